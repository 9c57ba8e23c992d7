/* Masks: area by area against counted points, the mean against closed forms, films of three guns. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crt/mask.h"
#include "crt/overlap.h"

#define PI 3.14159265358979324

static const char *const tubes[] = {"COLOR17", "SLOT14", "GRILLE17"};

static struct crt_tube_row row_of(int tube, double landing)
{
    struct crt_tube_row row = *crt_tube_row_find(tubes[tube]);
    row.landing.value = landing;
    row.landing_edge.value = 0;
    return row;
}

/* ---- a slow model: is the point lit? ---------------------------------------------------------- */

/* The nearest hole of a lattice of upright columns, `step` apart, holes `pitch` apart, every other
 * column half a pitch higher: the offset from it, by trying all around. */
static double from_nearest(double x, double y, double step, double pitch, double *ox, double *oy)
{
    double best = 1e9;
    int i0 = (int)lround(x / step);
    for (int i = i0 - 2; i <= i0 + 2; i++) {
        double up = i % 2 != 0 ? pitch / 2 : 0;
        int j0 = (int)lround((y - up) / pitch);
        for (int j = j0 - 2; j <= j0 + 2; j++) {
            double dx = x - i * step, dy = y - up - j * pitch, d = hypot(dx, dy);
            if (d < best) {
                best = d;
                *ox = dx;
                *oy = dy;
            }
        }
    }
    return best;
}

static bool delta_lit(const struct crt_tube_row *r, int gun, int colour, double x, double y,
                      double mx, double my)
{
    static const double angle[3] = {210, 330, 90};
    double a = r->mask_pitch.value, t = a / 3, ox, oy;
    double hole = a * sqrt(r->mask_transmission.value * sqrt(3) / 2 / PI);
    double gx = t * cos(angle[gun] * PI / 180), gy = t * sin(angle[gun] * PI / 180);
    double cx = t * cos(angle[colour] * PI / 180), cy = t * sin(angle[colour] * PI / 180);
    double step = a * sqrt(3) / 2;
    return from_nearest(x - gx - mx, y - gy - my, step, a, &ox, &oy) < hole &&
           from_nearest(x - cx, y - cy, step, a, &ox, &oy) < a / sqrt(12);
}

static bool stripe_lit(const struct crt_tube_row *r, int gun, int colour, double x, double y,
                       double mx, double my)
{
    double p = r->mask_pitch.value, on = x - (colour - 1) * p / 3;
    if (fabs(on - p * round(on / p)) > p / 6)
        return false;
    double beam = x - mx - (gun - 1) * p / 3, k = round(beam / p), across = fabs(beam - k * p);
    y -= my;
    if (r->mask == CRT_MASK_GRILLE) {
        double h = r->height.value, open = 1 - 2 * CRT_DAMPER_MM / h;
        return across < r->mask_transmission.value / open * p / 2 &&
               fabs(fabs(y) - h / 6) > CRT_DAMPER_MM / 2;
    }
    double s = CRT_SLOT_PITCH * p, open = 1 - CRT_SLOT_BRIDGE;
    double up = y - (fmod(k, 2) != 0 ? s / 2 : 0);
    return across < r->mask_transmission.value / open * p / 2 &&
           fabs(up - s * round(up / s)) < open * s / 2;
}

static double counted(const struct crt_tube_row *r, int gun, int colour, double x, double y,
                      double cell, double landing)
{
    enum { N = 8000 };
    double d = hypot(x, y), mx = d > 0 ? landing * x / d : 0, my = d > 0 ? landing * y / d : 0;
    int lit = 0;
    for (int i = 0; i < N; i++) { /* points evenly spread, in no rows (golden ratio) */
        double px = x + ((i + 0.5) / N - 0.5) * cell;
        double py = y + (fmod(i * 0.6180339887498949, 1) - 0.5) * cell;
        lit += r->mask == CRT_MASK_DELTA ? delta_lit(r, gun, colour, px, py, mx, my)
                                         : stripe_lit(r, gun, colour, px, py, mx, my);
    }
    return (double)lit / N;
}

