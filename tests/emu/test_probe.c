/* A photodiode at a head: its report against closed forms of short pulses through each phosphor. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <complex.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emu/lab/probe.h"
#include "emu/lab/probe_signal.h"
#include "tests/support/dpu_invariants.h"
#include "tests/support/source.h"

#define COUNT(a) (sizeof(a) / sizeof *(a))
#define PI       3.14159265358979323846

static const char dot[] = "        .tube \"VR17\"\n"
                          "        .start again\n"
                          "again:  sync italics=off\n"
                          "        point i=7 pen=off blink=off line=solid\n"
                          "        plot 512, 512\n"
                          "        jump again\n";

/* In every second refresh only. */
static const char seldom[] = "        .tube \"VR17\"\n"
                             "        .start again\n"
                             "again:  sync italics=off\n"
                             "        point i=7 pen=off blink=off line=solid\n"
                             "        plot 512, 512\n"
                             "        sync italics=off\n"
                             "        point i=7\n"
                             "        plot 100, 100\n"
                             "        jump again\n";

/* Dots on one after another for half of the time, far apart. */
static const char long_list[] = "        .tube \"VR17\"\n"
                                "        .start again\n"
                                "again:  sync italics=off\n"
                                "        point i=7 pen=off blink=off line=solid\n"
                                "        .repeat 600, K\n"
                                "        plot 512 + 400*cos(K*7.3), 512 + 400*sin(K*7.3)\n"
                                "        .endr\n"
                                "        jump again\n";

struct bench {
    struct vm_input input;
    struct vm_settings settings;
    struct vm_rig rig;
    struct vm_probe probe;
};

static struct vm_settings_options plain(const char *phosphor, unsigned hz)
{
    return (struct vm_settings_options){.phosphor = phosphor, .refresh = {hz, 1}, .threads = 1};
}

/* Points take long, so that a list of a few hundred of them fills half a refresh. */
static struct vm_settings_options slow(const char *phosphor, unsigned hz)
{
    struct vm_settings_options options = plain(phosphor, hz);
    options.set = (struct vm_list){{"point=10us"}, 1};
    return options;
}

static const struct vm_probe_place middle = {VM_VECTOR, CRT_DIODE_POINT, 512, 512, 0, false, 0, 0};

/* `small`: a grid of a few cells, as the command has. */
static struct bench *bench_open(const char *text, const struct vm_settings_options *options,
                                const struct vm_probe_place *place, bool small)
{
    struct crt_error err;
    struct bench *b = calloc(1, sizeof *b);
    assert_non_null(b);
    source_program(text, &b->input.program);
    snprintf(b->input.name, sizeof b->input.name, "test.df");
    assert_int_equal(vm_settings_resolve(options, NULL, "VR17", &b->settings, &err), 0);
    struct vm_tubes tubes = vm_settings_tubes(&b->settings, VM_VIEW_VECTOR);
    if (small)
        tubes.desc[VM_VECTOR].grid = crt_grid_closeup(0, 0, 1, 8, 8);
    assert_true(vm_rig_open(&b->rig, &b->settings, &b->input, DF_TIMING_VALUE, &tubes, &err));
    if (place)
        assert_true(vm_probe_open(&b->probe, &b->rig, place, &err));
    return b;
}

static void bench_close(struct bench *b)
{
    vm_probe_close(&b->probe);
    vm_rig_close(&b->rig);
    vm_settings_free(&b->settings);
    df_program_free(&b->input.program);
    free(b);
}

static struct vm_probe_report report_of(struct bench *b, uint64_t t0, uint64_t t1)
{
    struct vm_probe_report report;
    struct crt_error err;
    assert_true(vm_probe_report(&b->probe, t0, t1, &report, &err));
    return report;
}

/* ---- closed forms, written anew ------------------------------------------------------------------ */

static double c_n(const struct crt_phosphor *p, double hz, int n)
{
    double complex sum = 0;
    for (int k = 0; k < p->terms; k++)
        sum += p->term[k].w / (1 + I * 2 * PI * n * hz * p->term[k].tau_s);
    return 2 * cabs(sum);
}

/* Light a time t after a pulse in the steady state, as a multiple of the mean; and its integral from there
 * to the next pulse. */
static double light(const struct crt_phosphor *p, double hz, double t)
{
    double sum = 0;
    for (int k = 0; k < p->terms; k++) {
        double tau = p->term[k].tau_s;
        sum += p->term[k].w / (tau * hz) * exp(-t / tau) / -expm1(-1 / (hz * tau));
    }
    return sum;
}

