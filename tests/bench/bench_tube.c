/* Speed of the tube: 1000 random long vectors a refresh on a 9.25" tube of 0.02" spots, P39-like
 * phosphor, one exposure a refresh. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "crt/tube.h"
#include "tests/support/tube_model.h"

#define VECTORS   1000
#define UNITS     1024
#define SCREEN_MM (9.25 * 25.4)
#define SIGMA_MM  (0.508 / 2.02)

/* Of this thread, so that other work on the machine does not count. */
static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* A refresh's vectors from t0 on: |Δ| <= 100 units on each axis, 2 us + 0.1 us a unit of the
 * longer. */
static void draw(struct crt_tube *tube, uint64_t t0, uint32_t *seed)
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
        crt_tube_stroke(tube, &s);
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

/* Reading and writing what a refresh must: plane read and written, film written. */
static double floor_ns(size_t cells)
{
    float *plane = calloc(cells, sizeof *plane), *film = calloc(cells, sizeof *film);
    double best = 1e9;
    for (int round = 0; round < 20; round++) {
        double start = seconds();
        for (size_t i = 0; i < cells; i++) {
            film[i] = plane[i] * 0.2F;
            plane[i] = plane[i] * 0.8F + 1e-3F;
        }
        __asm__ volatile("" ::"r"(plane), "r"(film) : "memory");
        double took = seconds() - start;
        best = took < best ? took : best;
    }
    free(plane);
    free(film);
    return best * 1e9 / (double)cells;
}

static void measure(enum crt_simd simd, const char *name, bool changing, int refreshes)
{
    struct crt_tube_row row = model_row(SIGMA_MM, 0);
    const double w[] = {1}, tau_ms[] = {150 / 2.303};
    struct crt_phosphor phosphor = model_phosphor(1, w, tau_ms);
    struct crt_screen screen = {SCREEN_MM, SCREEN_MM, UNITS, UNITS};
    struct crt_tube_desc desc = {
        .row = &row,
        .phosphor = &phosphor,
        .grid = crt_grid_cover(&screen, 2, SIGMA_MM),
        .epoch = {60, 1},
        .knobs = {0, 1, 0},
        .threads = 1,
        .simd = simd,
    };
    struct crt_error err;
    struct crt_film film;
    struct crt_tube *tube = crt_tube_create(&desc, &err);
    if (!tube || !crt_film_init(&film, tube, &err)) {
        printf("tube: %s skipped: %s\n", name, err.text);
        return;
    }
    uint32_t seed = 1;
    double start = 0, each = 1e9;
    const int warm = 20, block = 25;
    for (int n = 0; n < warm + refreshes; n++) {
        if (n >= warm && (n - warm) % block == 0)
            start = seconds();
        if (!changing)
            seed = 1;
        uint64_t t0 = crt_tick_time(desc.epoch, (uint64_t)n);
        uint64_t t1 = crt_tick_time(desc.epoch, (uint64_t)n + 1);
        crt_film_open(tube, &film, t0, t1);
        draw(tube, t0, &seed);
        crt_tube_advance(tube, t1);
        /* The best block, since the machine may have other work that takes its cache and memory. */
        if (n >= warm && (n - warm) % block == block - 1)
            each = fmin(each, (seconds() - start) / block);
    }
    size_t lit = lit_cells(&film);
    double floor = floor_ns((size_t)desc.grid.cols * (size_t)desc.grid.rows);
    printf("tube: %s %s %.0f refreshes/s, %.2f ns per lit cell (%zu lit of %d x %d; "
           "memory floor %.2f ns per cell)\n",
           changing ? "changing" : "static", name, 1 / each, each * 1e9 / (double)lit, lit,
           desc.grid.cols, desc.grid.rows, floor);
    crt_film_free(&film);
    crt_tube_destroy(tube);
}

int main(int argc, char **argv)
{
    const char *only = argc > 1 ? argv[1] : "";
    for (int changing = 1; changing >= 0; changing--)
        for (int avx2 = 0; avx2 <= 1; avx2++)
            if (!*only || strcmp(only, changing ? "changing" : "static") == 0 ||
                strcmp(only, avx2 ? "avx2" : "baseline") == 0)
                measure(avx2 ? CRT_SIMD_AVX2 : CRT_SIMD_BASELINE, avx2 ? "avx2" : "baseline",
                        changing, 400);
    return 0;
}
