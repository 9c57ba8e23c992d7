/* Photodiodes over time: shares and integrals, light from before, forgetting, snapshots; and that they change
 * nothing. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crt/spot.h"
#include "tests/support/diode_rig.h"
#include "tests/support/line_model.h"

#define PI 3.14159265358979324

/* ---- shares, integrals --------------------------------------------------------------------------------- */

static void shares_sum_to_the_luminance(void **state)
{
    (void)state;
    const double w[] = {0.5, 0.5}, tau[] = {0.05, 4};
    struct crt_phosphor p = model_phosphor(2, w, tau);
    struct crt_tube_row row = model_row(0.25, 0.1);
    struct crt_tube *tube = vector_tube(&row, &p, 64, 64);
    uint32_t seed = 21;
    uint64_t end = draw(tube, &seed, 0, 100, 3);
    crt_tube_advance(tube, end);
    struct crt_photodiode *d = open_diode(tube, CRT_DIODE_POINT, 0.2, 0.1, 0);
    uint64_t start = crt_photodiode_from(d);
    end = draw(tube, &seed, end, 200, 3);
    crt_tube_advance(tube, end);
    for (int i = 0; i < 300; i++) {
        uint64_t t = start + model_random(&seed) % (end - start);
        size_t count;
        const struct crt_deposit *at = crt_photodiode_deposits(d, &count);
        double sum = crt_photodiode_older(d, t), all = crt_photodiode_luminance(d, t);
        for (size_t k = 0; k < count && at[k].t0 < t; k++)
            sum += crt_photodiode_share(d, k, t);
        assert_close(sum, all, 1e-12 * all);
    }
    crt_photodiode_close(d);
    crt_tube_destroy(tube);
}

/* Gathering and harmonics against sums over fine samples; the window cuts pieces. */
static void integrals_are_those_of_samples(void **state)
{
    (void)state;
    const double w[] = {0.3, 0.3, 0.4}, tau[] = {0.03, 0.4, 30};
    struct crt_phosphor p = model_phosphor(3, w, tau);
    struct crt_tube_row row = model_row(0.25, 0.1);
    struct crt_tube *tube = vector_tube(&row, &p, 8, 8);
    struct crt_photodiode *d = open_diode(tube, CRT_DIODE_DISC, 0, 0, 3);
    uint32_t seed = 8;
    uint64_t end = draw(tube, &seed, 0, 40, 3);
    crt_tube_advance(tube, end);
    const uint64_t a = end / 7, b = end - end / 9;
    const int samples = 150000;
    const double step = (double)(b - a) / samples;
    double *l = malloc((size_t)samples * sizeof *l);
    assert_non_null(l);
    for (int i = 0; i < samples; i++)
        l[i] = crt_photodiode_luminance(d, a + (uint64_t)((i + 0.5) * step));
    static const double hz[] = {0, 300, 5000, 80000};
    for (int h = 0; h < 4; h++) {
        double re = 0, im = 0, sum = 0;
        for (int i = 0; i < samples; i++) {
            double t = (i + 0.5) * step;
            re += l[i] * cos(2 * PI * hz[h] * t * 1e-12) * step * 1e-12;
            im -= l[i] * sin(2 * PI * hz[h] * t * 1e-12) * step * 1e-12;
            sum += l[i] * step * 1e-12;
        }
        struct crt_phasor got = crt_photodiode_harmonic(d, a, b, hz[h]);
        assert_close(got.re, re, 1e-6 * sum);
        assert_close(got.im, im, 1e-6 * sum);
        double light[CRT_MAX_COLOURS];
        crt_photodiode_gather(d, a, b, light);
        assert_close(light[0], sum, 1e-6 * sum);
        if (h == 0)
            assert_close(light[0], got.re, 1e-14 * sum);
    }
    free(l);
    crt_photodiode_close(d);
    crt_tube_destroy(tube);
}

/* ---- what came before; forgetting; snapshots --------------------------------------------------------------- */

