/* What photodiodes read: points against the tube's own probe, discs against sums over points and rings, discs and the
 * screen against energy. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crt/spot.h"
#include "tests/support/diode_rig.h"
#include "tests/support/line_model.h"

#define PI 3.14159265358979324

/* ---- against the probe ------------------------------------------------------------------------------- */

static void point_is_as_the_probe(void **state)
{
    (void)state;
    const double w[] = {0.5, 0.3, 0.2}, tau[] = {0.00007, 0.12, 3};
    struct crt_phosphor p = model_phosphor(3, w, tau);
    struct crt_tube_row row = model_row(0.25, 0.1);
    struct crt_tube *tube = vector_tube(&row, &p, 80, 80);
    struct crt_photodiode *d = open_diode(tube, CRT_DIODE_POINT, 0.3, -0.2, 0);
    uint32_t seed = 7;
    double highest = 0, off = 0;
    uint64_t end = draw(tube, &seed, 0, 300, 4);
    assert_true(end < 16 * MS);
    crt_tube_advance(tube, 16 * MS);
    for (int i = 0; i < 4000; i++) {
        double want[CRT_MAX_COLOURS], got[CRT_MAX_COLOURS];
        uint64_t t = (uint64_t)i * (end / 3500);
        crt_tube_probe(tube, 0.3, -0.2, t, want);
        crt_photodiode_read(d, t, got);
        highest = fmax(highest, want[0]);
        off = fmax(off, fabs(want[0] - got[0]) / fmax(want[0], 1e-3 * highest));
    }
    print_message("# against the probe: %.2g\n", off);
    assert_true(highest > 0 && off < 1e-5);
    crt_photodiode_close(d);
    crt_tube_destroy(tube);
}

/* A tube whose colours are voltages: other spots, places and shares of the light. */
static void levels_are_as_the_probe(void **state)
{
    (void)state;
    const struct crt_tube_row *row = crt_tube_row_find("PENET17");
    const struct crt_phosphor *p = crt_phosphor_find(row->phosphor);
    struct crt_tube *tube = vector_tube(row, p, 8, 8);
    struct crt_photodiode *d = open_diode(tube, CRT_DIODE_POINT, 60, -50, 0);
    uint32_t seed = 17;
    uint64_t t = 0;
    for (int i = 0; i < 60; i++) {
        struct crt_stroke s = {.t0 = t, .t1 = t + 20 * US, .x0 = 58, .y0 = -50, .drive = 0.9F};
        s.x1 = (float)model_uniform(&seed, 59, 65);
        s.y1 = (float)model_uniform(&seed, -51, -49);
        s.level = (uint32_t)i % 5;
        crt_tube_stroke(tube, &s);
        t = s.t1 + US;
    }
    crt_tube_advance(tube, t);
    double highest = 0, off = 0;
    for (uint64_t at = 0; at <= t; at += t / 997) {
        double want[CRT_MAX_COLOURS], got[CRT_MAX_COLOURS];
        crt_tube_probe(tube, 60, -50, at, want);
        crt_photodiode_read(d, at, got);
        for (int c = 0; c < 2; c++) {
            highest = fmax(highest, want[c]);
            off = fmax(off, fabs(want[c] - got[c]));
        }
    }
    assert_true(highest > 0 && off < 1e-7 * highest);
    crt_photodiode_close(d);
    crt_tube_destroy(tube);
}

/* ---- scan lines ------------------------------------------------------------------------------------- */

/* At many instants, most of them while lines near the place are drawn. */
static double lines_off_the_probe(struct crt_tube *tube, struct crt_photodiode *d, double x,
                                  double y, uint64_t until, uint32_t *seed)
{
    double highest = 0, off = 0;
    size_t count;
    const struct crt_deposit *at = crt_photodiode_deposits(d, &count);
    assert_true(count > 4);
    for (int i = 0; i < 30; i++) {
        double want[CRT_MAX_COLOURS], got[CRT_MAX_COLOURS];
        uint64_t t = model_random(seed) % until;
        if (i % 4) {
            const struct crt_deposit *near = &at[model_random(seed) % count];
            double when = near->mean_t_s * 1e12 + model_uniform(seed, -1, 1) * 4e5;
            t = near->t0 + (uint64_t)fmax(when, 0);
        }
        crt_tube_probe(tube, x, y, t, want);
        crt_photodiode_read(d, t, got);
        for (int c = 0; c < CRT_MAX_COLOURS; c++) {
            highest = fmax(highest, want[c]);
            off = fmax(off, fabs(want[c] - got[c]));
        }
    }
    return off / highest;
}

