/* Loads and stores: widths, signs, alignment, the bus, the ends of memory, read-only ranges. */
#include "tests/support/rv_rig.h"

static struct rig rig;
static struct rig *const r = &rig;

enum { HANDLER = 0x800 };

struct width {
    const char *name;
    unsigned funct3, bytes;
    bool is_signed;
};

static const struct width loads[] = {
    {"lb", 0, 1, true},   {"lh", 1, 2, true},   {"lw", 2, 4, false},
    {"lbu", 4, 1, false}, {"lhu", 5, 2, false},
};
#define LOADS (sizeof loads / sizeof loads[0])

static int set_up(void **state)
{
    (void)state;
    rig_init(r);
    r->cpu.mtvec = RIG_BASE + HANDLER;
    RIG_PUT(r, HANDLER, W_WFI);
    rv_csr_write(&r->cpu, MSTATUS, 1 << 13);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    rig_free(r);
    return 0;
}

/* The word, then wfi. True: it retired; else it trapped, and mcause says why. */
static bool execute(uint32_t word, bool clock_by_clock)
{
    RIG_PUT(r, 0, word, W_WFI);
    r->cpu.state = RV_RUNNING;
    (clock_by_clock ? rig_step : rig_run)(r, 0, 1000);
    assert_int_equal(r->cpu.state, RV_WAITING);
    return r->cpu.pc == RIG_BASE + 8;
}

static void expect_trap(uint32_t word, uint32_t cause, uint32_t value)
{
    for (int slow = 0; slow < 2; slow++) {
        assert_false(execute(word, slow));
        assert_int_equal(r->cpu.pc, RIG_BASE + HANDLER + 4);
        assert_int_equal(r->cpu.mcause, cause);
        assert_int_equal(r->cpu.mtval, value);
        assert_int_equal(r->cpu.mepc, RIG_BASE);
    }
}

/* As bytes of a little-endian number. */
static uint32_t expected(const uint8_t *at, const struct width *w)
{
    int64_t value = 0;
    for (unsigned i = w->bytes; i-- > 0;)
        value = value * 256 + at[i];
    if (w->is_signed && at[w->bytes - 1] > 127)
        value -= INT64_C(1) << 8 * w->bytes;
    return (uint32_t)value;
}

static void loads_extend(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 64; i++)
        r->memory[0x1000 + i] = (uint8_t)(i * 37 + 0x71);
    for (size_t i = 0; i < 2 * LOADS * 64; i++) {
        const struct width *w = &loads[i / 2 % LOADS];
        uint32_t place = (uint32_t)(i / 2 / LOADS);
        if (place % w->bytes != 0)
            continue;
        int32_t imm = (int32_t)(place * 61 % 4096) - 2048;
        r->cpu.x[A1] = RIG_BASE + 0x1000 + place - (uint32_t)imm;
        assert_true(execute(w_i(w->funct3, 0x03, A0, A1, imm), i % 2 == 1));
        if (r->cpu.x[A0] != expected(r->memory + 0x1000 + place, w))
            fail_msg("%s at %u: %08x", w->name, place, r->cpu.x[A0]);
    }
    assert_int_equal(r->accesses, 0);
}

static void stores_touch_nothing_else(void **state)
{
    (void)state;
    for (unsigned funct3 = 0; funct3 < 3; funct3++) {
        unsigned bytes = 1u << funct3;
        for (uint32_t place = 0; place < 16; place += bytes) {
            uint8_t want[24];
            memset(r->memory + 0x2000, 0x5A, sizeof want);
            memset(want, 0x5A, sizeof want);
            for (unsigned i = 0; i < bytes; i++)
                want[4 + place + i] = (uint8_t)(0xC0DE1234u >> 8 * i);
            r->cpu.x[A0] = 0xC0DE1234;
            r->cpu.x[A1] = RIG_BASE + 0x2000;
            assert_true(execute(w_s(funct3, 0x23, A0, A1, (int32_t)place + 4), place & 4));
            assert_memory_equal(r->memory + 0x2000, want, sizeof want);
        }
    }
}

static void float_registers_keep_bits(void **state)
{
    (void)state;
    const uint32_t patterns[] = {0x7F800001, 0xFFC12345, 0x80000000, 1, 0x7F800000, 0x3F800000};
    for (size_t i = 0; i < 2 * sizeof patterns / sizeof patterns[0]; i++) {
        RIG_PUT(r, 0x1000, patterns[i / 2]);
        r->cpu.x[A1] = RIG_BASE + 0x1000;
        assert_true(execute(w_flw(3, A1, 0), i % 2));
        assert_int_equal(r->cpu.f[3], patterns[i / 2]);
        assert_true(execute(w_fsw(3, A1, 16), i % 2));
        assert_int_equal(rig_word(r, 0x1010), patterns[i / 2]);
    }
    assert_int_equal(r->cpu.fflags, 0);
}