static void cells_against_counted_points(void **state)
{
    (void)state;
    static const double landings[] = {0, 0.012, 0.05, 0.13, 0.4};
    double worst = 0, lit = 0;
    srand(7);
    for (int t = 0; t < 3; t++)
        for (size_t l = 0; l < sizeof landings / sizeof landings[0]; l++) {
            struct crt_tube_row row = row_of(t, landings[l]);
            struct crt_mask mask;
            crt_mask_init(&mask, &row);
            for (int i = 0; i < 120; i++) {
                double x = rand() % 20000 / 1e4 - 1 + (i % 3) * 70.0;
                double y = rand() % 20000 / 1e4 - 1 + (i % 3 == 2 ? 0 : 40.0);
                double cell = i % 4 == 0 ? 0.01 : i % 4 == 1 ? 0.05 : i % 4 == 2 ? 0.2 : 0.9;
                int gun = i / 2 % 3, colour = i % 2 ? gun : (gun + 1 + i / 7 % 2) % 3;
                double got = crt_mask_cover(&mask, gun, colour, x, y, cell);
                double want = counted(&row, gun, colour, x, y, cell, landings[l]);
                worst = fmax(worst, fabs(got - want));
                lit += got;
                if (fabs(got - want) > 0.008) /* points near outlines */
                    fail_msg(
                        "%s, landing %g, gun %d on colour %d at %g,%g, cell %g: %g, counted %g",
                        tubes[t], landings[l], gun, colour, x, y, cell, got, want);
            }
        }
    print_message("# worst %.4f of a cell, lit %.1f cells\n", worst, lit);
    assert_true(lit > 50);
}

/* A place where wires are, and one without. */
static void damper_wires_throw_shadows(void **state)
{
    (void)state;
    struct crt_tube_row row = row_of(2, 0);
    struct crt_mask mask;
    crt_mask_init(&mask, &row);
    double cell = row.mask_pitch.value * 2; /* whole periods */
    double free_ = crt_mask_cover(&mask, 1, 1, 10, 0, cell);
    for (int side = -1; side <= 1; side += 2) {
        double wire = crt_mask_cover(&mask, 1, 1, 10, side * row.height.value / 6, cell);
        assert_true(fabs(wire / free_ - (1 - CRT_DAMPER_MM / cell)) < 1e-9);
    }
}

/* ---- closed forms ----------------------------------------------------------------------------- */

static void discs_in_boxes(void **state)
{
    (void)state;
    struct crt_disc d[2] = {{0.3, -0.2, 1.5}};
    struct crt_box all = {-9, -9, 9, 9}, half = {0.3, -9, 9, 9}, corner = {0.3, -0.2, 9, 9};
    double area = PI * 1.5 * 1.5;
    assert_true(fabs(crt_overlap_discs(d, 1, &all) / area - 1) < 1e-6);
    assert_true(fabs(crt_overlap_discs(d, 1, &half) / area - 0.5) < 1e-6);
    assert_true(fabs(crt_overlap_discs(d, 1, &corner) / area - 0.25) < 1e-6);
    /* A segment of height h: r²·acos(1 − h/r) − (r − h)·√(2rh − h²). */
    struct crt_box cap = {-9, 0.8, 9, 9}; /* 1 above the centre, so h = 0.5 */
    double segment = 2.25 * acos(1 - 0.5 / 1.5) - 1 * sqrt(2 * 1.5 * 0.5 - 0.25);
    assert_true(fabs(crt_overlap_discs(d, 1, &cap) - segment) < 1e-6 * area);
    /* A lens of two discs, the textbook's formula. */
    for (double gap = 0.1; gap < 2.6; gap += 0.07) {
        double r = 1.5, q = 1.1, lens = 0;
        d[1] = (struct crt_disc){0.3 + gap * 0.6, -0.2 + gap * 0.8, q};
        if (gap <= r - q)
            lens = PI * q * q;
        else if (gap < r + q)
            lens = q * q * acos((gap * gap + q * q - r * r) / (2 * gap * q)) +
                   r * r * acos((gap * gap + r * r - q * q) / (2 * gap * r)) -
                   0.5 * sqrt((-gap + q + r) * (gap + q - r) * (gap - q + r) * (gap + q + r));
        double got = crt_overlap_discs(d, 2, &all);
        if (fabs(got - lens) > 5e-6 * area)
            fail_msg("gap %g: %.9f, want %.9f", gap, got, lens);
    }
}

static void combs(void **state)
{
    (void)state;
    assert_true(fabs(crt_overlap_comb(-10, 10, 1, -0.1, 0.2) - 6) < 1e-12);
    assert_true(fabs(crt_overlap_comb(0, 0.5, 1, -0.1, 0.2) - 0.2) < 1e-12);
    assert_true(fabs(crt_overlap_comb(0.15, 1, 1, -0.1, 0.2) - 0.15) < 1e-12);
    assert_true(fabs(crt_overlap_comb(-0.95, -0.85, 1, -0.1, 0.2) - 0.1) < 1e-12);
    assert_true(fabs(crt_overlap_comb(0.3, 0.8, 1, -0.1, 0.2)) < 1e-12);
}

