/* rv_random.c — random programs for the rig. */
#include "tests/support/rv_random.h"

/* Registers with a purpose; the others are anything. */
enum { CODE = 26, FIXED = CODE, DATA = 27, COPY = 28, DEVICE = 29, ONE = 30, SCRATCH = 31 };
enum { HANDLER = 0x800 };

struct source {
    uint64_t state;
};

static uint32_t any(struct source *s, uint32_t below)
{
    s->state = s->state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (uint32_t)((s->state >> 33) % below);
}

static unsigned in(struct source *s)
{
    return any(s, 32);
}

static unsigned out(struct source *s)
{
    return any(s, FIXED);
}

static uint32_t pick(struct source *s, const unsigned *list, size_t count)
{
    return list[any(s, (uint32_t)count)];
}
#define PICK(s, ...)                                                                               \
    pick(s, (const unsigned[]){__VA_ARGS__},                                                       \
         sizeof((const unsigned[]){__VA_ARGS__}) / sizeof(unsigned))

static uint32_t integer_word(struct source *s)
{
    unsigned funct3 = any(s, 8);
    switch (any(s, 4)) {
    case 0:
        return w_r(PICK(s, 0, 0, 1), funct3, 0x33, out(s), in(s), in(s));
    case 1:
        return w_r(0x20, PICK(s, 0, 5), 0x33, out(s), in(s), in(s));
    case 2:
        if (funct3 == 1 || funct3 == 5)
            return w_r(funct3 == 5 ? PICK(s, 0, 0x20) : 0, funct3, 0x13, out(s), in(s), in(s));
        return w_i(funct3, 0x13, out(s), in(s), (int32_t)any(s, 4096));
    default:
        return PICK(s, 0x37, 0x17) | out(s) << 7 | any(s, 1 << 20) << 12;
    }
}

static uint32_t memory_word(struct source *s)
{
    unsigned base = any(s, 6) != 0 ? DATA : any(s, 4) != 0 ? DEVICE : in(s);
    int32_t imm = base == DEVICE ? (int32_t)any(s, 64) : (int32_t)any(s, 256) - 128;
    if (any(s, 8) != 0)
        imm &= ~3;
    switch (any(s, 5)) {
    case 0:
    case 1:
        return w_i(PICK(s, 0, 1, 2, 2, 4, 5), 0x03, out(s), base, imm);
    case 2:
    case 3:
        return w_s(PICK(s, 0, 1, 2, 2), 0x23, in(s), base, imm);
    default:
        return any(s, 2) ? w_flw(in(s), DATA, imm) : w_fsw(in(s), DATA, imm);
    }
}

static uint32_t float_word(struct source *s)
{
    unsigned rm = PICK(s, 7, 7, 7, 7, 0, 0, 1, 2, 3, 4, 5);
    switch (any(s, 4)) {
    case 0:
        return w_r(in(s) << 2, rm, PICK(s, 0x43, 0x47, 0x4B, 0x4F), in(s), in(s), in(s));
    case 1:
        return w_fp(PICK(s, 0x00, 0x04, 0x08, 0x0C), rm, in(s), in(s), in(s));
    case 2:
        return w_fp(PICK(s, 0x10, 0x14), any(s, 2), in(s), in(s), in(s));
    default:
        switch (any(s, 5)) {
        case 0:
            return w_fp(0x50, any(s, 3), out(s), in(s), in(s));
        case 1:
            return w_fp(0x60, PICK(s, 1, 1, 7), out(s), in(s), any(s, 2));
        case 2:
            return w_fp(0x68, rm, in(s), in(s), any(s, 2));
        case 3:
            return w_fp(0x70, any(s, 2), out(s), in(s), 0);
        default:
            return any(s, 2) ? w_fp(0x2C, rm, in(s), in(s), 0) : w_fp(0x78, 0, in(s), in(s), 0);
        }
    }
}

static uint32_t system_word(struct source *s)
{
    switch (any(s, 12)) {
    case 0:
        return PICK(s, W_FENCE, W_FENCE_I, 0, 0xFFFFFFFF);
    case 10:
    case 11:
        return PICK(s, W_ECALL, W_EBREAK);
    case 1:
        return W_WFI;
    case 2:
        return w_csr(PICK(s, 1, 2, 3), out(s), PICK(s, FFLAGS, FCSR, MSCRATCH, 0x7C0), in(s));
    case 3:
        return w_csr(5, out(s), FRM, PICK(s, 0, 0, 0, 1, 4, 6));
    case 4:
        return w_csr(PICK(s, 6, 7), out(s), MSTATUS, 8); /* interrupts on, off */
    case 5:
        return w_csr(PICK(s, 2, 3), out(s), MSTATUS, in(s));
    case 6:
        return w_csr(5, out(s), PICK(s, MCOUNTINHIBIT, MCYCLE, MINSTRET, MIP), any(s, 32));
    default:
        return w_csrr(out(s), PICK(s, CYCLE, INSTRET, TIME, MCYCLEH, MCAUSE, MEPC, MIP, 0xF14));
    }
}

