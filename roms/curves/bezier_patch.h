/* bezier_patch.h — surfaces of 4 by 4 control points.
 *
 *      p30 ·──·──·──· p33       p(u,v) = Σ Σ p_jk · BEZ_j,3(u) · BEZ_k,3(v)
 *          │  │  │  │           u: from row 0 to row 3; v: along a row
 *        u ▲──·──·──·
 *          │  │  │  │           for a fixed u (or v) it is a cubic Bézier curve
 *      p00 ·──·─▶·──· p03
 *                v
 *
 * Models:     points, normals, the curves of constant u and v.
 * Cost:       a point: 16 + 4 products of a vector; a normal: two curves' derivatives and a cross
 *             product; a curve of constant u or v: 16 products, then a cubic's cost.
 * Domain:     u and v within 0…1.
 * Units:      the caller's.
 * Ownership:  plain values.
 * Errors:     where a tangent vanishes (control points that coincide) the normal is that of a
 *             place a little further in; a patch without area has the normal 0.
 * Source:     P. Bézier, Numerical Control: Mathematics and Applications (1972).
 */
#ifndef ROMS_CURVES_BEZIER_PATCH_H
#define ROMS_CURVES_BEZIER_PATCH_H

#include "roms/geometry/vector.h"

struct bezier_patch {
    struct vector3 at[4][4];
};

struct vector3 bezier_patch_point(const struct bezier_patch *patch, float u, float v);
/* ∂p/∂v × ∂p/∂u, of length 1: toward +z where v runs along +x and u along +y. */
struct vector3 bezier_patch_normal(const struct bezier_patch *patch, float u, float v);
/* The control points of a curve of constant u (running along v) or constant v (running along u). */
void bezier_patch_along_v(const struct bezier_patch *patch, float u, struct vector3 curve[4]);
void bezier_patch_along_u(const struct bezier_patch *patch, float v, struct vector3 curve[4]);

#endif
