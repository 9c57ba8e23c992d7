/* scene.h — polygons after projection, which all methods for visible surfaces take.
 *
 *      object ──view──▶ vertices (x, y, z): x, y on the picture, z larger where nearer
 *                       surfaces: corners, colour, plane A·x + B·y + C·z + D = 0 of these
 *             coordinates           edges:    between two surfaces, or at the rim of one
 *
 * A perspective moves z as it moves x and y, z' = z·d/(d − z), so that planes stay planes and a
 * line's depth is linear along the picture.
 *
 * Models:     a list of convex planar polygons. Rules that make methods agree: a pixel belongs to a
 *             surface when its middle does, on a left or upper edge, too (scan_edge.h); of equal
 *             depths the surface that comes first in the list is shown.
 * Cost:       about 700 instructions a polygon of four corners, 840 when it is not left out.
 * Domain:     vertices in front of the eye: z < d.
 * Units:      after projection: pixels of a canvas or stage units; depth in the same.
 * Ownership:  plain value of about 150 KB: static storage.
 * Errors:     false: no room, or a vertex at or behind the eye or far beyond the picture; the
 *             scene is then as before.
 * Source:     J. D. Foley et al., Computer Graphics (1990), section 15.1, for the depth.
 */
#ifndef ROMS_VISIBLE_SCENE_H
#define ROMS_VISIBLE_SCENE_H

#include "roms/geometry/matrix4.h"
#include "roms/solids/plane.h"

enum {
    SCENE_VERTICES = OBJECT_VERTICES,
    SCENE_SURFACES = OBJECT_POLYGONS,
    SCENE_CORNERS = OBJECT_SIDES,
    SCENE_EDGES = OBJECT_EDGES,
    SURFACE_CORNERS = OBJECT_CORNERS,
    SURFACE_NONE = OBJECT_NONE,
    SCENE_FARTHEST = 30000 /* from the origin of the picture */
};

/* From an object's coordinates onto the picture. */
struct view {
    struct matrix4 turn; /* to x right, y up, z toward the viewer */
    float eye;           /* at (0, 0, eye); 0: parallel, along −z */
    float scale;         /* picture units a unit */
    float x, y;          /* of the picture: where (0, 0, 0) comes to lie */
    float up;            /* 1: picture y grows upwards; -1: downwards, as rows of a canvas do */
};

struct surface {
    uint16_t first, count; /* corners */
    uint16_t polygon;      /* of the object */
    uint32_t colour;       /* pixel value */
    struct plane plane;    /* of the projected corners; C = 0: edge-on */
    struct vector3 normal; /* before projection, of length 1: for shading */
    bool front;            /* no back face */
};

struct scene_edge {
    uint16_t vertex[2];
    uint16_t surface[2]; /* SURFACE_NONE: none, or a back face that was left out */
    float fold;          /* cosine of the angle between its surfaces' normals; -2: one surface, or
                              an outline: one of them is a back face */
};

struct scene {
    struct vector3 vertex[SCENE_VERTICES];
    uint16_t corner[SCENE_CORNERS]; /* indices of vertices */
    struct surface surface[SCENE_SURFACES];
    struct scene_edge edge[SCENE_EDGES];
    int vertices, corners, surfaces, edges;
};

enum { SCENE_CULLED = 1 /* without back faces: for closed solids */ };

void scene_clear(struct scene *scene);
/* Adds an object. Its surfaces get `colour`; their `polygon` says which they are. */
bool scene_add(struct scene *scene, const struct object *object, const struct view *view,
               unsigned flags, uint32_t colour);
/* A point through a view. */
struct vector3 view_place(const struct view *view, struct vector3 p);

static inline struct vector3 scene_corner(const struct scene *scene, const struct surface *surface,
                                          int k)
{
    return scene->vertex[scene->corner[surface->first + k]];
}

/* The depth of a surface's plane; 0 for an edge-on one. */
static inline float surface_depth(const struct surface *s, float x, float y)
{
    return s->plane.c != 0 ? -(s->plane.a * x + s->plane.b * y + s->plane.d) / s->plane.c : 0;
}

#endif
