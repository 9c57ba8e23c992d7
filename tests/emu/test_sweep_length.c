/* How long a list may grow: the arithmetic of lists against the machine that runs them, and what it says of
 * flicker against the published line. */
#define _POSIX_C_SOURCE 200809L
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "display_file/asm.h"
#include "emu/lab/sweep_length.h"

static const char *const tubes[] = {"VR17", "VR14", "LAB31", "TYPE30"};

static void resolve(struct vm_settings *s, const char *tube, const char *set)
{
    struct vm_settings_options o = {.tube = {{tube}, 1}, .set = {{set}, set ? 1 : 0}};
    struct crt_error err;
    if (vm_settings_resolve(&o, NULL, NULL, s, &err) != 0)
        fail_msg("%s", err.text);
}

/* The list as source, assembled. */
static void assemble(const struct vm_list_shape *s, long n, struct vm_input *input)
{
    char *text;
    size_t length;
    struct df_asm_report report;
    FILE *to = open_memstream(&text, &length);
    assert_non_null(to);
    vm_list_write(to, s, n, NULL);
    fclose(to);
    memset(input, 0, sizeof *input);
    if (!df_assemble_text("list.df", text, length, NULL, &input->program, &report))
        fail_msg("%s", report.text);
    df_asm_report_free(&report);
    free(text);
}

struct run {
    uint64_t took, period; /* of the second refresh; the longest from one's begin to the next's */
    uint64_t words;
};

static struct run run(const struct vm_settings *settings, const struct vm_list_shape *s, long n,
                      enum df_timing_choice choice)
{
    struct vm_input input;
    struct vm_rig rig;
    struct crt_error err;
    struct run r;
    assemble(s, n, &input);
    if (!vm_rig_open(&rig, settings, &input, choice, NULL, &err))
        fail_msg("%s", err.text);
    for (int i = 0; i < 2; i++)
        assert_true(vm_machine_run_refresh(rig.machine, 100 * CRT_PS_PER_S));
    struct vm_refresh last = rig.machine->refreshes.last;
    r = (struct run){last.end - last.begin, 0, last.words};
    /* One that misses the tick by less than the sync word takes is late by that, until it misses it whole. */
    for (int i = 0; i < (s->sync ? 40 : 1); i++) {
        assert_true(vm_machine_run_refresh(rig.machine, 100 * CRT_PS_PER_S));
        uint64_t gap = rig.machine->refreshes.last.begin - last.begin;
        r.period = gap > r.period ? gap : r.period;
        last = rig.machine->refreshes.last;
    }
    vm_rig_close(&rig);
    df_program_free(&input.program);
    return r;
}

static long uniform(uint64_t *seed, long low, long high)
{
    *seed = *seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return low + (long)((*seed >> 33) % (uint64_t)(high - low + 1));
}

/* To the picosecond, whatever the items, their length and the choice of times. */
static void lists_take_what_the_machine_takes(void **state)
{
    (void)state;
    uint64_t seed = 3;
    for (size_t i = 0; i < sizeof tubes / sizeof *tubes; i++)
        for (int average = 0; average < 2; average++) {
            struct vm_settings settings;
            resolve(&settings, tubes[i], average ? "dpu.average=33.33us" : NULL);
            const struct crt_tube_row *row = &settings.monitor[VM_VECTOR].row;
            for (int k = 0; k < 24; k++) {
                enum df_timing_choice choice = (enum df_timing_choice)uniform(&seed, 0, 2);
                struct vm_list_shape s =
                    vm_list_shape(row, (enum vm_list_kind)(k % VM_LIST_KINDS),
                                  (int)uniform(&seed, 1, k % 8 < 4 ? 60 : 1023), false);
                struct df_timing t = df_timing_of_tube(row, choice);
                t.average_ps = settings.average_ps;
                long n = uniform(&seed, 1, 700);
                struct run r = run(&settings, &s, n, choice);
                if (r.took != vm_list_ps(&s, &t, n) || r.period != r.took ||
                    (long)r.words != vm_list_words(&s, n))
                    fail_msg(
                        "%s kind %d, %ld of %d units: %llu ps and %llu words, not %llu and %ld",
                        tubes[i], s.kind, n, s.units, (unsigned long long)r.took,
                        (unsigned long long)r.words, (unsigned long long)vm_list_ps(&s, &t, n),
                        vm_list_words(&s, n));
            }
            vm_settings_free(&settings);
        }
}

