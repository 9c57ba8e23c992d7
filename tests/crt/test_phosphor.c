/* Phosphor rows against the figures they say they were made from, and flicker from closed forms. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <complex.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "crt/phosphor.h"

static const struct crt_phosphor *get(const char *name)
{
    const struct crt_phosphor *p = crt_phosphor_find(name);
    if (!p)
        fail_msg("no phosphor %s", name);
    return p;
}

static void every_listed_phosphor_is_there(void **state)
{
    (void)state;
    const char *names[] = {"P1",  "P2",  "P3",  "P4",  "P7",  "P11",  "P12",  "P15",
                           "P19", "P20", "P24", "P28", "P31", "P22R", "P22G", "P22B",
                           "P22", "P33", "P38", "P39", "P40", "P43",  "P45",  "P46",
                           "P47", "P49", "P53", "P55", "P56", "P134"};
    size_t n;
    const struct crt_phosphor *p = crt_phosphors(&n);
    assert_int_equal(n, sizeof names / sizeof names[0]);
    for (size_t i = 0; i < n; i++)
        assert_string_equal(get(names[i])->name, names[i]);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < i; j++)
            assert_string_not_equal(p[i].name, p[j].name);
    assert_ptr_equal(crt_phosphor_find("p22g"), get("P22G"));
    assert_null(crt_phosphor_find("P"));
    assert_null(crt_phosphor_find("P311"));
    assert_null(crt_phosphor_find(""));
}

static void rows_are_well_formed(void **state)
{
    (void)state;
    size_t n;
    const struct crt_phosphor *p = crt_phosphors(&n);
    for (size_t i = 0; i < n; i++) {
        double sum = 0, share[CRT_MAX_COLOURS] = {0};
        assert_in_range(p[i].terms, 1, CRT_MAX_TERMS);
        assert_in_range(p[i].colours, 1, CRT_MAX_COLOURS);
        for (int k = 0; k < p[i].terms; k++) {
            assert_true(p[i].term[k].w > 0 && p[i].term[k].tau_s > 0);
            assert_in_range(p[i].term[k].colour, 0, p[i].colours - 1);
            sum += p[i].term[k].w;
            share[p[i].term[k].colour] += p[i].term[k].w;
        }
        if (fabs(sum - 1) > 1e-12)
            fail_msg("%s: shares add up to %.15f", p[i].name, sum);
        for (int c = 0; c < p[i].colours; c++) {
            assert_true(share[c] > 0);
            assert_true(p[i].colour[c].x > 0 && p[i].colour[c].y > 0);
            assert_true(p[i].colour[c].x + p[i].colour[c].y < 1);
        }
        assert_true(p[i].peak_nm >= 380 && p[i].peak_nm <= 700);
        assert_true(p[i].source[0] && p[i].note && p[i].tektronix.source && p[i].jedec.source);
        assert_true((p[i].tektronix.t10_s > 0) == (p[i].tektronix.source[0] != 0));
        assert_true((p[i].jedec.t10_s > 0) == (p[i].jedec.source[0] != 0));
    }
}

/* The light after an impulse, and when it has fallen to a fraction: stepping, no root-finding. */
static double light(const struct crt_phosphor *p, double t)
{
    double sum = 0;
    for (int k = 0; k < p->terms; k++)
        sum += p->term[k].w / p->term[k].tau_s * exp(-t / p->term[k].tau_s);
    return sum;
}

static double stepped_decay_time(const struct crt_phosphor *p, double fraction)
{
    double t = 1e-10, goal = fraction * light(p, 0);
    while (light(p, t) > goal)
        t *= 1.0002;
    return t;
}

static void within_2_percent(const struct crt_phosphor *p, double fraction, double published,
                             double published_high)
{
    if (published == 0)
        return;
    double high = published_high > 0 ? published_high : published;
    double t = crt_phosphor_decay_time(p, fraction);
    if (t < published * 0.98 || t > high * 1.02)
        fail_msg("%s falls to %g %% in %g s, published %g…%g s", p->name, 100 * fraction, t,
                 published, high);
    double slow = stepped_decay_time(p, fraction);
    assert_true(fabs(t / slow - 1) < 3e-4);
}

