/* mesh.h — a solid as triangles that share their corners: moved, projected, lit, shaded.
 *
 *      object (tables) ──▶ mesh ──model, projection──▶ shade_vertex ──front faces──▶ shade.h
 *
 * Models:     what is done once a vertex (motion, projection, for Gouraud its light) and once a
 *             triangle (back faces left out, for flat its light). The viewer looks along −z from
 *             `distance` before the origin, or from infinity.
 * Cost:       about 60 instructions a vertex and 20 a triangle, the light of vertices that are
 *             seen, and the shading's.
 * Domain:     MESH_… entries; rigid motions (normals keep their length); all of it before the eye.
 * Units:      space: the caller's; canvas: pixels.
 * Ownership:  a mesh is about 130 KB, a mesh_view's work space 110 KB: static storage.
 * Errors:     what does not fit: false, and the mesh is empty. Vertices at the eye or behind it are
 *             not drawn.
 * Source:     elementary.
 * Not modelled: clipping at the eye, several materials in a mesh.
 */
#ifndef ROMS_LIGHT_MESH_H
#define ROMS_LIGHT_MESH_H

#include "roms/geometry/matrix4.h"
#include "roms/light/shade.h"
#include "roms/solids/object.h"

enum { MESH_VERTICES = 2560, MESH_TRIANGLES = 2560 };

struct mesh {
    struct vector3 place[MESH_VERTICES], normal[MESH_VERTICES];
    uint16_t corner[MESH_TRIANGLES][3]; /* counter-clockwise from outside */
    int vertices, triangles;
    /* Private: vertices by the object's vertex that they are at, and their normal's index. */
    uint16_t first[OBJECT_VERTICES], next[MESH_VERTICES], source[MESH_VERTICES];
};

/* The object's triangles; its normals must have been made (roms/solids/normals.h). */
bool mesh_of_object(struct mesh *mesh, const struct object *object);

struct mesh_view {
    struct matrix4 model;
    float distance;       /* of the eye from the origin; 0: at infinity */
    float x, y;           /* of the origin on the canvas */
    float dots_x, dots_y; /* pixels a unit at the origin */
    struct shade_vertex vertex[MESH_VERTICES];
};

/* Moves and projects: fills view->vertex. Depth is z, or 1/(distance − z): the nearer the larger,
 * above 0 for all that lies before the eye. */
void mesh_project(const struct mesh *mesh, struct mesh_view *view);
/* Draws what mesh_project projected. */
void mesh_shade(const struct mesh *mesh, struct mesh_view *view, struct shade *shade,
                enum shading shading);

/* Whether these corners on the canvas are counter-clockwise, so that their front is seen. */
static inline bool mesh_is_front(const struct shade_vertex *a, const struct shade_vertex *b,
                                 const struct shade_vertex *c)
{
    return (b->x - a->x) * (c->y - a->y) < (c->x - a->x) * (b->y - a->y);
}

#endif
