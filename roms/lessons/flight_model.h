/* flight_model.h — a light aircraft as a point with lift, drag, thrust and weight.
 *
 *      m·V' = T·cos α − D − m·g·sin γ            V speed, γ flight-path angle, ψ heading
 *      m·V·γ' = (L + T·sin α)·cos μ − m·g·cos γ  μ bank, α angle of attack = (θ − γ)/cos μ
 *      m·V·cos γ·ψ' = (L + T·sin α)·sin μ        θ pitch attitude
 *      x' = V·cos γ·sin ψ   z' = −V·cos γ·cos ψ   y' = V·sin γ
 *      L = ½ρV²·S·CL(α)     D = ½ρV²·S·(CD0 + k·CL²)     T = throttle · min(T0, η·P/V)
 *
 *      CL = CL0 + a·α up to the stall at 15 degrees; beyond it CL falls, CD grows, the nose drops
 *
 * Models:     flight over a plane earth in still air; the pilot's attitude in pitch and bank, which
 *             follows the stick with a lag (in place of moments and inertia); rolling, steering and
 *             braking on the ground; touch-down or crash.
 * Cost:       a dozen sines and cosines a step of FLIGHT_STEP.
 * Units:      metres, seconds, radians, newtons. x east, y up, z south; heading 0 is north (−z),
 *             clockwise.
 * Ownership:  plain values.
 * Errors:     none; angles and speed are kept within what the equations stand (V >= 1 m/s in the
 *             air).
 * Source:     equations: N. X. Vinh, Flight Mechanics of High-Performance Aircraft (1993). CL0
 *             0.31, a 5.14, CD0 0.031: a light single-engined aircraft in J. Roskam, Airplane
 *             Flight Dynamics and Automatic Flight Controls (1979); S 16.2 m², b 10.9 m, P 119 kW:
 *             such an aircraft's data sheet. Mass 1043 kg, k = 1/(π·e·b²/S) with e 0.75, η 0.75,
 *             T0 2400 N, stall, lags, friction: estimates.
 * Not modelled: moments, side-slip, propeller torque, wind, fuel, flaps, density by height.
 */
#ifndef ROMS_LESSONS_FLIGHT_MODEL_H
#define ROMS_LESSONS_FLIGHT_MODEL_H

#include <stdbool.h>

#include "roms/geometry/scalar.h"
#include "roms/geometry/vector.h"

#define FLIGHT_STEP 0.02f
/* The runway: from the threshold at the origin to the north. */
enum { RUNWAY_LENGTH = 1200, RUNWAY_WIDTH = 30 };

/* What the pilot asks for. */
struct flight_stick {
    float pitch, bank; /* attitude; on the ground bank steers */
    float throttle;    /* 0…1 */
    bool brakes;
};

enum flight_phase { FLIGHT_AIRBORNE, FLIGHT_ROLLING, FLIGHT_CRASHED };

struct flight {
    struct vector3 at; /* of the wheels */
    float speed, path, heading;
    float pitch, bank;
    float attack; /* α */
    float touch;  /* sink rate at the last touch-down */
    bool stalled;
    enum flight_phase phase;
    struct flight_stick stick;
};

/* On the approach to the runway, so far before the threshold and so far to the side. */
void flight_on_approach(struct flight *f, float before, float aside);
void flight_step(struct flight *f);
float flight_climb_rate(const struct flight *f);
bool flight_over_runway(const struct flight *f);
/* Lift and drag coefficients. */
float flight_lift_coefficient(float attack);
float flight_drag_coefficient(float attack);
/* Heading `to` seen from heading `from`: −π…π. */
float flight_turn_to(float from, float to);

#endif