static void opened_while_it_runs(void **state)
{
    (void)state;
    const double w[] = {0.3, 0.3, 0.4}, tau[] = {0.002, 3, 60};
    struct crt_phosphor p = model_phosphor(3, w, tau);
    struct crt_tube_row row = model_row(0.25, 0.1);
    static const enum crt_photodiode_kind kind[] = {CRT_DIODE_POINT, CRT_DIODE_DISC,
                                                    CRT_DIODE_SCREEN};
    row.width.value = row.height.value = 20;
    for (int n = 0; n < 3; n++) {
        struct crt_tube *tube = vector_tube(&row, &p, 96, 96);
        struct crt_photodiode *all = open_diode(tube, kind[n], 0.2, 0.1, 2);
        uint32_t seed = 5;
        uint64_t end = draw(tube, &seed, 0, 4000, 4); /* some 80 ms: epochs */
        /* Some of the strokes have been delivered and not begun, one is being drawn. */
        crt_tube_advance(tube, end - 100 * US);
        struct crt_photodiode *late = open_diode(tube, kind[n], 0.2, 0.1, 2);
        crt_tube_advance(tube, end + 20 * MS);
        double highest = 0, off = 0;
        for (int i = 0; i < 500; i++) {
            uint64_t t = end - 100 * US + (uint64_t)i * US;
            double want = crt_photodiode_luminance(all, t);
            highest = fmax(highest, want);
            off = fmax(off, fabs(want - crt_photodiode_luminance(late, t)));
        }
        print_message("# opened while it runs, kind %d: %.2g\n", n, off / highest);
        assert_true(off < 1e-4 * highest);
        crt_photodiode_close(all);
        crt_photodiode_close(late);
        crt_tube_destroy(tube);
    }
}

static void forgetting_changes_nothing(void **state)
{
    (void)state;
    const double w[] = {0.6, 0.4}, tau[] = {0.05, 20};
    struct crt_phosphor p = model_phosphor(2, w, tau);
    struct crt_tube_row row = model_row(0.25, 0.1);
    struct crt_tube *tube = vector_tube(&row, &p, 8, 8);
    struct crt_photodiode *a = open_diode(tube, CRT_DIODE_POINT, 0, 0, 0);
    struct crt_photodiode *b = open_diode(tube, CRT_DIODE_POINT, 0, 0, 0);
    uint32_t seed = 9;
    uint64_t t = 0;
    size_t most = 0, count;
    for (int i = 0; i < 300; i++) {
        uint64_t end = draw(tube, &seed, t, 10, 1);
        crt_tube_advance(tube, end);
        if (i % 3 == 0)
            crt_photodiode_forget(b, t + (end - t) / 3);
        for (int k = 0; k < 5; k++) {
            uint64_t at = crt_photodiode_from(b);
            at += model_random(&seed) % (end + 1 - at);
            assert_true(crt_photodiode_luminance(a, at) == crt_photodiode_luminance(b, at));
        }
        crt_photodiode_deposits(b, &count);
        most = count > most ? count : most;
        t = end;
    }
    crt_photodiode_deposits(a, &count);
    print_message("# %zu deposits; at most %zu where it forgets\n", count, most);
    assert_true(count > 1000 && most < 60);
    crt_photodiode_close(a);
    crt_photodiode_close(b);
    crt_tube_destroy(tube);
}

