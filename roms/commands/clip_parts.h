/* clip_parts.h — the command `clip`, a function a form.
 *
 * Models:     each takes what follows its name in `clip NAME …`; see clip.c for the forms.
 * Ownership:  nothing.
 * Errors:     as command.h.
 */
#ifndef ROMS_COMMANDS_CLIP_PARTS_H
#define ROMS_COMMANDS_CLIP_PARTS_H

#include "roms/monitor/monitor.h"

bool clip_point_command(struct monitor *m, struct words *w);
bool clip_cohen_sutherland_command(struct monitor *m, struct words *w);
bool clip_liang_barsky_command(struct monitor *m, struct words *w);
bool clip_polygon_command(struct monitor *m, struct words *w);
bool clip_text_command(struct monitor *m, struct words *w);

#endif