static double share_until(const struct crt_phosphor *p, double hz, double t)
{
    double sum = 0;
    for (int k = 0; k < p->terms; k++) {
        double tau = p->term[k].tau_s;
        sum += p->term[k].w * expm1(-t / tau) / expm1(-1 / (hz * tau));
    }
    return sum;
}

static double index_of(const struct crt_phosphor *p, double hz)
{
    double low = 0, high = 1 / hz;
    for (int i = 0; i < 200; i++) {
        double t = (low + high) / 2;
        *(light(p, hz, t) > 1 ? &low : &high) = t;
    }
    return share_until(p, hz, low) - low * hz;
}

static double percent_of(const struct crt_phosphor *p, double hz)
{
    double most = light(p, hz, 0), least = light(p, hz, 1 / hz);
    return 100 * (most - least) / (most + least);
}

static void near(const char *what, const char *phosphor, unsigned hz, double got, double want)
{
    if (fabs(got - want) <= 0.01 * fabs(want))
        return;
    fail_msg("%s of %s at %u Hz: %.9g, not %.9g", what, phosphor, hz, got, want);
}

/* ---- tests --------------------------------------------------------------------------------------- */

static void every_phosphor_is_as_its_closed_forms(void **state)
{
    (void)state;
    static const unsigned rates[] = {30, 50, 60, 75};
    size_t count, done = 0;
    const struct crt_phosphor *all = crt_phosphors(&count);
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < COUNT(rates); k++) {
            const struct crt_phosphor *p = &all[i];
            double slowest = 0;
            for (int t = 0; t < p->terms; t++)
                slowest = fmax(slowest, p->term[t].tau_s);
            struct vm_settings_options options = plain(p->name, rates[k]);
            struct bench *b = bench_open(dot, &options, &middle, true);
            uint64_t t0 = (uint64_t)(10 * fmin(fmax(slowest, 0.02), 2) * 1e12);
            vm_machine_run(b->rig.machine, t0);
            vm_probe_forget(&b->probe, t0);
            vm_probe_run(&b->probe, b->rig.machine, t0 + CRT_PS_PER_S / 5);
            struct vm_probe_report r = report_of(b, t0, t0 + CRT_PS_PER_S / 5);
            near("refresh", p->name, rates[k], r.refresh_hz, rates[k]);
            assert_int_equal(r.periods, rates[k] / 5);
            assert_true(r.settled);
            for (int n = 1; n <= 4; n++)
                near("harmonic", p->name, rates[k], r.figures.c[n - 1], c_n(p, rates[k], n));
            near("percent flicker", p->name, rates[k], r.figures.percent_flicker,
                 percent_of(p, rates[k]));
            near("flicker index", p->name, rates[k], r.figures.flicker_index,
                 index_of(p, rates[k]));
            bench_close(b);
            done++;
        }
    assert_true(done >= 25 * COUNT(rates));
}

static void the_eye_sees_what_the_closed_form_says(void **state)
{
    (void)state;
    /* crt-physics: 30 degrees, 100 cd/m², 3 mm; each to half a hertz. */
    static const struct {
        const char *phosphor;
        double hz;
    } known[] = {{"P4", 71}, {"P31", 69.5}, {"P1", 61}, {"P39", 49}};
    for (size_t i = 0; i < COUNT(known); i++) {
        struct vm_settings_options options = plain(known[i].phosphor, 60);
        struct bench *b = bench_open(dot, &options, &middle, true);
        b->probe.eye_cd_m2 = 100;
        vm_probe_run(&b->probe, b->rig.machine, CRT_PS_PER_S);
        struct vm_probe_report r = report_of(b, CRT_PS_PER_S / 2, CRT_PS_PER_S);
        assert_true(fabs(r.cff_hz - known[i].hz) <= 0.5);
        assert_int_equal(r.cff_harmonic, 1);
        assert_int_equal(r.flickers, known[i].hz > 60);
        assert_true(isnan(r.svm));
        bench_close(b);
    }
}

static void a_place_that_is_lit_every_second_time_has_half_the_rate(void **state)
{
    (void)state;
    struct vm_settings_options options = plain("P31", 60);
    struct bench *b = bench_open(seldom, &options, &middle, true);
    vm_probe_run(&b->probe, b->rig.machine, CRT_PS_PER_S);
    struct vm_probe_report r = report_of(b, CRT_PS_PER_S / 2, CRT_PS_PER_S);
    near("rate", "P31", 30, r.figures.hz, 30);
    assert_int_equal(r.periods, 15);
    near("harmonic", "P31", 30, r.figures.c[0], c_n(b->probe.phosphor, 30, 1));
    bench_close(b);
}

