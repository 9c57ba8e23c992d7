/* rv_decode.c — from a word to an entry. Only what a loop can do by itself gets a handler. */
#include "emu/cpu/rv_decode.h"
#include "emu/cpu/rv_parts.h"
#include "emu/cpu/rv_word.h"

_Static_assert(RV_DO_COUNT <= 256, "an op is a byte");

#define SLOW ((struct rv_entry){.op = RV_DO_SLOW})

/* What goes to x0 goes where nobody looks. */
static uint8_t x_out(uint32_t word)
{
    unsigned rd = rv_rd(word);
    return (uint8_t)(rd == 0 ? 32 : rd);
}

static struct rv_entry make(enum rv_op op, uint32_t word, uint8_t rd, uint32_t imm)
{
    return (struct rv_entry){
        .op = (uint8_t)op,
        .rd = rd,
        .rs1 = (uint8_t)rv_rs1(word),
        .rs2 = (uint8_t)rv_rs2(word),
        .imm = (int32_t)imm,
    };
}

static struct rv_entry constant(uint32_t word, uint32_t value)
{
    return make(RV_DO_LI, word, x_out(word), value);
}

static struct rv_entry decode_imm(uint32_t word)
{
    static const uint8_t ops[8] = {RV_DO_ADDI, RV_DO_SLLI, RV_DO_SLTI, RV_DO_SLTIU,
                                   RV_DO_XORI, RV_DO_SRLI, RV_DO_ORI,  RV_DO_ANDI};
    unsigned funct3 = rv_funct3(word), funct7 = rv_funct7(word);
    if (funct3 == 0 && rv_rs1(word) == 0)
        return constant(word, rv_imm_i(word));
    if (funct3 == 1 || funct3 == 5) { /* shifts have an amount and funct7 */
        enum rv_op op = funct3 == 5 && funct7 == 0x20 ? RV_DO_SRAI : (enum rv_op)ops[funct3];
        if (funct7 != 0 && op != RV_DO_SRAI)
            return SLOW;
        return make(op, word, x_out(word), rv_rs2(word));
    }
    return make((enum rv_op)ops[funct3], word, x_out(word), rv_imm_i(word));
}

static struct rv_entry decode_reg(uint32_t word)
{
    static const uint8_t base[8] = {RV_DO_ADD, RV_DO_SLL, RV_DO_SLT, RV_DO_SLTU,
                                    RV_DO_XOR, RV_DO_SRL, RV_DO_OR,  RV_DO_AND};
    static const uint8_t muldiv[8] = {RV_DO_MUL, RV_DO_MULH, RV_DO_MULHSU, RV_DO_MULHU,
                                      RV_DO_DIV, RV_DO_DIVU, RV_DO_REM,    RV_DO_REMU};
    unsigned funct3 = rv_funct3(word), funct7 = rv_funct7(word), op = RV_DO_SLOW;
    if (funct7 == 0)
        op = base[funct3];
    else if (funct7 == 1)
        op = muldiv[funct3];
    else if (funct7 == 0x20 && funct3 == 0)
        op = RV_DO_SUB;
    else if (funct7 == 0x20 && funct3 == 5)
        op = RV_DO_SRA;
    return make((enum rv_op)op, word, x_out(word), 0);
}

/* A jump to `target`, as the distance from behind the entry; SLOW when nobody can go there. */
static struct rv_entry jump(const struct rv_cpu *cpu, struct rv_entry made, uint32_t pc,
                            uint32_t target)
{
    if (!rv_fetchable(cpu, target))
        return SLOW;
    const struct rv_entry *behind = rv_entry_of(cpu, pc) + 1;
    made.imm = (int32_t)((rv_entry_of(cpu, target) - behind) * (ptrdiff_t)sizeof *behind);
    return made;
}

static struct rv_entry decode_branch(const struct rv_cpu *cpu, uint32_t pc, uint32_t word)
{
    static const uint8_t ops[8] = {RV_DO_BEQ, RV_DO_BNE, RV_DO_SLOW, RV_DO_SLOW,
                                   RV_DO_BLT, RV_DO_BGE, RV_DO_BLTU, RV_DO_BGEU};
    struct rv_entry made = make((enum rv_op)ops[rv_funct3(word)], word, 0, 0);
    return jump(cpu, made, pc, pc + rv_imm_b(word));
}

