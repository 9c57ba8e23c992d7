/* Interrupts: when they are taken, in which order and where to; WFI; what bus accesses may ask for. */
#include "tests/support/rv_rig.h"

static struct rig rig;
static struct rig *const r = &rig;

enum {
    HANDLER = 0x800,
    MIE_BIT = 1 << 3,
    MPIE_BIT = 1 << 7,
    MPP_BITS = 3 << 11,
    SOFTWARE = 1 << RV_INT_SOFTWARE,
    TIMER = 1 << RV_INT_TIMER,
    EXTERNAL = 1 << RV_INT_EXTERNAL,
};
static const int lines[] = {RV_INT_SOFTWARE, RV_INT_TIMER, RV_INT_EXTERNAL};

static int set_up(void **state)
{
    (void)state;
    rig_init(r);
    r->cpu.mtvec = RIG_BASE + HANDLER;
    for (uint32_t i = 0; i < 16; i++)
        RIG_PUT(r, HANDLER + 4 * i, W_WFI);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    rig_free(r);
    return 0;
}

static void set_lines(uint32_t pending)
{
    for (int i = 0; i < 3; i++)
        rv_set_interrupt(&r->cpu, lines[i], (pending >> lines[i] & 1) != 0);
}

/* All lines, all enables, globally on or off, direct or vectored: the first of external, software,
 * timer that is pending and enabled, before the instruction at pc, which does not execute. */
static void order_and_place(void **state)
{
    (void)state;
    for (unsigned n = 0; n < 256; n++) {
        uint32_t pending = 0, enabled = 0, on = n & 64 ? MIE_BIT : 0, vectored = n >> 7;
        for (int i = 0; i < 3; i++) {
            pending |= (n >> i & 1) << lines[i];
            enabled |= (n >> (3 + i) & 1) << lines[i];
        }
        r->cpu.state = RV_RUNNING;
        r->cpu.mtvec = (RIG_BASE + HANDLER) | vectored;
        r->cpu.mie = enabled;
        r->cpu.mcause = 0;
        r->cpu.x[A0] = 0;
        rv_csr_write(&r->cpu, MSTATUS, on);
        set_lines(pending);
        assert_int_equal(rig_csr(r, MIP), pending);
        RIG_PUT(r, 0, w_addi(A0, A0, 1), W_NOP);
        uint64_t cycle = r->cpu.cycle;
        rig_step(r, 0, 1);
        uint32_t ready = pending & enabled;
        uint32_t number = ready & EXTERNAL ? 11 : ready & SOFTWARE ? 3 : 7;
        assert_int_equal(r->cpu.cycle, cycle + 1); /* taking it costs nothing */
        if (on && ready) {
            assert_int_equal(r->cpu.mcause, 0x80000000u | number);
            assert_int_equal(r->cpu.mepc, RIG_BASE);
            assert_int_equal(r->cpu.mtval, 0);
            assert_int_equal(r->cpu.pc, RIG_BASE + HANDLER + (vectored ? 4 * number : 0) + 4);
            assert_int_equal(rig_csr(r, MSTATUS), MPP_BITS | MPIE_BIT);
            assert_int_equal(r->cpu.x[A0], 0);
        } else {
            assert_int_equal(r->cpu.mcause, 0);
            assert_int_equal(r->cpu.x[A0], 1);
        }
    }
}

/* Not before there is an instruction to execute. */
static void not_at_the_end_of_a_run(void **state)
{
    (void)state;
    RIG_PUT(r, 0, W_NOP, W_NOP);
    r->cpu.mie = TIMER;
    r->cpu.mstatus = MIE_BIT;
    rig_run(r, 0, 1);
    set_lines(TIMER);
    rv_run(&r->cpu, r->cpu.cycle);
    assert_int_equal(r->cpu.pc, RIG_BASE + 4);
    rv_run(&r->cpu, r->cpu.cycle + 1);
    assert_int_equal(r->cpu.mepc, RIG_BASE + 4);
}

/* Each way to make a pending interrupt takeable works on the very next instruction. */
static void taken_once_enabled(void **state)
{
    (void)state;
    const uint32_t words[] = {w_csr(6, ZERO, MSTATUS, MIE_BIT), w_csr(1, ZERO, MIE, A1), W_MRET,
                              w_csr(2, ZERO, MSTATUS, A2)};
    RIG_PUT(r, HANDLER, w_jal(ZERO, 0));
    for (size_t i = 0; i < 2 * 4; i++) {
        uint32_t word = words[i / 2];
        r->cpu.state = RV_RUNNING;
        r->cpu.mie = i / 2 == 1 ? 0 : TIMER;
        rv_csr_write(&r->cpu, MSTATUS, i / 2 == 1 ? MIE_BIT : MPIE_BIT);
        r->cpu.mepc = RIG_BASE + 8;
        r->cpu.x[A0] = 0;
        r->cpu.x[A1] = TIMER;
        r->cpu.x[A2] = MIE_BIT;
        set_lines(TIMER);
        RIG_PUT(r, 0, W_NOP, word, w_addi(A0, A0, 1), w_addi(A0, A0, 1));
        (i % 2 ? rig_step : rig_run)(r, 0, 70);
        assert_int_equal(r->cpu.mcause, 0x80000007);
        assert_int_equal(r->cpu.mepc, RIG_BASE + 8);
        assert_int_equal(r->cpu.x[A0], 0);
        set_lines(0);
    }
}

