/* What noise, room light and lamps do to a light pen is what statistics say. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "crt/spot.h"
#include "tests/input/pen_slow.h"

#define US UINT64_C(1000000)
#define MS (1000 * US)

/* Glows for a hundred picoseconds: its light is the beam's power. */
static const struct crt_phosphor instant = {
    .name = "INSTANT", .colours = 1, .colour = {{.3, .5}}, .terms = 1, .term = {{1, 1e-10, 0}}};

static struct inp_pen_setup setup;
static struct inp_pen pen;

static void make(const char *tube, const struct crt_phosphor *phosphor, uint64_t seed)
{
    struct inp_pen_desc desc = {&setup, crt_tube_row_find(tube), phosphor, {0, 1, 0}, seed};
    inp_pen_init(&pen, &desc);
    inp_hand_move(&pen.hand, (struct inp_place){0, 0, 0}, 0, 0);
}

/* Share of a normal deviate that is above x. */
static double above(double x)
{
    return erfc(x / sqrt(2)) / 2;
}

static void within_chance(double found, double of, double share)
{
    double sigma = sqrt(of * share * (1 - share)) + 1;
    if (!(fabs(found - of * share) < 4 * sigma))
        print_message("%g of %g, %g expected\n", found, of, of * share);
    assert_true(fabs(found - of * share) < 4 * sigma);
}

/* ---- hits --------------------------------------------------------------------------------------- */

/* A spot lit for a number of cells of noise, dim to bright: in each the detector has come so far. */
static void hits_are_as_likely_as_the_normal_integral_says(void **state)
{
    enum { CELLS = 8, TRIALS = 3000 };
    (void)state;
    setup = slow_setup();
    setup.couple.value = 1e5;
    setup.delay.value = 0;
    setup.noise.value = 10;
    setup.threshold.value = 60;
    make("VR17", &instant, 1);
    double full = crt_spot_at(pen.desc.row, &pen.knobs, 1).power / 0.5;
    uint64_t cell = pen.model.cell;
    assert_true(fabs((double)cell - 0.6e6) < 2);
    for (int i = 0; i < 8; i++) {
        double signal = 25 + 6 * i, miss = 1;
        for (int n = 0; n < CELLS; n++)
            miss *= 1 - above((60 - signal * (1 - exp(-2 * (n + 1)))) / 10);
        int hits = 0;
        for (unsigned trial = 0; trial < TRIALS; trial++) {
            uint64_t when;
            make("VR17", &instant, trial + 1);
            struct crt_stroke dot = {.t0 = 10 * cell, .t1 = (10 + CELLS) * cell - 5};
            dot.drive = (float)pow(signal / full, 1 / 2.5);
            hits += inp_pen_stroke(&pen, &dot, &when);
        }
        within_chance(hits, TRIALS, 1 - miss);
    }
}

/* ---- false firings ------------------------------------------------------------------------------ */

static double variance_of(double lux)
{
    double luminance = lux * 0.3 / SLOW_PI, area = SLOW_PI * 1.5 * 1.5;
    double signal =
        luminance * area / 0.3290; /* of white, as a detector flat over the visible sees it */
    return setup.noise.value * setup.noise.value + setup.shot.value * signal;
}

/* Firings of a pen of the raster head before a dark screen. */
static double false_firings(uint64_t until, double *in_first_half)
{
    double count = 0;
    *in_first_half = 0;
    for (uint64_t t = inp_pen_next(&pen); t < until; t = inp_pen_next(&pen))
        if (inp_pen_event(&pen, t)) {
            double turns = (double)t * 1e-12 * setup.lamp.value;
            count++;
            *in_first_half += turns - floor(turns) < 0.5;
        }
    return count;
}

static void room_light_fires_it_as_often_as_its_noise_says(void **state)
{
    static const double rooms[] = {1500, 3000, 6000, 20000, 100000};
    (void)state;
    setup = slow_setup();
    setup.delay.value = 0;
    setup.ripple.value = 0;
    for (unsigned i = 0; i < 5; i++) {
        double half, sigma = sqrt(variance_of(rooms[i])), level = setup.threshold.value / sigma;
        setup.room.value = rooms[i];
        make("COLOR17", crt_phosphor_find("P22"), 7);
        /* It is armed when a cell has been below half the threshold since it last fired. */
        double fires = above(level), arms = 1 - above(level / 2);
        double share = fires * arms / (arms + fires);
        double cells = i < 2 ? 200000 : 20000;
        double found = false_firings((uint64_t)cells * pen.model.cell, &half);
        within_chance(found, cells, share);
    }
}

