/* Photodiodes: what they read against the tube's own probe, slow direct sums and energy; shares, integrals,
 * forgetting, snapshots; and that they change nothing. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crt/photodiode.h"
#include "crt/spot.h"
#include "tests/support/line_model.h"
#include "tests/support/tube_model.h"

#define PI 3.14159265358979324
#define US CRT_PS_PER_US
#define MS CRT_PS_PER_MS

/* ---- tubes ---------------------------------------------------------------------------------------- */

static struct crt_tube *vector_tube(const struct crt_tube_row *row, const struct crt_phosphor *p,
                                    int cols, int rows)
{
    struct crt_error err;
    double cell = row->spot.value / CRT_WIDTH60_SIGMA;
    struct crt_tube_desc desc = {
        .row = row,
        .phosphor = p,
        .grid = {cols, rows, cell, -cols * cell / 2, rows * cell / 2},
        .epoch = {60, 1},
        .knobs = {0, 1, 0},
        .threads = 1,
    };
    struct crt_tube *tube = crt_tube_create(&desc, &err);
    assert_non_null(tube);
    return tube;
}

static struct crt_photodiode *open_diode(struct crt_tube *tube, enum crt_photodiode_kind kind,
                                         double x, double y, double diameter)
{
    struct crt_error err;
    struct crt_photodiode_desc desc = {kind, x, y, diameter};
    struct crt_photodiode *d = crt_photodiode_open(tube, &desc, &err);
    assert_non_null(d);
    return d;
}

static void assert_close(double got, double want, double tolerance)
{
    if (!(fabs(got - want) <= tolerance))
        print_message("# got %.15g, want %.15g, off %.3g, allowed %.3g\n", got, want,
                      fabs(got - want), tolerance);
    assert_true(fabs(got - want) <= tolerance);
}

/* A few strokes at random near the middle, one after the other from t on; returns the end. */
static uint64_t draw(struct crt_tube *tube, uint32_t *seed, uint64_t t, int count, double size)
{
    for (int i = 0; i < count; i++) {
        struct crt_stroke s = {.t0 = t, .source = (uint32_t)i, .drive = 1};
        s.t1 = t + US / 2 + model_random(seed) % (40 * US);
        s.x0 = (float)model_uniform(seed, -size, size);
        s.y0 = (float)model_uniform(seed, -size, size);
        bool rests = model_random(seed) % 4 == 0;
        s.x1 = rests ? s.x0 : (float)model_uniform(seed, -size, size);
        s.y1 = rests ? s.y0 : (float)model_uniform(seed, -size, size);
        s.drive = (float)model_uniform(seed, 0.4, 1);
        crt_tube_stroke(tube, &s);
        t = s.t1 + model_random(seed) % (3 * US);
    }
    return t;
}

/* ---- against the probe ------------------------------------------------------------------------------- */

static void point_is_as_the_probe(void **state)
{
    (void)state;
    const double w[] = {0.5, 0.3, 0.2}, tau[] = {0.00007, 0.12, 3};
    struct crt_phosphor p = model_phosphor(3, w, tau);
    struct crt_tube_row row = model_row(0.25, 0.1);
    struct crt_tube *tube = vector_tube(&row, &p, 80, 80);
    struct crt_photodiode *d = open_diode(tube, CRT_DIODE_POINT, 0.3, -0.2, 0);
    uint32_t seed = 7;
    double highest = 0, off = 0;
    uint64_t end = draw(tube, &seed, 0, 300, 4);
    assert_true(end < 16 * MS);
    crt_tube_advance(tube, 16 * MS);
    for (int i = 0; i < 4000; i++) {
        double want[CRT_MAX_COLOURS], got[CRT_MAX_COLOURS];
        uint64_t t = (uint64_t)i * (end / 3500);
        crt_tube_probe(tube, 0.3, -0.2, t, want);
        crt_photodiode_read(d, t, got);
        highest = fmax(highest, want[0]);
        off = fmax(off, fabs(want[0] - got[0]) / fmax(want[0], 1e-3 * highest));
    }
    print_message("# against the probe: %.2g\n", off);
    assert_true(highest > 0 && off < 1e-5);
    crt_photodiode_close(d);
    crt_tube_destroy(tube);
}

/* ---- scan lines ------------------------------------------------------------------------------------- */

