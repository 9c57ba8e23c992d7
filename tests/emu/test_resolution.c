/* What measure says of a tube against closed forms, a slow simulation of amplifier, gun and spot, and
 * films. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "emu/resolution.h"

#define PI     3.14159265358979324
#define GROWTH 0.075 /* mm, of colour tubes, whose rows leave it out */

static struct vm_resolution of(const char *tube, const char *mode, double bandwidth)
{
    static struct crt_tube_row row;
    struct ras_timing timing;
    struct vm_resolution r;
    struct crt_error err;
    row = *crt_tube_row_find(tube);
    if (row.mask != CRT_MASK_NONE)
        row.spot_growth.value = GROWTH;
    if (bandwidth > 0)
        row.bandwidth.value = bandwidth;
    if (mode && !ras_mode_parse(mode, &timing, &err))
        fail_msg("%s", err.text);
    vm_resolution_init(&r, &row, mode ? &timing : NULL, 1);
    return r;
}

static void a_spot_is_gaussian(void **state)
{
    (void)state;
    struct vm_resolution r = of("COLOR17", "1024x768@60", 0);
    double least = 0.445 / (2 * sqrt(2 * log(1 / 0.6)));
    double sigma = sqrt(least * least + GROWTH * GROWTH);
    assert_true(fabs(r.sigma_least / least - 1) < 1e-6);
    assert_true(fabs(r.sigma[VM_CENTRE] / sigma - 1) < 1e-6);
    assert_true(fabs(r.sigma[VM_CORNER] / (1.25 * sigma) - 1) < 1e-6);
    for (double f = 0.1; f < 3; f += 0.3) {
        double want = exp(-2 * PI * PI * sigma * sigma * f * f);
        assert_true(fabs(vm_resolution_spot(&r, VM_CENTRE, f) - want) < 1e-6);
        assert_true(vm_resolution_at(&r, VM_CENTRE, VM_UP, f) ==
                    vm_resolution_spot(&r, VM_CENTRE, f));
    }
    double limit = sqrt(log(1 / VM_LEAST_MODULATION) / 2) / (PI * sigma);
    assert_true(fabs(vm_resolution_limit(&r, VM_CENTRE, VM_UP) / limit - 1) < 1e-6);
    assert_true(fabs(vm_resolution_limit(&r, VM_CORNER, VM_UP) * 1.25 / limit - 1) < 1e-6);
    /* Spots at 60 % side by side. */
    assert_true(fabs(vm_resolution_width60(r.sigma_least) - 0.445) < 1e-6);
}

static void a_perfect_amplifier_changes_nothing(void **state)
{
    (void)state;
    struct vm_resolution r = of("COLOR17", "1024x768@60", 1e4);
    /* The sine's drive has a cusp at nothing: 64 harmonics leave 1e-3 of it. */
    for (double f = 0.2; f < 2; f += 0.2)
        assert_true(fabs(vm_resolution_at(&r, VM_CENTRE, VM_ACROSS, f) -
                         vm_resolution_spot(&r, VM_CENTRE, f)) < 2e-3);
}

/* Steps a resistor and capacitor through time, then a gun, then a Gaussian, by sums. */
static double simulated(const struct vm_resolution *r, double f)
{
    enum { N = 4000, PERIODS = 12 };
    static double light[N];
    double gamma = r->row->gun_exponent.value, step = 1 / (f * r->speed_mm_s) / N; /* s */
    double rate = 2 * PI * r->row->bandwidth.value * 1e6, v = 0;
    for (int i = 0; i < N * PERIODS; i++) {
        double drive = pow((1 + cos(2 * PI * (i + 0.5) / N)) / 2, 1 / gamma);
        v = drive + (v - drive) * exp(-rate * step);
        light[i % N] = pow(v, gamma);
    }
    double low = 1e9, high = 0, mm = 1 / f / N; /* a sample */
    int reach = (int)(6 * r->sigma[VM_CENTRE] / mm);
    for (int at = 0; at < N; at += 20) {
        double sum = 0, weight = 0;
        for (int k = -reach; k <= reach; k += 5) {
            double w = exp(-0.5 * pow(k * mm / r->sigma[VM_CENTRE], 2));
            sum += w * light[((at + k) % N + N) % N];
            weight += w;
        }
        low = fmin(low, sum / weight);
        high = fmax(high, sum / weight);
    }
    return (high - low) / (high + low);
}

static void amplifier_gun_and_spot_together(void **state)
{
    (void)state;
    static const double bandwidth[] = {4.5, 2, 1};
    for (int i = 0; i < 3; i++) {
        struct vm_resolution r = of("TV12M", "525/60i", bandwidth[i]);
        for (double f = 0.2; f < 1.1; f += 0.2) {
            double want = simulated(&r, f), got = vm_resolution_at(&r, VM_CENTRE, VM_ACROSS, f);
            if (fabs(got - want) > 3e-3)
                fail_msg("%g MHz, %g lp/mm: %.4f, simulated %.4f", bandwidth[i], f, got, want);
            assert_true(got < vm_resolution_spot(&r, VM_CENTRE, f) + 2e-3);
        }
        /* What the amplifier takes is seen. */
        assert_true(vm_resolution_at(&r, VM_CENTRE, VM_ACROSS, 0.8) <
                    0.95 * vm_resolution_spot(&r, VM_CENTRE, 0.8));
    }
}

