/* Every trap with its cause, value and place, in the fast loop and clock by clock; trap entry and
 * return; what happens when nobody can handle one. */
#include "tests/support/rv_rig.h"

#include "emu/cpu/rv_float.h"

static struct rig rig;
static struct rig *const r = &rig;

enum { AT = 0x400, HANDLER = 0x800, MIE_BIT = 1 << 3, MPIE_BIT = 1 << 7, MPP_BITS = 3 << 11 };

static int set_up(void **state)
{
    (void)state;
    rig_init(r);
    r->cpu.mtvec = RIG_BASE + HANDLER;
    RIG_PUT(r, HANDLER, W_WFI);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    rig_free(r);
    return 0;
}

/* The word at AT traps: before it two instructions retire, the handler's wfi is the last one. */
static void expect_trap(uint32_t word, uint32_t cause, uint32_t value)
{
    for (int slow = 0; slow < 2; slow++) {
        uint64_t cycle = r->cpu.cycle, retired = rv_retired(&r->cpu);
        r->cpu.state = RV_RUNNING;
        r->cpu.mcause = r->cpu.mtval = r->cpu.mepc = 0x5555;
        RIG_PUT(r, AT - 8, W_NOP, W_NOP, word);
        (slow ? rig_step : rig_run)(r, AT - 8, 1000);
        assert_int_equal(r->cpu.mcause, cause);
        assert_int_equal(r->cpu.mtval, value);
        assert_int_equal(r->cpu.mepc, RIG_BASE + AT);
        assert_int_equal(r->cpu.pc, RIG_BASE + HANDLER + 4);
        assert_int_equal(r->cpu.cycle, cycle + 4);
        assert_int_equal(rv_retired(&r->cpu), retired + 3);
    }
}

static void calls_and_breakpoints(void **state)
{
    (void)state;
    expect_trap(W_ECALL, 11, 0);
    expect_trap(W_EBREAK, 3, RIG_BASE + AT);
}

static void illegal_words(void **state)
{
    (void)state;
    const uint32_t words[] = {
        0,
        0xFFFFFFFF,
        0x00000001, /* a compressed instruction */
        w_r(2, 0, 0x33, 1, 1, 1),
        w_r(0x20, 1, 0x33, 1, 1, 1),
        w_r(0x20, 1, 0x13, 1, 1, 1),
        w_r(1, 1, 0x13, 1, 1, 1), /* slli by 32 */
        w_i(3, 0x03, 1, 0, 0),    /* ld */
        w_i(6, 0x03, 1, 0, 0),
        w_s(3, 0x23, 1, 0, 0),
        w_b(2, 1, 1, 8),
        w_b(3, 1, 1, 8),
        w_i(1, 0x67, 1, 0, 0), /* jalr has funct3 0 */
        w_i(2, 0x0F, 0, 0, 0),
        0x10200073, /* sret */
        0x00200073, /* uret */
        0x7B200073, /* dret */
        W_ECALL | 1 << 7,
        W_MRET | 1 << 15,
        w_csr(4, 1, MSCRATCH, 1), /* funct3 4 */
        w_csr(1, 1, 0x7C0, 1),    /* no such CSR */
        w_csrr(1, 0x180),         /* satp: no supervisor mode */
        w_csrr(1, 0x306),         /* mcounteren: no user mode */
        w_csr(1, 1, CYCLE, 1),    /* read-only */
        w_csr(2, 1, 0xF14, 1),
        w_csr(7, 1, INSTRET, 1),
        w_r(0x10, 2, 0x2F, 1, 1, 2), /* lr.w: no A */
    };
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        expect_trap(words[i], 2, words[i]);
}

static void jumps_to_half_words(void **state)
{
    (void)state;
    r->cpu.x[A1] = RIG_BASE + 0x103;
    r->cpu.x[RA] = 0x77;
    expect_trap(w_jal(RA, 6), 0, RIG_BASE + AT + 6);
    expect_trap(w_jal(ZERO, -2), 0, RIG_BASE + AT - 2);
    expect_trap(w_jalr(RA, A1, -1), 0, RIG_BASE + 0x102);
    expect_trap(w_jalr(ZERO, A1, 0), 0, RIG_BASE + 0x102);
    expect_trap(w_jalr(A1, A1, 0), 0, RIG_BASE + 0x102);
    expect_trap(w_beq(ZERO, ZERO, 10), 0, RIG_BASE + AT + 10);
    assert_int_equal(r->cpu.x[RA], 0x77);
    assert_int_equal(r->cpu.x[A1], RIG_BASE + 0x103);
}

