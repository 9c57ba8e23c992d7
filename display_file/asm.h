/* asm.h — the assembler for .df display-file source.
 *
 * Models:     two passes over the source (and what it includes); all errors of a run are reported
 *             at once, each as
 *
 *                  FILE:LINE:COLUMN: what is wrong; what was expected
 *                      the source line
 *                      ^
 *
 * Language:   display_file/LANGUAGE.md.
 * Units:      byte addresses; columns are bytes from 1.
 * Ownership:  the program and the report belong to the caller (df_program_free,
 *             df_asm_report_free).
 * Errors:     returns false when there was any; the report then holds every one of them.
 * Limits:     include depth 16, repeat depth 8, one million words emitted, 1000 errors kept;
 *             12 MiB and a million lines a file, 4095 bytes a line, 255 files, two million lines
 *             executed.
 * Source:     the language is ours; DEC's mnemonics and syntax after EK-VT11-TM-001 and MACRO-11.
 * Not modelled: MACRO-11's own macros, conditionals and relocatable sections.
 */
#ifndef DF_ASM_H
#define DF_ASM_H

#include <stddef.h>

#include "display_file/program.h"

struct df_asm_report {
    char *text; /* all errors, or "" */
    size_t errors;
    char *listing; /* addresses, words, source; NULL unless asked for */
};

struct df_asm_options {
    bool listing;
};

bool df_assemble_file(const char *path, const struct df_asm_options *options,
                      struct df_program *program, struct df_asm_report *report);
/* `name` is what errors call the text; includes are looked up beside it. */
bool df_assemble_text(const char *name, const char *text, size_t length,
                      const struct df_asm_options *options, struct df_program *program,
                      struct df_asm_report *report);
void df_asm_report_free(struct df_asm_report *report);

#endif
