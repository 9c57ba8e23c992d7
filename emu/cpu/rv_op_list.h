/* rv_op_list.h — the list of handlers, and what the simple ones compute.
 *
 * Models:     for integer operations and branches, the formula on operands a and b; for loads and
 *             stores, the type in memory. The loops, the decoder and the tables of handlers are all
 *             made from these lists.
 * Units:      uint32_t in, uint32_t (or a truth value) out.
 * Source:     The RISC-V Instruction Set Manual I, chapters 2, 7, 11.
 */
#ifndef EMU_CPU_RV_OP_LIST_H
#define EMU_CPU_RV_OP_LIST_H

#include <stdint.h>

/* Division has no traps: by zero gives all ones and the dividend, −2³¹ / −1 gives −2³¹ and 0. */
static inline uint32_t rv_div(uint32_t a, uint32_t b)
{
    return b == 0 ? UINT32_MAX : b == UINT32_MAX ? 0 - a : (uint32_t)((int32_t)a / (int32_t)b);
}

static inline uint32_t rv_rem(uint32_t a, uint32_t b)
{
    return b == 0 ? a : b == UINT32_MAX ? 0 : (uint32_t)((int32_t)a % (int32_t)b);
}

/* The upper half of a product of operands that were extended to 64 bits. */
static inline uint32_t rv_mulh(int64_t a, int64_t b)
{
    return (uint32_t)((uint64_t)(a * b) >> 32);
}

/* >> of a negative number is arithmetic on every compiler we build with. */
static inline uint32_t rv_sra(uint32_t a, uint32_t b)
{
    return (uint32_t)((int32_t)a >> (b & 31));
}

/* a: rs1; b: rs2, or the immediate. */
#define RV_IMM_OPS(X)                                                                              \
    X(ADDI, a + b)                                                                                 \
    X(SLLI, a << b)                                                                                \
    X(SLTI, (int32_t)a < (int32_t)b)                                                               \
    X(SLTIU, a < b)                                                                                \
    X(XORI, a ^ b)                                                                                 \
    X(SRLI, a >> b)                                                                                \
    X(SRAI, rv_sra(a, b))                                                                          \
    X(ORI, a | b)                                                                                  \
    X(ANDI, (a) & (b))

#define RV_REG_OPS(X)                                                                              \
    X(ADD, a + b)                                                                                  \
    X(SUB, a - b)                                                                                  \
    X(SLL, a << (b & 31))                                                                          \
    X(SLT, (int32_t)a < (int32_t)b)                                                                \
    X(SLTU, a < b)                                                                                 \
    X(XOR, a ^ b)                                                                                  \
    X(SRL, a >> (b & 31))                                                                          \
    X(SRA, rv_sra(a, b))                                                                           \
    X(OR, a | b)                                                                                   \
    X(AND, (a) & (b))                                                                              \
    X(MUL, (a) * (b))                                                                              \
    X(MULH, rv_mulh((int32_t)a, (int32_t)b))                                                       \
    X(MULHSU, rv_mulh((int32_t)a, b))                                                              \
    X(MULHU, (uint32_t)((uint64_t)a * b >> 32))                                                    \
    X(DIV, rv_div(a, b))                                                                           \
    X(DIVU, b == 0 ? UINT32_MAX : a / b)                                                           \
    X(REM, rv_rem(a, b))                                                                           \
    X(REMU, b == 0 ? a : a % b)

#define RV_BRANCH_OPS(X)                                                                           \
    X(BEQ, a == b)                                                                                 \
    X(BNE, a != b)                                                                                 \
    X(BLT, (int32_t)a < (int32_t)b)                                                                \
    X(BGE, (int32_t)a >= (int32_t)b)                                                               \
    X(BLTU, a < b)                                                                                 \
    X(BGEU, a >= b)

/* As they lie in memory; sign extension follows from the type. */
#define RV_LOAD_OPS(X)                                                                             \
    X(LB, int8_t)                                                                                  \
    X(LH, int16_t)                                                                                 \
    X(LW, uint32_t)                                                                                \
    X(LBU, uint8_t)                                                                                \
    X(LHU, uint16_t)

#define RV_STORE_OPS(X)                                                                            \
    X(SB, uint8_t)                                                                                 \
    X(SH, uint16_t)                                                                                \
    X(SW, uint32_t)

/* The rest has no formula: _ stands in for it. */
#define RV_JUMP_OPS(X)                                                                             \
    X(J, _)                                                                                        \
    X(JAL, _)                                                                                      \
    X(JR, _)                                                                                       \
    X(JALR, _)                                                                                     \
    X(LI, _) /* a constant: lui, auipc, addi from x0; to x0: fence */

/* What touches float registers needs mstatus.FS. These do not round. */
#define RV_FLOAT_FREE_OPS(X)                                                                       \
    X(FLW, _)                                                                                      \
    X(FSW, _)                                                                                      \
    X(FMV_X_W, _)                                                                                  \
    X(FMV_W_X, _)                                                                                  \
    X(FSGNJ, _)                                                                                    \
    X(FSGNJN, _)                                                                                   \
    X(FSGNJX, _)                                                                                   \
    X(FEQ, _)                                                                                      \
    X(FLT, _)                                                                                      \
    X(FLE, _)                                                                                      \
    X(FMIN, _)                                                                                     \
    X(FMAX, _)

/* These need RV_FLOAT_HOST: dynamic rounding mode or nearest even; conversions to
 * integers toward zero. */
#define RV_FLOAT_HOST_OPS(X)                                                                       \
    X(FADD, _)                                                                                     \
    X(FSUB, _)                                                                                     \
    X(FMUL, _)                                                                                     \
    X(FDIV, _)                                                                                     \
    X(FSQRT, _)                                                                                    \
    X(FMADD, _)                                                                                    \
    X(FMSUB, _)                                                                                    \
    X(FNMSUB, _)                                                                                   \
    X(FNMADD, _)                                                                                   \
    X(FCVT_W_S, _)                                                                                 \
    X(FCVT_WU_S, _)                                                                                \
    X(FCVT_S_W, _)                                                                                 \
    X(FCVT_S_WU, _)

#define RV_INTEGER_OPS(X)                                                                          \
    RV_IMM_OPS(X)                                                                                  \
    RV_REG_OPS(X)                                                                                  \
    RV_BRANCH_OPS(X)                                                                               \
    RV_LOAD_OPS(X)                                                                                 \
    RV_STORE_OPS(X)                                                                                \
    RV_JUMP_OPS(X)

#define RV_ALL_OPS(X)                                                                              \
    RV_INTEGER_OPS(X)                                                                              \
    RV_FLOAT_FREE_OPS(X)                                                                           \
    RV_FLOAT_HOST_OPS(X)

#endif
