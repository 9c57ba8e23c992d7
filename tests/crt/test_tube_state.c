/* A tube saved at any instant and loaded into another goes on to the same light. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crt/tube.h"
#include "tests/support/tube_model.h"

#define CELL    0.25
#define COLS    136 /* tiles are 64 × 16: two and an eighth across */
#define ROWS    90
#define STROKES 900
#define TICK    (CRT_PS_PER_S / 60)
#define EPOCHS  9

static const struct crt_grid grid = {COLS, ROWS, CELL, -COLS *CELL / 2, ROWS *CELL / 2};

/* A tube and the scene it is shown. */
struct bench {
    struct crt_tube_row row;
    struct crt_phosphor phosphor;
    struct crt_stroke stroke[STROKES];
    struct crt_tube *tube;
    int next; /* stroke to be delivered */
};

struct how {
    int threads;
    enum crt_simd simd;
    bool no_reuse;
};

static const struct how plain = {1, CRT_SIMD_BASELINE, true};

/* One term with a plane; four terms of which one has none; two colours. */
static struct crt_phosphor phosphor(int kind)
{
    static const double w1[] = {1}, t1[] = {65};
    static const double w4[] = {0.2, 0.3, 0.2, 0.3}, t4[] = {0.005, 0.12, 2.16, 60};
    struct crt_phosphor p = kind == 0 ? model_phosphor(1, w1, t1) : model_phosphor(4, w4, t4);
    if (kind == 2) {
        p.colours = 2;
        p.term[2].colour = p.term[3].colour = 1;
    }
    return p;
}