static struct crt_tube *raster_tube(const struct crt_tube_row *row, const struct crt_phosphor *p,
                                    struct crt_knobs knobs, int cols, int rows, double x, double y)
{
    struct crt_error err;
    double cell = row->spot.value / CRT_WIDTH60_SIGMA;
    struct crt_tube_desc desc = {
        .row = row,
        .phosphor = p,
        .grid = {cols, rows, cell, x - cols * cell / 2, y + rows * cell / 2},
        .epoch = {60, 1},
        .knobs = knobs,
        .threads = 1,
    };
    struct crt_tube *tube = crt_tube_create(&desc, &err);
    assert_non_null(tube);
    return tube;
}

/* A raster: `count` lines of `dots` dots over width × height; `step` 2: every other line. */
struct raster {
    double width, height;
    int count, dots, step;
    uint64_t line, lit; /* ps */
    uint8_t *drive[CRT_MAX_GUNS];
    int guns;
};

static struct crt_scan_line line_of(const struct raster *r, int n, uint64_t t0)
{
    struct crt_scan_line l = {.t0 = t0, .t1 = t0 + r->lit, .dots = r->dots, .guns = r->guns};
    l.x0 = (float)(-r->width / 2);
    l.x1 = (float)(r->width / 2);
    l.y0 = l.y1 = (float)(r->height / 2 - (n + 0.5) * r->height / r->count);
    for (int gun = 0; gun < r->guns; gun++)
        l.drive[gun] = r->drive[gun] + (size_t)n * (size_t)r->dots;
    l.source = (uint32_t)n;
    return l;
}

static uint64_t field(struct crt_tube *tube, const struct raster *r, int first, uint64_t t0)
{
    for (int n = first; n < r->count; n += r->step, t0 += r->line) {
        struct crt_scan_line l = line_of(r, n, t0);
        crt_tube_scan_line(tube, &l);
    }
    return t0;
}

static void paint(struct raster *r, uint32_t *seed)
{
    size_t dots = (size_t)r->count * (size_t)r->dots;
    for (int gun = 0; gun < r->guns; gun++) {
        r->drive[gun] = malloc(dots);
        for (size_t i = 0; i < dots; i++) {
            uint32_t x = model_random(seed) % 4;
            r->drive[gun][i] = (uint8_t)(x == 0 ? 0 : x == 1 ? 255 : model_random(seed) % 256);
        }
    }
}

static void unpaint(struct raster *r)
{
    for (int gun = 0; gun < r->guns; gun++)
        free(r->drive[gun]);
}

/* What two tubes' rows have in common here: 40 × 30 mm, 96 lines of 128 dots. */
static struct raster small_raster(int guns, uint32_t *seed)
{
    struct raster r = {40, 30, 96, 128, 1, 22 * US, 18 * US, {NULL, NULL, NULL}, guns};
    paint(&r, seed);
    return r;
}

/* At many instants, most of them while lines near the place are drawn. */
static double lines_off_the_probe(struct crt_tube *tube, struct crt_photodiode *d, double x,
                                  double y, uint64_t until, uint32_t *seed)
{
    double highest = 0, off = 0;
    size_t count;
    const struct crt_deposit *at = crt_photodiode_deposits(d, &count);
    assert_true(count > 4);
    for (int i = 0; i < 60; i++) {
        double want[CRT_MAX_COLOURS], got[CRT_MAX_COLOURS];
        uint64_t t = model_random(seed) % until;
        if (i % 4) {
            const struct crt_deposit *near = &at[model_random(seed) % count];
            double when = near->mean_t_s * 1e12 + model_uniform(seed, -1, 1) * 4e5;
            t = near->t0 + (uint64_t)fmax(when, 0);
        }
        crt_tube_probe(tube, x, y, t, want);
        crt_photodiode_read(d, t, got);
        for (int c = 0; c < CRT_MAX_COLOURS; c++) {
            highest = fmax(highest, want[c]);
            off = fmax(off, fabs(want[c] - got[c]));
        }
    }
    return off / highest;
}

