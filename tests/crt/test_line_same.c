/* Scan lines: the same film however it is computed and however they are delivered; energy; timing;
 * snapshots; extremes. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crt/state.h"
#include "crt/tube.h"
#include "tests/support/line_model.h"
#include "tests/support/tube_model.h"

#define LINES 48
#define DOTS  70
#define FIELD (CRT_PS_PER_S / 60)

struct how {
    int threads;
    enum crt_simd simd;
    bool no_reuse;
    uint64_t step; /* of advance; 0: field by field */
    bool saved;    /* goes on in another tube halfway */
};

struct scene {
    struct crt_tube_row row;
    struct crt_phosphor phosphor;
    struct crt_grid grid;
};

static const struct how plain = {1, CRT_SIMD_BASELINE, true, 0, false};

static struct scene scene_of(int kind)
{
    const double w[] = {0.2, 0.3, 0.2, 0.3}, tau[] = {0.005, 0.12, 2.16, 60};
    struct scene s;
    if (kind == 0) {
        s.row = line_model_colour_row(24, 18, 0.45);
        s.row.spot_edge.value = 1.3;
        s.row.converge_edge.value = 0.1;
        s.phosphor = line_model_p22();
    } else {
        s.row = line_model_row(24, 18, 0.45);
        s.row.spot_growth.value = kind == 2 ? 0.1 : 0;
        s.phosphor = model_phosphor(4, w, tau);
        s.phosphor.colours = 2;
        s.phosphor.term[2].colour = s.phosphor.term[3].colour = 1;
    }
    s.grid = crt_tube_grid(&s.row);
    return s;
}

static struct crt_tube *new_tube(const struct scene *s, struct how how)
{
    struct crt_error err;
    const struct crt_tube_desc desc = {.row = &s->row,
                                       .phosphor = &s->phosphor,
                                       .grid = s->grid,
                                       .epoch = {60, 1},
                                       .knobs = {0, 1, 0},
                                       .threads = how.threads,
                                       .simd = how.simd,
                                       .no_reuse = how.no_reuse};
    struct crt_tube *tube = crt_tube_create(&desc, &err);
    if (!tube)
        fail_msg("%s", err.text);
    return tube;
}

/* Line n of a field: every third one moves, one is dark, knobs change once. */
static void scan(struct crt_tube *tube, const struct scene *s, int field, int n)
{
    uint8_t drive[3][DOTS];
    uint32_t seed = 1 + (uint32_t)n + (n % 3 == 0 ? 1000 * (uint32_t)field : 0);
    uint64_t t0 = (uint64_t)field * FIELD + 400000000 + (uint64_t)n * 330000000;
    for (int g = 0; g < 3; g++)
        for (int i = 0; i < DOTS; i++) {
            uint32_t r = model_random(&seed);
            drive[g][i] = n == 20 ? 0 : r & 1 ? (uint8_t)(r >> 8) : 40;
        }
    if (field == 2 && n == 30)
        crt_tube_set_knobs(tube, (struct crt_knobs){0.05, 0.9, 0.3});
    float half = (float)s->row.width.value / 2;
    float y =
        (float)(s->row.height.value *
                (0.5 - (n + 0.25 + (s->phosphor.colours == 3 ? 0 : field % 2 * 0.5)) / LINES));
    const struct crt_scan_line line = {t0,
                                       t0 + 3000000,
                                       -half,
                                       y,
                                       half,
                                       y,
                                       DOTS,
                                       crt_tube_guns(&s->row),
                                       {drive[0], drive[1], drive[2]},
                                       (uint32_t)n};
    crt_tube_scan_line(tube, &line);
}

static struct crt_tube *moved(struct crt_tube *tube, const struct scene *s, struct how how)
{
    struct crt_state out, in;
    crt_state_save(&out);
    crt_tube_state(tube, &out);
    assert_false(out.failed);
    struct crt_tube *other = new_tube(s, how);
    crt_state_load(&in, out.out, out.size);
    crt_tube_state(other, &in);
    if (in.failed)
        fail_msg("%s", in.err.text);
    /* Cut short it is refused, wherever that is. */
    struct crt_tube *victim = new_tube(s, plain);
    for (size_t size = 0; size < out.size; size += out.size / 60 + 1) {
        crt_state_load(&in, out.out, size);
        crt_tube_state(victim, &in);
        assert_true(in.failed);
    }
    crt_tube_destroy(victim);
    crt_state_free(&out);
    crt_tube_destroy(tube);
    return other;
}

