/* The resistive tablet: currents, straight and bent lines, a sheet over a tube against arcs that are added
 * up, noise and height, edges. */
#include "tests/input/tablet_rig.h"

static double thousandths(double mm)
{
    return rig_um(mm) / 1000.0;
}

static void exact(struct tablet_rig *r)
{
    rig_open(r, TABLET_RESISTIVE);
    r->setup.noise.value = r->setup.bow.value = 0;
}

/* ---- flat --------------------------------------------------------------------------------------- */

/* Edge to edge in proportion; a part of 65536 and a count of 10 µm is all that it is off. */
static void currents_divide(void **state)
{
    (void)state;
    for (int i = 0; i < 500; i++) {
        struct tablet_rig r;
        struct rig_seen seen;
        exact(&r);
        r.seed += (uint64_t)i * 15485863;
        double w = r.setup.width.value = i % 5 ? rig_between(&r, 150, 1830) : 1830;
        double h = r.setup.height.value = i % 6 ? rig_between(&r, 150, 1830) : 150;
        double x = thousandths(rig_between(&r, 0, w - 0.001));
        double y = thousandths(rig_between(&r, 0, h - 0.001));
        assert_true(rig_measure(&r, x, y, rig_between(&r, 0, 12), &seen));
        uint32_t left = rig_read(&r, INPUT_TABLET_RAW), right = rig_read(&r, INPUT_TABLET_RAW + 4);
        uint32_t lower = rig_read(&r, INPUT_TABLET_RAW + 8);
        uint32_t upper = rig_read(&r, INPUT_TABLET_RAW + 12);
        assert_int_equal(left + right, 65536);
        assert_int_equal(lower + upper, 65536);
        rig_within(right - 65536 * x / w, -0.501, 0.501);
        rig_within(upper - 65536 * y / h, -0.501, 0.501);
        rig_within(seen.x - x, -0.0051 - w / 131072, 0.0051 + w / 131072);
        rig_within(seen.y - y, -0.0051 - h / 131072, 0.0051 + h / 131072);
        assert_true(seen.z == 0); /* it does not tell */
    }
}

/* Vertical lines are right in the middle of their length and at the tablet's edges, and bent by the
 * figure at most, which they come near. */
static void lines_are_bent(void **state)
{
    (void)state;
    struct tablet_rig r;
    struct rig_seen seen;
    struct rig_errors x = {.count = 0}, y = {.count = 0}, straight = {.count = 0};
    exact(&r);
    r.setup.bow.value = 1;
    for (int i = 0; i < 20000; i++) {
        double at = thousandths(rig_between(&r, 0, 280)), up = thousandths(rig_between(&r, 0, 280));
        assert_true(rig_measure(&r, at, up, 0, &seen));
        rig_add(&x, seen.x - at);
        rig_add(&y, seen.y - up);
        if (i % 10)
            continue;
        assert_true(rig_measure(&r, at, 140, 0, &seen));
        rig_add(&straight, seen.x - at);
        assert_true(rig_measure(&r, i % 4 ? 0 : 280, up, 0, &seen));
        rig_add(&straight, seen.x - (i % 4 ? 0 : 280));
    }
    rig_within(x.most, 0.95, 1.01);
    rig_within(y.most, 0.95, 1.01);
    rig_within(rig_rms(&x), 0.2, 0.5);
    rig_within(straight.most, 0, 0.01);
    /* Towards the middle, alike on both sides. */
    for (int side = -1; side <= 1; side += 2) {
        assert_true(rig_measure(&r, 140 + 80 * side, 279, 0, &seen));
        rig_within(side * (seen.x - 140 - 80 * side), -1.01, -0.9);
        assert_true(rig_measure(&r, 140 + 80 * side, 1, 0, &seen));
        rig_within(side * (seen.x - 140 - 80 * side), -1.01, -0.9);
    }
}

