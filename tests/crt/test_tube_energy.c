/* Energy: what strokes bring is in film and phosphor, to 1e-5, at every moment; and what is far
 * off, empty or absurd changes nothing. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "crt/spot.h"
#include "crt/tube.h"
#include "tests/support/tube_model.h"

#define CELL 0.25
#define COLS 160
#define ROWS 150

struct bench {
    struct crt_tube_row row;
    struct crt_phosphor phosphor;
    struct crt_tube_desc desc;
    struct crt_tube *tube;
};

static void set_up(struct bench *b, struct crt_phosphor phosphor, double cell)
{
    b->row = model_row(CELL, 0.2);
    b->phosphor = phosphor;
    b->desc = (struct crt_tube_desc){
        .row = &b->row,
        .phosphor = &b->phosphor,
        .grid = {COLS, ROWS, cell, -COLS * cell / 2, ROWS * cell / 2},
        .epoch = {60, 1},
        .knobs = {0, 1, 0},
        .threads = 1,
    };
    struct crt_error err;
    b->tube = crt_tube_create(&b->desc, &err);
    assert_non_null(b->tube);
}

static struct crt_phosphor phosphor(int kind)
{
    static const double one[] = {1}, p39[] = {65}, p46[] = {0.00007};
    static const double w[] = {0.1, 0.2, 0.3, 0.2, 0.2}, tau[] = {0.0005, 0.12, 2.16, 19, 300};
    return kind == 0   ? model_phosphor(1, one, p39)
           : kind == 1 ? model_phosphor(1, one, p46)
                       : model_phosphor(5, w, tau);
}

static double light_in(const struct crt_film *film)
{
    double sum = 0;
    size_t cells = (size_t)film->grid.cols * (size_t)film->grid.rows;
    for (int c = 0; c < film->colours; c++)
        for (size_t i = 0; i < cells; i++)
            sum += (double)film->light[c][i];
    return sum;
}

/* Energy of a stroke, in the totals' unit: per cell. */
static double brought(const struct bench *b, const struct crt_stroke *s)
{
    double power = crt_spot_at(&b->row, &b->desc.knobs, (double)s->drive).power;
    return power * (double)(s->t1 - s->t0) * 1e-12 / (b->desc.grid.cell_mm * b->desc.grid.cell_mm);
}

static struct crt_stroke inside(uint32_t *seed, double cell)
{
    double w = COLS * cell / 2 - 3, h = ROWS * cell / 2 - 3;
    struct crt_stroke s = {.drive = (float)model_uniform(seed, 0.2, 1)};
    s.x0 = (float)model_uniform(seed, -w, w);
    s.y0 = (float)model_uniform(seed, -h, h);
    s.x1 = (float)model_uniform(seed, -w, w);
    s.y1 = (float)model_uniform(seed, -h, h);
    switch (model_random(seed) % 5) {
    case 0:
        s.x1 = s.x0;
        s.y1 = s.y0;
        break;
    case 1:
        s.x1 = s.x0 + (float)model_uniform(seed, -0.4, 0.4);
        s.y1 = s.y0 + (float)model_uniform(seed, -0.4, 0.4);
        break;
    case 2:
        s.y1 = s.y0;
        break;
    }
    return s;
}

/* Each stroke alone, long after which all of its light is on film. */
static void each_stroke_is_whole(void **state)
{
    (void)state;
    uint32_t seed = 3;
    double worst = 0;
    for (int i = 0; i < 300; i++) {
        struct bench b;
        set_up(&b, phosphor(1), i % 5 == 4 ? CELL / 3 : CELL);
        struct crt_film film;
        struct crt_error err;
        assert_true(crt_film_init(&film, b.tube, &err));
        struct crt_stroke s = inside(&seed, b.desc.grid.cell_mm);
        s.t0 = 1000000;
        s.t1 = s.t0 + 5000000;
        crt_film_open(b.tube, &film, 0, crt_tick_time(b.desc.epoch, 1));
        crt_tube_stroke(b.tube, &s);
        crt_tube_advance(b.tube, crt_tick_time(b.desc.epoch, 1));
        double off = light_in(&film) / brought(&b, &s) - 1;
        if (fabs(off) > fabs(worst))
            worst = off;
        crt_film_free(&film);
        crt_tube_destroy(b.tube);
    }
    print_message("# a stroke's energy is off by at most %.2e\n", worst);
    assert_true(fabs(worst) < 1e-5);
}