static void lines_are_as_the_probe(void **state)
{
    (void)state;
    const double w[] = {0.6, 0.4}, tau[] = {0.0005, 1};
    struct crt_phosphor one = model_phosphor(2, w, tau), three = line_model_p22();
    uint32_t seed = 3;
    for (int n = 0; n < 4; n++) {
        bool colour = n & 1;
        struct crt_tube_row row = colour ? line_model_colour_row(40, 30, 0.4)
                                         : line_model_row(40, 30, n == 2 ? 0.2 : 0.5);
        row.spot_growth.value = n >= 2 ? 0.15 : 0;
        row.spot_exponent.value = n == 2 ? 0.5 : 0.6;
        row.spot_edge.value = 1.4;
        row.converge.value = colour ? 0.1 : 0;
        row.converge_edge.value = colour ? 0.2 : 0;
        struct crt_knobs knobs = {n == 3 ? 0.05 : 0, n == 3 ? 1.3 : 1, n == 3 ? 0.4 : 0};
        double x = 7.3 - 2 * n, y = -5.1;
        struct crt_tube *tube = raster_tube(&row, colour ? &three : &one, knobs, 64, 64, x, y);
        struct crt_photodiode *d = open_diode(tube, CRT_DIODE_POINT, x, y, 0);
        struct raster r = small_raster(colour ? 3 : 1, &seed);
        uint64_t end = field(tube, &r, 0, 0);
        crt_tube_advance(tube, end);
        double off = lines_off_the_probe(tube, d, x, y, end, &seed);
        print_message("# raster %d against the probe: %.2g of the brightest\n", n, off);
        assert_true(off < 2e-4);
        crt_photodiode_close(d);
        crt_tube_destroy(tube);
        unpaint(&r);
    }
}

/* ---- discs and the screen ------------------------------------------------------------------------ */

/* Mean of points over a disc, in rings. */
static double mean_of_points(struct crt_tube *tube, double x, double y, double radius, int rings,
                             uint64_t t)
{
    double sum = 0;
    int count = 0;
    for (int i = 0; i < rings; i++) {
        double r = radius * (i + 0.5) / rings; /* 2i + 1 points: equal areas */
        for (int n = 0; n < 3 * (2 * i + 1); n++, count++) {
            double a = 2 * PI * (n + 0.5 * (i & 1)) / (3 * (2 * i + 1)), cd[CRT_MAX_COLOURS];
            crt_tube_probe(tube, x + r * cos(a), y + r * sin(a), t, cd);
            sum += cd[0] + cd[1] + cd[2];
        }
    }
    return sum / count;
}

static void disc_is_the_mean_of_points(void **state)
{
    (void)state;
    const double w[] = {0.7, 0.3}, tau[] = {0.02, 2};
    struct crt_phosphor p = model_phosphor(2, w, tau);
    struct crt_tube_row row = model_row(0.25, 0.1);
    static const double radius[] = {0.05, 0.3, 1.2, 3};
    for (int n = 0; n < 4; n++) {
        struct crt_tube *tube = vector_tube(&row, &p, 8, 8);
        struct crt_photodiode *d = open_diode(tube, CRT_DIODE_DISC, 0.4, 0.3, 2 * radius[n]);
        uint32_t seed = 11;
        uint64_t end = draw(tube, &seed, 0, 60, 4);
        double highest = 0, off = 0;
        crt_tube_advance(tube, end);
        for (int i = 1; i <= 3; i++) {
            uint64_t t = end / 3 * (uint64_t)i;
            double want = mean_of_points(tube, 0.4, 0.3, radius[n], 8 + 10 * n, t);
            highest = fmax(highest, want);
            off = fmax(off, fabs(want - crt_photodiode_luminance(d, t)));
        }
        print_message("# disc of %.2f mm against points: %.2g\n", 2 * radius[n], off / highest);
        assert_true(off < 2e-3 * highest); /* the points' own error */
        crt_photodiode_close(d);
        crt_tube_destroy(tube);
    }
}

