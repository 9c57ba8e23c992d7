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

struct plane plane_of_polygon(const struct object *o, int polygon)
{
    struct plane_sums s = plane_sums_begin(o->vertex[object_corner(o, polygon, 0)]);
    for (int i = 1; i < o->polygon[polygon].count; i++)
        plane_sums_add(&s, o->vertex[object_corner(o, polygon, i)]);
    return plane_at(s.origin, s.normal);
}

struct vector3 plane_normal(const struct plane *p)
{
    return vector3_direction((struct vector3){p->a, p->b, p->c});
}

float plane_value(const struct plane *p, struct vector3 at)
{
    return p->a * at.x + p->b * at.y + p->c * at.z + p->d;
}

int solid_planes_outside(const struct object *o, struct vector3 at, int *first)
{
    int outside = 0;
    for (int i = 0; i < o->polygons; i++) {
        struct plane p = plane_of_polygon(o, i);
        if (plane_value(&p, at) > 0 && outside++ == 0)
            *first = i;
    }
    return outside;
}
