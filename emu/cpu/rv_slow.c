/* rv_slow.c — instructions that a loop leaves to somebody else: whatever may trap, reach the bus,
 * change how the processor goes on, or is rare. They work from the word, not from the entry. */
#include "emu/cpu/rv_parts.h"
#include "emu/cpu/rv_word.h"

static void set_x(struct rv_cpu *cpu, unsigned rd, uint32_t value)
{
    cpu->x[rd == 0 ? 32 : rd] = value;
}

/* The instruction at pc is done and the next one follows. */
static bool retire(struct rv_cpu *cpu)
{
    cpu->pc += 4;
    cpu->cycle++;
    return !cpu->attention;
}

static bool trap(struct rv_cpu *cpu, uint32_t cause, uint32_t value)
{
    rv_trap(cpu, cause, value);
    return false;
}

static bool illegal(struct rv_cpu *cpu, uint32_t word)
{
    return trap(cpu, RV_ILLEGAL, word);
}

/* ---- loads and stores ---- */

bool rv_access_of(const struct rv_cpu *cpu, uint32_t word, struct rv_access *access)
{
    unsigned opcode = rv_opcode(word), funct3 = rv_funct3(word);
    access->store = opcode == RV_STORE || opcode == RV_STORE_FP;
    access->width = 1u << (funct3 & 3);
    access->address = cpu->x[rv_rs1(word)] + (access->store ? rv_imm_s(word) : rv_imm_i(word));
    switch (opcode) {
    case RV_LOAD:
        return funct3 <= 2 || funct3 == 4 || funct3 == 5;
    case RV_STORE:
        return funct3 <= 2;
    case RV_LOAD_FP:
    case RV_STORE_FP:
        return funct3 == 2 && rv_float_on(cpu);
    default:
        return false;
    }
}

static uint32_t extend(unsigned funct3, uint32_t value)
{
    switch (funct3) {
    case 0:
        return (uint32_t)(int8_t)value;
    case 1:
        return (uint32_t)(int16_t)value;
    default:
        return value;
    }
}

static bool load(struct rv_cpu *cpu, uint32_t word)
{
    enum rv_float_mode mode = rv_float_mode(cpu);
    struct rv_access access;
    uint32_t value;
    if (!rv_access_of(cpu, word, &access))
        return illegal(cpu, word);
    if (access.address & (access.width - 1))
        return trap(cpu, RV_LOAD_MISALIGNED, access.address);
    if (!rv_load(cpu, access.address, access.width, &value))
        return trap(cpu, RV_LOAD_FAULT, access.address);
    if (rv_opcode(word) == RV_LOAD) {
        set_x(cpu, rv_rd(word), extend(rv_funct3(word), value));
    } else {
        cpu->f[rv_rd(word)] = value;
        cpu->mstatus |= RV_MSTATUS_FS;
    }
    return retire(cpu) && rv_float_mode(cpu) == mode;
}

static bool store(struct rv_cpu *cpu, uint32_t word)
{
    struct rv_access access;
    if (!rv_access_of(cpu, word, &access))
        return illegal(cpu, word);
    if (access.address & (access.width - 1))
        return trap(cpu, RV_STORE_MISALIGNED, access.address);
    unsigned rs2 = rv_rs2(word);
    uint32_t value = rv_opcode(word) == RV_STORE ? cpu->x[rs2] : cpu->f[rs2];
    if (!rv_store(cpu, access.address, access.width, value))
        return trap(cpu, RV_STORE_FAULT, access.address);
    return retire(cpu);
}

/* ---- jumps whose target is no place to go to, or was not known to be one ---- */

static bool jump(struct rv_cpu *cpu, uint32_t target, unsigned link)
{
    if (target & 3)
        return trap(cpu, RV_FETCH_MISALIGNED, target);
    set_x(cpu, link, cpu->pc + 4);
    cpu->pc = target;
    cpu->cycle++;
    return false;
}