/* Only when it is taken. */
static void branch_to_a_half_word(void **state)
{
    (void)state;
    for (int slow = 0; slow < 2; slow++) {
        RIG_PUT(r, AT, w_bne(ZERO, ZERO, 10), W_WFI);
        r->cpu.state = RV_RUNNING;
        (slow ? rig_step : rig_run)(r, AT, 1000);
        assert_int_equal(r->cpu.pc, RIG_BASE + AT + 8);
    }
}

/* The jump itself retires, with its link; what is at its target cannot be fetched. */
static void jumps_out_of_memory(void **state)
{
    (void)state;
    static const uint32_t targets[] = {0, 4, RIG_BASE - 4, RIG_BASE + RIG_SIZE, 0xFFFFFFFC};
    for (size_t i = 0; i < 2 * sizeof targets / sizeof targets[0]; i++) {
        uint64_t cycle = r->cpu.cycle, retired = rv_retired(&r->cpu);
        r->cpu.x[A1] = targets[i / 2];
        r->cpu.state = RV_RUNNING;
        RIG_PUT(r, AT, w_jalr(RA, A1, 0));
        (i % 2 ? rig_step : rig_run)(r, AT, 1000);
        assert_int_equal(r->cpu.mcause, 1);
        assert_int_equal(r->cpu.mepc, targets[i / 2]);
        assert_int_equal(r->cpu.mtval, targets[i / 2]);
        assert_int_equal(r->cpu.x[RA], RIG_BASE + AT + 4);
        assert_int_equal(r->cpu.cycle, cycle + 3); /* jump, trap, wfi */
        assert_int_equal(rv_retired(&r->cpu), retired + 2);
    }
}

static void runs_off_the_ends(void **state)
{
    (void)state;
    for (int i = 0; i < 4; i++) {
        uint32_t at = i < 2 ? RIG_SIZE - 8 : RIG_SIZE - 4;
        uint32_t word = i < 2 ? W_NOP : w_jal(ZERO, 4);
        r->cpu.state = RV_RUNNING;
        RIG_PUT(r, RIG_SIZE - 8, W_NOP, word);
        (i % 2 ? rig_step : rig_run)(r, at, 1000);
        assert_int_equal(r->cpu.mcause, 1);
        assert_int_equal(r->cpu.mepc, RIG_BASE + RIG_SIZE);
        /* A branch before the start. */
        r->cpu.state = RV_RUNNING;
        RIG_PUT(r, 0, w_beq(ZERO, ZERO, -64));
        (i % 2 ? rig_step : rig_run)(r, 0, 1000);
        assert_int_equal(r->cpu.mcause, 1);
        assert_int_equal(r->cpu.mepc, RIG_BASE - 64);
    }
}

static void floats_are_off(void **state)
{
    (void)state;
    const uint32_t words[] = {
        w_flw(1, A1, 0),          w_fsw(1, A1, 0),          w_fp(0, 7, 1, 2, 3),
        w_fp(8, 0, 1, 2, 3),      w_fp(0x10, 0, 1, 2, 3),   w_fp(0x14, 0, 1, 2, 3),
        w_fp(0x50, 2, 1, 2, 3),   w_fp(0x60, 1, 1, 2, 0),   w_fp(0x68, 7, 1, 2, 0),
        w_fp(0x70, 0, 1, 2, 0),   w_fp(0x70, 1, 1, 2, 0),   w_fp(0x78, 0, 1, 2, 0),
        w_r(0, 7, 0x43, 1, 2, 3), w_r(0, 7, 0x4F, 1, 2, 3), w_csrr(A0, FFLAGS),
        w_csrr(A0, FRM),          w_csrr(A0, FCSR),
    };
    r->cpu.x[A1] = RIG_BASE;
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        expect_trap(words[i], 2, words[i]);
    assert_int_equal(r->cpu.f[1], 0);
    assert_int_equal(rig_csr(r, MSTATUS), MPP_BITS);
}

