/* map_relief.h — shaded relief with tints of height, in pixels of the raster head.
 *
 *      pixel ──pipeline, backwards──▶ place in the world ──▶ height, light ──▶ shade of a ramp
 *
 * Models:     heights and light between the grid's nodes by two linear interpolations; four pixels
 *             of a square have one shade.
 * Cost:       about 90 operations a square.
 * Units:      stage units for the viewport.
 * Ownership:  nothing.
 * Errors:     none; without a raster head it does nothing.
 * Not modelled: what is above the island's grid is deep sea.
 */
#ifndef ROMS_LESSONS_MAP_RELIEF_H
#define ROMS_LESSONS_MAP_RELIEF_H

#include "roms/clip/window.h"
#include "roms/geometry/matrix3.h"
#include "roms/lessons/map_terrain.h"
#include "roms/stage/stage.h"

/* `back`: from stage units to the world. */
void map_relief(struct stage *stage, const struct map_terrain *t,
                const struct clip_window *viewport, const struct matrix3 *back);

#endif
