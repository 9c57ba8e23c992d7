/* versus.h — two machines compared: what is different about the other one, and how the two are called.
 *
 *      --versus "phosphor=p31;refresh=30;set.spot=0.5;brightness=0.2"
 *          │ an option each, without its dashes; what --set knows, with or without "set."
 *          ▼
 *      --phosphor=p31 --refresh=30 --set=spot=0.5 --set=brightness=0.2
 *          ▼ emu/options.h, by the command's own tables, into a copy of the left side's options
 *      "P39 · 60 Hz · spot 0.4 mm"  |  "P31 · 30 Hz · spot 0.5 mm"
 *
 * Models:     nothing. What is said replaces what the left side's options say; a tube named replaces all that
 *             the left side names.
 * Ownership:  vm_versus_free releases the text that options then point into: they must not outlive it.
 * Errors:     one sentence that begins with --versus; a name that is none suggests the nearest.
 */
#ifndef EMU_VERSUS_H
#define EMU_VERSUS_H

#include "emu/settings.h"

#define VM_SIDES          2 /* left, right */
#define VM_VERSUS_MOST    32
#define VM_VERSUS_CAPTION 160

struct vm_versus {
    int count;                  /* 0: there is no other side */
    char *item[VM_VERSUS_MOST]; /* "--name=value" */
};

/* The tables' targets are what the right side is to have, copies of the left side's. */
bool vm_versus_parse(struct vm_versus *versus, const char *text,
                     const struct vm_option_table *tables, size_t table_count,
                     struct crt_error *err);
void vm_versus_free(struct vm_versus *versus);

/* A side of the comparison: its options and what has come of them. */
struct vm_versus_side {
    const struct vm_option_table *tables;
    size_t table_count;
    const struct vm_settings *settings;
    const struct ras_timing
        *timing;       /* that the raster head runs in by now; NULL: of the settings */
    enum vm_view view; /* wanted by now */
};
/* What each side is called: what differs, in the same words for either; what was said but is the same on both
 * is left out, unless all is. UTF-8. */
void vm_versus_captions(const struct vm_versus *versus, const struct vm_versus_side side[VM_SIDES],
                        char text[VM_SIDES][VM_VERSUS_CAPTION]);

#endif
