/* insn_table.c — the rows. */
#include "tests/cpu/qemu/insn_table.h"

#include <assert.h>
#include <string.h>

/* Which bits are given: the opcode; with funct3; with funct7; with rs2 too; all. */
#define OPCODE  0x0000007f
#define FUNCT3  0x0000707f
#define FUNCT7  0xfe00707f
#define FUNCT2  0x0600007f /* four operands: the format's two bits */
#define ROUNDED 0xfe00007f /* funct7, and rm where funct3 was */
#define UNARY   0xfff0007f /* and rs2 */
#define MOVE    0xfff0707f
#define ALL     0xffffffff

const struct insn insn_table[INSN_COUNT] = {
    {"lui", INSN_UPPER, 0x00000037, OPCODE},         {"auipc", INSN_UPPER, 0x00000017, OPCODE},
    {"jal", INSN_JAL, 0x0000006f, OPCODE},           {"jalr", INSN_JALR, 0x00000067, FUNCT3},
    {"beq", INSN_BRANCH, 0x00000063, FUNCT3},        {"bne", INSN_BRANCH, 0x00001063, FUNCT3},
    {"blt", INSN_BRANCH, 0x00004063, FUNCT3},        {"bge", INSN_BRANCH, 0x00005063, FUNCT3},
    {"bltu", INSN_BRANCH, 0x00006063, FUNCT3},       {"bgeu", INSN_BRANCH, 0x00007063, FUNCT3},
    {"lb", INSN_LOAD, 0x00000003, FUNCT3},           {"lh", INSN_LOAD, 0x00001003, FUNCT3},
    {"lw", INSN_LOAD, 0x00002003, FUNCT3},           {"lbu", INSN_LOAD, 0x00004003, FUNCT3},
    {"lhu", INSN_LOAD, 0x00005003, FUNCT3},          {"sb", INSN_STORE, 0x00000023, FUNCT3},
    {"sh", INSN_STORE, 0x00001023, FUNCT3},          {"sw", INSN_STORE, 0x00002023, FUNCT3},
    {"addi", INSN_IMMEDIATE, 0x00000013, FUNCT3},    {"slti", INSN_IMMEDIATE, 0x00002013, FUNCT3},
    {"sltiu", INSN_IMMEDIATE, 0x00003013, FUNCT3},   {"xori", INSN_IMMEDIATE, 0x00004013, FUNCT3},
    {"ori", INSN_IMMEDIATE, 0x00006013, FUNCT3},     {"andi", INSN_IMMEDIATE, 0x00007013, FUNCT3},
    {"slli", INSN_SHIFT, 0x00001013, FUNCT7},        {"srli", INSN_SHIFT, 0x00005013, FUNCT7},
    {"srai", INSN_SHIFT, 0x40005013, FUNCT7},        {"add", INSN_REGISTERS, 0x00000033, FUNCT7},
    {"sub", INSN_REGISTERS, 0x40000033, FUNCT7},     {"sll", INSN_REGISTERS, 0x00001033, FUNCT7},
    {"slt", INSN_REGISTERS, 0x00002033, FUNCT7},     {"sltu", INSN_REGISTERS, 0x00003033, FUNCT7},
    {"xor", INSN_REGISTERS, 0x00004033, FUNCT7},     {"srl", INSN_REGISTERS, 0x00005033, FUNCT7},
    {"sra", INSN_REGISTERS, 0x40005033, FUNCT7},     {"or", INSN_REGISTERS, 0x00006033, FUNCT7},
    {"and", INSN_REGISTERS, 0x00007033, FUNCT7},     {"fence", INSN_FENCE, 0x0000000f, 0xf00fffff},
    {"fence.i", INSN_FIXED, 0x0000100f, ALL},        {"ecall", INSN_ECALL, 0x00000073, ALL},
    {"csrrw", INSN_CSR, 0x00001073, FUNCT3},         {"csrrs", INSN_CSR, 0x00002073, FUNCT3},
    {"csrrc", INSN_CSR, 0x00003073, FUNCT3},         {"csrrwi", INSN_CSR_IMM, 0x00005073, FUNCT3},
    {"csrrsi", INSN_CSR_IMM, 0x00006073, FUNCT3},    {"csrrci", INSN_CSR_IMM, 0x00007073, FUNCT3},
    {"mul", INSN_REGISTERS, 0x02000033, FUNCT7},     {"mulh", INSN_REGISTERS, 0x02001033, FUNCT7},
    {"mulhsu", INSN_REGISTERS, 0x02002033, FUNCT7},  {"mulhu", INSN_REGISTERS, 0x02003033, FUNCT7},
    {"div", INSN_REGISTERS, 0x02004033, FUNCT7},     {"divu", INSN_REGISTERS, 0x02005033, FUNCT7},
    {"rem", INSN_REGISTERS, 0x02006033, FUNCT7},     {"remu", INSN_REGISTERS, 0x02007033, FUNCT7},
    {"flw", INSN_F_LOAD, 0x00002007, FUNCT3},        {"fsw", INSN_F_STORE, 0x00002027, FUNCT3},
    {"fmadd.s", INSN_F_FOUR, 0x00000043, FUNCT2},    {"fmsub.s", INSN_F_FOUR, 0x00000047, FUNCT2},
    {"fnmsub.s", INSN_F_FOUR, 0x0000004b, FUNCT2},   {"fnmadd.s", INSN_F_FOUR, 0x0000004f, FUNCT2},
    {"fadd.s", INSN_F_THREE, 0x00000053, ROUNDED},   {"fsub.s", INSN_F_THREE, 0x08000053, ROUNDED},
    {"fmul.s", INSN_F_THREE, 0x10000053, ROUNDED},   {"fdiv.s", INSN_F_THREE, 0x18000053, ROUNDED},
    {"fsqrt.s", INSN_F_TWO, 0x58000053, UNARY},      {"fsgnj.s", INSN_F_PLAIN, 0x20000053, FUNCT7},
    {"fsgnjn.s", INSN_F_PLAIN, 0x20001053, FUNCT7},  {"fsgnjx.s", INSN_F_PLAIN, 0x20002053, FUNCT7},
    {"fmin.s", INSN_F_PLAIN, 0x28000053, FUNCT7},    {"fmax.s", INSN_F_PLAIN, 0x28001053, FUNCT7},
    {"fcvt.w.s", INSN_F_TO_X, 0xc0000053, UNARY},    {"fcvt.wu.s", INSN_F_TO_X, 0xc0100053, UNARY},
    {"fmv.x.w", INSN_F_MOVE_X, 0xe0000053, MOVE},    {"feq.s", INSN_F_COMPARE, 0xa0002053, FUNCT7},
    {"flt.s", INSN_F_COMPARE, 0xa0001053, FUNCT7},   {"fle.s", INSN_F_COMPARE, 0xa0000053, FUNCT7},
    {"fclass.s", INSN_F_MOVE_X, 0xe0001053, MOVE},   {"fcvt.s.w", INSN_F_FROM_X, 0xd0000053, UNARY},
    {"fcvt.s.wu", INSN_F_FROM_X, 0xd0100053, UNARY}, {"fmv.w.x", INSN_X_MOVE_F, 0xf0000053, MOVE},
};

unsigned insn_index(uint32_t word)
{
    unsigned i = 0;

    while (i < INSN_COUNT && (word & insn_table[i].mask) != insn_table[i].match)
        i++;
    return i;
}

int insn_rounds(const struct insn *i)
{
    switch (i->kind) {
    case INSN_F_FOUR:
    case INSN_F_THREE:
    case INSN_F_TWO:
    case INSN_F_TO_X:
    case INSN_F_FROM_X:
        return 1;
    default:
        return 0;
    }
}

const struct insn *insn_named(const char *name)
{
    unsigned i = 0;

    while (i < INSN_COUNT && strcmp(insn_table[i].name, name) != 0)
        i++;
    assert(i < INSN_COUNT);
    return &insn_table[i];
}
