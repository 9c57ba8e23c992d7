/* curve.h — the curve that a model describes, whatever its kind: pieces with Bézier control points.
 *
 *      Bézier    one piece of any degree             natural   each piece's slopes as handles
 *      pieces    handles are the inner controls      B-spline  means of four points each
 *
 *      t: knot[0] ──piece 0── knot[1] ──piece 1── knot[2] … knot[pieces];   u = (t − t_i)/h_i
 *
 * Models:     points, derivatives with respect to t, curvature κ = (x′y″ − y′x″)/|p′|³ (positive: it
 *             bends to the left); joints between pieces, that of a closed curve with itself too; the
 *             nearest point; length by Simpson's rule.
 * Domain:     what curve_of takes. All pieces have `order` control points.
 * Units:      stage units; κ a stage unit.
 * Ownership:  plain values.
 * Errors:     curve_of: a sentence why there is no curve; NULL: there is one. Where a curve stands still
 *             κ is 0.
 * Source:     bezier.h, spline.h, periodic.h.
 */
#ifndef ROMS_SPLINE_CURVE_H
#define ROMS_SPLINE_CURVE_H

#include "roms/curves/b_spline.h"
#include "roms/spline/model.h"

enum { CURVE_PIECES_MOST = MODEL_POINTS_MOST, CURVE_CONTROLS = 4 * CURVE_PIECES_MOST };

struct curve {
    int pieces, order;
    bool closed;
    float knot[CURVE_PIECES_MOST + 1];
    struct vector3 control[CURVE_CONTROLS];
};

struct curve_place {
    struct vector3 at, first, second;
    float curvature;
    int piece;
    float u; /* within the piece */
};

const char *curve_of(const struct model *model, struct curve *curve);
const struct vector3 *curve_piece(const struct curve *curve, int piece);
/* 0 is the beginning, 1 the end. */
float curve_t(const struct curve *curve, float part);
/* t beyond the ends is moved to them. */
struct curve_place curve_at(const struct curve *curve, float t);

/* Joints: of piece i with the next; of a closed curve the last one with the first. */
int curve_joints(const struct curve *curve);
struct join curve_join(const struct curve *curve, int joint);

/* The part of the way, 0…1 (curve_t), whose point is nearest to a place. */
float curve_nearest(const struct curve *curve, struct vector3 place, float *distance);
float curve_length(const struct curve *curve);

/* Of a B-spline, its points and knots as roms/curves/b_spline.h has them; false: the model is none. */
bool curve_b_spline(const struct model *model, struct b_spline *out);

#endif
