#include "roms/light/mesh.h"

#include <string.h>

/* ---- from polygon tables --------------------------------------------------------------------- */

/* The mesh's vertex for a side's start and normal; -1: no room. */
static int vertex_of(struct mesh *mesh, const struct object *o, int side)
{
    int place = o->side[side].start, normal = o->side_normal[side];
    for (int k = mesh->first[place]; k != OBJECT_NONE; k = mesh->next[k])
        if (mesh->source[k] == normal)
            return k;
    if (mesh->vertices == MESH_VERTICES)
        return -1;
    int new = mesh->vertices++;
    mesh->place[new] = o->vertex[place];
    mesh->normal[new] = o->normal[normal];
    mesh->source[new] = (uint16_t)normal;
    mesh->next[new] = mesh->first[place];
    mesh->first[place] = (uint16_t) new;
    return new;
}

static bool add_triangle(struct mesh *mesh, const struct object *o, const int *side)
{
    if (mesh->triangles == MESH_TRIANGLES)
        return false;
    for (int k = 0; k < 3; k++) {
        int v = vertex_of(mesh, o, side[k]);
        if (v < 0)
            return false;
        mesh->corner[mesh->triangles][k] = (uint16_t)v;
    }
    mesh->triangles++;
    return true;
}

bool mesh_of_object(struct mesh *mesh, const struct object *o)
{
    mesh->vertices = mesh->triangles = 0;
    memset(mesh->first, 0xFF, sizeof mesh->first);
    for (int p = 0; p < o->polygons; p++) {
        int first = o->polygon[p].first;
        for (int k = 1; k + 1 < o->polygon[p].count; k++) {
            int side[3] = {first, first + k, first + k + 1};
            if (!add_triangle(mesh, o, side)) {
                mesh->vertices = mesh->triangles = 0;
                return false;
            }
        }
    }
    return true;
}

/* ---- once a vertex --------------------------------------------------------------------------- */

static inline struct vector3 turned(const struct matrix4 *m, struct vector3 v)
{
    return (struct vector3){fmaf(m->at[0][0], v.x, fmaf(m->at[0][1], v.y, m->at[0][2] * v.z)),
                            fmaf(m->at[1][0], v.x, fmaf(m->at[1][1], v.y, m->at[1][2] * v.z)),
                            fmaf(m->at[2][0], v.x, fmaf(m->at[2][1], v.y, m->at[2][2] * v.z))};
}

void mesh_project(const struct mesh *mesh, struct mesh_view *view)
{
    const struct matrix4 m = view->model;
    struct vector3 shift = {m.at[0][3], m.at[1][3], m.at[2][3]};
    float distance = view->distance;
    for (int i = 0; i < mesh->vertices; i++) {
        struct shade_vertex *v = &view->vertex[i];
        struct vector3 p = vector3_sum(turned(&m, mesh->place[i]), shift);
        float nearer = 1;
        v->place = p;
        v->normal = turned(&m, mesh->normal[i]);
        v->z = p.z;
        if (distance > 0) {
            v->z = 1 / (distance - p.z);
            nearer = v->z > 0 ? distance * v->z : NAN;
        }
        v->x = fmaf(p.x * nearer, view->dots_x, view->x);
        v->y = fmaf(p.y * nearer, -view->dots_y, view->y);
        v->intensity = -1; /* not lit yet */
    }
}

/* ---- once a triangle ------------------------------------------------------------------------- */

static void light_corner(const struct shade *s, struct shade_vertex *v)
{
    if (v->intensity < 0)
        v->intensity = illumination_sum(illuminate(s->lighting, s->material, v->place, v->normal));
}

static float light_face(const struct shade *s, const struct shade_vertex *a,
                        const struct shade_vertex *b, const struct shade_vertex *c)
{
    struct vector3 normal = vector3_cross(vector3_difference(b->place, a->place),
                                          vector3_difference(c->place, a->place));
    struct vector3 middle =
        vector3_times(vector3_sum(vector3_sum(a->place, b->place), c->place), 1.0f / 3);
    return illumination_sum(illuminate(s->lighting, s->material, middle, normal));
}

static void shade_face(struct shade *s, enum shading shading, struct shade_vertex *a,
                       struct shade_vertex *b, struct shade_vertex *c)
{
    switch (shading) {
    case SHADE_FLAT:
        shade_flat(s, light_face(s, a, b, c), a, b, c);
        break;
    case SHADE_GOURAUD:
        light_corner(s, a);
        light_corner(s, b);
        light_corner(s, c);
        shade_gouraud(s, a, b, c);
        break;
    case SHADE_PHONG:
        shade_phong(s, a, b, c);
        break;
    default:
        shade_fast_phong(s, a, b, c);
        break;
    }
}

void mesh_shade(const struct mesh *mesh, struct mesh_view *view, struct shade *s,
                enum shading shading)
{
    for (int i = 0; i < mesh->triangles; i++) {
        const uint16_t *corner = mesh->corner[i];
        struct shade_vertex *a = &view->vertex[corner[0]], *b = &view->vertex[corner[1]];
        struct shade_vertex *c = &view->vertex[corner[2]];
        if (mesh_is_front(a, b, c))
            shade_face(s, shading, a, b, c);
    }
}
