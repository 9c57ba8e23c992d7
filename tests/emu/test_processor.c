/* The machine with its processor: who sees what when, interrupts, registers; all against closed forms,
 * and the same however the run is cut into pieces. */
#include "tests/emu/processor_rig.h"

#include "emu/trouble.h"

/* ---- stores and fetches ------------------------------------------------------------------------- */

struct seen {
    uint64_t t[4096];
    uint16_t word[4096];
    size_t count;
};

static void see(void *ctx, uint64_t t, uint16_t address, uint16_t word, bool fetched,
                const struct df_dpu *dpu)
{
    struct seen *s = ctx;
    (void)dpu;
    if (address != 01002 || !fetched)
        return;
    assert_true(s->count < COUNT(s->t));
    s->t[s->count] = t;
    s->word[s->count++] = word;
}

static struct seen *watch_in_pieces(uint64_t piece)
{
    struct bench *b = set_up(writer, COUNT(writer), looped, COUNT(looped));
    struct seen *s = calloc(1, sizeof *s);
    const struct vm_hooks hooks = {.ctx = s, .word = see};
    assert_non_null(s);
    while (b->m->now < 20 * MS)
        vm_machine_trace(b->m, b->m->now + piece < 20 * MS ? b->m->now + piece : 20 * MS, &hooks);
    tear_down(b);
    return s;
}

static void a_fetch_sees_the_stores_begun_before_it(void **state)
{
    (void)state;
    struct seen *s = watch_in_pieces(20 * MS);
    assert_true(s->count > 600);
    for (size_t i = 0; i < s->count; i++) {
        /* The n-th store begins at cycle FIRST_STORE + EVERY * (n - 1). */
        uint64_t begun = (s->t[i] + CYCLE - 1) / CYCLE; /* cycles begun before t */
        uint64_t stores = begun > FIRST_STORE ? (begun - 1 - FIRST_STORE) / EVERY + 1 : 0;
        assert_int_equal(s->word[i], stores % 1024);
    }
    free(s);
}

static void pieces_of_a_run_change_nothing(void **state)
{
    (void)state;
    static const uint64_t pieces[] = {1 * MS, 777777, 20001, 5000000001};
    struct seen *whole = watch_in_pieces(20 * MS);
    for (size_t i = 0; i < COUNT(pieces); i++) {
        struct seen *cut = watch_in_pieces(pieces[i]);
        assert_memory_equal(cut, whole, sizeof *cut);
        free(cut);
    }
    free(whole);
}

/* ---- interrupts --------------------------------------------------------------------------------- */

static void stop_interrupts_come_when_the_word_is_done(void **state)
{
    (void)state;
    struct bench *b = set_up(stopper, COUNT(stopper), stopping, COUNT(stopping));
    /* A refresh is four instructions of AVERAGE; the handler begins at the first cycle not before
     * its end, and starts the file again three cycles after that. */
    uint64_t start = 11 * CYCLE, n = 0;
    while (start + 4 * AVERAGE < 10 * MS) {
        uint64_t end = start + 4 * AVERAGE, taken = (end + CYCLE - 1) / CYCLE * CYCLE;
        vm_machine_run(b->m, end);
        assert_int_equal(b->board->irq.pending & 1 << IRQ_LINE_STOP, 0);
        assert_int_equal(b->board->cpu.x[A0], n);
        assert_int_equal(b->m->stops, n + 1);
        vm_machine_run(b->m, taken + CYCLE);
        n++;
        assert_int_equal(b->board->cpu.x[A0], n);
        assert_int_equal(b->board->irq.pending & 1 << IRQ_LINE_STOP, 1 << IRQ_LINE_STOP);
        start = taken + 2 * CYCLE;
        vm_machine_run(b->m, start + 2 * CYCLE);
        assert_int_equal(b->board->cpu.x[A4], IRQ_LINE_STOP);
        assert_int_equal(b->board->cpu.x[A5], 0);
    }
    assert_true(n > 200);
    assert_int_equal(b->m->refreshes.last.number, n);
    assert_int_equal(b->m->refreshes.last.words, 5);
    tear_down(b);
}

/* Nothing but the stop: the line falls at START and rises when that word is done. */
static void a_line_falls_at_start_though_the_first_word_raises_it(void **state)
{
    (void)state;
    static const uint16_t stop[] = {DF_STATUS_A | DF_LSA_STOP_INT | DF_LSA_STOP_INT_ON |
                                    DF_LSA_STOP};
    struct bench *b = set_up(stopper, COUNT(stopper), stop, COUNT(stop));
    uint64_t start = 11 * CYCLE;
    for (uint32_t n = 1; n < 20; n++) {
        uint64_t taken = (start + AVERAGE + CYCLE - 1) / CYCLE * CYCLE;
        vm_machine_run(b->m, taken + 4 * CYCLE);
        assert_int_equal(b->board->cpu.x[A0], n);
        assert_int_equal(b->board->cpu.x[A4], IRQ_LINE_STOP);
        assert_int_equal(b->board->cpu.x[A5], 0);
        start = taken + 2 * CYCLE;
    }
    tear_down(b);
}

