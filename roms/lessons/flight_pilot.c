#include "roms/lessons/flight_pilot.h"

#include <math.h>

#include "roms/geometry/scalar.h"

enum { AIM = 150, HEIGHT = 150, NEAR_WAYPOINT = 350 };

/* A circuit to the left. */
static const struct {
    float x, z;
} waypoints[] = {{0, -2300}, {-900, -2600}, {-1300, -1800}, {-1300, 1700}, {-900, 2600}, {0, 2500}};
enum { WAYPOINTS = sizeof waypoints / sizeof waypoints[0] };

static void hold_path(struct flight *f, float path)
{
    f->stick.pitch = scalar_clamp(f->pitch + 1.2f * (path - f->path), -10 * DEGREE, 14 * DEGREE);
}

static void hold_speed(struct flight *f, float speed)
{
    f->stick.throttle = scalar_clamp(0.45f + 0.12f * (speed - f->speed) + 3 * f->path, 0, 1);
}

static void hold_heading(struct flight *f, float heading)
{
    float turn = flight_turn_to(f->heading, heading);
    f->stick.bank = scalar_clamp(1.6f * turn, -25 * DEGREE, 25 * DEGREE);
}

/* To the runway's middle line. */
static void hold_line(struct flight *f)
{
    hold_heading(f, scalar_clamp(-0.006f * f->at.x, -0.5f, 0.5f));
}

static void approach(struct pilot *p, struct flight *f)
{
    float glide = 3 * DEGREE * (f->at.z + AIM);
    hold_line(f);
    hold_path(f, -3 * DEGREE + scalar_clamp(0.006f * (glide - f->at.y), -0.06f, 0.05f));
    hold_speed(f, 34);
    if (f->at.y < 7)
        p->task = PILOT_FLARE;
}

static void flare(struct pilot *p, struct flight *f)
{
    hold_line(f);
    f->stick.bank = scalar_clamp(f->stick.bank, -5 * DEGREE, 5 * DEGREE);
    hold_path(f, -(0.4f + 0.22f * f->at.y) / fmaxf(f->speed, 10));
    f->stick.throttle = 0;
    if (f->phase == FLIGHT_ROLLING)
        p->task = PILOT_ROLL_OUT;
}

/* The nosewheel keeps the line. */
static void steer(struct flight *f)
{
    float heading = scalar_clamp(-0.02f * f->at.x, -0.1f, 0.1f);
    f->stick.bank = scalar_clamp(2 * flight_turn_to(f->heading, heading), -0.2f, 0.2f);
}

static void roll_out(struct pilot *p, struct flight *f)
{
    steer(f);
    f->stick.pitch = 0;
    f->stick.throttle = 0;
    f->stick.brakes = f->speed < 30;
    if (f->speed < 0.5f)
        p->task = PILOT_TAKE_OFF;
}

static void take_off(struct pilot *p, struct flight *f)
{
    f->stick.throttle = 1;
    f->stick.brakes = false;
    if (f->phase == FLIGHT_ROLLING) {
        steer(f);
        f->stick.pitch = f->speed > 28 ? 9 * DEGREE : 0;
        return;
    }
    hold_line(f);
    hold_path(f, 5 * DEGREE);
    if (f->at.y > 60) {
        p->task = PILOT_CIRCUIT;
        p->waypoint = 0;
    }
}

static void circuit(struct pilot *p, struct flight *f)
{
    float dx = waypoints[p->waypoint].x - f->at.x, dz = waypoints[p->waypoint].z - f->at.z;
    hold_heading(f, atan2f(dx, -dz));
    hold_path(f, scalar_clamp(0.006f * (HEIGHT - f->at.y), -0.06f, 0.09f));
    hold_speed(f, 42);
    f->stick.brakes = false;
    if (dx * dx + dz * dz < NEAR_WAYPOINT * NEAR_WAYPOINT && ++p->waypoint == WAYPOINTS)
        p->task = PILOT_APPROACH;
}

void pilot_takes_over(struct pilot *p, const struct flight *f)
{
    bool ahead =
        f->at.z > 300 && fabsf(f->at.x) < 0.2f * f->at.z && fabsf(f->heading) < 40 * DEGREE;
    *p = (struct pilot){.task = ahead ? PILOT_APPROACH : PILOT_CIRCUIT, .waypoint = 0};
    if (f->phase == FLIGHT_ROLLING)
        p->task = PILOT_ROLL_OUT;
}

void pilot_flies(struct pilot *p, struct flight *f)
{
    static void (*const tasks[])(struct pilot * p, struct flight * f) = {
        [PILOT_APPROACH] = approach, [PILOT_FLARE] = flare,     [PILOT_ROLL_OUT] = roll_out,
        [PILOT_TAKE_OFF] = take_off, [PILOT_CIRCUIT] = circuit,
    };
    if (f->phase == FLIGHT_ROLLING && (p->task == PILOT_APPROACH || p->task == PILOT_CIRCUIT))
        p->task = PILOT_ROLL_OUT;
    tasks[p->task](p, f);
}

const char *pilot_says(const struct pilot *p)
{
    static const char *const says[] = {
        [PILOT_APPROACH] = "on the approach, 3 degrees down",
        [PILOT_FLARE] = "flare: nose up, power off",
        [PILOT_ROLL_OUT] = "roll-out and brakes",
        [PILOT_TAKE_OFF] = "take-off: full power",
        [PILOT_CIRCUIT] = "round the circuit, 150 m up",
    };
    return says[p->task];
}
