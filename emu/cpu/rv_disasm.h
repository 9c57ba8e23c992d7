/* rv_disasm.h — an instruction as text, as objdump writes it.
 *
 * Models:     RV32IMF, Zicsr, Zifencei with the usual pseudo-instructions (li, mv, ret, beqz, csrr,
 *             fmv.s …); operands separated by commas without spaces, branch targets as absolute
 *             hexadecimal addresses, CSRs by name. What is no instruction is ".word 0x…".
 * Ownership:  the caller's buffer; RV_DISASM_MAX bytes are enough.
 * Source:     The RISC-V Instruction Set Manual I; the assembly programmer's manual.
 */
#ifndef EMU_CPU_RV_DISASM_H
#define EMU_CPU_RV_DISASM_H

#include <stddef.h>
#include <stdint.h>

#define RV_DISASM_MAX 64

/* "addi a0,a0,-16" for the word at `pc`: mnemonic, one space, operands. */
void rv_disasm(uint32_t pc, uint32_t word, char *text, size_t size);

/* "zero" "ra" … and "ft0" …, by the calling convention. */
const char *rv_x_name(unsigned number);
const char *rv_f_name(unsigned number);
/* "mstatus"; NULL when the number has no name. */
const char *rv_csr_name(unsigned csr);

/* The register that `word` writes: −1 none (nor is x0 one), 1…31 x, 32…63 f. */
int rv_destination(uint32_t word);

#endif