static void lines_are_as_the_probe(void **state)
{
    (void)state;
    const double w[] = {0.6, 0.4}, tau[] = {0.0005, 1};
    struct crt_phosphor one = model_phosphor(2, w, tau), three = line_model_p22();
    uint32_t seed = 3;
    for (int n = 0; n < 4; n++) {
        bool colour = n & 1;
        struct crt_tube_row row = colour ? line_model_colour_row(40, 30, 0.4)
                                         : line_model_row(40, 30, n == 2 ? 0.2 : 0.5);
        row.spot_growth.value = n >= 2 ? 0.15 : 0;
        row.spot_exponent.value = n == 2 ? 0.5 : 0.6;
        row.spot_edge.value = 1.4;
        row.converge.value = colour ? 0.1 : 0;
        row.converge_edge.value = colour ? 0.2 : 0;
        struct crt_knobs knobs = {n == 3 ? 0.05 : 0, n == 3 ? 1.3 : 1, n == 3 ? 0.4 : 0};
        double x = 7.3 - 2 * n, y = -5.1;
        struct crt_tube *tube = raster_tube(&row, colour ? &three : &one, knobs, 64, 64, x, y);
        struct crt_photodiode *d = open_diode(tube, CRT_DIODE_POINT, x, y, 0);
        struct raster r = small_raster(colour ? 3 : 1, &seed);
        uint64_t end = field(tube, &r, 0, 0);
        crt_tube_advance(tube, end);
        double off = lines_off_the_probe(tube, d, x, y, end, &seed);
        print_message("# raster %d against the probe: %.2g of the brightest\n", n, off);
        assert_true(off < 2e-4);
        crt_photodiode_close(d);
        crt_tube_destroy(tube);
        unpaint(&r);
    }
}

/* ---- discs and the screen ------------------------------------------------------------------------ */

/* Mean of points over a disc, in rings. */
static double mean_of_points(struct crt_tube *tube, double x, double y, double radius, int rings,
                             uint64_t t)
{
    double sum = 0;
    int count = 0;
    for (int i = 0; i < rings; i++) {
        double r = radius * (i + 0.5) / rings; /* 2i + 1 points: equal areas */
        for (int n = 0; n < 3 * (2 * i + 1); n++, count++) {
            double a = 2 * PI * (n + 0.5 * (i & 1)) / (3 * (2 * i + 1)), cd[CRT_MAX_COLOURS];
            crt_tube_probe(tube, x + r * cos(a), y + r * sin(a), t, cd);
            sum += cd[0] + cd[1] + cd[2];
        }
    }
    return sum / count;
}

static void disc_is_the_mean_of_points(void **state)
{
    (void)state;
    const double w[] = {0.7, 0.3}, tau[] = {0.02, 2};
    struct crt_phosphor p = model_phosphor(2, w, tau);
    struct crt_tube_row row = model_row(0.25, 0.1);
    static const double radius[] = {0.05, 0.3, 1.2, 3};
    for (int n = 0; n < 4; n++) {
        struct crt_tube *tube = vector_tube(&row, &p, 8, 8);
        struct crt_photodiode *d = open_diode(tube, CRT_DIODE_DISC, 0.4, 0.3, 2 * radius[n]);
        uint32_t seed = 11;
        uint64_t end = draw(tube, &seed, 0, 60, 4);
        double highest = 0, off = 0;
        crt_tube_advance(tube, end);
        for (int i = 1; i <= 6; i++) {
            uint64_t t = end / 6 * (uint64_t)i;
            double want = mean_of_points(tube, 0.4, 0.3, radius[n], 8 + 10 * n, t);
            highest = fmax(highest, want);
            off = fmax(off, fabs(want - crt_photodiode_luminance(d, t)));
        }
        print_message("# disc of %.2f mm against points: %.2g\n", 2 * radius[n], off / highest);
        assert_true(off < 2e-3 * highest); /* the points' own error */
        crt_photodiode_close(d);
        crt_tube_destroy(tube);
    }
}

/* Mean over a disc of a resting spot, as an integral over rings; on a ring over angles. */
static double mean_of_rings(double radius, double sigma, double distance)
{
    double sum = 0;
    const int rings = 1500, angles = 100;
    for (int i = 0; i < rings; i++) {
        double r = radius * (i + 0.5) / rings, off = r - distance, around = 0;
        if (fabs(off) > 7 * sigma)
            continue;
        for (int n = 0; n < angles; n++)
            around += exp(-r * distance / (sigma * sigma) * (1 - cos(PI * (n + 0.5) / angles)));
        sum += r * exp(-off * off / (2 * sigma * sigma)) * around / angles;
    }
    return sum * radius / rings / (sigma * sigma) / (PI * radius * radius);
}