/* Films end to end over many epochs with odd exposures; stored and exposed light against what was
 * brought. */
static void nothing_is_lost_over_time(void **state)
{
    (void)state;
    for (int kind = 0; kind < 3; kind++) {
        struct bench b;
        set_up(&b, phosphor(kind), CELL);
        struct crt_film film;
        struct crt_error err;
        assert_true(crt_film_init(&film, b.tube, &err));
        uint32_t seed = 17;
        uint64_t now = 0, t = 0;
        double sum = 0, exposed = 0, worst = 0, left = 0;
        for (int n = 0; n < 200; n++) {
            uint64_t to = now + 1000000 + model_random(&seed) % 20000 * 1000000;
            crt_film_open(b.tube, &film, now, to);
            while (n < 60 && t < to) {
                struct crt_stroke s = inside(&seed, CELL);
                s.t0 = t;
                s.t1 = t + 2000000 + model_random(&seed) % 200000000;
                /* Every stroke ends with the exposure at the latest, so that it counts once. */
                if (s.t1 > to)
                    s.t1 = to;
                t = s.t1 + 10000000;
                crt_tube_stroke(b.tube, &s);
                sum += brought(&b, &s);
            }
            if (t < to)
                t = to;
            crt_tube_advance(b.tube, to);
            now = to;
            assert_true(film.complete);
            exposed += light_in(&film);
            left = crt_tube_totals(b.tube).stored;
            double off = (exposed + left) / sum - 1;
            if (n > 3 && fabs(off) > fabs(worst))
                worst = off;
        }
        print_message("# phosphor %d: %.2e off at worst, %.2g of it still stored\n", kind, worst,
                      left / sum);
        assert_true(fabs(worst) < 1e-5);
        crt_film_free(&film);
        crt_tube_destroy(b.tube);
    }
}

static void totals_follow_decay(void **state)
{
    (void)state;
    struct bench b;
    set_up(&b, phosphor(0), CELL);
    struct crt_stroke s = {.t0 = 0, .t1 = 1000000, .x0 = -5, .x1 = 5, .y0 = 1, .y1 = 2, .drive = 1};
    crt_tube_stroke(b.tube, &s);
    double all = brought(&b, &s), tau = 0.065;
    const double at_ms[] = {0.001, 1, 16, 17, 40, 100, 400};
    for (unsigned i = 0; i < sizeof at_ms / sizeof at_ms[0]; i++) {
        crt_tube_advance(b.tube, (uint64_t)(at_ms[i] * 1e9));
        double want = all * exp(-(at_ms[i] * 1e-3 - 0.5e-6) / tau);
        assert_true(fabs(crt_tube_totals(b.tube).stored / want - 1) < 2e-5);
    }
    assert_int_equal(crt_tube_totals(b.tube).strokes, 1);
    crt_tube_advance(b.tube, 10 * CRT_PS_PER_S);
    assert_true(crt_tube_totals(b.tube).stored == 0);
    /* An idle week passes at once. */
    crt_tube_advance(b.tube, 7 * 86400 * CRT_PS_PER_S);
    crt_tube_destroy(b.tube);
}