static void limits_of_mask_and_mode(void **state)
{
    (void)state;
    struct vm_resolution r = of("COLOR17", "1024x768@60", 0);
    assert_true(fabs(vm_resolution_mode_limit(&r, VM_ACROSS) - 1024 / 640.0) < 1e-9);
    assert_true(fabs(vm_resolution_mode_limit(&r, VM_UP) - 768 / 480.0) < 1e-9);
    assert_true(fabs(vm_resolution_mask_limit(r.row, VM_ACROSS) - 0.5 / (0.28 * sqrt(0.75))) <
                1e-9);
    assert_true(fabs(vm_resolution_mask_limit(r.row, VM_UP) - 0.5 / 0.14) < 1e-9);
    r = of("GRILLE17", "1280x1024@60", 0);
    assert_true(fabs(vm_resolution_mask_limit(r.row, VM_ACROSS) - 2) < 1e-9);
    assert_true(vm_resolution_mask_limit(r.row, VM_UP) == 0);
    r = of("VR17", NULL, 0);
    assert_true(vm_resolution_mask_limit(r.row, VM_ACROSS) == 0 && r.speed_mm_s == 0);
    assert_true(vm_resolution_at(&r, VM_CORNER, VM_ACROSS, 1) == vm_resolution_spot(&r, 0, 1));
    /* 2 : 1 in time is 2 : 1 in speed: 65 MHz over 1024 dots of 0.3125 mm. */
    r = of("COLOR17", "1024x768@60", 0);
    assert_true(fabs(r.speed_mm_s / (320.0 / 1024 * 65e6) - 1) < 1e-9);
}

/* The crest and the trough between lines, added up one by one. */
static void gratings_of_lines(void **state)
{
    (void)state;
    for (double f = 0.3; f < 4; f *= 1.4) {
        double sigma = 0.23, crest = 0, trough = 0;
        for (int k = -400; k <= 400; k++) {
            crest += exp(-0.5 * pow(k / f / sigma, 2));
            trough += exp(-0.5 * pow((k + 0.5) / f / sigma, 2));
        }
        double want = (crest - trough) / (crest + trough);
        assert_true(fabs(vm_resolution_lines(sigma, f) - want) < 1e-6);
    }
}

static void films_show_what_is_measured(void **state)
{
    (void)state;
    static const char *const tubes[] = {"VR17", "LAB31", "RADAR7"};
    for (int t = 0; t < 3; t++) {
        struct vm_resolution r = of(tubes[t], NULL, 0);
        for (double sigmas = 2.5; sigmas < 5.5; sigmas += 0.5) {
            double f = 1 / (sigmas * r.sigma[VM_CENTRE]), film = 0;
            struct crt_error err;
            if (!vm_resolution_on_film(&r, VM_ACROSS, f, &film, &err))
                fail_msg("%s", err.text);
            double want = vm_resolution_lines(r.sigma[VM_CENTRE], f);
            if (fabs(film - want) > 2e-3)
                fail_msg("%s, lines %g sigma apart: %.4f on film, %.4f", tubes[t], sigmas, film,
                         want);
        }
    }
}

/* Sines drawn by scan lines; without growth, as the figures know one sigma only. */
static void films_of_raster_tubes(void **state)
{
    (void)state;
    static const struct {
        const char *tube, *mode;
    } tubes[] = {{"COLOR17", "1024x768@60"}, {"SLOT14", "640x480@60"}, {"TV12M", "525/60i"}};
    for (int t = 0; t < 3; t++) {
        struct crt_tube_row row = *crt_tube_row_find(tubes[t].tube);
        struct ras_timing timing;
        struct vm_resolution r;
        struct crt_error err;
        assert_true(ras_mode_parse(tubes[t].mode, &timing, &err));
        row.spot_growth.value = 0;
        vm_resolution_init(&r, &row, &timing, 1);
        for (int d = 0; d < VM_DIRECTIONS; d++)
            for (int i = 1; i <= 4; i++) {
                double f = vm_resolution_mode_limit(&r, VM_UP) * i / 8, film = 0;
                if (!vm_resolution_on_film(&r, (enum vm_direction)d, f, &film, &err))
                    fail_msg("%s", err.text);
                double want = vm_resolution_at(&r, VM_CENTRE, (enum vm_direction)d, f);
                /* Lines that merge no more than these beat with the grating. */
                double beat = d == VM_UP ? r.dots_y / row.height.value - f : 9;
                if (fabs(film - want) > 4e-3 + vm_resolution_spot(&r, VM_CENTRE, beat))
                    fail_msg("%s, %s, %g lp/mm: %.4f on film, %.4f", tubes[t].tube,
                             d == VM_UP ? "up" : "across", f, film, want);
            }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_spot_is_gaussian),
        cmocka_unit_test(a_perfect_amplifier_changes_nothing),
        cmocka_unit_test(amplifier_gun_and_spot_together),
        cmocka_unit_test(limits_of_mask_and_mode),
        cmocka_unit_test(gratings_of_lines),
        cmocka_unit_test(films_show_what_is_measured),
        cmocka_unit_test(films_of_raster_tubes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