static void disc_sees_of_a_spot_what_falls_on_it(void **state)
{
    (void)state;
    const double w[] = {1}, tau[] = {1};
    struct crt_phosphor p = model_phosphor(1, w, tau);
    struct crt_knobs neutral = {0, 1, 0};
    static const double radius[] = {0.02, 0.25, 0.8, 4}, sigma[] = {0.21, 0.25};
    double worst = 0;
    for (int n = 0; n < 8; n++) {
        struct crt_tube_row row = model_row(sigma[n & 1], 0);
        struct crt_tube *tube = vector_tube(&row, &p, 8, 8);
        struct crt_photodiode *d = open_diode(tube, CRT_DIODE_DISC, -1, 2, 2 * radius[n / 2]);
        struct crt_spot spot = crt_spot_at(&row, &neutral, 1);
        for (int i = 0; i < 6; i++) {
            double off = fmax(0, radius[n / 2] + (i - 3) * 0.9 * sigma[n & 1]);
            struct crt_stroke s = {.t0 = (uint64_t)i * US, .y0 = 2, .y1 = 2, .drive = 1};
            s.t1 = s.t0 + US;
            s.x0 = s.x1 = (float)(-1 + off);
            crt_tube_stroke(tube, &s);
        }
        crt_tube_advance(tube, MS);
        size_t count;
        const struct crt_deposit *at = crt_photodiode_deposits(d, &count);
        assert_int_equal(count, 6);
        double most = mean_of_rings(radius[n / 2], spot.sigma_mm, 0);
        for (int i = 0; i < 6; i++) {
            double off =
                (double)(float)(-1 + fmax(0, radius[n / 2] + (i - 3) * 0.9 * sigma[n & 1])) + 1;
            double want = mean_of_rings(radius[n / 2], spot.sigma_mm, off);
            worst = fmax(worst, fabs(at[i].fluence[0] / (spot.power * 1e-6) - want) / most);
        }
        crt_photodiode_close(d);
        crt_tube_destroy(tube);
    }
    print_message("# discs of spots: %.2g of the most\n", worst);
    assert_true(worst < 2e-5);
}

/* A disc that has everything within: energy over its area, of strokes and of lines. */
static void wide_disc_has_all_the_energy(void **state)
{
    (void)state;
    const double w[] = {1}, tau[] = {1};
    struct crt_phosphor p = model_phosphor(1, w, tau);
    struct crt_tube_row row = model_row(0.25, 0);
    struct crt_knobs neutral = {0, 1, 0};
    struct crt_tube *tube = vector_tube(&row, &p, 8, 8);
    struct crt_photodiode *d = open_diode(tube, CRT_DIODE_DISC, 1, 0, 40);
    struct crt_stroke s = {.t1 = 30 * US, .x0 = -5, .y0 = 2, .x1 = 6, .y1 = -3, .drive = 0.8F};
    size_t count;
    crt_tube_stroke(tube, &s);
    crt_tube_advance(tube, MS);
    const struct crt_deposit *at = crt_photodiode_deposits(d, &count);
    double energy = crt_spot_at(&row, &neutral, (double)0.8F).power * 30e-6;
    assert_int_equal(count, 1);
    assert_close(at->fluence[0] * PI * 400 / energy, 1, 1e-6);
    assert_close(at->mean_t_s, 15e-6, 1e-11);
    crt_photodiode_close(d);
    crt_tube_destroy(tube);
}

static void screen_has_all_the_energy(void **state)
{
    (void)state;
    const double w[] = {0.4, 0.6}, tau[] = {0.01, 5};
    struct crt_phosphor p = model_phosphor(2, w, tau);
    struct crt_tube_row row = model_row(0.25, 0.1);
    row.width.value = 80;
    row.height.value = 60;
    struct crt_knobs neutral = {0, 1, 0};
    struct crt_tube *tube = vector_tube(&row, &p, 8, 8);
    struct crt_photodiode *d = open_diode(tube, CRT_DIODE_SCREEN, 0, 0, 0);
    struct crt_stroke s = {.t0 = 2 * MS, .t1 = 2 * MS + 40 * US, .x1 = 30, .drive = 0.7F};
    double rate = crt_spot_at(&row, &neutral, (double)0.7F).power / 4800, got[CRT_MAX_COLOURS];
    crt_tube_stroke(tube, &s);
    crt_tube_advance(tube, 100 * MS);
    crt_photodiode_gather(d, 0, 100 * MS, got);
    double left = rate * 40e-6 * 0.6 * exp(-(98 - 0.02) / 5);
    assert_close(got[0], rate * 40e-6 - left, 1e-9 * rate * 40e-6);
    /* While it is drawn: 20 us of it. */
    double want = rate * (0.4 * -expm1(-2.0) + 0.6 * -expm1(-0.004));
    assert_close(crt_photodiode_luminance(d, 2 * MS + 20 * US), want, 1e-9 * want);
    crt_photodiode_close(d);
    crt_tube_destroy(tube);
}

