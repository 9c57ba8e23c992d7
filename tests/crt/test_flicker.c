/* Flicker against worked figures, against closed forms in libm, and against waveforms that are made pulse by
 * pulse and integrated step by step. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "crt/flicker.h"

#define TWO_PI 6.283185307179586

static const double rates[] = {30, 50, 60, 75};

static const struct crt_phosphor *get(const char *name)
{
    const struct crt_phosphor *p = crt_phosphor_find(name);
    if (!p)
        fail_msg("no phosphor %s", name);
    return p;
}

static void near(const char *what, double got, double want, double tolerance)
{
    if (!(fabs(got - want) <= tolerance))
        fail_msg("%s: %.12g, not %.12g within %g", what, got, want, tolerance);
}

static struct crt_glow single(double tau_s)
{
    return (struct crt_glow){.terms = 1, .share = {1}, .tau_s = {tau_s}, .pulse = 1};
}

/* ---- figures worked out elsewhere ---------------------------------------------------------------- */

/* Rounded as they are given. */
static void worked_rows_at_60_hz(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        double c1, c1_within, pf, pf_within, fi, fi_within;
    } rows[] = {
        {"P31", 1.19, .005, 99, .5, .50, .005}, {"P4", 1.41, .005, 99.6, .05, .59, .005},
        {"P1", .445, .0005, 61, .5, .17, .005}, {"P43", 1.96, .005, 100, .5, .86, .005},
        {"P53", 1.31, .005, 99, .5, .51, .005}, {"P39", .081, .0005, 12.7, .05, .032, .0005},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct crt_glow g = crt_glow_of(get(rows[i].name));
        near(rows[i].name, crt_glow_harmonic(&g, 60, 1), rows[i].c1, rows[i].c1_within);
        near(rows[i].name, crt_glow_percent_flicker(&g, 60), rows[i].pf, rows[i].pf_within);
        near(rows[i].name, crt_glow_flicker_index(&g, 60), rows[i].fi, rows[i].fi_within);
    }
}

static void worked_fusion_frequencies(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        double hz;
    } rows[] = {{"P4", 71}, {"P31", 69.5}, {"P1", 61}, {"P39", 49}};
    struct crt_viewer viewer = {1, 3};
    assert_float_equal(crt_fields_deg[1], 30, 0);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct crt_glow g = crt_glow_of(get(rows[i].name));
        near(rows[i].name, crt_cff(&viewer, 100, &g), rows[i].hz, 0.5);
    }
}

/* ---- one exponential ------------------------------------------------------------------------------ */

static void one_exponential_has_closed_forms(void **state)
{
    (void)state;
    for (double x = 1e-3; x < 500; x *= 1.7) {
        double hz = 60, tau = 1 / (hz * x), a = -1 / expm1(-x);
        struct crt_glow g = single(tau);
        near("percent", crt_glow_percent_flicker(&g, hz), 100 * tanh(x / 2), 1e-10);
        near("index", crt_glow_flicker_index(&g, hz), a - 1 / x - log(x * a) / x, 1e-9);
        for (int n = 1; n < 6; n++)
            near("harmonic", crt_glow_harmonic(&g, hz, n), 2 / hypot(1, TWO_PI * n / x), 1e-13);
    }
}

/* ---- every phosphor, by brute force --------------------------------------------------------------- */

#define SAMPLES 6000

/* Each term after so many pulses that it has settled, each pulse adding 1/tau. */
static void pulse_until_steady(const struct crt_phosphor *p, double period, double *rate)
{
    for (int k = 0; k < p->terms; k++) {
        double decay = exp(-period / p->term[k].tau_s), sum = 0;
        for (long i = 0; i < 40 + (long)(40 * p->term[k].tau_s / period); i++)
            sum = sum * decay + 1;
        rate[k] = p->term[k].w / p->term[k].tau_s * sum;
    }
}

struct wave {
    double mean, most, least, above, c[4];
};