static struct crt_tube *new_tube(const struct bench *b, struct how how)
{
    struct crt_error err;
    const struct crt_tube_desc desc = {.row = &b->row,
                                       .phosphor = &b->phosphor,
                                       .grid = grid,
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

/* The same figure in every refresh, dark refreshes between, and strokes longer than an epoch. */
static void make_scene(struct bench *b)
{
    uint32_t seed = 3;
    uint64_t t = 1000;
    for (int i = 0; i < STROKES; i++) {
        struct crt_stroke *s = &b->stroke[i];
        uint32_t fixed = 1000 + (uint32_t)i % 120;
        *s = (struct crt_stroke){.t0 = t, .drive = i & 1 ? 1.0F : 0.6F, .source = (uint32_t)i};
        s->x0 = (float)model_uniform(&fixed, -20, 20);
        s->y0 = (float)model_uniform(&fixed, -13, 13);
        s->x1 = s->x0 + (float)model_uniform(&fixed, -6, 6);
        s->y1 = i % 3 ? s->y0 + (float)model_uniform(&fixed, -6, 6) : s->y0;
        s->t1 = s->t0 + 2000000 + model_random(&seed) % 200000000;
        if (i % 300 == 290)
            s->t1 += 3 * TICK / 2;
        t = s->t1 + model_random(&seed) % 1000;
        if (i % 240 == 230)
            t += 5 * TICK / 2;
    }
}

static struct bench *set_up(int kind)
{
    struct bench *b = calloc(1, sizeof *b);
    assert_non_null(b);
    b->row = model_row(CELL, 0.2);
    b->phosphor = phosphor(kind);
    make_scene(b);
    b->tube = new_tube(b, plain);
    return b;
}

static void tear_down(struct bench *b)
{
    crt_tube_destroy(b->tube);
    free(b);
}

static void run_to(struct bench *b, struct crt_tube *tube, int *next, uint64_t t)
{
    while (*next < STROKES && b->stroke[*next].t0 < t)
        crt_tube_stroke(tube, &b->stroke[(*next)++]);
    crt_tube_advance(tube, t);
}

static struct crt_state save(struct crt_tube *tube)
{
    struct crt_state s;
    crt_state_save(&s);
    crt_tube_state(tube, &s);
    if (s.failed)
        fail_msg("%s", s.err.text);
    return s;
}

static void load(struct crt_tube *tube, const struct crt_state *saved)
{
    struct crt_state s;
    crt_state_load(&s, saved->out, saved->size);
    crt_tube_state(tube, &s);
    if (s.failed)
        fail_msg("%s", s.err.text);
    assert_int_equal(s.at, saved->size);
}

static void films_equal(const struct crt_film *a, const struct crt_film *b, double *light)
{
    size_t cells = (size_t)grid.cols * (size_t)grid.rows;
    assert_true(a->complete && b->complete);
    for (int c = 0; c < a->colours; c++) {
        assert_memory_equal(a->light[c], b->light[c], cells * sizeof(float));
        for (size_t i = 0; i < cells; i++)
            *light += (double)a->light[c][i];
    }
}

/* Both go on from `t` by three films in a row; the second tube is left for the caller. */
static void go_on_alike(struct bench *b, struct crt_tube *second, uint64_t t, uint32_t *seed)
{
    struct crt_film film[2];
    struct crt_error err;
    int next[2] = {b->next, b->next};
    struct crt_tube *tube[2] = {b->tube, second};
    double light = 0;
    for (int i = 0; i < 2; i++)
        assert_true(crt_film_init(&film[i], tube[i], &err));
    for (int n = 0; n < 3; n++) {
        uint64_t t0 = t + model_random(seed) % TICK, t1 = t0 + 1 + model_random(seed) % (2 * TICK);
        double cd[2][CRT_MAX_COLOURS];
        for (int i = 0; i < 2; i++) {
            crt_film_open(tube[i], &film[i], t0, t1);
            run_to(b, tube[i], &next[i], t1);
            crt_tube_probe(tube[i], 1, 2, t1, cd[i]);
        }
        films_equal(&film[0], &film[1], &light);
        assert_memory_equal(cd[0], cd[1], sizeof cd[0]);
        assert_true(crt_tube_totals(tube[0]).stored == crt_tube_totals(tube[1]).stored);
        assert_int_equal(crt_tube_totals(tube[0]).strokes, crt_tube_totals(tube[1]).strokes);
        t = t1;
    }
    assert_true(light > 0);
    crt_film_free(&film[0]);
    crt_film_free(&film[1]);
}

static void it_goes_on_from_any_instant(void **state)
{
    (void)state;
    static const struct how others[] = {
        {1, CRT_SIMD_AUTO, false}, {2, CRT_SIMD_BASELINE, true}, {3, CRT_SIMD_AUTO, false}};
    uint32_t seed = 11;
    for (int kind = 0; kind < 3; kind++)
        for (unsigned n = 0; n < 12; n++) {
            struct bench *b = set_up(kind);
            /* Some instants on an epoch's very end. */
            uint64_t at = model_random(&seed) % (EPOCHS * (uint64_t)TICK);
            uint64_t t = n % 4 == 3 ? crt_tick_time((struct crt_rate){60, 1}, 1 + n / 2) : at;
            run_to(b, b->tube, &b->next, t / 2);
            crt_tube_set_knobs(b->tube, (struct crt_knobs){0.05 * n, 1, 0.1 * n});
            run_to(b, b->tube, &b->next, t);
            struct crt_state saved = save(b->tube);
            struct crt_tube *second = new_tube(b, others[n % 3]);
            load(second, &saved);
            assert_true(crt_tube_knobs(second).focus == 0.1 * n);
            struct crt_state again = save(second);
            assert_int_equal(again.size, saved.size);
            assert_memory_equal(again.out, saved.out, saved.size);
            go_on_alike(b, second, t, &seed);
            crt_state_free(&again);
            crt_state_free(&saved);
            crt_tube_destroy(second);
            tear_down(b);
        }
}

/* The instant of saving itself changes nothing: not for a film being exposed across it either. */
static void saving_is_not_seen(void **state)
{
    (void)state;
    for (int kind = 0; kind < 3; kind++) {
        struct bench *b = set_up(kind);
        struct crt_tube *second = new_tube(b, plain);
        struct crt_film film[2];
        struct crt_error err;
        double light = 0;
        int next = 0;
        assert_true(crt_film_init(&film[0], b->tube, &err));
        assert_true(crt_film_init(&film[1], second, &err));
        crt_film_open(b->tube, &film[0], TICK / 2, 6 * TICK);
        crt_film_open(second, &film[1], TICK / 2, 6 * TICK);
        run_to(b, second, &next, 6 * TICK);
        for (int i = 1; i <= 40; i++) {
            run_to(b, b->tube, &b->next, 6 * TICK / 40 * (uint64_t)i);
            struct crt_state s = save(b->tube);
            crt_state_free(&s);
        }
        run_to(b, b->tube, &b->next, 6 * TICK);
        films_equal(&film[0], &film[1], &light);
        assert_true(light > 0);
        crt_film_free(&film[0]);
        crt_film_free(&film[1]);
        crt_tube_destroy(second);
        tear_down(b);
    }
}

/* Whether somebody looks, when planes are aged, how many threads: not in the bytes. */
static void the_bytes_do_not_depend_on_observing(void **state)
{
    (void)state;
    for (int kind = 0; kind < 3; kind++) {
        struct bench *b = set_up(kind);
        struct crt_tube *second = new_tube(b, (struct how){2, CRT_SIMD_AUTO, false});
        struct crt_film film;
        struct crt_error err;
        int next = 0;
        uint64_t t = 8 * TICK + 12345;
        run_to(b, b->tube, &b->next, t);
        assert_true(crt_film_init(&film, second, &err));
        for (uint64_t at = 0; at < t; at += t / 50 + 1) {
            if (film.complete || film.t1 == 0)
                crt_film_open(second, &film, at, at + TICK);
            run_to(b, second, &next, at);
        }
        run_to(b, second, &next, t);
        crt_film_cancel(second, &film);
        struct crt_state one = save(b->tube), two = save(second);
        assert_int_equal(one.size, two.size);
        assert_memory_equal(one.out, two.out, one.size);
        crt_state_free(&one);
        crt_state_free(&two);
        crt_film_free(&film);
        crt_tube_destroy(second);
        tear_down(b);
    }
}

/* What the tube showed before is gone when another state is loaded. */
static void a_used_tube_forgets(void **state)
{
    (void)state;
    struct bench *b = set_up(1);
    struct crt_tube *second = new_tube(b, plain);
    struct crt_state dark = save(second);
    struct crt_film film;
    struct crt_error err;
    uint32_t seed = 1;
    int next = 0;
    run_to(b, second, &next, 7 * TICK + 99);
    assert_true(crt_film_init(&film, second, &err));
    crt_film_open(second, &film, 7 * TICK + 99, 9 * TICK);
    load(second, &dark);
    assert_false(crt_film_end(second, &film)); /* it is not open any more */
    crt_film_free(&film);
    assert_true(crt_tube_totals(second).stored == 0);
    assert_int_equal(crt_tube_times(second).now, 0);
    run_to(b, b->tube, &b->next, 3 * TICK / 2);
    struct crt_state saved = save(b->tube);
    run_to(b, second, &next, 5 * TICK);
    load(second, &saved);
    go_on_alike(b, second, 3 * TICK / 2, &seed);
    crt_state_free(&dark);
    crt_state_free(&saved);
    crt_tube_destroy(second);
    tear_down(b);
}

/* Loads damaged bytes; when they are taken, what the tube shows is a number and time goes on. */
static bool survives(struct bench *b, struct crt_tube *tube, const uint8_t *bytes, size_t size)
{
    struct crt_state s;
    crt_state_load(&s, bytes, size);
    crt_tube_state(tube, &s);
    if (s.failed)
        return false;
    struct crt_film film;
    struct crt_error err;
    struct crt_tube_times times = crt_tube_times(tube);
    uint64_t t = times.now > times.last_start ? times.now : times.last_start;
    struct crt_stroke stroke = b->stroke[0];
    stroke.t0 = t;
    stroke.t1 = t + 1000000;
    assert_true(crt_film_init(&film, tube, &err));
    crt_film_open(tube, &film, times.now, times.now + TICK / 3);
    if (t < times.now + TICK)
        crt_tube_stroke(tube, &stroke);
    crt_tube_advance(tube, times.now + TICK);
    for (size_t i = 0; i < (size_t)COLS * ROWS; i++)
        assert_true(isfinite(film.light[0][i]));
    assert_true(isfinite(crt_tube_totals(tube).stored));
    crt_film_free(&film);
    return true;
}

static void damage_is_refused_or_harmless(void **state)
{
    (void)state;
    struct bench *b = set_up(1);
    struct crt_tube *tube = new_tube(b, plain);
    int taken = 0, refused = 0;
    run_to(b, b->tube, &b->next, TICK + TICK / 7);
    struct crt_state saved = save(b->tube);
    for (size_t i = 0; i < saved.size; i += i < 200 || i + 3000 > saved.size ? 1 : 97) {
        uint8_t bit = (uint8_t)(i < 200 ? 0x80 : 1 << i % 8);
        saved.out[i] ^= bit;
        if (survives(b, tube, saved.out, saved.size))
            taken++;
        else
            refused++;
        saved.out[i] ^= bit;
    }
    print_message("# %d damaged bytes taken, %d refused\n", taken, refused);
    assert_true(taken > 100 && refused > 100);
    for (size_t size = 0; size < saved.size; size += 211)
        assert_false(survives(b, tube, saved.out, size));
    assert_true(survives(b, tube, saved.out, saved.size));
    crt_state_free(&saved);
    crt_tube_destroy(tube);
    tear_down(b);
}

static void another_grid_is_refused(void **state)
{
    (void)state;
    struct bench *b = set_up(0);
    struct crt_state s, saved = save(b->tube);
    struct crt_error err;
    struct crt_tube_desc desc = {.row = &b->row,
                                 .phosphor = &b->phosphor,
                                 .grid = {COLS, ROWS - 1, CELL, 0, 0},
                                 .epoch = {60, 1},
                                 .knobs = {0, 1, 0},
                                 .threads = 1};
    struct crt_tube *other = crt_tube_create(&desc, &err);
    assert_non_null(other);
    crt_state_load(&s, saved.out, saved.size);
    crt_tube_state(other, &s);
    assert_true(s.failed);
    assert_non_null(strstr(s.err.text, "other film cells"));
    crt_state_free(&saved);
    crt_tube_destroy(other);
    tear_down(b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_goes_on_from_any_instant),
        cmocka_unit_test(saving_is_not_seen),
        cmocka_unit_test(the_bytes_do_not_depend_on_observing),
        cmocka_unit_test(a_used_tube_forgets),
        cmocka_unit_test(damage_is_refused_or_harmless),
        cmocka_unit_test(another_grid_is_refused),
    };
    return cmocka_run_group_tests_name("tube_state", tests, NULL, NULL);
}
