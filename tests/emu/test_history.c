/* Going back leads to the very state that was: compared with states recorded on the way there. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <string.h>

#include "emu/debug/history.h"
#include "tests/support/rig_digest.h"

#define COUNT(a) (sizeof(a) / sizeof *(a))
#define MS       CRT_PS_PER_MS
#define TICK     (CRT_PS_PER_S / 60)

/* A program of roms/ on a tube with a wide spot, so that there is not much to compute. */
struct bench {
    struct vm_input input;
    struct vm_settings settings;
    struct vm_rig rig;
    struct vm_history *history;
};

static struct bench *set_up(const char *path, uint64_t period, size_t budget)
{
    struct bench *b = calloc(1, sizeof *b);
    const struct vm_input_options input = {.base = {.given = false}};
    const struct vm_settings_options options = {.threads = 1};
    struct crt_error err;
    assert_non_null(b);
    if (!vm_input_load(&b->input, path, &input, &err, NULL) ||
        vm_settings_resolve(&options, NULL, vm_input_tube(&b->input), &b->settings, &err))
        fail_msg("%s", err.text);
    b->settings.monitor[VM_VECTOR].row.spot.value =
        b->settings.monitor[VM_VECTOR].row.width.value / 48;
    struct vm_tubes tubes = vm_settings_tubes(&b->settings, VM_VIEW_VECTOR);
    if (!vm_rig_open(&b->rig, &b->settings, &b->input, DF_TIMING_VALUE, &tubes, &err))
        fail_msg("%s", err.text);
    const struct vm_history_desc desc = {&b->rig, period, budget};
    assert_non_null(b->history = vm_history_create(&desc, &err));
    return b;
}

static void tear_down(struct bench *b)
{
    vm_history_destroy(b->history);
    vm_rig_close(&b->rig);
    vm_settings_free(&b->settings);
    vm_input_free(&b->input);
    free(b);
}

static void is_what_was(struct bench *b, const struct digest *was)
{
    struct digest is = rig_digest(&b->rig);
    assert_memory_equal(is.byte, was->byte, sizeof was->byte);
}

/* In pieces, as a window does. */
static void run_to(struct bench *b, uint64_t t)
{
    while (b->rig.machine->now < t) {
        uint64_t next = b->rig.machine->now + 7 * MS;
        vm_machine_run(b->rig.machine, next < t ? next : t);
        vm_history_note(b->history);
    }
}

static void one_word(struct bench *b)
{
    struct vm_machine *m = b->rig.machine;
    assert_true(vm_machine_run_words(m, m->dpu.words + 1, UINT64_MAX / 4));
    vm_history_note(b->history);
}

static void back(struct bench *b, enum vm_unit unit, uint64_t n)
{
    struct crt_error err;
    if (!vm_history_back(b->history, unit, n, &err))
        fail_msg("%s", err.text);
}

/* ---- words ------------------------------------------------------------------------------------- */

static void back_by_words(void **state)
{
    (void)state;
    enum { STEPS = 400 };
    static struct digest was[STEPS];
    static const unsigned hops[] = {1, 1, 1, 17, 1, 100, 3, 1, 200, 50};
    struct bench *b = set_up("roms/lander.df", 20 * MS, 0);
    run_to(b, CRT_PS_PER_S / 3);
    for (int i = 0; i < STEPS; i++) {
        one_word(b);
        was[i] = rig_digest(&b->rig);
    }
    unsigned at = STEPS - 1;
    for (size_t i = 0; i < COUNT(hops); i++) {
        at -= hops[i];
        back(b, VM_UNIT_WORD, hops[i]);
        is_what_was(b, &was[at]);
    }
    /* And forward again. */
    for (; at < STEPS - 1; at++) {
        is_what_was(b, &was[at]);
        one_word(b);
    }
    is_what_was(b, &was[at]);
    tear_down(b);
}

