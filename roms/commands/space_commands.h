/* space_commands.h — the commands of space that have files of their own, for the table in space.c.
 *
 * Errors:     as command.h says.
 */
#ifndef ROMS_COMMANDS_SPACE_COMMANDS_H
#define ROMS_COMMANDS_SPACE_COMMANDS_H

#include "roms/monitor/command.h"

bool space_viewing(struct monitor *monitor, struct words *words);
bool space_project(struct monitor *monitor, struct words *words);
bool space_clip(struct monitor *monitor, struct words *words);

#endif