static void snapshots_restart_it(void **state)
{
    (void)state;
    const double w[] = {0.6, 0.4}, tau[] = {0.05, 20};
    struct crt_phosphor p = model_phosphor(2, w, tau);
    struct crt_tube_row row = model_row(0.25, 0.1);
    struct crt_tube *tube = vector_tube(&row, &p, 64, 64);
    struct crt_photodiode *d = open_diode(tube, CRT_DIODE_POINT, 0.1, 0.1, 0);
    uint32_t seed = 31;
    uint64_t end = draw(tube, &seed, 0, 500, 2);
    crt_tube_advance(tube, end);
    double want = crt_photodiode_luminance(d, end);
    struct crt_state saved, load;
    crt_state_save(&saved);
    crt_tube_state(tube, &saved);
    assert_false(saved.failed);
    crt_tube_advance(tube, end + 200 * MS);
    crt_state_load(&load, saved.out, saved.size);
    crt_tube_state(tube, &load);
    assert_false(load.failed);
    size_t count;
    crt_photodiode_deposits(d, &count);
    assert_int_equal(count, 0);
    assert_true(crt_photodiode_from(d) == end && crt_photodiode_now(d) == end);
    assert_close(crt_photodiode_luminance(d, end), want, 1e-2 * want);
    /* A snapshot that is no good leaves it dark. */
    crt_state_load(&load, saved.out, saved.size / 2);
    crt_tube_state(tube, &load);
    assert_true(load.failed);
    assert_true(crt_photodiode_luminance(d, crt_photodiode_now(d)) == 0);
    crt_state_free(&saved);
    crt_photodiode_close(d);
    crt_tube_destroy(tube);
}

/* ---- observing ------------------------------------------------------------------------------------------------ */

/* Samples do not depend on how time is cut, nor on what was asked before. */
static void cutting_time_changes_nothing(void **state)
{
    (void)state;
    const double w[] = {0.6, 0.4}, tau[] = {0.05, 20};
    struct crt_phosphor p = model_phosphor(2, w, tau);
    struct crt_tube_row row = model_row(0.25, 0.1);
    struct crt_tube *tube[2];
    struct crt_photodiode *d[2];
    uint64_t end = 0;
    for (int n = 0; n < 2; n++) {
        uint32_t seed = 77, other = 5;
        uint64_t t = 0;
        tube[n] = vector_tube(&row, &p, 8, 8);
        d[n] = open_diode(tube[n], CRT_DIODE_DISC, 0, 0, 1);
        for (int i = 0; i < 200; i++) {
            t = draw(tube[n], &seed, t, 1, 2);
            if (n == 0)
                continue;
            crt_tube_advance(tube[n], t - model_random(&other) % (US / 4));
            crt_photodiode_luminance(d[n], model_random(&other) % crt_photodiode_now(d[n]));
        }
        crt_tube_advance(tube[n], end = t);
    }
    for (uint64_t t = 0; t < end; t += US / 3)
        assert_true(crt_photodiode_luminance(d[0], t) == crt_photodiode_luminance(d[1], t));
    for (int n = 0; n < 2; n++) {
        crt_photodiode_close(d[n]);
        crt_tube_destroy(tube[n]);
    }
}

static void films_stay_as_they_are(void **state)
{
    (void)state;
    const double w[] = {0.6, 0.4}, tau[] = {0.05, 20};
    struct crt_phosphor p = model_phosphor(2, w, tau);
    struct crt_tube_row vector = model_row(0.25, 0.1), raster = line_model_row(40, 30, 0.5);
    struct crt_film film[4];
    uint32_t paint_seed = 2;
    vector.width.value = vector.height.value = 20;
    struct raster r = small_raster(1, &paint_seed);
    for (int n = 0; n < 4; n++) {
        struct crt_error err;
        uint32_t seed = 4;
        struct crt_tube *tube =
            n & 2 ? raster_tube(&raster, &p, (struct crt_knobs){0, 1, 0}, 64, 48, 0, 0)
                  : vector_tube(&vector, &p, 64, 48);
        struct crt_photodiode *d[3] = {NULL};
        for (int k = 0; k < 3 && (n & 1); k++)
            d[k] = open_diode(tube, (enum crt_photodiode_kind)k, 0.5, 0.5, 1.5);
        assert_true(crt_film_init(&film[n], tube, &err));
        crt_film_open(tube, &film[n], MS, 30 * MS);
        if (n & 2)
            field(tube, &r, 0, 0);
        else
            draw(tube, &seed, 0, 100, 4);
        crt_tube_advance(tube, 5 * MS);
        for (int k = 0; k < 3 && (n & 1); k++)
            assert_true(crt_photodiode_luminance(d[k], 3 * MS) > 0);
        crt_tube_advance(tube, 40 * MS);
        assert_true(film[n].complete);
        for (int k = 0; k < 3; k++)
            crt_photodiode_close(d[k]);
        crt_tube_destroy(tube);
    }
    for (int n = 0; n < 4; n += 2) {
        size_t bytes = 64 * 48 * sizeof(float);
        assert_memory_equal(film[n].light[0], film[n + 1].light[0], bytes);
        crt_film_free(&film[n]);
        crt_film_free(&film[n + 1]);
    }
    unpaint(&r);
}

