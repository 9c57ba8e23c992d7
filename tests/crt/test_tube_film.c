/* Film against a slow exact integral: random strokes, phosphors from nanoseconds to seconds,
 * exposures of a microsecond to seconds that begin and end anywhere. */
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

#define SIGMA 0.25
#define COLS  104
#define ROWS  90

struct picture {
    struct crt_tube_row row;
    struct crt_phosphor phosphor;
    struct crt_tube_desc desc;
    struct model_stroke strokes[400];
    int count;
};

static void set_up(struct picture *p, struct crt_phosphor phosphor, double cell_mm, double growth)
{
    p->row = model_row(SIGMA, growth);
    p->phosphor = phosphor;
    p->desc = (struct crt_tube_desc){
        .row = &p->row,
        .phosphor = &p->phosphor,
        .grid = {COLS, ROWS, cell_mm, -COLS * cell_mm / 2, ROWS * cell_mm / 2},
        .epoch = {60, 1},
        .knobs = {0, 1, 0},
        .threads = 1,
    };
    p->count = 0;
}

static void add(struct picture *p, struct crt_stroke s)
{
    struct crt_spot spot = crt_spot_at(&p->row, &p->desc.knobs, (double)s.drive);
    p->strokes[p->count++] = (struct model_stroke){s, spot.power, spot.sigma_mm};
}

/* Exposes [a, b), calling advance in steps of `step` (0: once). */
static void expose(const struct picture *p, struct crt_film *film, uint64_t a, uint64_t b,
                   uint64_t step)
{
    struct crt_error err;
    struct crt_tube *tube = crt_tube_create(&p->desc, &err);
    assert_non_null(tube);
    assert_true(crt_film_init(film, tube, &err));
    bool open = false;
    int next = 0;
    uint64_t now = 0;
    while (!film->complete) {
        uint64_t to = step ? now + step : b;
        if (!open && to >= a) {
            to = a;
        } else if (to > b) {
            to = b;
        }
        while (next < p->count && p->strokes[next].stroke.t0 < to)
            crt_tube_stroke(tube, &p->strokes[next++].stroke);
        crt_tube_advance(tube, to);
        now = to;
        if (!open && now >= a) {
            crt_film_open(tube, film, a, b);
            open = true;
        }
    }
    crt_tube_destroy(tube);
}

/* Greatest difference from the exact integral at the brightest cell and `samples` others, over
 * peak. */
static double worst(const struct picture *p, const struct crt_film *film, int samples,
                    uint32_t *seed)
{
    size_t cells = (size_t)COLS * ROWS, brightest = 0;
    for (size_t i = 0; i < cells; i++)
        if (film->light[0][i] > film->light[0][brightest])
            brightest = i;
    double peak = (double)film->light[0][brightest], most = 0, exact_peak = 0;
    for (int n = 0; n < samples; n++) {
        size_t i = n == 0 ? brightest : model_random(seed) % cells;
        if (n > samples / 3 && !(film->light[0][i] > 0)) {
            for (int tries = 0; tries < 20 && !((double)film->light[0][i] > 1e-3 * peak); tries++)
                i = model_random(seed) % cells;
        }
        double x, y;
        x = film->grid.left_mm + ((double)(i % COLS) + 0.5) * film->grid.cell_mm;
        y = film->grid.top_mm - ((double)(i / COLS) + 0.5) * film->grid.cell_mm;
        double exact = model_light(p->strokes, p->count, &p->phosphor, 0, x, y, film->t0, film->t1);
        exact_peak = fmax(exact_peak, exact);
        most = fmax(most, fabs((double)film->light[0][i] - exact));
    }
    /* The spot is cut off at 1e-5 of its crest, which may lie off the grid. */
    for (int i = 0; i < p->count; i++) {
        const struct crt_stroke *s = &p->strokes[i].stroke;
        double x = ((double)s->x0 + (double)s->x1) / 2, y = ((double)s->y0 + (double)s->y1) / 2;
        exact_peak = fmax(exact_peak, model_light(p->strokes, p->count, &p->phosphor, 0, x, y,
                                                  film->t0, film->t1));
    }
    peak = fmax(peak, exact_peak);
    /* Light too faint for anybody is not followed. */
    if (peak < 1e-8)
        return most < 2e-9 ? 0 : 1;
    return most / peak;
}

