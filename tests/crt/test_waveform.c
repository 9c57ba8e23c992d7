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
#include "tests/support/diode_rig.h"
#include "tests/support/line_model.h"
#include "tests/support/tube_model.h"

#define PI 3.14159265358979324

static struct crt_tube *tube_of(const struct crt_tube_row *row, const struct crt_phosphor *p)
{
    return vector_tube(row, p, 8, 1);
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
    double mean =
        spot.power * s.dwell * hz * exp(-0.01 / (2 * sigma * sigma)) / (2 * PI * sigma * sigma);
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

/* The rows of the physics notes at 60 Hz, to their printed digits: C1, percent flicker, flicker index. */
static void worked_rows(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        double c1, percent, index, digit[3];
    } want[] = {
        {"P31", 1.19, 99, .50, {.005, .5, .005}}, {"P4", 1.41, 99.6, .59, {.005, .05, .005}},
        {"P1", .445, 61, .17, {.0005, .5, .005}}, {"P43", 1.96, 100, .86, {.005, .5, .005}},
        {"P53", 1.31, 99, .51, {.005, .5, .005}}, {"P39", .081, 12.7, .032, {.0005, .05, .0005}}};
    struct crt_tube_row row = model_row(0.25, 0);
    struct crt_rate rate = {60, 1};
    for (size_t i = 0; i < sizeof want / sizeof want[0]; i++) {
        const struct crt_phosphor *p = crt_phosphor_find(want[i].name);
        struct crt_tube *tube = tube_of(&row, p);
        struct crt_photodiode *d = point_at(tube, 0, 0);
        for (uint64_t n = 0; n < 200; n++)
            point(tube, crt_tick_time(rate, n), 100000, 8, 0);
        crt_tube_advance(tube, crt_tick_time(rate, 200));
        struct crt_waveform_figures f;
        uint64_t t0 = crt_tick_time(rate, 180), t1 = crt_tick_time(rate, 200);
        double hz = crt_waveform_repeats_hz(d, 0, t1, 0);
        assert_true(fabs(hz - 60) < 1e-6);
        crt_waveform_measure(d, t0, t1, hz, &f);
        print_message("# %s: C1 %.4f, %.2f %%, index %.4f\n", want[i].name, f.c[0],
                      f.percent_flicker, f.flicker_index);
        assert_true(fabs(f.c[0] - want[i].c1) <= want[i].digit[0] * 1.01);
        assert_true(fabs(f.percent_flicker - want[i].percent) <= want[i].digit[1] * 1.01);
        assert_true(fabs(f.flicker_index - want[i].index) <= want[i].digit[2] * 1.01);
        crt_photodiode_close(d);
        crt_tube_destroy(tube);
    }
}

/* ---- against sums over samples ------------------------------------------------------------------------ */