/* Energy of a line on the whole screen, and on a disc around all of it, against the slow model's current. */
static void screen_has_all_of_a_line(void **state)
{
    (void)state;
    uint32_t seed = 5;
    struct crt_phosphor p = line_model_p22();
    struct crt_tube_row row = line_model_colour_row(40, 30, 0.4);
    for (int n = 0; n < 2; n++) {
        struct crt_knobs knobs = {n ? 0.04 : 0, n ? 1.2 : 1, 0};
        struct line_model model = {&row, &p, knobs};
        struct crt_tube *tube = raster_tube(&row, &p, knobs, 8, 8, 0, 0);
        struct crt_photodiode *d[2] = {open_diode(tube, CRT_DIODE_SCREEN, 0, 0, 0),
                                       open_diode(tube, CRT_DIODE_DISC, 0, 0, 100)};
        struct raster r = small_raster(3, &seed);
        struct crt_scan_line l = line_of(&r, 40, US);
        crt_tube_scan_line(tube, &l);
        crt_tube_advance(tube, MS);
        size_t count[2];
        const struct crt_deposit *screen = crt_photodiode_deposits(d[0], &count[0]);
        const struct crt_deposit *disc = crt_photodiode_deposits(d[1], &count[1]);
        assert_true(count[0] == 1 && count[1] == 1);
        for (int c = 0; c < 3; c++) {
            double tau = 1 / (2 * PI * row.bandwidth.value * 1e6), v = knobs.brightness, sum = 0;
            for (int i = 0; i < 128 * 400; i++) { /* the amplifier in small steps */
                double to =
                    knobs.contrast * r.drive[c][40 * 128 + i / 400] / 255 + knobs.brightness;
                double step = (double)r.lit * 1e-12 / (128 * 400);
                double there = to + (v - to) * exp(-step / 2 / tau);
                sum += pow(fmin(fmax(there, 0), 1), 2.5) * step;
                v = to + (v - to) * exp(-step / tau);
            }
            double share = 0;
            for (int k = 0; k < p.terms; k++)
                share += p.term[k].colour == c ? p.term[k].w : 0;
            double want = sum * line_model_power(&model, c) * share;
            assert_close(screen->fluence[c] * 1200 / want, 1, 1e-4);
            assert_close(disc->fluence[c] * PI * 2500 / want, 1, 1e-4);
        }
        for (int i = 0; i < 2; i++)
            crt_photodiode_close(d[i]);
        crt_tube_destroy(tube);
        unpaint(&r);
    }
}

/* ---- shares, integrals --------------------------------------------------------------------------------- */

static void shares_sum_to_the_luminance(void **state)
{
    (void)state;
    const double w[] = {0.5, 0.5}, tau[] = {0.05, 4};
    struct crt_phosphor p = model_phosphor(2, w, tau);
    struct crt_tube_row row = model_row(0.25, 0.1);
    struct crt_tube *tube = vector_tube(&row, &p, 64, 64);
    uint32_t seed = 21;
    uint64_t end = draw(tube, &seed, 0, 100, 3);
    crt_tube_advance(tube, end);
    struct crt_photodiode *d = open_diode(tube, CRT_DIODE_POINT, 0.2, 0.1, 0);
    uint64_t start = crt_photodiode_from(d);
    end = draw(tube, &seed, end, 200, 3);
    crt_tube_advance(tube, end);
    for (int i = 0; i < 300; i++) {
        uint64_t t = start + model_random(&seed) % (end - start);
        size_t count;
        const struct crt_deposit *at = crt_photodiode_deposits(d, &count);
        double sum = crt_photodiode_older(d, t), all = crt_photodiode_luminance(d, t);
        for (size_t k = 0; k < count && at[k].t0 < t; k++)
            sum += crt_photodiode_share(d, k, t);
        assert_close(sum, all, 1e-12 * all);
    }
    crt_photodiode_close(d);
    crt_tube_destroy(tube);
}