static void back_to_the_very_beginning(void **state)
{
    (void)state;
    struct bench *b = set_up("roms/spin.df", 20 * MS, 0);
    struct digest begin = rig_digest(&b->rig);
    struct crt_error err;
    run_to(b, CRT_PS_PER_S / 4);
    uint64_t words = b->rig.machine->dpu.words;
    back(b, VM_UNIT_WORD, words);
    is_what_was(b, &begin);
    run_to(b, CRT_PS_PER_S / 4);
    assert_int_equal(b->rig.machine->dpu.words, words);
    assert_false(vm_history_back(b->history, VM_UNIT_WORD, words + 1, &err));
    assert_string_equal(err.text, "this is as far back as the run is remembered");
    is_what_was(b, &begin);
    tear_down(b);
}

/* ---- refreshes --------------------------------------------------------------------------------- */

static void refreshes_of(const char *path)
{
    enum { REFRESHES = 30 };
    static struct digest was[REFRESHES];
    struct bench *b = set_up(path, 50 * MS, 0);
    struct vm_machine *m = b->rig.machine;
    run_to(b, CRT_PS_PER_S / 4);
    uint64_t first = m->refreshes.last.number + 1;
    for (int i = 0; i < REFRESHES; i++) {
        assert_true(vm_machine_run_refresh(m, UINT64_MAX / 4));
        vm_history_note(b->history);
        was[i] = rig_digest(&b->rig);
    }
    /* From the end of a refresh to that before; from within one to its own begin. */
    back(b, VM_UNIT_REFRESH, 1);
    is_what_was(b, &was[REFRESHES - 2]);
    vm_machine_run(m, m->now + MS / 10);
    assert_int_equal(m->refreshes.last.number, first + REFRESHES - 2);
    back(b, VM_UNIT_REFRESH, 1);
    is_what_was(b, &was[REFRESHES - 2]);
    back(b, VM_UNIT_REFRESH, 20);
    is_what_was(b, &was[REFRESHES - 22]);
    for (int i = REFRESHES - 22; i > 0; i--) {
        back(b, VM_UNIT_REFRESH, 1);
        is_what_was(b, &was[i - 1]);
    }
    assert_int_equal(m->refreshes.last.number, first);
    tear_down(b);
}

/* Restarted at ticks, waiting for them, going round freely. */
static void back_by_refreshes(void **state)
{
    (void)state;
    refreshes_of("roms/radar.df");
    refreshes_of("roms/charset.df");
    refreshes_of("tests/programs/star.df");
}

/* A film exposed again after going back is the same film. */
static void light_is_seen_again(void **state)
{
    (void)state;
    struct bench *b = set_up("roms/lander.df", 30 * MS, 0);
    struct vm_machine *m = b->rig.machine;
    struct crt_film film[2];
    struct crt_error err;
    run_to(b, CRT_PS_PER_S / 5);
    assert_true(vm_machine_run_refresh(m, UINT64_MAX / 4));
    uint64_t t = m->now;
    for (int i = 0; i < 2; i++) {
        assert_true(crt_film_init(&film[i], b->rig.tube[VM_VECTOR], &err));
        crt_film_open(b->rig.tube[VM_VECTOR], &film[i], t + MS, t + 3 * TICK);
        run_to(b, t + 3 * TICK);
        assert_true(film[i].complete);
        while (m->now > t)
            back(b, VM_UNIT_REFRESH, 1);
        assert_int_equal(m->now, t);
    }
    size_t cells = (size_t)film[0].grid.cols * (size_t)film[0].grid.rows;
    assert_memory_equal(film[0].light[0], film[1].light[0], cells * sizeof(float));
    crt_film_free(&film[0]);
    crt_film_free(&film[1]);
    tear_down(b);
}

/* ---- instructions ------------------------------------------------------------------------------ */

