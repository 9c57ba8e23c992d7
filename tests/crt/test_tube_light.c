/* Measured as one would measure a real tube: width of the spot and of a line, luminance of a line,
 * flicker at the steady state, against closed forms. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "crt/spot.h"
#include "crt/tube.h"
#include "tests/support/tube_model.h"

#define SIGMA 0.25

static struct crt_tube_desc desc_of(const struct crt_tube_row *row, const struct crt_phosphor *p,
                                    int cols, int rows, double cell)
{
    return (struct crt_tube_desc){
        .row = row,
        .phosphor = p,
        .grid = {cols, rows, cell, -cols * cell / 2, rows * cell / 2},
        .epoch = {60, 1},
        .knobs = {0, 1, 0},
        .threads = 1,
    };
}

/* Film of one stroke, until its light is out. */
static void film_of(const struct crt_tube_desc *desc, struct crt_stroke s, struct crt_film *film)
{
    struct crt_error err;
    struct crt_tube *tube = crt_tube_create(desc, &err);
    assert_non_null(tube);
    assert_true(crt_film_init(film, tube, &err));
    crt_film_open(tube, film, 0, CRT_PS_PER_S);
    crt_tube_stroke(tube, &s);
    crt_tube_advance(tube, CRT_PS_PER_S);
    crt_tube_destroy(tube);
}

/* Width at 60 % of the peak of a row of samples around its maximum, in samples. */
static double width_at_60(const float *at, size_t step, int count)
{
    int top = 0;
    for (int i = 0; i < count; i++)
        if (at[(size_t)i * step] > at[(size_t)top * step])
            top = i;
    double level = 0.6 * (double)at[(size_t)top * step], edge[2];
    for (int side = 0; side < 2; side++) {
        int i = top, d = side ? 1 : -1;
        while ((double)at[(size_t)(i + d) * step] > level)
            i += d;
        double a = (double)at[(size_t)i * step], b = (double)at[(size_t)(i + d) * step];
        edge[side] = i - top + d * (a - level) / (a - b);
    }
    return edge[1] - edge[0];
}

static void spot_width(void **state)
{
    (void)state;
    const double one[] = {1}, tau[] = {1};
    struct crt_phosphor p = model_phosphor(1, one, tau);
    struct crt_tube_row row = model_row(SIGMA, 0.2);
    const double expect = 2 * sqrt(2 * log(1 / 0.6));
    for (int n = 0; n < 4; n++) {
        double drive = n & 1 ? 1 : 0.4, cell = SIGMA / 25; /* a close-up: 25 cells a sigma */
        struct crt_tube_desc desc = desc_of(&row, &p, 416, 400, cell);
        desc.knobs.focus = n == 3 ? 0.5 : 0;
        double sigma = crt_spot_at(&row, &desc.knobs, drive).sigma_mm / cell;
        struct crt_film film;
        struct crt_stroke dot = {
            .t1 = CRT_PS_PER_US, .x0 = 0.003F, .x1 = 0.003F, .drive = (float)drive};
        film_of(&desc, dot, &film);
        double across = width_at_60(film.light[0] + 200 * 416, 1, 416);
        double down = width_at_60(film.light[0] + 208, 416, 400);
        assert_true(fabs(across / sigma / expect - 1) < 2e-3);
        assert_true(fabs(down / sigma / expect - 1) < 2e-3);
        crt_film_free(&film);
        /* Across a line, on the row through the middle. */
        struct crt_stroke line = {.t1 = CRT_PS_PER_US, .y0 = -9, .y1 = 9, .drive = (float)drive};
        film_of(&desc, line, &film);
        across = width_at_60(film.light[0] + 200 * 416, 1, 416);
        assert_true(fabs(across / sigma / expect - 1) < 2e-3);
        print_message("# sigma %.2f cells: line %.4f sigma wide at 60 %%\n", sigma, across / sigma);
        crt_film_free(&film);
    }
}

