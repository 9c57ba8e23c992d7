/* Speed of the tube: 1000 random long vectors a refresh on a 9.25" tube of 0.02" spots, P39-like
 * phosphor, one exposure a refresh. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crt/tube.h"
#include "tests/support/bench.h"
#include "tests/support/tube_model.h"

#define VECTORS   1000
#define BLOCK     15 /* refreshes timed together */
#define ROUNDS    24
#define UNITS     1024
#define SCREEN_MM (9.25 * 25.4)
#define SIGMA_MM  (0.508 / CRT_WIDTH60_SIGMA)

/* A refresh's vectors from t0 on: |Δ| <= 100 units on each axis, 2 us + 0.1 us a unit of the
 * longer. */
static void make_picture(struct crt_stroke *strokes, uint64_t t0, uint32_t *seed)
{
    const double unit = SCREEN_MM / UNITS;
    for (int i = 0; i < VECTORS; i++) {
        double x = model_uniform(seed, 0, UNITS), y = model_uniform(seed, 0, UNITS), dx, dy;
        do {
            dx = model_uniform(seed, -100, 100);
            dy = model_uniform(seed, -100, 100);
        } while (x + dx < 0 || x + dx > UNITS || y + dy < 0 || y + dy > UNITS);
        uint64_t lit = (uint64_t)((2 + 0.1 * fmax(fabs(dx), fabs(dy))) * 1e6);
        struct crt_stroke s = {
            .t0 = t0,
            .t1 = t0 + lit,
            .x0 = (float)((x - UNITS / 2) * unit),
            .y0 = (float)((y - UNITS / 2) * unit),
            .x1 = (float)((x + dx - UNITS / 2) * unit),
            .y1 = (float)((y + dy - UNITS / 2) * unit),
            .drive = 1,
        };
        strokes[i] = s;
        t0 = s.t1 + 1000;
    }
}

static size_t lit_cells(const struct crt_film *film)
{
    size_t lit = 0, cells = (size_t)film->grid.cols * (size_t)film->grid.rows;
    for (size_t i = 0; i < cells; i++)
        lit += film->light[0][i] > 0;
    return lit;
}

struct contest {
    const char *name;
    enum crt_simd simd;
    bool changing, wanted;
    struct crt_tube_desc desc;
    struct crt_tube *tube;
    struct crt_film film;
    uint64_t epoch;
    uint32_t seed;
    double best; /* seconds a refresh */
};

static struct crt_tube_row row;
static struct crt_phosphor phosphor;

static bool set_up(struct contest *c)
{
    struct crt_screen screen = {SCREEN_MM, SCREEN_MM, UNITS, UNITS};
    struct crt_error err;
    c->desc = (struct crt_tube_desc){
        .row = &row,
        .phosphor = &phosphor,
        .grid = crt_grid_cover(&screen, 2, SIGMA_MM),
        .epoch = {60, 1},
        .knobs = {0, 1, 0},
        .threads = 1,
        .simd = c->simd,
    };
    c->seed = 1;
    c->best = 1e9;
    c->tube = crt_tube_create(&c->desc, &err);
    if (c->tube && crt_film_init(&c->film, c->tube, &err))
        return true;
    printf("tube: %s skipped: %s\n", c->name, err.text);
    return false;
}

/* Seconds that the tube took; making the picture is another's work. */
static double refresh(struct contest *c)
{
    static struct crt_stroke strokes[VECTORS];
    uint64_t t0 = crt_tick_time(c->desc.epoch, c->epoch);
    uint64_t t1 = crt_tick_time(c->desc.epoch, ++c->epoch);
    if (!c->changing)
        c->seed = 1;
    make_picture(strokes, t0, &c->seed);
    double start = bench_seconds();
    crt_film_open(c->tube, &c->film, t0, t1);
    for (int i = 0; i < VECTORS; i++)
        crt_tube_stroke(c->tube, &strokes[i]);
    crt_tube_advance(c->tube, t1);
    return bench_seconds() - start;
}

/* One round of a contest. The best of many rounds counts, and the contests take turns, since the
 * machine may have other work that takes its cache and memory for a while. */
static void compete(struct contest *c)
{
    refresh(c);
    double sum = 0;
    for (int n = 0; n < BLOCK; n++)
        sum += refresh(c);
    c->best = fmin(c->best, sum / BLOCK);
}

int main(int argc, char **argv)
{
    struct contest contests[] = {
        {.name = "changing baseline", .simd = CRT_SIMD_BASELINE, .changing = true},
        {.name = "changing avx2", .simd = CRT_SIMD_AVX2, .changing = true},
        {.name = "static baseline", .simd = CRT_SIMD_BASELINE},
        {.name = "static avx2", .simd = CRT_SIMD_AVX2},
    };
    const double w[] = {1}, tau_ms[] = {150 / 2.303};
    double floor = 1e9;
    row = model_row(SIGMA_MM, 0);
    phosphor = model_phosphor(1, w, tau_ms);
    for (int i = 0; i < 4; i++)
        contests[i].wanted =
            (argc < 2 || strstr(contests[i].name, argv[1])) && set_up(&contests[i]);
    for (int round = 0; round < ROUNDS; round++)
        for (int i = 0; i < 4; i++)
            if (contests[i].wanted) {
                compete(&contests[i]);
                floor = fmin(floor, bench_floor_ns((size_t)contests[i].desc.grid.cols *
                                                   (size_t)contests[i].desc.grid.rows));
            }
    for (int i = 0; i < 4; i++) {
        struct contest *c = &contests[i];
        if (!c->wanted)
            continue;
        size_t lit = lit_cells(&c->film);
        printf("tube: %s %.0f refreshes/s, %.2f ns per lit cell (%zu of %d x %d cells lit; memory "
               "floor %.2f ns per cell)\n",
               c->name, 1 / c->best, c->best * 1e9 / (double)lit, lit, c->desc.grid.cols,
               c->desc.grid.rows, floor);
        crt_film_free(&c->film);
        crt_tube_destroy(c->tube);
    }
    return 0;
}
