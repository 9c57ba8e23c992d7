/* rv_rig.c — a processor with memory and a bus that remembers, for tests. */
#include "tests/support/rv_rig.h"

static bool access_device(struct rig *r, uint32_t address, unsigned width, bool store)
{
    if (address - RIG_DEVICE >= 4 * RIG_PORTS)
        return false;
    r->address = address;
    r->width = width;
    r->was_store = store;
    r->cycle = r->cpu.cycle;
    r->accesses++;
    if (r->raises >= 0)
        rv_set_interrupt(&r->cpu, r->raises, address != RIG_DROPS);
    if (r->attention)
        rv_attention(&r->cpu);
    return true;
}

static bool load(void *ctx, uint32_t address, unsigned width, uint32_t *value)
{
    struct rig *r = ctx;
    if (!access_device(r, address, width, false))
        return false;
    *value = r->ports[(address - RIG_DEVICE) / 4] >> 8 * (address & 3);
    if (width < 4)
        *value &= (1u << 8 * width) - 1;
    return true;
}

static bool store(void *ctx, uint32_t address, unsigned width, uint32_t value)
{
    struct rig *r = ctx;
    if (!access_device(r, address, width, true))
        return false;
    r->ports[(address - RIG_DEVICE) / 4] = value;
    return true;
}

void rig_init(struct rig *r)
{
    *r = (struct rig){.raises = -1};
    struct rv_desc desc = {.memory = r->memory,
                           .memory_base = RIG_BASE,
                           .memory_size = RIG_SIZE,
                           .bus = {r, load, store, NULL}};
    assert_true(rv_init(&r->cpu, &desc));
}

void rig_free(struct rig *r)
{
    rv_free(&r->cpu);
}

void rig_put(struct rig *r, uint32_t offset, const uint32_t *words, size_t count)
{
    for (size_t i = 0; i < 4 * count; i++)
        r->memory[offset + i] = (uint8_t)(words[i / 4] >> 8 * (i % 4));
    rv_changed(&r->cpu, RIG_BASE + offset, RIG_BASE + offset + 4 * (uint32_t)count);
}

uint32_t rig_word(const struct rig *r, uint32_t offset)
{
    const uint8_t *at = r->memory + offset;
    return at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

uint32_t rig_csr(struct rig *r, unsigned csr)
{
    uint32_t value = 0;
    assert_true(rv_csr_read(&r->cpu, csr, &value));
    return value;
}

void rig_run(struct rig *r, uint32_t offset, uint64_t clocks)
{
    uint64_t until = r->cpu.cycle + clocks;
    r->cpu.pc = RIG_BASE + offset;
    while (r->cpu.state == RV_RUNNING && r->cpu.cycle < until)
        rv_run(&r->cpu, until);
}

void rig_step(struct rig *r, uint32_t offset, uint64_t clocks)
{
    uint64_t until = r->cpu.cycle + clocks;
    r->cpu.pc = RIG_BASE + offset;
    while (r->cpu.state == RV_RUNNING && r->cpu.cycle < until)
        rv_run(&r->cpu, r->cpu.cycle + 1);
}

void rig_expect_same(const struct rig *a, const struct rig *b)
{
    const struct rv_cpu *p = &a->cpu, *q = &b->cpu;
    assert_memory_equal(p->x, q->x, 32 * sizeof p->x[0]);
    assert_memory_equal(p->f, q->f, sizeof p->f);
    assert_int_equal(p->pc, q->pc);
    assert_int_equal(p->fflags, q->fflags);
    assert_int_equal(p->frm, q->frm);
    assert_int_equal(p->mstatus, q->mstatus);
    assert_int_equal(p->mie, q->mie);
    assert_int_equal(p->mip, q->mip);
    assert_int_equal(p->mtvec, q->mtvec);
    assert_int_equal(p->mscratch, q->mscratch);
    assert_int_equal(p->mepc, q->mepc);
    assert_int_equal(p->mcause, q->mcause);
    assert_int_equal(p->mtval, q->mtval);
    assert_int_equal(p->mcountinhibit, q->mcountinhibit);
    assert_int_equal(p->cycle, q->cycle);
    assert_int_equal(p->idle, q->idle);
    assert_int_equal(p->cycle_offset, q->cycle_offset);
    assert_int_equal(p->retire_offset, q->retire_offset);
    assert_int_equal(p->state, q->state);
    assert_int_equal(p->trouble.cause, q->trouble.cause);
    assert_int_equal(p->trouble.pc, q->trouble.pc);
    assert_int_equal(p->trouble.value, q->trouble.value);
    assert_int_equal(p->trouble.cycle, q->trouble.cycle);
    assert_memory_equal(a->memory, b->memory, RIG_SIZE);
    assert_memory_equal(a->ports, b->ports, sizeof a->ports);
    assert_int_equal(a->accesses, b->accesses);
}