/* Simpson over t = period·u⁸, which has its samples where the light falls fast. */
static struct wave integrate(const struct crt_phosphor *p, double period)
{
    static double light[SAMPLES + 1], t[SAMPLES + 1], dt[SAMPLES + 1];
    double rate[CRT_MAX_TERMS], re[4] = {0}, im[4] = {0};
    struct wave w = {0};
    pulse_until_steady(p, period, rate);
    for (int i = 0; i <= SAMPLES; i++) {
        double u = (double)i / SAMPLES, weight = i == 0 || i == SAMPLES ? 1 : i % 2 ? 4 : 2;
        t[i] = period * pow(u, 8);
        dt[i] = 8 * period * pow(u, 7) / SAMPLES * weight / 3;
        light[i] = 0;
        for (int k = 0; k < p->terms; k++)
            light[i] += rate[k] * exp(-t[i] / p->term[k].tau_s);
        w.mean += light[i] * dt[i] / period;
    }
    for (int i = 0; i <= SAMPLES; i++) {
        w.above += fmax(light[i] - w.mean, 0) * dt[i] / (w.mean * period);
        for (int n = 0; n < 4; n++) {
            re[n] += light[i] * cos(TWO_PI * (n + 1) * t[i] / period) * dt[i];
            im[n] += light[i] * sin(TWO_PI * (n + 1) * t[i] / period) * dt[i];
        }
    }
    for (int n = 0; n < 4; n++)
        w.c[n] = 2 * hypot(re[n], im[n]) / (w.mean * period);
    w.most = light[0];
    w.least = light[SAMPLES];
    return w;
}

static void every_phosphor_as_its_waveform(void **state)
{
    (void)state;
    size_t count;
    const struct crt_phosphor *p = crt_phosphors(&count);
    for (size_t i = 0; i < count; i++)
        for (size_t r = 0; r < sizeof rates / sizeof *rates; r++) {
            struct wave w = integrate(&p[i], 1 / rates[r]);
            struct crt_glow g = crt_glow_of(&p[i]);
            double pf = 100 * (w.most - w.least) / (w.most + w.least);
            near(p[i].name, w.mean / rates[r], 1, 1e-7); /* energy 1 a pulse */
            near(p[i].name, crt_glow_percent_flicker(&g, rates[r]), pf, 1e-7 * pf);
            near(p[i].name, crt_glow_flicker_index(&g, rates[r]), w.above, 1e-4 * w.above);
            for (int n = 0; n < 4; n++)
                near(p[i].name, crt_glow_harmonic(&g, rates[r], n + 1), w.c[n], 1e-6);
            assert_true(crt_glow_harmonic(&g, rates[r], 1) == crt_phosphor_c1(&p[i], rates[r]));
        }
}

/* ---- limits and properties ------------------------------------------------------------------------ */

static void slow_and_fast_rates(void **state)
{
    (void)state;
    size_t count;
    const struct crt_phosphor *p = crt_phosphors(&count);
    for (size_t i = 0; i < count; i++) {
        struct crt_glow g = crt_glow_of(&p[i]);
        near(p[i].name, crt_glow_harmonic(&g, 1e-5, 1), 2, 1e-3);
        near(p[i].name, crt_glow_percent_flicker(&g, 1e-5), 100, 1e-9);
        near(p[i].name, crt_glow_flicker_index(&g, 1e-5), 1, 2e-3);
        near(p[i].name, crt_glow_harmonic(&g, 1e12, 1), 0, 1e-3);
        near(p[i].name, crt_glow_percent_flicker(&g, 1e12), 0, 1e-1);
        near(p[i].name, crt_glow_flicker_index(&g, 1e12), 0, 1e-3);
        double before[3] = {2, 100, 1};
        for (double hz = 1e-5; hz < 1e9; hz *= 3) {
            double now[3] = {crt_glow_harmonic(&g, hz, 1), crt_glow_percent_flicker(&g, hz),
                             crt_glow_flicker_index(&g, hz)};
            for (int k = 0; k < 3; k++) {
                if (!(now[k] <= before[k] + 1e-12 && now[k] >= -1e-12))
                    fail_msg("%s: figure %d rises from %.15g to %.15g at %g Hz", p[i].name, k,
                             before[k], now[k], hz);
                before[k] = now[k];
            }
        }
    }
}

static double uniform(uint64_t *seed, double low, double high)
{
    *seed = *seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return low + (high - low) * (double)(*seed >> 11) / 9007199254740992.0;
}