static uint64_t hash_of(const struct crt_film *film)
{
    uint64_t h = UINT64_C(0xcbf29ce484222325);
    for (int c = 0; c < film->colours; c++) {
        const uint8_t *at = (const uint8_t *)film->light[c];
        size_t bytes = (size_t)film->grid.cols * (size_t)film->grid.rows * sizeof(float);
        for (size_t i = 0; i < bytes; i++)
            h = (h ^ at[i]) * UINT64_C(0x100000001b3);
    }
    return h;
}

static uint64_t film_of(const struct scene *s, struct how how, uint64_t a, uint64_t b)
{
    struct crt_error err;
    struct crt_tube *tube = new_tube(s, how);
    struct crt_film film = {.complete = false};
    int next = 0;
    uint64_t now = 0, saved = how.saved ? a - 1234567 : UINT64_MAX;
    assert_true(crt_film_init(&film, tube, &err));
    while (!film.complete) {
        uint64_t to = how.step ? now + how.step : (now / FIELD + 1) * FIELD;
        to = now < saved && to > saved ? saved : to;
        to = now < a && to > a ? a : to;
        if (now == a)
            crt_film_open(tube, &film, a, b);
        for (; next < 5 * LINES; next++) {
            uint64_t t0 =
                (uint64_t)(next / LINES) * FIELD + 400000000 + (uint64_t)(next % LINES) * 330000000;
            if (t0 >= to)
                break;
            scan(tube, s, next / LINES, next % LINES);
        }
        crt_tube_advance(tube, to);
        now = to;
        if (now == saved)
            tube = moved(tube, s, how);
    }
    assert_true(crt_tube_intact(tube, &err));
    uint64_t h = hash_of(&film);
    crt_film_free(&film);
    crt_tube_destroy(tube);
    return h;
}

static void samples_depend_on_nothing_else(void **state)
{
    (void)state;
    const struct how others[] = {
        {1, CRT_SIMD_AUTO, true, 0, false},
        {1, CRT_SIMD_BASELINE, false, 0, false},
        {2, CRT_SIMD_AUTO, false, 0, false},
        {5, CRT_SIMD_AUTO, true, 0, false},
        {1, CRT_SIMD_AUTO, false, 777777777, false},
        {1, CRT_SIMD_AUTO, false, 0, true},
        {2, CRT_SIMD_BASELINE, false, 2345678901, true},
    };
    const uint64_t interval[][2] = {{3 * FIELD, 4 * FIELD},
                                    {2 * FIELD + 5000000000, 3 * FIELD + 9000000000},
                                    {2 * FIELD + 10301500000, 2 * FIELD + 10302500000}};
    for (int kind = 0; kind < 3; kind++) {
        struct scene s = scene_of(kind);
        for (int i = 0; i < 3; i++) {
            uint64_t want = film_of(&s, plain, interval[i][0], interval[i][1]);
            for (unsigned k = 0; k < sizeof others / sizeof others[0]; k++)
                if (film_of(&s, others[k], interval[i][0], interval[i][1]) != want)
                    fail_msg("scene %d, film %d, variant %u differs", kind, i, k);
        }
    }
}

/* Close-ups, of few lines and many rows of cells, whose bands begin wherever threads make them. */
static void bands_begin_anywhere(void **state)
{
    (void)state;
    for (int rows = 72; rows <= 312; rows += 20) {
        struct scene s = scene_of(rows % 3);
        s.grid = crt_grid_closeup(1.5, 2.5 + rows * 0.017, 4, 96, rows);
        uint64_t want = film_of(&s, plain, FIELD, 2 * FIELD);
        for (int threads = 2; threads < 7; threads++)
            assert_true(film_of(&s, (struct how){threads, CRT_SIMD_AUTO, false, 0, false}, FIELD,
                                2 * FIELD) == want);
    }
}

/* ---- energy ---------------------------------------------------------------------------------- */

static double film_sum(const struct crt_film *film)
{
    double sum = 0;
    for (int c = 0; c < film->colours; c++)
        for (int i = 0; i < film->grid.cols * film->grid.rows; i++)
            sum += (double)film->light[c][i];
    return sum;
}

static struct crt_scan_line white_line(const uint8_t *white, uint64_t t0, double y, double half,
                                       int dots, int guns)
{
    return (struct crt_scan_line){
        t0,   t0 + 40000000, (float)-half,          (float)y, (float)half, (float)y,
        dots, guns,          {white, white, white}, 0};
}

/* Film and what is stored are all the light of the beam: power × time lit, less what the amplifier
 * takes to rise. */
