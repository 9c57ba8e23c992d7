/* The same film whatever else is observed, however time is advanced, and however it is computed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crt/tube.h"
#include "tests/support/tube_model.h"

#define CELL   0.25
#define EPOCHS 7

/* Strokes of EPOCHS refreshes: a static part, a moving part, and one long stroke over three epochs.
 */
struct scene {
    struct crt_stroke stroke[4000];
    int count;
};

static struct crt_stroke any_stroke(uint32_t *seed, double width, double height)
{
    struct crt_stroke s = {.drive = model_random(seed) & 1 ? 1.0F : 0.6F};
    s.x0 = (float)model_uniform(seed, -0.55 * width, 0.55 * width);
    s.y0 = (float)model_uniform(seed, -0.55 * height, 0.55 * height);
    double reach = model_random(seed) % 3 ? 10 : 0.4 * width;
    s.x1 = s.x0 + (float)model_uniform(seed, -reach, reach);
    s.y1 = s.y0 + (float)model_uniform(seed, -reach, reach);
    if (model_random(seed) % 4 == 0) {
        s.x1 = s.x0;
        s.y1 = s.y0;
    }
    return s;
}

/* As a vector is drawn: the spot rests, moves, rests. */
static void add_rested(struct scene *scene, const struct crt_stroke *s, uint64_t rest)
{
    struct crt_stroke start = *s, move = *s, end = *s;
    start.x1 = s->x0;
    start.y1 = s->y0;
    start.t1 = move.t0 = s->t0 + rest;
    end.x0 = s->x1;
    end.y0 = s->y1;
    end.t0 = move.t1 = s->t1 - rest;
    scene->stroke[scene->count++] = start;
    scene->stroke[scene->count++] = move;
    scene->stroke[scene->count++] = end;
}

static void make_scene(struct scene *scene, const struct crt_grid *grid, struct crt_rate epoch)
{
    double width = grid->cols * CELL, height = grid->rows * CELL;
    scene->count = 0;
    for (uint64_t n = 0; n < EPOCHS; n++) {
        uint64_t t = crt_tick_time(epoch, n) + 1000, end = crt_tick_time(epoch, n + 1);
        uint32_t fixed = 7, moving = 100 + (uint32_t)n;
        for (int i = 0; i < 140; i++) {
            struct crt_stroke s = any_stroke(i < 90 ? &fixed : &moving, width, height);
            s.t0 = t;
            s.t1 = t + 1000000 + model_random(&moving) % 100000000;
            if (n == 2 && i == 139)
                s.t1 = end + (crt_tick_time(epoch, 1)) + 12345; /* through all of the next epoch */
            if (i % 3 == 0)
                add_rested(scene, &s, 100000 + 1000 * (uint64_t)i);
            else
                scene->stroke[scene->count++] = s;
            t = s.t1 + 100;
        }
    }
}

struct how {
    int threads;
    enum crt_simd simd;
    bool no_reuse;
    uint64_t step; /* of advance; 0: tick by tick */
    int observers; /* other films, and probes */
};

struct interval {
    uint64_t t0, t1;
};

static uint64_t hash(uint64_t h, const void *data, size_t size)
{
    const uint8_t *at = data;
    for (size_t i = 0; i < size; i++)
        h = (h ^ at[i]) * UINT64_C(0x100000001b3);
    return h;
}

static const struct crt_grid grid = {256, 200, CELL, -256 * CELL / 2, 200 * CELL / 2};

/* The film of an interval, as a hash of its samples. */
static uint64_t film_of(const struct crt_phosphor *phosphor, const struct scene *scene,
                        struct how how, struct interval of, uint64_t *lit)
{
    struct crt_tube_row row = model_row(CELL, 0.2);
    struct crt_tube_desc desc = {
        .row = &row,
        .phosphor = phosphor,
        .grid = grid,
        .epoch = {60, 1},
        .knobs = {0, 1, 0},
        .threads = how.threads,
        .simd = how.simd,
        .no_reuse = how.no_reuse,
    };
    struct crt_error err;
    struct crt_tube *tube = crt_tube_create(&desc, &err);
    if (!tube)
        fail_msg("%s", err.text);
    struct crt_film film, other[12];
    assert_true(crt_film_init(&film, tube, &err));
    for (int i = 0; i < how.observers; i++)
        assert_true(crt_film_init(&other[i], tube, &err));
    uint64_t now = 0;
    uint32_t seed = 5;
    int next = 0;
    bool open = false;
    while (!film.complete) {
        uint64_t to =
            how.step ? now + how.step : crt_tick_time(desc.epoch, crt_tick_at(desc.epoch, now) + 1);
        if (!open && to > of.t0)
            to = of.t0;
        if (!open && now == of.t0) {
            crt_film_open(tube, &film, of.t0, of.t1);
            open = true;
        }
        for (int i = 0; i < how.observers; i++) /* other films, some of them given up */
            if (other[i].complete || other[i].t1 == 0 || model_random(&seed) % 16 == 0)
                crt_film_open(tube, &other[i], now + model_random(&seed) % 20000000000u,
                              now + 20000000000 + model_random(&seed) % 30000000000u);
        while (next < scene->count && scene->stroke[next].t0 < to)
            crt_tube_stroke(tube, &scene->stroke[next++]);
        crt_tube_advance(tube, to);
        now = to;
        double cd_m2[CRT_MAX_COLOURS];
        for (int i = 0; i < how.observers; i++)
            crt_tube_probe(tube, i, -i, now, cd_m2);
        if (how.observers)
            crt_tube_totals(tube);
    }
    uint64_t h = UINT64_C(0xcbf29ce484222325);
    *lit = 0;
    size_t cells = (size_t)grid.cols * (size_t)grid.rows;
    for (int c = 0; c < film.colours; c++) {
        h = hash(h, film.light[c], cells * sizeof(float));
        for (size_t i = 0; i < cells; i++) {
            *lit += film.light[c][i] > 0;
            assert_true(film.light[c][i] >= 0);
        }
    }
    for (int i = 0; i < how.observers; i++) {
        crt_film_cancel(tube, &other[i]);
        crt_film_free(&other[i]);
    }
    crt_film_free(&film);
    crt_tube_destroy(tube);
    return h;
}

