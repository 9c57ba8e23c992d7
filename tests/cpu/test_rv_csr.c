/* Control and status registers: which there are, which bits they keep, counters, float control. */
#include "tests/support/rv_rig.h"

static struct rig rig;
static struct rig *const r = &rig;

enum { HANDLER = 0x800, FS = 3 << 13, FS_INITIAL = 1 << 13, FS_CLEAN = 2 << 13, MPP = 3 << 11 };
#define SD 0x80000000u

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

/* False: it trapped as illegal. */
static bool execute(uint32_t word)
{
    RIG_PUT(r, 0, word, W_WFI);
    r->cpu.state = RV_RUNNING;
    rig_run(r, 0, 1000);
    if (r->cpu.pc == RIG_BASE + 8)
        return true;
    assert_int_equal(r->cpu.mcause, RV_ILLEGAL);
    assert_int_equal(r->cpu.mtval, word);
    return false;
}

struct known {
    unsigned csr;
    uint32_t
        fixed; /* what reads when all ones or zeroes were written: the bits that are always so */
    uint32_t kept; /* the bits that a write changes */
};

/* With floats on. Counters move; they have tests of their own. */
static const struct known known[] = {
    {FFLAGS, 0, 31},        {FRM, 0, 7},
    {FCSR, 0, 255},         {MISA, 0x40001120, 0},
    {MIE, 0, 0x888},        {MTVEC, 0, 0xFFFFFFFD},
    {MCOUNTINHIBIT, 0, 5},  {MSCRATCH, 0, 0xFFFFFFFF},
    {MEPC, 0, 0xFFFFFFFC},  {MCAUSE, 0, 0xFFFFFFFF},
    {MTVAL, 0, 0xFFFFFFFF}, {MIP, 0, 0},
    {0x310, 0, 0},                         /* mstatush */
    {0x323, 0, 0},                         /* mhpmevent3 */
    {0x33F, 0, 0},          {0xB03, 0, 0}, /* mhpmcounter3 */
    {0xB1F, 0, 0},          {0xB83, 0, 0},
    {0xB9F, 0, 0},
};

static void bits_that_are_kept(void **state)
{
    (void)state;
    static const uint32_t written[] = {0xFFFFFFFF, 0, 0x55555555, 0xAAAAAAAA, 0x12345678};
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
        for (size_t k = 0; k < sizeof written / sizeof written[0]; k++) {
            rv_csr_write(&r->cpu, MSTATUS, FS_INITIAL);
            r->cpu.x[A0] = written[k];
            assert_true(execute(w_csrw(known[i].csr, A0)));
            assert_true(execute(w_csrr(A1, known[i].csr)));
            uint32_t want = known[i].fixed | (written[k] & known[i].kept);
            if (r->cpu.x[A1] != want)
                fail_msg("%03x after %08x: %08x, must be %08x", known[i].csr, written[k],
                         r->cpu.x[A1], want);
            rv_csr_write(&r->cpu, MCOUNTINHIBIT, 0);
            r->cpu.mtvec = RIG_BASE + HANDLER;
        }
}

/* All 4096 numbers: those named here exist, the others are illegal; 11 on top is read-only. */
static void which_there_are(void **state)
{
    (void)state;
    static const unsigned others[] = {MSTATUS, MCYCLE, MINSTRET, MCYCLEH, MINSTRETH, 0xC00,
                                      0xC01,   0xC02,  0xC80,    0xC81,   0xC82,     0xF11,
                                      0xF12,   0xF13,  0xF14,    0xF15};
    for (unsigned csr = 0; csr < 4096; csr++) {
        bool there = (csr >= 0x323 && csr <= 0x33F) || (csr >= 0xB03 && csr <= 0xB1F) ||
                     (csr >= 0xB83 && csr <= 0xB9F);
        for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
            there |= known[i].csr == csr;
        for (size_t i = 0; i < sizeof others / sizeof others[0]; i++)
            there |= others[i] == csr;
        bool writable = there && csr < 0xC00;
        rv_csr_write(&r->cpu, MSTATUS, FS_INITIAL);
        uint32_t value;
        assert_int_equal(rv_csr_read(&r->cpu, csr, &value), there);
        assert_int_equal(execute(w_csrr(A1, csr)), there);
        assert_int_equal(execute(w_csr(3, A1, csr, ZERO)), there);
        assert_int_equal(execute(w_csr(6, A1, csr, 0)), there);
        assert_int_equal(execute(w_csr(7, A1, csr, 0)), there);
        if (csr == MTVEC)
            continue;
        r->cpu.x[A0] = 0; /* a bit of no register is set: still a write */
        assert_int_equal(execute(w_csr(2, A1, csr, A0)), writable);
        assert_int_equal(execute(w_csr(3, A1, csr, A0)), writable);
        assert_int_equal(execute(w_csr(6, A1, csr, 1)), writable);
        assert_int_equal(execute(w_csr(7, A1, csr, 1)), writable);
        rv_csr_write(&r->cpu, MSTATUS, FS_INITIAL);
        assert_int_equal(execute(w_csr(1, ZERO, csr, ZERO)), writable);
        rv_csr_write(&r->cpu, MSTATUS, FS_INITIAL);
        assert_int_equal(execute(w_csr(5, ZERO, csr, 0)), writable);
    }
}