static void float_words_that_do_not_exist(void **state)
{
    (void)state;
    rv_csr_write(&r->cpu, MSTATUS, 1 << 13);
    const uint32_t words[] = {
        w_fp(0, 5, 1, 2, 3),    w_fp(8, 6, 1, 2, 3),    w_fp(1, 0, 1, 2, 3) /* double */,
        w_fp(0x2C, 0, 1, 2, 1), w_fp(0x10, 3, 1, 2, 3), w_fp(0x14, 2, 1, 2, 3),
        w_fp(0x50, 3, 1, 2, 3), w_fp(0x60, 0, 1, 2, 2), w_fp(0x68, 0, 1, 2, 3),
        w_fp(0x70, 2, 1, 2, 0), w_fp(0x70, 0, 1, 2, 1), w_fp(0x78, 1, 1, 2, 0),
        w_fp(0x78, 0, 1, 2, 1), w_fp(0x20, 0, 1, 2, 1), w_r(1, 0, 0x43, 1, 2, 3),
        w_i(3, 0x07, 1, A1, 0), w_s(3, 0x27, 1, A1, 0), w_i(1, 0x07, 1, A1, 0),
    };
    r->cpu.x[A1] = RIG_BASE;
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        expect_trap(words[i], 2, words[i]);
    /* Dynamic, and frm names no mode. */
    for (uint32_t frm = 5; frm < 8; frm++) {
        rv_csr_write(&r->cpu, FRM, frm);
        expect_trap(w_fp(0, 7, 1, 2, 3), 2, w_fp(0, 7, 1, 2, 3));
        expect_trap(w_r(0, 7, 0x47, 1, 2, 3), 2, w_r(0, 7, 0x47, 1, 2, 3));
    }
    assert_int_equal(r->cpu.fflags, 0);
    assert_int_equal(r->cpu.f[1], 0);
}

/* mret: MIE from MPIE, MPIE set; a trap: MPIE from MIE, MIE clear. */
static void entry_and_return(void **state)
{
    (void)state;
    for (unsigned n = 0; n < 4; n++) {
        uint32_t mie = n & 1 ? MIE_BIT : 0, mpie = n & 2 ? MPIE_BIT : 0;
        r->cpu.state = RV_RUNNING;
        rv_csr_write(&r->cpu, MSTATUS, mie | mpie);
        RIG_PUT(r, AT, W_ECALL);
        rig_run(r, AT, 2);
        assert_int_equal(rig_csr(r, MSTATUS), MPP_BITS | (mie ? MPIE_BIT : 0));

        r->cpu.state = RV_RUNNING;
        rv_csr_write(&r->cpu, MSTATUS, mie | mpie);
        rv_csr_write(&r->cpu, MEPC, RIG_BASE + 0x903);
        RIG_PUT(r, AT, W_MRET);
        rig_run(r, AT, 1);
        assert_int_equal(rig_csr(r, MSTATUS), MPP_BITS | MPIE_BIT | (mpie ? MIE_BIT : 0));
        assert_int_equal(r->cpu.pc, RIG_BASE + 0x900);
    }
}

/* Vectors are for interrupts only. */
static void exceptions_are_not_vectored(void **state)
{
    (void)state;
    r->cpu.mtvec = (RIG_BASE + HANDLER) | 1;
    expect_trap(W_ECALL, 11, 0);
    expect_trap(W_EBREAK, 3, RIG_BASE + AT);
}

static void expect_halt(uint32_t cause, uint32_t pc, uint32_t value, uint64_t cycle)
{
    assert_int_equal(r->cpu.state, RV_HALTED);
    assert_int_equal(r->cpu.trouble.cause, cause);
    assert_int_equal(r->cpu.trouble.pc, pc);
    assert_int_equal(r->cpu.trouble.value, value);
    assert_int_equal(r->cpu.trouble.cycle, cycle);
    /* For ever. */
    struct rv_cpu before = r->cpu;
    rv_run(&r->cpu, r->cpu.cycle + 1000);
    rv_wait(&r->cpu, r->cpu.cycle + 1000);
    rv_set_interrupt(&r->cpu, RV_INT_TIMER, true);
    rv_set_interrupt(&r->cpu, RV_INT_TIMER, false);
    assert_int_equal(r->cpu.cycle, before.cycle);
    assert_int_equal(r->cpu.pc, before.pc);
    assert_int_equal(r->cpu.state, RV_HALTED);
}

