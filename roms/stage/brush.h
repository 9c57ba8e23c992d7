/* brush.h — lines and marks that can be seen from the back of a room.
 *
 * Models:     lines two dots wide on the raster head, discs for points; on the vector head single lines
 *             and lozenges.
 * Units:      stage units (stage.h).
 * Ownership:  nothing.
 * Errors:     none.
 */
#ifndef ROMS_STAGE_BRUSH_H
#define ROMS_STAGE_BRUSH_H

#include "roms/curves/cubic_kind.h"
#include "roms/stage/stage.h"

void brush_thin(struct stage *s, struct vector3 a, struct vector3 b, enum ink ink);
void brush_line(struct stage *s, struct vector3 a, struct vector3 b, enum ink ink);
void brush_path(struct stage *s, const struct vector3 *points, int count, enum ink ink);
/* Wide, adaptive. */
void brush_cubic(struct stage *s, const struct cubic *cubic, enum ink ink);
void brush_bezier(struct stage *s, const struct vector3 *points, int count, enum ink ink);
void brush_point(struct stage *s, struct vector3 at, float radius, enum ink ink);
/* The outline of a square, as handles are shown. */
void brush_square(struct stage *s, struct vector3 at, float half, enum ink ink);
/* Where the stylus is: a cross open in the middle, filled while it touches. */
void brush_cursor(struct stage *s, struct vector3 at, bool pressed);

#endif
