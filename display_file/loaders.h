/* loaders.h — display-file programs from files other than source.
 *
 * .oct        one octal word a line; `@octal` sets the byte address, `=octal` the entry, `;` starts
 *             a comment
 * .lda        DEC absolute tape: blocks 001 000, count, address, bytes, checksum; a block of count
 *             6 ends it and names the transfer address (odd = none: the lowest address then); that
 *             one's checksum may be missing. Display words only: a PDP-11 program in the tape is
 *             not executed, and a tape whose transfer address does not point at a display word that
 *             could start a display file is refused with a sentence saying that it needs a PDP-11.
 *             "Could start" means: it is a control word, and going on from it, through jumps, over
 *             loaded words none of which is illegal, comes to a stop or back to a word already
 *             passed.
 * raw         a memory image, little-endian words, placed at `base`, started at `start`
 *
 * Units:      byte addresses.
 * Ownership:  the program is the caller's (df_program_free); the bytes are only read.
 * Errors:     one sentence with file and line (or byte offset); the program is then empty.
 * Source:     .lda after DEC's PDP-11 paper tape software handbook; .oct is ours.
 * Not modelled: a PDP-11.
 */
#ifndef DF_LOADERS_H
#define DF_LOADERS_H

#include <stddef.h>
#include <stdio.h>

#include "display_file/program.h"

bool df_load_oct(const char *name, const char *text, size_t length, struct df_program *program,
                 struct crt_error *err);
bool df_load_lda(const char *name, const uint8_t *bytes, size_t length, struct df_program *program,
                 struct crt_error *err);
bool df_load_raw(const char *name, const uint8_t *bytes, size_t length, uint32_t base,
                 uint32_t start, struct df_program *program, struct crt_error *err);

/* Writes a program as .oct that reads back to the same words and entry. */
void df_write_oct(FILE *out, const struct df_program *program);

#endif
