/* curve_pen.h — curves and points that can be seen from the back of a room.
 *
 * Models:     lines two dots wide on the raster head, discs for points, letters twice as high; on
 *             the vector head single lines, crosses and its own letters.
 * Units:      stage units (stage.h).
 * Ownership:  nothing.
 * Errors:     none.
 */
#ifndef ROMS_LESSONS_CURVE_PEN_H
#define ROMS_LESSONS_CURVE_PEN_H

#include "roms/curves/cubic_kind.h"
#include "roms/curves/spline.h"
#include "roms/stage/stage.h"

void pen_line(struct stage *s, struct vector3 a, struct vector3 b, enum ink ink);
void pen_thin(struct stage *s, struct vector3 a, struct vector3 b, enum ink ink);
void pen_polyline(struct stage *s, const struct vector3 *points, int count, enum ink ink);
void pen_bezier(struct stage *s, const struct vector3 *points, int count, enum ink ink);
void pen_cubic(struct stage *s, const struct cubic *cubic, enum ink ink);
void pen_spline(struct stage *s, const struct spline *spline, enum ink ink);
/* `radius` in stage units. */
void pen_point(struct stage *s, struct vector3 at, float radius, enum ink ink);
void pen_arrow(struct stage *s, struct vector3 from, struct vector3 along, enum ink ink);
/* Big letters, about x. */
void pen_words(struct stage *s, float x, float y, enum ink ink, const char *text);
/* Points of a cubic, without repeating the first if there are points already; at most `most`.
 * Returns the new count. */
int pen_collect(const struct vector3 bezier[4], int steps, struct point2 *out, int count, int most);

#endif
