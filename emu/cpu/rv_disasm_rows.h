/* rv_disasm_rows.h — every instruction and pseudo-instruction as a row: bits and text.
 *
 * Models:     a word is the first row whose bits match and whose conditions hold. A template's "%"
 *             letters are operands:
 *               %d %s %t     rd, rs1, rs2          %D %S %T %R  the same and rs3, float registers
 *               %i %o        I and S immediate, decimal         %u      U immediate, hexadecimal
 *               %b %j        branch and jump target             %h      shift amount, hexadecimal
 *               %c %z        CSR; five bits at rs1, decimal     %p %q   fence: before, after
 *               %m           ",rtz" and the like, nothing when dynamic; condition: not reserved
 *               %=           nothing; condition: rs1 and rs2 are the same register
 * Ownership:  constant.
 * Source:     The RISC-V Instruction Set Manual I (20191213), chapters 2–11 and 24–25.
 */
#ifndef EMU_CPU_RV_DISASM_ROWS_H
#define EMU_CPU_RV_DISASM_ROWS_H

#include <stddef.h>
#include <stdint.h>

struct rv_disasm_row {
    uint32_t mask, match;
    const char *text;
};

extern const struct rv_disasm_row rv_disasm_rows[];
extern const size_t rv_disasm_row_count;

#endif