/* ---- registers ---------------------------------------------------------------------------------- */

/* Runs code that ends in WFI with interrupts off, and returns the bench. */
static struct bench *run_code(const uint32_t *code, size_t words)
{
    struct bench *b = set_up(code, words, looped, COUNT(looped));
    vm_machine_run(b->m, MS);
    return b;
}

static void display_memory_takes_all_widths(void **state)
{
    (void)state;
    static const uint32_t code[] = {
        LUI(A0, MAP_DISPLAY >> 12),
        LUI(A1, 0x12345),
        ADDI(A1, A1, 0x678),
        SW(A1, A0, 0x100),
        SB(A1, A0, 0x101),
        SH(A1, A0, 0x106),
        LW(A2, A0, 0x100),
        LHU(A3, A0, 0x102),
        LBU(A4, A0, 0x101),
        LW(A5, A0, 0x104),
        WFI,
    };
    struct bench *b = run_code(code, COUNT(code));
    assert_int_equal(b->m->memory[0x80], 0x7878);
    assert_int_equal(b->m->memory[0x81], 0x1234);
    assert_int_equal(b->m->memory[0x83], 0x5678);
    assert_int_equal(b->board->cpu.x[A2], 0x12347878);
    assert_int_equal(b->board->cpu.x[A3], 0x1234);
    assert_int_equal(b->board->cpu.x[A4], 0x78);
    assert_int_equal(b->board->cpu.x[A5], 0x56780000);
    tear_down(b);
}

static void identity_says_what_is_here(void **state)
{
    (void)state;
    static const uint32_t code[] = {
        LUI(A0, MAP_IDENTITY >> 12), LW(A1, A0, IDENTITY_MAGIC),
        LW(A2, A0, IDENTITY_HEADS),  LW(A3, A0, IDENTITY_ENTRY),
        LW(A4, A0, IDENTITY_CLOCK),  SW(A3, A0, IDENTITY_MARK),
        LW(A5, A0, IDENTITY_TICK),   WFI,
    };
    struct bench *b = run_code(code, COUNT(code));
    assert_int_equal(b->board->cpu.x[A1], IDENTITY_KNSC);
    assert_int_equal(b->board->cpu.x[A2], 1);
    assert_int_equal(b->board->cpu.x[A3], 01000);
    assert_int_equal(b->board->cpu.x[A4], VM_CPU_HZ);
    assert_int_equal(b->board->cpu.x[A5], 0);
    assert_int_equal(b->m->marks, 1);
    assert_int_equal(b->m->mark, 01000);
    tear_down(b);
}

/* Each would be an access fault; with mtvec 0 nobody handles it. */
static void what_no_device_takes_is_a_fault_nobody_handles(void **state)
{
    (void)state;
    const struct {
        uint32_t instruction, base, cause;
    } cases[] = {
        {LBU(A1, A0, 0), MAP_DPU, RV_LOAD_FAULT},              /* width */
        {LW(A1, A0, 0), MAP_DPU, RV_LOAD_FAULT},               /* width */
        {SH(A1, A0, 040), MAP_DPU, RV_STORE_FAULT},            /* no such register */
        {LHU(A1, A0, 0), MAP_IDENTITY, RV_LOAD_FAULT},         /* width */
        {SW(A1, A0, 0), MAP_IDENTITY, RV_STORE_FAULT},         /* read-only */
        {LW(A1, A0, 0), MAP_DISPLAY + 0x10000, RV_LOAD_FAULT}, /* beyond what memory there is */
        {LW(A1, A0, 0), 0x50000000, RV_LOAD_FAULT},            /* nobody */
        {SW(A1, A0, 0), MAP_PROGRAM, RV_STORE_FAULT},          /* ROM */
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        const uint32_t code[] = {LUI(A0, cases[i].base >> 12), cases[i].instruction, WFI};
        struct bench *b = set_up(code, COUNT(code), looped, COUNT(looped));
        struct vm_input input = {.name = "test"};
        struct crt_error err;
        assert_true(vm_machine_run_end(b->m, MS));
        assert_int_equal(b->board->cpu.state, RV_HALTED);
        assert_int_equal(b->board->cpu.trouble.cause, cases[i].cause);
        assert_int_equal(b->board->cpu.trouble.pc, MAP_PROGRAM + 4);
        assert_int_equal(vm_find_trouble(b->m, &input, &err), VM_TROUBLE_TRAP);
        assert_non_null(strstr(err.text, "80000004"));
        tear_down(b);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_fetch_sees_the_stores_begun_before_it),
        cmocka_unit_test(pieces_of_a_run_change_nothing),
        cmocka_unit_test(stop_interrupts_come_when_the_word_is_done),
        cmocka_unit_test(a_line_falls_at_start_though_the_first_word_raises_it),
        cmocka_unit_test(display_memory_takes_all_widths),
        cmocka_unit_test(identity_says_what_is_here),
        cmocka_unit_test(what_no_device_takes_is_a_fault_nobody_handles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
