#include "roms/solids/plane.h"

struct plane plane_through(struct vector3 p1, struct vector3 p2, struct vector3 p3)
{
    struct plane p;
    p.a = p1.y * (p2.z - p3.z) + p2.y * (p3.z - p1.z) + p3.y * (p1.z - p2.z);
    p.b = p1.z * (p2.x - p3.x) + p2.z * (p3.x - p1.x) + p3.z * (p1.x - p2.x);
    p.c = p1.x * (p2.y - p3.y) + p2.x * (p3.y - p1.y) + p3.x * (p1.y - p2.y);
    p.d = -p1.x * (p2.y * p3.z - p3.y * p2.z) - p2.x * (p3.y * p1.z - p1.y * p3.z) -
          p3.x * (p1.y * p2.z - p2.y * p1.z);
    return p;
}

/* About the first corner, so that a polygon far from the origin loses nothing. */
struct plane plane_of_polygon(const struct object *o, int polygon)
{
    const struct object_polygon *s = &o->polygon[polygon];
    struct vector3 origin = o->vertex[object_corner(o, polygon, 0)], n = {0, 0, 0};
    struct vector3 at = {0, 0, 0};
    for (int i = 1; i < s->count; i++) {
        struct vector3 to = vector3_difference(o->vertex[object_corner(o, polygon, i)], origin);
        n = vector3_sum(n, vector3_cross(at, to));
        at = to;
    }
    return (struct plane){n.x, n.y, n.z, -vector3_dot(n, origin)};
}

struct vector3 plane_normal(const struct plane *p)
{
    return vector3_direction((struct vector3){p->a, p->b, p->c});
}

float plane_value(const struct plane *p, struct vector3 at)
{
    return p->a * at.x + p->b * at.y + p->c * at.z + p->d;
}

bool solid_convex_contains(const struct object *o, struct vector3 at)
{
    for (int i = 0; i < o->polygons; i++) {
        struct plane p = plane_of_polygon(o, i);
        if (plane_value(&p, at) > 0)
            return false;
    }
    return o->polygons > 0;
}