static void misaligned(void **state)
{
    (void)state;
    for (uint32_t place = 1; place < 4; place++) {
        const uint32_t bases[] = {RIG_BASE + 0x1000, RIG_DEVICE, 0x20000000};
        for (size_t i = 0; i < 3; i++) {
            uint32_t address = bases[i] + place;
            r->cpu.x[A1] = address + 5;
            for (size_t k = 0; k < LOADS; k++)
                if (place % loads[k].bytes != 0)
                    expect_trap(w_i(loads[k].funct3, 0x03, A0, A1, -5), RV_LOAD_MISALIGNED,
                                address);
            if (place % 2 != 0)
                expect_trap(w_s(1, 0x23, A0, A1, -5), RV_STORE_MISALIGNED, address);
            expect_trap(w_s(2, 0x23, A0, A1, -5), RV_STORE_MISALIGNED, address);
            expect_trap(w_flw(0, A1, -5), RV_LOAD_MISALIGNED, address);
            expect_trap(w_fsw(0, A1, -5), RV_STORE_MISALIGNED, address);
        }
    }
    assert_int_equal(r->accesses, 0);
}

static void nobody_there(void **state)
{
    (void)state;
    const uint32_t addresses[] = {0,          RIG_BASE - 4,   RIG_BASE + RIG_SIZE,
                                  0xFFFFFFFC, RIG_DEVICE - 4, RIG_DEVICE + 4 * RIG_PORTS};
    r->cpu.x[A0] = 0xAAAA5555;
    for (size_t i = 0; i < sizeof addresses / sizeof addresses[0]; i++) {
        r->cpu.x[A1] = addresses[i] - 2047;
        for (size_t k = 0; k < LOADS; k++)
            expect_trap(w_i(loads[k].funct3, 0x03, A0, A1, 2047), RV_LOAD_FAULT, addresses[i]);
        for (unsigned funct3 = 0; funct3 < 3; funct3++)
            expect_trap(w_s(funct3, 0x23, A0, A1, 2047), RV_STORE_FAULT, addresses[i]);
    }
    assert_int_equal(r->cpu.x[A0], 0xAAAA5555);
    assert_int_equal(r->accesses, 0);
}

static void ends_of_memory(void **state)
{
    (void)state;
    r->cpu.x[A0] = 0x11223344;
    r->cpu.x[A1] = RIG_BASE + RIG_SIZE - 4;
    assert_true(execute(w_sw(A0, A1, 0), false));
    assert_true(execute(w_lw(A2, A1, 0), false));
    assert_int_equal(r->cpu.x[A2], 0x11223344);
    assert_true(execute(w_i(4, 0x03, A2, A1, 3), false));
    assert_int_equal(r->cpu.x[A2], 0x11);
    r->cpu.x[A1] = RIG_BASE;
    assert_true(execute(w_lw(A2, A1, 0), false));
    assert_int_equal(r->cpu.x[A2], w_lw(A2, A1, 0));
}

static void device_sees_accesses(void **state)
{
    (void)state;
    static const uint32_t stored[] = {0x98, 0xBA98, 0xFEDCBA98};
    r->ports[3] = 0x8091A2B3;
    r->cpu.x[A1] = RIG_DEVICE;
    for (size_t i = 0; i < 2 * LOADS; i++) {
        const struct width *w = &loads[i / 2];
        uint32_t place = 16 - w->bytes;
        uint64_t cycle = r->cpu.cycle;
        assert_true(execute(w_i(w->funct3, 0x03, A0, A1, (int32_t)place), i % 2));
        const uint8_t bytes[] = {0xB3, 0xA2, 0x91, 0x80};
        assert_int_equal(r->cpu.x[A0], expected(bytes + (place - 12), w));
        assert_int_equal(r->address, RIG_DEVICE + place);
        assert_int_equal(r->width, w->bytes);
        assert_false(r->was_store);
        assert_int_equal(r->cycle, cycle);
    }
    for (unsigned funct3 = 0; funct3 < 3; funct3++) {
        r->cpu.x[A0] = 0xFEDCBA98;
        assert_true(execute(w_s(funct3, 0x23, A0, A1, 8), false));
        assert_int_equal(r->ports[2], stored[funct3]);
        assert_int_equal(r->width, 1u << funct3);
        assert_true(r->was_store);
    }
    assert_int_equal(r->accesses, 2 * LOADS + 3);
}

