/* Light of scan lines on film against an exact model: dots, edges, corners, growth, shares, cuts. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crt/tube.h"
#include "tests/support/line_model.h"
#include "tests/support/tube_model.h"

#define MOST_LINES 400
#define MOST_DOTS  640

/* A tube and what is scanned on it. */
struct scene {
    struct crt_tube_row row;
    struct crt_phosphor phosphor;
    struct crt_knobs knobs;
    struct crt_grid grid;
    struct crt_rate epoch;
    int count;
    struct crt_scan_line line[MOST_LINES];
    uint8_t drive[MOST_LINES][3][MOST_DOTS];
};

static struct scene scene;

static void begin(struct crt_tube_row row, struct crt_phosphor phosphor)
{
    memset(&scene, 0, sizeof scene);
    scene.row = row;
    scene.phosphor = phosphor;
    scene.knobs = (struct crt_knobs){0, 1, 0};
    scene.grid = crt_tube_grid(&scene.row);
    scene.epoch = (struct crt_rate){60, 1};
}

static struct crt_phosphor plain(double tau_ms)
{
    const double w[] = {1};
    return model_phosphor(1, w, &tau_ms);
}

/* A line of `dots` dark dots across the screen at y. */
static struct crt_scan_line *add_line(uint64_t t0, uint64_t lit, double y, int dots)
{
    struct crt_scan_line *line = &scene.line[scene.count];
    double half = scene.row.width.value / 2;
    assert_true(scene.count < MOST_LINES && dots <= MOST_DOTS);
    *line = (struct crt_scan_line){.t0 = t0,
                                   .t1 = t0 + lit,
                                   .x0 = (float)-half,
                                   .x1 = (float)half,
                                   .y0 = (float)y,
                                   .y1 = (float)y,
                                   .dots = dots,
                                   .guns = crt_tube_guns(&scene.row),
                                   .source = (uint32_t)scene.count};
    for (int gun = 0; gun < 3; gun++)
        line->drive[gun] = scene.drive[scene.count][gun];
    scene.count++;
    return line;
}

/* Dots at random, a third of them white and a third black. */
static void randomize(int line, uint32_t *seed)
{
    for (int gun = 0; gun < 3; gun++)
        for (int i = 0; i < scene.line[line].dots; i++) {
            uint32_t r = model_random(seed);
            scene.drive[line][gun][i] = r % 3 == 0 ? 255 : r % 3 == 1 ? 0 : (uint8_t)(r >> 8);
        }
}

static struct crt_tube *new_tube(void)
{
    struct crt_error err;
    const struct crt_tube_desc desc = {.row = &scene.row,
                                       .phosphor = &scene.phosphor,
                                       .grid = scene.grid,
                                       .epoch = scene.epoch,
                                       .knobs = scene.knobs,
                                       .threads = 1};
    struct crt_tube *tube = crt_tube_create(&desc, &err);
    if (!tube)
        fail_msg("%s", err.text);
    return tube;
}

static struct crt_film film_of(uint64_t a, uint64_t b)
{
    struct crt_error err;
    struct crt_tube *tube = new_tube();
    struct crt_film film;
    assert_true(crt_film_init(&film, tube, &err));
    int next = 0;
    for (; next < scene.count && scene.line[next].t0 < a; next++)
        crt_tube_scan_line(tube, &scene.line[next]);
    crt_tube_advance(tube, a);
    crt_film_open(tube, &film, a, b);
    for (; next < scene.count && scene.line[next].t0 < b; next++)
        crt_tube_scan_line(tube, &scene.line[next]);
    crt_tube_advance(tube, b);
    assert_true(film.complete);
    assert_true(crt_tube_intact(tube, &err));
    crt_tube_destroy(tube);
    return film;
}

struct region {
    int col, row, cols, rows;
};

static const struct region everywhere = {0, 0, 0, 0};