static void spot_follows_drive_and_knobs(void **state)
{
    (void)state;
    struct crt_tube_row row = model_row(SIGMA, 0.2);
    struct crt_knobs knobs = {0, 1, 0};
    assert_true(fabs(crt_spot_sigma0(&row) - SIGMA) < 1e-12);
    struct crt_spot full = crt_spot_at(&row, &knobs, 1), half = crt_spot_at(&row, &knobs, 0.5);
    assert_true(fabs(full.current - 1) < 1e-12);
    assert_true(fabs(half.current - pow(0.5, 2.5)) < 1e-12);
    assert_true(fabs(full.sigma_mm - hypot(SIGMA, 0.2)) < 1e-12);
    assert_true(fabs(half.sigma_mm - hypot(SIGMA, 0.2 * pow(half.current, 0.5))) < 1e-12);
    assert_true(fabs(half.power / full.power - half.current) < 1e-12);
    assert_true(crt_spot_at(&row, &knobs, 0).power == 0);
    assert_true(crt_spot_at(&row, &knobs, -1).power == 0);
    assert_true(crt_spot_at(&row, &knobs, NAN).power == 0);
    assert_true(crt_spot_at(&row, &knobs, 7).current == 1);
    knobs = (struct crt_knobs){0.1, 2, 0.75};
    struct crt_spot turned = crt_spot_at(&row, &knobs, 0.2);
    assert_true(fabs(turned.current - pow(0.5, 2.5)) < 1e-12);
    assert_true(fabs(turned.sigma_mm - half.sigma_mm * 1.25) < 1e-12);
}

/* A full-drive line at the row's speed and refresh has the row's luminance. */
static void line_luminance(void **state)
{
    (void)state;
    const double w[] = {0.3, 0.3, 0.4}, tau[] = {0.05, 2, 65};
    struct crt_phosphor p = model_phosphor(3, w, tau);
    struct crt_tube_row row = model_row(SIGMA, 0.1);
    struct crt_tube_desc desc = desc_of(&row, &p, 160, 64, SIGMA);
    struct crt_error err;
    struct crt_film film;
    struct crt_tube *tube = crt_tube_create(&desc, &err);
    assert_true(tube && crt_film_init(&film, tube, &err));
    const uint64_t refreshes = 60;
    for (uint64_t n = 0; n < refreshes; n++) {
        uint64_t t = crt_tick_time(desc.epoch, n);
        if (n == refreshes - 6)
            crt_film_open(tube, &film, t, crt_tick_time(desc.epoch, refreshes));
        struct crt_stroke s = {.t0 = t,
                               .t1 = t + 30 * CRT_PS_PER_US,
                               .x0 = -15,
                               .x1 = 15,
                               .y0 = (float)SIGMA / 2,
                               .y1 = (float)SIGMA / 2,
                               .drive = 1};
        crt_tube_stroke(tube, &s);
        crt_tube_advance(tube, crt_tick_time(desc.epoch, n + 1));
    }
    float crest = film.light[0][31 * 160 + 80];
    double luminance = (double)crest / 0.1;
    print_message("# line: %.3f cd/m2, row says %g\n", luminance, row.line_luminance.value);
    assert_true(fabs(luminance / row.line_luminance.value - 1) < 1e-3);
    crt_film_free(&film);
    crt_tube_destroy(tube);
}

/* ---- flicker --------------------------------------------------------------------------------- */

/* Light of periodic unit impulses, t after one of them, of period f. */
static double periodic(const struct crt_phosphor *p, double t, double period)
{
    double sum = 0;
    for (int k = 0; k < p->terms; k++) {
        double tau = p->term[k].tau_s;
        sum += p->term[k].w / tau * exp(-t / tau) / -expm1(-period / tau);
    }
    return sum;
}

struct flicker {
    double c1, percent, index;
};

static struct flicker closed_form(const struct crt_phosphor *p, double f)
{
    double period = 1 / f, re = 0, im = 0;
    for (int k = 0; k < p->terms; k++) {
        double a = 2 * acos(-1) * f * p->term[k].tau_s;
        re += p->term[k].w / (1 + a * a);
        im -= p->term[k].w * a / (1 + a * a);
    }
    double most = periodic(p, 0, period), least = periodic(p, period, period), mean = f;
    double low = 0, high = period; /* where it falls through the mean */
    for (int i = 0; i < 200; i++) {
        double mid = (low + high) / 2;
        *(periodic(p, mid, period) > mean ? &low : &high) = mid;
    }
    double above = -low * mean;
    for (int k = 0; k < p->terms; k++) {
        double tau = p->term[k].tau_s;
        above += p->term[k].w * expm1(-low / tau) / expm1(-period / tau);
    }
    return (struct flicker){2 * hypot(re, im), 100 * (most - least) / (most + least), above};
}