static void nobody_handles(void **state)
{
    (void)state;
    static const uint32_t nowhere[] = {0, RIG_BASE - 4, RIG_BASE + RIG_SIZE, 0xFFFFFFFC};
    for (size_t i = 0; i < 8; i++) {
        rv_reset(&r->cpu);
        r->cpu.mtvec = nowhere[i / 2];
        uint64_t cycle = r->cpu.cycle, retired = rv_retired(&r->cpu);
        RIG_PUT(r, AT, W_NOP, W_EBREAK);
        (i % 2 ? rig_step : rig_run)(r, AT, 1000);
        expect_halt(3, RIG_BASE + AT + 4, RIG_BASE + AT + 4, cycle + 1);
        assert_int_equal(r->cpu.cycle, cycle + 2);
        assert_int_equal(rv_retired(&r->cpu), retired + 1);
        assert_int_equal(r->cpu.pc, RIG_BASE + AT + 4);
    }
    rv_reset(&r->cpu);
    assert_int_equal(r->cpu.state, RV_RUNNING);
    assert_int_equal(r->cpu.pc, RIG_BASE);
}

static void nobody_handles_an_interrupt(void **state)
{
    (void)state;
    /* Vectored: the base can be fetched from, the vector behind the end of memory cannot. */
    r->cpu.mtvec = (RIG_BASE + RIG_SIZE - 4) | 1;
    r->cpu.mie = 1u << RV_INT_TIMER;
    r->cpu.mstatus = MIE_BIT;
    rv_set_interrupt(&r->cpu, RV_INT_TIMER, true);
    uint64_t cycle = r->cpu.cycle;
    rig_run(r, AT, 100);
    expect_halt(0x80000007, RIG_BASE + AT, 0, cycle);
    assert_int_equal(r->cpu.cycle, cycle);
}

/* A handler that itself traps loops; it does not halt, and it counts. */
static void handler_traps(void **state)
{
    (void)state;
    RIG_PUT(r, HANDLER, W_EBREAK);
    uint64_t retired = rv_retired(&r->cpu);
    rig_run(r, HANDLER, 1000);
    assert_int_equal(r->cpu.state, RV_RUNNING);
    assert_int_equal(r->cpu.mepc, RIG_BASE + HANDLER);
    assert_int_equal(rv_retired(&r->cpu), retired);
}

static void names(void **state)
{
    (void)state;
    static const uint32_t causes[] = {0, 1, 2,  3,          4,          5,
                                      6, 7, 11, 0x80000003, 0x80000007, 0x8000000B};
    for (size_t i = 0; i < sizeof causes / sizeof causes[0]; i++)
        for (size_t k = 0; k < i; k++)
            assert_string_not_equal(rv_cause_name(causes[i]), rv_cause_name(causes[k]));
    assert_string_equal(rv_cause_name(5), "load access fault");
    assert_string_equal(rv_cause_name(24), rv_cause_name(0x80000001));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(calls_and_breakpoints, set_up, tear_down),
        cmocka_unit_test_setup_teardown(illegal_words, set_up, tear_down),
        cmocka_unit_test_setup_teardown(jumps_to_half_words, set_up, tear_down),
        cmocka_unit_test_setup_teardown(branch_to_a_half_word, set_up, tear_down),
        cmocka_unit_test_setup_teardown(jumps_out_of_memory, set_up, tear_down),
        cmocka_unit_test_setup_teardown(runs_off_the_ends, set_up, tear_down),
        cmocka_unit_test_setup_teardown(floats_are_off, set_up, tear_down),
        cmocka_unit_test_setup_teardown(float_words_that_do_not_exist, set_up, tear_down),
        cmocka_unit_test_setup_teardown(entry_and_return, set_up, tear_down),
        cmocka_unit_test_setup_teardown(exceptions_are_not_vectored, set_up, tear_down),
        cmocka_unit_test_setup_teardown(nobody_handles, set_up, tear_down),
        cmocka_unit_test_setup_teardown(nobody_handles_an_interrupt, set_up, tear_down),
        cmocka_unit_test_setup_teardown(handler_traps, set_up, tear_down),
        cmocka_unit_test(names),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