/* The published line, m + n·ln(trolands of the fundamental), meets the frequency there. */
static void fusion_is_where_the_line_meets_the_rate(void **state)
{
    (void)state;
    static const double m[] = {14.6, 13.83, 8.32, 6.79}, n[] = {7.00, 8.31, 9.73, 10.03};
    size_t count;
    const struct crt_phosphor *p = crt_phosphors(&count);
    uint64_t seed = 7;
    for (int i = 0; i < 3000; i++) {
        struct crt_glow g = crt_glow_of(&p[(size_t)uniform(&seed, 0, (double)count)]);
        struct crt_viewer v = {(int)uniform(&seed, 0, 4), uniform(&seed, 1.5, 8)};
        double cd_m2 = exp(uniform(&seed, log(0.5), log(5000)));
        double hz = crt_cff(&v, cd_m2, &g);
        if (hz == 0)
            continue;
        double trolands = cd_m2 * 3.141592653589793 / 4 * v.pupil_mm * v.pupil_mm;
        double line = m[v.field] + n[v.field] * log(trolands * crt_glow_harmonic(&g, hz, 1));
        near("fusion", hz, line, 1e-9 * hz);
        /* What is seen and the limit of luminance say the same, on both sides. */
        double other = uniform(&seed, 5, 120), limit = crt_flicker_luminance(&v, other, &g);
        double c = crt_glow_harmonic(&g, other, 1);
        assert_true(crt_flickers(&v, cd_m2, other, c) == (other < hz));
        assert_true((cd_m2 > limit) == (other < hz));
        near("limit", crt_cff(&v, limit, &g), other, 1e-7 * other);
        assert_true(crt_cff(&v, cd_m2 * 1.01, &g) > hz);
    }
}

static void a_softer_excitation_flickers_less(void **state)
{
    (void)state;
    struct crt_viewer v = {1, 3};
    struct crt_glow g = crt_glow_of(get("P31")), soft = g;
    soft.pulse = 0.25;
    near("fundamental", crt_glow_harmonic(&soft, 60, 1), crt_glow_harmonic(&g, 60, 1) / 4, 1e-15);
    assert_true(crt_glow_harmonic(&soft, 60, 2) == crt_glow_harmonic(&g, 60, 2));
    assert_true(crt_cff(&v, 100, &soft) < crt_cff(&v, 100, &g) - 5);
    soft.pulse = 0;
    assert_true(crt_cff(&v, 100, &soft) == 0);
    assert_true(isinf(crt_flicker_luminance(&v, 60, &soft)));
    assert_false(crt_flickers(&v, 100, 60, 0));
}

static void what_does_not_apply_is_not_a_number(void **state)
{
    (void)state;
    struct crt_glow g = crt_glow_of(get("P31"));
    struct crt_viewer v = {1, 3}, below = {-1, 3}, above = {CRT_FIELDS, 3}, blind = {1, 0};
    assert_true(crt_cff(&v, 0, &g) == 0 && crt_cff(&v, -5, &g) == 0 && crt_cff(&v, 1e-4, &g) == 0);
    assert_true(isnan(crt_cff(&v, NAN, &g)) && isnan(crt_cff(&below, 100, &g)) &&
                isnan(crt_cff(&above, 100, &g)) && isnan(crt_cff(&blind, 100, &g)));
    assert_true(isinf(crt_cff(&v, INFINITY, &g)));
    assert_true(isnan(crt_flicker_luminance(&v, 0, &g)) &&
                isnan(crt_flicker_luminance(&v, NAN, &g)) &&
                isnan(crt_flicker_luminance(&above, 60, &g)));
    assert_false(crt_flickers(&above, 100, 60, 1) || crt_flickers(&v, NAN, 60, 1) ||
                 crt_flickers(&v, 100, NAN, 1) || crt_flickers(&v, 100, 60, NAN) ||
                 crt_flickers(&v, 0, 60, 1) || crt_flickers(&v, 100, 0, 1));
    static const double bad[] = {0, -60, NAN, INFINITY};
    for (int i = 0; i < 4; i++) {
        assert_true(isnan(crt_glow_percent_flicker(&g, bad[i])));
        assert_true(isnan(crt_glow_flicker_index(&g, bad[i])));
        assert_true(isnan(crt_svm(bad[i], (double[]){1}, 1)));
    }
}

/* ---- laws and standards --------------------------------------------------------------------------- */