/* Mean over a disc of a resting spot, as an integral over rings; on a ring over angles. */
static double mean_of_rings(double radius, double sigma, double distance)
{
    double sum = 0;
    const int rings = 1500, angles = 100;
    for (int i = 0; i < rings; i++) {
        double r = radius * (i + 0.5) / rings, off = r - distance, around = 0;
        if (fabs(off) > 7 * sigma)
            continue;
        for (int n = 0; n < angles; n++)
            around += exp(-r * distance / (sigma * sigma) * (1 - cos(PI * (n + 0.5) / angles)));
        sum += r * exp(-off * off / (2 * sigma * sigma)) * around / angles;
    }
    return sum * radius / rings / (sigma * sigma) / (PI * radius * radius);
}

static void disc_sees_of_a_spot_what_falls_on_it(void **state)
{
    (void)state;
    const double w[] = {1}, tau[] = {1};
    struct crt_phosphor p = model_phosphor(1, w, tau);
    struct crt_knobs neutral = {0, 1, 0};
    static const double radius[] = {0.02, 0.25, 0.8, 4}, sigma[] = {0.21, 0.25};
    double worst = 0;
    for (int n = 0; n < 8; n++) {
        struct crt_tube_row row = model_row(sigma[n & 1], 0);
        struct crt_tube *tube = vector_tube(&row, &p, 8, 8);
        struct crt_photodiode *d = open_diode(tube, CRT_DIODE_DISC, -1, 2, 2 * radius[n / 2]);
        struct crt_spot spot = crt_spot_at(&row, &neutral, 1);
        for (int i = 0; i < 6; i++) {
            double off = fmax(0, radius[n / 2] + (i - 3) * 0.9 * sigma[n & 1]);
            struct crt_stroke s = {.t0 = (uint64_t)i * US, .y0 = 2, .y1 = 2, .drive = 1};
            s.t1 = s.t0 + US;
            s.x0 = s.x1 = (float)(-1 + off);
            crt_tube_stroke(tube, &s);
        }
        crt_tube_advance(tube, MS);
        size_t count;
        const struct crt_deposit *at = crt_photodiode_deposits(d, &count);
        assert_int_equal(count, 6);
        double most = mean_of_rings(radius[n / 2], spot.sigma_mm, 0);
        for (int i = 0; i < 6; i++) {
            double off =
                (double)(float)(-1 + fmax(0, radius[n / 2] + (i - 3) * 0.9 * sigma[n & 1])) + 1;
            double want = mean_of_rings(radius[n / 2], spot.sigma_mm, off);
            worst = fmax(worst, fabs(at[i].fluence[0] / (spot.power * 1e-6) - want) / most);
        }
        crt_photodiode_close(d);
        crt_tube_destroy(tube);
    }
    print_message("# discs of spots: %.2g of the most\n", worst);
    assert_true(worst < 2e-5);
}

/* A disc that has everything within: energy over its area, of strokes and of lines. */
static void wide_disc_has_all_the_energy(void **state)
{
    (void)state;
    const double w[] = {1}, tau[] = {1};
    struct crt_phosphor p = model_phosphor(1, w, tau);
    struct crt_tube_row row = model_row(0.25, 0);
    struct crt_knobs neutral = {0, 1, 0};
    struct crt_tube *tube = vector_tube(&row, &p, 8, 8);
    struct crt_photodiode *d = open_diode(tube, CRT_DIODE_DISC, 1, 0, 40);
    struct crt_stroke s = {.t1 = 30 * US, .x0 = -5, .y0 = 2, .x1 = 6, .y1 = -3, .drive = 0.8F};
    size_t count;
    crt_tube_stroke(tube, &s);
    crt_tube_advance(tube, MS);
    const struct crt_deposit *at = crt_photodiode_deposits(d, &count);
    double energy = crt_spot_at(&row, &neutral, (double)0.8F).power * 30e-6;
    assert_int_equal(count, 1);
    assert_close(at->fluence[0] * PI * 400 / energy, 1, 1e-6);
    assert_close(at->mean_t_s, 15e-6, 1e-11);
    crt_photodiode_close(d);
    crt_tube_destroy(tube);
}

