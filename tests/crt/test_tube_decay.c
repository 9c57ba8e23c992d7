/* The built-in phosphors seen through the tube: a spot is flashed, and a photodiode on the glass
 * (the probe) and films measure how its light falls; against the times each row was made from. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "crt/tube.h"
#include "tests/support/tube_model.h"

#define SIGMA 0.25
#define X     (SIGMA / 2) /* the centre of a cell */

struct bench {
    struct crt_tube_row row;
    struct crt_tube_desc desc;
    struct crt_tube *tube;
    uint64_t flash; /* end of the flash */
    uint64_t tick;  /* epochs ended */
};

static void flash(struct bench *b, const struct crt_phosphor *p)
{
    b->row = model_row(SIGMA, 0);
    b->row.line_luminance.value = 1e8; /* bright, so that no floor is reached */
    b->desc = (struct crt_tube_desc){
        .row = &b->row,
        .phosphor = p,
        .grid = {32, 32, SIGMA, -16 * SIGMA, 16 * SIGMA},
        .epoch = {60, 1},
        .knobs = {0, 1, 0},
        .threads = 1,
    };
    double shortest = 1;
    for (int k = 0; k < p->terms; k++)
        shortest = fmin(shortest, p->term[k].tau_s);
    struct crt_error err;
    b->tube = crt_tube_create(&b->desc, &err);
    assert_non_null(b->tube);
    b->tick = 0;
    b->flash = 1000000 + (uint64_t)fmax(1, fmin(1e6, shortest * 1e12 / 2000));
    struct crt_stroke s = {.t0 = 1000000,
                           .t1 = b->flash,
                           .x0 = (float)X,
                           .y0 = (float)X,
                           .x1 = (float)X,
                           .y1 = (float)X,
                           .drive = 1};
    crt_tube_stroke(b->tube, &s);
}

static double probe(const struct bench *b, uint64_t t)
{
    double cd_m2[CRT_MAX_COLOURS];
    crt_tube_probe(b->tube, X, X, t, cd_m2);
    return cd_m2[0] + cd_m2[1] + cd_m2[2];
}

/* When the light has fallen to `goal`, seconds after the flash; never called for less later. */
static double falls_to(struct bench *b, double goal)
{
    uint64_t end;
    while (probe(b, end = crt_tick_time(b->desc.epoch, b->tick + 1)) > goal) {
        crt_tube_advance(b->tube, end);
        b->tick++;
        assert_true(b->tick < 6000);
    }
    uint64_t low = crt_tick_time(b->desc.epoch, b->tick), high = end;
    if (low < b->flash)
        low = b->flash;
    while (high - low > 1) {
        uint64_t middle = low + (high - low) / 2;
        *(probe(b, middle) > goal ? &low : &high) = middle;
    }
    return (double)(high - b->flash) * 1e-12;
}

/* The same from the row's terms alone, by stepping. */
static double of_terms(const struct crt_phosphor *p, double fraction)
{
    double t = 1e-10, start = 0, light;
    for (int k = 0; k < p->terms; k++)
        start += p->term[k].w / p->term[k].tau_s;
    do {
        t *= 1.0005;
        light = 0;
        for (int k = 0; k < p->terms; k++)
            light += p->term[k].w / p->term[k].tau_s * exp(-t / p->term[k].tau_s);
    } while (light > fraction * start);
    return t;
}

static void simulated_decay_times(void **state)
{
    (void)state;
    size_t count;
    const struct crt_phosphor *p = crt_phosphors(&count);
    double worst = 0;
    for (size_t i = 0; i < count; i++, p++) {
        struct bench b;
        flash(&b, p);
        const struct crt_persistence *from =
            p->made_from == CRT_FROM_JEDEC ? &p->jedec : &p->tektronix;
        double published[3] = {from->t10_s, from->t1_s, from->t01_s}, full = probe(&b, b.flash);
        assert_true(full > 0);
        for (int n = 0; n < 3; n++) {
            double fraction = pow(10, -1 - n), low = published[n], high = low;
            if (n == 0 && from->t10_high_s > 0)
                high = from->t10_high_s;
            if (p->made_from == CRT_FROM_IMPULSE || low == 0)
                low = high = of_terms(p, fraction); /* what the row's terms say */
            double t = falls_to(&b, fraction * full);
            worst = fmax(worst, fmax(low / t, t / high) - 1);
            if (t < 0.98 * low || t > 1.02 * high)
                fail_msg("%s falls to %g %% in %g s, its row says %g…%g s", p->name, 100 * fraction,
                         t, low, high);
        }
        crt_tube_destroy(b.tube);
    }
    print_message("# decay times of %zu phosphors: off by at most %.2f %%\n", count, 100 * worst);
}

/* Light on film from a moment on is what the terms still hold then: at 10, 1 and 0.1 % too. */
static void films_of_the_afterglow(void **state)
{
    (void)state;
    size_t count;
    const struct crt_phosphor *p = crt_phosphors(&count);
    for (size_t i = 0; i < count; i++, p++)
        for (int n = 0; n < 3; n++) {
            struct bench b;
            struct crt_error err;
            struct crt_film all, rest;
            flash(&b, p);
            double t = of_terms(p, pow(10, -1 - n)), kept = 0, total = 0, held = 0;
            uint64_t from = b.flash + (uint64_t)(t * 1e12), to = from + 4 * from;
            assert_true(crt_film_init(&all, b.tube, &err) && crt_film_init(&rest, b.tube, &err));
            crt_film_open(b.tube, &all, 0, to);
            crt_film_open(b.tube, &rest, from, to);
            crt_tube_advance(b.tube, to);
            size_t cell = 15 * 32 + 16; /* under the probe */
            for (int c = 0; c < p->colours; c++) {
                total += (double)all.light[c][cell];
                kept += (double)rest.light[c][cell];
            }
            double shown = 0, dark = (double)(from - b.flash) * 1e-12;
            double end = (double)(to - b.flash) * 1e-12;
            for (int k = 0; k < p->terms; k++) {
                held +=
                    p->term[k].w * (exp(-dark / p->term[k].tau_s) - exp(-end / p->term[k].tau_s));
                shown += p->term[k].w * -expm1(-end / p->term[k].tau_s);
            }
            if (fabs(kept / total - held / shown) > 2e-3 * held / shown + 1e-6)
                fail_msg("%s: %g of the light after %g s, the terms say %g", p->name, kept / total,
                         t, held / shown);
            crt_film_free(&all);
            crt_film_free(&rest);
            crt_tube_destroy(b.tube);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(simulated_decay_times),
        cmocka_unit_test(films_of_the_afterglow),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