/* With every figure as listed a tablet is below 0.2 mm but for some places of the border. */
static void accurate(void **state)
{
    (void)state;
    struct tablet_rig r;
    struct rig_seen seen;
    struct rig_errors x = {.count = 0}, y = {.count = 0};
    rig_open(&r, TABLET_RESISTIVE);
    unsigned beyond = 0;
    for (int i = 0; i < 10000; i++) {
        double at = thousandths(rig_between(&r, 0, 280)), up = thousandths(rig_between(&r, 0, 280));
        assert_true(rig_measure(&r, at, up, 0, &seen));
        rig_add(&x, seen.x - at);
        rig_add(&y, seen.y - up);
        beyond += fabs(seen.x - at) > 0.15;
    }
    rig_within(x.most, 0.1, 0.25);
    rig_within(y.most, 0.1, 0.25);
    rig_within(beyond, 0, 100);
    rig_within(rig_rms(&x), 0.03, 0.06);
    rig_within(rig_mean(&x), -0.002, 0.002);
    rig_within(rig_mean(&y), -0.002, 0.002);
}

/* ---- over a tube -------------------------------------------------------------------------------- */

/* Along a circle of that radius to x beside its top: the lengths of small chords, made longer by what a
 * chord lacks of its arc (in the second order: Richardson). */
static long double chords(long double x, long double radius, int pieces)
{
    long double sum = 0, u0 = 0, v0 = radius;
    for (int i = 1; i <= pieces; i++) {
        long double u = x * i / pieces, v = sqrtl(radius * radius - u * u);
        sum += hypotl(u - u0, v - v0);
        u0 = u;
        v0 = v;
    }
    return x < 0 ? -sum : sum;
}

static double arc(double x, double radius)
{
    long double coarse = chords(x, radius, 400), fine = chords(x, radius, 800);
    return (double)(fine + (fine - coarse) / 3);
}

static void along_a_cylinder(void **state)
{
    (void)state;
    const struct {
        double width, height, radius;
    } tubes[] = {{280, 210, 500}, {280, 280, 250}, {1830, 1220, 5000}, {1830, 150, 1100}};
    for (int i = 0; i < 4; i++) {
        struct tablet_rig r;
        struct rig_seen seen;
        exact(&r);
        double w = r.setup.width.value = tubes[i].width, h = r.setup.height.value = tubes[i].height;
        double radius = r.setup.radius.value = tubes[i].radius;
        double across = arc(w / 2, radius), up = arc(h / 2, radius);
        rig_within(rig_read(&r, INPUT_TABLET_WIDTH) * 0.01 - 2 * across, -0.0051, 0.0051);
        rig_within(rig_read(&r, INPUT_TABLET_HEIGHT) * 0.01 - 2 * up, -0.0051, 0.0051);
        for (int n = 0; n < 200; n++) {
            double x = thousandths(rig_between(&r, 0, w)), y = thousandths(rig_between(&r, 0, h));
            assert_true(rig_measure(&r, x, y, 1, &seen));
            double miss = 0.006 + across / 65536;
            rig_within(seen.x - across - arc(x - w / 2, radius), -miss, miss);
            miss = 0.006 + up / 65536;
            rig_within(seen.y - up - arc(y - h / 2, radius), -miss, miss);
        }
    }
}

/* Of a point of the sphere: the angle to the nearest point of the great circle through the top that runs
 * up (or across), found by searching. */
static double to_circle(double x, double y, double radius, bool up)
{
    double z = sqrt(radius * radius - x * x - y * y), low = -1.5, high = 1.5;
    double least = 0;
    for (int i = 0; i < 100; i++) {
        double cut[2] = {low + (high - low) / 3, high - (high - low) / 3}, chord[2];
        for (int k = 0; k < 2; k++) {
            double side = radius * sin(cut[k]), top = radius * cos(cut[k]);
            double dx = up ? x : x - side, dy = up ? y - side : y;
            chord[k] = sqrt(dx * dx + dy * dy + (z - top) * (z - top));
        }
        low = chord[0] > chord[1] ? cut[0] : low;
        high = chord[0] > chord[1] ? high : cut[1];
        least = chord[0];
    }
    return 2 * radius * asin(least / 2 / radius); /* the arc of a chord */
}

static void along_a_sphere(void **state)
{
    (void)state;
    struct tablet_rig r;
    struct rig_seen seen;
    exact(&r);
    r.setup.width.value = 380;
    double radius = r.setup.radius.value = 600;
    double across = arc(190, radius), up = arc(140, radius);
    for (int n = 0; n < 500; n++) {
        double x = thousandths(rig_between(&r, 0, 380)), y = thousandths(rig_between(&r, 0, 280));
        assert_true(rig_measure(&r, x, y, 0, &seen));
        double right = to_circle(x - 190, y - 140, radius, true);
        double above = to_circle(x - 190, y - 140, radius, false);
        rig_within(fabs(seen.x - across) - right, -0.012, 0.012);
        rig_within(fabs(seen.y - up) - above, -0.012, 0.012);
        assert_true((seen.x > across) == (x > 190) || right < 0.02);
    }
}

