/* The machine: order of ticks and words, restarts, what a refresh is, memory limits, recordings. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "display_file/df_regs.h"
#include "emu/machine.h"
#include "emu/trouble.h"

#define COUNT(a) (sizeof(a) / sizeof *(a))
#define US       CRT_PS_PER_US
#define MS       CRT_PS_PER_MS
#define TICK     (CRT_PS_PER_S / 60)

/* Words that do as they say. */
#define POINT  (DF_SET_MODE | DF_MODE_POINT << DF_MODE_SHIFT)
#define SHORTV (DF_SET_MODE | DF_MODE_SHORT << DF_MODE_SHIFT)
#define LIT    DF_BEAM_ON
#define SYNC   (DF_STATUS_A | DF_LSA_SYNC)
#define STOP   DF_STOP

struct bench {
    struct vm_machine *m;
    struct df_program program;
};

/* Every instruction takes `average`; memory is 16 KiB; the words start at 01000. */
static struct bench set_up(const uint16_t *words, size_t count, uint64_t average,
                           enum vm_on_stop on_stop)
{
    struct bench b = {calloc(1, sizeof *b.m), {0}};
    struct crt_error err;
    const struct crt_tube_row *row = crt_tube_row_find("VR17");
    struct df_timing timing = df_timing_of_tube(row, DF_TIMING_VALUE);
    timing.average_ps = average;
    assert_non_null(b.m);
    assert_true(df_program_init(&b.program, &err));
    for (size_t i = 0; i < count; i++)
        df_program_put(&b.program, 01000 + 2 * (uint32_t)i, words[i]);
    b.program.entry = 01000;
    vm_machine_init(b.m, &(struct vm_machine_desc){.row = row,
                                                   .timing = timing,
                                                   .tick = {60, 1},
                                                   .memory_bytes = 16384,
                                                   .on_stop = on_stop});
    assert_true(vm_machine_load(b.m, &b.program, "test", &err));
    return b;
}

static void tear_down(struct bench *b)
{
    df_program_free(&b->program);
    free(b->m);
}

static void stopped_programs_restart_at_the_tick(void **state)
{
    (void)state;
    static const uint16_t words[] = {POINT, LIT | 100, 100, STOP};
    struct bench b = set_up(words, COUNT(words), 10 * US, VM_RESTART);
    vm_machine_run(b.m, 30 * US);
    assert_int_equal(b.m->dpu.state, DF_STOPPED);
    assert_int_equal(b.m->stops, 1);
    assert_int_equal(b.m->refreshes.last.number, 1);
    assert_int_equal(b.m->refreshes.last.begin, 0);
    assert_int_equal(b.m->refreshes.last.end, 30 * US);
    assert_int_equal(b.m->refreshes.last.words, 4);
    assert_int_equal(b.m->refreshes.last.instructions, 3);
    assert_int_equal(b.m->refreshes.last.strokes, 1);
    vm_machine_run(b.m, TICK);
    assert_int_equal(b.m->dpu.state, DF_STOPPED);
    vm_machine_run(b.m, TICK + 1);
    assert_int_equal(b.m->dpu.state, DF_RUNNING);
    vm_machine_run(b.m, CRT_PS_PER_S);
    assert_int_equal(b.m->refreshes.last.number, 60);
    assert_int_equal(b.m->strokes, 60);
    assert_int_equal(b.m->refreshes.last.begin, crt_tick_time((struct crt_rate){60, 1}, 59));
    tear_down(&b);
}

static void a_halted_program_stays_so(void **state)
{
    (void)state;
    static const uint16_t words[] = {POINT, LIT | 100, 100, STOP};
    struct bench b = set_up(words, COUNT(words), 10 * US, VM_HALT);
    vm_machine_run(b.m, CRT_PS_PER_S);
    assert_int_equal(b.m->stops, 1);
    assert_int_equal(b.m->strokes, 1);
    assert_int_equal(b.m->now, CRT_PS_PER_S);
    tear_down(&b);
}

/* A refresh longer than a tick waits for the next tick after its stop. */
static void long_refreshes_halve_the_rate(void **state)
{
    (void)state;
    static const uint16_t words[] = {POINT, LIT | 100, 100, STOP};
    struct bench b = set_up(words, COUNT(words), 6 * MS, VM_RESTART);
    vm_machine_run(b.m, CRT_PS_PER_S);
    assert_int_equal(b.m->refreshes.last.number, 30);
    assert_int_equal(b.m->refreshes.last.end - b.m->refreshes.last.begin, 18 * MS);
    tear_down(&b);
}