/* The access's own clock, also in the middle of a straight run and behind a checkpoint. */
static void device_sees_the_clock(void **state)
{
    (void)state;
    uint32_t words[200];
    for (size_t i = 0; i < 200; i++)
        words[i] = i % 2 == 0 ? w_addi(A3, A3, 1) : W_NOP;
    for (uint32_t at = 0; at < 199; at++) {
        rig_put(r, 0x3000, words, 200);
        RIG_PUT(r, 0x3000 + 4 * at, at % 3 == 0 ? w_sw(A0, A1, 0) : w_lw(A0, A1, 0));
        RIG_PUT(r, 0x3000 + 4 * 199, W_WFI);
        r->cpu.x[A1] = RIG_DEVICE;
        r->cpu.state = RV_RUNNING;
        uint64_t cycle = r->cpu.cycle;
        rig_run(r, 0x3000, 1000);
        assert_int_equal(r->cycle, cycle + at);
        assert_int_equal(r->cpu.cycle, cycle + 200);
    }
}

static void read_only(void **state)
{
    (void)state;
    assert_true(rv_protect(&r->cpu, RIG_BASE + 0x1002, RIG_BASE + 0x2001));
    memset(r->memory + 0x1000, 0x77, 0x1100);
    r->cpu.x[A0] = 0;
    for (uint32_t at = 0xFF0; at < 0x2020; at++) {
        bool rom = at >= 0x1002 && at < 0x2001;
        if (at == 0x1010)
            at = 0x1FF0;
        rom = at >= 0x1002 && at < 0x2001;
        r->cpu.x[A1] = RIG_BASE + at;
        if (rom)
            expect_trap(w_sb(A0, A1, 0), RV_STORE_FAULT, RIG_BASE + at);
        else
            assert_true(execute(w_sb(A0, A1, 0), false));
        assert_int_equal(r->memory[at], rom ? 0x77 : 0);
        assert_true(execute(w_i(4, 0x03, A2, A1, 0), false));
        assert_int_equal(r->cpu.x[A2], rom ? 0x77 : 0);
    }
    rv_writable(&r->cpu);
    r->cpu.x[A1] = RIG_BASE + 0x1800;
    assert_true(execute(w_sw(A0, A1, 0), false));
    assert_int_equal(rig_word(r, 0x1800), 0);
}

/* A wide store whose first byte may be written, and whose last may not. */
static void read_only_begins_within_a_word(void **state)
{
    (void)state;
    assert_true(rv_protect(&r->cpu, RIG_BASE + 0x1002, RIG_BASE + 0x1006));
    memset(r->memory + 0x1000, 0x77, 16);
    r->cpu.x[A0] = 0;
    r->cpu.x[A1] = RIG_BASE + 0x1000;
    expect_trap(w_sw(A0, A1, 0), RV_STORE_FAULT, RIG_BASE + 0x1000);
    expect_trap(w_sw(A0, A1, 4), RV_STORE_FAULT, RIG_BASE + 0x1004);
    expect_trap(w_s(1, 0x23, A0, A1, 4), RV_STORE_FAULT, RIG_BASE + 0x1004);
    assert_true(execute(w_s(1, 0x23, A0, A1, 6), false));
    assert_true(execute(w_s(1, 0x23, A0, A1, 0), false));
    assert_int_equal(rig_word(r, 0x1000), 0x77770000);
    assert_int_equal(rig_word(r, 0x1004), 0x00007777);
}

static void as_many_ranges_as_there_are(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < RV_MAX_ROM; i++)
        assert_true(rv_protect(&r->cpu, RIG_BASE + 0x1000 + 8 * i, RIG_BASE + 0x1004 + 8 * i));
    assert_false(rv_protect(&r->cpu, RIG_BASE + 0x4000, RIG_BASE + 0x4004));
    for (uint32_t i = 0; i < 2 * RV_MAX_ROM; i++) {
        r->cpu.x[A1] = RIG_BASE + 0x1000 + 4 * i;
        if (i % 2 == 0)
            expect_trap(w_sw(A0, A1, 0), RV_STORE_FAULT, r->cpu.x[A1]);
        else
            assert_true(execute(w_sw(A0, A1, 0), false));
    }
    r->cpu.x[A1] = RIG_BASE + 0x4000;
    assert_true(execute(w_sw(A0, A1, 0), false));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(loads_extend, set_up, tear_down),
        cmocka_unit_test_setup_teardown(stores_touch_nothing_else, set_up, tear_down),
        cmocka_unit_test_setup_teardown(float_registers_keep_bits, set_up, tear_down),
        cmocka_unit_test_setup_teardown(misaligned, set_up, tear_down),
        cmocka_unit_test_setup_teardown(nobody_there, set_up, tear_down),
        cmocka_unit_test_setup_teardown(ends_of_memory, set_up, tear_down),
        cmocka_unit_test_setup_teardown(device_sees_accesses, set_up, tear_down),
        cmocka_unit_test_setup_teardown(device_sees_the_clock, set_up, tear_down),
        cmocka_unit_test_setup_teardown(read_only, set_up, tear_down),
        cmocka_unit_test_setup_teardown(read_only_begins_within_a_word, set_up, tear_down),
        cmocka_unit_test_setup_teardown(as_many_ranges_as_there_are, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
