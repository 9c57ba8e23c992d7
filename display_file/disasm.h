/* disasm.h — words back to .df source that assembles to the same words.
 *
 * Models:     assemble(disassemble(x)) == x for any words at any addresses, entry, tube and firmware
 *             included: what no mnemonic says exactly is written as an octal .word.
 * Units:      addresses are byte addresses, in octal.
 * Ownership:  df_disassemble returns malloced text.
 * Errors:     NULL when memory is out; df_disassemble_word has none.
 * Source:     the language is display_file/LANGUAGE.md.
 * Not modelled: what the assembler refuses cannot come back: the entry must hold a word, below
 *             64 KiB. Macros, constants and comments are lost.
 */
#ifndef DF_DISASM_H
#define DF_DISASM_H

#include "display_file/program.h"

/* The whole program as source text; NULL only when memory is out. Comments tell addresses and name
 * the special characters of strings. */
char *df_disassemble(const struct df_program *program);

/* One word on its own, for traces and the status line: `mode` is the graphic mode it would be read
 * in (DF_MODE_*). Writes at most `size` bytes, always terminated. */
void df_disassemble_word(uint16_t word, unsigned mode, char *text, unsigned long size);

#endif