static void screen_has_all_the_energy(void **state)
{
    (void)state;
    const double w[] = {0.4, 0.6}, tau[] = {0.01, 5};
    struct crt_phosphor p = model_phosphor(2, w, tau);
    struct crt_tube_row row = model_row(0.25, 0.1);
    row.width.value = 80;
    row.height.value = 60;
    struct crt_knobs neutral = {0, 1, 0};
    struct crt_tube *tube = vector_tube(&row, &p, 8, 8);
    struct crt_photodiode *d = open_diode(tube, CRT_DIODE_SCREEN, 0, 0, 0);
    struct crt_stroke s = {.t0 = 2 * MS, .t1 = 2 * MS + 40 * US, .x1 = 30, .drive = 0.7F};
    double rate = crt_spot_at(&row, &neutral, (double)0.7F).power / 4800, got[CRT_MAX_COLOURS];
    crt_tube_stroke(tube, &s);
    crt_tube_advance(tube, 100 * MS);
    crt_photodiode_gather(d, 0, 100 * MS, got);
    double left = rate * 40e-6 * 0.6 * exp(-(98 - 0.02) / 5);
    assert_close(got[0], rate * 40e-6 - left, 1e-9 * rate * 40e-6);
    /* While it is drawn: 20 us of it. */
    double want = rate * (0.4 * -expm1(-2.0) + 0.6 * -expm1(-0.004));
    assert_close(crt_photodiode_luminance(d, 2 * MS + 20 * US), want, 1e-9 * want);
    crt_photodiode_close(d);
    crt_tube_destroy(tube);
}

/* Energy of a line on the whole screen, and on a disc around all of it, against the slow model's current. */
static void screen_has_all_of_a_line(void **state)
{
    (void)state;
    uint32_t seed = 5;
    struct crt_phosphor p = line_model_p22();
    struct crt_tube_row row = line_model_colour_row(40, 30, 0.4);
    for (int n = 0; n < 2; n++) {
        struct crt_knobs knobs = {n ? 0.04 : 0, n ? 1.2 : 1, 0};
        struct line_model model = {&row, &p, knobs};
        struct crt_tube *tube = raster_tube(&row, &p, knobs, 8, 8, 0, 0);
        struct crt_photodiode *d[2] = {open_diode(tube, CRT_DIODE_SCREEN, 0, 0, 0),
                                       open_diode(tube, CRT_DIODE_DISC, 0, 0, 100)};
        struct raster r = small_raster(3, &seed);
        struct crt_scan_line l = line_of(&r, 40, US);
        crt_tube_scan_line(tube, &l);
        crt_tube_advance(tube, MS);
        size_t count[2];
        const struct crt_deposit *screen = crt_photodiode_deposits(d[0], &count[0]);
        const struct crt_deposit *disc = crt_photodiode_deposits(d[1], &count[1]);
        assert_true(count[0] == 1 && count[1] == 1);
        for (int c = 0; c < 3; c++) {
            double tau = 1 / (2 * PI * row.bandwidth.value * 1e6), v = knobs.brightness, sum = 0;
            for (int i = 0; i < 128 * 400; i++) { /* the amplifier in small steps */
                double to =
                    knobs.contrast * r.drive[c][40 * 128 + i / 400] / 255 + knobs.brightness;
                double step = (double)r.lit * 1e-12 / (128 * 400);
                double there = to + (v - to) * exp(-step / 2 / tau);
                sum += pow(fmin(fmax(there, 0), 1), 2.5) * step;
                v = to + (v - to) * exp(-step / tau);
            }
            double share = 0;
            for (int k = 0; k < p.terms; k++)
                share += p.term[k].colour == c ? p.term[k].w : 0;
            double want = sum * line_model_power(&model, c) * share;
            assert_close(screen->fluence[c] * 1200 / want, 1, 1e-4);
            assert_close(disc->fluence[c] * PI * 2500 / want, 1, 1e-4);
        }
        for (int i = 0; i < 2; i++)
            crt_photodiode_close(d[i]);
        crt_tube_destroy(tube);
        unpaint(&r);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(point_is_as_the_probe),
        cmocka_unit_test(levels_are_as_the_probe),
        cmocka_unit_test(lines_are_as_the_probe),
        cmocka_unit_test(disc_is_the_mean_of_points),
        cmocka_unit_test(disc_sees_of_a_spot_what_falls_on_it),
        cmocka_unit_test(wide_disc_has_all_the_energy),
        cmocka_unit_test(screen_has_all_the_energy),
        cmocka_unit_test(screen_has_all_of_a_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