static void energy(void **state)
{
    (void)state;
    static uint8_t white[DOTS];
    memset(white, 255, sizeof white);
    for (int kind = 0; kind < 3; kind++) {
        struct scene s = scene_of(kind);
        struct crt_error err;
        struct crt_tube *tube = new_tube(&s, plain);
        struct crt_film film;
        const struct line_model model = {&s.row, &s.phosphor, {0, 1, 0}};
        double want = 0, rise = 1 / (2 * acos(-1) * s.row.bandwidth.value * 1e6);
        assert_true(crt_film_init(&film, tube, &err));
        crt_film_open(tube, &film, 0, FIELD + FIELD / 2);
        for (int n = 0; n < LINES; n++) {
            struct crt_scan_line line = white_line(white, 100000000 + (uint64_t)n * 500000000,
                                                   8 - n * 0.33, 10, DOTS, crt_tube_guns(&s.row));
            /* ∫ 1 − (1 − e^−t)^2.5 dt = 1.680372… time constants */
            for (int g = 0; g < line.guns; g++)
                want += line_model_power(&model, g) * (40e-6 - 1.6803723 * rise) *
                        (line.guns == 1 ? 1 : 0);
            for (int g = 0; g < line.guns && line.guns == 3; g++) {
                double terms = 0;
                for (int k = 0; k < s.phosphor.terms; k++)
                    terms += s.phosphor.term[k].colour == g ? s.phosphor.term[k].w : 0;
                want += line_model_power(&model, g) * terms * (40e-6 - 1.6803723 * rise);
            }
            crt_tube_scan_line(tube, &line);
        }
        crt_tube_advance(tube, FIELD + FIELD / 2);
        double area = s.grid.cell_mm * s.grid.cell_mm;
        double got = (film_sum(&film) + crt_tube_totals(tube).stored) * area;
        print_message("# energy %.7f of %.7f\n", got, want);
        assert_true(fabs(got / want - 1) < 3e-4);
        crt_film_free(&film);
        crt_tube_destroy(tube);
    }
}

/* Lines p apart: (max − min)/(max + min) of the field they make is 2·e^(−2π²σ²/p²). */
static void ripple(void **state)
{
    (void)state;
    static uint8_t white[DOTS];
    const double pitch[] = {2, 2.355, 3};
    memset(white, 255, sizeof white);
    for (int k = 0; k < 3; k++) {
        struct scene s = scene_of(1);
        double sigma = s.row.spot.value / CRT_WIDTH60_SIGMA, p = pitch[k] * sigma;
        struct crt_error err;
        s.grid = crt_grid_closeup(0, 0, 4 * p, 64, 64);
        struct crt_tube *tube = new_tube(&s, plain);
        struct crt_film film;
        assert_true(crt_film_init(&film, tube, &err));
        crt_film_open(tube, &film, 0, 2 * FIELD);
        for (int n = 0; n < 30; n++) {
            struct crt_scan_line line =
                white_line(white, 1000000 + (uint64_t)n * 50000000, (15 - n) * p, 11, DOTS, 1);
            crt_tube_scan_line(tube, &line);
        }
        crt_tube_advance(tube, 2 * FIELD);
        double low = 1e30, high = 0, want = 2 * exp(-2 * acos(-1) * acos(-1) / pitch[k] / pitch[k]);
        for (int r = 0; r < 64; r++) {
            double v = (double)film.light[0][r * 64 + 32] + (double)film.light[1][r * 64 + 32];
            low = fmin(low, v);
            high = fmax(high, v);
        }
        double got = (high - low) / (high + low);
        print_message("# ripple %.5f, closed form %.5f\n", got, want);
        assert_true(fabs(got / want - 1) < 0.05);
        crt_film_free(&film);
        crt_tube_destroy(tube);
    }
}

/* ---- timing ---------------------------------------------------------------------------------- */

