/* The machine with its processor: to which moment a run goes, the console, copies. */
#include "tests/emu/processor_rig.h"

/* ---- goals -------------------------------------------------------------------------------------- */

static void the_finisher_ends_a_run_with_its_status(void **state)
{
    (void)state;
    static const uint32_t code[] = {LUI(A0, MAP_FINISHER >> 12), LUI(A1, 0x73), ADDI(A1, A1, 0x333),
                                    SW(A1, A0, 0), JUMP_BACK(0)};
    struct bench *b = set_up(code, COUNT(code), NULL, 0);
    int status = 0;
    assert_true(vm_machine_run_end(b->m, MS));
    assert_int_equal(b->m->now, 4 * CYCLE);
    assert_true(vm_machine_exited(b->m, &status));
    assert_int_equal(status, 7);
    vm_machine_run(b->m, 2 * MS);
    assert_int_equal(b->m->now, 2 * MS);
    assert_int_equal(rv_retired(&b->board->cpu), 4);
    tear_down(b);
}

/* Power-on again is at the present time, however long ago the processor ended. */
static void firmware_that_has_ended_can_be_booted_again(void **state)
{
    (void)state;
    static const uint32_t code[] = {LUI(A0, MAP_FINISHER >> 12), LUI(A1, 5), ADDI(A1, A1, 0x555),
                                    SW(A1, A0, 0), JUMP_BACK(0)};
    struct bench *b = set_up(code, COUNT(code), NULL, 0);
    assert_true(vm_machine_run_end(b->m, MS));
    vm_machine_run(b->m, 2 * MS);
    boot(b, code, COUNT(code), false);
    assert_true(vm_machine_run_end(b->m, 3 * MS));
    assert_int_equal(b->m->now, 2 * MS + 4 * CYCLE);
    assert_int_equal(b->board->finisher.t, 2 * MS + 3 * CYCLE);
    assert_int_equal(rv_retired(&b->board->cpu), 8);
    tear_down(b);
}

/* Also where the firmware says itself what a refresh is. */
static void a_stop_is_when_its_word_is_done(void **state)
{
    (void)state;
    static const uint32_t code[] = {LUI(A0, MAP_IDENTITY >> 12), SW(ZERO, A0, IDENTITY_REFRESH),
                                    LUI(A1, MAP_DPU >> 12),      ADDI(A2, ZERO, 01000),
                                    SH(A2, A1, DF_DPC),          WFI};
    struct bench *b = set_up(code, COUNT(code), stopping, COUNT(stopping));
    assert_true(vm_machine_run_stop(b->m, MS));
    assert_int_equal(b->m->now, 4 * CYCLE + 4 * AVERAGE);
    assert_int_equal(b->m->now, b->m->last_stop);
    tear_down(b);
}

/* The instruction begun when the word was fetched has been executed, too. */
static void where_a_word_was_reached_can_be_saved(void **state)
{
    (void)state;
    struct bench *b = set_up(writer, COUNT(writer), looped, COUNT(looped));
    for (uint64_t n = 1; n < 20; n++) {
        struct crt_state s;
        assert_true(vm_machine_run_words(b->m, n, MS));
        crt_state_save(&s);
        vm_machine_state(b->m, &s);
        if (s.failed)
            fail_msg("%s", s.err.text);
        crt_state_free(&s);
    }
    tear_down(b);
}

static void runs_stop_at_an_instruction_or_a_word(void **state)
{
    (void)state;
    struct bench *b = set_up(writer, COUNT(writer), looped, COUNT(looped));
    for (uint64_t n = 1; n < 3000; n += 7) {
        assert_true(vm_machine_run_retired(b->m, n, MS));
        assert_int_equal(rv_retired(&b->board->cpu), n);
        assert_int_equal(b->m->now, n * CYCLE);
    }
    uint64_t words = b->m->dpu.words;
    for (uint64_t n = words + 1; n < words + 100; n++) {
        assert_true(vm_machine_run_words(b->m, n, MS));
        assert_int_equal(b->m->dpu.words, n);
        assert_true(b->board->cpu.cycle >= b->m->now / CYCLE);
        assert_true((b->board->cpu.cycle - 1) * CYCLE < b->m->now);
    }
    assert_false(vm_machine_run_retired(b->m, UINT64_MAX, b->m->now + US));
    tear_down(b);
}

