/* block.c — what stands around a body: registers loaded and stored, the system call, and the data. */
#include "tests/cpu/qemu/block.h"

#include <assert.h>
#include <string.h>

#include "tests/cpu/qemu/block_parts.h"

enum { FCSR = 3 }; /* the CSR */
enum { A0 = 10, A1 = 11, A2 = 12, A7 = 17 };

static void emit_immediate(struct maker *m, const char *name, unsigned rd, unsigned rs1, int imm)
{
    maker_emit(m, insn_named(name)->match | insn_rd(rd) | insn_rs1(rs1) | insn_imm_i(imm));
}

static void emit_store(struct maker *m, const char *name, unsigned rs2, unsigned rs1, int imm)
{
    maker_emit(m, insn_named(name)->match | insn_rs2(rs2) | insn_rs1(rs1) | insn_imm_s(imm));
}

/* Any 32-bit number: lui takes the upper part so that the lower can be added with its sign. */
static void emit_number(struct maker *m, unsigned rd, uint32_t number)
{
    uint32_t upper = (number + 0x800) & 0xfffff000;
    maker_emit(m, insn_named("lui")->match | insn_rd(rd) | upper);
    emit_immediate(m, "addi", rd, rd, (int)(number - upper));
}

static void load_registers(struct maker *m, uint32_t data_address)
{
    unsigned spare = m->base == 1 ? 2 : 1;

    emit_number(m, m->base, data_address + BLOCK_BASE);
    for (unsigned r = 0; r < 32; r++)
        emit_immediate(m, "flw", r, m->base, BLOCK_F + 4 * (int)r - BLOCK_BASE);
    emit_immediate(m, "lw", spare, m->base, BLOCK_FCSR - BLOCK_BASE);
    maker_emit(m, insn_named("csrrw")->match | insn_rs1(spare) | insn_imm_i(FCSR));
    for (unsigned r = 1; r < 32; r++) {
        if (r != m->base)
            emit_immediate(m, "lw", r, m->base, BLOCK_X + 4 * (int)r - BLOCK_BASE);
    }
}

static void store_registers(struct maker *m)
{
    unsigned spare = m->base == 1 ? 2 : 1;

    for (unsigned r = 0; r < 32; r++)
        emit_store(m, "sw", r, m->base, BLOCK_END_X + 4 * (int)r - BLOCK_BASE);
    for (unsigned r = 0; r < 32; r++)
        emit_store(m, "fsw", r, m->base, BLOCK_END_F + 4 * (int)r - BLOCK_BASE);
    maker_emit(m, insn_named("csrrs")->match | insn_rd(spare) | insn_imm_i(FCSR));
    emit_store(m, "sw", spare, m->base, BLOCK_END_FCSR - BLOCK_BASE);
}

/* All data to standard output; then the next block, or the end. */
static void hand_over(struct maker *m, const struct block_plan *plan)
{
    emit_immediate(m, "addi", A0, 0, 1);
    emit_number(m, A1, plan->data_address);
    emit_number(m, A2, BLOCK_DATA);
    emit_immediate(m, "addi", A7, 0, BLOCK_SYS_WRITE);
    maker_emit(m, insn_named("ecall")->match);
    if (plan->last) {
        emit_immediate(m, "addi", A0, 0, 0);
        emit_immediate(m, "addi", A7, 0, BLOCK_SYS_EXIT);
        maker_emit(m, insn_named("ecall")->match);
    } else {
        int offset = BLOCK_CODE - 4 * (int)m->b->words;
        maker_emit(m, insn_named("jal")->match | insn_imm_j(offset));
    }
}

/* Integers that arithmetic trips over, bits of floats, or anything. */
static uint32_t initial_x(struct maker *m)
{
    static const uint32_t edges[] = {0,          1,          2,          0xffffffff, 0xfffffffe,
                                     0x7fffffff, 0x80000000, 0x80000001, 31,         32,
                                     33,         0xffff,     0x10000,    0x8000,     0xffff8000,
                                     0x7fff,     0xff,       0x80,       0xffffff80, 0x01000001};

    switch (maker_pick(m, 4)) {
    case 0:
        return edges[maker_pick(m, sizeof edges / sizeof edges[0])];
    case 1:
        return maker_float(m);
    case 2:
        return maker_random(m) >> maker_pick(m, 32);
    default:
        return maker_random(m);
    }
}

/* A calm program has rounded something before, to nearest; others begin with whatever fcsr holds. */
static uint32_t initial_fcsr(struct maker *m)
{
    uint32_t fcsr = m->calm ? 1u : maker_random(m) & 0xff;

    m->frm_valid = fcsr >> 5 <= 4;
    return fcsr;
}

static void fill_data(struct maker *m)
{
    uint32_t *data = m->b->data;

    for (unsigned i = 0; i < BLOCK_DATA / 4; i++)
        data[i] = initial_x(m);
    for (unsigned r = 0; r < 32; r++)
        data[BLOCK_F / 4 + r] = maker_float(m);
    data[BLOCK_FCSR / 4] = initial_fcsr(m);
    /* What the block is to fill in must not be there by chance. */
    memset(&data[BLOCK_END_X / 4], 0xa5, BLOCK_SCRATCH - BLOCK_END_X);
}

void block_make(struct block *b, const struct block_plan *plan)
{
    struct maker m = {.b = b};

    m.random = plan->seed * UINT64_C(0x9e3779b97f4a7c15) + 1;
    m.base = 1 + plan->seed % 31;
    m.calm = maker_pick(&m, 4) != 0;
    m.mild = maker_pick(&m, 2) != 0;
    b->words = 0;
    fill_data(&m);
    load_registers(&m, plan->data_address);
    b->body_begin = b->words;
    block_body(&m, plan->items);
    b->body_end = b->words;
    store_registers(&m);
    hand_over(&m, plan);
    assert(b->words <= BLOCK_CODE / 4);
    while (b->words < BLOCK_CODE / 4)
        maker_emit(&m, 0); /* not an instruction */
}