static void forms_of_access(void **state)
{
    (void)state;
    struct {
        unsigned funct3;
        uint32_t old, operand, want;
    } forms[] = {
        {1, 0xF0F0, 0x00FF, 0x00FF}, {2, 0xF0F0, 0x00FF, 0xF0FF}, {3, 0xF0F0, 0x00FF, 0xF000},
        {5, 0xF0F0, 21, 21},         {6, 0xF0F0, 21, 0xF0F5},     {7, 0xF0F0, 16, 0xF0E0},
    };
    for (size_t i = 0; i < sizeof forms / sizeof forms[0]; i++) {
        r->cpu.mscratch = forms[i].old;
        r->cpu.x[A1] = forms[i].operand;
        unsigned field = forms[i].funct3 > 4 ? forms[i].operand : A1;
        assert_true(execute(w_csr(forms[i].funct3, A0, MSCRATCH, field)));
        assert_int_equal(r->cpu.x[A0], forms[i].old);
        assert_int_equal(r->cpu.mscratch, forms[i].want);
    }
    /* Swapped with itself. */
    r->cpu.mscratch = 7;
    r->cpu.x[A1] = 9;
    assert_true(execute(w_csr(1, A1, MSCRATCH, A1)));
    assert_int_equal(r->cpu.mscratch, 9);
    assert_int_equal(r->cpu.x[A1], 7);
}

static void mstatus_follows_floats(void **state)
{
    (void)state;
    rv_csr_write(&r->cpu, MSTATUS, 0xFFFFFFFF);
    assert_int_equal(rig_csr(r, MSTATUS), SD | FS | MPP | 0x88);
    rv_csr_write(&r->cpu, MSTATUS, 0);
    assert_int_equal(rig_csr(r, MSTATUS), MPP);
    assert_false(execute(w_csrr(A0, FCSR)));
    static const uint32_t starts[] = {FS_INITIAL, FS_CLEAN};
    const uint32_t writers[] = {w_flw(1, A1, 0),          w_fp(0, 7, 1, 2, 3),
                                w_fp(0x10, 0, 1, 2, 3),   w_fp(0x14, 1, 1, 2, 3),
                                w_fp(0x68, 0, 1, 2, 0),   w_fp(0x78, 0, 1, 2, 0),
                                w_r(0, 7, 0x43, 1, 2, 3), w_csrw(FFLAGS, ZERO),
                                w_csrw(FRM, ZERO),        w_csrw(FCSR, ZERO)};
    const uint32_t readers[] = {w_fsw(1, A1, 0), w_fp(0x70, 0, A0, 2, 0), w_fp(0x70, 1, A0, 2, 0),
                                w_fp(0x50, 2, A0, 2, 3), w_csrr(A0, FCSR)};
    r->cpu.x[A1] = RIG_BASE + 0x1000;
    for (size_t s = 0; s < 2; s++) {
        for (size_t i = 0; i < sizeof writers / sizeof writers[0]; i++) {
            rv_csr_write(&r->cpu, MSTATUS, starts[s]);
            assert_true(execute(writers[i]));
            assert_int_equal(rig_csr(r, MSTATUS), SD | FS | MPP);
        }
        for (size_t i = 0; i < sizeof readers / sizeof readers[0]; i++) {
            rv_csr_write(&r->cpu, MSTATUS, starts[s]);
            assert_true(execute(readers[i]));
            assert_int_equal(rig_csr(r, MSTATUS), starts[s] | MPP);
        }
        /* A comparison that raises a flag has written. */
        rv_csr_write(&r->cpu, MSTATUS, starts[s]);
        r->cpu.fflags = 0;
        r->cpu.f[2] = 0x7F800001;
        assert_true(execute(w_fp(0x50, 1, A0, 2, 3)));
        assert_int_equal(rig_csr(r, MSTATUS), SD | FS | MPP);
        r->cpu.f[2] = 0;
    }
}

