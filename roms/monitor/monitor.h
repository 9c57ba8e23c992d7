/* monitor.h — the terminal's monitor: what all commands share.
 *
 *      keys ──▶ editor ──line──▶ words ──▶ command ──▶ table on the console, and the transcript
 *                 │                            └─────▶ picture on the stage
 *                 └──▶ menu, pages (shell.c)
 *
 * Models:     the state that commands change for those that follow.
 * Ownership:  one for the program.
 * Errors:     a command that cannot be carried out says one sentence; nothing ends the monitor but
 *             `quit` and the end of input.
 */
#ifndef ROMS_MONITOR_MONITOR_H
#define ROMS_MONITOR_MONITOR_H

#include <stdbool.h>

#include "roms/monitor/words.h"
#include "roms/stage/stage.h"

struct monitor {
    struct stage stage;
    bool table;       /* print the working */
    bool steps;       /* scan conversions go one decision at a time */
    bool left_lesson; /* a command has run a lesson: its picture is not the command's */
};

#endif
