#include "roms/solids/object_check.h"

static void count_one(uint8_t *counter)
{
    *counter = (uint8_t)(*counter < 2 ? *counter + 1 : 2);
}

void object_check_begin(struct object_check *c, const struct object *o)
{
    c->object = o;
    c->rule = RULE_VERTEX_ENDS;
    c->index = c->polygon = 0;
    for (int i = 0; i < o->vertices; i++)
        c->ends[i] = 0;
    for (int i = 0; i < o->edges; i++) {
        c->uses[i] = 0;
        count_one(&c->ends[o->edge[i].vertex[0]]);
        count_one(&c->ends[o->edge[i].vertex[1]]);
    }
    for (int p = 0; p < o->polygons; p++)
        for (int k = 0; k < o->polygon[p].count; k++)
            count_one(&c->uses[o->side[o->polygon[p].first + k].edge]);
}

/* Every side ends where the next begins. */
static bool is_closed(const struct object *o, int polygon)
{
    int count = o->polygon[polygon].count;
    for (int k = 0; k < count; k++) {
        unsigned from = (unsigned)object_corner(o, polygon, k);
        unsigned to = (unsigned)object_corner(o, polygon, (k + 1) % count);
        const struct object_edge *e = &o->edge[o->side[o->polygon[polygon].first + k].edge];
        if (!(e->vertex[0] == from && e->vertex[1] == to) &&
            !(e->vertex[1] == from && e->vertex[0] == to))
            return false;
    }
    return count >= 3;
}

static bool shares_an_edge(const struct object_check *c, int polygon)
{
    const struct object_polygon *p = &c->object->polygon[polygon];
    for (int k = 0; k < p->count; k++)
        if (c->uses[c->object->side[p->first + k].edge] > 1)
            return true;
    return false;
}

static bool has_edge(const struct object *o, unsigned polygon, int edge)
{
    const struct object_polygon *p = &o->polygon[polygon];
    for (int k = 0; k < p->count; k++)
        if (o->side[p->first + k].edge == edge)
            return true;
    return false;
}

/* A polygon that the edge points to and that lacks it; OBJECT_NONE: none. */
static unsigned wrong_pointer(const struct object *o, int edge)
{
    for (int i = 0; i < 2; i++) {
        unsigned p = o->edge[edge].polygon[i];
        if (p != OBJECT_NONE && !has_edge(o, p, edge))
            return p;
    }
    return OBJECT_NONE;
}

/* Indices count edges first, then sides: each the other half of the rule. */
static bool is_reciprocal(struct object_check *c, int index, struct object_fault *fault)
{
    const struct object *o = c->object;
    if (index < o->edges) {
        fault->index = index;
        fault->other = (int)wrong_pointer(o, index);
        return fault->other == OBJECT_NONE;
    }
    int side = index - o->edges;
    while (side >= o->polygon[c->polygon].first + o->polygon[c->polygon].count)
        c->polygon++;
    const struct object_edge *e = &o->edge[o->side[side].edge];
    fault->index = o->side[side].edge;
    fault->other = c->polygon;
    return e->polygon[0] == c->polygon || e->polygon[1] == c->polygon;
}

static int entries(const struct object *o, enum object_rule rule)
{
    switch (rule) {
    case RULE_VERTEX_ENDS:
        return o->vertices;
    case RULE_EDGE_USED:
        return o->edges;
    case RULE_RECIPROCAL:
        return o->edges + o->sides;
    default:
        return o->polygons;
    }
}

static bool holds(struct object_check *c, int index, struct object_fault *fault)
{
    *fault = (struct object_fault){c->rule, index, 0};
    switch (c->rule) {
    case RULE_VERTEX_ENDS:
        fault->other = c->ends[index];
        return c->ends[index] >= 2;
    case RULE_EDGE_USED:
        return c->uses[index] >= 1;
    case RULE_POLYGON_CLOSED:
        return is_closed(c->object, index);
    case RULE_POLYGON_SHARED:
        return shares_an_edge(c, index);
    default:
        return is_reciprocal(c, index, fault);
    }
}

bool object_check_next(struct object_check *c, struct object_fault *fault)
{
    for (; c->rule < OBJECT_RULES; c->rule++, c->index = 0)
        while (c->index < entries(c->object, c->rule))
            if (!holds(c, c->index++, fault))
                return true;
    return false;
}

const char *object_rule_text(enum object_rule rule)
{
    static const char *const text[OBJECT_RULES] = {
        "every vertex is an end of at least two edges",
        "every edge is part of at least one polygon",
        "every polygon is closed",
        "every polygon has at least one shared edge",
        "pointers between edges and polygons are reciprocal",
    };
    return text[rule];
}