static void same_doubles(const struct vm_probe_report *a, const struct vm_probe_report *b)
{
    assert_int_equal(a->t0, b->t0);
    assert_int_equal(a->t1, b->t1);
    assert_true(a->refresh_hz == b->refresh_hz && a->repeats_hz == b->repeats_hz);
    assert_memory_equal(&a->figures, &b->figures, sizeof a->figures);
    assert_true(a->cff_hz == b->cff_hz && a->flickers == b->flickers);
}

/* A window has all cells and runs from picture to picture. */
static void a_window_and_the_command_see_the_same(void **state)
{
    (void)state;
    struct vm_settings_options options = slow("P1", 60);
    const struct vm_probe_place places[] = {middle,
                                            {VM_VECTOR, CRT_DIODE_DISC, 910, 500, 5, false, 0, 0},
                                            {VM_VECTOR, CRT_DIODE_SCREEN, 0, 0, 0, false, 0, 0}};
    for (size_t i = 0; i < COUNT(places); i++) {
        const char *text = i ? long_list : dot;
        struct bench *a = bench_open(text, &options, &places[i], true),
                     *b = bench_open(text, &options, &places[i], false);
        uint64_t t0 = CRT_PS_PER_S / 5, t1 = t0 + CRT_PS_PER_S / 10;
        vm_probe_run(&a->probe, a->rig.machine, t1);
        for (uint64_t t = 0; t < t1;) {
            t = t + 17 * CRT_PS_PER_MS < t1 ? t + 17 * CRT_PS_PER_MS : t1;
            vm_machine_run(b->rig.machine, t);
            vm_probe_watch(&b->probe, b->rig.machine);
        }
        struct vm_probe_report ra = report_of(a, t0, t1), rb = report_of(b, t0, t1);
        assert_false(ra.dark);
        same_doubles(&ra, &rb);
        bench_close(a);
        bench_close(b);
    }
}

/* A click: what glowed before comes from the planes, on the tube's own cells. */
static void a_probe_that_comes_late_sees_nearly_the_same(void **state)
{
    (void)state;
    struct vm_settings_options options = plain("P39", 60);
    struct bench *a = bench_open(dot, &options, &middle, true),
                 *b = bench_open(dot, &options, NULL, false);
    struct crt_error err;
    uint64_t t0 = CRT_PS_PER_S / 2, t1 = t0 + CRT_PS_PER_S / 10;
    vm_probe_run(&a->probe, a->rig.machine, t1);
    vm_machine_run(b->rig.machine, t0);
    assert_true(vm_probe_open(&b->probe, &b->rig, &middle, &err));
    vm_probe_run(&b->probe, b->rig.machine, t1);
    struct vm_probe_report ra = report_of(a, t0, t1), rb = report_of(b, t0, t1);
    near("mean", "P39", 60, rb.figures.mean_cd_m2, ra.figures.mean_cd_m2);
    assert_true(fabs(rb.figures.c[0] / ra.figures.c[0] - 1) < 0.02);
    bench_close(a);
    bench_close(b);
}

static void forgetting_changes_nothing_that_comes_later(void **state)
{
    (void)state;
    struct vm_settings_options options = plain("P1", 50);
    struct bench *a = bench_open(long_list, &options, &middle, true),
                 *b = bench_open(long_list, &options, &middle, true);
    struct bench *both[] = {a, b};
    uint64_t t0 = CRT_PS_PER_S / 2, t1 = t0 + CRT_PS_PER_S / 5;
    for (int i = 0; i < 2; i++) {
        both[i]->probe.place = both[0]->probe.place;
        for (uint64_t t = CRT_PS_PER_S / 30; t < t0; t += CRT_PS_PER_S / 30) {
            vm_probe_run(&both[i]->probe, both[i]->rig.machine, t);
            if (i)
                vm_probe_forget(&both[i]->probe, t);
        }
        vm_probe_run(&both[i]->probe, both[i]->rig.machine, t1);
    }
    struct vm_probe_report ra = report_of(a, t0, t1), rb = report_of(b, t0, t1);
    assert_int_equal(ra.t1, rb.t1);
    if (!ra.dark)
        assert_true(fabs(rb.figures.mean_cd_m2 / ra.figures.mean_cd_m2 - 1) < 1e-9);
    assert_int_equal(ra.dark, rb.dark);
    bench_close(a);
    bench_close(b);
}