/* With perfect landing only the own colour lights, and as much as the figure says. */
static void transmission_is_that_of_the_row(void **state)
{
    (void)state;
    for (int t = 0; t < 3; t++)
        for (double share = 0.1; share < 0.28; share += 0.085) {
            struct crt_tube_row row = row_of(t, 0);
            row.mask_transmission.value = share;
            struct crt_mask mask;
            crt_mask_init(&mask, &row);
            for (int gun = 0; gun < 3; gun++)
                for (int c = 0; c < 3; c++) {
                    double want = gun == c ? share : 0, sum = 0;
                    if (t == 2) /* the mean is for places without wires */
                        want /= 1 - 2 * CRT_DAMPER_MM / row.height.value;
                    assert_true(fabs(crt_mask_mean(&mask, gun, c, 31, -17) - want) < 1e-2 * share);
                    enum { N = 100 };
                    double cell = 26.0 / N;
                    for (int i = 0; i < N * N; i++)
                        sum += crt_mask_cover(&mask, gun, c, 60 + i % N * cell, -6 + i / N * cell,
                                              cell);
                    if (fabs(sum / (N * N) - want) > 0.01 * share)
                        fail_msg("%s: gun %d, colour %d: %g of %g", tubes[t], gun, c, sum / (N * N),
                                 want);
                }
        }
}

/* The mean of the pattern against the cells of a large area that all miss alike. */
static void mean_is_the_mean_of_the_cells(void **state)
{
    (void)state;
    static const double landings[] = {0.005, 0.02, 0.04, 0.07, 0.1, 0.2, 1.3};
    for (int t = 0; t < 3; t++)
        for (size_t l = 0; l < sizeof landings / sizeof landings[0]; l++) {
            struct crt_tube_row row = row_of(t, landings[l]);
            struct crt_mask mask;
            crt_mask_init(&mask, &row);
            double all = 0;
            for (int gun = 0; gun < 3; gun++)
                for (int c = 0; c < 3; c++) {
                    /* Far out, so that the direction hardly changes; periods each way. */
                    enum { N = 80 };
                    double cell = 24 * row.mask_pitch.value / N, sum = 0;
                    for (int i = 0; i < N * N; i++)
                        sum += crt_mask_cover(&mask, gun, c, 4000 + i % N * cell,
                                              3000 + i / N * cell, cell);
                    double mean = crt_mask_mean(&mask, gun, c, 4000, 3000);
                    all += mean;
                    if (fabs(sum / (N * N) - mean) > 0.004)
                        fail_msg("%s, landing %g, gun %d, colour %d: mean %g, cells %g", tubes[t],
                                 landings[l], gun, c, mean, sum / (N * N));
                    if (landings[l] <= crt_mask_guard(&mask))
                        assert_true(gun == c ? mean > 0.9 * row.mask_transmission.value
                                             : mean == 0);
                }
            /* No more than passes the holes; stripes leave no gap, dots do. */
            double passed = 3 * row.mask_transmission.value * 1.001;
            assert_true(all < passed && (t == 0 || all > passed * 0.998));
        }
}

static void just_beyond_the_guard_band_a_neighbour_lights(void **state)
{
    (void)state;
    for (int t = 0; t < 3; t++) {
        struct crt_tube_row row = row_of(t, 0);
        struct crt_mask mask;
        crt_mask_init(&mask, &row);
        double guard = crt_mask_guard(&mask);
        assert_true(guard > 0.005 && guard < 0.03);
        double stray[2] = {0, 0};
        for (int far = 0; far < 2; far++) {
            mask.optics.landing = far ? guard * 1.05 : guard * 0.999;
            for (int gun = 0; gun < 3; gun++)
                for (int c = 0; c < 3; c++) {
                    stray[far] += gun == c ? 0 : crt_mask_mean(&mask, gun, c, 50, 0);
                    stray[far] += gun == c ? 0 : crt_mask_mean(&mask, gun, c, 0, -50);
                    stray[far] += gun == c ? 0 : crt_mask_mean(&mask, gun, c, 30, 30 * sqrt(3));
                }
        }
        assert_true(stray[0] == 0);
        assert_true(stray[1] > 1e-6 && stray[1] < 0.05);
    }
}

