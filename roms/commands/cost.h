/* cost.h — the command `cost`.
 *
 * Models:     every figure drawn once, between two readings of minstret; one instruction a cycle.
 * Units:      instructions; milliseconds at the board's nominal clock.
 * Errors:     without a raster head, or on a board whose clock is not known, a sentence.
 */
#ifndef ROMS_COMMANDS_COST_H
#define ROMS_COMMANDS_COST_H

#include "roms/monitor/command.h"

bool cost_run(struct monitor *monitor, struct words *words);

#endif
