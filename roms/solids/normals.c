#include "roms/solids/normals.h"

#include "roms/solids/plane.h"

/* The sides that begin at a vertex without a crease between their polygons form a group. A group is
 * a chain in o->side_normal that ends at its lowest side. */
static unsigned group_of(const struct object *o, unsigned side)
{
    while (o->side_normal[side] != side)
        side = o->side_normal[side];
    return side;
}

static void join(struct object *o, unsigned a, unsigned b)
{
    a = group_of(o, a);
    b = group_of(o, b);
    o->side_normal[a > b ? a : b] = (uint16_t)(a > b ? b : a);
}

/* The side of a polygon that begins at a vertex; OBJECT_NONE: it has no such corner. */
static unsigned side_at(const struct object *o, unsigned polygon, unsigned vertex)
{
    const struct object_polygon *p = &o->polygon[polygon];
    for (unsigned side = p->first; side < (unsigned)p->first + p->count; side++)
        if (o->side[side].start == vertex)
            return side;
    return OBJECT_NONE;
}

static void join_at(struct object *o, const struct object_edge *e, unsigned vertex)
{
    unsigned a = side_at(o, e->polygon[0], vertex), b = side_at(o, e->polygon[1], vertex);
    if (a != OBJECT_NONE && b != OBJECT_NONE)
        join(o, a, b);
}

static struct vector3 polygon_normal(const struct object *o, int polygon)
{
    struct plane p = plane_of_polygon(o, polygon);
    return plane_normal(&p);
}

static void join_smooth_edges(struct object *o, float crease_cosine)
{
    for (int i = 0; i < o->edges; i++) {
        const struct object_edge *e = &o->edge[i];
        if (e->polygon[1] == OBJECT_NONE)
            continue;
        struct vector3 a = polygon_normal(o, e->polygon[0]), b = polygon_normal(o, e->polygon[1]);
        if (vector3_dot(a, b) <= crease_cosine)
            continue;
        join_at(o, e, e->vertex[0]);
        join_at(o, e, e->vertex[1]);
    }
}

/* Gives each group a normal, in the order of the sides: a group's lowest side comes first. */
static bool number_groups(struct object *o)
{
    int count = 0;
    for (int i = 0; i < o->sides; i++)
        count += o->side_normal[i] == i;
    if (count > OBJECT_NORMALS)
        return false;
    for (int i = 0; i < o->sides; i++)
        o->side_normal[i] = (uint16_t)group_of(o, (unsigned)i);
    for (int i = 0; i < o->sides; i++) {
        if (o->side_normal[i] == i) {
            o->normal[o->normals] = (struct vector3){0, 0, 0};
            o->side_normal[i] = (uint16_t)o->normals++;
        } else {
            o->side_normal[i] = o->side_normal[o->side_normal[i]];
        }
    }
    return true;
}

bool object_normals(struct object *o, float crease_cosine)
{
    o->normals = 0;
    for (int i = 0; i < o->sides; i++)
        o->side_normal[i] = (uint16_t)i;
    join_smooth_edges(o, crease_cosine);
    if (!number_groups(o))
        return false;
    for (int p = 0; p < o->polygons; p++) {
        struct vector3 n = polygon_normal(o, p);
        for (int k = 0; k < o->polygon[p].count; k++) {
            struct vector3 *sum = &o->normal[o->side_normal[o->polygon[p].first + k]];
            *sum = vector3_sum(*sum, n);
        }
    }
    for (int i = 0; i < o->normals; i++)
        o->normal[i] = vector3_direction(o->normal[i]);
    return true;
}
