/* rv_op_list.h — the list of handlers.
 *
 * Models:     names only: what they do is in rv_ops.inc. The decoder's numbers, the loops' labels
 *             and their tables are made from these lists.
 * Source:     The RISC-V Instruction Set Manual I, chapters 2, 7, 11. Which pairs are worth a
 *             handler: counted in firmware that draws lines, fills shaded polygons, prints, sorts,
 *             multiplies matrices and walks lists; each is at least 0.5 % of the instructions of one.
 */
#ifndef EMU_CPU_RV_OP_LIST_H
#define EMU_CPU_RV_OP_LIST_H

/* clang-format off */

/* LI: a constant (lui, auipc, addi from x0; to x0: fence). J and JR: jal and jalr without a link. */
#define RV_INTEGER_OPS(X)                                                                          \
    X(ADDI) X(SLLI) X(SLTI) X(SLTIU) X(XORI) X(SRLI) X(SRAI) X(ORI) X(ANDI) X(LI)                  \
    X(ADD) X(SUB) X(SLL) X(SLT) X(SLTU) X(XOR) X(SRL) X(SRA) X(OR) X(AND)                          \
    X(MUL) X(MULH) X(MULHSU) X(MULHU) X(DIV) X(DIVU) X(REM) X(REMU)                                \
    X(BEQ) X(BNE) X(BLT) X(BGE) X(BLTU) X(BGEU) X(J) X(JAL) X(JR) X(JALR)                          \
    X(LB) X(LH) X(LW) X(LBU) X(LHU) X(SB) X(SH) X(SW)

/* What touches float registers needs mstatus.FS. These do not round. */
#define RV_FREE_OPS(X)                                                                             \
    X(FLW) X(FSW) X(FMV_X_W) X(FMV_W_X) X(FSGNJ) X(FSGNJN) X(FSGNJX)                               \
    X(FEQ) X(FLT) X(FLE) X(FMIN) X(FMAX)

/* These need RV_FLOAT_HOST: dynamic rounding mode, or nearest even; to integers toward zero. */
#define RV_HOST_OPS(X)                                                                             \
    X(FADD) X(FSUB) X(FMUL) X(FDIV) X(FSQRT) X(FMADD) X(FMSUB) X(FNMSUB) X(FNMADD)                 \
    X(FCVT_W_S) X(FCVT_WU_S) X(FCVT_S_W) X(FCVT_S_WU)

/* Pairs that follow each other so often that they have a handler together: X(first, second). By what
 * the first one is, and what the handler needs. */
#define RV_INTEGER_PAIRS(X)                                                                        \
    X(ADDI, ADDI) X(ADDI, ADD) X(ADDI, AND) X(ADDI, XOR) X(ADDI, SLLI) X(ADDI, BEQ) X(ADDI, BNE)   \
    X(ADDI, SW) X(ADDI, J) X(ADDI, JR) X(ADDI, JALR)                                               \
    X(LI, ADDI) X(LI, ADD) X(LI, LI) X(LI, BEQ) X(LI, BNE) X(LI, JR)                               \
    X(SLLI, ADDI) X(SLLI, ADD) X(SLLI, SUB) X(SLLI, XOR) X(SLLI, LI) X(SLLI, SRLI) X(SLLI, BEQ)    \
    X(SLLI, BNE) X(SRLI, ADDI) X(SRLI, AND) X(SRLI, ANDI) X(SRLI, XOR)                             \
    X(ANDI, ADD) X(ANDI, SUB) X(ANDI, SLLI)                                                        \
    X(ADD, ADD) X(ADD, ADDI) X(ADD, ANDI) X(ADD, OR) X(ADD, SLLI) X(ADD, BLT) X(ADD, BNE)          \
    X(ADD, LBU) X(ADD, LW) X(ADD, SB) X(ADD, J) X(SUB, ADDI) X(SUB, AND) X(SUB, SRLI)              \
    X(AND, ADDI) X(AND, XOR) X(OR, BNE) X(XOR, BNE) X(XOR, SLLI) X(XOR, SRLI) X(SLT, JR)           \
    X(BEQ, BLT) X(BEQ, LI) X(BNE, ADD) X(BNE, ADDI) X(BNE, BNE) X(BNE, LI) X(BLT, ADD)             \
    X(BLT, SLT) X(BLTU, ADDI)                                                                      \
    X(LW, LW) X(LW, ADD) X(LW, ADDI) X(LW, BLT) X(LW, SB) X(LBU, ADDI) X(LBU, BEQ) X(LBU, SLLI)    \
    X(SB, ADDI) X(SB, SLLI) X(SW, SW) X(SW, ADDI)

#define RV_INTEGER_FREE_PAIRS(X)                                                                   \
    X(ADD, FLW) X(LI, FLW) X(SB, FSW)

#define RV_INTEGER_HOST_PAIRS(X)                                                                   \
    X(ADDI, FMADD) X(ADD, FMADD) X(ADD, FMUL) X(LI, FMUL) X(BEQ, FCVT_S_W) X(BNE, FSUB)

#define RV_FREE_PAIRS(X)                                                                           \
    X(FLT, BEQ) X(FLT, BNE) X(FLE, BNE) X(FLW, ADD) X(FLW, ADDI) X(FLW, FLW) X(FLW, FSW)           \
    X(FLW, LI) X(FLW, LW) X(FSW, ADDI)

#define RV_FREE_HOST_PAIRS(X)                                                                      \
    X(FLW, FMADD) X(FLW, FMUL) X(FSW, FMADD) X(FMV_W_X, FADD)

#define RV_HOST_PAIRS(X)                                                                           \
    X(FADD, FLT) X(FADD, FMADD) X(FADD, FSUB) X(FCVT_S_W, FMV_W_X) X(FCVT_WU_S, ANDI)              \
    X(FDIV, FMUL) X(FMADD, ADD) X(FMADD, FLW) X(FMADD, FMADD) X(FMSUB, FMUL)                       \
    X(FMUL, ADD) X(FMUL, FADD) X(FMUL, FCVT_WU_S) X(FMUL, FLT) X(FMUL, FLW) X(FMUL, FMADD)         \
    X(FMUL, FMSUB) X(FMUL, FMUL) X(FMUL, FNMSUB) X(FNMSUB, FMUL) X(FSQRT, FDIV)                    \
    X(FSUB, FLT) X(FSUB, FMUL) X(FSUB, FSUB)

#define RV_ALL_OPS(X) RV_INTEGER_OPS(X) RV_FREE_OPS(X) RV_HOST_OPS(X)

#define RV_ALL_PAIRS(X)                                                                            \
    RV_INTEGER_PAIRS(X) RV_INTEGER_FREE_PAIRS(X) RV_INTEGER_HOST_PAIRS(X)                          \
    RV_FREE_PAIRS(X) RV_FREE_HOST_PAIRS(X) RV_HOST_PAIRS(X)

/* clang-format on */

#endif
