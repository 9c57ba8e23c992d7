/* plane_parts.h — commands of viewing, and what they share with `2d`.
 *
 * Models:     see plane.c for their forms.
 * Ownership:  nothing.
 * Errors:     as command.h.
 */
#ifndef ROMS_COMMANDS_PLANE_PARTS_H
#define ROMS_COMMANDS_PLANE_PARTS_H

#include "roms/commands/plane_picture.h"
#include "roms/monitor/monitor.h"

/* [at x y …] to the end of the line, or the default figure. */
bool plane_take_figure(struct words *w, struct plane_figure *f, bool *given);

bool plane_window(struct monitor *m, struct words *w);
bool plane_view(struct monitor *m, struct words *w);
bool plane_pipeline(struct monitor *m, struct words *w);

#endif