static void a_dark_room_costs_nothing(void **state)
{
    (void)state;
    setup = slow_setup();
    make("COLOR17", crt_phosphor_find("P22"), 7);
    assert_true(inp_pen_next(&pen) == INP_NEVER);
    setup.room.value = 3000;
    make("COLOR17", crt_phosphor_find("P22"), 7);
    assert_true(inp_pen_next(&pen) < INP_NEVER);
    inp_hand_away(&pen.hand);
    assert_true(inp_pen_next(&pen) == INP_NEVER);
}

/* Office light, 500 lx, doubles the noise and does no harm; the sun does. */
static void rooms_are_as_the_figures_promise(void **state)
{
    double half;
    (void)state;
    setup = slow_setup();
    assert_true(fabs(sqrt(variance_of(500)) / setup.noise.value - 2) < 0.1);
    setup.room.value = 500;
    make("COLOR17", crt_phosphor_find("P22"), 9);
    assert_true(false_firings(50 * MS, &half) == 0);
    setup.room.value = 20000;
    make("COLOR17", crt_phosphor_find("P22"), 9);
    assert_true(false_firings(50 * MS, &half) > 50);
}

/* Lamps on the mains: it fires while they grow brighter. Coupled through 20 us it sees the slope of a
 * sine, which is a sine itself. */
static void lamps_fire_it_in_step_with_the_mains(void **state)
{
    double half, turn = 2 * SLOW_PI * 120 * 20e-6;
    (void)state;
    setup = slow_setup();
    setup.noise.value = 0.5;
    setup.shot.value = 0;
    setup.ripple.value = 0.35;
    double signal = 0.3 / SLOW_PI * SLOW_PI * 1.5 * 1.5 / 0.3290 * 0.35 * turn; /* per lux */
    for (int i = 0; i < 2; i++) {
        setup.room.value = (setup.threshold.value + (i ? 8 : -8)) / signal;
        make("COLOR17", crt_phosphor_find("P22"), 11);
        double found = false_firings(100 * MS, &half);
        if (i == 0)
            assert_true(found == 0);
        else
            assert_true(found >= 12 && found < 40 && half == found);
    }
}

/* Seldom looked at, often looked at: the same pulses. */
static void looking_again_changes_nothing(void **state)
{
    static struct inp_pen other;
    int pulses = 0;
    (void)state;
    setup = slow_setup();
    setup.room.value = 5000;
    make("COLOR17", crt_phosphor_find("P22"), 13);
    other = pen;
    for (uint64_t t = 0; t < 20 * MS; t += 33 * US / 10) { /* events that are none */
        while (inp_pen_next(&pen) <= t) {
            uint64_t next = inp_pen_next(&pen);
            if (!inp_pen_event(&pen, next))
                continue;
            bool seen = false;
            while (!seen && inp_pen_next(&other) <= next)
                seen = inp_pen_event(&other, inp_pen_next(&other));
            assert_true(seen);
            pulses++;
        }
        assert_true(!inp_pen_event(&pen, t));
    }
    assert_true(pulses > 5);
}

/* A pulse on its way when the pen is taken away is not there a second later. */
static void an_old_pulse_is_over(void **state)
{
    (void)state;
    setup = slow_setup();
    make("COLOR17", crt_phosphor_find("P22"), 7);
    static uint8_t dots[1024];
    memset(dots, 255, sizeof dots);
    struct crt_scan_line line = {.t0 = MS,
                                 .t1 = MS + 16 * US,
                                 .x0 = -160,
                                 .x1 = 160,
                                 .dots = 1024,
                                 .guns = 3,
                                 .drive = {dots, dots, dots}};
    for (int late = 0; late < 2; late++) {
        inp_pen_reset(&pen, 0);
        inp_pen_line(&pen, &line);
        uint64_t pulse = inp_pen_next(&pen);
        assert_true(pulse > line.t0 + 8 * US - 2 * US && pulse < line.t0 + 8 * US + 2 * US);
        assert_true(inp_pen_event(&pen, pulse + (late ? 1000 * MS : US)) == !late);
        assert_true(inp_pen_next(&pen) > pulse + US);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hits_are_as_likely_as_the_normal_integral_says),
        cmocka_unit_test(room_light_fires_it_as_often_as_its_noise_says),
        cmocka_unit_test(a_dark_room_costs_nothing),
        cmocka_unit_test(rooms_are_as_the_figures_promise),
        cmocka_unit_test(lamps_fire_it_in_step_with_the_mains),
        cmocka_unit_test(looking_again_changes_nothing),
        cmocka_unit_test(an_old_pulse_is_over),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
