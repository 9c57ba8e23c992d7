/* diode_rig.h — tubes, strokes and rasters for tests of photodiodes.
 *
 * Models:     small tubes of model rows; random strokes one after the other; rasters of random dots.
 * Units:      mm, ps.
 * Ownership:  tubes, diodes and rasters are the test's.
 * Errors:     asserts.
 */
#ifndef DIODE_RIG_H
#define DIODE_RIG_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "crt/photodiode.h"
#include "tests/support/tube_model.h"

#define US CRT_PS_PER_US
#define MS CRT_PS_PER_MS

static inline struct crt_tube *vector_tube(const struct crt_tube_row *row,
                                           const struct crt_phosphor *p, int cols, int rows)
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

static inline struct crt_photodiode *open_diode(struct crt_tube *tube,
                                                enum crt_photodiode_kind kind, double x, double y,
                                                double diameter)
{
    struct crt_error err;
    struct crt_photodiode_desc desc = {kind, x, y, diameter};
    struct crt_photodiode *d = crt_photodiode_open(tube, &desc, &err);
    assert_non_null(d);
    return d;
}

static inline void assert_close(double got, double want, double tolerance)
{
    if (!(fabs(got - want) <= tolerance))
        print_message("# got %.15g, want %.15g, off %.3g, allowed %.3g\n", got, want,
                      fabs(got - want), tolerance);
    assert_true(fabs(got - want) <= tolerance);
}

/* A few strokes at random near the middle, one after the other from t on; returns the end. */
static inline uint64_t draw(struct crt_tube *tube, uint32_t *seed, uint64_t t, int count,
                            double size)
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

static inline struct crt_tube *raster_tube(const struct crt_tube_row *row,
                                           const struct crt_phosphor *p, struct crt_knobs knobs,
                                           int cols, int rows, double x, double y)
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

static inline struct crt_scan_line line_of(const struct raster *r, int n, uint64_t t0)
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

static inline uint64_t field(struct crt_tube *tube, const struct raster *r, int first, uint64_t t0)
{
    for (int n = first; n < r->count; n += r->step, t0 += r->line) {
        struct crt_scan_line l = line_of(r, n, t0);
        crt_tube_scan_line(tube, &l);
    }
    return t0;
}

static inline void paint(struct raster *r, uint32_t *seed)
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

static inline void unpaint(struct raster *r)
{
    for (int gun = 0; gun < r->guns; gun++)
        free(r->drive[gun]);
}

/* What two tubes' rows have in common here: 40 × 30 mm, 96 lines of 128 dots. */
static inline struct raster small_raster(int guns, uint32_t *seed)
{
    struct raster r = {40, 30, 96, 128, 1, 22 * US, 18 * US, {NULL, NULL, NULL}, guns};
    paint(&r, seed);
    return r;
}

#endif