/* Slow strokes and quick terms: light rises, stays and falls while pieces are drawn. */
static void as_fine_samples_say(void **state)
{
    (void)state;
    const double w[] = {0.4, 0.4, 0.2}, tau[] = {0.0005, 0.02, 3};
    struct crt_phosphor p = model_phosphor(3, w, tau);
    struct crt_tube_row row = model_row(0.25, 0);
    for (int n = 0; n < 4; n++) {
        struct crt_tube *tube = tube_of(&row, &p);
        struct crt_photodiode *d = point_at(tube, 0.1, 0.05);
        uint64_t t = 0;
        uint32_t seed = 40 + (uint32_t)n;
        for (int i = 0; i < 8; i++) {
            struct crt_stroke s = {.t0 = t, .drive = (float)model_uniform(&seed, 0.7, 1)};
            s.x0 = (float)model_uniform(&seed, -2, 0.3);
            s.x1 = i % 3 == 0 ? s.x0 : (float)model_uniform(&seed, 0.2, 2);
            s.y0 = s.y1 = i % 3 == 0 ? 0 : (float)model_uniform(&seed, -0.3, 0.3);
            s.t1 = t += (uint64_t)model_uniform(&seed, 1, n < 2 ? 4 : 60) * US;
            crt_tube_stroke(tube, &s);
            t += (uint64_t)(model_uniform(&seed, 0, 60) * (double)US);
        }
        crt_tube_advance(tube, t);
        struct crt_waveform_figures f;
        const size_t samples = 100000;
        double *l = malloc(samples * sizeof *l), mean = 0, peak = 0, least = 1e300, above = 0;
        crt_waveform_measure(d, 0, t, 1000, &f);
        assert_non_null(l);
        crt_waveform_sample(d, 0, t, samples, l);
        for (size_t i = 0; i < samples; i++) {
            mean += l[i] / (double)samples;
            peak = fmax(peak, l[i]);
            least = fmin(least, l[i]);
        }
        for (size_t i = 0; i < samples; i++)
            above += fmax(l[i] - mean, 0) / (double)samples / mean;
        assert_true(fabs(f.mean_cd_m2 / mean - 1) < 1e-4);
        assert_true(f.peak_cd_m2 >= peak * (1 - 1e-9) && f.peak_cd_m2 < peak * (1 + 1e-3));
        assert_true(f.least_cd_m2 <= least * (1 + 1e-9) && f.least_cd_m2 > least - 1e-3 * mean);
        assert_true(fabs(f.flicker_index - above) < 1e-4);
        uint64_t at = (uint64_t)(f.peak_t_s * 1e12 + 0.5);
        assert_true(fabs(crt_photodiode_luminance(d, at) / f.peak_cd_m2 - 1) < 1e-9);
        free(l);
        crt_photodiode_close(d);
        crt_tube_destroy(tube);
    }
}

/* Columns of a plot have all the extremes that fine samples have, and hardly more. */
static void ranges_keep_peaks(void **state)
{
    (void)state;
    const double w[] = {1}, tau[] = {0.0001}; /* 100 ns */
    struct crt_phosphor p = model_phosphor(1, w, tau);
    struct crt_tube_row row = model_row(0.25, 0);
    struct crt_tube *tube = tube_of(&row, &p);
    struct crt_photodiode *d = point_at(tube, 0, 0);
    for (int i = 0; i < 10; i++)
        point(tube, (uint64_t)i * MS + 13 * US, 50000, 8, 0);
    crt_tube_advance(tube, 10 * MS);
    struct crt_waveform_range range[100];
    crt_waveform_ranges(d, 0, 10 * MS, 100, range);
    double peak = crt_photodiode_luminance(d, 13 * US + 50000);
    assert_true(peak > 0);
    for (int i = 0; i < 100; i++) {
        double want = i % 10 == 0 ? peak : crt_photodiode_luminance(d, (uint64_t)i * 100 * US);
        assert_true(fabs(range[i].most - want) < 1e-9 * peak);
        double end = crt_photodiode_luminance(d, (uint64_t)(i + 1) * 100 * US);
        double least = i % 10 == 0 ? crt_photodiode_luminance(d, (uint64_t)i * 100 * US) : end;
        assert_true(fabs(range[i].least - fmin(least, end)) < 1e-9 * peak);
    }
    crt_photodiode_close(d);
    crt_tube_destroy(tube);
}

/* ---- how often it repeats -------------------------------------------------------------------------------- */

/* A refresh of vectors (rest, move, rest, each of one word) and a word of many equal dots. */
static uint64_t refresh(struct crt_tube *tube, uint64_t t, int words, int dots, float shift)
{
    for (int i = 0; i < words; i++) {
        struct crt_stroke s = {.t0 = t, .t1 = t + 2 * US, .drive = 1, .source = (uint32_t)i * 4};
        s.x0 = s.x1 = -1;
        s.y0 = s.y1 = shift;
        crt_tube_stroke(tube, &s);
        s = (struct crt_stroke){s.t1, s.t1 + 9 * US, -1, shift, 1, shift, 1, s.source, 0};
        crt_tube_stroke(tube, &s);
        s = (struct crt_stroke){s.t1, s.t1 + 2 * US, 1, shift, 1, shift, 1, s.source, 0};
        crt_tube_stroke(tube, &s);
        t = s.t1 + 5 * US;
    }
    for (int i = 0; i < dots; i++, t += 2 * US)
        point(tube, t, US, 1000, 0);
    return t;
}

