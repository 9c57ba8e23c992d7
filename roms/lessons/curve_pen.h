/* curve_pen.h — what lessons on curves draw beside lines and points: splines, arrows, words.
 *
 * Models:     lines as brush.h has them, letters twice as high; on the vector head its own letters.
 * Units:      stage units (stage.h).
 * Ownership:  nothing.
 * Errors:     none.
 */
#ifndef ROMS_LESSONS_CURVE_PEN_H
#define ROMS_LESSONS_CURVE_PEN_H

#include "roms/curves/cubic_kind.h"
#include "roms/curves/spline.h"
#include "roms/stage/brush.h"

void pen_spline(struct stage *s, const struct spline *spline, enum ink ink);
void pen_arrow(struct stage *s, struct vector3 from, struct vector3 along, enum ink ink);
/* Big letters, about x. */
void pen_words(struct stage *s, float x, float y, enum ink ink, const char *text);
/* Points of a cubic, without repeating the first if there are points already; at most `most`.
 * Returns the new count. */
int pen_collect(const struct vector3 bezier[4], int steps, struct point2 *out, int count, int most);

#endif
