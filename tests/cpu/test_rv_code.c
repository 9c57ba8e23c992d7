/* The cache of decoded words cannot be seen: code that is changed, by itself or from outside, is what
 * executes next, within pairs that share a handler too; and stores are looked at where they must be. */
#include "tests/support/rv_rig.h"

#include "emu/cpu/rv_decode.h"

static struct rig rig;
static struct rig *const r = &rig;

enum { HANDLER = 0x800, DATA = 0x8000 };

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

/* Registers that programs of this file need. */
static void set_registers(void)
{
    r->cpu.state = RV_RUNNING;
    r->cpu.x[A0] = 0;
    r->cpu.x[S0] = RIG_BASE;
    r->cpu.x[S1] = RIG_BASE + DATA;
    for (unsigned i = A1; i <= A7; i++)
        r->cpu.x[i] = 0x100 + i;
}

/* The store at word 1 replaces word `n` (of 2 … 9), which has been executed before, by an addition of
 * 64: whatever stands around them. */
static void next_words_change(void **state)
{
    (void)state;
    for (uint32_t n = 2; n < 10; n++)
        for (int slow = 0; slow < 2; slow++) {
            RIG_PUT(r, 0, W_NOP, W_NOP, w_addi(A0, A0, 1), w_addi(A0, A0, 1), w_slli(A1, A1, 1),
                    w_add(A2, A2, A1), w_addi(A0, A0, 1), w_addi(A0, A0, 1), w_sw(A1, S1, 0),
                    w_addi(A0, A0, 1), W_WFI);
            set_registers();
            rig_run(r, 0, 1000);
            assert_int_equal(r->cpu.x[A0], 5);
            set_registers();
            RIG_PUT(r, 4, w_sw(A3, S0, (int32_t)(4 * n)));
            r->cpu.x[A3] = w_addi(A0, A0, 64);
            (slow ? rig_step : rig_run)(r, 0, 1000);
            bool replaced_addition = n != 4 && n != 5 && n != 8;
            assert_int_equal(r->cpu.x[A0], 64 + 5 - (replaced_addition ? 1 : 0));
            assert_int_equal(rig_word(r, 4 * n), w_addi(A0, A0, 64));
        }
}

/* Every pair with a handler of its own: executed together, then the second word alone is replaced,
 * then the first one, by a store of the program or from outside. Jumping to the second word executes
 * it alone. */
static void pairs_come_apart(void **state)
{
    (void)state;
    const uint32_t firsts[] = {w_addi(A1, A2, 3),   w_add(A1, A2, A3),    w_slli(A1, A2, 4),
                               w_lui(A1, 0x5000),   w_bne(ZERO, ZERO, 8), w_lw(A1, S1, 0),
                               w_sw(A2, S1, 4),     w_flw(1, S1, 0),      w_fsw(1, S1, 8),
                               w_fp(0, 7, 1, 2, 3), w_fp(8, 7, 1, 2, 3)};
    const uint32_t seconds[] = {w_addi(A4, A1, 5), w_add(A4, A1, A3),  w_lui(A4, 0x7000),
                                w_lw(A4, S1, 0),   w_sw(A1, S1, 12),   w_bne(A1, A1, 8),
                                w_flw(2, S1, 0),   w_fp(8, 7, 4, 1, 1)};
    enum { AT = 0x100 };
    for (size_t i = 0; i < sizeof firsts / sizeof firsts[0]; i++)
        for (size_t k = 0; k < sizeof seconds / sizeof seconds[0]; k++)
            for (uint32_t which = 0; which < 4; which++) {
                rv_csr_write(&r->cpu, MSTATUS, 3 << 13);
                RIG_PUT(r, AT, firsts[i], seconds[k], W_WFI);
                RIG_PUT(r, 0, w_sw(A5, S0, (int32_t)(AT + 4 * (which & 1))), w_jal(ZERO, AT - 4));
                set_registers();
                rig_run(r, AT, 1000);
                set_registers();
                r->cpu.x[A5] = w_addi(A0, ZERO, 77);
                if (which & 2) {
                    RIG_PUT(r, AT + 4 * (which & 1), w_addi(A0, ZERO, 77));
                    rig_run(r, AT, 1000);
                } else {
                    rig_run(r, 0, 1000);
                }
                assert_int_equal(r->cpu.x[A0], 77);
                assert_int_equal(r->cpu.pc, RIG_BASE + AT + 12);
                set_registers();
                RIG_PUT(r, AT + 4, w_addi(A0, A0, 1));
                rig_run(r, AT + 4, 1000);
                assert_int_equal(r->cpu.x[A0], 1);
            }
}