static struct rv_entry decode_load(const struct rv_cpu *cpu, uint32_t word)
{
    static const uint8_t ops[8] = {RV_DO_LB,  RV_DO_LH,  RV_DO_LW,   RV_DO_SLOW,
                                   RV_DO_LBU, RV_DO_LHU, RV_DO_SLOW, RV_DO_SLOW};
    return make((enum rv_op)ops[rv_funct3(word)], word, x_out(word),
                rv_imm_i(word) - cpu->desc.memory_base);
}

static struct rv_entry decode_store(const struct rv_cpu *cpu, uint32_t word)
{
    static const uint8_t ops[8] = {RV_DO_SB,   RV_DO_SH,   RV_DO_SW,   RV_DO_SLOW,
                                   RV_DO_SLOW, RV_DO_SLOW, RV_DO_SLOW, RV_DO_SLOW};
    return make((enum rv_op)ops[rv_funct3(word)], word, 0, rv_imm_s(word) - cpu->desc.memory_base);
}

/* The dynamic rounding mode is looked at by the loops' choice of handlers, which nearest even suits,
 * too. */
static bool host_rounds(uint32_t word)
{
    return rv_funct3(word) == RV_DYN || rv_funct3(word) == RV_RNE;
}

/* The third register in imm. */
static struct rv_entry decode_fused(uint32_t word)
{
    unsigned op = RV_DO_SLOW;
    if (rv_field(word, 25, 2) != 0 || !host_rounds(word))
        return SLOW;
    switch (rv_opcode(word)) {
    case RV_MADD:
        op = RV_DO_FMADD;
        break;
    case RV_MSUB:
        op = RV_DO_FMSUB;
        break;
    case RV_NMSUB:
        op = RV_DO_FNMSUB;
        break;
    default:
        op = RV_DO_FNMADD;
        break;
    }
    return make((enum rv_op)op, word, (uint8_t)rv_rd(word), rv_rs3(word));
}

static struct rv_entry decode_arithmetic(uint32_t word)
{
    unsigned op = RV_DO_SLOW;
    switch (rv_funct7(word)) {
    case RV_FP_ADD:
        op = RV_DO_FADD;
        break;
    case RV_FP_SUB:
        op = RV_DO_FSUB;
        break;
    case RV_FP_MUL:
        op = RV_DO_FMUL;
        break;
    case RV_FP_DIV:
        op = RV_DO_FDIV;
        break;
    case RV_FP_SQRT:
        op = rv_rs2(word) == 0 ? RV_DO_FSQRT : RV_DO_SLOW;
        break;
    }
    return host_rounds(word) ? make((enum rv_op)op, word, (uint8_t)rv_rd(word), 0) : SLOW;
}

static struct rv_entry decode_convert(uint32_t word)
{
    unsigned to_unsigned = rv_rs2(word);
    if (to_unsigned > 1)
        return SLOW;
    if (rv_funct7(word) == RV_FP_TO_INT)
        return rv_funct3(word) == RV_RTZ
                   ? make(to_unsigned ? RV_DO_FCVT_WU_S : RV_DO_FCVT_W_S, word, x_out(word), 0)
                   : SLOW;
    return host_rounds(word)
               ? make(to_unsigned ? RV_DO_FCVT_S_WU : RV_DO_FCVT_S_W, word, (uint8_t)rv_rd(word), 0)
               : SLOW;
}

static struct rv_entry decode_float(uint32_t word)
{
    static const uint8_t signs[8] = {RV_DO_FSGNJ, RV_DO_FSGNJN, RV_DO_FSGNJX, RV_DO_SLOW,
                                     RV_DO_SLOW,  RV_DO_SLOW,   RV_DO_SLOW,   RV_DO_SLOW};
    static const uint8_t min_max[8] = {RV_DO_FMIN, RV_DO_FMAX, RV_DO_SLOW, RV_DO_SLOW,
                                       RV_DO_SLOW, RV_DO_SLOW, RV_DO_SLOW, RV_DO_SLOW};
    static const uint8_t compare[8] = {RV_DO_FLE,  RV_DO_FLT,  RV_DO_FEQ,  RV_DO_SLOW,
                                       RV_DO_SLOW, RV_DO_SLOW, RV_DO_SLOW, RV_DO_SLOW};
    uint8_t f_out = (uint8_t)rv_rd(word);
    unsigned funct3 = rv_funct3(word), rs2 = rv_rs2(word);
    switch (rv_funct7(word)) {
    case RV_FP_SIGN:
        return make((enum rv_op)signs[funct3], word, f_out, 0);
    case RV_FP_MINMAX:
        return make((enum rv_op)min_max[funct3], word, f_out, 0);
    case RV_FP_COMPARE:
        return make((enum rv_op)compare[funct3], word, x_out(word), 0);
    case RV_FP_TO_X:
        return rs2 == 0 && funct3 == 0 ? make(RV_DO_FMV_X_W, word, x_out(word), 0) : SLOW;
    case RV_FP_FROM_X:
        return rs2 == 0 && funct3 == 0 ? make(RV_DO_FMV_W_X, word, f_out, 0) : SLOW;
    case RV_FP_TO_INT:
    case RV_FP_FROM_INT:
        return decode_convert(word);
    default:
        return decode_arithmetic(word);
    }
}