static void decay_times_are_those_published(void **state)
{
    (void)state;
    size_t n;
    const struct crt_phosphor *p = crt_phosphors(&n);
    int tektronix = 0, jedec = 0, impulse = 0;
    for (size_t i = 0; i < n; i++) {
        const struct crt_persistence *from = &p[i].tektronix;
        if (p[i].made_from == CRT_FROM_JEDEC)
            from = &p[i].jedec;
        tektronix += p[i].made_from == CRT_FROM_TEKTRONIX;
        jedec += p[i].made_from == CRT_FROM_JEDEC;
        impulse += p[i].made_from == CRT_FROM_IMPULSE;
        if (p[i].made_from == CRT_FROM_IMPULSE)
            continue;
        assert_true(from->t10_s > 0);
        within_2_percent(&p[i], 0.1, from->t10_s, from->t10_high_s);
        within_2_percent(&p[i], 0.01, from->t1_s, 0);
        within_2_percent(&p[i], 0.001, from->t01_s, 0);
    }
    assert_int_equal(tektronix, 11);
    assert_int_equal(jedec, 14);
    assert_int_equal(impulse, 5);
}

/* The figures as published, once more, so that a slip in the rows is seen. Milliseconds. */
static void published_figures(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        double t10, t1, t01;
    } tek[] = {{"P1", 27, 60, 95},       {"P2", .37, 4.7, 51},  {"P3", 19, 45, 74},
               {"P4", .32, 3.3, 20},     {"P7", .305, 5.7, 66}, {"P11", .274, 2.6, 17},
               {"P15", .002, .012, .05}, {"P20", .23, 2.3, 11}, {"P24", .018, .137, .59},
               {"P28", .39, 17, 132.5},  {"P31", .34, 4.5, 32}};
    static const struct {
        const char *name;
        double t10;
    } jedec[] = {{"P1", 24},      {"P3", 13},      {"P7", 400},     {"P11", .034}, {"P12", 210},
                 {"P15", 3e-3},   {"P19", 220},    {"P24", 1.5e-3}, {"P28", 600},  {"P31", .038},
                 {"P33", 2200},   {"P38", 1040},   {"P39", 150},    {"P43", 1.2},  {"P45", 1.8},
                 {"P46", .16e-3}, {"P47", .08e-3}, {"P53", 7},      {"P55", .05},  {"P56", 2.2}};
    for (size_t i = 0; i < sizeof tek / sizeof tek[0]; i++) {
        const struct crt_persistence *t = &get(tek[i].name)->tektronix;
        assert_true(fabs(t->t10_s * 1e3 / tek[i].t10 - 1) < 1e-9);
        assert_true(fabs(t->t1_s * 1e3 / tek[i].t1 - 1) < 1e-9);
        assert_true(fabs(t->t01_s * 1e3 / tek[i].t01 - 1) < 1e-9);
    }
    for (size_t i = 0; i < sizeof jedec / sizeof jedec[0]; i++)
        assert_true(fabs(get(jedec[i].name)->jedec.t10_s * 1e3 / jedec[i].t10 - 1) < 1e-9);
}

/* The measured impulse responses of P22 (seconds), to compare shapes with. */
static double p22r(double t)
{
    return 4 * exp(-t / 442e-6) + 1.75 * exp(-t / 99.5e-6) + 2 * exp(-t / 19.9e-6) +
           2.25 * exp(-t / 6.37e-6) + 15 * exp(-t / 227e-9) + 29 * exp(-t / 22.7e-9);
}

static double p22g(double t)
{
    return 2.1e-4 * pow(t + 5.5e-6, -1.1) + 90 * exp(-t / 31.8e-9) + 100 * exp(-t / 227e-9) +
           37 * exp(-t / 1.06e-6);
}

static double p22b(double t)
{
    return 1.9e-4 * pow(t + 5e-6, -1.11) + 1100 * exp(-t / 39.8e-9) + 1000 * exp(-t / 145e-9) +
           75 * exp(-t / 1.59e-6);
}

static void shape(const char *name, double (*measured)(double), double until, double tolerance)
{
    const struct crt_phosphor *p = get(name);
    double scale = crt_phosphor_impulse(p, 0) / measured(0);
    for (double t = 1e-9; t < until; t *= 1.1) {
        double ratio = crt_phosphor_impulse(p, t) / scale / measured(t);
        if (fabs(ratio - 1) > tolerance)
            fail_msg("%s at %g s is %g of the measured response", name, t, ratio);
    }
}