static bool branch(struct rv_cpu *cpu, uint32_t word)
{
    uint32_t a = cpu->x[rv_rs1(word)], b = cpu->x[rv_rs2(word)];
    bool taken;
    switch (rv_funct3(word) >> 1) {
    case 0:
        taken = a == b;
        break;
    case 2:
        taken = (int32_t)a < (int32_t)b;
        break;
    case 3:
        taken = a < b;
        break;
    default:
        return illegal(cpu, word);
    }
    if (taken == (rv_funct3(word) & 1)) /* the odd ones are the opposites */
        return retire(cpu);
    return jump(cpu, cpu->pc + rv_imm_b(word), 0);
}

static bool jalr(struct rv_cpu *cpu, uint32_t word)
{
    if (rv_funct3(word) != 0)
        return illegal(cpu, word);
    return jump(cpu, (cpu->x[rv_rs1(word)] + rv_imm_i(word)) & ~1u, rv_rd(word));
}

/* ---- SYSTEM ---- */

static bool csr_access(struct rv_cpu *cpu, uint32_t word)
{
    unsigned csr = word >> 20, funct3 = rv_funct3(word), field = rv_rs1(word);
    uint32_t operand = funct3 & 4 ? field : cpu->x[field], old;
    bool writes = (funct3 & 3) == 1 || field != 0;
    if (!rv_csr_read(cpu, csr, &old) || (writes && rv_csr_read_only(csr)))
        return illegal(cpu, word);
    enum rv_float_mode mode = rv_float_mode(cpu);
    uint32_t mstatus = cpu->mstatus, mie = cpu->mie;
    bool goes_on = retire(cpu); /* a write happens after the instruction has counted */
    if (writes) {
        uint32_t value = (funct3 & 3) == 1   ? operand
                         : (funct3 & 3) == 2 ? old | operand
                                             : old & ~operand;
        rv_csr_write(cpu, csr, value);
    }
    set_x(cpu, rv_rd(word), old);
    return goes_on && cpu->mstatus == mstatus && cpu->mie == mie && rv_float_mode(cpu) == mode;
}

static bool privileged(struct rv_cpu *cpu, uint32_t word)
{
    switch (word) {
    case 0x00000073:
        return trap(cpu, RV_ECALL_M, 0);
    case 0x00100073:
        return trap(cpu, RV_BREAKPOINT, cpu->pc);
    case 0x30200073:
        rv_mret(cpu);
        cpu->cycle++;
        return false;
    case 0x10500073: /* wfi */
        retire(cpu);
        cpu->state = RV_WAITING;
        rv_wake(cpu);
        return false;
    default:
        return illegal(cpu, word);
    }
}

static bool system_op(struct rv_cpu *cpu, uint32_t word)
{
    unsigned funct3 = rv_funct3(word);
    if (funct3 == 0)
        return privileged(cpu, word);
    return funct3 == 4 ? illegal(cpu, word) : csr_access(cpu, word);
}

static bool float_op(struct rv_cpu *cpu, uint32_t word)
{
    enum rv_float_mode mode = rv_float_mode(cpu);
    if (!rv_float_on(cpu) || !rv_float_slow(cpu, word))
        return illegal(cpu, word);
    return retire(cpu) && rv_float_mode(cpu) == mode;
}

bool rv_slow(struct rv_cpu *cpu)
{
    uint32_t word = rv_bytes_get(cpu->desc.memory + (cpu->pc - cpu->desc.memory_base), 4);
    switch (rv_opcode(word)) {
    case RV_LOAD:
    case RV_LOAD_FP:
        return load(cpu, word);
    case RV_STORE:
    case RV_STORE_FP:
        return store(cpu, word);
    case RV_BRANCH:
        return branch(cpu, word);
    case RV_JAL:
        return jump(cpu, cpu->pc + rv_imm_j(word), rv_rd(word));
    case RV_JALR:
        return jalr(cpu, word);
    case RV_SYSTEM:
        return system_op(cpu, word);
    case RV_MADD:
    case RV_MSUB:
    case RV_NMSUB:
    case RV_NMADD:
    case RV_OP_FP:
        return float_op(cpu, word);
    default:
        return illegal(cpu, word);
    }
}
