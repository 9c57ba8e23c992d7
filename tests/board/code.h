/* code.h — instruction words for tests that must not need an assembler. */
#ifndef TESTS_BOARD_CODE_H
#define TESTS_BOARD_CODE_H

#include <stdint.h>

/* Registers by their ABI names. */
enum { ZERO, RA, SP, GP, TP, T0, T1, T2, S0, S1, A0, A1, A2, A3, A4, A5 };

enum {
    CSR_MSTATUS = 0x300,
    CSR_MIE = 0x304,
    CSR_MTVEC = 0x305,
    CSR_MSCRATCH = 0x340,
    CSR_MEPC = 0x341,
    CSR_MCAUSE = 0x342,
    CSR_MTVAL = 0x343,
    CSR_MCYCLE = 0xB00,
    CSR_TIME = 0xC01,
    CSR_TIMEH = 0xC81,
};

struct code {
    uint32_t word[256];
    unsigned n;
};

static inline void emit(struct code *c, uint32_t word)
{
    c->word[c->n++] = word;
}

static inline void op_i(struct code *c, unsigned op, unsigned f3, unsigned rd, unsigned rs, int imm)
{
    emit(c, (uint32_t)imm << 20 | rs << 15 | f3 << 12 | rd << 7 | op);
}

static inline void addi(struct code *c, unsigned rd, unsigned rs, int imm)
{
    op_i(c, 0x13, 0, rd, rs, imm);
}

static inline void andi(struct code *c, unsigned rd, unsigned rs, int imm)
{
    op_i(c, 0x13, 7, rd, rs, imm);
}

static inline void lw(struct code *c, unsigned rd, unsigned rs, int imm)
{
    op_i(c, 0x03, 2, rd, rs, imm);
}

static inline void lbu(struct code *c, unsigned rd, unsigned rs, int imm)
{
    op_i(c, 0x03, 4, rd, rs, imm);
}

static inline void store(struct code *c, unsigned f3, unsigned rs2, unsigned rs, int imm)
{
    emit(c, ((uint32_t)imm >> 5 & 0x7F) << 25 | rs2 << 20 | rs << 15 | f3 << 12 |
                ((uint32_t)imm & 0x1F) << 7 | 0x23);
}

static inline void sw(struct code *c, unsigned rs2, unsigned rs, int imm)
{
    store(c, 2, rs2, rs, imm);
}

static inline void sb(struct code *c, unsigned rs2, unsigned rs, int imm)
{
    store(c, 0, rs2, rs, imm);
}

/* Two words always, so that addresses are easy to count. */
static inline void li(struct code *c, unsigned rd, uint32_t value)
{
    emit(c, ((value + 0x800) & 0xFFFFF000) | rd << 7 | 0x37);
    addi(c, rd, rd, (int)(value & 0xFFF));
}

/* To the word `to`, counted from the beginning. */
static inline void branch(struct code *c, unsigned f3, unsigned a, unsigned b, unsigned to)
{
    uint32_t d = (to - c->n) * 4;
    emit(c, (d >> 12 & 1) << 31 | (d >> 5 & 0x3F) << 25 | b << 20 | a << 15 | f3 << 12 |
                (d >> 1 & 0xF) << 8 | (d >> 11 & 1) << 7 | 0x63);
}

static inline void beq(struct code *c, unsigned a, unsigned b, unsigned to)
{
    branch(c, 0, a, b, to);
}

static inline void bne(struct code *c, unsigned a, unsigned b, unsigned to)
{
    branch(c, 1, a, b, to);
}

static inline void jump(struct code *c, unsigned to)
{
    uint32_t d = (to - c->n) * 4;
    emit(c, (d >> 20 & 1) << 31 | (d >> 1 & 0x3FF) << 21 | (d >> 11 & 1) << 20 |
                (d >> 12 & 0xFF) << 12 | 0x6F);
}

static inline void csrw(struct code *c, unsigned csr, unsigned rs)
{
    op_i(c, 0x73, 1, ZERO, rs, (int)csr);
}

static inline void csrr(struct code *c, unsigned rd, unsigned csr)
{
    op_i(c, 0x73, 2, rd, ZERO, (int)csr);
}

static inline void csrsi(struct code *c, unsigned csr, unsigned bits)
{
    op_i(c, 0x73, 6, ZERO, bits, (int)csr);
}

static inline void wfi(struct code *c)
{
    emit(c, 0x10500073);
}

static inline void mret(struct code *c)
{
    emit(c, 0x30200073);
}

#endif