/* Bytes and halves of words count, too. */
static void parts_of_words_change(void **state)
{
    (void)state;
    RIG_PUT(r, 0, w_sb(A1, S0, 0x103), w_s(1, 0x23, A2, S0, 0x106), w_jal(ZERO, 0xF8));
    RIG_PUT(r, 0x100, w_addi(A0, A0, 1), w_addi(A0, A0, 1), W_WFI);
    set_registers();
    rig_run(r, 0x100, 100);
    set_registers();
    r->cpu.x[A1] = w_addi(A0, A0, 0x120) >> 24;
    r->cpu.x[A2] = w_addi(A0, A0, 0x230) >> 16;
    rig_run(r, 0, 100);
    uint32_t first = w_addi(A0, A0, 0x120), second = w_addi(A0, A0, 0x230);
    assert_int_equal(rig_word(r, 0x100) >> 24, first >> 24);
    int32_t a = (int32_t)rig_word(r, 0x100) >> 20, b = (int32_t)second >> 20;
    assert_int_equal(r->cpu.x[A0], a + b);
}

/* A loop that writes the next copy of itself and goes there, through all of memory. */
static void walking_program(void **state)
{
    (void)state;
    /* Copies eight words 32 bytes on, one by one, and falls into the copy. */
    const uint32_t walk[] = {
        w_lw(T0, S0, 0),      w_sw(T0, S0, 32),    w_addi(S0, S0, 4), w_addi(A1, A1, -1),
        w_bne(A1, ZERO, -16), w_addi(A1, ZERO, 8), w_addi(A0, A0, 1), W_NOP};
    rig_put(r, 0x1000, walk, 8);
    set_registers();
    r->cpu.x[A1] = 8;
    r->cpu.x[S0] = RIG_BASE + 0x1000;
    rig_run(r, 0x1000, 1000000);
    /* Every copy took 43 instructions; the last one runs into the end of memory. */
    uint32_t copies = (RIG_SIZE - 0x1000) / 32 - 1;
    assert_int_equal(r->cpu.x[A0], copies);
    assert_int_equal(r->cpu.mcause, RV_STORE_FAULT);
    assert_int_equal(r->cpu.mtval, RIG_BASE + RIG_SIZE);
}

/* The program changes the word it executes in a loop, each time round. */
static void patched_loop(void **state)
{
    (void)state;
    for (int together = 0; together < 2; together++) {
        /* 2: addi A0, A0, n; n grows by one each time round */
        RIG_PUT(r, 0, w_sw(T0, S0, 8), w_add(T0, T0, T1), w_addi(A0, A0, 0), w_addi(A1, A1, -1),
                w_bne(A1, ZERO, -16), W_WFI);
        set_registers();
        r->cpu.x[T0] = w_addi(A0, A0, 1);
        r->cpu.x[T1] = 1u << 20;
        r->cpu.x[A1] = 1000;
        (together ? rig_run : rig_step)(r, 0, 10000);
        assert_int_equal(r->cpu.x[A0], 1000 * 1001 / 2);
        assert_int_equal(r->cpu.cycle % 5001, 0);
    }
}