static void wfi_waits(void **state)
{
    (void)state;
    RIG_PUT(r, 0, W_NOP, W_WFI, w_addi(A0, A0, 1), W_WFI);
    r->cpu.mie = TIMER;
    rig_run(r, 0, 1000);
    assert_int_equal(r->cpu.state, RV_WAITING);
    assert_int_equal(r->cpu.pc, RIG_BASE + 8);
    assert_int_equal(r->cpu.cycle, 2);
    rv_run(&r->cpu, 500); /* does nothing */
    assert_int_equal(r->cpu.cycle, 2);
    rv_wait(&r->cpu, 100);
    rv_wait(&r->cpu, 50); /* never back */
    assert_int_equal(r->cpu.cycle, 100);
    assert_int_equal(r->cpu.idle, 98);
    /* Not by a line that is not enabled. */
    set_lines(EXTERNAL | SOFTWARE);
    assert_int_equal(r->cpu.state, RV_WAITING);
    set_lines(TIMER);
    assert_int_equal(r->cpu.state, RV_RUNNING);
    rv_wait(&r->cpu, 200); /* not while running */
    assert_int_equal(r->cpu.cycle, 100);
    /* Interrupts are off: it goes on behind wfi. The next wfi does not wait, the line being high. */
    RIG_PUT(r, 16, w_jal(ZERO, 0));
    rv_run(&r->cpu, 103);
    assert_int_equal(r->cpu.x[A0], 1);
    assert_int_equal(r->cpu.state, RV_RUNNING);
    assert_int_equal(r->cpu.pc, RIG_BASE + 16);
    assert_int_equal(r->cpu.mcause, 0);
}

static void wfi_returns_behind_itself(void **state)
{
    (void)state;
    RIG_PUT(r, 0, W_WFI, w_addi(A0, A0, 1), w_jal(ZERO, 0));
    RIG_PUT(r, HANDLER, w_csr(1, ZERO, MIE, ZERO), W_MRET);
    r->cpu.mie = TIMER;
    r->cpu.mstatus = MIE_BIT;
    rig_run(r, 0, 100);
    set_lines(TIMER);
    rv_run(&r->cpu, r->cpu.cycle + 20);
    assert_int_equal(r->cpu.mepc, RIG_BASE + 4);
    assert_int_equal(r->cpu.x[A0], 1);
}

/* A debugger that enables the interrupt wakes it as well. */
static void wfi_ends_when_enabled(void **state)
{
    (void)state;
    RIG_PUT(r, 0, W_WFI);
    rig_run(r, 0, 100);
    set_lines(SOFTWARE);
    assert_int_equal(r->cpu.state, RV_WAITING);
    rv_csr_write(&r->cpu, MIE, SOFTWARE);
    assert_int_equal(r->cpu.state, RV_RUNNING);
}

/* An access raises the line: the next instruction is the handler's first, and rv_run has returned
 * between them, whatever stood around it. */
static void raised_by_an_access(void **state)
{
    (void)state;
    uint32_t words[140];
    for (size_t i = 0; i < 140; i++)
        words[i] = w_addi(A0, A0, 1);
    for (uint32_t at = 0; at < 139; at++) {
        rig_put(r, 0x1000, words, 140);
        RIG_PUT(r, 0x1000 + 4 * at, at % 2 ? w_sw(A0, A1, 0) : w_lw(ZERO, A1, 0));
        r->cpu.x[A0] = 0;
        r->cpu.x[A1] = RIG_DEVICE;
        r->cpu.mie = EXTERNAL;
        r->cpu.mstatus = MIE_BIT;
        r->cpu.state = RV_RUNNING;
        r->cpu.pc = RIG_BASE + 0x1000;
        set_lines(0);
        r->raises = RV_INT_EXTERNAL;
        uint64_t cycle = r->cpu.cycle;
        rv_run(&r->cpu, cycle + (at % 3 ? 1000 : at + 5));
        assert_int_equal(r->cpu.cycle, cycle + at + 1);
        assert_int_equal(r->cpu.pc, RIG_BASE + 0x1000 + 4 * (at + 1));
        assert_int_equal(r->cpu.x[A0], at);
        rv_run(&r->cpu, r->cpu.cycle + 1);
        assert_int_equal(r->cpu.mepc, RIG_BASE + 0x1000 + 4 * (at + 1));
        assert_int_equal(r->cpu.pc, RIG_BASE + HANDLER + 4);
    }
}

