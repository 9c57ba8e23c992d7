/* Figures of what a photodiode saw: of every built-in phosphor at four refresh rates against closed forms of the
 * steady state; of lines and mixtures against sums over fine samples; refresh rates; samples for plots. */
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

#include "crt/spot.h"
#include "crt/waveform.h"
#include "tests/support/line_model.h"
#include "tests/support/tube_model.h"

#define PI 3.14159265358979324
#define US CRT_PS_PER_US
#define MS CRT_PS_PER_MS

static struct crt_tube *tube_of(const struct crt_tube_row *row, const struct crt_phosphor *p)
{
    struct crt_error err;
    double cell = row->spot.value / CRT_WIDTH60_SIGMA;
    struct crt_tube_desc desc = {
        .row = row,
        .phosphor = p,
        .grid = crt_grid_closeup(0, 0, 8 * cell, 8, 1),
        .epoch = {60, 1},
        .knobs = {0, 1, 0},
        .threads = 1,
    };
    struct crt_tube *tube = crt_tube_create(&desc, &err);
    assert_non_null(tube);
    return tube;
}

static struct crt_photodiode *point_at(struct crt_tube *tube, double x, double y)
{
    struct crt_error err;
    struct crt_photodiode_desc desc = {CRT_DIODE_POINT, x, y, 0};
    struct crt_photodiode *d = crt_photodiode_open(tube, &desc, &err);
    assert_non_null(d);
    return d;
}

static void point(struct crt_tube *tube, uint64_t t, uint64_t lit, uint32_t source, double x)
{
    struct crt_stroke s = {.t0 = t, .t1 = t + lit, .drive = 1, .source = source};
    s.x0 = s.x1 = (float)x;
    crt_tube_stroke(tube, &s);
}

/* ---- the steady state ---------------------------------------------------------------------------- */

/* A point lit for `dwell` seconds, `hz` times a second, in the steady state; luminance in parts of the mean. */
struct steady {
    const struct crt_phosphor *p;
    double hz, dwell;
};

/* At t seconds after the dwell ended, t < period − dwell. */
static double steady_at(const struct steady *s, double t)
{
    double sum = 0;
    for (int k = 0; k < s->p->terms; k++) {
        double tau = s->p->term[k].tau_s, w = s->p->term[k].w;
        sum += w * -expm1(-s->dwell / tau) / -expm1(-1 / (s->hz * tau)) * exp(-t / tau);
    }
    return sum / (s->dwell * s->hz);
}

static double steady_c(const struct steady *s, int n)
{
    double complex sum = 0;
    double x = PI * n * s->hz * s->dwell;
    for (int k = 0; k < s->p->terms; k++)
        sum += s->p->term[k].w / (1 + 2 * PI * n * s->hz * s->p->term[k].tau_s * I);
    return 2 * cabs(sum) * sin(x) / x;
}

/* Area above the mean over all. In the dwell the light rises above the mean at once: what is below is left out. */
static double steady_index(const struct steady *s)
{
    double a = 0, b = 1 / s->hz - s->dwell, area = 0;
    for (int i = 0; i < 200; i++)
        *(steady_at(s, (a + b) / 2) > 1 ? &a : &b) = (a + b) / 2;
    for (int k = 0; k < s->p->terms; k++) {
        double tau = s->p->term[k].tau_s, w = s->p->term[k].w;
        double rise = tau * -expm1(-s->dwell / tau), all = -expm1(-1 / (s->hz * tau));
        double left = rise / tau / all * exp(-(1 / s->hz - s->dwell) / tau);
        area += w * rise / all * -expm1(-a / tau);
        area += w * (s->dwell - rise + left * rise);
    }
    return area / s->dwell - (a + s->dwell) * s->hz;
}

static double longest_of(const struct crt_phosphor *p)
{
    double longest = 0;
    for (int k = 0; k < p->terms; k++)
        longest = fmax(longest, p->term[k].tau_s);
    return longest;
}

static double worst;