static bool at_the_store(void *ctx, struct rv_cpu *cpu)
{
    (void)ctx;
    return cpu->pc == MAP_PROGRAM + 8 * 4 && cpu->x[A3] == 100;
}

static void a_debugger_stops_before_an_instruction(void **state)
{
    (void)state;
    struct bench *b = set_up(writer, COUNT(writer), looped, COUNT(looped));
    const struct rv_hooks hooks = {NULL, at_the_store, NULL, NULL};
    assert_true(vm_machine_watch(b->m, 10 * MS, &hooks));
    uint64_t cycle = FIRST_STORE + EVERY * 99;
    assert_int_equal(b->m->now, cycle * CYCLE);
    assert_int_equal(b->board->cpu.cycle, cycle);
    assert_true(b->m->memory[01002 / 2] == 99);
    vm_machine_run(b->m, b->m->now + CYCLE);
    assert_true(b->m->memory[01002 / 2] == 100);
    tear_down(b);
}

/* ---- console ------------------------------------------------------------------------------------ */

/* Sends back each byte plus one. */
static const uint32_t echo[] = {
    LUI(A0, MAP_UART >> 12),
    LBU(A1, A0, 5),
    I(0x13u, 7u, A1, A1, 1), /* andi: data ready */
    0xfe058ce3u /* beq a1,zero,-8 */,
    LBU(A2, A0, 0),
    ADDI(A2, A2, 1),
    SB(A2, A0, 0),
    JUMP_BACK(6),
};

struct paper {
    char text[32];
    uint64_t t[32];
    size_t count;
};

static void to_paper(void *ctx, uint8_t byte, uint64_t t)
{
    struct paper *p = ctx;
    p->text[p->count] = (char)byte;
    p->t[p->count++] = t;
}

static void the_console_keeps_its_baud_rate(void **state)
{
    (void)state;
    struct bench *b = set_up(echo, COUNT(echo), NULL, 0);
    struct paper paper = {"", {0}, 0};
    b->console.desc = (struct vm_console_desc){.ctx = &paper, .sink = to_paper};
    assert_true(vm_console_type(&b->console, "HAL", 3, 100 * US));
    vm_console_watch(&b->console, "BM");
    assert_true(vm_machine_run_console(b->m, 10 * MS));
    assert_int_equal(b->m->now, paper.t[2]);
    assert_string_equal(paper.text, "IBM");
    double byte = 10e12 / 115200;
    for (int i = 1; i < 3; i++) {
        double apart = (double)(paper.t[i] - paper.t[i - 1]);
        assert_true(apart > byte * 0.999 && apart < byte * 1.02);
    }
    assert_true(paper.t[0] > 100 * US + (uint64_t)byte);
    tear_down(b);
}

/* Reads a byte, then does nothing for longer than the next one takes. */
static const uint32_t sleepy[] = {
    /* 00 */ LUI(A0, MAP_UART >> 12),
    /* 04 */ LBU(A1, A0, 0),
    /* 08 */ ADDI(T0, ZERO, 1999),
    /* 0c */ NOP,
    /* 10 */ ADDI(T0, T0, -1),
    /* 14 */ 0xfe029ce3u, /* bne t0,zero,-8 */
    /* 18 */ JUMP_BACK(5),
};