/* `count` cells of the region compared; parts of the film's peak. */
static double worst_of(uint64_t a, uint64_t b, struct region in, int count, uint32_t seed)
{
    struct crt_film film = film_of(a, b);
    const struct line_model model = {&scene.row, &scene.phosphor, scene.knobs};
    const struct crt_grid *g = &scene.grid;
    double worst = 0;
    if (in.cols == 0)
        in = (struct region){0, 0, g->cols, g->rows};
    for (int colour = 0; colour < film.colours; colour++) {
        double peak = 0, off = 0;
        for (int i = 0; i < g->cols * g->rows; i++)
            peak = fmax(peak, (double)film.light[colour][i]);
        for (int i = 0; i < count; i++) {
            int col = in.col + (int)(model_random(&seed) % (uint32_t)in.cols);
            int row = in.row + (int)(model_random(&seed) % (uint32_t)in.rows);
            double x, y;
            crt_cell_to_mm(g, col, row, &x, &y);
            double want = line_model_light(&model, scene.line, scene.count, colour, x, y, a, b);
            double got = (double)film.light[colour][(size_t)row * (size_t)g->cols + (size_t)col];
            off = fmax(off, fabs(got - want));
        }
        assert_true(peak > 0);
        worst = fmax(worst, off / peak);
    }
    crt_film_free(&film);
    print_message("# worst %.1e of the peak\n", worst);
    return worst;
}

#define FIELD (CRT_PS_PER_S / 60)

static void single_dots(void **state)
{
    (void)state;
    for (int dots = 32; dots <= 128; dots *= 2) {
        begin(line_model_row(30, 20, 0.45), plain(20));
        struct crt_scan_line *line = add_line(1000000, 16000000, 0.13, dots);
        scene.drive[0][0][dots / 2] = 255;
        scene.drive[0][0][3] = 140;
        scene.drive[0][0][dots - 1] = 255;
        assert_int_equal(line->dots, dots);
        double y, row;
        crt_mm_to_cell(&scene.grid, 0, 0.13, &y, &row);
        struct region near = {0, (int)row - 6, scene.grid.cols, 13};
        assert_true(worst_of(0, FIELD, near, 120, 5) < 1e-3);
    }
}

/* Slow and fast amplifiers, dots narrower and much wider than the spot. */
static void random_dots(void **state)
{
    (void)state;
    const struct {
        double bandwidth, lit_us;
        int dots;
    } kind[] = {{65, 1.5, 96}, {20, 1.5, 96}, {200, 1.5, 96},
                {5, 3, 300},   {100, 20, 20}, {65, 2, 200}};
    for (int k = 0; k < 6; k++) {
        uint32_t seed = 7 + (uint32_t)k;
        begin(line_model_row(30, 20, 0.45), plain(20));
        scene.row.bandwidth.value = kind[k].bandwidth;
        for (int n = 0; n < 64; n++) {
            add_line(1000000000 + (uint64_t)n * 30000000, (uint64_t)(kind[k].lit_us * 1e6),
                     10 - (n + 0.5) * 20 / 64, kind[k].dots);
            randomize(n, &seed);
        }
        assert_true(worst_of(0, FIELD, everywhere, 40, 5) < 1e-3);
    }
}

static void growing_spot(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        uint32_t seed = 3;
        begin(line_model_row(30, 20, 0.45), plain(20));
        scene.row.spot_growth.value = 0.1;
        if (k == 1) {
            scene.row.gun_exponent.value = 2.2;
            scene.row.spot_exponent.value = 0.5;
        }
        for (int n = 0; n < 64; n++) {
            add_line(1000000000 + (uint64_t)n * 30000000, 1500000, 10 - (n + 0.5) * 20 / 64, 96);
            randomize(n, &seed);
        }
        assert_true(worst_of(0, FIELD, everywhere, 40, 5) < 1e-3);
    }
}

/* Brightness lights dark dots and hides dim ones; contrast clips. */
static void knobs(void **state)
{
    (void)state;
    const struct crt_knobs setting[] = {
        {0.3, 0.7, 0}, {-0.2, 1.1, 0}, {0, 1.6, 0}, {0.1, 0.5, 1.2}};
    for (int k = 0; k < 4; k++) {
        uint32_t seed = 3;
        begin(line_model_row(30, 20, 0.45), plain(20));
        scene.knobs = setting[k];
        for (int n = 0; n < 64; n++) {
            add_line(1000000000 + (uint64_t)n * 30000000, 1500000, 10 - (n + 0.5) * 20 / 64, 96);
            randomize(n, &seed);
        }
        assert_true(worst_of(0, FIELD, everywhere, 50, 5) < 1.5e-3);
    }
}

