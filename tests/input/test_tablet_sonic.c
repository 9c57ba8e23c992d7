/* The sonic tablet: travel times against distance and the speed of sound, places against those found by
 * Gauss and Newton from the times, the law of the air's temperature, space, reach, noise. */
#include "tests/input/tablet_rig.h"

struct point {
    long double x, y, z;
};

static struct point microphone(const struct tablet_rig *r, int m)
{
    return (struct point){m % 2 ? r->setup.width.value : 0, m / 2 ? r->setup.height.value : 0,
                          m == 1 || m == 2 ? r->setup.post.value : 0};
}

static long double distance(struct point a, struct point b)
{
    return sqrtl((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

/* Metres a second are 10^-6 mm a nanosecond. */
static long double mm_per_ns(long double celsius)
{
    return 331.3L * sqrtl(1 + celsius / 273.15L) * 1e-6L;
}

static double thousandths(double mm)
{
    return rig_um(mm) / 1000.0;
}

static struct point anywhere(struct tablet_rig *r, double beyond, double up)
{
    return (struct point){thousandths(rig_between(r, -beyond, r->setup.width.value + beyond)),
                          thousandths(rig_between(r, -beyond, r->setup.height.value + beyond)),
                          thousandths(rig_between(r, 0.001, up))};
}

static bool measure(struct tablet_rig *r, struct point p, struct rig_seen *seen)
{
    return rig_measure(r, (double)p.x, (double)p.y, (double)p.z, seen);
}

static void random_figures(struct tablet_rig *r, int i)
{
    rig_open(r, TABLET_SONIC);
    r->seed += (uint64_t)i * 15485863;
    r->setup.noise.value = 0;
    r->setup.width.value = i % 6 ? rig_between(r, 150, 1830) : 1830;
    r->setup.height.value = i % 5 ? rig_between(r, 150, 1830) : 150;
    r->setup.post.value = i % 4 ? rig_between(r, 50, 500) : 50;
    r->setup.temperature.value = i % 3 ? rig_between(r, -20, 50) : i % 2 ? -20 : 50;
    r->setup.reach.value = i % 7 ? rig_between(r, 10, 1000) : 1000;
    r->setup.clock.value = i % 8 ? rig_between(r, 1, 50) : 50;
}

static void times_are_distance_over_speed(void **state)
{
    (void)state;
    for (int i = 0; i < 400; i++) {
        struct tablet_rig r;
        struct rig_seen seen;
        random_figures(&r, i);
        struct point p = anywhere(&r, 0, r.setup.reach.value);
        assert_true(measure(&r, p, &seen));
        long double tick = 1000 / (long double)r.setup.clock.value; /* ns */
        for (int m = 0; m < 4; m++) {
            long double exact =
                distance(p, microphone(&r, m)) / mm_per_ns(r.setup.temperature.value);
            double raw = rig_read(&r, INPUT_TABLET_RAW + 4 * (uint32_t)m);
            rig_within(raw - (double)exact, -0.51 - (double)tick / 2, 0.51 + (double)tick / 2);
        }
    }
}

/* Four equations in three unknowns; steps from near by that make the sum of squared misses least. */
static struct point triangulate(const struct tablet_rig *r, struct point p, const long double d[4])
{
    for (int turn = 0; turn < 20; turn++) {
        long double a[3][4] = {{0}};
        for (int m = 0; m < 4; m++) {
            struct point q = microphone(r, m);
            long double l = distance(p, q);
            long double j[4] = {(p.x - q.x) / l, (p.y - q.y) / l, (p.z - q.z) / l, d[m] - l};
            for (int row = 0; row < 3; row++)
                for (int col = 0; col < 4; col++)
                    a[row][col] += j[row] * j[col];
        }
        for (int k = 0; k < 3; k++)
            for (int row = 0; row < 3; row++) {
                long double f = row == k ? 0 : a[row][k] / a[k][k];
                for (int col = 0; col < 4; col++)
                    a[row][col] -= f * a[k][col];
            }
        p = (struct point){p.x + a[0][3] / a[0][0], p.y + a[1][3] / a[1][1],
                           p.z + a[2][3] / a[2][2]};
    }
    return p;
}

/* What the registers say of the place is what their own times say. */
static void places_follow_from_times(void **state)
{
    (void)state;
    for (int i = 0; i < 300; i++) {
        struct tablet_rig r;
        struct rig_seen seen;
        random_figures(&r, i);
        r.setup.temperature.value = 20;
        r.setup.clock.value = 50;
        struct point p = anywhere(&r, 0, r.setup.reach.value);
        assert_true(measure(&r, p, &seen));
        long double d[4];
        for (int m = 0; m < 4; m++)
            d[m] = rig_read(&r, INPUT_TABLET_RAW + 4 * (uint32_t)m) * mm_per_ns(20);
        struct point q = triangulate(&r, (struct point){p.x + 5, p.y - 4, p.z + 3}, d);
        /* Times are quantised: two ways to use four of them differ by a few ticks of 0.007 mm; heights by
         * more, where the posts are low for the width. */
        double low =
            (r.setup.width.value + r.setup.height.value + r.setup.reach.value) / r.setup.post.value;
        rig_within(seen.x - (double)q.x, -0.04, 0.04);
        rig_within(seen.y - (double)q.y, -0.04, 0.04);
        rig_within(seen.z - fmax((double)q.z, 0), -0.02 - 0.005 * low, 0.02 + 0.005 * low);
    }
}

static void accurate_in_space(void **state)
{
    (void)state;
    struct tablet_rig r;
    struct rig_seen seen;
    struct rig_errors x = {.count = 0}, y = {.count = 0}, z = {.count = 0};
    rig_open(&r, TABLET_SONIC);
    for (int i = 0; i < 5000; i++) {
        struct point p = anywhere(&r, 0, 300);
        assert_true(measure(&r, p, &seen));
        rig_add(&x, seen.x - (double)p.x);
        rig_add(&y, seen.y - (double)p.y);
        rig_add(&z, seen.z - (double)p.z);
    }
    rig_within(x.most, 0.05, 0.2);
    rig_within(y.most, 0.05, 0.2);
    rig_within(z.most, 0.1, 0.5);
    rig_within(rig_rms(&x), 0.02, 0.05);
    rig_within(rig_rms(&y), 0.02, 0.05);
    rig_within(rig_mean(&x), -0.002, 0.002);
    rig_within(rig_mean(&y), -0.002, 0.002);
    rig_within(rig_mean(&z), -0.005, 0.005);
}

/* Every distance is wrong by √(T0/T), so every square by T0/T; with the microphones in the corners that
 * moves all places towards or away from the middle in that proportion. */
static void another_temperature(void **state)
{
    (void)state;
    for (int celsius = -20; celsius <= 50; celsius += 5)
        for (int assumed = -20; assumed <= 50; assumed += 35) {
            struct tablet_rig r;
            struct rig_seen seen;
            rig_open(&r, TABLET_SONIC);
            r.setup.noise.value = 0;
            r.setup.clock.value = 50;
            r.setup.temperature.value = celsius;
            r.setup.assumed.value = assumed;
            double scale = (273.15 + assumed) / (273.15 + celsius);
            for (int i = 0; i < 40; i++) {
                struct point p = anywhere(&r, 0, 300);
                assert_true(measure(&r, p, &seen));
                rig_within(seen.x - 140 - scale * ((double)p.x - 140), -0.03, 0.03);
                rig_within(seen.y - 140 - scale * ((double)p.y - 140), -0.03, 0.03);
                double z = 50 + scale * ((double)p.z - 50);
                rig_within(seen.z - fmax(z, 0), -0.06, 0.06);
            }
        }
}

/* One way, as √T: 10 degrees from 20 to 30 make sound 1.69 % faster. */
static void ten_degrees(void **state)
{
    (void)state;
    struct tablet_rig r;
    struct rig_seen seen;
    uint32_t time[2];
    rig_open(&r, TABLET_SONIC);
    r.setup.noise.value = 0;
    r.setup.clock.value = 50;
    for (int i = 0; i < 2; i++) {
        r.setup.temperature.value = 20 + 10 * i;
        assert_true(rig_measure(&r, 240, 180, 0, &seen)); /* 300 mm from microphone 0 */
        time[i] = rig_read(&r, INPUT_TABLET_RAW);
    }
    rig_within(time[0], 300e6 / 343.214 - 15, 300e6 / 343.214 + 15);
    rig_within(time[0] / (double)time[1], 1.0169, 1.0170);
}

/* The place does not care whether there is anything under the stylus; only its switch tells touching. */
static void no_surface(void **state)
{
    (void)state;
    struct tablet_rig r;
    struct rig_seen seen;
    rig_open(&r, TABLET_SONIC);
    for (int i = 0; i < 300; i++) {
        struct point p = anywhere(&r, 50, 299);
        p.z = i % 2 ? p.z : 0.001L;
        assert_true(measure(&r, p, &seen));
        assert_int_equal(seen.proximity, TABLET_NEAR);
        rig_act(&r, INP_PRESS, 0);
        assert_true(measure(&r, p, &seen));
        assert_int_equal(seen.proximity, TABLET_TOUCH);
        rig_within(seen.x - (double)p.x, -0.3, 0.3);
        rig_act(&r, INP_RELEASE, 0);
    }
    for (int i = 0; i < 300; i++) {
        struct point p = anywhere(&r, 50, 9000);
        if (p.z < 301)
            p.z += 301;
        assert_false(measure(&r, p, &seen));
    }
}

/* Too far for one microphone is too far. */
static void the_counter_ends(void **state)
{
    (void)state;
    struct tablet_rig r;
    struct rig_seen seen;
    rig_open(&r, TABLET_SONIC);
    r.setup.noise.value = 0;
    double longest = 1.2 * sqrt(280 * 280.0 + 280 * 280.0 + 300 * 300.0);
    for (int i = 0; i < 2000; i++) {
        struct point p = anywhere(&r, i % 2 ? 400 : 5000, 300);
        double most = 0;
        for (int m = 0; m < 4; m++)
            most = fmax(most, (double)distance(p, microphone(&r, m)));
        if (fabs(most - longest) > 0.01)
            assert_int_equal(measure(&r, p, &seen), most < longest);
    }
}

/* A counter of one microsecond: steps of a third of a millimetre, and no further off than that. */
static void a_slow_counter(void **state)
{
    (void)state;
    struct tablet_rig r;
    struct rig_seen seen;
    struct rig_errors x = {.count = 0};
    rig_open(&r, TABLET_SONIC);
    r.setup.noise.value = 0;
    r.setup.clock.value = 1;
    unsigned same = 0;
    double last = 0;
    for (int i = 0; i < 4000; i++) {
        double at = 100 + 0.01 * i;
        assert_true(rig_measure(&r, at, 133, 0, &seen));
        rig_add(&x, seen.x - at);
        same += seen.x == last;
        last = seen.x;
    }
    rig_within(x.most, 0.1, 0.36);
    rig_within(rig_mean(&x), -0.02, 0.02);
    rig_within(same, 3000, 3990); /* it goes in steps */
}

/* Noise of distances; in the middle of the tablet that is noise of the place by Σr² of the four. */
static void noise_of_distances(void **state)
{
    (void)state;
    struct tablet_rig r;
    struct rig_seen seen;
    struct rig_errors x = {.count = 0}, y = {.count = 0}, z = {.count = 0};
    rig_open(&r, TABLET_SONIC);
    r.setup.noise.value = 0.1;
    r.setup.clock.value = 50;
    struct point p = {100, 160, 30};
    long double squares = 0;
    for (int m = 0; m < 4; m++)
        squares += distance(p, microphone(&r, m)) * distance(p, microphone(&r, m));
    for (int i = 0; i < 4000; i++) {
        assert_true(measure(&r, p, &seen));
        rig_add(&x, seen.x - (double)p.x);
        rig_add(&y, seen.y - (double)p.y);
        rig_add(&z, seen.z - (double)p.z);
    }
    double each = 0.1 * 2 * sqrt((double)squares) / 4;
    rig_within(rig_rms(&x) * 280 / each, 0.95, 1.05);
    rig_within(rig_rms(&y) * 280 / each, 0.95, 1.05);
    rig_within(rig_rms(&z) * 100 / each, 0.95, 1.05);
    rig_within(rig_mean(&x) * 280 / each, -0.065, 0.065);
    rig_within(rig_mean(&y) * 280 / each, -0.065, 0.065);
    rig_within(rig_mean(&z) * 100 / each, -0.065, 0.065);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(times_are_distance_over_speed),
        cmocka_unit_test(places_follow_from_times),
        cmocka_unit_test(accurate_in_space),
        cmocka_unit_test(another_temperature),
        cmocka_unit_test(ten_degrees),
        cmocka_unit_test(no_surface),
        cmocka_unit_test(the_counter_ends),
        cmocka_unit_test(a_slow_counter),
        cmocka_unit_test(noise_of_distances),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