/* Gathering and harmonics against sums over fine samples; the window cuts pieces. */
static void integrals_are_those_of_samples(void **state)
{
    (void)state;
    const double w[] = {0.3, 0.3, 0.4}, tau[] = {0.03, 0.4, 30};
    struct crt_phosphor p = model_phosphor(3, w, tau);
    struct crt_tube_row row = model_row(0.25, 0.1);
    struct crt_tube *tube = vector_tube(&row, &p, 8, 8);
    struct crt_photodiode *d = open_diode(tube, CRT_DIODE_DISC, 0, 0, 3);
    uint32_t seed = 8;
    uint64_t end = draw(tube, &seed, 0, 40, 3);
    crt_tube_advance(tube, end);
    const uint64_t a = end / 7, b = end - end / 9;
    const int samples = 150000;
    const double step = (double)(b - a) / samples;
    double *l = malloc((size_t)samples * sizeof *l);
    assert_non_null(l);
    for (int i = 0; i < samples; i++)
        l[i] = crt_photodiode_luminance(d, a + (uint64_t)((i + 0.5) * step));
    static const double hz[] = {0, 300, 5000, 80000};
    for (int h = 0; h < 4; h++) {
        double re = 0, im = 0, sum = 0;
        for (int i = 0; i < samples; i++) {
            double t = (i + 0.5) * step;
            re += l[i] * cos(2 * PI * hz[h] * t * 1e-12) * step * 1e-12;
            im -= l[i] * sin(2 * PI * hz[h] * t * 1e-12) * step * 1e-12;
            sum += l[i] * step * 1e-12;
        }
        struct crt_phasor got = crt_photodiode_harmonic(d, a, b, hz[h]);
        assert_close(got.re, re, 1e-6 * sum);
        assert_close(got.im, im, 1e-6 * sum);
        double light[CRT_MAX_COLOURS];
        crt_photodiode_gather(d, a, b, light);
        assert_close(light[0], sum, 1e-6 * sum);
        if (h == 0)
            assert_close(light[0], got.re, 1e-14 * sum);
    }
    free(l);
    crt_photodiode_close(d);
    crt_tube_destroy(tube);
}

/* ---- what came before; forgetting; snapshots --------------------------------------------------------------- */

static void opened_while_it_runs(void **state)
{
    (void)state;
    const double w[] = {0.3, 0.3, 0.4}, tau[] = {0.002, 3, 60};
    struct crt_phosphor p = model_phosphor(3, w, tau);
    struct crt_tube_row row = model_row(0.25, 0.1);
    static const enum crt_photodiode_kind kind[] = {CRT_DIODE_POINT, CRT_DIODE_DISC,
                                                    CRT_DIODE_SCREEN};
    row.width.value = row.height.value = 20;
    for (int n = 0; n < 3; n++) {
        struct crt_tube *tube = vector_tube(&row, &p, 96, 96);
        struct crt_photodiode *all = open_diode(tube, kind[n], 0.2, 0.1, 2);
        uint32_t seed = 5;
        uint64_t end = draw(tube, &seed, 0, 4000, 4); /* some 80 ms: epochs */
        /* Some of the strokes have been delivered and not begun, one is being drawn. */
        crt_tube_advance(tube, end - 100 * US);
        struct crt_photodiode *late = open_diode(tube, kind[n], 0.2, 0.1, 2);
        crt_tube_advance(tube, end + 20 * MS);
        double highest = 0, off = 0;
        for (int i = 0; i < 500; i++) {
            uint64_t t = end - 100 * US + (uint64_t)i * US;
            double want = crt_photodiode_luminance(all, t);
            highest = fmax(highest, want);
            off = fmax(off, fabs(want - crt_photodiode_luminance(late, t)));
        }
        print_message("# opened while it runs, kind %d: %.2g\n", n, off / highest);
        assert_true(off < (n == 0 ? 1e-2 : 2e-3) * highest);
        crt_photodiode_close(all);
        crt_photodiode_close(late);
        crt_tube_destroy(tube);
    }
}

