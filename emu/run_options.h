/* run_options.h — what `run` can be told: at the command line, or by a lesson.
 *
 *      vm_run_begin ─▶ tables ─▶ vm_options_parse ─▶ vm_run_check ─▶ vm_run_show ─▶ struct vm_show_desc
 *
 * Ownership:  the caller's struct, which stays where it is: tables and descs point into it. vm_run_free frees what
 *             vm_run_check allocates. Strings are those parsed.
 * Errors:     an exit status and one sentence.
 */
#ifndef EMU_RUN_OPTIONS_H
#define EMU_RUN_OPTIONS_H

#include "emu/show.h"

struct vm_run_options {
    bool headless, console, full_screen, gdb_anywhere, tour, latency, no_flash;
    const char *gdb, *record, *versus;
    struct vm_time length, shutter;
    struct vm_size size;
    double scale;
    struct vm_saved_options saved;
    struct vm_show_options side[VM_SIDES]; /* left, or alone; right */
    struct vm_option_table tables[VM_SIDES][VM_SHOW_TABLES];
    struct vm_versus other; /* what is different on the right */
    struct vm_input_options input;
    struct vm_roms_options roms;
    const char *path;        /* what to show; NULL: the tour */
    char monitor[4096 + 16]; /* its path, when it is that */
};

#define VM_RUN_TABLES 6

/* As when nothing is said; the tables are to be parsed. */
void vm_run_begin(struct vm_run_options *o, struct vm_option_table tables[VM_RUN_TABLES]);
/* What was parsed: whether it goes together; finds the program. Free it also after an error. */
int vm_run_check(struct vm_run_options *o, const struct vm_args *args, struct crt_error *err);
/* The window that follows from it, but for a debugger. */
int vm_run_show(const struct vm_run_options *o, struct vm_show_desc *desc, struct crt_error *err);
void vm_run_free(struct vm_run_options *o);

#endif
