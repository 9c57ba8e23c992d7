/* insn_table.h — every instruction of RV32IMF with Zicsr and Zifencei that an application may execute.
 *
 * Models:     a row an instruction: its name, the bits that are given (match, mask), and which fields
 *             are free. Read off the manual's listing of instructions, not off the processor's decoder.
 * Ownership:  constants.
 * Errors:     a word that no row matches has index INSN_COUNT.
 * Source:     The RISC-V Instruction Set Manual I (20191213), chapter 24.
 * Not modelled: ebreak, mret and wfi, which an application under Linux cannot execute and go on.
 */
#ifndef TESTS_QEMU_INSN_TABLE_H
#define TESTS_QEMU_INSN_TABLE_H

#include <stdint.h>

/* Free fields: registers are x unless f is said. */
enum insn_kind {
    INSN_UPPER,     /* rd, imm[31:12] */
    INSN_JAL,       /* rd, offset */
    INSN_JALR,      /* rd, rs1, imm */
    INSN_BRANCH,    /* rs1, rs2, offset */
    INSN_LOAD,      /* rd, imm(rs1) */
    INSN_STORE,     /* rs2, imm(rs1) */
    INSN_IMMEDIATE, /* rd, rs1, imm */
    INSN_SHIFT,     /* rd, rs1, shamt */
    INSN_REGISTERS, /* rd, rs1, rs2 */
    INSN_FENCE,     /* predecessors, successors */
    INSN_FIXED,     /* none */
    INSN_ECALL,     /* none */
    INSN_CSR,       /* rd, csr, rs1 */
    INSN_CSR_IMM,   /* rd, csr, uimm */
    INSN_F_LOAD,    /* frd, imm(rs1) */
    INSN_F_STORE,   /* frs2, imm(rs1) */
    INSN_F_FOUR,    /* frd, frs1, frs2, frs3, rm */
    INSN_F_THREE,   /* frd, frs1, frs2, rm */
    INSN_F_TWO,     /* frd, frs1, rm */
    INSN_F_PLAIN,   /* frd, frs1, frs2 */
    INSN_F_COMPARE, /* rd, frs1, frs2 */
    INSN_F_TO_X,    /* rd, frs1, rm */
    INSN_F_FROM_X,  /* frd, rs1, rm */
    INSN_F_MOVE_X,  /* rd, frs1 */
    INSN_X_MOVE_F,  /* frd, rs1 */
};

struct insn {
    const char *name;
    enum insn_kind kind;
    uint32_t match, mask;
};

enum { INSN_COUNT = 80 };
extern const struct insn insn_table[INSN_COUNT];

unsigned insn_index(uint32_t word);
/* Has a field for the rounding mode. */
int insn_rounds(const struct insn *i);
/* The row of this name, which must be one. */
const struct insn *insn_named(const char *name);

/* Fields of a word being put together. */
static inline uint32_t insn_rd(unsigned r)
{
    return (uint32_t)r << 7;
}

static inline uint32_t insn_rm(unsigned rm)
{
    return (uint32_t)rm << 12;
}

static inline uint32_t insn_rs1(unsigned r)
{
    return (uint32_t)r << 15;
}

static inline uint32_t insn_rs2(unsigned r)
{
    return (uint32_t)r << 20;
}

static inline uint32_t insn_rs3(unsigned r)
{
    return (uint32_t)r << 27;
}

static inline uint32_t insn_imm_i(int imm)
{
    return (uint32_t)imm << 20;
}

static inline uint32_t insn_imm_s(int imm)
{
    uint32_t i = (uint32_t)imm;
    return (i >> 5 & 0x7f) << 25 | (i & 0x1f) << 7;
}

static inline uint32_t insn_imm_b(int offset)
{
    uint32_t i = (uint32_t)offset;
    return (i >> 12 & 1) << 31 | (i >> 5 & 0x3f) << 25 | (i >> 1 & 0xf) << 8 | (i >> 11 & 1) << 7;
}

static inline uint32_t insn_imm_j(int offset)
{
    uint32_t i = (uint32_t)offset;
    return (i >> 20 & 1) << 31 | (i >> 1 & 0x3ff) << 21 | (i >> 11 & 1) << 20 |
           (i >> 12 & 0xff) << 12;
}

#endif