/* As the radius grows it becomes flat; a radius below what the sheet can be bent to is that. */
static void any_radius(void **state)
{
    (void)state;
    struct tablet_rig r;
    struct rig_seen seen;
    for (int i = 0; i < 400; i++) {
        exact(&r);
        r.seed += (uint64_t)i * 32452843;
        double w = r.setup.width.value = i % 5 ? rig_between(&r, 150, 1830) : 1830;
        double h = r.setup.height.value = i % 4 ? rig_between(&r, 150, 1830) : 1830;
        r.setup.radius.value = i % 3 ? rig_between(&r, 0, 5000) : i % 2 ? 1e-9 : 5000;
        double radius = fmax(r.setup.radius.value, 0.55 * hypot(w, h));
        double x = thousandths(rig_between(&r, 0, w - 0.001));
        double y = thousandths(rig_between(&r, 0, h - 0.001));
        assert_true(rig_measure(&r, x, y, 0, &seen));
        double across = radius * asin(w / 2 / radius), up = radius * asin(h / 2 / radius);
        rig_within(seen.x - across - radius * asin((x - w / 2) / radius), -0.04, 0.04);
        rig_within(seen.y - up - radius * asin((y - h / 2) / radius), -0.04, 0.04);
    }
}

/* ---- noise and reach ---------------------------------------------------------------------------- */

/* The stylus's signal falls to a half at 3 mm, to a quarter at 9: the noise of the place is as much more. */
static void noise_and_height(void **state)
{
    (void)state;
    const struct {
        double z, more;
    } heights[] = {{0, 1}, {3, 2}, {9, 4}, {12, 5}};
    for (int i = 0; i < 4; i++) {
        struct tablet_rig r;
        struct rig_seen seen;
        struct rig_errors x = {.count = 0}, y = {.count = 0};
        exact(&r);
        r.setup.noise.value = 0.1;
        double rms = 0.1 * heights[i].more, product = 0;
        for (int n = 0; n < 4000; n++) {
            assert_true(rig_measure(&r, 101, 77, heights[i].z, &seen));
            rig_add(&x, seen.x - 101);
            rig_add(&y, seen.y - 77);
            product += (seen.x - 101) * (seen.y - 77);
        }
        rig_within(rig_rms(&x) / rms, 0.95, 1.05);
        rig_within(rig_rms(&y) / rms, 0.95, 1.05);
        rig_within(rig_mean(&x) / rms, -0.065, 0.065);
        rig_within(rig_mean(&y) / rms, -0.065, 0.065);
        rig_within(product / 4000 / (rms * rms), -0.065, 0.065);
    }
}

static void the_sheet_ends(void **state)
{
    (void)state;
    struct tablet_rig r;
    struct rig_seen seen;
    rig_open(&r, TABLET_RESISTIVE);
    for (int i = 0; i < 500; i++) {
        double out = rig_between(&r, 0.001, i % 2 ? 1 : 9000), y = rig_between(&r, 0, 280);
        assert_false(rig_measure(&r, -out, y, 0, &seen));
        assert_false(rig_measure(&r, 280 + out, y, 0, &seen));
        assert_false(rig_measure(&r, y, -out, 0, &seen));
        assert_false(rig_measure(&r, y, 280 + out, 0, &seen));
        assert_true(rig_measure(&r, i % 2 ? 0 : 280, y, 5, &seen));
        rig_within(seen.x, 0, 280); /* noise makes no current negative */
        assert_true(rig_read(&r, INPUT_TABLET_RAW) <= 65536);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(currents_divide),  cmocka_unit_test(lines_are_bent),
        cmocka_unit_test(accurate),         cmocka_unit_test(along_a_cylinder),
        cmocka_unit_test(along_a_sphere),   cmocka_unit_test(any_radius),
        cmocka_unit_test(noise_and_height), cmocka_unit_test(the_sheet_ends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