/* Whole periods are cut out of whatever is asked for, and always give the same figures. */
static void any_time_gives_whole_periods(void **state)
{
    (void)state;
    struct vm_settings_options options = plain("P1", 60);
    struct bench *b = bench_open(dot, &options, &middle, true);
    uint64_t seed = 11;
    vm_probe_run(&b->probe, b->rig.machine, CRT_PS_PER_S);
    for (int i = 0; i < 100; i++) {
        uint64_t t0 = CRT_PS_PER_S / 2 + dpu_random(&seed) % (CRT_PS_PER_S / 4),
                 t1 = t0 + 1 + dpu_random(&seed) % (CRT_PS_PER_S / 4);
        struct vm_probe_report r = report_of(b, t0, t1);
        assert_int_equal(r.periods, (t1 - t0) * 60 / CRT_PS_PER_S);
        assert_true(r.t0 == t0 && r.t1 <= t1 && r.t1 > t0);
        if (r.periods == 0) {
            assert_true(isnan(r.figures.c[0]) && isnan(r.cff_hz) && !r.flickers);
            continue;
        }
        assert_true(fabs((double)(r.t1 - r.t0) * 60e-12 - (double)r.periods) < 1e-9);
        near("harmonic", "P1", 60, r.figures.c[0], c_n(b->probe.phosphor, 60, 1));
    }
    bench_close(b);
}

/* Two lists in turn, as double-buffered firmware has them: alike but for a hair, and unlike. */
static void twice_is_slower_only_where_it_shows(void **state)
{
    (void)state;
    static const char turns[] = ".tube \"VR17\"\n.start a\n"
                                "a: sync italics=off\n point i=7 pen=off blink=off line=solid\n"
                                " plot 512, 512\n"
                                "b: sync italics=off\n point i=%d pen=off blink=off line=solid\n"
                                " plot 512, 512\n jump a\n";
    for (int i = 0; i < 2; i++) {
        char text[400];
        snprintf(text, sizeof text, turns, i ? 2 : 7);
        struct vm_settings_options options = plain("P39", 60);
        struct bench *b = bench_open(text, &options, &middle, true);
        vm_probe_run(&b->probe, b->rig.machine, 2 * CRT_PS_PER_S);
        struct vm_probe_report r = report_of(b, CRT_PS_PER_S, 2 * CRT_PS_PER_S);
        near("turns", "P39", 60, r.figures.hz, i ? 30 : 60);
        assert_true(r.known && r.cff_of_hz == r.cff_harmonic * r.figures.hz);
        bench_close(b);
    }
}

/* A tube just switched on brightens, and one left alone fades: neither is flicker. */
static void drift_is_no_flicker(void **state)
{
    (void)state;
    struct vm_settings_options options = plain("P39", 60);
    struct bench *b = bench_open(dot, &options, &middle, true);
    vm_probe_run(&b->probe, b->rig.machine, 2 * CRT_PS_PER_S);
    struct vm_probe_report r = report_of(b, 0, CRT_PS_PER_S / 10);
    assert_true(!r.known && !r.settled && !r.flickers && r.drift > 0.1);
    assert_true(isnan(r.figures.c[0]) && isnan(r.figures.percent_flicker) && isnan(r.cff_hz));
    r = report_of(b, CRT_PS_PER_S, 2 * CRT_PS_PER_S);
    assert_true(r.known && r.settled);
    bench_close(b);
}

/* Many more refreshes than are kept. */
static void the_rate_is_known_after_a_long_time(void **state)
{
    (void)state;
    struct vm_settings_options options = plain("P31", 75);
    struct bench *b = bench_open(dot, &options, &middle, true);
    uint64_t second = CRT_PS_PER_S;
    for (uint64_t t = 1; t <= 20; t++) {
        vm_probe_run(&b->probe, b->rig.machine, t * second);
        vm_probe_forget(&b->probe, (t - 1) * second + second / 2);
        near("rate", "P31", 75, vm_probe_hz(&b->probe, t * second - second / 4, t * second), 75);
    }
    bench_close(b);
}

static double trapezoid(const struct vm_probe_wave *w)
{
    double sum = 0;
    for (size_t i = 1; i < w->count; i++)
        sum += (w->cd_m2[i] + w->cd_m2[i - 1]) / 2 * (double)(w->t[i] - w->t[i - 1]);
    return sum / (double)(w->t[w->count - 1] - w->t[0]);
}

