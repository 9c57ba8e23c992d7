/* back_face.h — which polygons of a solid look away from the viewer.
 *
 *      parallel:  back face if V · N > 0        perspective:  visible if A·Ex + B·Ey + C·Ez + D > 0
 *
 *           ──V──▶ ┌──┐ ──N──▶                       E ·┐      the eye is outside of the polygon's
 *          front   └──┘  back                           └─▶ │   plane
 *
 * The sign of D does not do: with the origin within the solid and normals outward, D < 0 for every
 * polygon, whichever way it looks. D says on which side of the plane the origin is, and the origin
 * is not the eye.
 *
 * Models:     the tests for closed solids; a convex one alone needs nothing else.
 * Cost:       3 multiplications, 2 additions, a comparison.
 * Domain:     normals outward; V from the eye into the scene. Edge-on (V · N = 0) is no back face;
 *             it shows nothing.
 * Units:      the caller's.
 * Ownership:  plain values.
 * Errors:     none.
 * Source:     elementary.
 */
#ifndef ROMS_VISIBLE_BACK_FACE_H
#define ROMS_VISIBLE_BACK_FACE_H

#include "roms/solids/plane.h"

static inline bool back_face_parallel(struct vector3 normal, struct vector3 viewing)
{
    return vector3_dot(viewing, normal) > 0;
}

static inline bool back_face_perspective(const struct plane *plane, struct vector3 eye)
{
    return plane_value(plane, eye) <= 0;
}

#endif
