/* object.h — a solid as polygon tables: vertices, edges, polygons, attributes.
 *
 *      V1: x, y, z        E1: V1, V2 ──▶ S1, S2       S1: E1, E2, E3       A1: its colour, what it
 *      V2: x, y, z        E2: V2, V3 ──▶ S1, S5       S2: E3, E4, E5, E6       reflects
 *        ▲  vertices ◀──────┘ edges ◀── reciprocal ──▶  polygons ─────────────▶ attributes
 *
 * Polygons are convex and planar, their corners counter-clockwise seen from outside. object_polygon
 * makes the edges that are not there yet and sets the pointers back from edges to polygons;
 * object_check.h says whether tables from elsewhere are right.
 *
 * Models:     a boundary representation by three lists, with pointers both ways.
 * Cost:       object_polygon looks at the edges of one vertex a corner; a few hundred instructions.
 * Domain:     at most OBJECT_… entries; an edge with more than two polygons is refused.
 * Units:      the caller's; right-handed.
 * Ownership:  plain value of about 135 KB: static storage. Indices count from 0, names from 1.
 * Errors:     what does not fit: -1 or false, and nothing changes but new edges.
 * Source:     J. D. Foley et al., Computer Graphics (1990), section 11.1; B. G. Baumgart, Winged
 *             Edge Polyhedron Representation, Stanford AIM-179 (1972), for the pointers back.
 * Not modelled: polygons with holes, curved faces, textures.
 */
#ifndef ROMS_SOLIDS_OBJECT_H
#define ROMS_SOLIDS_OBJECT_H

#include <stdbool.h>
#include <stdint.h>

#include "roms/geometry/matrix4.h"

/* Room for 1280 triangles or quadrilaterals. */
enum {
    OBJECT_VERTICES = 1536,
    OBJECT_EDGES = 3072,
    OBJECT_POLYGONS = 1536,
    OBJECT_SIDES = 6144, /* of all polygons together */
    OBJECT_NORMALS = 3072,
    OBJECT_ATTRIBUTES = 8,
    OBJECT_CORNERS = 64, /* of one polygon */
    OBJECT_NONE = 0xFFFF
};

struct object_edge {
    uint16_t vertex[2];
    uint16_t polygon[2]; /* OBJECT_NONE: none */
};

/* An edge of a polygon, in the polygon's order. */
struct object_side {
    uint16_t edge;
    uint16_t start; /* the corner that it begins at: one of the edge's vertices */
};

struct object_polygon {
    uint16_t first, count; /* of the sides */
    uint16_t attribute;
};

struct object_attribute {
    const char *name;
    unsigned ramp; /* of colours: enum ink_ramp */
    float ambient, diffuse, specular, shininess;
    float transparency; /* 0: opaque */
};

struct object {
    struct vector3 vertex[OBJECT_VERTICES];
    struct object_edge edge[OBJECT_EDGES];
    struct object_side side[OBJECT_SIDES];
    struct object_polygon polygon[OBJECT_POLYGONS];
    struct object_attribute attribute[OBJECT_ATTRIBUTES];
    int vertices, edges, sides, polygons, attributes;
    /* By object_normals (normals.h). */
    struct vector3 normal[OBJECT_NORMALS];
    uint16_t side_normal[OBJECT_SIDES]; /* the normal at the side's start */
    int normals;
    /* Private: edges by their lower vertex, for object_polygon. */
    uint16_t edge_first[OBJECT_VERTICES], edge_next[OBJECT_EDGES];
};

/* Empty tables. */
void object_clear(struct object *o);
/* The new entry's index; -1: no room. */
int object_vertex(struct object *o, float x, float y, float z);
int object_attribute(struct object *o, const struct object_attribute *attribute);
/* A polygon by its corners, 3…OBJECT_CORNERS: its index; -1: no room, a vertex that there is not,
 * or an edge that already has two polygons. */
int object_polygon(struct object *o, const int *corners, int count, int attribute);
/* The index of the edge between two vertices; -1: none. */
int object_edge_between(const struct object *o, int a, int b);

/* Moves vertices from `first` on. Turn the normals, too, by calling object_normals again. */
void object_transform(struct object *o, int first, const struct matrix4 *m);

/* The corner at which a polygon's side begins. */
static inline int object_corner(const struct object *o, int polygon, int side)
{
    return o->side[o->polygon[polygon].first + side].start;
}

#endif