static struct crt_stroke random_stroke(uint32_t *seed, uint64_t t0, double size_mm,
                                       double longest_us)
{
    struct crt_stroke s = {.t0 = t0, .drive = (float)model_uniform(seed, 0.3, 1)};
    double lit = exp(model_uniform(seed, log(0.02), log(longest_us)));
    s.t1 = t0 + (uint64_t)(lit * 1e6) + 1;
    double edge = 0.5 * size_mm;
    s.x0 = (float)model_uniform(seed, -edge, edge);
    s.y0 = (float)model_uniform(seed, -edge, edge);
    switch (model_random(seed) % 5) {
    case 0: /* a dot */
        s.x1 = s.x0;
        s.y1 = s.y0;
        break;
    case 1: { /* short */
        double l = exp(model_uniform(seed, log(0.001), log(3.0)));
        double angle = model_uniform(seed, 0, 6.28318);
        s.x1 = s.x0 + (float)(l * cos(angle));
        s.y1 = s.y0 + (float)(l * sin(angle));
        break;
    }
    case 2: /* along an axis */
        s.x1 = s.x0;
        s.y1 = s.y0;
        *(model_random(seed) & 1 ? &s.x1 : &s.y1) = (float)model_uniform(seed, -edge, edge);
        break;
    default:
        s.x1 = (float)model_uniform(seed, -edge, edge);
        s.y1 = (float)model_uniform(seed, -edge, edge);
    }
    return s;
}

static struct crt_phosphor phosphor_number(unsigned n)
{
    static const double fast_w[] = {0.35, 0.35, 0.3}, fast_tau[] = {0.000736, 0.00493, 0.0204};
    static const double mixed_w[] = {0.4, 0.35, 0.25}, mixed_tau[] = {0.12, 2.16, 18.8};
    static const double one[] = {1}, p46[] = {0.00007}, p39[] = {150 / 2.303}, p33[] = {955};
    static const double edge_tau[] = {1.3};
    switch (n % 6) {
    case 0:
        return model_phosphor(3, fast_w, fast_tau);
    case 1:
        return model_phosphor(3, mixed_w, mixed_tau);
    case 2:
        return model_phosphor(1, one, p46);
    case 3:
        return model_phosphor(1, one, p39);
    case 4:
        return model_phosphor(1, one, p33);
    default:
        return model_phosphor(1, one, edge_tau);
    }
}

/* As a vector is drawn: the spot rests for a part of the time, moves, rests. */
static void add_rested(struct picture *p, struct crt_stroke s, double part)
{
    uint64_t rest = (uint64_t)(part * (double)(s.t1 - s.t0));
    struct crt_stroke start = s, end = s;
    start.x1 = s.x0;
    start.y1 = s.y0;
    end.x0 = s.x1;
    end.y0 = s.y1;
    start.t1 = s.t0 = s.t0 + rest;
    end.t0 = s.t1 = s.t1 - rest;
    if (rest > 0)
        add(p, start);
    add(p, s);
    if (rest > 0)
        add(p, end);
}

/* One random scene; whether it agrees. */
static double scene(uint32_t *seed, unsigned number, bool talk)
{
    struct picture *p = malloc(sizeof *p);
    struct crt_film film;
    double cell = number % 7 == 6 ? SIGMA / 6 : SIGMA;
    set_up(p, phosphor_number(number), cell, number % 2 ? 0.2 : 0);
    double longest = exp(model_uniform(seed, log(1.0), log(3000.0)));
    if (number % 11 == 10)
        longest = 40000; /* over several epochs */
    uint64_t t = (uint64_t)model_uniform(seed, 0, 2e10);
    int strokes = 1 + (int)(model_random(seed) % 40);
    for (int i = 0; i < strokes; i++) {
        struct crt_stroke s = random_stroke(seed, t, 1.2 * COLS * cell, longest);
        if (number % 3 == 1)
            add_rested(p, s, i % 2 ? 0.01 : 0.2);
        else
            add(p, s);
        t = p->strokes[p->count - 1].stroke.t1;
        t += (uint64_t)model_uniform(seed, 0, longest * 1e5);
    }
    /* Exposures that begin at, in, before or after the strokes. */
    uint64_t begin = p->strokes[0].stroke.t0, end = t;
    double span = (double)(end - begin) + 1e6;
    double exposure = exp(model_uniform(seed, log(1e6), log(3e11)));
    if (model_random(seed) % 3)
        exposure = exp(model_uniform(seed, log(1e-3), log(3.0))) * span + 1;
    double start = (double)begin + model_uniform(seed, -0.5, 1.2) * span;
    if (model_random(seed) % 4 == 0) { /* ends in the middle of a stroke */
        const struct crt_stroke *s = &p->strokes[model_random(seed) % (unsigned)strokes].stroke;
        start = (double)s->t0 + model_uniform(seed, 0.01, 1) * (double)(s->t1 - s->t0) - exposure;
    }
    uint64_t a = start > 0 ? (uint64_t)start : 0, b = a + (uint64_t)exposure;
    expose(p, &film, a, b, 0);
    double off = worst(p, &film, 60, seed), peak = 0;
    for (int i = 0; i < COLS * ROWS; i++)
        peak = fmax(peak, (double)film.light[0][i]);
    if (talk && off > 0.8e-3)
        print_message("# scene %u: off by %.2e of peak; cell %g, %d strokes up to %g us, exposure "
                      "%g us, peak %g\n",
                      number, off, cell, strokes, longest, exposure * 1e-6, peak);
    crt_film_free(&film);
    free(p);
    return off;
}