/* rv_changed for ranges of any size, also far too large ones, and inside words. */
static void changed_from_outside(void **state)
{
    (void)state;
    static const uint32_t ranges[][2] = {
        {RIG_BASE + 0x1000, RIG_BASE + 0x1004},
        {RIG_BASE + 0x1003, RIG_BASE + 0x1004},
        {0, 0xFFFFFFFF},
        {RIG_BASE, RIG_BASE + RIG_SIZE},
        {RIG_BASE - 4096, RIG_BASE + 0x1001},
    };
    for (size_t i = 0; i < sizeof ranges / sizeof ranges[0]; i++) {
        RIG_PUT(r, 0xFFC, W_NOP, w_addi(A0, A0, 1), W_WFI);
        set_registers();
        rig_run(r, 0xFFC, 100);
        uint32_t word = w_addi(A0, A0, 100);
        for (unsigned b = 0; b < 4; b++)
            r->memory[0x1000 + b] = (uint8_t)(word >> 8 * b);
        rv_changed(&r->cpu, ranges[i][0], ranges[i][1]);
        set_registers();
        rig_run(r, 0xFFC, 100);
        assert_int_equal(r->cpu.x[A0], 100);
    }
    /* Part of a page: the rest of it is code as before, and stores to that are seen. */
    RIG_PUT(r, 0xC100, w_addi(A0, A0, 1), W_WFI);
    set_registers();
    rig_run(r, 0xC100, 100);
    rv_changed(&r->cpu, RIG_BASE + 0xC000, RIG_BASE + 0xC080);
    RIG_PUT(r, 0, w_lui(A1, RIG_BASE + 0xC000), w_sw(A2, A1, 0x100), w_jalr(ZERO, A1, 0x100));
    set_registers();
    r->cpu.x[A2] = w_addi(A0, A0, 50);
    rig_run(r, 0, 100);
    assert_int_equal(r->cpu.x[A0], 50);

    rv_changed(&r->cpu, 0, RIG_BASE);
    rv_changed(&r->cpu, RIG_BASE + RIG_SIZE, 0xFFFFFFFF);
    rv_changed(&r->cpu, RIG_BASE + 8, RIG_BASE + 8);
}

/* Whatever was executed and protected: a store changes memory, or traps, never both or neither. The
 * window must not hold a decoded page or a read-only byte. */
static void stores_with_any_window(void **state)
{
    uint32_t seed = 1;
    for (int round = 0; round < 1000; round++) {
        rig_free(r);
        set_up(state);
        uint32_t low[3], high[3];
        for (int i = 0; i < 3; i++) {
            seed = seed * 1664525u + 1013904223u;
            low[i] = seed >> 16;
            high[i] = low[i] + (seed >> 8 & 0x1FFF);
            assert_true(rv_protect(&r->cpu, RIG_BASE + low[i], RIG_BASE + high[i]));
        }
        for (int n = 0; n < 12; n++) {
            seed = seed * 1664525u + 1013904223u;
            uint32_t at = seed >> 16, code = (seed >> 4 & 0xFFC) | (at & 0xF000);
            at = at < 0x900 ? 0x900 : at;
            bool rom = false;
            for (int i = 0; i < 3; i++)
                rom |= at >= low[i] && at < high[i];
            if (code < 0x900 || code >= RIG_SIZE - 8)
                code = 0x400;
            RIG_PUT(r, code, w_sb(A0, A1, 0), W_WFI);
            uint8_t old = r->memory[at];
            set_registers();
            r->cpu.x[A0] = (uint8_t)~old;
            r->cpu.x[A1] = RIG_BASE + at;
            rig_run(r, code, 100);
            assert_int_equal(r->memory[at], rom ? old : (uint8_t)~old);
            if (at < code || at >= code + 8)
                assert_int_equal(r->cpu.pc, RIG_BASE + (rom ? HANDLER + 4 : code + 8));
            assert_true(r->cpu.store_low + r->cpu.store_size <= RIG_SIZE);
            for (uint32_t page = 0; page < RIG_SIZE / 4096; page++)
                if (r->cpu.decoded[page])
                    assert_true(r->cpu.store_low >= (page + 1) * 4096 ||
                                r->cpu.store_low + r->cpu.store_size <= page * 4096);
        }
    }
}