static void forgetting_changes_nothing(void **state)
{
    (void)state;
    const double w[] = {0.6, 0.4}, tau[] = {0.05, 20};
    struct crt_phosphor p = model_phosphor(2, w, tau);
    struct crt_tube_row row = model_row(0.25, 0.1);
    struct crt_tube *tube = vector_tube(&row, &p, 8, 8);
    struct crt_photodiode *a = open_diode(tube, CRT_DIODE_POINT, 0, 0, 0);
    struct crt_photodiode *b = open_diode(tube, CRT_DIODE_POINT, 0, 0, 0);
    uint32_t seed = 9;
    uint64_t t = 0;
    size_t most = 0, count;
    for (int i = 0; i < 300; i++) {
        uint64_t end = draw(tube, &seed, t, 10, 1);
        crt_tube_advance(tube, end);
        if (i % 3 == 0)
            crt_photodiode_forget(b, t + (end - t) / 3);
        for (int k = 0; k < 5; k++) {
            uint64_t at = crt_photodiode_from(b);
            at += model_random(&seed) % (end + 1 - at);
            assert_true(crt_photodiode_luminance(a, at) == crt_photodiode_luminance(b, at));
        }
        crt_photodiode_deposits(b, &count);
        most = count > most ? count : most;
        t = end;
    }
    crt_photodiode_deposits(a, &count);
    print_message("# %zu deposits; at most %zu where it forgets\n", count, most);
    assert_true(count > 1000 && most < 60);
    crt_photodiode_close(a);
    crt_photodiode_close(b);
    crt_tube_destroy(tube);
}

static void snapshots_restart_it(void **state)
{
    (void)state;
    const double w[] = {0.6, 0.4}, tau[] = {0.05, 20};
    struct crt_phosphor p = model_phosphor(2, w, tau);
    struct crt_tube_row row = model_row(0.25, 0.1);
    struct crt_tube *tube = vector_tube(&row, &p, 64, 64);
    struct crt_photodiode *d = open_diode(tube, CRT_DIODE_POINT, 0.1, 0.1, 0);
    uint32_t seed = 31;
    uint64_t end = draw(tube, &seed, 0, 500, 2);
    crt_tube_advance(tube, end);
    double want = crt_photodiode_luminance(d, end);
    struct crt_state saved, load;
    crt_state_save(&saved);
    crt_tube_state(tube, &saved);
    assert_false(saved.failed);
    crt_tube_advance(tube, end + 200 * MS);
    crt_state_load(&load, saved.out, saved.size);
    crt_tube_state(tube, &load);
    assert_false(load.failed);
    size_t count;
    crt_photodiode_deposits(d, &count);
    assert_int_equal(count, 0);
    assert_true(crt_photodiode_from(d) == end && crt_photodiode_now(d) == end);
    assert_close(crt_photodiode_luminance(d, end), want, 1e-2 * want);
    /* A snapshot that is no good leaves it dark. */
    crt_state_load(&load, saved.out, saved.size / 2);
    crt_tube_state(tube, &load);
    assert_true(load.failed);
    assert_true(crt_photodiode_luminance(d, crt_photodiode_now(d)) == 0);
    crt_state_free(&saved);
    crt_photodiode_close(d);
    crt_tube_destroy(tube);
}

/* ---- observing ------------------------------------------------------------------------------------------------ */

/* Samples do not depend on how time is cut, nor on what was asked before. */
static void cutting_time_changes_nothing(void **state)
{
    (void)state;
    const double w[] = {0.6, 0.4}, tau[] = {0.05, 20};
    struct crt_phosphor p = model_phosphor(2, w, tau);
    struct crt_tube_row row = model_row(0.25, 0.1);
    struct crt_tube *tube[2];
    struct crt_photodiode *d[2];
    uint64_t end = 0;
    for (int n = 0; n < 2; n++) {
        uint32_t seed = 77, other = 5;
        uint64_t t = 0;
        tube[n] = vector_tube(&row, &p, 8, 8);
        d[n] = open_diode(tube[n], CRT_DIODE_DISC, 0, 0, 1);
        for (int i = 0; i < 200; i++) {
            t = draw(tube[n], &seed, t, 1, 2);
            if (n == 0)
                continue;
            crt_tube_advance(tube[n], t - model_random(&other) % (US / 4));
            crt_photodiode_luminance(d[n], model_random(&other) % crt_photodiode_now(d[n]));
        }
        crt_tube_advance(tube[n], end = t);
    }
    for (uint64_t t = 0; t < end; t += US / 3)
        assert_true(crt_photodiode_luminance(d[0], t) == crt_photodiode_luminance(d[1], t));
    for (int n = 0; n < 2; n++) {
        crt_photodiode_close(d[n]);
        crt_tube_destroy(tube[n]);
    }
}

