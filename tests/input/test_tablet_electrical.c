/* The electrical tablet: signals against the law of Biot and Savart added up along the wires, accuracy at
 * the surface and above it, edges, noise. */
#include "tests/input/tablet_rig.h"

/* Upright field at `d` beside and `h` above a wire, added up piece by piece along 2·40 m of it: each piece at s
 * adds ds·d/(d² + h² + s²)^(3/2). */
static double wire(double d, double h)
{
    double sum = 0, square = d * d + h * h, near = sqrt(square), last = asinh(40000 / near);
    int steps = 120;
    for (int i = 0; i < steps; i++) {
        double v =
            -last + 2 * last * (i + 0.5) / steps; /* s = near·sinh(v): short pieces near by */
        double s = near * sinh(v), ds = near * cosh(v) * 2 * last / steps;
        double r = sqrt(square + s * s);
        sum += ds * d / (r * r * r);
    }
    return sum;
}

/* Of loop n: wires half a pitch to both sides of its middle, their currents against each other. */
static double loop(const struct tablet_rig *r, long n, double x, double z)
{
    double p = r->setup.pitch.value, d = x - (double)(n - 1) * p, h = r->setup.coil.value + z;
    return wire(d + p / 2, h) - wire(d - p / 2, h);
}

static void signals_are_those_of_wires(void **state)
{
    (void)state;
    struct tablet_rig r;
    struct rig_seen seen;
    rig_open(&r, TABLET_ELECTRICAL);
    r.setup.noise.value = 0;
    for (int i = 0; i < 40; i++) {
        r.setup.pitch.value = rig_between(&r, 6.35, 12.7);
        r.setup.coil.value = rig_between(&r, 8, 20);
        double at[2] = {rig_between(&r, 0, 280), rig_between(&r, 0, 280)};
        double z = rig_between(&r, 0, 12);
        assert_true(rig_measure(&r, at[0], at[1], z, &seen));
        double full = loop(&r, 1, 0, 0);
        for (uint32_t axis = 0; axis < 2; axis++) {
            double x = rig_um(at[axis]) / 1000.0;
            long about = (long)(x / r.setup.pitch.value), best = about;
            for (long n = about - 3; n < about + 6; n++)
                if (loop(&r, n, x, z) > loop(&r, best, x, z))
                    best = n;
            double below = loop(&r, best - 1, x, z), above = loop(&r, best + 1, x, z);
            double beside = below > above ? below : above;
            uint32_t signal = INPUT_TABLET_RAW + 8 + 8 * axis;
            assert_int_equal(rig_read(&r, INPUT_TABLET_RAW + 4 * axis), best);
            rig_within(rig_read(&r, signal) - 65536 * loop(&r, best, x, z) / full, -5, 5);
            rig_within(rig_read(&r, signal + 4) - 65536 * fmax(beside, 0) / full, -5, 5);
        }
    }
}

struct cloud {
    struct rig_errors x, y, z;
    unsigned missed;
};

/* Errors at random places of the surface at one height. */
static struct cloud at_height(struct tablet_rig *r, double z, int places)
{
    struct cloud c = {.missed = 0};
    struct rig_seen seen;
    for (int i = 0; i < places; i++) {
        double x = rig_um(rig_between(r, 0, r->setup.width.value)) / 1000.0;
        double y = rig_um(rig_between(r, 0, r->setup.height.value)) / 1000.0;
        if (!rig_measure(r, x, y, z, &seen)) {
            c.missed++;
            continue;
        }
        rig_add(&c.x, seen.x - x);
        rig_add(&c.y, seen.y - y);
        rig_add(&c.z, seen.z - z);
    }
    return c;
}