static void back_by_instructions(void **state)
{
    (void)state;
    enum { STEPS = 300 };
    static struct digest was[STEPS];
    static const unsigned hops[] = {1, 1, 40, 1, 1, 7, 100, 2, 1, 60};
    struct bench *b = set_up("roms/bounce.elf", 20 * MS, 0);
    struct vm_machine *m = b->rig.machine;
    run_to(b, CRT_PS_PER_S / 4);
    for (int i = 0; i < STEPS; i++) {
        assert_true(vm_machine_run_retired(m, rv_retired(&m->desc.board->cpu) + 1, UINT64_MAX / 4));
        vm_history_note(b->history);
        was[i] = rig_digest(&b->rig);
    }
    unsigned at = STEPS - 1;
    for (size_t i = 0; i < COUNT(hops); i++) {
        at -= hops[i];
        back(b, VM_UNIT_INSTRUCTION, hops[i]);
        is_what_was(b, &was[at]);
    }
    /* Each unit leads to the same past. */
    back(b, VM_UNIT_INSTRUCTION, 100000);
    uint64_t words = m->dpu.words, number = m->refreshes.last.number;
    back(b, VM_UNIT_WORD, 10);
    assert_int_equal(m->dpu.words, words - 10);
    back(b, VM_UNIT_REFRESH, 2);
    assert_true(m->refreshes.last.number < number);
    tear_down(b);
}

/* A searcher's way: to the last snapshot before some clock, and on from there. */
static void rewound_by_the_clock(void **state)
{
    (void)state;
    struct bench *b = set_up("roms/clock.elf", 10 * MS, 0);
    struct vm_machine *m = b->rig.machine;
    const struct rv_cpu *cpu = &m->desc.board->cpu;
    run_to(b, CRT_PS_PER_S / 20);
    vm_machine_run(m, m->now + 3 * MS);
    struct digest was = rig_digest(&b->rig);
    uint64_t t = m->now, cycle = cpu->cycle;
    assert_true(vm_history_rewind(b->history, cycle));
    assert_true(cpu->cycle < cycle && t - m->now <= 20 * MS);
    uint64_t earlier = cpu->cycle;
    assert_true(vm_history_rewind(b->history, cycle)); /* again the same */
    assert_int_equal(cpu->cycle, earlier);
    vm_machine_run(m, t);
    is_what_was(b, &was);
    assert_true(vm_history_rewind(b->history, earlier));
    assert_true(cpu->cycle < earlier);
    while (vm_history_rewind(b->history, cpu->cycle))
        ;
    assert_int_equal(m->now, 0);
    vm_machine_run(m, t);
    is_what_was(b, &was);
    tear_down(b);
}

/* What was printed is not printed again. */
static void count_byte(void *ctx, uint8_t byte, uint64_t t)
{
    (void)byte;
    (void)t;
    ++*(unsigned *)ctx;
}

static void the_console_says_it_once(void **state)
{
    (void)state;
    struct bench *b = set_up("roms/hello.elf", MS, 0);
    unsigned bytes = 0;
    b->rig.console->desc = (struct vm_console_desc){.ctx = &bytes, .sink = count_byte};
    run_to(b, 5 * MS);
    unsigned printed = bytes;
    assert_true(printed > 20);
    struct digest was = rig_digest(&b->rig);
    back(b, VM_UNIT_INSTRUCTION, 10000);
    assert_true(b->rig.console->sent < printed);
    run_to(b, 5 * MS);
    is_what_was(b, &was);
    assert_int_equal(bytes, printed);
    run_to(b, 100 * MS);
    assert_true(bytes > printed);
    tear_down(b);
}

/* ---- what is remembered ------------------------------------------------------------------------ */