static void ferry_and_porter_is_a_line(void **state)
{
    (void)state;
    near("trolands", crt_trolands(100, 3), 706.858347, 1e-6);
    for (double cd = 0.5; cd < 2000; cd *= 3)
        near("a decade", crt_cff_ferry_porter(10 * cd, 3) - crt_cff_ferry_porter(cd, 3), 10, 1e-9);
    near("as many trolands", crt_cff_ferry_porter(100, 3), crt_cff_ferry_porter(25, 6), 1e-9);
    assert_true(crt_cff_ferry_porter(0, 3) == 0 && crt_cff_ferry_porter(-1, 3) == 0);
    assert_true(isnan(crt_cff_ferry_porter(NAN, 3)) && isnan(crt_cff_ferry_porter(100, 0)));
    /* The centre of the eye ends at 50 … 55 Hz where the law ends, at 10⁴ trolands. */
    double end = crt_cff_ferry_porter(1e4 / crt_trolands(1, 3), 3);
    assert_true(end > 50 && end < 55);
}

static void classes_of_ieee_1789(void **state)
{
    (void)state;
    static const struct {
        double hz, percent;
        enum crt_ieee1789 is;
    } rows[] = {
        {60, .599, CRT_IEEE_NO_EFFECT},  {60, .601, CRT_IEEE_LOW_RISK},
        {60, 1.499, CRT_IEEE_LOW_RISK},  {60, 1.501, CRT_IEEE_ABOVE},
        {89.9, 2.24, CRT_IEEE_LOW_RISK}, {89.9, 2.26, CRT_IEEE_ABOVE},
        {90, 2.98, CRT_IEEE_NO_EFFECT},  {90, 7.19, CRT_IEEE_LOW_RISK},
        {90, 7.21, CRT_IEEE_ABOVE},      {1249, 99.9, CRT_IEEE_LOW_RISK},
        {1249, 41, CRT_IEEE_NO_EFFECT},  {1251, 100, CRT_IEEE_LOW_RISK},
        {2950, 99, CRT_IEEE_LOW_RISK},   {3001, 100, CRT_IEEE_NO_EFFECT},
        {0, 0, CRT_IEEE_ABOVE},          {NAN, 1, CRT_IEEE_ABOVE},
        {100, NAN, CRT_IEEE_ABOVE},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (crt_ieee1789(rows[i].hz, rows[i].percent) != rows[i].is)
            fail_msg("%g Hz, %g %%: %s", rows[i].hz, rows[i].percent,
                     crt_ieee1789_name(crt_ieee1789(rows[i].hz, rows[i].percent)));
    assert_string_equal(crt_ieee1789_name(CRT_IEEE_LOW_RISK), "low risk");
}

static double threshold(double hz)
{
    return 1 / (1 + exp(-0.00518 * (hz - 306.6))) + 20 * exp(-hz / 10);
}

static void stroboscopic_visibility(void **state)
{
    (void)state;
    /* A sine at its threshold has 1; the threshold at 100 Hz is about a quarter. */
    for (double hz = 80; hz <= 2000; hz *= 1.1)
        near("threshold", crt_svm(hz, (double[]){threshold(hz)}, 1), 1, 1e-12);
    near("a full sine at 100 Hz", crt_svm(100, (double[]){1}, 1), 3.9, 0.05);
    double c[30], sum = 0;
    for (int i = 0; i < 30; i++)
        c[i] = 1.5 / (i + 1);
    for (int i = 0; (i + 1) * 120 <= 2000; i++)
        sum += pow(c[i] / threshold((i + 1) * 120), 3.7);
    near("harmonics up to 2 kHz", crt_svm(120, c, 30), pow(sum, 1 / 3.7), 1e-10);
    near("no harmonics", crt_svm(120, c, 0), 0, 0);
    assert_true(isnan(crt_svm(79.9, c, 30)) && isnan(crt_svm(2000.1, c, 30)));
    assert_false(isnan(crt_svm(80, c, 30)) || isnan(crt_svm(2000, c, 30)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(worked_rows_at_60_hz),
        cmocka_unit_test(worked_fusion_frequencies),
        cmocka_unit_test(one_exponential_has_closed_forms),
        cmocka_unit_test(every_phosphor_as_its_waveform),
        cmocka_unit_test(slow_and_fast_rates),
        cmocka_unit_test(fusion_is_where_the_line_meets_the_rate),
        cmocka_unit_test(a_softer_excitation_flickers_less),
        cmocka_unit_test(what_does_not_apply_is_not_a_number),
        cmocka_unit_test(ferry_and_porter_is_a_line),
        cmocka_unit_test(classes_of_ieee_1789),
        cmocka_unit_test(stroboscopic_visibility),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