/* 0.2 mm with every figure as listed; what interpolation alone gets wrong is a tenth of that. */
static void accurate_at_the_surface(void **state)
{
    (void)state;
    struct tablet_rig r;
    rig_open(&r, TABLET_ELECTRICAL);
    struct cloud c = at_height(&r, 0, 5000);
    assert_int_equal(c.missed, 0);
    rig_within(c.x.most, 0.06, 0.2); /* noise is there, and it is accurate */
    rig_within(c.y.most, 0.06, 0.2);
    for (double z = 0; z <= 12; z += 0.5) {
        rig_open(&r, TABLET_ELECTRICAL);
        r.setup.noise.value = 0;
        c = at_height(&r, z, 400);
        assert_int_equal(c.missed, 0);
        rig_within(c.x.most, 0, 0.022);
        rig_within(c.y.most, 0, 0.022);
        rig_within(c.z.most, 0, 0.022);
    }
}

/* Whatever pitch and coil it is made with, and however large. */
static void every_grid_interpolates(void **state)
{
    (void)state;
    struct tablet_rig r;
    for (int i = 0; i < 200; i++) {
        rig_open(&r, TABLET_ELECTRICAL);
        r.seed += (uint64_t)i * 7919;
        r.setup.noise.value = 0;
        r.setup.pitch.value = i % 5 ? rig_between(&r, 6.35, 12.7) : i % 2 ? 12.7 : 6.35;
        r.setup.coil.value = i % 3 ? rig_between(&r, 8, 20) : i % 2 ? 8 : 20;
        r.setup.width.value = i % 7 ? rig_between(&r, 150, 1830) : 1830;
        r.setup.height.value = i % 4 ? rig_between(&r, 150, 1830) : 150;
        r.setup.near.value = i % 3 ? 25 : 1;
        double z = rig_between(&r, 0, i % 3 ? 24.5 : 0.5);
        struct cloud c = at_height(&r, z, 50);
        assert_int_equal(c.missed, 0);
        rig_within(c.x.most, 0, 0.13);
        rig_within(c.y.most, 0, 0.13);
        rig_within(c.z.most, 0, 0.4);
    }
}

/* The figure is the noise of a place at the surface; no bias; even and normal enough. */
static void noise_at_the_surface(void **state)
{
    (void)state;
    const double figures[] = {0.03, 0.1, 0.2};
    for (int i = 0; i < 3; i++) {
        struct tablet_rig r;
        struct rig_seen seen;
        struct rig_errors x = {.count = 0}, y = {.count = 0};
        unsigned beyond = 0, both = 0, n = 4000;
        rig_open(&r, TABLET_ELECTRICAL);
        r.setup.noise.value = figures[i];
        double place = 22 * 6.35; /* the middle of a loop */
        for (unsigned k = 0; k < n; k++) {
            assert_true(rig_measure(&r, place, place, 0, &seen));
            rig_add(&x, seen.x - place);
            rig_add(&y, seen.y - place);
            beyond += fabs(seen.x - place) > 2 * figures[i];
            both += (seen.x > place) == (seen.y > place);
        }
        /* Standard errors: figure/√4000 = 0.016 of it; of the rms 0.011 of it. */
        rig_within(rig_rms(&x), 0.95 * figures[i], 1.05 * figures[i]);
        rig_within(rig_rms(&y), 0.95 * figures[i], 1.05 * figures[i]);
        rig_within(rig_mean(&x), -0.065 * figures[i], 0.065 * figures[i]);
        rig_within(rig_mean(&y), -0.065 * figures[i], 0.065 * figures[i]);
        rig_within(beyond, 0.030 * n, 0.062 * n); /* 4.55 % of a normal deviate */
        rig_within(both, 0.46 * n, 0.54 * n);     /* x and y are independent */
    }
}

/* In the middle of a loop the neighbours' signals are on the slope of theirs: the noise of the place is that
 * of their difference over its slope, which falls with height. */
