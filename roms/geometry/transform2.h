/* transform2.h — transformations of the plane as matrices.
 *
 *      translate      rotate anticlockwise       scale           shear x
 *      | 1 0 tx |     | cos θ  −sin θ  0 |       | sx 0  0 |     | 1 k −k·y0 |
 *      | 0 1 ty |     | sin θ   cos θ  0 |       | 0  sy 0 |     | 0 1   0   |
 *      | 0 0 1  |     |   0       0    1 |       | 0  0  1 |     | 0 0   1   |
 *
 *      about a point: T(x, y) · M · T(−x, −y); first: rightmost (matrix3.h)
 *
 * Models:     the elementary transformations, those about a point or a line, composition.
 * Cost:       a matrix takes at most 8 multiplications and, where an angle stands, a sine and a
 *             cosine; a point then takes 4 multiplications and 4 additions, whatever was composed.
 * Domain:     any finite values; scaling by 0 has no inverse.
 * Units:      angles in degrees, anticlockwise positive; lengths the caller's.
 * Ownership:  plain values.
 * Errors:     none. Sines and cosines of multiples of 90° are 0, 1 and −1 exactly.
 * Source:     A. F. Möbius, Der barycentrische Calcul (1827), for homogeneous coordinates; L. G.
 *             Roberts, MIT Lincoln Laboratory MS-1405 (1965), for their use in computer graphics.
 */
#ifndef ROMS_GEOMETRY_TRANSFORM2_H
#define ROMS_GEOMETRY_TRANSFORM2_H

#include "roms/geometry/matrix3.h"

enum mirror2 { MIRROR_X_AXIS, MIRROR_Y_AXIS, MIRROR_ORIGIN, MIRROR_Y_IS_X, MIRROR_Y_IS_MINUS_X };

struct matrix3 transform2_translate(float tx, float ty);
struct matrix3 transform2_rotate(float degrees);
struct matrix3 transform2_scale(float sx, float sy);
struct matrix3 transform2_reflect(enum mirror2 mirror);
/* x' = x + k (y − y0); y' = y + k (x − x0). */
struct matrix3 transform2_shear_x(float k, float y0);
struct matrix3 transform2_shear_y(float k, float x0);

/* About a pivot; about a fixed point. */
struct matrix3 transform2_rotate_about(float degrees, struct point2 pivot);
struct matrix3 transform2_scale_about(float sx, float sy, struct point2 fixed);
/* In the line y = mx + c; in x = k; in y = k. */
struct matrix3 transform2_reflect_line(float m, float c);
struct matrix3 transform2_reflect_x_is(float k);
struct matrix3 transform2_reflect_y_is(float k);

/* First one, then the other. */
struct matrix3 transform2_then(const struct matrix3 *first, const struct matrix3 *second);

#endif
