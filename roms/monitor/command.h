/* command.h — the console's language: groups of commands.
 *
 * A command takes its words (words.h), draws between stage_begin and stage_end, and prints with
 * printf. `table` asks whether the working is to be printed; results that are the command's answer are
 * printed anyway.
 *
 * Models:     a table a group; the groups stand in commands.c.
 * Ownership:  static tables.
 * Errors:     run returns false after a words_… function did, or after words_refuse: the monitor then
 *             prints the sentence and the form. It must not draw or print before it has taken and checked
 *             all its words.
 */
#ifndef ROMS_MONITOR_COMMAND_H
#define ROMS_MONITOR_COMMAND_H

#include "roms/monitor/monitor.h"

struct command {
    const char *name;
    const char *form; /* what follows the name: "dda|bresenham x0 y0 x1 y1" */
    const char *what; /* what it does, a line for `help` */
    bool (*run)(struct monitor *monitor, struct words *words);
};

/* Tables end with a name of NULL. */
extern const struct command commands_general[]; /* help, table, lesson, … */
extern const struct command commands_arithmetic[];
extern const struct command commands_lines[]; /* lines, circles, ellipses */
extern const struct command commands_areas[]; /* filling */
extern const struct command commands_clip[];
extern const struct command commands_plane[]; /* 2-D transformations and viewing */
extern const struct command commands_space[]; /* 3-D transformations and projections */
extern const struct command commands_curves[];
extern const struct command commands_solids[];   /* object tables */
extern const struct command commands_surfaces[]; /* visible surfaces */
extern const struct command commands_light[];
extern const struct command commands_segments[]; /* the segmented display file */

/* Carries out a typed line, which is cut up. */
void command_line(struct monitor *monitor, char *line);
/* The command of that name; NULL: there is none. */
const struct command *command_find(const char *name);
/* Calls visit(…) with every command, group after group. */
void command_each(void (*visit)(const struct command *command, void *ctx), void *ctx);

#endif