static void film_is_the_integral(void **state)
{
    (void)state;
    uint32_t seed = 12345;
    double most = 0;
    for (unsigned n = 0; n < 240; n++)
        most = fmax(most, scene(&seed, n, true));
    print_message("# film: off by at most %.2e of peak in 240 scenes\n", most);
    assert_true(most < 1e-3);
}

/* A refresh of P39 exposed from tick to tick, the usual case; then the next, from planes. */
static void refreshes_in_a_row(void **state)
{
    (void)state;
    uint32_t seed = 99;
    struct picture *p = malloc(sizeof *p);
    for (unsigned kind = 0; kind < 6; kind++) {
        set_up(p, phosphor_number(kind), SIGMA, 0);
        for (uint64_t epoch = 0; epoch < 6; epoch++) {
            uint64_t t = crt_tick_time(p->desc.epoch, epoch);
            for (int i = 0; i < 60; i++) {
                add(p, random_stroke(&seed, t, COLS * SIGMA, 200));
                t = p->strokes[p->count - 1].stroke.t1;
            }
        }
        struct crt_film film;
        expose(p, &film, crt_tick_time(p->desc.epoch, 4), crt_tick_time(p->desc.epoch, 6), 0);
        double off = worst(p, &film, 60, &seed);
        print_message("# refreshes of phosphor %u: off by %.2e of peak\n", kind, off);
        assert_true(off < 1e-3);
        crt_film_free(&film);
    }
    free(p);
}

/* Opened for longer than it is exposed: as one that was opened for just that long. */
static void end_of_a_film(const struct picture *p, uint64_t a, uint64_t b)
{
    struct crt_error err;
    struct crt_film film, whole;
    struct crt_tube *tube = crt_tube_create(&p->desc, &err);
    assert_non_null(tube);
    assert_true(crt_film_init(&film, tube, &err));
    int next = 0;
    for (int half = 0; half < 2; half++) {
        uint64_t to = half ? b : a;
        while (next < p->count && p->strokes[next].stroke.t0 < to)
            crt_tube_stroke(tube, &p->strokes[next++].stroke);
        crt_tube_advance(tube, to);
        if (!half)
            crt_film_open(tube, &film, a, 10 * CRT_PS_PER_S);
    }
    assert_true(crt_film_end(tube, &film));
    assert_true(film.complete && film.t0 == a && film.t1 == b);
    assert_false(crt_film_end(tube, &film)); /* it is not open any more */
    expose(p, &whole, a, b, 0);
    assert_memory_equal(film.light[0], whole.light[0], COLS * ROWS * sizeof(float));

    crt_film_open(tube, &film, b, b + 1);
    assert_false(crt_film_end(tube, &film)); /* nothing has been exposed */
    assert_false(film.complete);
    crt_film_open(tube, &film, b, b + 1);
    crt_tube_cancel_films(tube);
    crt_tube_advance(tube, b + 1);
    assert_false(film.complete);
    crt_film_free(&film);
    crt_film_free(&whole);
    crt_tube_destroy(tube);
}

static void ended_early(void **state)
{
    (void)state;
    uint32_t seed = 7;
    struct picture *p = malloc(sizeof *p);
    set_up(p, phosphor_number(1), SIGMA, 0);
    for (uint64_t t = 0; p->count < 300; t = p->strokes[p->count - 1].stroke.t1)
        add(p, random_stroke(&seed, t, COLS * SIGMA, 200));
    uint64_t last = p->strokes[p->count - 1].stroke.t1, epoch = crt_tick_time(p->desc.epoch, 1);
    end_of_a_film(p, 0, 1);
    end_of_a_film(p, last / 5, last / 2);
    end_of_a_film(p, last / 3, 2 * epoch);
    end_of_a_film(p, epoch / 2, 3 * epoch + 12345);
    free(p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(film_is_the_integral),
        cmocka_unit_test(refreshes_in_a_row),
        cmocka_unit_test(ended_early),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
