/* expand.h — a picture as the lines, circles and arcs that it shows, those of copies where they are.
 *
 *      copy of A at p, turned, scaled ──▶ each figure of A:  p' = p + s·R(θ)·(p − origin of A)
 *
 * Models:     copies within copies: their transformations, which all keep shapes, are multiplied.
 * Units:      stage units.
 * Ownership:  plain values.
 * Errors:     none: subpictures never show themselves (drawing.h), so this ends.
 * Source:     I. E. Sutherland, Sketchpad (MIT, 1963): instances.
 */
#ifndef ROMS_SKETCH_EXPAND_H
#define ROMS_SKETCH_EXPAND_H

#include "roms/geometry/vector.h"
#include "roms/sketch/drawing.h"

/* x' = a x − b y + x, y' = b x + a y + y. */
struct pose {
    float a, b, x, y;
};

struct stroke {
    enum figure_kind kind; /* line, circle or arc; a copy itself: only its place */
    int figure;            /* of the picture: that it is, or that it is a part of */
    bool inner;            /* it is a part of a copy */
    struct point2 at[DRAWING_ENDS];
    int point[DRAWING_ENDS]; /* of the picture; -1: inner */
};

typedef void (*stroke_taker)(void *ctx, const struct stroke *stroke);

struct point2 place_in_units(struct place p);
struct place place_of_units(float x, float y);

struct pose pose_of_copy(const struct drawing_state *s, const struct figure *copy);
struct point2 pose_apply(const struct pose *pose, struct point2 p);
/* First b, then a. */
struct pose pose_product(const struct pose *a, const struct pose *b);

/* One figure of a picture; all of them. */
void expand_figure(const struct drawing_state *s, int figure, stroke_taker take, void *ctx);
void expand_picture(const struct drawing_state *s, int picture, stroke_taker take, void *ctx);

/* ---- the geometry of strokes ----------------------------------------------------------------- */

float stroke_radius(const struct stroke *stroke);
/* Of an arc: where it begins, radians; how far it goes anticlockwise, above 0, at most a turn. */
void stroke_arc(const struct stroke *stroke, float *begin, float *sweep);
/* The place on the stroke that is nearest to p, and how far that is. */
float stroke_nearest(const struct stroke *stroke, struct point2 p, struct point2 *on);

#endif