static void free_loops_count_at_their_head(void **state)
{
    (void)state;
    /* A preamble of one word, then a loop of five (four instructions). */
    static const uint16_t words[] = {POINT, POINT, LIT | 100, 100, DF_JUMP, 01002};
    struct bench b = set_up(words, COUNT(words), 10 * US, VM_RESTART);
    assert_true(b.m->refreshes.flow.loops);
    assert_int_equal(b.m->refreshes.flow.head, 01002);
    vm_machine_run(b.m, 10 * US + 30 * US * 7 + 1);
    assert_int_equal(b.m->refreshes.last.number, 7);
    assert_int_equal(b.m->refreshes.last.words, 5);
    assert_int_equal(b.m->refreshes.last.instructions, 3);
    assert_int_equal(b.m->refreshes.last.end - b.m->refreshes.last.begin, 30 * US);
    tear_down(&b);
}

static void synchronised_loops_count_at_the_tick(void **state)
{
    (void)state;
    static const uint16_t words[] = {SYNC, POINT, LIT | 100, 100, DF_JUMP, 01000};
    struct bench b = set_up(words, COUNT(words), 10 * US, VM_RESTART);
    assert_true(b.m->refreshes.flow.synchronised);
    vm_machine_run(b.m, CRT_PS_PER_S);
    /* Released at ticks 1 … 59; the lone sync word before tick 1 is no refresh. */
    assert_int_equal(b.m->refreshes.last.number, 59);
    assert_int_equal(b.m->refreshes.last.begin, crt_tick_time((struct crt_rate){60, 1}, 59));
    /* Point, datum, jump, and the sync word that ends it. */
    assert_int_equal(b.m->refreshes.last.end - b.m->refreshes.last.begin, 40 * US);
    assert_int_equal(b.m->strokes, 59);
    tear_down(&b);
}

/* An animation: two pictures, a tick each, then a stop word. */
static void each_picture_of_an_animation_is_a_refresh(void **state)
{
    (void)state;
    static const uint16_t words[] = {POINT, LIT | 100, 100, SYNC, POINT, LIT | 200, 200, STOP};
    struct bench b = set_up(words, COUNT(words), 10 * US, VM_RESTART);
    vm_machine_run(b.m, CRT_PS_PER_S);
    assert_int_equal(b.m->strokes, 60);
    assert_int_equal(b.m->refreshes.last.number, 60);
    assert_int_equal(b.m->stops, 30);
    tear_down(&b);
}

/* Until is exclusive: a word at `until` has not been fetched. */
static void words_at_the_limit_wait(void **state)
{
    (void)state;
    static const uint16_t words[] = {POINT, POINT, POINT, STOP};
    struct bench b = set_up(words, COUNT(words), 10 * US, VM_HALT);
    vm_machine_run(b.m, 10 * US);
    assert_int_equal(b.m->dpu.words, 1);
    vm_machine_run(b.m, 10 * US + 1);
    assert_int_equal(b.m->dpu.words, 2);
    vm_machine_run(b.m, 5 * US); /* the past: nothing happens */
    assert_int_equal(b.m->dpu.words, 2);
    assert_int_equal(b.m->now, 10 * US + 1);
    tear_down(&b);
}

struct log {
    size_t words, strokes;
    uint64_t last_t;
    uint16_t address[16], word[16];
};

static void log_word(void *ctx, uint64_t t, uint16_t address, uint16_t word, bool fetched,
                     const struct df_dpu *dpu)
{
    struct log *l = ctx;
    (void)dpu;
    assert_true(fetched);
    assert_true(t >= l->last_t);
    l->last_t = t;
    if (l->words < COUNT(l->address)) {
        l->address[l->words] = address;
        l->word[l->words] = word;
    }
    l->words++;
}

static void log_stroke(void *ctx, const struct crt_stroke *stroke)
{
    struct log *l = ctx;
    assert_true(stroke->t1 > stroke->t0);
    l->strokes++;
}