static void films_stay_as_they_are(void **state)
{
    (void)state;
    const double w[] = {0.6, 0.4}, tau[] = {0.05, 20};
    struct crt_phosphor p = model_phosphor(2, w, tau);
    struct crt_tube_row vector = model_row(0.25, 0.1), raster = line_model_row(40, 30, 0.5);
    struct crt_film film[4];
    uint32_t paint_seed = 2;
    vector.width.value = vector.height.value = 20;
    struct raster r = small_raster(1, &paint_seed);
    for (int n = 0; n < 4; n++) {
        struct crt_error err;
        uint32_t seed = 4;
        struct crt_tube *tube =
            n & 2 ? raster_tube(&raster, &p, (struct crt_knobs){0, 1, 0}, 64, 48, 0, 0)
                  : vector_tube(&vector, &p, 64, 48);
        struct crt_photodiode *d[3] = {NULL};
        for (int k = 0; k < 3 && (n & 1); k++)
            d[k] = open_diode(tube, (enum crt_photodiode_kind)k, 0.5, 0.5, 1.5);
        assert_true(crt_film_init(&film[n], tube, &err));
        crt_film_open(tube, &film[n], MS, 30 * MS);
        if (n & 2)
            field(tube, &r, 0, 0);
        else
            draw(tube, &seed, 0, 100, 4);
        crt_tube_advance(tube, 5 * MS);
        for (int k = 0; k < 3 && (n & 1); k++)
            assert_true(crt_photodiode_luminance(d[k], 3 * MS) > 0);
        crt_tube_advance(tube, 40 * MS);
        assert_true(film[n].complete);
        for (int k = 0; k < 3; k++)
            crt_photodiode_close(d[k]);
        crt_tube_destroy(tube);
    }
    for (int n = 0; n < 4; n += 2) {
        size_t bytes = 64 * 48 * sizeof(float);
        assert_memory_equal(film[n].light[0], film[n + 1].light[0], bytes);
        crt_film_free(&film[n]);
        crt_film_free(&film[n + 1]);
    }
    unpaint(&r);
}

static void nonsense_is_refused(void **state)
{
    (void)state;
    const double w[] = {1}, tau[] = {1};
    struct crt_phosphor p = model_phosphor(1, w, tau);
    struct crt_tube_row row = model_row(0.25, 0.1);
    struct crt_tube *tube = vector_tube(&row, &p, 8, 8);
    static const struct crt_photodiode_desc bad[] = {{CRT_DIODE_POINT, NAN, 0, 0},
                                                     {CRT_DIODE_POINT, 0, 1e300, 0},
                                                     {CRT_DIODE_DISC, 0, 0, 0},
                                                     {CRT_DIODE_DISC, 0, 0, -1},
                                                     {CRT_DIODE_DISC, 0, 0, NAN}};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        struct crt_error err = {""};
        assert_null(crt_photodiode_open(tube, &bad[i], &err));
        assert_true(strlen(err.text) > 10);
    }
    crt_tube_destroy(tube);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(point_is_as_the_probe),
        cmocka_unit_test(lines_are_as_the_probe),
        cmocka_unit_test(disc_is_the_mean_of_points),
        cmocka_unit_test(disc_sees_of_a_spot_what_falls_on_it),
        cmocka_unit_test(wide_disc_has_all_the_energy),
        cmocka_unit_test(screen_has_all_the_energy),
        cmocka_unit_test(screen_has_all_of_a_line),
        cmocka_unit_test(shares_sum_to_the_luminance),
        cmocka_unit_test(integrals_are_those_of_samples),
        cmocka_unit_test(opened_while_it_runs),
        cmocka_unit_test(forgetting_changes_nothing),
        cmocka_unit_test(snapshots_restart_it),
        cmocka_unit_test(cutting_time_changes_nothing),
        cmocka_unit_test(films_stay_as_they_are),
        cmocka_unit_test(nonsense_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