/* From probe samples of a point drawn once a period, in the steady state. The samples follow the
 * decay: dense after the flash, and each is the mean of its interval as far as a straight line is.
 */
static struct flicker measured(const struct crt_phosphor *p, double f)
{
    enum { SAMPLES = 4000 };
    static double time[SAMPLES + 1], light[SAMPLES + 1];
    struct crt_tube_row row = model_row(SIGMA, 0);
    struct crt_tube_desc desc = desc_of(&row, p, 64, 64, SIGMA);
    struct crt_error err;
    struct crt_tube *tube = crt_tube_create(&desc, &err);
    assert_non_null(tube);
    double longest = 0, period = 1 / f;
    for (int k = 0; k < p->terms; k++)
        longest = fmax(longest, p->term[k].tau_s);
    uint64_t settle = (uint64_t)ceil(9 * longest * f) + 2, dwell = 10000; /* 10 ns */
    double x = SIGMA / 2, y = SIGMA / 2, cd_m2[CRT_MAX_COLOURS];
    for (uint64_t n = 0; n <= settle; n++) {
        uint64_t t = crt_tick_time(desc.epoch, n) + 1000;
        struct crt_stroke s = {.t0 = t,
                               .t1 = t + dwell,
                               .x0 = (float)x,
                               .y0 = (float)y,
                               .x1 = (float)x,
                               .y1 = (float)y,
                               .drive = 1};
        crt_tube_stroke(tube, &s);
        if (n < settle)
            crt_tube_advance(tube, crt_tick_time(desc.epoch, n + 1));
    }
    uint64_t start = crt_tick_time(desc.epoch, settle) + 1000 + dwell;
    for (int i = 0; i <= SAMPLES; i++) {
        double u = (double)i / SAMPLES;
        time[i] = (period - (double)dwell * 1e-12) * u * u * u;
        crt_tube_probe(tube, x, y, start + (uint64_t)(time[i] * 1e12), cd_m2);
        light[i] = cd_m2[0] + cd_m2[1];
    }
    crt_tube_destroy(tube);
    double sum = 0, re = 0, im = 0, above = 0;
    for (int i = 0; i < SAMPLES; i++) {
        double dt = time[i + 1] - time[i], mid = (time[i] + time[i + 1]) / 2;
        double v = (light[i] + light[i + 1]) / 2, angle = 2 * acos(-1) * f * mid;
        sum += v * dt;
        re += v * dt * cos(angle);
        im += v * dt * sin(angle);
    }
    double mean = sum / time[SAMPLES];
    for (int i = 0; i < SAMPLES; i++)
        above += fmax(0, (light[i] + light[i + 1]) / 2 - mean) * (time[i + 1] - time[i]);
    double most = light[0], least = light[SAMPLES];
    return (struct flicker){2 * hypot(re, im) / sum, 100 * (most - least) / (most + least),
                            above / sum};
}

static void flicker_figures(void **state)
{
    (void)state;
    const char *const names[] = {"P31", "P1", "P39", "P4", "P43", "P7"};
    for (unsigned i = 0; i < sizeof names / sizeof names[0]; i++) {
        const struct crt_phosphor *p = crt_phosphor_find(names[i]);
        assert_non_null(p);
        struct flicker want = closed_form(p, 60), got = measured(p, 60);
        print_message(
            "# %s at 60 Hz: C1 %.4f (%.4f), percent flicker %.3f (%.3f), index %.4f (%.4f)\n",
            names[i], got.c1, want.c1, got.percent, want.percent, got.index, want.index);
        assert_true(fabs(got.c1 / want.c1 - 1) < 0.01);
        assert_true(fabs(got.percent / want.percent - 1) < 0.01);
        assert_true(fabs(got.index / want.index - 1) < 0.01);
    }
}

/* The probe's integral over an exposure is the film's sample; on and between cell centres, for
 * lines. */
