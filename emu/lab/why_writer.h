/* why_writer.h — lines of an answer as they are written: broken at words, counted; and its figures as text.
 *
 * Ownership:  the caller's struct and buffers.
 * Errors:     none; texts are cut where they do not fit.
 */
#ifndef EMU_LAB_WHY_WRITER_H
#define EMU_LAB_WHY_WRITER_H

#include "emu/lab/why_entries.h"

/* Below this a dark-adapted eye sees nothing, cd/m²: about the absolute threshold of large, long-lasting
 * lights (Blackwell 1946, J. Opt. Soc. Am. 36, 624; rounded). */
#define VM_WHY_DARK 1e-6

/* Less than this part of the light is not worth a word. */
#define VM_WHY_FADED 1e-7

/* From here on a sentence and a table of figures have room; below it lines are short. */
#define VM_WHY_WIDE 80

#define VM_WHY_TEXT 1600 /* bytes of a line or sentence, at most */

struct vm_why_writer {
    const struct vm_why *why;
    const struct vm_why_text *text;
    void (*line)(void *ctx, const char *line);
    void *ctx;
    int written;
    struct vm_why_store store; /* the last one said */
};

/* A line, unless there are as many as there may be. */
void vm_why_put(struct vm_why_writer *writer, const char *line);
/* `text` after `lead`, on as many lines as it takes; the later ones are indented by lead's length. */
void vm_why_wrap(struct vm_why_writer *writer, const char *lead, const char *text);

/* "91 %", "0.02 %" */
void vm_why_percent(double part, char *text, size_t size);
/* Of the luminance. */
double vm_why_part(const struct vm_why *why, double cd_m2);
/* How long before the answer t was: "2.1 ms" */
void vm_why_ago(const struct vm_why *why, uint64_t t, char *text, size_t size);
/* Whether light from before the record is worth a word. */
bool vm_why_has_older(const struct vm_why *why);

/* why_short.c: a line with the luminance, or the dark; then as many entries as there is room for. */
void vm_why_short_head(struct vm_why_writer *writer);
void vm_why_short(struct vm_why_writer *writer, const struct vm_why_entries *entries);

#endif
