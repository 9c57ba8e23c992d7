/* flight_panel.h — the instruments: airspeed, attitude, altitude, climb, heading, throttle.
 *
 * Models:     dials with a needle and a figure; an artificial horizon.
 * Units:      metres a second, metres, degrees, as shown. Stage units.
 * Ownership:  plain values.
 * Errors:     none.
 */
#ifndef ROMS_LESSONS_FLIGHT_PANEL_H
#define ROMS_LESSONS_FLIGHT_PANEL_H

#include "roms/lessons/flight_model.h"
#include "roms/stage/stage.h"

void flight_panel(struct stage *stage, const struct flight *f);

#endif