static void impulse_rows_follow_the_measured_response(void **state)
{
    (void)state;
    shape("P22R", p22r, 5e-3, 1e-9);
    shape("P22G", p22g, 30e-6, 0.015);
    shape("P22B", p22b, 30e-6, 0.015);
    shape("P22G", p22g, 100e-6, 0.05);
    shape("P22B", p22b, 100e-6, 0.05);
}

/* Each colour of P22 decays as its own row does, and its share of the light is that of D65. */
static void p22_is_its_three_colours(void **state)
{
    (void)state;
    const struct crt_phosphor *p = get("P22");
    const struct crt_phosphor *own[] = {get("P22R"), get("P22G"), get("P22B")};
    double share[3], X = 0, Z = 0;
    assert_int_equal(p->colours, 3);
    for (int c = 0; c < 3; c++) {
        assert_true(p->colour[c].x == own[c]->colour[0].x && p->colour[c].y == own[c]->colour[0].y);
        double start = 0;
        share[c] = 0;
        for (int k = 0; k < p->terms; k++)
            if (p->term[k].colour == c) {
                share[c] += p->term[k].w;
                start += p->term[k].w / p->term[k].tau_s;
            }
        assert_true(fabs(start / share[c] / light(own[c], 0) - 1) < 1e-12);
        for (double t = 1e-9; t < 5e-3; t *= 1.2) {
            double sum = 0;
            for (int k = 0; k < p->terms; k++)
                if (p->term[k].colour == c)
                    sum += p->term[k].w / p->term[k].tau_s * exp(-t / p->term[k].tau_s);
            if (fabs(sum / share[c] / light(own[c], t) - 1) > 5e-3)
                fail_msg("colour %d at %g s is %g of its own row", c, t,
                         sum / share[c] / light(own[c], t));
        }
        X += share[c] * p->colour[c].x / p->colour[c].y;
        Z += share[c] * (1 - p->colour[c].x - p->colour[c].y) / p->colour[c].y;
    }
    assert_true(fabs(X / (X + 1 + Z) - 0.3127) < 1e-12);
    assert_true(fabs(1 / (X + 1 + Z) - 0.3290) < 1e-12);
}

static void p4_components_mix_to_the_published_white(void **state)
{
    (void)state;
    const struct crt_phosphor *p = get("P4");
    double X = 0, Y = 0, S = 0;
    for (int k = 0; k < p->terms; k++) {
        struct crt_chromaticity c = p->colour[p->term[k].colour];
        X += p->term[k].w * c.x / c.y;
        Y += p->term[k].w;
        S += p->term[k].w / c.y;
    }
    assert_true(fabs(X / S - 0.270) < 1e-6);
    assert_true(fabs(Y / S - 0.300) < 1e-6);
}

static void p7_keeps_a_yellow_afterglow(void **state)
{
    (void)state;
    const struct crt_phosphor *p = get("P7");
    /* After long excitation the yellow layer falls to 10 % in JEDEC's 400 ms. */
    double full = 0, later = 0;
    for (int k = 0; k < p->terms; k++)
        if (p->term[k].colour == 1) {
            full += p->term[k].w;
            later += p->term[k].w * exp(-0.4 / p->term[k].tau_s);
        }
    assert_true(fabs(later / full - 0.1) < 0.002);
    /* Painted every 2 s, the light 1 s after the paint is still some per cent of the mean. */
    double periodic = 0;
    for (int k = 0; k < p->terms; k++)
        periodic += p->term[k].w / p->term[k].tau_s * exp(-1.0 / p->term[k].tau_s) /
                    (1 - exp(-2.0 / p->term[k].tau_s));
    assert_in_range((int)(1000 * periodic * 2), 30, 300);
}