static void nonsense_is_refused(void **state)
{
    (void)state;
    const double w[] = {1}, tau[] = {1};
    struct crt_phosphor p = model_phosphor(1, w, tau);
    struct crt_tube_row row = model_row(0.25, 0.1);
    struct crt_tube *tube = vector_tube(&row, &p, 8, 8);
    static const struct crt_photodiode_desc bad[] = {{CRT_DIODE_POINT, NAN, 0, 0},
                                                     {CRT_DIODE_POINT, 0, 1e300, 0},
                                                     {CRT_DIODE_DISC, 0, 0, 0},
                                                     {CRT_DIODE_DISC, 0, 0, -1},
                                                     {CRT_DIODE_DISC, 0, 0, NAN}};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        struct crt_error err = {""};
        assert_null(crt_photodiode_open(tube, &bad[i], &err));
        assert_true(strlen(err.text) > 10);
    }
    crt_tube_destroy(tube);
}

/* Lines: what was there, and the one that is being drawn. */
static void opened_within_a_field(void **state)
{
    (void)state;
    struct crt_phosphor p = line_model_p22();
    struct crt_tube_row row = line_model_colour_row(40, 30, 0.6);
    static const enum crt_photodiode_kind kind[] = {CRT_DIODE_POINT, CRT_DIODE_DISC,
                                                    CRT_DIODE_SCREEN};
    uint32_t seed = 12;
    struct raster r = small_raster(3, &seed);
    for (int n = 0; n < 3; n++) {
        struct crt_tube *tube = raster_tube(&row, &p, (struct crt_knobs){0, 1, 0}, 192, 152, 0, 0);
        struct crt_photodiode *all = open_diode(tube, kind[n], 3, 2, 2);
        for (uint64_t k = 0; k < 8; k++)
            field(tube, &r, 0, k * 16666 * US);
        /* In line 41 of the field before the last, which goes through the place. */
        uint64_t now = 6 * 16666 * US + 41 * r.line + (uint64_t)(23.0 / 40 * (double)r.lit);
        crt_tube_advance(tube, now);
        struct crt_photodiode *late = open_diode(tube, kind[n], 3, 2, 2);
        crt_tube_advance(tube, 130 * MS);
        double highest = 0, off = 0;
        for (uint64_t t = now; t < 130 * MS; t += t < now + MS ? US / 20 : 50 * US) {
            double want = crt_photodiode_luminance(all, t);
            highest = fmax(highest, want);
            off = fmax(off, fabs(want - crt_photodiode_luminance(late, t)));
        }
        print_message("# opened within a field, kind %d: %.2g\n", n, off / highest);
        assert_true(off < 1e-6 * highest);
        crt_photodiode_close(all);
        crt_photodiode_close(late);
        crt_tube_destroy(tube);
    }
    unpaint(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shares_sum_to_the_luminance),
        cmocka_unit_test(integrals_are_those_of_samples),
        cmocka_unit_test(opened_while_it_runs),
        cmocka_unit_test(forgetting_changes_nothing),
        cmocka_unit_test(snapshots_restart_it),
        cmocka_unit_test(cutting_time_changes_nothing),
        cmocka_unit_test(films_stay_as_they_are),
        cmocka_unit_test(nonsense_is_refused),
        cmocka_unit_test(opened_within_a_field),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
