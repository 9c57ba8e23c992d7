/* Film and probe against the slow exact integral where it is hardest: at the edges of the grid, of
 * epochs and of exposures, in a close-up, over very short and very long times. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crt/spot.h"
#include "crt/tube.h"
#include "tests/support/tube_model.h"

#define SIGMA 0.25
#define MANY  4096
#define FILMS 4

struct scene {
    struct crt_tube_row row;
    struct crt_phosphor phosphor;
    struct crt_tube_desc desc;
    struct crt_knobs knobs[MANY];
    struct model_stroke stroke[MANY];
    int count;
    struct crt_film film[FILMS];
    uint64_t step; /* of advance, 0: all at once */
};

static struct scene scene; /* too large for the stack */

static void set_up(const struct crt_phosphor *phosphor, int cols, int rows, double cell)
{
    memset(&scene, 0, sizeof scene);
    scene.row = model_row(SIGMA, 0.1);
    scene.phosphor = *phosphor;
    scene.desc = (struct crt_tube_desc){
        .row = &scene.row,
        .phosphor = &scene.phosphor,
        .grid = {cols, rows, cell, -cols * cell / 2, rows * cell / 2},
        .epoch = {60, 1},
        .knobs = {0, 1, 0},
        .threads = 1,
    };
}

static void add(struct crt_stroke s, struct crt_knobs knobs)
{
    struct crt_spot spot = crt_spot_at(&scene.row, &knobs, (double)s.drive);
    assert_true(scene.count < MANY);
    scene.knobs[scene.count] = knobs;
    scene.stroke[scene.count++] = (struct model_stroke){s, spot.power, spot.sigma_mm};
}

static void line(uint64_t t0, uint64_t t1, double x0, double y0, double x1, double y1, double drive)
{
    struct crt_stroke s = {.t0 = t0,
                           .t1 = t1,
                           .x0 = (float)x0,
                           .y0 = (float)y0,
                           .x1 = (float)x1,
                           .y1 = (float)y1,
                           .drive = (float)drive};
    add(s, scene.desc.knobs);
}

/* Light of one film cell by the slow integral. */
static double exact(const struct crt_film *film, int col, int row)
{
    double x = film->grid.left_mm + (col + 0.5) * film->grid.cell_mm;
    double y = film->grid.top_mm - (row + 0.5) * film->grid.cell_mm;
    return model_light(scene.stroke, scene.count, &scene.phosphor, 0, x, y, film->t0, film->t1);
}

/* The greatest difference on `samples` cells, over the peak. */
static double worst(const struct crt_film *film, int samples)
{
    int cols = film->grid.cols, rows = film->grid.rows;
    uint32_t seed = 77;
    double peak = 0, most = 0;
    size_t brightest = 0;
    for (size_t i = 0; i < (size_t)cols * (size_t)rows; i++)
        if (film->light[0][i] > film->light[0][brightest])
            brightest = i;
    for (int n = 0; n < samples; n++) {
        size_t i = model_random(&seed) % ((uint32_t)cols * (uint32_t)rows);
        for (int tries = 0; tries < 50 && n % 4 && !(film->light[0][i] > 0); tries++)
            i = model_random(&seed) % ((uint32_t)cols * (uint32_t)rows);
        i = n == 0 ? brightest : i;
        double want = exact(film, (int)(i % (size_t)cols), (int)(i / (size_t)cols));
        peak = fmax(peak, want);
        most = fmax(most, fabs((double)film->light[0][i] - want));
    }
    assert_true(peak > 1e-6);
    return most / peak;
}

static struct crt_tube *run(const uint64_t (*intervals)[2], int films)
{
    struct crt_error err;
    struct crt_tube *tube = crt_tube_create(&scene.desc, &err);
    assert_non_null(tube);
    uint64_t end = 0, now = 0;
    for (int i = 0; i < films; i++) {
        assert_true(crt_film_init(&scene.film[i], tube, &err));
        crt_film_open(tube, &scene.film[i], intervals[i][0], intervals[i][1]);
        end = intervals[i][1] > end ? intervals[i][1] : end;
    }
    int next = 0;
    while (now < end) {
        now = scene.step && now + scene.step < end ? now + scene.step : end;
        for (; next < scene.count && scene.stroke[next].stroke.t0 < now; next++) {
            crt_tube_set_knobs(tube, scene.knobs[next]);
            crt_tube_stroke(tube, &scene.stroke[next].stroke);
        }
        crt_tube_advance(tube, now);
    }
    assert_true(crt_tube_intact(tube, &err));
    return tube;
}