static void decay_time_is_robust(void **state)
{
    (void)state;
    struct crt_phosphor p = {.terms = 2, .term = {{.5, 1e-9, 0}, {.5, 100, 0}}};
    assert_true(crt_phosphor_decay_time(&p, 1) == 0);
    assert_true(crt_phosphor_decay_time(&p, 2) == 0);
    assert_true(isinf(crt_phosphor_decay_time(&p, 0)));
    assert_true(isinf(crt_phosphor_decay_time(&p, -1)));
    assert_true(isinf(crt_phosphor_decay_time(&p, NAN)));
    for (double f = 1e-30; f < 1; f *= 3) {
        double t = crt_phosphor_decay_time(&p, f);
        assert_true(crt_phosphor_impulse(&p, t) <= f * crt_phosphor_impulse(&p, 0) * (1 + 1e-9));
        assert_true(crt_phosphor_impulse(&p, t * (1 - 1e-9)) >=
                    f * crt_phosphor_impulse(&p, 0) * (1 - 1e-9));
    }
    struct crt_phosphor one = {.terms = 1, .term = {{1, 0.25, 0}}};
    assert_true(fabs(crt_phosphor_decay_time(&one, 0.1) - 0.25 * log(10)) < 1e-14);
}

/* Steady-state light in a period T after each impulse. */
static double periodic_light(const struct crt_phosphor *p, double T, double t)
{
    double sum = 0;
    for (int k = 0; k < p->terms; k++)
        sum += p->term[k].w / p->term[k].tau_s * exp(-t / p->term[k].tau_s) /
               -expm1(-T / p->term[k].tau_s);
    return sum;
}

/* Area above the mean over the whole area: the light crosses its mean, 1/T, once, at t. */
static double flicker_index(const struct crt_phosphor *p, double T)
{
    double low = 0, high = T;
    for (int i = 0; i < 100; i++) {
        double middle = (low + high) / 2;
        if (periodic_light(p, T, middle) > 1 / T)
            low = middle;
        else
            high = middle;
    }
    double area = 0;
    for (int k = 0; k < p->terms; k++)
        area += p->term[k].w * expm1(-low / p->term[k].tau_s) / expm1(-T / p->term[k].tau_s);
    return area - low / T;
}

static void flicker_at_60_hz(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        double c1, c1_tolerance, percent, percent_tolerance, index, index_tolerance;
    } want[] = {
        {"P31", 1.19, .005, 99, .5, .50, .005}, {"P4", 1.41, .005, 99.6, .05, .59, .005},
        {"P1", .445, .0005, 61, .5, .17, .005}, {"P43", 1.96, .005, 100, .5, .86, .005},
        {"P53", 1.31, .005, 99, .5, .51, .005}, {"P39", .081, .0005, 12.7, .05, .032, .0005}};
    const double T = 1 / 60.0;
    for (size_t i = 0; i < sizeof want / sizeof want[0]; i++) {
        const struct crt_phosphor *p = get(want[i].name);
        double complex h = 0;
        for (int k = 0; k < p->terms; k++)
            h += p->term[k].w / (1 + 2 * acos(-1) * 60 * p->term[k].tau_s * I);
        double max = periodic_light(p, T, 0), min = periodic_light(p, T, T);
        double c1 = 2 * cabs(h), percent = 100 * (max - min) / (max + min);
        double index = flicker_index(p, T);
        if (fabs(c1 - want[i].c1) > want[i].c1_tolerance ||
            fabs(percent - want[i].percent) > want[i].percent_tolerance ||
            fabs(index - want[i].index) > want[i].index_tolerance)
            fail_msg("%s at 60 Hz: C1 %.4f, flicker %.3f %%, index %.4f", want[i].name, c1, percent,
                     index);
        assert_true(fabs(crt_phosphor_c1(p, 60) / c1 - 1) < 1e-12);
        if (p->terms == 1) { /* one exponential: closed forms of both */
            double x = T / p->term[0].tau_s, a = 1 / (1 - exp(-x));
            assert_true(fabs(percent - 100 * tanh(x / 2)) < 1e-9);
            assert_true(fabs(index - (a - 1 / x - log(x * a) / x)) < 1e-9);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_listed_phosphor_is_there),
        cmocka_unit_test(rows_are_well_formed),
        cmocka_unit_test(decay_times_are_those_published),
        cmocka_unit_test(published_figures),
        cmocka_unit_test(impulse_rows_follow_the_measured_response),
        cmocka_unit_test(p22_is_its_three_colours),
        cmocka_unit_test(p4_components_mix_to_the_published_white),
        cmocka_unit_test(p7_keeps_a_yellow_afterglow),
        cmocka_unit_test(decay_time_is_robust),
        cmocka_unit_test(flicker_at_60_hz),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