static struct vm_length subject(const struct vm_settings *settings, enum vm_list_kind kind,
                                int field)
{
    const struct vm_monitor *m = &settings->monitor[VM_VECTOR];
    struct vm_length l = {.settings = settings, .kind = kind, .units = {100, 40, 100, 100}};
    l.steady = (struct vm_steady){.viewer = {field, 3},
                                  .glow = crt_glow_of(&m->phosphor),
                                  .cd_m2 = m->row.line_luminance.value,
                                  .at_hz = m->row.line_refresh.value,
                                  .tick = settings->tick};
    vm_steady_find(&l.steady);
    for (int t = 0; t < VM_TIMINGS; t++)
        l.timing[t] = df_timing_of_tube(&m->row, (enum df_timing_choice)t);
    return l;
}

/* The published line, for light in proportion to the rate. */
static bool seen(const struct vm_length *l, double hz)
{
    static const double m[] = {14.6, 13.83, 8.32, 6.79}, n[] = {7.00, 8.31, 9.73, 10.03};
    const struct crt_phosphor *p = &l->settings->monitor[VM_VECTOR].phosphor;
    double trolands = l->steady.cd_m2 * hz / l->steady.at_hz * 3.141592653589793 * 9 / 4;
    int field = l->steady.viewer.field;
    return m[field] + n[field] * log(trolands * crt_phosphor_c1(p, hz)) > hz;
}

static double hz_of(uint64_t ps)
{
    return 1e12 / (double)ps;
}

/* The longest list is run, and the one with an item more: the one is steady, the other flickers. */
static void the_longest_list_is_the_last_that_is_steady(void **state)
{
    (void)state;
    for (size_t i = 0; i < 3; i++) {
        struct vm_settings settings;
        resolve(&settings, tubes[i], NULL);
        for (int k = 0; k < VM_LIST_KINDS; k++)
            for (int t = 0; t < VM_TIMINGS; t++) {
                enum df_timing_choice choice = (enum df_timing_choice)t;
                struct vm_length l = subject(&settings, (enum vm_list_kind)k, (k + t) % CRT_FIELDS);
                long longest = vm_length_longest(&l, l.kind).free[t];
                struct vm_list_shape s = vm_length_shape(&l, l.kind, false);
                assert_true(longest > 100);
                assert_false(seen(&l, hz_of(run(&settings, &s, longest, choice).period)));
                assert_true(seen(&l, hz_of(run(&settings, &s, longest + 1, choice).period)));
            }
        vm_settings_free(&settings);
    }
}

/* Locked, the rate of the longest is the tick's over a whole number, and falls by a step with an item more. */
static void locked_lists_fall_by_steps(void **state)
{
    (void)state;
    struct vm_settings settings;
    resolve(&settings, "VR17", NULL);
    for (int k = 0; k < VM_LIST_KINDS; k++)
        for (int dim = 0; dim < 2; dim++) {
            struct vm_length l = subject(&settings, (enum vm_list_kind)k, 1);
            l.steady.cd_m2 = dim ? 5 : 100;
            vm_steady_find(&l.steady);
            int ticks = l.steady.ticks;
            assert_int_equal(ticks, dim ? 2 : 1);
            long longest = vm_length_longest(&l, l.kind).locked[DF_TIMING_VALUE];
            struct vm_list_shape s = vm_length_shape(&l, l.kind, true);
            double hz = hz_of(run(&settings, &s, longest, DF_TIMING_VALUE).period);
            double next = hz_of(run(&settings, &s, longest + 1, DF_TIMING_VALUE).period);
            assert_true(fabs(hz - 60.0 / ticks) < 0.01 && !seen(&l, hz));
            assert_true(fabs(next - 60.0 / (ticks + 1)) < 0.01 && seen(&l, next));
        }
    vm_settings_free(&settings);
}