static void parts_of_fcsr(void **state)
{
    (void)state;
    rv_csr_write(&r->cpu, MSTATUS, FS_INITIAL);
    rv_csr_write(&r->cpu, FCSR, 0xFFFFFF35);
    assert_int_equal(rig_csr(r, FCSR), 0x35);
    assert_int_equal(rig_csr(r, FRM), 1);
    assert_int_equal(rig_csr(r, FFLAGS), 0x15);
    rv_csr_write(&r->cpu, FRM, 4);
    assert_int_equal(rig_csr(r, FCSR), 0x95);
    rv_csr_write(&r->cpu, FFLAGS, 2);
    assert_int_equal(rig_csr(r, FCSR), 0x82);
}

/* Writing the flags or the mode has its effect on the next instruction, in one straight run. */
static void rounding_changes_at_once(void **state)
{
    (void)state;
    rv_csr_write(&r->cpu, MSTATUS, FS);
    r->cpu.f[2] = 0x3F800000; /* 1 + 2^-24: a tie */
    r->cpu.f[3] = 0x33800000;
    r->cpu.x[A0] = 3;
    RIG_PUT(r, 0, w_fp(0, 7, 4, 2, 3), w_fp(0, 7, 5, 2, 3), w_csrw(FRM, A0), w_fp(0, 7, 6, 2, 3),
            w_csrw(FRM, ZERO), w_fp(0, 7, 7, 2, 3), w_csr(5, A1, FFLAGS, 0), w_csrr(A2, FFLAGS),
            w_fp(0, 7, 8, 2, 3), w_csrr(A3, FFLAGS), W_WFI);
    rig_run(r, 0, 1000);
    assert_int_equal(r->cpu.f[4], 0x3F800000);
    assert_int_equal(r->cpu.f[5], 0x3F800000);
    assert_int_equal(r->cpu.f[6], 0x3F800001);
    assert_int_equal(r->cpu.f[7], 0x3F800000);
    assert_int_equal(r->cpu.x[A1], 1);
    assert_int_equal(r->cpu.x[A2], 0);
    assert_int_equal(r->cpu.f[8], 0x3F800000);
    assert_int_equal(r->cpu.x[A3], 1);
}

/* Counters count instructions before this one; what is written is read by the next instruction. */
static void counters(void **state)
{
    (void)state;
    static const unsigned pairs[2][3] = {{MCYCLE, MCYCLEH, CYCLE}, {MINSTRET, MINSTRETH, INSTRET}};
    for (size_t i = 0; i < 2; i++) {
        const unsigned *c = pairs[i];
        r->cpu.state = RV_RUNNING;
        r->cpu.x[A0] = 0xFFFFFFFE;
        r->cpu.x[A1] = 41;
        RIG_PUT(r, 0, w_csrr(S0, c[2]), W_NOP, w_csrr(S1, c[2]), /* + 2 */
                w_csrw(c[1], A1), w_csrw(c[0], A0), w_csrr(A2, c[0]), w_csrr(A3, c[2]),
                w_csrr(A4, c[2] + 0x80), w_csrr(A5, c[0]), w_csrr(A6, c[1]), W_WFI);
        rig_run(r, 0, 1000);
        assert_int_equal(r->cpu.x[S1] - r->cpu.x[S0], 2);
        assert_int_equal(r->cpu.x[A2], 0xFFFFFFFE);
        assert_int_equal(r->cpu.x[A3], 0xFFFFFFFF);
        assert_int_equal(r->cpu.x[A4], 42);
        assert_int_equal(r->cpu.x[A5], 1);
        assert_int_equal(r->cpu.x[A6], 42);
    }
}