static void films_agree(const char *what, const uint64_t (*intervals)[2], int films, double allowed)
{
    struct crt_tube *tube = run(intervals, films);
    for (int i = 0; i < films; i++) {
        assert_true(scene.film[i].complete);
        double off = worst(&scene.film[i], 24);
        print_message("# %s, film %d: off by %.2e of peak\n", what, i, off);
        assert_true(off < allowed);
        crt_film_free(&scene.film[i]);
    }
    crt_tube_destroy(tube);
}

static const struct crt_phosphor *named(const char *name)
{
    const struct crt_phosphor *p = crt_phosphor_find(name);
    assert_non_null(p);
    return p;
}

#define US CRT_PS_PER_US
#define MS CRT_PS_PER_MS
#define S  CRT_PS_PER_S

/* Strokes that leave the grid by a side or a corner, run along its edge, or lie just outside. */
static void across_the_edge(void **state)
{
    (void)state;
    set_up(named("P31"), 64, 48, SIGMA);
    double w = 32 * SIGMA, h = 24 * SIGMA;
    uint64_t t = 10 * US;
    const double ends[][4] = {{w - 2, 1, w + 5, 3},
                              {-w - 3, -h - 3, -w + 4, -h + 4},
                              {-w, h, w, h},
                              {w + 0.3, -2, w + 0.3, 2},
                              {-1, -h - 0.4, 3, -h},
                              {w - 0.1, h - 0.1, w - 0.1, h - 0.1},
                              {-300, -1.37, 400, 1.21},
                              {0.3, -900, -0.9, 800},
                              {-w + 0.02, -6, -w - 0.03, 6}};
    for (unsigned i = 0; i < sizeof ends / sizeof ends[0]; i++, t += 60 * US)
        line(t, t + 50 * US, ends[i][0], ends[i][1], ends[i][2], ends[i][3], 0.7);
    const uint64_t when[][2] = {{0, S / 60}, {t - 70 * US, t + 5 * US}};
    films_agree("edge", when, 2, 1e-3);
}

/* One stroke over three and a half epochs, seen in parts. */
static void longer_than_an_epoch(void **state)
{
    (void)state;
    const char *const names[] = {"P39", "P31", "P46", "P33"};
    for (unsigned i = 0; i < 4; i++) {
        set_up(named(names[i]), 64, 48, SIGMA);
        line(5 * MS, 63 * MS, -7, -5, 7.3, 5.2, 1);
        const uint64_t when[][2] = {
            {0, 100 * MS}, {20 * MS, 21 * MS}, {30 * MS, 52 * MS}, {62 * MS, 64 * MS}};
        scene.step = 3 * MS;
        films_agree(names[i], when, 4, 1e-3);
    }
}

/* A microsecond in the middle of a stroke of 40 µs, the phosphor faster than that. */
static void a_microsecond_of_p46(void **state)
{
    (void)state;
    set_up(named("P46"), 128, 48, SIGMA);
    line(100 * US, 140 * US, -14, -3, 14, 4, 1);
    const uint64_t when[][2] = {{120 * US, 121 * US},
                                {120 * US + 400000, 120 * US + 500000},
                                {139 * US + 700000, 140 * US + 300000},
                                {140 * US, 141 * US}};
    films_agree("P46", when, 4, 1e-3);
}

/* Overlapping films, one within the other, sharing an end. */
static void overlapping_films(void **state)
{
    (void)state;
    set_up(named("P1"), 64, 48, SIGMA);
    uint32_t seed = 4;
    for (uint64_t t = 0; t < 50 * MS; t += 400 * US)
        line(t, t + 350 * US, model_uniform(&seed, -7, 7), model_uniform(&seed, -5, 5),
             model_uniform(&seed, -7, 7), model_uniform(&seed, -5, 5),
             model_uniform(&seed, 0.3, 1));
    const uint64_t when[][2] = {
        {3 * MS, 41 * MS}, {10 * MS, 41 * MS}, {10 * MS, 20 * MS}, {33333333333, 50000000000}};
    scene.step = 700 * US;
    films_agree("overlap", when, 4, 1e-3);
}

/* P33, drawn for two seconds, watched for twenty: light is still there at the end. */
static void twenty_seconds_of_p33(void **state)
{
    (void)state;
    set_up(named("P33"), 64, 48, SIGMA);
    for (uint64_t n = 0; n < 120; n++) {
        uint64_t t = n * S / 60 + 1000 * US;
        line(t, t + 40 * US, -6, -4 + 0.06 * (double)n, 6, 4 - 0.05 * (double)n, 1);
    }
    const uint64_t when[][2] = {{0, 20 * S}, {2 * S, 2 * S + S / 60}, {8 * S, 8 * S + S / 60}};
    scene.step = S / 60;
    films_agree("P33", when, 3, 1e-3);
}