static void vectors_repeat(void **state)
{
    (void)state;
    const double w[] = {1}, tau[] = {1};
    struct crt_phosphor p = model_phosphor(1, w, tau);
    struct crt_tube_row row = model_row(0.25, 0);
    static const struct {
        int words, dots;
        bool moves, pauses;
    } c[] = {{1, 0, 0, 0}, {3, 0, 0, 0},   {0, 1, 0, 0},  {0, 35, 0, 0}, {2, 90, 0, 0},
             {3, 5, 1, 0}, {0, 200, 0, 0}, {0, 35, 0, 1}, {2, 0, 1, 1},  {0, 60, 0, 1}};
    for (size_t i = 0; i < sizeof c / sizeof c[0]; i++)
        for (int where = 0; where < 2; where++) {
            struct crt_tube *tube = tube_of(&row, &p);
            struct crt_photodiode *d = point_at(tube, where ? 0.9 : 0, 0.1);
            uint32_t seed = 3;
            for (uint64_t n = 0; n < 60; n++) {
                uint64_t t = crt_tick_time((struct crt_rate){40, 1}, n);
                t += c[i].pauses && n >= 30 ? CRT_PS_PER_S : 0;
                float shift = c[i].moves ? (float)model_uniform(&seed, -0.3, 0.3) : 0;
                refresh(tube, t, c[i].words, c[i].dots, shift);
            }
            crt_tube_advance(tube, 4 * CRT_PS_PER_S);
            double hz = crt_waveform_repeats_hz(d, 0, 4 * CRT_PS_PER_S, 0);
            if (!(fabs(hz / 40 - 1) < 1e-4))
                print_message("# case %zu at %d: %g Hz\n", i, where, hz);
            assert_true(fabs(hz / 40 - 1) < 1e-4);
            crt_photodiode_close(d);
            crt_tube_destroy(tube);
        }
}

/* The same with the refresh known; of less than a refresh nothing repeats. */
static void pieces_of_a_refresh_are_no_repeats(void **state)
{
    (void)state;
    const double w[] = {1}, tau[] = {1};
    struct crt_phosphor p = model_phosphor(1, w, tau);
    struct crt_tube_row row = model_row(0.25, 0);
    for (int dots = 1; dots <= 200; dots = dots * 3 + 1)
        for (int changes = 0; changes < 2; changes++) {
            struct crt_tube *tube = tube_of(&row, &p);
            struct crt_photodiode *d = point_at(tube, 0, 0.1);
            uint32_t seed = 5;
            for (uint64_t n = 0; n < 8; n++) {
                uint64_t t = crt_tick_time((struct crt_rate){40, 1}, n);
                int more = changes ? (int)model_uniform(&seed, 0, dots) : 0;
                refresh(tube, t, changes ? 1 : 0, dots + more, 0);
            }
            crt_tube_advance(tube, 200 * MS);
            double hz = crt_waveform_repeats_hz(d, 0, 200 * MS, 40);
            if (!(fabs(hz / 40 - 1) < 1e-3))
                fail_msg("%d dots, changing %d: %g Hz", dots, changes, hz);
            assert_true(crt_waveform_repeats_hz(d, 50 * MS, 74 * MS, 40) == 0);
            crt_photodiode_close(d);
            crt_tube_destroy(tube);
        }
}

/* Flashes at random have no period, however many there are. */
static void chance_does_not_repeat(void **state)
{
    (void)state;
    const double w[] = {1}, tau[] = {1};
    struct crt_phosphor p = model_phosphor(1, w, tau);
    struct crt_tube_row row = model_row(0.25, 0);
    for (int sources = 1; sources <= 3; sources++)
        for (int spread = 1; spread <= 2; spread++)
            for (int i = 0; i < 3; i++) {
                struct crt_tube *tube = tube_of(&row, &p);
                struct crt_photodiode *d = point_at(tube, 0, 0);
                uint32_t seed = 100 + (uint32_t)i;
                uint64_t t = 0;
                for (int n = 0; n < 400; n++) {
                    double u = model_uniform(&seed, 0, 1);
                    point(tube, t, US, 4 * (uint32_t)(n % sources), 0);
                    t += 2 * US + (uint64_t)((spread == 1 ? u : -log(1 - u)) * 1e9);
                }
                crt_tube_advance(tube, t);
                double hz = crt_waveform_repeats_hz(d, 0, t, 0);
                if (hz != 0)
                    fail_msg("%d sources, spread %d, seed %d: %g Hz", sources, spread, i, hz);
                crt_photodiode_close(d);
                crt_tube_destroy(tube);
            }
}