static void near(const char *what, const struct steady *s, double got, double want,
                 double tolerance)
{
    double off = fabs(got - want);
    worst = fmax(worst, off / tolerance);
    if (!(off <= tolerance))
        print_message("# %s at %g Hz: %s %.9g, want %.9g\n", s->p->name, s->hz, what, got, want);
    assert_true(off <= tolerance);
}

static void steady_state(const struct crt_tube_row *row, const struct crt_phosphor *p, unsigned hz)
{
    struct crt_tube *tube = tube_of(row, p);
    struct crt_photodiode *d = point_at(tube, 0.1, 0);
    struct steady s = {p, hz, 100e-9};
    struct crt_rate rate = {hz, 1};
    struct crt_knobs neutral = {0, 1, 0};
    struct crt_spot spot = crt_spot_at(row, &neutral, 1);
    /* 25 time constants: what is missing of the steady state is e^−25. */
    uint64_t refreshes = (uint64_t)ceil(25 * longest_of(p) * hz) + 3;
    for (uint64_t n = 0; n < refreshes; n++) {
        point(tube, crt_tick_time(rate, n), 100000, 8, 0);
        if (n % 16 == 15) {
            crt_tube_advance(tube, crt_tick_time(rate, n));
            crt_photodiode_forget(d, crt_tick_time(rate, n - 8));
        }
    }
    crt_tube_advance(tube, crt_tick_time(rate, refreshes));
    uint64_t t1 = crt_tick_time(rate, refreshes), t0 = crt_tick_time(rate, refreshes - 1);
    struct crt_waveform_figures f;
    crt_waveform_measure(d, t0, t1, hz, &f);
    double sigma = spot.sigma_mm;
    double mean = spot.power * s.dwell * hz * exp(-0.01 / (2 * sigma * sigma)) / (2 * PI * sigma * sigma);
    double peak = steady_at(&s, 0), least = steady_at(&s, 1 / s.hz - s.dwell);
    near("mean", &s, f.mean_cd_m2, mean, 1e-6 * mean);
    near("peak", &s, f.peak_cd_m2, peak * mean, 1e-6 * peak * mean);
    near("least", &s, f.least_cd_m2, least * mean, 1e-6 * peak * mean);
    near("percent flicker", &s, f.percent_flicker, 100 * (peak - least) / (peak + least), 1e-4);
    near("flicker index", &s, f.flicker_index, steady_index(&s), 2e-5);
    near("peak time", &s, f.peak_t_s, s.dwell, 1e-11);
    for (int n = 0; n < CRT_HARMONICS; n++)
        near("harmonic", &s, f.c[n], steady_c(&s, n + 1), 1e-6);
    crt_photodiode_close(d);
    crt_tube_destroy(tube);
}

static void every_phosphor(void **state)
{
    (void)state;
    struct crt_tube_row row = model_row(0.25, 0);
    static const unsigned rates[] = {30, 50, 60, 75};
    size_t count;
    const struct crt_phosphor *p = crt_phosphors(&count);
    for (size_t i = 0; i < count; i++)
        for (int r = 0; r < 4; r++)
            steady_state(&row, &p[i], rates[r]);
    print_message("# %d phosphors; the worst is off by %.2g of what is allowed\n", (int)count,
                  worst);
}

/* The peak of one short flash, down to a tenth. */
static void persistence(void **state)
{
    (void)state;
    struct crt_tube_row row = model_row(0.25, 0);
    size_t count;
    const struct crt_phosphor *p = crt_phosphors(&count);
    for (size_t i = 0; i < count; i++) {
        struct crt_tube *tube = tube_of(&row, &p[i]);
        struct crt_photodiode *d = point_at(tube, 0, 0);
        struct crt_waveform_figures f;
        point(tube, MS, 10, 8, 0);
        crt_tube_advance(tube, 5 * MS);
        crt_waveform_measure(d, 0, 5 * MS, 60, &f);
        double want = crt_phosphor_decay_time(&p[i], 0.1);
        assert_true(fabs(f.persistence_10_s / want - 1) < 1e-3);
        crt_photodiode_close(d);
        crt_tube_destroy(tube);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_phosphor),
        cmocka_unit_test(persistence),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