/* With little memory the spacing grows with age, the begin stays, and back is exact all the same. */
static void little_memory_thins(void **state)
{
    (void)state;
    struct bench *b = set_up("tests/programs/star.df", 10 * MS, 0);
    struct vm_machine *m = b->rig.machine;
    vm_machine_run(m, CRT_PS_PER_S / 2 + MS);
    vm_history_forget(b->history);
    size_t one = vm_history_extent(b->history).bytes;
    tear_down(b);
    b = set_up("tests/programs/star.df", 10 * MS, 40 * one);
    m = b->rig.machine;
    struct digest was[6];
    uint64_t number[6];
    for (int i = 0; i < 6; i++) {
        run_to(b, (uint64_t)(i + 1) * CRT_PS_PER_S / 2);
        assert_true(vm_machine_run_refresh(m, UINT64_MAX / 4));
        was[i] = rig_digest(&b->rig);
        number[i] = m->refreshes.last.number;
    }
    struct vm_history_extent extent = vm_history_extent(b->history);
    print_message("# %zu snapshots, %zu bytes of %zu\n", extent.snapshots, extent.bytes, 40 * one);
    assert_true(extent.bytes <= 40 * one && extent.snapshots >= 8);
    assert_int_equal(extent.oldest, 0);
    for (int i = 5; i >= 0; i--) {
        if (m->refreshes.last.number > number[i])
            back(b, VM_UNIT_REFRESH, m->refreshes.last.number - number[i]);
        assert_int_equal(m->refreshes.last.number, number[i]);
        is_what_was(b, &was[i]);
    }
    tear_down(b);
}

/* A knob turned in between: no replay crosses that. */
static void what_came_from_outside_stays(void **state)
{
    (void)state;
    struct bench *b = set_up("roms/lander.df", 60 * MS, 0);
    struct vm_machine *m = b->rig.machine;
    struct digest was[6];
    for (int i = 0; i < 6; i++) {
        run_to(b, (uint64_t)(i + 1) * 97 * MS);
        crt_tube_set_knobs(b->rig.tube[VM_VECTOR], (struct crt_knobs){0.1 * i, 1, 0});
        m->memory[0100] = (uint16_t)i;
        vm_history_mark(b->history);
        assert_true(vm_machine_run_refresh(m, UINT64_MAX / 4));
        was[i] = rig_digest(&b->rig);
    }
    run_to(b, CRT_PS_PER_S);
    for (int i = 5; i >= 0; i--) {
        while (m->now > (uint64_t)(i + 1) * 97 * MS + 2 * TICK)
            back(b, VM_UNIT_REFRESH, 1);
        while (memcmp(rig_digest(&b->rig).byte, was[i].byte, sizeof was[i].byte) != 0) {
            assert_true(m->now > (uint64_t)(i + 1) * 97 * MS);
            back(b, VM_UNIT_REFRESH, 1);
        }
        assert_int_equal(m->memory[0100], i);
        assert_true(crt_tube_knobs(b->rig.tube[VM_VECTOR]).brightness == 0.1 * i);
    }
    tear_down(b);
}

/* Going back a long way leaves snapshots near the target: the next step is short. */
static void the_second_step_is_short(void **state)
{
    (void)state;
    struct bench *b = set_up("roms/lander.df", 10 * MS, 0);
    struct vm_machine *m = b->rig.machine;
    vm_machine_run(m, CRT_PS_PER_S / 2); /* without a note */
    assert_int_equal(vm_history_extent(b->history).snapshots, 1);
    back(b, VM_UNIT_WORD, 10);
    size_t many = vm_history_extent(b->history).snapshots;
    assert_true(many > 40);
    back(b, VM_UNIT_WORD, 1);
    assert_true(vm_history_extent(b->history).snapshots + 1 >= many);
    vm_history_forget(b->history);
    assert_int_equal(vm_history_extent(b->history).snapshots, 1);
    assert_int_equal(vm_history_extent(b->history).oldest, m->now);
    tear_down(b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(back_by_words),
        cmocka_unit_test(back_to_the_very_beginning),
        cmocka_unit_test(back_by_refreshes),
        cmocka_unit_test(light_is_seen_again),
        cmocka_unit_test(back_by_instructions),
        cmocka_unit_test(rewound_by_the_clock),
        cmocka_unit_test(the_console_says_it_once),
        cmocka_unit_test(little_memory_thins),
        cmocka_unit_test(what_came_from_outside_stays),
        cmocka_unit_test(the_second_step_is_short),
    };
    return cmocka_run_group_tests_name("history", tests, NULL, NULL);
}
