#include "emu/cpu/rv_disasm_rows.h"

/* Fields of a word. */
#define OPCODE 0x0000007fu
#define RD     0x00000f80u
#define FUNCT3 0x00007000u
#define RS1    0x000f8000u
#define RS2    0x01f00000u
#define FUNCT7 0xfe000000u
#define FMT    0x06000000u /* of fused operations: 0 is single */
#define IMM    0xfff00000u /* of the I format; a CSR's number, too */
#define ALL    0xffffffffu

/* Opcodes. */
#define LOAD   0x03u
#define LOADFP 0x07u
#define FENCES 0x0fu
#define OPIMM  0x13u
#define AUIPC  0x17u
#define STORE  0x23u
#define STORFP 0x27u
#define OP     0x33u
#define LUI    0x37u
#define MADD   0x43u
#define MSUB   0x47u
#define NMSUB  0x4bu
#define NMADD  0x4fu
#define OPFP   0x53u
#define BRANCH 0x63u
#define JALR   0x67u
#define JAL    0x6fu
#define SYSTEM 0x73u

#define F3(n) ((uint32_t)(n) << 12)
#define F7(n) ((uint32_t)(n) << 25)
#define D(n)  ((uint32_t)(n) << 7)
#define S(n)  ((uint32_t)(n) << 15)
#define IS(n) ((uint32_t)(n) << 20)

/* Usual shapes, mask and match: told apart by funct3; and funct7; and rs2. */
#define BY_F3(op, f3)      OPCODE | FUNCT3, (op) | F3(f3)
#define BY_F37(op, f3, f7) OPCODE | FUNCT3 | FUNCT7, (op) | F3(f3) | F7(f7)
#define BY_F37T(f3, f7, t) OPCODE | FUNCT3 | FUNCT7 | RS2, OPFP | F3(f3) | F7(f7) | IS(t)
/* Float operations with a rounding mode where funct3 would be. */
#define BY_F7(f7)     OPCODE | FUNCT7, OPFP | F7(f7)
#define BY_F7T(f7, t) OPCODE | FUNCT7 | RS2, OPFP | F7(f7) | IS(t)

/* CSR instructions that have a name of their own. */
#define READ(csr)   OPCODE | FUNCT3 | RS1 | IMM, SYSTEM | F3(2) | IS(csr)
#define WRITE(csr)  OPCODE | FUNCT3 | RD | IMM, SYSTEM | F3(1) | IS(csr)
#define SWAP(csr)   OPCODE | FUNCT3 | IMM, SYSTEM | F3(1) | IS(csr)
#define WRITEI(csr) OPCODE | FUNCT3 | RD | IMM, SYSTEM | F3(5) | IS(csr)
#define SWAPI(csr)  OPCODE | FUNCT3 | IMM, SYSTEM | F3(5) | IS(csr)