/* Data away from code needs no second look. */
static void window_is_the_largest_stretch(void **state)
{
    (void)state;
    assert_int_equal(r->cpu.store_size, RIG_SIZE);
    rv_protect(&r->cpu, RIG_BASE, RIG_BASE + 0x2345);
    assert_int_equal(r->cpu.store_low, 0x2348);
    assert_int_equal(r->cpu.store_size, RIG_SIZE - 0x2348);
    RIG_PUT(r, 0xC000, W_WFI);
    rig_run(r, 0xC000, 10);
    assert_int_equal(r->cpu.store_low, 0x2348);
    assert_int_equal(r->cpu.store_size, 0xC000 - 0x2348);
    /* What was loaded anew is no code yet. */
    rv_changed(&r->cpu, RIG_BASE + 0xC004, RIG_BASE + RIG_SIZE);
    assert_int_equal(r->cpu.store_size, 0xC000 - 0x2348);
    rv_changed(&r->cpu, RIG_BASE + 0xC000, RIG_BASE + RIG_SIZE);
    assert_int_equal(r->cpu.store_size, RIG_SIZE - 0x2348);
}

/* The window ends where a read-only range begins within a word: that word is not in it. */
static void window_ends_at_a_whole_word(void **state)
{
    (void)state;
    rv_protect(&r->cpu, RIG_BASE + 0xF002, RIG_BASE + RIG_SIZE);
    assert_int_equal(r->cpu.store_low + r->cpu.store_size, 0xF000);
    RIG_PUT(r, 0, w_sw(S0, A1, 0), W_WFI);
    set_registers();
    r->cpu.x[A1] = RIG_BASE + 0xF000;
    rig_run(r, 0, 100);
    assert_int_equal(r->cpu.mcause, RV_STORE_FAULT);
    assert_int_equal(rig_word(r, 0xF000), 0);
}

/* All of what can be known of a load or store before it is done. */
static void access_of_a_word(void **state)
{
    (void)state;
    struct rv_access a;
    r->cpu.x[A1] = 0x1000;
    assert_true(rv_access_of(&r->cpu, w_lw(A0, A1, -4), &a));
    assert_int_equal(a.address, 0xFFC);
    assert_int_equal(a.width, 4);
    assert_false(a.store);
    assert_true(rv_access_of(&r->cpu, w_s(1, 0x23, A0, A1, 2047), &a));
    assert_int_equal(a.address, 0x17FF);
    assert_int_equal(a.width, 2);
    assert_true(a.store);
    assert_true(rv_access_of(&r->cpu, w_i(4, 0x03, A0, A1, 1), &a));
    assert_int_equal(a.width, 1);
    assert_false(rv_access_of(&r->cpu, w_flw(0, A1, 0), &a)); /* floats are off */
    rv_csr_write(&r->cpu, MSTATUS, 1 << 13);
    assert_true(rv_access_of(&r->cpu, w_fsw(0, A1, 0), &a));
    const uint32_t none[] = {w_i(3, 0x03, A0, A1, 0), w_s(3, 0x23, A0, A1, 0), W_NOP, W_ECALL,
                             w_i(6, 0x03, A0, A1, 0), w_i(3, 0x07, A0, A1, 0), 0};
    for (size_t i = 0; i < sizeof none / sizeof none[0]; i++)
        assert_false(rv_access_of(&r->cpu, none[i], &a));
    uint32_t word;
    assert_true(rv_fetch(&r->cpu, RIG_BASE + HANDLER, &word));
    assert_int_equal(word, W_WFI);
    assert_false(rv_fetch(&r->cpu, RIG_BASE + 2, &word));
    assert_false(rv_fetch(&r->cpu, RIG_BASE + RIG_SIZE, &word));
    assert_false(rv_fetch(&r->cpu, RIG_BASE - 4, &word));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(next_words_change, set_up, tear_down),
        cmocka_unit_test_setup_teardown(pairs_come_apart, set_up, tear_down),
        cmocka_unit_test_setup_teardown(parts_of_words_change, set_up, tear_down),
        cmocka_unit_test_setup_teardown(walking_program, set_up, tear_down),
        cmocka_unit_test_setup_teardown(patched_loop, set_up, tear_down),
        cmocka_unit_test_setup_teardown(changed_from_outside, set_up, tear_down),
        cmocka_unit_test_setup_teardown(stores_with_any_window, set_up, tear_down),
        cmocka_unit_test_setup_teardown(window_is_the_largest_stretch, set_up, tear_down),
        cmocka_unit_test_setup_teardown(window_ends_at_a_whole_word, set_up, tear_down),
        cmocka_unit_test_setup_teardown(access_of_a_word, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
