/* solids.h — the present object's view, for the commands about solids and visible surfaces.
 *
 * Models:     from where the present object is looked at.
 * Units:      degrees; the eye's distance in reaches of the object, 0: parallel.
 * Ownership:  static storage.
 * Errors:     none.
 */
#ifndef ROMS_COMMANDS_SOLIDS_H
#define ROMS_COMMANDS_SOLIDS_H

#include "roms/monitor/monitor.h"
#include "roms/solids/object.h"

struct look {
    float yaw, pitch, eye;
};

struct look *present_look(void);
/* An object's wireframe on both heads. */
void draw_object(struct monitor *m, const struct object *o, const char *title);

#endif
