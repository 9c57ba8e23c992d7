/* surface_picture.h — pictures of a scene by each method, the same on every board.
 *
 *      scene ──method──▶ SURFACE_WIDTH × SURFACE_HEIGHT pixels ──▶ into the stage's picture
 *
 * Models:     two pictures in memory, so that methods can be compared where there is no head.
 * Units:      pixels.
 * Ownership:  static storage.
 * Errors:     surface_scene: false when something is too near to the eye.
 */
#ifndef ROMS_COMMANDS_SURFACE_PICTURE_H
#define ROMS_COMMANDS_SURFACE_PICTURE_H

#include "roms/commands/solids.h"
#include "roms/scenery/workroom.h"
#include "roms/visible/surface_scan.h"

enum { SURFACE_WIDTH = 600, SURFACE_HEIGHT = 400 };
enum surface_method {
    METHOD_DEPTH_BUFFER,
    METHOD_SCAN_LINE,
    METHOD_PAINTER,
    METHOD_LINES,
    METHOD_FROM_0,
    METHOD_ALL /* as they come in the list: no method */
};
/* By their numbers; ends with NULL. */
extern const char *const surface_methods[];

/* The scene in pixels and in stage units, in the workroom. */
bool surface_scene(enum scene_which which, const struct look *look);
uint8_t *surface_pixels(int picture);
void surface_draw(const struct scene *scene, enum surface_method method, int picture);
/* Picture 0 on the raster head, lines on the vector head. */
void surface_show(struct monitor *m, enum surface_method method, const char *title);

#endif
