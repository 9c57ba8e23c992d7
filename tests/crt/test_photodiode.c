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
    for (int i = 0; i < 600; i++) {
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
        struct crt_tube *tube =
            raster_tube(&row, colour ? &three : &one, knobs, 64, 64, x, y);
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(point_is_as_the_probe),
        cmocka_unit_test(lines_are_as_the_probe),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
