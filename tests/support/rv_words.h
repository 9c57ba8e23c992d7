/* rv_words.h — instruction words for tests, put together from the manual's formats.
 *
 * Models:     RV32IMF, Zicsr, Zifencei and the privileged instructions. Immediates are signed bytes
 *             as assembly has them; upper ones (lui, auipc) are the whole word.
 * Ownership:  pure functions.
 * Errors:     none; what does not fit in a field is cut off.
 * Source:     The RISC-V Instruction Set Manual I (20191213), 2.2, 2.3 and chapter 24.
 */
#ifndef TESTS_RV_WORDS_H
#define TESTS_RV_WORDS_H

#include <stdint.h>

/* Registers by the calling convention. */
enum { ZERO, RA, SP, GP, TP, T0, T1, T2, S0, S1, A0, A1, A2, A3, A4, A5, A6, A7 };

static inline uint32_t w_r(unsigned funct7, unsigned funct3, unsigned opcode, unsigned rd,
                           unsigned rs1, unsigned rs2)
{
    return funct7 << 25 | rs2 << 20 | rs1 << 15 | funct3 << 12 | rd << 7 | opcode;
}

static inline uint32_t w_i(unsigned funct3, unsigned opcode, unsigned rd, unsigned rs1, int32_t imm)
{
    return (uint32_t)imm << 20 | rs1 << 15 | funct3 << 12 | rd << 7 | opcode;
}

static inline uint32_t w_s(unsigned funct3, unsigned opcode, unsigned rs2, unsigned rs1,
                           int32_t imm)
{
    uint32_t u = (uint32_t)imm;
    return (u >> 5 & 127) << 25 | rs2 << 20 | rs1 << 15 | funct3 << 12 | (u & 31) << 7 | opcode;
}

static inline uint32_t w_b(unsigned funct3, unsigned rs1, unsigned rs2, int32_t to)
{
    uint32_t u = (uint32_t)to;
    return (u >> 12 & 1) << 31 | (u >> 5 & 63) << 25 | rs2 << 20 | rs1 << 15 | funct3 << 12 |
           (u >> 1 & 15) << 8 | (u >> 11 & 1) << 7 | 0x63;
}

static inline uint32_t w_lui(unsigned rd, uint32_t value)
{
    return (value & 0xFFFFF000u) | rd << 7 | 0x37;
}

static inline uint32_t w_auipc(unsigned rd, uint32_t value)
{
    return (value & 0xFFFFF000u) | rd << 7 | 0x17;
}

static inline uint32_t w_jal(unsigned rd, int32_t to)
{
    uint32_t u = (uint32_t)to;
    return (u >> 20 & 1) << 31 | (u >> 1 & 0x3FF) << 21 | (u >> 11 & 1) << 20 |
           (u >> 12 & 0xFF) << 12 | rd << 7 | 0x6F;
}

static inline uint32_t w_jalr(unsigned rd, unsigned rs1, int32_t imm)
{
    return w_i(0, 0x67, rd, rs1, imm);
}

static inline uint32_t w_addi(unsigned rd, unsigned rs1, int32_t imm)
{
    return w_i(0, 0x13, rd, rs1, imm);
}

static inline uint32_t w_slli(unsigned rd, unsigned rs1, unsigned amount)
{
    return w_r(0, 1, 0x13, rd, rs1, amount);
}

static inline uint32_t w_add(unsigned rd, unsigned rs1, unsigned rs2)
{
    return w_r(0, 0, 0x33, rd, rs1, rs2);
}

static inline uint32_t w_beq(unsigned rs1, unsigned rs2, int32_t to)
{
    return w_b(0, rs1, rs2, to);
}

static inline uint32_t w_bne(unsigned rs1, unsigned rs2, int32_t to)
{
    return w_b(1, rs1, rs2, to);
}

static inline uint32_t w_lw(unsigned rd, unsigned rs1, int32_t imm)
{
    return w_i(2, 0x03, rd, rs1, imm);
}

static inline uint32_t w_sw(unsigned rs2, unsigned rs1, int32_t imm)
{
    return w_s(2, 0x23, rs2, rs1, imm);
}

static inline uint32_t w_sb(unsigned rs2, unsigned rs1, int32_t imm)
{
    return w_s(0, 0x23, rs2, rs1, imm);
}

static inline uint32_t w_flw(unsigned fd, unsigned rs1, int32_t imm)
{
    return w_i(2, 0x07, fd, rs1, imm);
}

static inline uint32_t w_fsw(unsigned fs2, unsigned rs1, int32_t imm)
{
    return w_s(2, 0x27, fs2, rs1, imm);
}

/* OP-FP with a rounding mode or function in `rm`. */
static inline uint32_t w_fp(unsigned funct7, unsigned rm, unsigned rd, unsigned rs1, unsigned rs2)
{
    return w_r(funct7, rm, 0x53, rd, rs1, rs2);
}

/* funct3: 1 csrrw, 2 csrrs, 3 csrrc; + 4 with an immediate in place of rs1. */
static inline uint32_t w_csr(unsigned funct3, unsigned rd, unsigned csr, unsigned rs1)
{
    return csr << 20 | rs1 << 15 | funct3 << 12 | rd << 7 | 0x73;
}

static inline uint32_t w_csrr(unsigned rd, unsigned csr)
{
    return w_csr(2, rd, csr, ZERO);
}

static inline uint32_t w_csrw(unsigned csr, unsigned rs1)
{
    return w_csr(1, ZERO, csr, rs1);
}

#define W_NOP     0x00000013u
#define W_ECALL   0x00000073u
#define W_EBREAK  0x00100073u
#define W_MRET    0x30200073u
#define W_WFI     0x10500073u
#define W_FENCE   0x0FF0000Fu
#define W_FENCE_I 0x0000100Fu

#endif
