/* The flight simulator's aircraft (roms/lessons/flight_model.h) against closed forms of flight
 * mechanics, and its autopilot: two whole circuits. The sources are compiled for this machine. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include "roms/lessons/flight_model.c"
#include "roms/lessons/flight_pilot.c"

enum { SECOND = 50 }; /* steps */

static void near_to(double value, double expected, double margin)
{
    if (!(fabs(value - expected) <= margin))
        fail_msg("%.6g instead of %.6g", value, expected);
}

/* At a height, level, at a speed. */
static struct flight cruising(float speed)
{
    return (struct flight){
        .at = {0, 1000, 0}, .speed = speed, .phase = FLIGHT_AIRBORNE, .stick = {.throttle = 0.5f}};
}

/* Keeps a path and bank for so many seconds. */
static void keep(struct flight *f, float path, float bank, int seconds)
{
    for (int i = 0; i < seconds * SECOND; i++) {
        hold_path(f, path);
        f->stick.bank = bank;
        flight_step(f);
    }
}

static void level_flight_balances_lift_and_weight(void **state)
{
    (void)state;
    struct flight f = cruising(45);
    keep(&f, 0, 0, 120);
    double q = 0.5 * 1.225 * (double)f.speed * (double)f.speed * 16.2;
    double thrust = 0.5 * fmin(2400, 0.75 * 119000 / (double)f.speed);
    double up = q * (double)flight_lift_coefficient(f.attack) + thrust * sin((double)f.attack);
    near_to(up, 1043 * 9.81, 20);
    near_to(q * (double)flight_drag_coefficient(f.attack), thrust * cos((double)f.attack), 20);
    near_to((double)f.at.y, 1000, 3);
    double lift = 0.31 + 5.14 * 0.1, aspect = 10.9 * 10.9 / 16.2;
    near_to((double)flight_lift_coefficient(0.1f), lift, 1e-5);
    near_to((double)flight_drag_coefficient(0.1f),
            0.031 + lift * lift / (3.14159265 * 0.75 * aspect), 5e-4);
}

/* Without power: sin γ = −D/W, cos γ = L/W. */
static void glides_at_the_angle_of_drag_to_lift(void **state)
{
    (void)state;
    struct flight f = cruising(40);
    f.stick.throttle = 0;
    for (int i = 0; i < 60 * SECOND; i++) {
        f.stick.pitch = 0.02f;
        flight_step(&f);
    }
    double ratio =
        (double)flight_drag_coefficient(f.attack) / (double)flight_lift_coefficient(f.attack);
    near_to(-tan((double)f.path), ratio, 2e-3);
}

/* ψ' = g·tan μ/V in a level turn, but for the part of the thrust. */
static void turns_at_the_rate_of_its_bank(void **state)
{
    (void)state;
    struct flight f = cruising(45);
    keep(&f, 0, 0.4f, 40);
    float before = f.heading;
    keep(&f, 0, 0.4f, 2);
    near_to((double)flight_turn_to(before, f.heading) / 2, 9.81 * tan(0.4) / (double)f.speed, 4e-3);
}

static void stalls_below_the_stalling_speed(void **state)
{
    (void)state;
    double top = 0.31 + 5.14 * 15 * 3.14159265 / 180;
    double slowest = sqrt(2 * 1043 * 9.81 / (1.225 * 16.2 * top));
    struct flight f = cruising(40);
    f.stick.throttle = 0;
    float speed = 0;
    for (int i = 0; i < 60 * SECOND && speed == 0; i++) {
        f.stick.pitch = fminf(f.pitch + 1.5f * (0 - f.path), 0.4f);
        flight_step(&f);
        if (f.stalled)
            speed = f.speed;
    }
    near_to((double)speed, slowest, 1);
    float height = f.at.y;
    keep(&f, 0, 0, 8);
    assert_true(f.at.y < height - 5);
}

static void hard_landings_crash(void **state)
{
    (void)state;
    struct flight f = cruising(35);
    f.at.y = 3;
    f.path = -0.2f; /* 7 m/s down, wings and nose level */
    for (int i = 0; i < SECOND && f.phase == FLIGHT_AIRBORNE; i++)
        flight_step(&f);
    assert_int_equal(f.phase, FLIGHT_CRASHED);
    struct flight still = f;
    flight_step(&f);
    assert_memory_equal(&f, &still, sizeof f);
    assert_true(f.touch > 3);
    f = cruising(35); /* a wing first */
    f.at.y = 0.2f;
    f.path = -0.02f;
    f.bank = f.stick.bank = 0.4f;
    for (int i = 0; i < 2 * SECOND && f.phase == FLIGHT_AIRBORNE; i++)
        flight_step(&f);
    assert_int_equal(f.phase, FLIGHT_CRASHED);
    assert_true(f.touch < 3);
}

static void the_autopilot_lands_and_takes_off_again(void **state)
{
    (void)state;
    struct flight f;
    struct pilot p;
    int landings = 0, take_offs = 0;
    float highest = 0;
    flight_on_approach(&f, 1100, 25);
    pilot_takes_over(&p, &f);
    for (int i = 0; i < 720 * SECOND; i++) {
        enum flight_phase before = f.phase;
        pilot_flies(&p, &f);
        flight_step(&f);
        assert_int_not_equal(f.phase, FLIGHT_CRASHED);
        if (before == FLIGHT_AIRBORNE && f.phase == FLIGHT_ROLLING && f.touch > 0) {
            landings++;
            assert_true(f.touch < 1.5f && flight_over_runway(&f));
        }
        take_offs += before == FLIGHT_ROLLING && f.phase == FLIGHT_AIRBORNE;
        if (f.phase == FLIGHT_ROLLING)
            assert_true(flight_over_runway(&f));
        highest = fmaxf(highest, f.at.y);
    }
    assert_true(landings >= 3 && take_offs >= 2);
    near_to((double)highest, 150, 5);
}

/* Whatever the stick does, the numbers stay finite. */
static void any_stick_can_be_flown(void **state)
{
    (void)state;
    uint32_t random = 1;
    for (int run = 0; run < 200; run++) {
        struct flight f = cruising(40);
        f.at.y = 400;
        for (int i = 0; i < 60 * SECOND; i++) {
            if (i % 40 == 0) {
                random = random * 1664525u + 1013904223u;
                f.stick.pitch = (float)(random >> 8 & 255) / 255 - 0.5f;
                f.stick.bank = (float)(random >> 16 & 255) / 128 - 1;
                f.stick.throttle = (float)(random >> 24) / 255;
                f.stick.brakes = random >> 7 & 1;
            }
            flight_step(&f);
            assert_true(isfinite(f.speed) && isfinite(f.path) && isfinite(f.heading));
            assert_true(isfinite(f.at.x) && f.at.y >= -1 && isfinite(f.at.z) && f.speed < 150);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(level_flight_balances_lift_and_weight),
        cmocka_unit_test(glides_at_the_angle_of_drag_to_lift),
        cmocka_unit_test(turns_at_the_rate_of_its_bank),
        cmocka_unit_test(stalls_below_the_stalling_speed),
        cmocka_unit_test(hard_landings_crash),
        cmocka_unit_test(the_autopilot_lands_and_takes_off_again),
        cmocka_unit_test(any_stick_can_be_flown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