/* Under the microscope: sigma is 60 cells and more. */
static void close_up(void **state)
{
    (void)state;
    set_up(named("P31"), 200, 160, SIGMA / 60);
    line(0, 3 * US, -20, -20.1, 20, 19.8, 1);
    line(10 * US, 11 * US, 0.1, -0.05, 0.1, -0.05, 0.8);
    line(20 * US, 21 * US, 0.1, -0.05, 0.14, 0.02, 0.8);
    line(40 * US, 41 * US, -0.6, 0.1, 0.2, 0.1, 0.5);
    const uint64_t when[][2] = {{0, S / 60}, {10 * US + 500000, 30 * US}};
    films_agree("close-up", when, 2, 1e-3);
    /* And far beyond: one cell is as bright as the next. */
    set_up(named("P31"), 64, 48, SIGMA / 40000);
    line(0, 3 * US, -20, -20.1, 20, 19.8, 1);
    line(10 * US, 11 * US, 0.1, -0.05, 0.1, -0.05, 0.8);
    films_agree("microscope", when, 2, 1e-3);
}

/* The knobs act on what is drawn from then on; no drive, no light. */
static void knobs_turned_while_running(void **state)
{
    (void)state;
    set_up(named("P39"), 64, 48, SIGMA);
    const struct crt_knobs turned[] = {{0, 1, 0},  {-0.3, 1, 0}, {0.2, 0.5, 0}, {0, 2, 1.5},
                                       {-1, 1, 0}, {0, 0, 0},    {0.6, 0, 2}};
    uint64_t t = 0;
    for (unsigned i = 0; i < 35; i++, t += 2 * MS) {
        struct crt_stroke s = {.t0 = t,
                               .t1 = t + MS,
                               .x0 = -6,
                               .x1 = 6,
                               .y0 = (float)(-5 + 0.3 * i),
                               .y1 = (float)(-4.8 + 0.3 * i),
                               .drive = i % 3 == 2 ? 0
                                        : i % 3    ? 1
                                                   : 0.5F};
        add(s, turned[i / 5]);
    }
    const uint64_t when[][2] = {{0, 80 * MS}, {31 * MS, 47 * MS}};
    films_agree("knobs", when, 2, 1e-3);
}

/* Epochs of ten seconds and of ten microseconds. */
static void slow_and_fast_epochs(void **state)
{
    (void)state;
    static const struct crt_rate rate[] = {{1, 10}, {100000, 1}};
    static const char *const names[] = {"P31", "P39", "P46"};
    for (unsigned r = 0; r < 2; r++)
        for (unsigned i = 0; i < 3; i++) {
            set_up(named(names[i]), 64, 48, SIGMA);
            scene.desc.epoch = rate[r];
            for (uint64_t t = 0; t < 30 * MS; t += 300 * US)
                line(t, t + 250 * US, -6, -4 + 0.25 * (double)(t / (US * 1000)), 6, 4, 1);
            const uint64_t when[][2] = {{0, 40 * MS}, {20 * MS, 21 * MS}, {35 * MS, 60 * MS}};
            print_message("# %u/%u Hz\n", (unsigned)rate[r].num, (unsigned)rate[r].den);
            films_agree(names[i], when, i == 2 ? 2 : 3, 1e-3);
        }
}

/* A hundred faint strokes on one line while the phosphor falls to 1/e, and a bright spot elsewhere:
 * what is allowed to be off for each of them must not add up. */
static void many_faint_strokes(void **state)
{
    (void)state;
    const double one[] = {1}, tau[] = {2};
    struct crt_phosphor p = model_phosphor(1, one, tau);
    for (int count = 30; count <= 3000; count *= 10) {
        set_up(&p, 64, 48, SIGMA);
        scene.row.spot_growth.value = 0;
        uint64_t length = 2 * MS / (unsigned)count, t = 10 * MS;
        line(t - MS, t - MS + length, -4, 3, -4, 3, 1);
        for (int i = 0; i < count; i++, t += length)
            line(t, t + length, -6, -2, 6, -2, 1);
        const uint64_t when[][2] = {{0, t}, {9 * MS, 10 * MS + 300 * US}, {t, t + 200 * US}};
        films_agree("faint", when, 3, 1e-3);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(across_the_edge),
        cmocka_unit_test(longer_than_an_epoch),
        cmocka_unit_test(a_microsecond_of_p46),
        cmocka_unit_test(overlapping_films),
        cmocka_unit_test(twenty_seconds_of_p33),
        cmocka_unit_test(close_up),
        cmocka_unit_test(knobs_turned_while_running),
        cmocka_unit_test(slow_and_fast_epochs),
        cmocka_unit_test(many_faint_strokes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
