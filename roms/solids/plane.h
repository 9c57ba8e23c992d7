/* plane.h — the plane of a polygon, and which side of it a point is on.
 *
 *      A·x + B·y + C·z + D = 0        > 0: outside   ▲ N = (A, B, C)
 *                                     ───────────────┴─────────── corners counter-clockwise seen
 *                                     < 0: inside                      from outside
 *
 * Models:     the plane through three points by Cramer's rule; that of a polygon by Newell's sums,
 *             which takes every corner alike and equals it (times a factor) when the polygon is
 *             planar.
 * Cost:       three points: 9 multiplications for A, B, C and 3 for D; Newell: 6 a corner.
 * Domain:     finite coordinates.
 * Units:      the caller's. The length of N is twice the polygon's area.
 * Ownership:  plain values.
 * Errors:     points on a line: A = B = C = D = 0.
 * Source:     I. E. Sutherland, R. F. Sproull, R. A. Schumacker, ACM Computing Surveys 6 (1974) 1,
 *             for the sums of M. E. Newell.
 */
#ifndef ROMS_SOLIDS_PLANE_H
#define ROMS_SOLIDS_PLANE_H

#include "roms/solids/object.h"

struct plane {
    float a, b, c, d;
};

struct plane plane_through(struct vector3 p1, struct vector3 p2, struct vector3 p3);
struct plane plane_of_polygon(const struct object *o, int polygon);
/* Of length 1; 0 for a plane that is none. */
struct vector3 plane_normal(const struct plane *plane);
/* A·x + B·y + C·z + D: a distance where the normal has length 1. */
float plane_value(const struct plane *plane, struct vector3 p);
/* Is a point inside of the planes of all polygons: within a solid, when that is convex? Points on a
 * face are. */
bool solid_convex_contains(const struct object *o, struct vector3 p);

#endif