static void samples_carry_the_light(void **state)
{
    (void)state;
    static const char *const phosphors[] = {"P46", "P4", "P7", "P31", "P39"};
    for (size_t i = 0; i < COUNT(phosphors); i++)
        for (int whole = 0; whole < (i < 2 ? 2 : 1); whole++) {
            const struct vm_probe_place all = {VM_VECTOR, CRT_DIODE_SCREEN, 0, 0, 0, false, 0, 0};
            struct vm_settings_options options = plain(phosphors[i], 60);
            struct bench *b =
                bench_open(whole ? long_list : dot, &options, whole ? &all : &middle, true);
            struct vm_probe_wave wave;
            struct crt_error err;
            uint64_t t0 = CRT_PS_PER_S / 5, t1 = t0 + CRT_PS_PER_S / 10;
            vm_probe_run(&b->probe, b->rig.machine, t1);
            struct vm_probe_report r = report_of(b, t0, t1);
            assert_true(vm_probe_wave(&b->probe, t0, t1, 0, &wave, &err));
            near("mean of samples", phosphors[i], 60, trapezoid(&wave), r.figures.mean_cd_m2);
            double most = 0, parts = 0;
            for (size_t n = 0; n < wave.count; n++) {
                assert_true(n == 0 || wave.t[n] > wave.t[n - 1]);
                most = fmax(most, wave.cd_m2[n]);
                parts = 0;
                for (int c = 0; c < wave.colours; c++)
                    parts += wave.colour[c][n];
                assert_true(fabs(parts - wave.cd_m2[n]) <= 1e-12 * wave.cd_m2[n]);
            }
            near("peak of samples", phosphors[i], 60, most, r.figures.peak_cd_m2);
            assert_true(wave.t[0] == t0 && wave.t[wave.count - 1] == t1);
            vm_probe_wave_free(&wave);
            assert_true(vm_probe_wave(&b->probe, t0, t1, 12345, &wave, &err));
            assert_int_equal(wave.count, 1235); /* 0, 1/12345, … 1234/12345 */
            assert_int_equal(wave.t[1], t0 + 81004455);
            vm_probe_wave_free(&wave);
            bench_close(b);
        }
}

static void a_long_list_is_steadier_as_a_whole(void **state)
{
    (void)state;
    const struct vm_probe_place all = {VM_VECTOR, CRT_DIODE_SCREEN, 0, 0, 0, false, 0, 0},
                                one = {VM_VECTOR, CRT_DIODE_POINT, 912, 512, 0, false, 0, 0};
    struct vm_settings_options options = slow("P31", 60);
    struct bench *a = bench_open(long_list, &options, &all, true),
                 *b = bench_open(long_list, &options, &one, true);
    vm_probe_run(&a->probe, a->rig.machine, CRT_PS_PER_S);
    vm_probe_run(&b->probe, b->rig.machine, CRT_PS_PER_S);
    struct vm_probe_report ra = report_of(a, CRT_PS_PER_S / 2, CRT_PS_PER_S),
                           rb = report_of(b, CRT_PS_PER_S / 2, CRT_PS_PER_S);
    assert_true(ra.figures.c[0] < 0.8 * rb.figures.c[0]);
    assert_true(ra.figures.percent_flicker < rb.figures.percent_flicker);
    assert_true(ra.figures.mean_cd_m2 < rb.figures.mean_cd_m2 / 10);
    bench_close(a);
    bench_close(b);
}

static void darkness_is_told(void **state)
{
    (void)state;
    const struct vm_probe_place corner = {VM_VECTOR, CRT_DIODE_POINT, 20, 20, 0, false, 0, 0},
                                beside = {VM_VECTOR, CRT_DIODE_POINT, 5000, 20, 0, false, 0, 0},
                                raster = {VM_RASTER, CRT_DIODE_POINT, 20, 20, 0, false, 0, 0};
    struct vm_settings_options options = plain("P31", 60);
    struct bench *b = bench_open(dot, &options, &corner, true);
    struct vm_probe none;
    struct crt_error err;
    vm_probe_run(&b->probe, b->rig.machine, CRT_PS_PER_S / 2);
    struct vm_probe_report r = report_of(b, 0, CRT_PS_PER_S / 2);
    assert_true(r.dark && !r.settled && !r.flickers && r.figures.mean_cd_m2 == 0);
    assert_false(vm_probe_open(&none, &b->rig, &beside, &err));
    assert_non_null(strstr(err.text, "beside the screen"));
    assert_false(vm_probe_open(&none, &b->rig, &raster, &err));
    assert_non_null(strstr(err.text, "no tube"));
    bench_close(b);
}

