/* flight_pilot.h — an autopilot that flies circuits: approach, landing, take-off, round again.
 *
 *      approach ▶ flare ▶ roll-out ▶ take-off ▶ waypoints of a left-hand circuit ▶ approach
 *
 * Models:     proportional control of path by pitch, of speed by throttle, of heading by bank.
 * Ownership:  plain value beside the aircraft's.
 * Errors:     none. From any place it flies to the next waypoint.
 * Source:     gains by trial.
 */
#ifndef ROMS_LESSONS_FLIGHT_PILOT_H
#define ROMS_LESSONS_FLIGHT_PILOT_H

#include "roms/lessons/flight_model.h"

enum pilot_task { PILOT_APPROACH, PILOT_FLARE, PILOT_ROLL_OUT, PILOT_TAKE_OFF, PILOT_CIRCUIT };

struct pilot {
    enum pilot_task task;
    int waypoint;
};

/* Begins with what suits where the aircraft is. */
void pilot_takes_over(struct pilot *p, const struct flight *f);
/* Moves the stick; once a FLIGHT_STEP. */
void pilot_flies(struct pilot *p, struct flight *f);
const char *pilot_says(const struct pilot *p);

#endif