static void tracing_changes_nothing(void **state)
{
    (void)state;
    static const uint16_t words[] = {POINT,   LIT | 100, 100, SHORTV, LIT | 10 << 7 | 5,
                                     DF_JUMP, 01000};
    struct bench a = set_up(words, COUNT(words), 0, VM_RESTART);
    struct bench b = set_up(words, COUNT(words), 0, VM_RESTART);
    struct log l = {0};
    const struct vm_hooks hooks = {.ctx = &l, .word = log_word, .stroke = log_stroke};
    vm_machine_run(a.m, 50 * MS);
    vm_machine_trace(b.m, 20 * MS, &hooks);
    vm_machine_trace(b.m, 50 * MS, &hooks);
    assert_int_equal(l.words, a.m->dpu.words);
    assert_int_equal(l.strokes, a.m->strokes);
    assert_int_equal(b.m->dpu.t, a.m->dpu.t);
    assert_int_equal(b.m->refreshes.last.number, a.m->refreshes.last.number);
    for (size_t i = 0; i < COUNT(words); i++) {
        assert_int_equal(l.address[i], 01000 + 2 * i);
        assert_int_equal(l.word[i], words[i]);
    }
    tear_down(&a);
    tear_down(&b);
}

static void pausing_changes_nothing(void **state)
{
    (void)state;
    static const uint16_t words[] = {POINT, LIT | 100, 100, SHORTV, LIT | 10 << 7 | 5, STOP};
    struct bench a = set_up(words, COUNT(words), 7 * MS, VM_RESTART);
    struct bench b = set_up(words, COUNT(words), 7 * MS, VM_RESTART);
    vm_machine_run(a.m, CRT_PS_PER_S);
    for (int i = 0; i < 5; i++) {
        assert_true(vm_machine_run_refresh(b.m, CRT_PS_PER_S));
        assert_int_equal(b.m->now, b.m->refreshes.last.end);
        vm_machine_step(b.m);
    }
    assert_true(vm_machine_run_stop(b.m, CRT_PS_PER_S));
    assert_int_equal(b.m->stops, 6);
    vm_machine_run(b.m, CRT_PS_PER_S);
    assert_int_equal(b.m->dpu.t, a.m->dpu.t);
    assert_int_equal(b.m->strokes, a.m->strokes);
    assert_int_equal(b.m->refreshes.last.number, a.m->refreshes.last.number);
    tear_down(&a);
    tear_down(&b);
}

static void a_copy_runs_alone(void **state)
{
    (void)state;
    static const uint16_t words[] = {POINT, LIT | 100, 100, STOP};
    struct bench b = set_up(words, COUNT(words), 10 * US, VM_RESTART);
    struct vm_machine *copy = malloc(sizeof *copy);
    assert_non_null(copy);
    vm_machine_run(b.m, MS);
    assert_true(vm_machine_copy(copy, b.m));
    copy->memory[01002 / 2] = 100; /* beam off */
    vm_machine_run(copy, CRT_PS_PER_S);
    assert_int_equal(copy->strokes, 1);
    assert_int_equal(b.m->strokes, 1);
    assert_int_equal(b.m->now, MS);
    vm_machine_run(b.m, CRT_PS_PER_S);
    assert_int_equal(b.m->strokes, 60);
    free(copy);
    tear_down(&b);
}

static void memory_ends_where_it_is_set(void **state)
{
    (void)state;
    static const uint16_t words[] = {POINT, LIT | 100, 100, DF_JUMP, 040000};
    struct bench b = set_up(words, COUNT(words), 10 * US, VM_RESTART);
    struct crt_error err;
    vm_machine_run(b.m, CRT_PS_PER_S);
    assert_true(b.m->dpu.timeout);
    assert_int_equal(b.m->dpu.state, DF_WAITING_RESUME);
    assert_int_equal(b.m->interrupt[DF_INT_CHARACTER].count, 1);
    df_program_put(&b.program, 040000, 0);
    assert_false(vm_machine_load(b.m, &b.program, "test", &err));
    assert_non_null(strstr(err.text, "40000"));
    assert_true(b.m->dpu.timeout); /* nothing has changed */
    tear_down(&b);
}

static void an_illegal_word_hangs(void **state)
{
    (void)state;
    static const uint16_t words[] = {POINT, LIT | 100, 100, 0134000};
    struct bench b = set_up(words, COUNT(words), 0, VM_RESTART);
    vm_machine_run(b.m, 100 * MS);
    assert_true(b.m->dpu.illegal);
    assert_int_equal(b.m->dpu.dpc, 01006);
    assert_int_equal(b.m->refreshes.last.number, 0);
    tear_down(&b);
}