static void attention_returns(void **state)
{
    (void)state;
    RIG_PUT(r, 0, w_addi(A0, A0, 1), w_lw(A2, A1, 0), w_addi(A0, A0, 1), w_sw(A2, A1, 0),
            w_addi(A0, A0, 1), w_flw(0, A1, 0), w_fsw(0, A1, 0), w_addi(A0, A0, 1), W_WFI);
    r->cpu.x[A1] = RIG_DEVICE;
    r->attention = true;
    rv_csr_write(&r->cpu, MSTATUS, 1 << 13);
    rv_attention(&r->cpu); /* from before: forgotten */
    static const uint32_t returns[] = {8, 16, 24, 28, 36};
    for (size_t i = 0; i < 5; i++) {
        rv_run(&r->cpu, 1000);
        assert_int_equal(r->cpu.pc, RIG_BASE + returns[i]);
    }
    assert_int_equal(r->cpu.x[A0], 4);
    assert_int_equal(r->cpu.cycle, 9);
}

struct seen {
    unsigned before, after, trapped, interrupts;
    uint32_t cause, pc, word, stop_at;
};

static bool before(void *ctx, struct rv_cpu *cpu)
{
    struct seen *s = ctx;
    s->before++;
    return cpu->pc == s->stop_at;
}

static void after(void *ctx, struct rv_cpu *cpu, uint32_t pc, uint32_t word, bool trapped)
{
    struct seen *s = ctx;
    (void)cpu;
    s->after++;
    s->trapped += trapped;
    s->pc = pc;
    s->word = word;
}

static void interrupt(void *ctx, struct rv_cpu *cpu, uint32_t cause)
{
    struct seen *s = ctx;
    (void)cpu;
    s->interrupts++;
    s->cause = cause;
}

static void watched(void **state)
{
    (void)state;
    struct seen s = {.stop_at = RIG_BASE + 12};
    struct rv_hooks hooks = {&s, before, after, interrupt}, none = {0};
    RIG_PUT(r, 0, W_NOP, W_ECALL, w_addi(A0, A0, 1), w_addi(A0, A0, 2), W_WFI);
    RIG_PUT(r, HANDLER, w_csrr(A5, MEPC), w_addi(A5, A5, 4), w_csrw(MEPC, A5), W_MRET);
    assert_true(rv_watch(&r->cpu, 1000, &hooks));
    assert_int_equal(r->cpu.pc, RIG_BASE + 12);
    assert_int_equal(r->cpu.x[A0], 1);
    assert_int_equal(s.before, 8);
    assert_int_equal(s.after, 7);
    assert_int_equal(s.trapped, 1);
    assert_int_equal(s.pc, RIG_BASE + 8);
    assert_int_equal(s.word, w_addi(A0, A0, 1));
    assert_int_equal(s.interrupts, 0);
    assert_true(rv_watch(&r->cpu, 1000, &hooks)); /* still there */
    assert_int_equal(r->cpu.cycle, 7);

    r->cpu.mie = TIMER;
    r->cpu.mstatus = MIE_BIT;
    set_lines(TIMER);
    s.stop_at = RIG_BASE + HANDLER;
    assert_true(rv_watch(&r->cpu, 1000, &hooks)); /* the interrupt first, then `before` */
    assert_int_equal(s.interrupts, 1);
    assert_int_equal(s.cause, 0x80000007);
    assert_int_equal(r->cpu.pc, RIG_BASE + HANDLER);
    assert_int_equal(r->cpu.cycle, 7);
    assert_false(rv_watch(&r->cpu, 9, &none));
    assert_int_equal(r->cpu.cycle, 9);
}

/* What cannot be fetched is watched, too: word 0, trapped. */
static void watched_out_of_memory(void **state)
{
    (void)state;
    struct seen s = {.stop_at = 1};
    struct rv_hooks hooks = {&s, before, after, interrupt};
    r->cpu.pc = 0x1234;
    assert_false(rv_watch(&r->cpu, 1, &hooks));
    assert_int_equal(s.before, 1);
    assert_int_equal(s.trapped, 1);
    assert_int_equal(s.pc, 0x1234);
    assert_int_equal(s.word, 0);
    assert_int_equal(r->cpu.mcause, RV_FETCH_FAULT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(order_and_place, set_up, tear_down),
        cmocka_unit_test_setup_teardown(not_at_the_end_of_a_run, set_up, tear_down),
        cmocka_unit_test_setup_teardown(taken_once_enabled, set_up, tear_down),
        cmocka_unit_test_setup_teardown(wfi_waits, set_up, tear_down),
        cmocka_unit_test_setup_teardown(wfi_returns_behind_itself, set_up, tear_down),
        cmocka_unit_test_setup_teardown(wfi_ends_when_enabled, set_up, tear_down),
        cmocka_unit_test_setup_teardown(raised_by_an_access, set_up, tear_down),
        cmocka_unit_test_setup_teardown(attention_returns, set_up, tear_down),
        cmocka_unit_test_setup_teardown(watched, set_up, tear_down),
        cmocka_unit_test_setup_teardown(watched_out_of_memory, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
