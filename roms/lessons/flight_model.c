#include "roms/lessons/flight_model.h"

#include <math.h>

#include "roms/geometry/scalar.h"

#define MASS     1043.0f
#define GRAVITY  9.81f
#define DENSITY  1.225f
#define WING     16.2f
#define LIFT_0   0.31f
#define LIFT_A   5.14f
#define DRAG_0   0.031f
#define DRAG_K   0.058f
#define STALL    (15 * DEGREE)
#define THRUST_0 2400.0f
#define POWER    (0.75f * 119000)
#define HARD     3.0f /* m/s that the wheels stand */

float flight_turn_to(float from, float to)
{
    float turn = fmodf(to - from, TURN);
    return turn > PI ? turn - TURN : turn < -PI ? turn + TURN : turn;
}

float flight_lift_coefficient(float attack)
{
    const float top = LIFT_0 + LIFT_A * STALL;
    if (attack > STALL)
        return fmaxf(top - 5 * (attack - STALL), 0.5f);
    return fmaxf(LIFT_0 + LIFT_A * attack, -1.0f);
}

float flight_drag_coefficient(float attack)
{
    float lift = flight_lift_coefficient(attack), over = attack - STALL;
    return DRAG_0 + DRAG_K * lift * lift + (over > 0 ? 0.8f * over : 0);
}

float flight_climb_rate(const struct flight *f)
{
    return f->speed * sinf(f->path);
}

bool flight_over_runway(const struct flight *f)
{
    return fabsf(f->at.x) < RUNWAY_WIDTH / 2 && f->at.z < 0 && f->at.z > -RUNWAY_LENGTH;
}

void flight_on_approach(struct flight *f, float before, float aside)
{
    *f = (struct flight){.at = {aside, 12 + before * 0.0524f, before},
                         .speed = 35,
                         .path = -3 * DEGREE,
                         .phase = FLIGHT_AIRBORNE,
                         .stick = {.throttle = 0.3f}};
}

/* Attitude follows the stick: 0.4 s behind, at most 15 and 40 degrees a second. */
static void follow_stick(struct flight *f)
{
    const float lag = 0.4f;
    float pitch = f->stalled ? fminf(f->stick.pitch, f->pitch - 4 * DEGREE) : f->stick.pitch;
    float bank = f->phase == FLIGHT_ROLLING ? 0 : f->stick.bank;
    if (f->phase == FLIGHT_ROLLING)
        pitch = scalar_clamp(pitch, 0, 12 * DEGREE);
    f->pitch += FLIGHT_STEP * scalar_clamp((pitch - f->pitch) / lag, -15 * DEGREE, 15 * DEGREE);
    f->bank += FLIGHT_STEP * scalar_clamp((bank - f->bank) / lag, -40 * DEGREE, 40 * DEGREE);
}

/* Forces along and across the path. */
struct forces {
    float thrust, lift, drag;
};

static struct forces forces(const struct flight *f)
{
    float q = 0.5f * DENSITY * f->speed * f->speed * WING;
    return (struct forces){f->stick.throttle * fminf(THRUST_0, POWER / fmaxf(f->speed, 1)),
                           q * flight_lift_coefficient(f->attack),
                           q * flight_drag_coefficient(f->attack)};
}

static void fly(struct flight *f, struct forces n)
{
    float up = n.lift + n.thrust * sinf(f->attack);
    float v = fmaxf(f->speed, 1);
    float speed = (n.thrust * cosf(f->attack) - n.drag) / MASS - GRAVITY * sinf(f->path);
    float path = (up * cosf(f->bank) / MASS - GRAVITY * cosf(f->path)) / v;
    float heading = up * sinf(f->bank) / (MASS * v * cosf(f->path));
    f->speed = fmaxf(f->speed + FLIGHT_STEP * speed, 1);
    f->path = scalar_clamp(f->path + FLIGHT_STEP * path, -70 * DEGREE, 70 * DEGREE);
    f->heading = flight_turn_to(0, f->heading + FLIGHT_STEP * heading);
}

static void roll(struct flight *f, struct forces n)
{
    const float wheelbase = 1.7f, sideways = 2; /* m/s² that the tyres hold */
    float weight = fmaxf(MASS * GRAVITY - n.lift, 0);
    float friction = (flight_over_runway(f) ? 0.03f : 0.08f) + (f->stick.brakes ? 0.3f : 0);
    float push = n.thrust - n.drag;
    float pull = friction * weight;
    f->speed = fmaxf(f->speed + FLIGHT_STEP * (push - pull) / MASS, 0);
    float turn = f->speed * tanf(scalar_clamp(f->stick.bank, -0.5f, 0.5f) * 0.3f) / wheelbase;
    float most = sideways / fmaxf(f->speed, 1);
    f->heading = flight_turn_to(0, f->heading + FLIGHT_STEP * scalar_clamp(turn, -most, most));
    f->path = 0;
    if (n.lift + n.thrust * sinf(f->attack) > MASS * GRAVITY)
        f->phase = FLIGHT_AIRBORNE;
}

static void touch(struct flight *f)
{
    f->touch = -flight_climb_rate(f);
    bool wings_level = fabsf(f->bank) < 12 * DEGREE;
    bool soft = f->touch < HARD && f->pitch > -4 * DEGREE && wings_level;
    f->phase = soft ? FLIGHT_ROLLING : FLIGHT_CRASHED;
    f->at.y = 0;
    f->path = 0;
    f->bank = 0;
}

void flight_step(struct flight *f)
{
    if (f->phase == FLIGHT_CRASHED)
        return;
    follow_stick(f);
    f->attack = scalar_clamp((f->pitch - f->path) / fmaxf(cosf(f->bank), 0.3f), -0.5f, 0.8f);
    f->stalled = f->phase == FLIGHT_AIRBORNE && f->attack > STALL;
    struct forces n = forces(f);
    if (f->phase == FLIGHT_ROLLING)
        roll(f, n);
    else
        fly(f, n);
    float along = FLIGHT_STEP * f->speed * cosf(f->path);
    f->at.x += along * sinf(f->heading);
    f->at.z -= along * cosf(f->heading);
    f->at.y += FLIGHT_STEP * flight_climb_rate(f);
    if (f->at.y < 0 && f->phase == FLIGHT_AIRBORNE)
        touch(f);
}