/* To a place within the code, and rarely to a half word of it. */
static uint32_t jump_word(struct source *s, uint32_t at)
{
    int32_t distance = (int32_t)any(s, 40) - 16;
    if ((int32_t)at + distance < 0 || at + (uint32_t)distance >= RANDOM_CODE || distance == 0)
        distance = 2;
    int32_t bytes = 4 * distance + (any(s, 40) == 0 ? 2 : 0);
    if (any(s, 5) == 0)
        return w_jal(PICK(s, ZERO, RA, T0), bytes);
    return w_b(PICK(s, 0, 1, 4, 5, 6, 7), in(s), in(s), bytes);
}

/* Through a register: far within the code, or out of memory. */
static uint32_t far_jump(struct source *s)
{
    int32_t imm = (int32_t)any(s, 4 * RANDOM_CODE);
    return w_jalr(PICK(s, ZERO, RA, T0), any(s, 20) == 0 ? in(s) : CODE,
                  any(s, 10) ? imm & ~3 : imm);
}

static uint32_t random_word(struct source *s, uint32_t at)
{
    uint32_t place = any(s, RANDOM_CODE);
    switch (any(s, 32)) {
    case 0:
        return w_lw(COPY, CODE, (int32_t)(4 * place));
    case 1:
        return any(s, 2) ? w_sw(COPY, CODE, (int32_t)(4 * place))
                         : w_sw(COPY, CODE, (int32_t)(4 * at + 4));
    case 2:
        return system_word(s);
    case 3:
        return far_jump(s);
    case 4:
    case 5:
    case 6:
    case 7:
        return jump_word(s, at);
    case 8:
    case 9:
    case 10:
    case 11:
    case 12:
        return memory_word(s);
    case 13:
    case 14:
    case 15:
    case 16:
    case 17:
    case 18:
    case 19:
    case 20:
        return float_word(s);
    case 21:
        return w_addi(out(s), ZERO, (int32_t)any(s, 4096));
    default:
        return integer_word(s);
    }
}

static void put_handler(struct rig *r)
{
    RIG_PUT(r, HANDLER, w_csrr(SCRATCH, MCAUSE), w_b(4, SCRATCH, ZERO, 36), /* an interrupt */
            w_beq(SCRATCH, ONE, 20),                                        /* no place to be */
            w_csrr(SCRATCH, MEPC), w_addi(SCRATCH, SCRATCH, 4), w_csrw(MEPC, SCRATCH), W_MRET,
            w_csrw(MEPC, CODE), W_MRET, W_NOP, /* from the start */
            w_sw(ZERO, DEVICE, 60), W_MRET);
}

void random_program(struct rig *r, uint32_t seed)
{
    struct source s = {seed * UINT64_C(0x9E3779B97F4A7C15) + 1};
    for (uint32_t i = 0; i < RANDOM_CODE; i++)
        RIG_PUT(r, 4 * i, random_word(&s, i));
    RIG_PUT(r, 4 * RANDOM_CODE, w_jalr(ZERO, CODE, 0));
    put_handler(r);
    for (uint32_t i = 0; i < 256; i++)
        RIG_PUT(r, 0x8000 - 512 + 4 * i, any(&s, UINT32_MAX));
    for (int i = 1; i < 32; i++) {
        r->cpu.x[i] = any(&s, 3) ? any(&s, UINT32_MAX) : any(&s, 64);
        r->cpu.f[i] = any(&s, 2) ? any(&s, UINT32_MAX) : 0x3F000000 + any(&s, 1 << 25);
    }
    r->cpu.x[CODE] = RIG_BASE;
    r->cpu.x[DATA] = RIG_BASE + 0x8000;
    r->cpu.x[DEVICE] = RIG_DEVICE;
    r->cpu.x[ONE] = 1;
    r->cpu.pc = RIG_BASE;
    r->raises = RV_INT_EXTERNAL;
    rv_csr_write(&r->cpu, MTVEC, RIG_BASE + HANDLER);
    rv_csr_write(&r->cpu, MIE, 1u << RV_INT_EXTERNAL | 1u << RV_INT_TIMER);
    rv_csr_write(&r->cpu, MSTATUS, 1 << 13 | 8);
}
