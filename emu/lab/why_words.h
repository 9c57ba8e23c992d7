/* why_words.h — what a deposit is called: its source, its word or dots, the store behind it.
 *
 * Models:     nothing.
 * Ownership:  the caller's buffers, of any size; texts are ASCII, cut where they do not fit.
 * Errors:     what is not known is left out.
 */
#ifndef EMU_LAB_WHY_WORDS_H
#define EMU_LAB_WHY_WORDS_H

#include "emu/lab/why_text.h"

/* Whether a deposit's words are those that a display file brought along: not stored, nor changed since. */
bool vm_why_as_loaded(const struct df_program *program, const struct vm_why_deposit *deposit);
/* The line of the display file's source that a deposit's word is of; false: it has none, or the program
 * has stored over it. */
bool vm_why_source_line(const struct vm_why_names *names, const struct vm_why_deposit *deposit,
                        const char **file, uint32_t *line);

/* "line 17 of rose.df", "word 001234", "scan line 300", "a stroke" */
void vm_why_say_source(const struct vm_why *why, const struct vm_why_names *names,
                       const struct vm_why_deposit *deposit, char *text, size_t size);
/* "001234 104210 002000 vec 34,8", "scan line 300, dots 510-514, byte 04b200" */
void vm_why_say_what(const struct vm_why *why, const struct vm_why_deposit *deposit, char *text,
                     size_t size);
/* The display word as a statement of its language. */
void vm_why_say_word(const struct vm_why_deposit *deposit, char *text, size_t size);
/* "fill+0x24, roms/raster/fill.c:88" of an address in the program */
void vm_why_say_code(const struct vm_why_names *names, uint32_t pc, char *text, size_t size);
/* "stored 12.3 ms ago by fill+0x24, roms/raster/fill.c:88: 80001234 sw a5,0(a4)", or "by the same" as what
 * was said before; "" when nobody has, or who is not known. */
void vm_why_say_store(const struct vm_why *why, const struct vm_why_names *names,
                      const struct vm_why_deposit *deposit, bool same, char *text, size_t size);
/* Who had called it, when that is another function: "memset" says little. "" else. */
void vm_why_say_caller(const struct vm_why_names *names, const struct vm_why_store *store,
                       char *text, size_t size);

#endif