/* The corners of a large tube, out of convergence and focus; in steps of time as a real one. */
static void corners(void **state)
{
    (void)state;
    static const enum crt_mask_kind mask[] = {CRT_MASK_DELTA, CRT_MASK_GRILLE};
    for (int k = 0; k < 2; k++)
        for (int corner = 0; corner < 4; corner++) {
            uint32_t seed = 11;
            begin(line_model_colour_row(320, 240, 0.445), line_model_p22());
            scene.row.mask = mask[k];
            scene.row.spot_edge.value = 1.3;
            scene.row.converge.value = 0.05;
            scene.row.converge_edge.value = 0.3;
            scene.grid = crt_tube_grid(&scene.row);
            for (int n = 0; n < 48; n++) {
                double y = 120 - (n + 0.5) * 240 / 768;
                /* Only the corner's dots, so that 640 of them are as fine as 1024 on the screen. */
                struct crt_scan_line *line =
                    add_line(1000000 + (uint64_t)n * 20677000, 1538460, corner & 1 ? y : -y, 100);
                line->x0 = corner & 2 ? -160 : 160 - 31.25F;
                line->x1 = line->x0 + 31.25F;
                randomize(n, &seed);
            }
            struct region in = {corner & 2 ? 4 : scene.grid.cols - 160,
                                corner & 1 ? 4 : scene.grid.rows - 76, 154, 72};
            assert_true(worst_of(0, FIELD, in, 50, 5) < 1.2e-3);
        }
}

/* Fields whose pictures move, exposures that begin and end anywhere, also within lines, and terms that
 * outlive lines, fields, or neither. */
static void exposures(void **state)
{
    (void)state;
    const double w[] = {0.3, 0.3, 0.2, 0.2}, tau[] = {0.006, 0.3, 2.2, 40};
    for (int k = 0; k < 2; k++) {
        uint32_t seed = 3;
        begin(k ? line_model_colour_row(30, 20, 0.45) : line_model_row(30, 20, 0.45),
              k ? line_model_p22() : model_phosphor(4, w, tau));
        for (int field = 0; field < 4; field++)
            for (int n = 0; n < 64; n++) {
                add_line((uint64_t)field * FIELD + 500000000 + (uint64_t)n * 240000000, 16000000,
                         10 - (n + 0.5) * 20 / 64, 96);
                randomize(field * 64 + n, &seed);
            }
        const struct crt_scan_line *cut = &scene.line[2 * 64 + 30];
        const struct {
            uint64_t a, b;
        } film[] = {{2 * FIELD, 3 * FIELD},
                    {FIELD + 7000000000, 3 * FIELD - 3000000000},
                    {cut->t0 + 5000000, cut[9].t0 + 9000000},
                    {cut->t0 + 7000000, cut->t0 + 9000000},
                    {3 * FIELD, 3 * FIELD + 400000000},
                    {cut->t1 + 1000, cut->t1 + 40000000}};
        for (int i = 0; i < 6; i++)
            assert_true(worst_of(film[i].a, film[i].b, everywhere, 40, 5) < 1e-3);
    }
}

/* Two fields, their lines between each other. */
static void interlaced(void **state)
{
    (void)state;
    const double w[] = {1}, tau[] = {150 / 2.303};
    uint32_t seed = 3;
    begin(line_model_row(30, 20, 0.45), model_phosphor(1, w, tau));
    for (int field = 0; field < 3; field++)
        for (int n = 0; n < 40; n++) {
            add_line((uint64_t)field * FIELD + 500000000 + (uint64_t)n * 240000000, 16000000,
                     10 - (2 * n + field % 2 + 0.5) * 20 / 80, 96);
            randomize(field * 40 + n, &seed);
        }
    assert_true(worst_of(FIELD, 3 * FIELD, everywhere, 50, 5) < 1e-3);
}

/* A microscope: hundreds of cells a dot. */
static void closeup(void **state)
{
    (void)state;
    uint32_t seed = 3;
    for (int k = 0; k < 3; k++) {
        begin(line_model_row(30, 20, 0.45), plain(20));
        scene.row.spot_edge.value = 1.02;
        for (int n = 0; n < 64; n++) {
            add_line(1000000000 + (uint64_t)n * 30000000, 1500000, 10 - (n + 0.5) * 20 / 64, 96);
            randomize(n, &seed);
        }
        scene.grid = crt_grid_closeup(3.3, -2.1, k == 0 ? 2 : k == 1 ? 0.05 : 6e-4, 160, 120);
        assert_true(worst_of(0, FIELD, everywhere, 40, 5) < 1e-3);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(single_dots),  cmocka_unit_test(random_dots),
        cmocka_unit_test(growing_spot), cmocka_unit_test(knobs),
        cmocka_unit_test(corners),      cmocka_unit_test(exposures),
        cmocka_unit_test(interlaced),   cmocka_unit_test(closeup),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