static void pieces_do_not_change_when_bytes_arrive(void **state)
{
    (void)state;
    struct bench *whole = set_up(sleepy, COUNT(sleepy), NULL, 0);
    struct bench *cut = set_up(sleepy, COUNT(sleepy), NULL, 0);
    static const char text[300] = "typed";
    assert_true(vm_console_type(&whole->console, text, sizeof text, 0));
    assert_true(vm_console_type(&cut->console, text, sizeof text, 0));
    for (uint64_t t = 60 * US; t < 30 * MS; t += 120 * US) {
        vm_machine_run(whole->m, t);
        while (cut->m->now < t)
            vm_machine_run(cut->m, t - cut->m->now > 17001 ? cut->m->now + 17001 : t);
        assert_int_equal(cut->console.next, whole->console.next);
        assert_int_equal(cut->board->uart.ready_from, whole->board->uart.ready_from);
    }
    assert_true(whole->console.next > 200);
    tear_down(whole);
    tear_down(cut);
}

/* ---- copies ------------------------------------------------------------------------------------- */

static void a_copy_goes_on_alone_to_the_same_end(void **state)
{
    (void)state;
    struct bench *b = set_up(stopper, COUNT(stopper), stopping, COUNT(stopping));
    struct vm_machine *copy = malloc(sizeof *copy);
    assert_non_null(copy);
    vm_machine_run(b->m, 3333333333);
    assert_true(vm_machine_copy(copy, b->m));
    vm_machine_run(copy, 9 * MS);
    assert_int_equal(b->m->now, 3333333333);
    vm_machine_run(b->m, 9 * MS);
    assert_int_equal(copy->desc.board->cpu.x[A0], b->board->cpu.x[A0]);
    assert_int_equal(copy->desc.board->cpu.pc, b->board->cpu.pc);
    assert_int_equal(copy->desc.board->cpu.cycle, b->board->cpu.cycle);
    assert_int_equal(copy->dpu.words, b->m->dpu.words);
    assert_int_equal(copy->dpu.t, b->m->dpu.t);
    assert_int_equal(copy->refreshes.last.end, b->m->refreshes.last.end);
    /* The copy's ROM is ROM, too. */
    assert_int_equal(copy->desc.board->cpu.rom_count, 1);
    vm_machine_forget(copy);
    free(copy);
    tear_down(b);
}

static void firmware_can_be_booted_again_after_it_was_lost(void **state)
{
    (void)state;
    static const uint32_t lost[] = {LUI(A0, 0x50000), LW(A1, A0, 0)};
    static const uint8_t counting[] = {0x13, 0x05, 0x15, 0,
                                       0x6f, 0xf0, 0xdf, 0xff}; /* addi a0; j */
    const struct vm_elf elf = {
        .segment = {{MAP_PROGRAM, counting, sizeof counting, sizeof counting, false, true}},
        .segments = 1,
        .entry = MAP_PROGRAM};
    struct bench *b = set_up(lost, COUNT(lost), NULL, 0);
    struct crt_error err;
    assert_true(vm_machine_run_end(b->m, MS));
    vm_machine_run(b->m, MS);
    assert_true(vm_machine_boot(b->m, &elf, NULL, "again", &err));
    vm_machine_run(b->m, 2 * MS);
    assert_int_equal(b->board->cpu.state, RV_RUNNING);
    assert_int_equal(b->board->cpu.x[A0], MS / CYCLE / 2);
    assert_int_equal(b->board->cpu.cycle, 2 * MS / CYCLE);
    tear_down(b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(firmware_can_be_booted_again_after_it_was_lost),
        cmocka_unit_test(the_finisher_ends_a_run_with_its_status),
        cmocka_unit_test(firmware_that_has_ended_can_be_booted_again),
        cmocka_unit_test(a_stop_is_when_its_word_is_done),
        cmocka_unit_test(where_a_word_was_reached_can_be_saved),
        cmocka_unit_test(runs_stop_at_an_instruction_or_a_word),
        cmocka_unit_test(a_debugger_stops_before_an_instruction),
        cmocka_unit_test(the_console_keeps_its_baud_rate),
        cmocka_unit_test(pieces_do_not_change_when_bytes_arrive),
        cmocka_unit_test(a_copy_goes_on_alone_to_the_same_end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
