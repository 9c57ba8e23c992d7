/* rv_op_list.h — the list of handlers.
 *
 * Models:     names only: what they do is in rv_ops.inc. The decoder's numbers, the loops' labels
 *             and their tables are made from these lists.
 * Source:     The RISC-V Instruction Set Manual I, chapters 2, 7, 11. Which pairs are worth a
 *             handler was counted: firmware that draws lines, fills shaded polygons, prints, sorts,
 *             multiplies matrices and walks lists begins 0.57 handlers an instruction with these,
 *             and would begin 0.55 with every pair that there is.
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
    X(ADDI, ADDI) X(ADDI, SLLI) X(ADDI, ADD) X(ADDI, XOR) X(ADDI, BEQ) X(ADDI, BNE) X(ADDI, J)     \
    X(ADDI, JAL) X(ADDI, JR) X(ADDI, JALR) X(ADDI, SW) X(SLLI, ADDI) X(SLLI, SRLI) X(SLLI, LI)     \
    X(SLLI, ADD) X(SLLI, XOR) X(SLLI, BNE) X(SRLI, ADDI) X(SRLI, ANDI) X(SRLI, AND) X(SRAI, AND)   \
    X(ANDI, ADD) X(ANDI, SUB) X(ANDI, SB) X(LI, ADDI) X(LI, LI) X(LI, ADD) X(LI, BEQ) X(LI, BNE)   \
    X(LI, J) X(LI, JR) X(LI, LW) X(ADD, SLLI) X(ADD, ANDI) X(ADD, ADD) X(ADD, OR) X(ADD, MUL)      \
    X(ADD, BEQ) X(ADD, BNE) X(ADD, BLT) X(ADD, J) X(ADD, LW) X(ADD, LBU) X(ADD, SB) X(SUB, ADDI)   \
    X(SUB, AND) X(SUB, SW) X(XOR, MUL) X(OR, BNE) X(AND, XOR) X(MUL, ADDI) X(MULHU, ADD)           \
    X(BEQ, ADDI) X(BEQ, LI) X(BEQ, BLT) X(BNE, ADDI) X(BNE, ADD) X(BNE, BNE) X(BNE, LW)            \
    X(BLT, ADDI) X(BLT, ADD) X(BLT, SLT) X(BLT, BNE) X(BLTU, ADDI) X(LW, ADDI) X(LW, ADD)          \
    X(LW, LW) X(LW, SW) X(LBU, ADDI) X(LBU, SLLI) X(SB, ADDI) X(SB, SLLI) X(SB, ADD) X(SB, SW)     \
    X(SW, ADDI) X(SW, ADD) X(SW, JR) X(SW, LW) X(SW, SW)

#define RV_INTEGER_FREE_PAIRS(X)                                                                   \
    X(LI, FLW) X(ADD, FLW) X(SB, FSW)

#define RV_INTEGER_HOST_PAIRS(X)                                                                   \
    X(ADDI, FADD) X(LI, FMUL) X(ADD, FMUL) X(BEQ, FCVT_S_W) X(BNE, FSUB)

#define RV_FREE_PAIRS(X)                                                                           \
    X(FLW, LW) X(FLW, FLW) X(FLW, FSW) X(FLW, FMV_W_X) X(FLW, FSGNJ) X(FSW, JR) X(FSW, FSW)        \
    X(FSGNJ, ADDI) X(FSGNJ, FSGNJ) X(FSGNJ, FLT) X(FLT, BEQ) X(FLT, BNE) X(FLE, BNE)

#define RV_FREE_HOST_PAIRS(X)                                                                      \
    X(FLW, FSUB) X(FLW, FMUL) X(FSW, FMADD) X(FMV_W_X, FADD)

#define RV_HOST_PAIRS(X)                                                                           \
    X(FADD, ADDI) X(FADD, FLW) X(FADD, FADD) X(FADD, FCVT_WU_S) X(FSUB, FLW) X(FSUB, FLT)          \
    X(FSUB, FSUB) X(FMUL, LI) X(FMUL, FLT) X(FMUL, FMUL) X(FMUL, FMADD) X(FMUL, FMSUB)             \
    X(FMUL, FNMSUB) X(FDIV, FLW) X(FDIV, FMUL) X(FMADD, ADDI) X(FMADD, ADD) X(FMADD, BNE)          \
    X(FMADD, FLW) X(FMADD, FSW) X(FMADD, FSQRT) X(FMADD, FMADD) X(FNMSUB, FLT) X(FCVT_W_S, XORI)

#define RV_ALL_OPS(X) RV_INTEGER_OPS(X) RV_FREE_OPS(X) RV_HOST_OPS(X)

#define RV_ALL_PAIRS(X)                                                                            \
    RV_INTEGER_PAIRS(X) RV_INTEGER_FREE_PAIRS(X) RV_INTEGER_HOST_PAIRS(X)                          \
    RV_FREE_PAIRS(X) RV_FREE_HOST_PAIRS(X) RV_HOST_PAIRS(X)

/* clang-format on */

#endif
