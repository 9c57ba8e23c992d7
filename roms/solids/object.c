#include "roms/solids/object.h"

void object_clear(struct object *o)
{
    o->vertices = o->edges = o->sides = o->polygons = o->attributes = o->normals = 0;
}

int object_vertex(struct object *o, float x, float y, float z)
{
    if (o->vertices == OBJECT_VERTICES)
        return -1;
    o->vertex[o->vertices] = (struct vector3){x, y, z};
    o->edge_first[o->vertices] = OBJECT_NONE;
    return o->vertices++;
}

int object_attribute(struct object *o, const struct object_attribute *attribute)
{
    if (o->attributes == OBJECT_ATTRIBUTES)
        return -1;
    o->attribute[o->attributes] = *attribute;
    return o->attributes++;
}

int object_edge_between(const struct object *o, int a, int b)
{
    int low = a < b ? a : b, high = a < b ? b : a;
    for (unsigned e = o->edge_first[low]; e != OBJECT_NONE; e = o->edge_next[e])
        if (o->edge[e].vertex[0] == high || o->edge[e].vertex[1] == high)
            return (int)e;
    return -1;
}

/* The edge from a to b, a new one if there is none; -1: no room, or it has two polygons. */
static int edge_for_polygon(struct object *o, int a, int b)
{
    if (a == b)
        return -1;
    int e = object_edge_between(o, a, b), low = a < b ? a : b;
    if (e >= 0)
        return o->edge[e].polygon[1] == OBJECT_NONE ? e : -1;
    if (o->edges == OBJECT_EDGES)
        return -1;
    e = o->edges++;
    o->edge[e] = (struct object_edge){{(uint16_t)a, (uint16_t)b}, {OBJECT_NONE, OBJECT_NONE}};
    o->edge_next[e] = o->edge_first[low];
    o->edge_first[low] = (uint16_t)e;
    return e;
}

int object_polygon(struct object *o, const int *corner, int count, int attribute)
{
    if (count < 3 || count > OBJECT_CORNERS || o->sides + count > OBJECT_SIDES ||
        o->polygons == OBJECT_POLYGONS)
        return -1;
    for (int i = 0; i < count; i++)
        if (corner[i] < 0 || corner[i] >= o->vertices)
            return -1;
    struct object_side *side = &o->side[o->sides];
    for (int i = 0; i < count; i++) {
        int e = edge_for_polygon(o, corner[i], corner[(i + 1) % count]);
        if (e < 0)
            return -1;
        side[i] = (struct object_side){(uint16_t)e, (uint16_t)corner[i]};
    }
    for (int i = 0; i < count; i++) {
        struct object_edge *e = &o->edge[side[i].edge];
        e->polygon[e->polygon[0] != OBJECT_NONE] = (uint16_t)o->polygons;
    }
    o->polygon[o->polygons] =
        (struct object_polygon){(uint16_t)o->sides, (uint16_t)count, (uint16_t)attribute};
    o->sides += count;
    return o->polygons++;
}

void object_transform(struct object *o, int first, const struct matrix4 *m)
{
    for (int i = first; i < o->vertices; i++)
        o->vertex[i] = matrix4_apply(m, o->vertex[i]);
}