static struct rv_entry decode_word(const struct rv_cpu *cpu, uint32_t pc, uint32_t word)
{
    unsigned funct3 = rv_funct3(word), base = cpu->desc.memory_base;
    switch (rv_opcode(word)) {
    case RV_LUI:
        return constant(word, rv_imm_u(word));
    case RV_AUIPC:
        return constant(word, pc + rv_imm_u(word));
    case RV_OP_IMM:
        return decode_imm(word);
    case RV_OP:
        return decode_reg(word);
    case RV_JAL:
        return jump(cpu, make(rv_rd(word) == 0 ? RV_DO_J : RV_DO_JAL, word, x_out(word), 0), pc,
                    pc + rv_imm_j(word));
    case RV_JALR:
        return funct3 != 0 ? SLOW
                           : make(rv_rd(word) == 0 ? RV_DO_JR : RV_DO_JALR, word, x_out(word),
                                  rv_imm_i(word) - base);
    case RV_BRANCH:
        return decode_branch(cpu, pc, word);
    case RV_LOAD:
        return decode_load(cpu, word);
    case RV_STORE:
        return decode_store(cpu, word);
    case RV_LOAD_FP:
        return funct3 != 2 ? SLOW
                           : make(RV_DO_FLW, word, (uint8_t)rv_rd(word), rv_imm_i(word) - base);
    case RV_STORE_FP:
        return funct3 != 2 ? SLOW : make(RV_DO_FSW, word, 0, rv_imm_s(word) - base);
    case RV_OP_FP:
        return decode_float(word);
    case RV_MADD:
    case RV_MSUB:
    case RV_NMSUB:
    case RV_NMADD:
        return decode_fused(word);
    case RV_MISC_MEM: /* fence, fence.i: nothing to wait for, and no stale words */
        return funct3 > 1 ? SLOW : make(RV_DO_LI, word, 32, 0);
    default:
        return SLOW;
    }
}

/* Makes the entry do the work of the next one, too, when they are a pair. The next entry stays as it
 * is: its handler is for those who jump there, its operands for both. */
static void join(struct rv_entry *entry, unsigned first, unsigned second)
{
    static const struct {
        uint8_t first, second, both;
    } pairs[] = {
#define PAIR(first, second) {RV_DO_##first, RV_DO_##second, RV_DO_##first##_##second},
        RV_ALL_PAIRS(PAIR)
#undef PAIR
    };
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++)
        if (pairs[i].first == first && pairs[i].second == second)
            entry->op = pairs[i].both;
}

void rv_part(struct rv_entry *entry)
{
    static const uint8_t first_of[256] = {
#define PAIR(first, second) [RV_DO_##first##_##second] = RV_DO_##first,
        RV_ALL_PAIRS(PAIR)
#undef PAIR
    };
    if (first_of[entry->op] != 0)
        entry->op = first_of[entry->op];
}

/* Words up to the next checkpoint. */
static void decode_run(struct rv_cpu *cpu, struct rv_entry *entry, uint32_t words)
{
    uint32_t pc = rv_pc_of(cpu, entry), word;
    uint8_t op[RV_RUN];
    rv_mark_decoded(cpu, pc - cpu->desc.memory_base);
    for (uint32_t i = 0; i < words; i++) {
        rv_fetch(cpu, pc + 4 * i, &word);
        entry[i] = decode_word(cpu, pc + 4 * i, word);
        op[i] = entry[i].op;
    }
    for (uint32_t i = 0; i + 1 < words; i++)
        join(entry + i, op[i], op[i + 1]);
}

void rv_decode(struct rv_cpu *cpu, struct rv_entry *entry)
{
    uint32_t index = (uint32_t)(entry - cpu->entries), place = index % (RV_RUN + 1);
    if (index == rv_index_of_word(cpu->desc.memory_size / 4))
        entry->op = RV_DO_END;
    else if (place == RV_RUN)
        entry->op = RV_DO_CHECKPOINT;
    else
        decode_run(cpu, entry, RV_RUN - place);
}