/* ---- films ------------------------------------------------------------------------------------ */

static struct crt_film film_of(struct crt_grid grid, double red, double green, double blue)
{
    struct crt_film film = {.grid = grid, .colours = 3, .t0 = 0, .t1 = 1, .complete = true};
    double light[3] = {red, green, blue};
    size_t n = (size_t)grid.cols * (size_t)grid.rows;
    for (int c = 0; c < 3; c++) {
        film.light[c] = malloc(n * sizeof(float));
        for (size_t i = 0; i < n; i++)
            film.light[c][i] = (float)(light[c] * (1 + 0.5 * sin((double)i * 1e-3)));
    }
    return film;
}

static void free_film(struct crt_film *film)
{
    for (int c = 0; c < 3; c++)
        free(film->light[c]);
}

static double total(const struct crt_film *film, int c)
{
    double sum = 0;
    for (size_t i = 0; i < (size_t)film->grid.cols * (size_t)film->grid.rows; i++)
        sum += (double)film->light[c][i];
    return sum;
}

static void perfect_landing_changes_no_film(void **state)
{
    (void)state;
    for (int t = 0; t < 3; t++) {
        const struct crt_tube_row *row = crt_tube_row_find(tubes[t]);
        struct crt_grid grid = crt_tube_grid(row);
        struct crt_mask mask;
        crt_mask_init(&mask, row);
        /* The rows as they are: pure up to the corner. */
        double x = grid.cols * grid.cell_mm / 2, y = grid.rows * grid.cell_mm / 2;
        assert_true(crt_optics_landing(&mask.optics, x, y) < crt_mask_guard(&mask));
        grid.rows = 40;
        struct crt_film film = film_of(grid, 1, 2, 3), before = film_of(grid, 1, 2, 3);
        crt_mask_film(&mask, crt_phosphor_find("P22"), &film, false, NULL);
        for (int c = 0; c < 3; c++)
            assert_memory_equal(film.light[c], before.light[c],
                                (size_t)grid.cols * (size_t)grid.rows * sizeof(float));
        free_film(&film);
        free_film(&before);
    }
}

/* Each gun alone, so far off that it lights the next colour only: light in the ratio of the shares.
 */
static void foreign_phosphor_gives_its_own_light(void **state)
{
    (void)state;
    const struct crt_phosphor *p22 = crt_phosphor_find("P22");
    double share[3] = {0};
    for (int k = 0; k < p22->terms; k++)
        share[p22->term[k].colour] += p22->term[k].w;
    struct crt_tube_row row = row_of(2, 0.25 / 3);
    struct crt_mask mask;
    crt_mask_init(&mask, &row);
    struct crt_grid grid = crt_grid_closeup(100, 0, 10, 64, 48);
    for (int gun = 0; gun < 3; gun++) {
        struct crt_film film = film_of(grid, gun == 0, gun == 1, gun == 2);
        double before = total(&film, gun);
        crt_mask_film(&mask, p22, &film, false, NULL);
        int next = (gun + 1) % 3;
        assert_true(fabs(total(&film, next) / before / (share[next] / share[gun]) - 1) < 1e-3);
        assert_true(total(&film, gun) < 1e-3 * before);
        free_film(&film);
    }
}

static void a_film_from_afar_is_the_mean_of_its_place(void **state)
{
    (void)state;
    struct crt_tube_row row = *crt_tube_row_find("COLOR17");
    row.landing_edge.value = 0.12;
    struct crt_mask mask;
    crt_mask_init(&mask, &row);
    struct crt_grid grid = crt_tube_grid(&row);
    struct crt_film film = film_of(grid, 0, 1, 0), plain = film_of(grid, 0, 1, 0);
    const struct crt_phosphor *p22 = crt_phosphor_find("P22");
    struct crt_error err;
    struct crt_pool *pool = crt_pool_create(3, &err);
    struct crt_film again = film_of(grid, 0, 1, 0);
    crt_mask_film(&mask, p22, &film, false, NULL);
    crt_mask_film(&mask, p22, &again, false, pool);
    crt_pool_destroy(pool);
    for (int c = 0; c < 3; c++)
        assert_memory_equal(film.light[c], again.light[c],
                            (size_t)grid.cols * (size_t)grid.rows * sizeof(float));
    for (int i = 0; i < 200; i++) {
        int col = i * 7919 % grid.cols, line = i * 104729 % grid.rows;
        size_t at = (size_t)line * (size_t)grid.cols + (size_t)col;
        double x, y;
        crt_cell_to_mm(&grid, col, line, &x, &y);
        double mean = crt_mask_mean(&mask, 1, 1, x, y) / row.mask_transmission.value;
        double got = (double)film.light[1][at] / (double)plain.light[1][at];
        if (fabs(got - mean) > 3e-3)
            fail_msg("%d,%d: %g of its light, %g wanted", col, line, got, mean);
    }
    free_film(&film);
    free_film(&again);
    free_film(&plain);
}

