/* rotate_axis.h — rotation about the line through two points.
 *
 *      T    P1 to the origin                     |P2 − P1| direction (a, b, c), of length 1
 *      Rx   about x by α: the line into the      d = √(b² + c²)
 *           xz plane                             sin α = b/d   cos α = c/d   (α = 0 where d = 0)
 *      Ry   about y by −β: the line onto z       sin β = a     cos β = d
 *      Rz   the rotation itself
 *      Ry⁻¹, Rx⁻¹, T⁻¹                           M = T⁻¹ Rx⁻¹ Ry⁻¹ Rz Ry Rx T
 *
 * Models:     the composition in seven steps, each of which can be looked at.
 * Cost:       6 products of matrices, 384 multiplications; 2 square roots, a sine and a cosine.
 * Domain:     points with coordinates up to 1e6 that are at least ROTATE_AXIS_SHORTEST apart, in
 *             any direction, along x, too.
 * Units:      degrees, anticlockwise seen from P2 toward P1.
 * Ownership:  plain values.
 * Errors:     two points that are one point: false, and nothing is written.
 * Source:     D. F. Rogers, J. A. Adams, Mathematical Elements for Computer Graphics (1976).
 */
#ifndef ROMS_GEOMETRY_ROTATE_AXIS_H
#define ROMS_GEOMETRY_ROTATE_AXIS_H

#include <stdbool.h>

#include "roms/geometry/transform3.h"

#define ROTATE_AXIS_SHORTEST 1e-6f

struct rotate_axis {
    struct vector3 direction; /* a, b, c: direction cosines */
    float d;
    float sine_alpha, cosine_alpha, sine_beta, cosine_beta;
    struct transform3 transform;
};

bool rotate_axis(struct vector3 p1, struct vector3 p2, float degrees, struct rotate_axis *out);

#endif
