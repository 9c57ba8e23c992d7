/* Each built-in tube: a full-drive line at the row's speed and refresh has the row's luminance on
 * film, and `auto` gain develops it to 0.8 of white. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "crt/develop.h"
#include "crt/tube.h"
#include "tests/support/tube_model.h"

#define COLS 96
#define ROWS 48

/* The inverse of the sRGB encoding, by the standard's formula. */
static double linear(double v)
{
    return v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
}

/* Some refreshes of a line through the middle of row 24 in the steady state. */
static void steady_line(const struct crt_tube_desc *desc, double speed_mm_us, struct crt_film *film,
                        uint64_t refreshes)
{
    const struct crt_phosphor *p = desc->phosphor;
    double longest = 0, cell = desc->grid.cell_mm;
    for (int k = 0; k < p->terms; k++)
        longest = fmax(longest, p->term[k].tau_s);
    double hz = (double)desc->epoch.num / (double)desc->epoch.den;
    uint64_t settle = (uint64_t)ceil(9 * longest * hz) + 2;
    struct crt_error err;
    struct crt_tube *tube = crt_tube_create(desc, &err);
    assert_non_null(tube);
    assert_true(crt_film_init(film, tube, &err));
    double half = COLS * cell, y = -cell / 2;
    for (uint64_t n = 0; n < settle + refreshes; n++) {
        uint64_t t = crt_tick_time(desc->epoch, n), end = crt_tick_time(desc->epoch, n + 1);
        if (n == settle)
            crt_film_open(tube, film, t, crt_tick_time(desc->epoch, n + refreshes));
        struct crt_stroke s = {.t0 = t,
                               .t1 = t + (uint64_t)(2 * half / speed_mm_us * 1e6),
                               .x0 = (float)-half,
                               .x1 = (float)half,
                               .y0 = (float)y,
                               .y1 = (float)y,
                               .drive = 1};
        crt_tube_stroke(tube, &s);
        crt_tube_advance(tube, end);
    }
    assert_true(film->complete);
    crt_tube_destroy(tube);
}

static void line_luminance_and_auto_gain(void **state)
{
    (void)state;
    size_t count;
    const struct crt_tube_row *row = crt_tube_rows(&count);
    for (size_t i = 0; i < count; i++, row++) {
        if (row->kind != CRT_VECTOR_TUBE)
            continue;
        struct crt_tube_desc desc = {
            .row = row,
            .phosphor = crt_phosphor_find(row->phosphor),
            .grid = crt_tube_grid(row),
            .epoch = {(uint64_t)(row->line_refresh.value * 1000), 1000},
            .knobs = {0, 1, 0},
            .threads = 1,
        };
        double cell = desc.grid.cell_mm; /* the film's own cells, fewer of them */
        desc.grid = (struct crt_grid){COLS, ROWS, cell, -COLS * cell / 2, ROWS * cell / 2};
        struct crt_film film;
        /* Whatever the exposure, as long as it is of whole refreshes. */
        steady_line(&desc, row->line_speed.value, &film, 1 + i % 3);
        double exposure = (double)(film.t1 - film.t0) * 1e-12, crest = 0;
        size_t middle = 24 * COLS + COLS / 2;
        for (int c = 0; c < film.colours; c++)
            crest += (double)film.light[c][middle] / exposure;
        double off = crest / row->line_luminance.value - 1;
        struct crt_image image;
        struct crt_error err;
        assert_true(crt_develop(&film, desc.phosphor, crt_auto_gain(row), 16, 1, &image, &err));
        const uint16_t *rgb = image.samples + 3 * middle;
        double y = 0.2126390 * linear(rgb[0] / 65535.0) + 0.7151687 * linear(rgb[1] / 65535.0) +
                   0.0721923 * linear(rgb[2] / 65535.0);
        print_message("# %s (%s): %.3f cd/m2 of %g; developed to %.4f of white\n", row->name,
                      desc.phosphor->name, crest, row->line_luminance.value, y);
        assert_true(fabs(off) < 2e-3);
        assert_true(fabs(y - 0.8) < 2e-3);
        crt_image_free(&image);
        crt_film_free(&film);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(line_luminance_and_auto_gain),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