static void loading_again_keeps_time(void **state)
{
    (void)state;
    static const uint16_t words[] = {POINT, LIT | 100, 100, STOP};
    struct bench b = set_up(words, COUNT(words), 10 * US, VM_RESTART);
    struct crt_error err;
    vm_machine_run(b.m, 5 * MS);
    df_program_put(&b.program, 01002, 100); /* beam off */
    assert_true(vm_machine_load(b.m, &b.program, "test", &err));
    assert_int_equal(b.m->now, 5 * MS);
    vm_machine_run(b.m, 6 * MS);
    assert_int_equal(b.m->stops, 2);
    assert_int_equal(b.m->refreshes.last.begin, 5 * MS);
    assert_int_equal(b.m->strokes, 1);
    tear_down(&b);
}

/* Reloaded, a program that stays dark is in trouble, however much the one before has drawn. */
static void trouble_is_of_the_program_loaded_last(void **state)
{
    (void)state;
    static const uint16_t lit[] = {POINT, LIT | 100, 100, STOP};
    static uint16_t words[DF_MEMORY_BYTES / 2];
    struct bench b = set_up(lit, COUNT(lit), 0, VM_RESTART);
    struct vm_input input = {.name = "loop"};
    struct crt_error err;
    words[0] = STOP;
    vm_machine_run(b.m, CRT_PS_PER_S);
    assert_true(b.m->strokes > 0);
    assert_int_equal(vm_find_trouble(b.m, &input, &err), VM_NO_TROUBLE);
    struct df_program program = {.words = words, .low = 0, .high = 2};
    assert_true(vm_machine_load(b.m, &program, "loop", &err));
    vm_machine_run(b.m, 2 * CRT_PS_PER_S);
    assert_int_equal(vm_find_trouble(b.m, &input, &err), VM_TROUBLE_DARK);
    tear_down(&b);
}

static void recordings_are_played_in_time(void **state)
{
    (void)state;
    static const struct crt_stroke strokes[] = {
        {MS, 2 * MS, 0, 0, 1, 1, 1, 0, 0},
        {20 * MS, 21 * MS, 1, 1, 2, 2, 1, 0, 0},
        {40 * MS, 41 * MS, 2, 2, 3, 3, 1, 0, 0},
    };
    struct vm_machine *m = calloc(1, sizeof *m);
    const struct crt_tube_row *row = crt_tube_row_find("VR17");
    assert_non_null(m);
    vm_machine_init(m, &(struct vm_machine_desc){.row = row,
                                                 .timing = df_timing_of_tube(row, DF_TIMING_VALUE),
                                                 .tick = {60, 1},
                                                 .memory_bytes = 65536});
    vm_machine_play(m, (struct vm_recording){strokes, COUNT(strokes)});
    vm_machine_run(m, MS);
    assert_int_equal(m->strokes, 0);
    vm_machine_run(m, MS + 1);
    assert_int_equal(m->strokes, 1);
    vm_machine_run(m, CRT_PS_PER_S);
    assert_int_equal(m->strokes, 3);
    assert_int_equal(m->lit, 3 * MS);
    assert_int_equal(m->last_light, 41 * MS);
    free(m);
}

/* Level n has drive_low + (1 − drive_low)·n/7. */
static void drive_grows_with_level(void **state)
{
    (void)state;
    static const uint16_t words[] = {STOP};
    struct bench b = set_up(words, COUNT(words), 0, VM_RESTART);
    double low = crt_tube_row_find("VR17")->drive_low.value;
    for (int n = 0; n < 8; n++)
        assert_true(fabs(b.m->dpu.desc.drive[n] - (low + (1 - low) * n / 7)) < 1e-12);
    tear_down(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stopped_programs_restart_at_the_tick),
        cmocka_unit_test(a_halted_program_stays_so),
        cmocka_unit_test(long_refreshes_halve_the_rate),
        cmocka_unit_test(free_loops_count_at_their_head),
        cmocka_unit_test(synchronised_loops_count_at_the_tick),
        cmocka_unit_test(each_picture_of_an_animation_is_a_refresh),
        cmocka_unit_test(words_at_the_limit_wait),
        cmocka_unit_test(tracing_changes_nothing),
        cmocka_unit_test(pausing_changes_nothing),
        cmocka_unit_test(a_copy_runs_alone),
        cmocka_unit_test(memory_ends_where_it_is_set),
        cmocka_unit_test(an_illegal_word_hangs),
        cmocka_unit_test(loading_again_keeps_time),
        cmocka_unit_test(trouble_is_of_the_program_loaded_last),
        cmocka_unit_test(recordings_are_played_in_time),
        cmocka_unit_test(drive_grows_with_level),
    };
    return cmocka_run_group_tests_name("machine", tests, NULL, NULL);
}