/* The beam itself: where strokes are, the signals are theirs. */
struct check {
    struct vm_signals *signals;
    size_t strokes;
};

static void check_stroke(void *ctx, const struct crt_stroke *s)
{
    struct check *check = ctx;
    const struct vm_signals *g = check->signals;
    if (s->t0 < CRT_PS_PER_S / 4 || s->t1 > CRT_PS_PER_S / 3)
        return;
    for (int i = 0; i <= 4; i++) {
        uint64_t t = s->t0 + (s->t1 - s->t0) * (uint64_t)i / 4;
        double part = (double)(t - s->t0) / (double)(s->t1 - s->t0);
        double x = (double)s->x0 + part * (double)(s->x1 - s->x0),
               y = (double)s->y0 + part * (double)(s->y1 - s->y0);
        assert_true(fabs(vm_trace_before(&g->x, t) - x) < 1e-4 || i == 0);
        assert_true(fabs(vm_trace_at(&g->x, t) - x) < 1e-4 || i == 4);
        assert_true(fabs(vm_trace_before(&g->y, t) - y) < 1e-4 || i == 0);
        if (i < 4)
            assert_true(fabs(vm_trace_at(&g->z[0], t) - (double)s->drive) < 1e-6);
    }
    check->strokes++;
}

static void signals_follow_the_beam(void **state)
{
    (void)state;
    static const char lines[] = "        .tube \"VR17\"\n"
                                "        .start again\n"
                                "again:  sync italics=off\n"
                                "        .repeat 40, K\n"
                                "        point i=K%8 pen=off blink=off line=dotdash\n"
                                "        at 37*K%1000, 71*K%1000\n"
                                "        longv\n"
                                "        draw 20, K-20\n"
                                "        move 3, 9\n"
                                "        draw -20, 11\n"
                                "        char\n"
                                "        text \"K\"\n"
                                "        .endr\n"
                                "        jump again\n";
    struct vm_settings_options options = plain("P31", 60);
    struct bench *a = bench_open(lines, &options, NULL, true),
                 *b = bench_open(lines, &options, NULL, true);
    struct vm_signals signals;
    struct crt_error err;
    assert_true(
        vm_signals_record(&signals, &a->rig, VM_VECTOR, CRT_PS_PER_S / 4, CRT_PS_PER_S / 3, &err));
    struct check check = {&signals, 0};
    vm_machine_trace(
        b->rig.machine, CRT_PS_PER_S / 2,
        &(struct vm_hooks){&check, NULL, check_stroke, NULL, NULL, NULL, NULL, NULL, NULL});
    assert_true(check.strokes > 1000);
    double lit = 0;
    for (size_t i = 1; i < signals.z[0].count; i++)
        lit += signals.z[0].v[i] > 0 && signals.z[0].v[i - 1] > 0
                   ? (double)(signals.z[0].t[i] - signals.z[0].t[i - 1])
                   : 0;
    for (size_t i = 1; i < signals.x.count; i++)
        assert_true(signals.x.t[i] >= signals.x.t[i - 1]);
    assert_true(lit > 0);
    vm_signals_free(&signals);
    bench_close(a);
    bench_close(b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_phosphor_is_as_its_closed_forms),
        cmocka_unit_test(the_eye_sees_what_the_closed_form_says),
        cmocka_unit_test(a_place_that_is_lit_every_second_time_has_half_the_rate),
        cmocka_unit_test(a_window_and_the_command_see_the_same),
        cmocka_unit_test(a_probe_that_comes_late_sees_nearly_the_same),
        cmocka_unit_test(forgetting_changes_nothing_that_comes_later),
        cmocka_unit_test(any_time_gives_whole_periods),
        cmocka_unit_test(twice_is_slower_only_where_it_shows),
        cmocka_unit_test(drift_is_no_flicker),
        cmocka_unit_test(the_rate_is_known_after_a_long_time),
        cmocka_unit_test(samples_carry_the_light),
        cmocka_unit_test(a_long_list_is_steadier_as_a_whole),
        cmocka_unit_test(darkness_is_told),
        cmocka_unit_test(signals_follow_the_beam),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
