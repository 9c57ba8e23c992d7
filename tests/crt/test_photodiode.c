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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(point_is_as_the_probe),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
