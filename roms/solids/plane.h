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

/* Newell's sums, corner by corner, about the first one, so that a polygon far from the origin loses
 * nothing. */
struct plane_sums {
    struct vector3 origin, at; /* the first corner; the last one from there */
    struct vector3 normal;     /* N */
};
static inline struct plane_sums plane_sums_begin(struct vector3 first)
{
    return (struct plane_sums){.origin = first};
}

static inline void plane_sums_add(struct plane_sums *s, struct vector3 corner)
{
    struct vector3 to = vector3_difference(corner, s->origin);
    s->normal = vector3_sum(s->normal, vector3_cross(s->at, to));
    s->at = to;
}

/* The plane through a point with a normal. */
static inline struct plane plane_at(struct vector3 point, struct vector3 normal)
{
    return (struct plane){normal.x, normal.y, normal.z, -vector3_dot(normal, point)};
}

/* Of length 1; 0 for a plane that is none. */
struct vector3 plane_normal(const struct plane *plane);
/* A·x + B·y + C·z + D: a distance where the normal has length 1. */
float plane_value(const struct plane *plane, struct vector3 p);
/* Of how many polygons' planes a point is outside, and the first one of them: of none within a solid
 * when that is convex. Points on a face are inside. */
int solid_planes_outside(const struct object *o, struct vector3 p, int *first);

#endif
