/* light.h — the commands about light, a file for each kind of them.
 *
 * Models:     what roms/commands/light.c puts into its table; they share the studio's lights and
 *             material.
 * Ownership:  nothing.
 * Errors:     as command.h says.
 */
#ifndef ROMS_COMMANDS_LIGHT_H
#define ROMS_COMMANDS_LIGHT_H

#include "roms/monitor/monitor.h"

/* light_lamps.c */
bool light_lights(struct monitor *m, struct words *w);
bool light_material(struct monitor *m, struct words *w);
bool light_fresnel(struct monitor *m, struct words *w);
/* light_point.c */
bool light_illuminate(struct monitor *m, struct words *w);
/* light_shade.c */
bool light_shade(struct monitor *m, struct words *w);
/* light_series.c */
bool light_fast_phong(struct monitor *m, struct words *w);
/* light_eye.c */
bool light_mach(struct monitor *m, struct words *w);
bool light_halftone(struct monitor *m, struct words *w);

#endif
