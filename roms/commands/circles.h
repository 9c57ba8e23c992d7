/* circles.h — the commands of circles and ellipses, for the table in lines.c.
 *
 * Models:     command.h.
 * Domain:     middles within ±2000, radii 0…1000.
 * Ownership:  nothing.
 * Errors:     as command.h.
 */
#ifndef ROMS_COMMANDS_CIRCLES_H
#define ROMS_COMMANDS_CIRCLES_H

#include "roms/monitor/command.h"

bool commands_circle(struct monitor *monitor, struct words *words);
bool commands_circle_side(struct monitor *monitor, struct words *words);
bool commands_ellipse(struct monitor *monitor, struct words *words);

#endif