static void noise_grows_with_height(void **state)
{
    (void)state;
    const double heights[] = {0, 2, 5, 8, 12, 16};
    double first = 0, place = 20 * 6.35;
    for (int i = 0; i < 6; i++) {
        struct tablet_rig r;
        struct rig_errors x = {.count = 0};
        struct rig_seen seen;
        rig_open(&r, TABLET_ELECTRICAL);
        r.setup.noise.value = 0.02;
        r.setup.near.value = 25;
        for (int k = 0; k < 3000; k++) {
            assert_true(rig_measure(&r, place, place, heights[i], &seen));
            rig_add(&x, seen.x - place);
        }
        double slope =
            (loop(&r, 22, place + 0.01, heights[i]) - loop(&r, 20, place + 0.01, heights[i])) /
            0.01;
        double scaled = rig_rms(&x) * slope;
        first = i ? first : scaled;
        rig_within(scaled / first, 0.93, 1.07);
        rig_within(rig_mean(&x) / rig_rms(&x), -0.08, 0.08);
    }
}

/* The grid ends half a pitch or more beyond the edges. */
static void beyond_the_edges(void **state)
{
    (void)state;
    struct tablet_rig r;
    struct rig_seen seen;
    for (int i = 0; i < 200; i++) {
        rig_open(&r, TABLET_ELECTRICAL);
        r.seed += (uint64_t)i * 104729;
        r.setup.noise.value = 0;
        r.setup.width.value = rig_between(&r, 150, 400);
        double width = r.setup.width.value, pitch = r.setup.pitch.value;
        double out = rig_between(&r, 0, 0.48 * pitch), y = rig_between(&r, 0, 280);
        assert_true(rig_measure(&r, -out, y, 1, &seen));
        rig_within(seen.x + out, -0.03, 0.03);
        assert_true(rig_measure(&r, width + out, y, 1, &seen));
        rig_within(seen.x - width - out, -0.03, 0.03);
        assert_false(rig_measure(&r, -0.52 * pitch - out, y, 1, &seen));
        assert_false(rig_measure(&r, width + 1.52 * pitch + out, y, 1, &seen));
        assert_false(rig_measure(&r, y, rig_between(&r, 300, 10000), 1, &seen));
        assert_false(rig_measure(&r, rig_between(&r, -10000, -20), y, 1, &seen));
    }
}

/* Signals alone tell touching within a measured height of half a millimetre. */
static void strength_tells_touching(void **state)
{
    (void)state;
    struct tablet_rig r;
    struct rig_seen seen;
    rig_open(&r, TABLET_ELECTRICAL);
    r.setup.noise.value = 0;
    for (int i = 0; i < 300; i++) {
        double z = rig_between(&r, 0.001, 1);
        if (fabs(z - 0.5) < 0.03)
            continue;
        assert_true(rig_measure(&r, rig_between(&r, 0, 280), rig_between(&r, 0, 280), z, &seen));
        assert_int_equal(seen.proximity, z < 0.5 ? TABLET_TOUCH : TABLET_NEAR);
        assert_int_equal(seen.buttons, 0); /* the switch is another matter */
    }
}

/* With the most noise it still works at 5 mm, and far off it never sees what is not there. */
static void no_ghosts(void **state)
{
    (void)state;
    struct tablet_rig r;
    struct rig_seen seen;
    rig_open(&r, TABLET_ELECTRICAL);
    r.setup.noise.value = 0.2;
    r.setup.near.value = 25;
    for (int i = 0; i < 3000; i++) {
        double x = rig_between(&r, 0, 280), y = rig_between(&r, 0, 280);
        assert_false(rig_measure(&r, x, y, rig_between(&r, 60, 1000), &seen));
        assert_true(rig_measure(&r, x, y, 5, &seen));
        rig_within(seen.x - x, -6, 6);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(signals_are_those_of_wires), cmocka_unit_test(accurate_at_the_surface),
        cmocka_unit_test(every_grid_interpolates),    cmocka_unit_test(noise_at_the_surface),
        cmocka_unit_test(noise_grows_with_height),    cmocka_unit_test(beyond_the_edges),
        cmocka_unit_test(strength_tells_touching),    cmocka_unit_test(no_ghosts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
