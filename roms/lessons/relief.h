/* relief.h — a field as a relief: lit, heights in colours, contour lines, legend.
 *
 *      raster head: triangles, cut at the levels, each part in the ramp of its heights
 *      vector head: the contour lines themselves, in perspective
 *
 * Models:     hypsometric tints; contour lines as the cuts of the levels with the triangles of the
 *             grid.
 * Cost:       about 400 instructions a triangle and 16 a pixel.
 * Units:      stage units; heights as the field has them.
 * Ownership:  plain value of about 200 KB: static storage.
 * Errors:     none.
 * Source:     W. E. Lorensen, H. E. Cline, Computer Graphics 21 (1987) 163, in the plane.
 */
#ifndef ROMS_LESSONS_RELIEF_H
#define ROMS_LESSONS_RELIEF_H

#include "roms/lessons/field.h"
#include "roms/light/mesh.h"
#include "roms/stage/stage.h"

enum { RELIEF_BANDS = 5 };

struct relief {
    struct mesh mesh;
    struct mesh_view view;
    struct lighting lighting;
    struct material material;
};

/* Draws it, turned by `yaw` degrees. */
void relief_draw(struct relief *r, struct stage *stage, const struct field *field, float yaw);

#endif
