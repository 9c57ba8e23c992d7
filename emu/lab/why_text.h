/* why_text.h — an answer of why.h as lines for people, or as JSON.
 *
 *      struct vm_why + names ─▶ groups (a source line, a word, a scan line, a store) ─▶ lines
 *
 * Models:     nothing. A group has the deposits of one source: on the vector head the source line where it
 *             is known, else the display word; on the raster head the scan line.
 * Ownership:  the caller's; names may hold NULLs where nothing is known.
 * Errors:     out of memory: groups are missing, the first sentence is there.
 */
#ifndef EMU_LAB_WHY_TEXT_H
#define EMU_LAB_WHY_TEXT_H

#include <stdio.h>

#include "emu/lab/source_lines.h"
#include "emu/lab/why.h"

/* What things are called. */
struct vm_why_names {
    const struct df_program *program;    /* with lines: its source; NULL: there is none */
    const struct vm_elf *elf;            /* with symbols */
    const struct vm_source_lines *lines; /* of the firmware */
};

/* Those of an input; `lines` of its firmware, or NULL. Both must outlive the names. */
struct vm_why_names vm_why_names_of(const struct vm_input *input,
                                    const struct vm_source_lines *lines);

struct vm_why_text {
    struct vm_why_names names;
    int columns;  /* a line has at most so many letters; at least 40 */
    int most;     /* lines; 0: all there are */
    bool all;     /* every deposit, not groups */
    bool by_time; /* the latest first, not the largest share */
    double least; /* smaller shares are summed up in one line; 0.01 = 1 % */
};

/* One sentence that says it all, broken into lines, then a table; with less than 80 columns a short form: a
 * line with the luminance, and one or two for each group. `line` gets them one by one. */
void vm_why_lines(const struct vm_why *why, const struct vm_why_text *text,
                  void (*line)(void *ctx, const char *line), void *ctx);

/* Everything as one JSON object. */
void vm_why_json(FILE *out, const struct vm_why *why, const struct vm_why_text *text);

#endif