/* A trap takes a clock, but retires nothing; wfi retires, and clocks pass in it. */
static void clocks_without_instructions(void **state)
{
    (void)state;
    RIG_PUT(r, HANDLER, w_csrr(A0, CYCLE), w_csrr(A1, INSTRET), W_WFI, w_csrr(A2, CYCLE),
            w_csrr(A3, INSTRET), W_WFI);
    RIG_PUT(r, 0, W_NOP, W_ECALL);
    rig_run(r, 0, 1000);
    assert_int_equal(r->cpu.state, RV_WAITING);
    assert_int_equal(r->cpu.x[A0], 2);
    assert_int_equal(r->cpu.x[A1], 2);
    assert_int_equal(r->cpu.cycle, 5);
    rv_wait(&r->cpu, 105);
    assert_int_equal(r->cpu.cycle, 105);
    assert_int_equal(rv_retired(&r->cpu), 4);
    r->cpu.mie = 1u << RV_INT_TIMER;
    rv_set_interrupt(&r->cpu, RV_INT_TIMER, true);
    rv_set_interrupt(&r->cpu, RV_INT_TIMER, false);
    rig_run(r, HANDLER + 12, 1000);
    assert_int_equal(r->cpu.x[A2], 105);
    assert_int_equal(r->cpu.x[A3], 5);
}

static void inhibited_counters(void **state)
{
    (void)state;
    RIG_PUT(r, 0, W_NOP, w_csr(5, ZERO, MCOUNTINHIBIT, 1), w_csrr(A0, MCYCLE), w_csrr(A1, MCYCLE),
            w_csrr(A2, MINSTRET), w_csr(5, ZERO, MCOUNTINHIBIT, 4), w_csrr(A3, MCYCLE),
            w_csrr(A4, MINSTRET), w_csrr(A5, MINSTRET), w_csr(5, ZERO, MINSTRET, 9),
            w_csrr(A6, MINSTRET), w_csr(5, ZERO, MCOUNTINHIBIT, 0), w_csrr(A7, MINSTRET), W_WFI);
    rig_run(r, 0, 1000);
    assert_int_equal(r->cpu.x[A0], 2); /* the inhibiting write itself counted */
    assert_int_equal(r->cpu.x[A1], 2);
    assert_int_equal(r->cpu.x[A2], 4);
    assert_int_equal(r->cpu.x[A3], 2);
    assert_int_equal(r->cpu.x[A4], 6);
    assert_int_equal(r->cpu.x[A5], 6);
    assert_int_equal(r->cpu.x[A6], 9);
    assert_int_equal(r->cpu.x[A7], 9);
    assert_int_equal(rv_retired(&r->cpu), 14);
}

static uint64_t clock_of_machine(void *ctx)
{
    return UINT64_C(0x1234567800000000) + ((const struct rig *)ctx)->cpu.cycle * 3;
}

static void time_is_the_machines(void **state)
{
    (void)state;
    RIG_PUT(r, 0, W_NOP, W_NOP, w_csrr(A0, TIME), w_csrr(A1, TIME + 0x80), W_WFI);
    rig_run(r, 0, 1000);
    assert_int_equal(r->cpu.x[A0], 2); /* without one: the cycle */
    r->cpu.desc.bus.time = clock_of_machine;
    uint64_t cycle = r->cpu.cycle;
    r->cpu.state = RV_RUNNING;
    rig_run(r, 0, 1000);
    assert_int_equal(r->cpu.x[A0], (cycle + 2) * 3);
    assert_int_equal(r->cpu.x[A1], 0x12345678);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(bits_that_are_kept, set_up, tear_down),
        cmocka_unit_test_setup_teardown(which_there_are, set_up, tear_down),
        cmocka_unit_test_setup_teardown(forms_of_access, set_up, tear_down),
        cmocka_unit_test_setup_teardown(mstatus_follows_floats, set_up, tear_down),
        cmocka_unit_test_setup_teardown(parts_of_fcsr, set_up, tear_down),
        cmocka_unit_test_setup_teardown(rounding_changes_at_once, set_up, tear_down),
        cmocka_unit_test_setup_teardown(counters, set_up, tear_down),
        cmocka_unit_test_setup_teardown(clocks_without_instructions, set_up, tear_down),
        cmocka_unit_test_setup_teardown(inhibited_counters, set_up, tear_down),
        cmocka_unit_test_setup_teardown(time_is_the_machines, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