/* Rows of growth say what the machine does. */
static void growth_is_what_the_machine_does(void **state)
{
    (void)state;
    struct vm_settings settings;
    struct vm_growth g;
    struct crt_error err;
    resolve(&settings, "VR17", NULL);
    struct vm_length l = subject(&settings, VM_LIST_VECTORS, 1);
    assert_true(vm_length_growth(&l, 8, true, &g, &err));
    assert_true(g.count >= 8);
    struct vm_list_shape free_running = vm_length_shape(&l, l.kind, false);
    struct vm_list_shape locked = vm_length_shape(&l, l.kind, true);
    for (int i = 0; i < g.count; i++) {
        const struct vm_growth_row *r = &g.row[i];
        long n = (long)r->amount;
        double hz = hz_of(run(&settings, &free_running, n, DF_TIMING_VALUE).period);
        double locked_hz = hz_of(run(&settings, &locked, n, DF_TIMING_VALUE).period);
        assert_true(i == 0 || r->amount > r[-1].amount);
        assert_true(fabs(r->free_hz - hz) < 1e-9 * hz && fabs(r->locked_hz - locked_hz) < 0.01);
        assert_true(r->free_flickers == seen(&l, hz) && r->locked_flickers == seen(&l, locked_hz));
    }
    free(g.row);
    vm_settings_free(&settings);
}

/* A program of so many items takes what the list takes: so many times as much of it may be shown. */
static void a_program_is_measured(void **state)
{
    (void)state;
    struct vm_settings settings;
    struct vm_input input;
    struct crt_error err;
    resolve(&settings, "LAB31", NULL);
    struct vm_length l = subject(&settings, VM_LIST_SHORT, 1);
    struct vm_list_shape s = vm_length_shape(&l, l.kind, false);
    assemble(&s, 400, &input);
    strcpy(input.name, "list.df");
    assert_true(vm_length_measure(&l, &input, &err));
    for (int t = 0; t < VM_TIMINGS; t++) {
        double list = (double)vm_list_ps(&s, &l.timing[t], 400),
               times = vm_length_times(&l, false, (enum df_timing_choice)t);
        double slack = (double)l.timing[t].settle_max_ps; /* the first refresh begins in a corner */
        assert_true(fabs((double)l.program.ps[t] - list) <= slack);
        assert_true(fabs(times - (double)l.steady.longest / list) < 0.01 * times);
    }
    assert_true(fabs(l.program.hz * (double)l.program.ps[0] * 1e-12 - 1) < 1e-6);
    df_program_free(&input.program);
    vm_settings_free(&settings);
}

static void memory_ends_lists(void **state)
{
    (void)state;
    struct vm_settings settings;
    resolve(&settings, "VR17", "memory=1K");
    struct vm_length l = subject(&settings, VM_LIST_VECTORS, 1);
    assert_true(vm_length_longest(&l, l.kind).memory_ends);
    for (int k = 0; k < VM_LIST_KINDS; k++) {
        struct vm_list_shape s = vm_length_shape(&l, (enum vm_list_kind)k, true);
        long most = vm_list_most(&s, 1024);
        assert_true(vm_list_words(&s, most) <= 512 && vm_list_words(&s, most + 2) > 512);
    }
    vm_settings_free(&settings);
}

static void light_too_dim_never_flickers(void **state)
{
    (void)state;
    struct vm_settings settings;
    resolve(&settings, "VR17", NULL);
    struct vm_length l = subject(&settings, VM_LIST_VECTORS, 1);
    l.steady.cd_m2 = 0.01;
    vm_steady_find(&l.steady);
    assert_true(l.steady.hz == VM_STEADY_LEAST_HZ && l.steady.ticks == 5);
    l.steady.cd_m2 = 100;
    l.steady.held = true;
    vm_steady_find(&l.steady);
    assert_true(fabs(l.steady.hz - crt_cff(&l.steady.viewer, 100, &l.steady.glow)) < 1e-9);
    vm_settings_free(&settings);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lists_take_what_the_machine_takes),
        cmocka_unit_test(the_longest_list_is_the_last_that_is_steady),
        cmocka_unit_test(locked_lists_fall_by_steps),
        cmocka_unit_test(growth_is_what_the_machine_does),
        cmocka_unit_test(a_program_is_measured),
        cmocka_unit_test(memory_ends_lists),
        cmocka_unit_test(light_too_dim_never_flickers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