/* Two colours, terms with and without planes. */
static struct crt_phosphor phosphor(int kind)
{
    static const double w1[] = {1}, t1[] = {65};
    static const double w4[] = {0.2, 0.3, 0.2, 0.3}, t4[] = {0.005, 0.12, 2.16, 60};
    if (kind == 0)
        return model_phosphor(1, w1, t1);
    struct crt_phosphor p = model_phosphor(4, w4, t4);
    if (kind == 2) {
        p.colours = 2;
        p.term[2].colour = p.term[3].colour = 1;
    }
    return p;
}

static void samples_depend_on_nothing_else(void **state)
{
    (void)state;
    static struct scene scene;
    const struct crt_rate epoch = {60, 1};
    make_scene(&scene, &grid, epoch);
    const struct interval intervals[] = {
        {crt_tick_time(epoch, 5), crt_tick_time(epoch, 6)},
        {crt_tick_time(epoch, 3) + 777, crt_tick_time(epoch, 5) - 5000000000},
        {crt_tick_time(epoch, 4) + 2000000000, crt_tick_time(epoch, 4) + 2000500000},
    };
    const struct how plain = {1, CRT_SIMD_BASELINE, true, 0, 0};
    const struct how others[] = {
        {1, CRT_SIMD_AUTO, true, 0, 0},
        {1, CRT_SIMD_BASELINE, false, 0, 0},
        {1, CRT_SIMD_AUTO, false, 0, 0},
        {2, CRT_SIMD_AUTO, true, 0, 0},
        {4, CRT_SIMD_BASELINE, false, 0, 0},
        {1, CRT_SIMD_AUTO, true, 1234567891, 0},
        {1, CRT_SIMD_AUTO, true, 50000000000, 0},
        {1, CRT_SIMD_AUTO, true, 0, 3},
        {3, CRT_SIMD_AUTO, false, 3234567891, 12},
    };
    /* Recorded; the same from every compiler and processor. To be recorded anew when the tube
     * itself is changed on purpose. */
    static const uint64_t recorded[3][3] = {
        {UINT64_C(0xf7f57d751a9d2b8d), UINT64_C(0x8aa28748169a11e3), UINT64_C(0xc6e747ed171b726d)},
        {UINT64_C(0x6d85d17d85f0ddb8), UINT64_C(0x8c78ccb929e4088a), UINT64_C(0x17e3d91c40c31111)},
        {UINT64_C(0xb8490b09696e3fe3), UINT64_C(0xff50da174b6aa894), UINT64_C(0xd735ac8fe1196ad7)},
    };
    for (int kind = 0; kind < 3; kind++) {
        struct crt_phosphor p = phosphor(kind);
        for (unsigned i = 0; i < sizeof intervals / sizeof intervals[0]; i++) {
            uint64_t lit, other_lit, want = film_of(&p, &scene, plain, intervals[i], &lit);
            assert_true(lit > 5000);
            print_message("# phosphor %d, film %u: %016llx, %llu lit\n", kind, i,
                          (unsigned long long)want, (unsigned long long)lit);
            assert_int_equal(want, recorded[kind][i]);
            for (unsigned k = 0; k < sizeof others / sizeof others[0]; k++) {
                uint64_t got = film_of(&p, &scene, others[k], intervals[i], &other_lit);
                if (got != want)
                    fail_msg("phosphor %d, film %u, variant %u differs", kind, i, k);
            }
        }
    }
}

static void an_absent_instruction_set_is_named(void **state)
{
    (void)state;
    struct crt_tube_row row = model_row(CELL, 0.2);
    struct crt_phosphor p = phosphor(0);
    struct crt_tube_desc desc = {.row = &row,
                                 .phosphor = &p,
                                 .grid = grid,
                                 .epoch = {60, 1},
                                 .knobs = {0, 1, 0},
                                 .threads = 1,
                                 .simd = CRT_SIMD_AVX2};
    struct crt_error err = {""};
    struct crt_tube *tube = crt_tube_create(&desc, &err);
    if (!tube)
        assert_non_null(strstr(err.text, "AVX2"));
    crt_tube_destroy(tube);
    desc.simd = CRT_SIMD_AUTO;
    desc.grid.cols = 12;
    assert_null(crt_tube_create(&desc, &err));
    desc.grid.cols = 16;
    desc.threads = 0;
    assert_null(crt_tube_create(&desc, &err));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(samples_depend_on_nothing_else),
        cmocka_unit_test(an_absent_instruction_set_is_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