/* A line's light after changes of timing: as if there had been none. */
static void set_epoch(void **state)
{
    (void)state;
    static uint8_t white[DOTS];
    const double w[] = {0.25, 0.25, 0.25, 0.25}, tau[] = {0.02, 0.6, 3, 40};
    memset(white, 255, sizeof white);
    struct scene s = scene_of(1);
    s.phosphor = model_phosphor(4, w, tau);
    for (int kind = 0; kind < 4; kind++) {
        struct crt_error err;
        struct crt_tube *tube = new_tube(&s, plain);
        struct crt_film whole, late;
        assert_true(crt_film_init(&whole, tube, &err) && crt_film_init(&late, tube, &err));
        crt_film_open(tube, &whole, 0, 60 * FIELD);
        struct crt_scan_line line = white_line(white, 15000000000, 0, 10, DOTS, 1);
        crt_tube_scan_line(tube, &line);
        uint64_t now = 16000000000, change = kind == 0   ? 17000000000
                                             : kind == 1 ? FIELD + 1
                                                         : 18000000000;
        crt_tube_advance(tube, now);
        crt_tube_advance(tube, change);
        crt_tube_set_epoch(tube, (struct crt_rate){kind == 2 ? 600 : 75, 1}, change);
        if (kind == 3) {
            crt_tube_advance(tube, change + 100000000);
            crt_tube_set_epoch(tube, (struct crt_rate){50, 1}, change + 100000000);
        }
        double cd[CRT_MAX_COLOURS], before;
        uint64_t probed = change + 150000000;
        crt_tube_advance(tube, probed);
        crt_tube_probe(tube, 0.4, 0.05, probed, cd);
        before = cd[0];
        crt_film_open(tube, &late, probed, probed + 30000000000);
        crt_tube_advance(tube, 60 * FIELD);
        assert_true(whole.complete && late.complete);
        double since[2] = {(double)(probed - line.t1) * 1e-12 + 20e-6, 0}, share = 0, rate = 0;
        since[1] = since[0] + 0.03;
        for (int k = 0; k < 4; k++) {
            share += w[k] * (exp(-since[0] / tau[k] * 1e3) - exp(-since[1] / tau[k] * 1e3));
            rate += w[k] / tau[k] * 1e3 * exp(-since[0] / tau[k] * 1e3);
        }
        double got = film_sum(&late) / film_sum(&whole);
        print_message("# timing %d: %.6f of the light, closed form %.6f\n", kind, got, share);
        assert_true(fabs(got - share) < 1e-4);
        double col, row;
        crt_mm_to_cell(&s.grid, 0.4, 0.05, &col, &row);
        double cell = (double)whole.light[0][(int)(row + 0.5) * s.grid.cols + (int)(col + 0.5)];
        assert_true(cell > 0 &&
                    fabs(before / (cell * rate) - 1) < 0.2); /* a cell is not the point */
        crt_film_free(&whole);
        crt_film_free(&late);
        crt_tube_destroy(tube);
    }
}

/* ---- extremes -------------------------------------------------------------------------------- */

static void extremes(void **state)
{
    (void)state;
    static uint8_t dots[CRT_MAX_DOTS];
    struct scene s = scene_of(1);
    memset(dots, 200, sizeof dots);
    const struct {
        double x0, x1, y;
        int dots;
        struct crt_knobs knobs;
        bool lit;
    } kind[] = {
        {-12, 12, 0, 1, {0, 1, 0}, true},       {-12, 12, 0, CRT_MAX_DOTS, {0, 1, 0}, true},
        {-1e6, 1e6, 0, 8192, {0, 1, 0}, true},  {-1e30, 1e30, 0, 8192, {0, 1, 0}, true},
        {100, 200, 0, 100, {0, 1, 0}, false},   {-12, 12, 300, 100, {0, 1, 0}, false},
        {-12, 12, 1e30, 100, {0, 1, 0}, false}, {-12, 12, 0, 100, {-1, 1, 0}, false},
        {-12, 12, 0, 100, {1, 4, 0}, true},     {-12, 12, 0, 100, {0, 1, 50}, true},
        {-12, 12, 0, 100, {0, 1, 1e6}, true},   {3, 3.0001, 0, 8000, {0, 1, 0}, false},
        {3, 3.01, 0, 100, {0, 1, 0}, true},     {-12, -12.5, 0, 10, {0, 1, 0}, false},
    };
    for (unsigned k = 0; k < sizeof kind / sizeof kind[0]; k++) {
        struct crt_error err;
        struct crt_tube *tube = new_tube(&s, plain);
        struct crt_film film;
        assert_true(crt_film_init(&film, tube, &err));
        crt_film_open(tube, &film, 0, FIELD);
        crt_tube_set_knobs(tube, kind[k].knobs);
        const struct crt_scan_line line = {1000000,
                                           21000000,
                                           (float)kind[k].x0,
                                           (float)kind[k].y,
                                           (float)kind[k].x1,
                                           (float)kind[k].y,
                                           kind[k].dots,
                                           1,
                                           {dots, dots, dots},
                                           0};
        crt_tube_scan_line(tube, &line);
        crt_tube_advance(tube, FIELD);
        assert_true(crt_tube_intact(tube, &err));
        double sum = film_sum(&film);
        print_message("# extreme %u: %g\n", k, sum);
        assert_true(isfinite(sum) && sum >= 0);
        if (k != 3 && k != 10)
            assert_int_equal(sum > 0, kind[k].lit);
        crt_film_free(&film);
        crt_tube_destroy(tube);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(samples_depend_on_nothing_else),
        cmocka_unit_test(bands_begin_anywhere),
        cmocka_unit_test(energy),
        cmocka_unit_test(ripple),
        cmocka_unit_test(set_epoch),
        cmocka_unit_test(extremes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
