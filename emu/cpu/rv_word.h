/* rv_word.h — the fields of an instruction word.
 *
 *      31      25 24  20 19  15 14    12 11   7 6      0
 *      ┌─────────┬──────┬──────┬────────┬──────┬────────┐
 *      │ funct7  │ rs2  │ rs1  │ funct3 │  rd  │ opcode │
 *      └─────────┴──────┴──────┴────────┴──────┴────────┘
 *
 * Models:     where each format keeps its fields; immediates sign-extended, as 32-bit words.
 * Ownership:  pure functions.
 * Errors:     none: every word has every field.
 * Source:     The RISC-V Instruction Set Manual I, 2.2 and 2.3.
 * Not modelled: compressed and long instructions.
 */
#ifndef EMU_CPU_RV_WORD_H
#define EMU_CPU_RV_WORD_H

#include <stdint.h>

/* Bits 6:0. */
enum rv_opcode {
    RV_LOAD = 0x03,
    RV_LOAD_FP = 0x07,
    RV_MISC_MEM = 0x0F,
    RV_OP_IMM = 0x13,
    RV_AUIPC = 0x17,
    RV_STORE = 0x23,
    RV_STORE_FP = 0x27,
    RV_OP = 0x33,
    RV_LUI = 0x37,
    RV_MADD = 0x43,
    RV_MSUB = 0x47,
    RV_NMSUB = 0x4B,
    RV_NMADD = 0x4F,
    RV_OP_FP = 0x53,
    RV_BRANCH = 0x63,
    RV_JALR = 0x67,
    RV_JAL = 0x6F,
    RV_SYSTEM = 0x73,
};

/* funct7 of OP-FP, single precision. */
enum rv_fp {
    RV_FP_ADD = 0x00,
    RV_FP_SUB = 0x04,
    RV_FP_MUL = 0x08,
    RV_FP_DIV = 0x0C,
    RV_FP_SIGN = 0x10,
    RV_FP_MINMAX = 0x14,
    RV_FP_SQRT = 0x2C,
    RV_FP_COMPARE = 0x50,
    RV_FP_TO_INT = 0x60,
    RV_FP_FROM_INT = 0x68,
    RV_FP_TO_X = 0x70, /* fmv.x.w, fclass.s */
    RV_FP_FROM_X = 0x78,
};

static inline unsigned rv_field(uint32_t word, unsigned low, unsigned bits)
{
    return word >> low & ((1u << bits) - 1);
}

static inline unsigned rv_opcode(uint32_t word)
{
    return rv_field(word, 0, 7);
}

static inline unsigned rv_rd(uint32_t word)
{
    return rv_field(word, 7, 5);
}

static inline unsigned rv_funct3(uint32_t word)
{
    return rv_field(word, 12, 3);
}

static inline unsigned rv_rs1(uint32_t word)
{
    return rv_field(word, 15, 5);
}

static inline unsigned rv_rs2(uint32_t word)
{
    return rv_field(word, 20, 5);
}

static inline unsigned rv_rs3(uint32_t word)
{
    return rv_field(word, 27, 5);
}

static inline unsigned rv_funct7(uint32_t word)
{
    return rv_field(word, 25, 7);
}

/* All bits set when the word's sign bit is. */
static inline uint32_t rv_sign(uint32_t word)
{
    return 0u - (word >> 31);
}

static inline uint32_t rv_imm_i(uint32_t word)
{
    return word >> 20 | rv_sign(word) << 12;
}

static inline uint32_t rv_imm_s(uint32_t word)
{
    return rv_rd(word) | rv_funct7(word) << 5 | rv_sign(word) << 12;
}

static inline uint32_t rv_imm_b(uint32_t word)
{
    return rv_field(word, 8, 4) << 1 | rv_field(word, 25, 6) << 5 | rv_field(word, 7, 1) << 11 |
           rv_sign(word) << 12;
}

static inline uint32_t rv_imm_u(uint32_t word)
{
    return word & 0xFFFFF000u;
}

static inline uint32_t rv_imm_j(uint32_t word)
{
    return rv_field(word, 21, 10) << 1 | rv_field(word, 20, 1) << 11 | rv_field(word, 12, 8) << 12 |
           rv_sign(word) << 20;
}

#endif
