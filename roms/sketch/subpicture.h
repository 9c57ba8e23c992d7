/* subpicture.h — a selection becomes a subpicture, and a copy of it stands in its place.
 *
 * Models:     the figures go into a picture of their own; points that others share stay there, and
 *             the figures get points of their own at the same places. The origin is their lowest point
 *             of those farthest to the left.
 * Ownership:  changes the drawing.
 * Errors:     a status; what fails changes nothing.
 * Source:     I. E. Sutherland, Sketchpad (MIT, 1963): masters and instances.
 */
#ifndef ROMS_SKETCH_SUBPICTURE_H
#define ROMS_SKETCH_SUBPICTURE_H

#include "roms/sketch/drawing.h"

/* Figures of `picture` that are selected. *master: its number; *copy: the figure in its place. */
enum drawing_status subpicture_define(struct drawing *d, int picture,
                                      const bool selected[DRAWING_FIGURES], int *master, int *copy);
/* The subpicture that comes after this one, round; 0: there is none. */
int subpicture_next(const struct drawing_state *s, int master);
/* Copies of it in all pictures. */
int subpicture_copies(const struct drawing_state *s, int master);

#endif