/* Pseudo-instructions stand before what they are a case of. */
const struct rv_disasm_row rv_disasm_rows[] = {
    /* Immediates. */
    {ALL, OPIMM, "nop"},
    {OPCODE | FUNCT3 | RS1, OPIMM, "li %d,%i"},
    {OPCODE | FUNCT3 | IMM, OPIMM, "mv %d,%s"},
    {BY_F3(OPIMM, 0), "addi %d,%s,%i"},
    {BY_F37(OPIMM, 1, 0x00), "slli %d,%s,%h"},
    {BY_F3(OPIMM, 2), "slti %d,%s,%i"},
    {OPCODE | FUNCT3 | IMM, OPIMM | F3(3) | IS(1), "seqz %d,%s"},
    {BY_F3(OPIMM, 3), "sltiu %d,%s,%i"},
    {OPCODE | FUNCT3 | IMM, OPIMM | F3(4) | IS(0xfff), "not %d,%s"},
    {BY_F3(OPIMM, 4), "xori %d,%s,%i"},
    {BY_F37(OPIMM, 5, 0x00), "srli %d,%s,%h"},
    {BY_F37(OPIMM, 5, 0x20), "srai %d,%s,%h"},
    {BY_F3(OPIMM, 6), "ori %d,%s,%i"},
    {OPCODE | FUNCT3 | IMM, OPIMM | F3(7) | IS(0xff), "zext.b %d,%s"},
    {BY_F3(OPIMM, 7), "andi %d,%s,%i"},
    {OPCODE, LUI, "lui %d,%u"},
    {OPCODE, AUIPC, "auipc %d,%u"},

    /* Registers. */
    {BY_F37(OP, 0, 0x00), "add %d,%s,%t"},
    {OPCODE | FUNCT3 | FUNCT7 | RS1, OP | F7(0x20), "neg %d,%t"},
    {BY_F37(OP, 0, 0x20), "sub %d,%s,%t"},
    {BY_F37(OP, 1, 0x00), "sll %d,%s,%t"},
    {OPCODE | FUNCT3 | FUNCT7 | RS2, OP | F3(2), "sltz %d,%s"},
    {OPCODE | FUNCT3 | FUNCT7 | RS1, OP | F3(2), "sgtz %d,%t"},
    {BY_F37(OP, 2, 0x00), "slt %d,%s,%t"},
    {OPCODE | FUNCT3 | FUNCT7 | RS1, OP | F3(3), "snez %d,%t"},
    {BY_F37(OP, 3, 0x00), "sltu %d,%s,%t"},
    {BY_F37(OP, 4, 0x00), "xor %d,%s,%t"},
    {BY_F37(OP, 5, 0x00), "srl %d,%s,%t"},
    {BY_F37(OP, 5, 0x20), "sra %d,%s,%t"},
    {BY_F37(OP, 6, 0x00), "or %d,%s,%t"},
    {BY_F37(OP, 7, 0x00), "and %d,%s,%t"},
    {BY_F37(OP, 0, 0x01), "mul %d,%s,%t"},
    {BY_F37(OP, 1, 0x01), "mulh %d,%s,%t"},
    {BY_F37(OP, 2, 0x01), "mulhsu %d,%s,%t"},
    {BY_F37(OP, 3, 0x01), "mulhu %d,%s,%t"},
    {BY_F37(OP, 4, 0x01), "div %d,%s,%t"},
    {BY_F37(OP, 5, 0x01), "divu %d,%s,%t"},
    {BY_F37(OP, 6, 0x01), "rem %d,%s,%t"},
    {BY_F37(OP, 7, 0x01), "remu %d,%s,%t"},

    /* Memory. */
    {BY_F3(LOAD, 0), "lb %d,%i(%s)"},
    {BY_F3(LOAD, 1), "lh %d,%i(%s)"},
    {BY_F3(LOAD, 2), "lw %d,%i(%s)"},
    {BY_F3(LOAD, 4), "lbu %d,%i(%s)"},
    {BY_F3(LOAD, 5), "lhu %d,%i(%s)"},
    {BY_F3(STORE, 0), "sb %t,%o(%s)"},
    {BY_F3(STORE, 1), "sh %t,%o(%s)"},
    {BY_F3(STORE, 2), "sw %t,%o(%s)"},
    {BY_F3(LOADFP, 2), "flw %D,%i(%s)"},
    {BY_F3(STORFP, 2), "fsw %T,%o(%s)"},

    /* Jumps. */
    {OPCODE | RD, JAL, "j %j"},
    {OPCODE | RD, JAL | D(1), "jal %j"},
    {OPCODE, JAL, "jal %d,%j"},
    {ALL, JALR | S(1), "ret"},
    {OPCODE | FUNCT3 | RD | IMM, JALR, "jr %s"},
    {OPCODE | FUNCT3 | RD, JALR, "jr %i(%s)"},
    {OPCODE | FUNCT3 | RD | IMM, JALR | D(1), "jalr %s"},
    {OPCODE | FUNCT3 | RD, JALR | D(1), "jalr %i(%s)"},
    {OPCODE | FUNCT3 | IMM, JALR, "jalr %d,%s"},
    {OPCODE | FUNCT3, JALR, "jalr %d,%i(%s)"},
    {OPCODE | FUNCT3 | RS2, BRANCH, "beqz %s,%b"},
    {BY_F3(BRANCH, 0), "beq %s,%t,%b"},
    {OPCODE | FUNCT3 | RS2, BRANCH | F3(1), "bnez %s,%b"},
    {BY_F3(BRANCH, 1), "bne %s,%t,%b"},
    {OPCODE | FUNCT3 | RS2, BRANCH | F3(4), "bltz %s,%b"},
    {OPCODE | FUNCT3 | RS1, BRANCH | F3(4), "bgtz %t,%b"},
    {BY_F3(BRANCH, 4), "blt %s,%t,%b"},
    {OPCODE | FUNCT3 | RS1, BRANCH | F3(5), "blez %t,%b"},
    {OPCODE | FUNCT3 | RS2, BRANCH | F3(5), "bgez %s,%b"},
    {BY_F3(BRANCH, 5), "bge %s,%t,%b"},
    {BY_F3(BRANCH, 6), "bltu %s,%t,%b"},
    {BY_F3(BRANCH, 7), "bgeu %s,%t,%b"},

    /* Fences ignore their other fields: these are kept for later standards. */
    {OPCODE | FUNCT3 | IMM, FENCES | IS(0x833), "fence.tso"},
    {OPCODE | FUNCT3 | IMM, FENCES | IS(0x0ff), "fence"},
    {BY_F3(FENCES, 0), "fence %p,%q"},
    {BY_F3(FENCES, 1), "fence.i"},

    /* System. */
    {ALL, SYSTEM, "ecall"},
    {ALL, SYSTEM | IS(0x001), "ebreak"},
    {ALL, SYSTEM | IS(0x302), "mret"},
    {ALL, SYSTEM | IS(0x105), "wfi"},
    {ALL, SYSTEM | F3(1) | IS(0xc00), "unimp"},
    {READ(0x001), "frflags %d"},
    {READ(0x002), "frrm %d"},
    {READ(0x003), "frcsr %d"},
    {READ(0xc00), "rdcycle %d"},
    {READ(0xc01), "rdtime %d"},
    {READ(0xc02), "rdinstret %d"},
    {READ(0xc80), "rdcycleh %d"},
    {READ(0xc81), "rdtimeh %d"},
    {READ(0xc82), "rdinstreth %d"},
    {WRITE(0x001), "fsflags %s"},
    {SWAP(0x001), "fsflags %d,%s"},
    {WRITE(0x002), "fsrm %s"},
    {SWAP(0x002), "fsrm %d,%s"},
    {WRITE(0x003), "fscsr %s"},
    {SWAP(0x003), "fscsr %d,%s"},
    {WRITEI(0x001), "fsflagsi %z"},
    {SWAPI(0x001), "fsflagsi %d,%z"},
    {WRITEI(0x002), "fsrmi %z"},
    {SWAPI(0x002), "fsrmi %d,%z"},
    {OPCODE | FUNCT3 | RD, SYSTEM | F3(1), "csrw %c,%s"},
    {BY_F3(SYSTEM, 1), "csrrw %d,%c,%s"},
    {OPCODE | FUNCT3 | RS1, SYSTEM | F3(2), "csrr %d,%c"},
    {OPCODE | FUNCT3 | RD, SYSTEM | F3(2), "csrs %c,%s"},
    {BY_F3(SYSTEM, 2), "csrrs %d,%c,%s"},
    {OPCODE | FUNCT3 | RD, SYSTEM | F3(3), "csrc %c,%s"},
    {BY_F3(SYSTEM, 3), "csrrc %d,%c,%s"},
    {OPCODE | FUNCT3 | RD, SYSTEM | F3(5), "csrwi %c,%z"},
    {BY_F3(SYSTEM, 5), "csrrwi %d,%c,%z"},
    {OPCODE | FUNCT3 | RD, SYSTEM | F3(6), "csrsi %c,%z"},
    {BY_F3(SYSTEM, 6), "csrrsi %d,%c,%z"},
    {OPCODE | FUNCT3 | RD, SYSTEM | F3(7), "csrci %c,%z"},
    {BY_F3(SYSTEM, 7), "csrrci %d,%c,%z"},

    /* Floats. */
    {OPCODE | FMT, MADD, "fmadd.s %D,%S,%T,%R%m"},
    {OPCODE | FMT, MSUB, "fmsub.s %D,%S,%T,%R%m"},
    {OPCODE | FMT, NMSUB, "fnmsub.s %D,%S,%T,%R%m"},
    {OPCODE | FMT, NMADD, "fnmadd.s %D,%S,%T,%R%m"},
    {BY_F7(0x00), "fadd.s %D,%S,%T%m"},
    {BY_F7(0x04), "fsub.s %D,%S,%T%m"},
    {BY_F7(0x08), "fmul.s %D,%S,%T%m"},
    {BY_F7(0x0c), "fdiv.s %D,%S,%T%m"},
    {BY_F7T(0x2c, 0), "fsqrt.s %D,%S%m"},
    {BY_F37(OPFP, 0, 0x10), "fmv.s %D,%S%="},
    {BY_F37(OPFP, 0, 0x10), "fsgnj.s %D,%S,%T"},
    {BY_F37(OPFP, 1, 0x10), "fneg.s %D,%S%="},
    {BY_F37(OPFP, 1, 0x10), "fsgnjn.s %D,%S,%T"},
    {BY_F37(OPFP, 2, 0x10), "fabs.s %D,%S%="},
    {BY_F37(OPFP, 2, 0x10), "fsgnjx.s %D,%S,%T"},
    {BY_F37(OPFP, 0, 0x14), "fmin.s %D,%S,%T"},
    {BY_F37(OPFP, 1, 0x14), "fmax.s %D,%S,%T"},
    {BY_F37(OPFP, 0, 0x50), "fle.s %d,%S,%T"},
    {BY_F37(OPFP, 1, 0x50), "flt.s %d,%S,%T"},
    {BY_F37(OPFP, 2, 0x50), "feq.s %d,%S,%T"},
    {BY_F7T(0x60, 0), "fcvt.w.s %d,%S%m"},
    {BY_F7T(0x60, 1), "fcvt.wu.s %d,%S%m"},
    {BY_F7T(0x68, 0), "fcvt.s.w %D,%s%m"},
    {BY_F7T(0x68, 1), "fcvt.s.wu %D,%s%m"},
    {BY_F37T(0, 0x70, 0), "fmv.x.w %d,%S"},
    {BY_F37T(1, 0x70, 0), "fclass.s %d,%S"},
    {BY_F37T(0, 0x78, 0), "fmv.w.x %D,%s"},
};

const size_t rv_disasm_row_count = sizeof rv_disasm_rows / sizeof *rv_disasm_rows;
