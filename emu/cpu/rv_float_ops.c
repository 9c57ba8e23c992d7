/* rv_float_ops.c — float instructions by their word, the exact way. */
#include "emu/cpu/rv_parts.h"
#include "emu/cpu/rv_word.h"

#define SIGN 0x80000000u

struct operands {
    uint32_t a, b, c; /* float registers rs1, rs2, rs3 */
    unsigned rm;      /* resolved */
};

/* False: no rounding mode. */
static bool resolve(const struct rv_cpu *cpu, uint32_t word, unsigned *rm)
{
    *rm = rv_funct3(word) == RV_DYN ? cpu->frm : rv_funct3(word);
    return *rm <= RV_RMM;
}

static void write_f(struct rv_cpu *cpu, uint32_t word, uint32_t value)
{
    cpu->f[rv_rd(word)] = value;
    cpu->mstatus |= RV_MSTATUS_FS;
}

/* To an integer register; flags may have been raised. */
static void write_x(struct rv_cpu *cpu, uint32_t word, uint32_t value)
{
    cpu->x[rv_rd(word) == 0 ? 32 : rv_rd(word)] = value;
}

static bool fused(struct rv_cpu *cpu, uint32_t word)
{
    unsigned rm;
    uint32_t a = cpu->f[rv_rs1(word)], c = cpu->f[rv_rs3(word)];
    if (rv_field(word, 25, 2) != 0 || !resolve(cpu, word, &rm))
        return false;
    /* msub: ab − c; nmsub: −ab + c; nmadd: −ab − c. */
    if (rv_opcode(word) == RV_NMSUB || rv_opcode(word) == RV_NMADD)
        a ^= SIGN;
    if (rv_opcode(word) == RV_MSUB || rv_opcode(word) == RV_NMADD)
        c ^= SIGN;
    write_f(cpu, word, rv_fmadd(a, cpu->f[rv_rs2(word)], c, rm, &cpu->fflags));
    return true;
}

static bool arithmetic(struct rv_cpu *cpu, uint32_t word)
{
    unsigned rm;
    uint32_t a = cpu->f[rv_rs1(word)], b = cpu->f[rv_rs2(word)], value;
    if (!resolve(cpu, word, &rm))
        return false;
    switch (rv_funct7(word)) {
    case RV_FP_ADD:
        value = rv_fadd(a, b, rm, &cpu->fflags);
        break;
    case RV_FP_SUB:
        value = rv_fsub(a, b, rm, &cpu->fflags);
        break;
    case RV_FP_MUL:
        value = rv_fmul(a, b, rm, &cpu->fflags);
        break;
    case RV_FP_DIV:
        value = rv_fdiv(a, b, rm, &cpu->fflags);
        break;
    default: /* RV_FP_SQRT */
        if (rv_rs2(word) != 0)
            return false;
        value = rv_fsqrt(a, rm, &cpu->fflags);
        break;
    }
    write_f(cpu, word, value);
    return true;
}

static bool sign(struct rv_cpu *cpu, uint32_t word)
{
    uint32_t a = cpu->f[rv_rs1(word)], b = cpu->f[rv_rs2(word)];
    const uint32_t signs[] = {b, ~b, a ^ b};
    if (rv_funct3(word) > 2)
        return false;
    write_f(cpu, word, (a & ~SIGN) | (signs[rv_funct3(word)] & SIGN));
    return true;
}

static bool min_max(struct rv_cpu *cpu, uint32_t word)
{
    uint32_t a = cpu->f[rv_rs1(word)], b = cpu->f[rv_rs2(word)];
    if (rv_funct3(word) > 1)
        return false;
    write_f(cpu, word,
            rv_funct3(word) == 0 ? rv_fmin(a, b, &cpu->fflags) : rv_fmax(a, b, &cpu->fflags));
    return true;
}

static bool compare(struct rv_cpu *cpu, uint32_t word)
{
    uint32_t a = cpu->f[rv_rs1(word)], b = cpu->f[rv_rs2(word)], value;
    switch (rv_funct3(word)) {
    case 0:
        value = rv_fle(a, b, &cpu->fflags);
        break;
    case 1:
        value = rv_flt(a, b, &cpu->fflags);
        break;
    case 2:
        value = rv_feq(a, b, &cpu->fflags);
        break;
    default:
        return false;
    }
    write_x(cpu, word, value);
    return true;
}

static bool to_int(struct rv_cpu *cpu, uint32_t word)
{
    unsigned rm;
    uint32_t a = cpu->f[rv_rs1(word)];
    if (rv_rs2(word) > 1 || !resolve(cpu, word, &rm))
        return false;
    write_x(cpu, word,
            rv_rs2(word) == 0 ? rv_fcvt_w(a, rm, &cpu->fflags) : rv_fcvt_wu(a, rm, &cpu->fflags));
    return true;
}

static bool from_int(struct rv_cpu *cpu, uint32_t word)
{
    unsigned rm;
    uint32_t a = cpu->x[rv_rs1(word)];
    if (rv_rs2(word) > 1 || !resolve(cpu, word, &rm))
        return false;
    write_f(cpu, word,
            rv_rs2(word) == 0 ? rv_fcvt_from_w(a, rm, &cpu->fflags)
                              : rv_fcvt_from_wu(a, rm, &cpu->fflags));
    return true;
}

/* fmv.x.w and fclass.s */
static bool to_x(struct rv_cpu *cpu, uint32_t word)
{
    uint32_t a = cpu->f[rv_rs1(word)];
    if (rv_rs2(word) != 0 || rv_funct3(word) > 1)
        return false;
    write_x(cpu, word, rv_funct3(word) == 0 ? a : rv_fclass(a));
    return true;
}

static bool from_x(struct rv_cpu *cpu, uint32_t word)
{
    if (rv_rs2(word) != 0 || rv_funct3(word) != 0)
        return false;
    write_f(cpu, word, cpu->x[rv_rs1(word)]);
    return true;
}

static bool op_fp(struct rv_cpu *cpu, uint32_t word)
{
    switch (rv_funct7(word)) {
    case RV_FP_ADD:
    case RV_FP_SUB:
    case RV_FP_MUL:
    case RV_FP_DIV:
    case RV_FP_SQRT:
        return arithmetic(cpu, word);
    case RV_FP_SIGN:
        return sign(cpu, word);
    case RV_FP_MINMAX:
        return min_max(cpu, word);
    case RV_FP_COMPARE:
        return compare(cpu, word);
    case RV_FP_TO_INT:
        return to_int(cpu, word);
    case RV_FP_FROM_INT:
        return from_int(cpu, word);
    case RV_FP_TO_X:
        return to_x(cpu, word);
    case RV_FP_FROM_X:
        return from_x(cpu, word);
    default:
        return false;
    }
}

bool rv_float_slow(struct rv_cpu *cpu, uint32_t word)
{
    uint32_t flags = cpu->fflags;
    if (!(rv_opcode(word) == RV_OP_FP ? op_fp(cpu, word) : fused(cpu, word)))
        return false;
    if (cpu->fflags != flags)
        cpu->mstatus |= RV_MSTATUS_FS;
    return true;
}