/* Strokes that no tube should trip over. */
static void odd_strokes(void **state)
{
    (void)state;
    const float inf = (float)INFINITY, nan = (float)NAN, big = 3e38F;
    const struct crt_stroke odd[] = {
        {.x0 = nan, .drive = 1},
        {.x1 = inf, .drive = 1},
        {.drive = nan},
        {.drive = -1},
        {.drive = 0},
        {.x0 = big, .y0 = big, .x1 = big, .y1 = -big, .drive = 1},
        {.x0 = -1e9F, .x1 = -1e9F, .drive = 1},
        {.x0 = 1000, .x1 = 1001, .drive = 1},
    };
    struct bench b;
    struct crt_film film;
    struct crt_error err;
    for (int kind = 0; kind < 3; kind++) {
        set_up(&b, phosphor(kind), CELL);
        assert_true(crt_film_init(&film, b.tube, &err));
        crt_film_open(b.tube, &film, 0, 3 * CRT_PS_PER_S);
        uint64_t t = 0;
        for (unsigned i = 0; i < sizeof odd / sizeof odd[0]; i++) {
            struct crt_stroke s = odd[i];
            s.t0 = t;
            t = s.t1 = t + 1000000;
            crt_tube_stroke(b.tube, &s);
        }
        struct crt_stroke none = {.t0 = t, .t1 = t, .drive = 1}; /* lasts no time */
        crt_tube_stroke(b.tube, &none);
        crt_tube_advance(b.tube, 3 * CRT_PS_PER_S);
        assert_true(light_in(&film) == 0);
        /* A line from one far end to the other: its share on the grid; and a spot parked for
         * seconds. */
        crt_film_open(b.tube, &film, 3 * CRT_PS_PER_S, 3003 * CRT_PS_PER_MS);
        struct crt_stroke across = {.t0 = 3 * CRT_PS_PER_S, .x0 = -1e7F, .x1 = 1e7F, .drive = 1};
        across.t1 = across.t0 + 2 * CRT_PS_PER_MS;
        crt_tube_stroke(b.tube, &across);
        crt_tube_advance(b.tube, 3003 * CRT_PS_PER_MS);
        double share = COLS * CELL / 2e7, got = light_in(&film) / (share * brought(&b, &across));
        print_message("# across: %g of its light at once\n", got);
        assert_true(got > 0 && got < 1.001);
        if (kind == 1) /* the float positions of its ends are exact enough for 1e-3 */
            assert_true(fabs(got - 1) < 1e-3);
        crt_film_open(b.tube, &film, 3003 * CRT_PS_PER_MS, 9 * CRT_PS_PER_S);
        struct crt_stroke parked = {.t0 = 3003 * CRT_PS_PER_MS, .t1 = 7 * CRT_PS_PER_S, .drive = 1};
        crt_tube_stroke(b.tube, &parked);
        crt_tube_advance(b.tube, 9 * CRT_PS_PER_S);
        got = light_in(&film) / brought(&b, &parked);
        print_message("# parked: %g\n", got);
        assert_true(fabs(got - 1) < 2e-3);
        assert_true(crt_tube_intact(b.tube, &err));
        crt_film_free(&film);
        crt_tube_destroy(b.tube);
    }
}

/* Many strokes in one epoch: more than a batch, more than reuse can keep. */
static void a_crowded_epoch(void **state)
{
    (void)state;
    struct bench b;
    set_up(&b, phosphor(2), CELL);
    struct crt_film film;
    struct crt_error err;
    assert_true(crt_film_init(&film, b.tube, &err));
    uint64_t end = crt_tick_time(b.desc.epoch, 1);
    double sum = 0;
    for (uint64_t n = 0; n < 3; n++) {
        uint32_t seed = 9;
        uint64_t t = crt_tick_time(b.desc.epoch, n);
        if (n == 2)
            crt_film_open(b.tube, &film, t, crt_tick_time(b.desc.epoch, 200));
        for (int i = 0; i < 20000; i++) {
            struct crt_stroke s = inside(&seed, CELL);
            s.t0 = t;
            t = s.t1 = t + 600000;
            crt_tube_stroke(b.tube, &s);
            if (n == 2)
                sum += brought(&b, &s);
        }
        if (n < 2)
            crt_tube_advance(b.tube, crt_tick_time(b.desc.epoch, n + 1));
        if (n == 1)
            sum += crt_tube_totals(b.tube).stored;
    }
    (void)end;
    crt_tube_advance(b.tube, crt_tick_time(b.desc.epoch, 200));
    double got = (light_in(&film) + crt_tube_totals(b.tube).stored) / sum;
    print_message("# crowded: %.2e off\n", got - 1);
    assert_true(fabs(got - 1) < 1e-5);
    crt_film_free(&film);
    crt_tube_destroy(b.tube);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_stroke_is_whole), cmocka_unit_test(nothing_is_lost_over_time),
        cmocka_unit_test(totals_follow_decay),  cmocka_unit_test(odd_strokes),
        cmocka_unit_test(a_crowded_epoch),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