static void probe_agrees_with_film(void **state)
{
    (void)state;
    const double w[] = {0.3, 0.3, 0.4}, tau[] = {0.0007, 0.9, 65};
    struct crt_phosphor p = model_phosphor(3, w, tau);
    struct crt_tube_row row = model_row(SIGMA, 0);
    struct crt_tube_desc desc = desc_of(&row, &p, 64, 64, SIGMA);
    struct crt_error err;
    struct crt_film film;
    struct crt_tube *tube = crt_tube_create(&desc, &err);
    assert_true(tube && crt_film_init(&film, tube, &err));
    uint64_t tick = crt_tick_time(desc.epoch, 3), a = tick + 100 * CRT_PS_PER_US;
    uint64_t b = a + 60 * CRT_PS_PER_US;
    for (uint64_t n = 0; n < 3; n++) {
        struct crt_stroke old = {.t0 = crt_tick_time(desc.epoch, n) + 15 * CRT_PS_PER_MS,
                                 .x0 = -6,
                                 .x1 = 6,
                                 .y0 = -2,
                                 .y1 = 3,
                                 .drive = 1};
        old.t1 = old.t0 + CRT_PS_PER_MS;
        crt_tube_stroke(tube, &old);
        crt_tube_advance(tube, crt_tick_time(desc.epoch, n + 1));
    }
    crt_tube_advance(tube, a);
    crt_film_open(tube, &film, a, b);
    struct crt_stroke s = {.t0 = a + 10 * CRT_PS_PER_US,
                           .t1 = a + 45 * CRT_PS_PER_US,
                           .x0 = -4,
                           .x1 = 5,
                           .y0 = 3,
                           .y1 = -2.5F,
                           .drive = 1};
    crt_tube_stroke(tube, &s);
    double worst = 0, peak = 0;
    const int cells[] = {32 * 64 + 32, 28 * 64 + 26, 20 * 64 + 16,
                         30 * 64 + 30, 42 * 64 + 52, 5 * 64 + 5};
    double sums[6];
    for (int i = 0; i < 6; i++) {
        double x, y, sum = 0, cd_m2[CRT_MAX_COLOURS];
        crt_cell_to_mm(&desc.grid, cells[i] % 64, cells[i] / 64, &x, &y);
        const int steps = 6000; /* 10 ns */
        for (int k = 0; k < steps; k++) {
            crt_tube_probe(tube, x, y, a + (uint64_t)k * 10000 + 5000, cd_m2);
            sum += cd_m2[0] * 10e-9;
        }
        sums[i] = sum;
    }
    crt_tube_advance(tube, b);
    assert_true(film.complete);
    for (int i = 0; i < 6; i++) {
        peak = fmax(peak, (double)film.light[0][cells[i]]);
        worst = fmax(worst, fabs(sums[i] - (double)film.light[0][cells[i]]));
    }
    print_message("# probe against film: %.2e of peak\n", worst / peak);
    assert_true(worst < 1e-3 * peak);
    crt_film_free(&film);
    crt_tube_destroy(tube);
}

/* Between cell centres the probe reads planes as the spot is, not as the grid is. */
static void probe_between_cells(void **state)
{
    (void)state;
    const double one[] = {1}, tau[] = {65};
    struct crt_phosphor p = model_phosphor(1, one, tau);
    struct crt_tube_row row = model_row(SIGMA, 0);
    struct crt_tube_desc desc = desc_of(&row, &p, 64, 64, SIGMA);
    struct crt_error err;
    struct crt_tube *tube = crt_tube_create(&desc, &err);
    struct crt_stroke dot = {.t0 = 0, .t1 = 1000000, .x0 = 0.11F, .x1 = 0.11F, .drive = 1};
    crt_tube_stroke(tube, &dot);
    double before[CRT_MAX_COLOURS], after[CRT_MAX_COLOURS], peak = 0, worst = 0;
    const double x[] = {0.11, 0.125, 0, 0.2, 0.36, 0.6, -0.5};
    uint64_t tick = crt_tick_time(desc.epoch, 1);
    double journal[7];
    for (int i = 0; i < 7; i++) {
        crt_tube_probe(tube, x[i], 0.03 * i, tick, before);
        journal[i] = before[0];
        peak = fmax(peak, before[0]);
    }
    crt_tube_advance(tube, tick);
    for (int i = 0; i < 7; i++) {
        crt_tube_probe(tube, x[i], 0.03 * i, tick, after);
        worst = fmax(worst, fabs(after[0] - journal[i]));
    }
    print_message("# probe of plane against closed form: %.2e of peak\n", worst / peak);
    assert_true(worst < 1e-2 * peak);
    crt_tube_destroy(tube);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(spot_width),
        cmocka_unit_test(spot_follows_drive_and_knobs),
        cmocka_unit_test(line_luminance),
        cmocka_unit_test(flicker_figures),
        cmocka_unit_test(probe_agrees_with_film),
        cmocka_unit_test(probe_between_cells),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
