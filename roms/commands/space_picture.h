/* space_picture.h — pictures of the commands of space: figures in an axonometric view, matrices
 * beside them.
 *
 *      ┌───────────────────┬─────────┐
 *      │ axes, the figure  │ matrix  │
 *      │ before and after  │         │
 *      └───────────────────┴─────────┘
 *
 * Units:      stage units.
 * Ownership:  plain values.
 * Errors:     none.
 */
#ifndef ROMS_COMMANDS_SPACE_PICTURE_H
#define ROMS_COMMANDS_SPACE_PICTURE_H

#include "roms/commands/space_words.h"
#include "roms/scenery/space_solid.h"

/* A matrix as four rows, under its name, the upper left corner at x, y. */
void space_matrix(struct stage *stage, float x, float y, const char *name, const struct matrix4 *m);
/* Points joined: one is a marker, more a line, three and more a polygon. With plumb lines to the
 * ground plane y = 0 if wanted. */
void space_figure(const struct space_view *view, const struct space_points *points, bool plumb);
/* A view that shows these points and the axes in the left part of the picture. */
struct space_scene {
    struct space_view view;
    float axes;    /* how long to draw them */
    bool negative; /* and whether both ways */
};
struct space_scene space_scene(struct stage *stage, const struct matrix4 *projection, float width,
                               const struct vector3 *points, int count);

#endif