static void under_the_microscope_light_is_kept(void **state)
{
    (void)state;
    struct crt_error err;
    struct crt_pool *pool = crt_pool_create(3, &err);
    assert_non_null(pool);
    for (int t = 0; t < 3; t++) {
        struct crt_tube_row row = *crt_tube_row_find(tubes[t]);
        struct crt_mask mask;
        crt_mask_init(&mask, &row);
        /* 24 periods across; for triads and slots as good as whole ones up, too. */
        double wide = 24 * row.mask_pitch.value;
        struct crt_grid grid = crt_grid_closeup(20, 30, wide, 400, 400);
        struct crt_film film = film_of(grid, 1, 2, 0.5), same = film_of(grid, 1, 2, 0.5);
        double before[3] = {total(&film, 0), total(&film, 1), total(&film, 2)};
        crt_mask_film(&mask, crt_phosphor_find("P22"), &film, true, NULL);
        crt_mask_film(&mask, crt_phosphor_find("P22"), &same, true, pool);
        for (int c = 0; c < 3; c++) {
            size_t n = (size_t)grid.cols * (size_t)grid.rows, lit = 0;
            assert_memory_equal(film.light[c], same.light[c], n * sizeof(float));
            if (fabs(total(&film, c) / before[c] - 1) > 0.02)
                fail_msg("%s: colour %d has %g of its light", tubes[t], c,
                         total(&film, c) / before[c]);
            for (size_t i = 0; i < n; i++)
                lit += film.light[c][i] > 0;
            /* Dark between the dots: outlines add some. */
            double share = (double)lit / (double)n / row.mask_transmission.value;
            assert_true(share > 1 && share < 1.6);
        }
        free_film(&film);
        free_film(&same);
    }
    crt_pool_destroy(pool);
}

/* The same samples from every compiler and processor. The light comes from integers alone. */
static void the_samples_are_these(void **state)
{
    (void)state;
    uint64_t hash = UINT64_C(0xcbf29ce484222325); /* FNV-1a */
    for (int t = 0; t < 3; t++)
        for (int microscope = 0; microscope < 2; microscope++) {
            struct crt_tube_row row = row_of(t, 0.031);
            struct crt_mask mask;
            crt_mask_init(&mask, &row);
            struct crt_film film = film_of(crt_grid_closeup(90, -40, 3, 128, 96), 0, 0, 0);
            uint32_t seed = 1;
            for (int c = 0; c < 3; c++)
                for (int i = 0; i < 128 * 96; i++) {
                    seed = seed * 1664525u + 1013904223u;
                    film.light[c][i] = (float)(seed >> 8) / 16777216.0f;
                }
            crt_mask_film(&mask, crt_phosphor_find("P22"), &film, microscope, NULL);
            for (int c = 0; c < 3; c++)
                for (int i = 0; i < 128 * 96; i++) {
                    uint32_t bits;
                    memcpy(&bits, &film.light[c][i], sizeof bits);
                    hash = (hash ^ bits) * UINT64_C(0x100000001b3);
                }
            free_film(&film);
        }
    print_message("# %016llx\n", (unsigned long long)hash);
    assert_true(hash == UINT64_C(0xb0547360ae71ed55));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(discs_in_boxes),
        cmocka_unit_test(combs),
        cmocka_unit_test(cells_against_counted_points),
        cmocka_unit_test(damper_wires_throw_shadows),
        cmocka_unit_test(transmission_is_that_of_the_row),
        cmocka_unit_test(mean_is_the_mean_of_the_cells),
        cmocka_unit_test(just_beyond_the_guard_band_a_neighbour_lights),
        cmocka_unit_test(perfect_landing_changes_no_film),
        cmocka_unit_test(foreign_phosphor_gives_its_own_light),
        cmocka_unit_test(a_film_from_afar_is_the_mean_of_its_place),
        cmocka_unit_test(under_the_microscope_light_is_kept),
        cmocka_unit_test(the_samples_are_these),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