/* Rasters, line n again in the next frame; interlaced, after two fields. */
static void rasters_repeat(void **state)
{
    (void)state;
    const double w[] = {1}, tau[] = {1};
    struct crt_phosphor p = model_phosphor(1, w, tau);
    struct crt_tube_row row = line_model_row(40, 30, 0.5);
    uint8_t white[64];
    memset(white, 255, sizeof white);
    for (int step = 1; step <= 2; step++) {
        struct crt_tube *tube = tube_of(&row, &p);
        struct crt_photodiode *d = point_at(tube, 3, 2.2);
        for (uint64_t n = 0; n < 20; n++) {
            uint64_t t = crt_tick_time((struct crt_rate){60, 1}, n);
            for (int line = step == 2 ? (int)(n & 1) : 0; line < 90; line += step, t += 50 * US) {
                struct crt_scan_line l = {.t0 = t, .t1 = t + 40 * US, .dots = 64, .guns = 1};
                l.x0 = -20;
                l.x1 = 20;
                l.y0 = l.y1 = (float)(15 - (line + 0.5) / 3);
                l.drive[0] = white;
                l.source = (uint32_t)line;
                crt_tube_scan_line(tube, &l);
            }
        }
        crt_tube_advance(tube, CRT_PS_PER_S / 3);
        double hz = crt_waveform_repeats_hz(d, 0, CRT_PS_PER_S / 3, 0);
        assert_true(fabs(hz - 60.0 / step) < 1e-3);
        /* The light of a point between lines of both fields comes 60 times a second all the same. */
        struct crt_waveform_figures f;
        crt_waveform_measure(d, CRT_PS_PER_S / 6, CRT_PS_PER_S / 6 * 2, hz, &f);
        assert_true(step == 1 || (f.c[0] < 0.7 && f.c[1] > 1));
        assert_true(f.flicker_index > 0.3 && f.percent_flicker > 99);
        crt_photodiode_close(d);
        crt_tube_destroy(tube);
    }
}

static void darkness(void **state)
{
    (void)state;
    const double w[] = {1}, tau[] = {1};
    struct crt_phosphor p = model_phosphor(1, w, tau);
    struct crt_tube_row row = model_row(0.25, 0);
    struct crt_tube *tube = tube_of(&row, &p);
    struct crt_photodiode *d = point_at(tube, 0, 0);
    struct crt_waveform_figures f;
    point(tube, 20 * MS, US, 8, 0);
    crt_tube_advance(tube, 30 * MS);
    crt_waveform_measure(d, 0, 10 * MS, 60, &f);
    assert_true(f.mean_cd_m2 == 0 && f.peak_cd_m2 == 0 && f.least_cd_m2 == 0 && f.hz == 60);
    assert_true(isnan(f.c[0]) && isnan(f.percent_flicker) && isnan(f.flicker_index));
    assert_true(isnan(f.persistence_10_s));
    assert_true(crt_waveform_repeats_hz(d, 0, 30 * MS, 0) == 0);
    crt_photodiode_close(d);
    crt_tube_destroy(tube);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_phosphor),
        cmocka_unit_test(persistence),
        cmocka_unit_test(worked_rows),
        cmocka_unit_test(as_fine_samples_say),
        cmocka_unit_test(ranges_keep_peaks),
        cmocka_unit_test(vectors_repeat),
        cmocka_unit_test(pieces_of_a_refresh_are_no_repeats),
        cmocka_unit_test(chance_does_not_repeat),
        cmocka_unit_test(rasters_repeat),
        cmocka_unit_test(darkness),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
