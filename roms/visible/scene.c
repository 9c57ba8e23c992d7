#include "roms/visible/scene.h"

#include "roms/visible/back_face.h"

void scene_clear(struct scene *s)
{
    s->vertices = s->corners = s->surfaces = s->edges = 0;
}

/* Viewer's coordinates onto the picture. */
static struct vector3 onto_picture(const struct view *v, struct vector3 p)
{
    float k = v->scale * (v->eye > 0 ? v->eye / (v->eye - p.z) : 1);
    return (struct vector3){v->x + k * p.x, v->y + k * p.y * v->up, k * p.z};
}

struct vector3 view_place(const struct view *v, struct vector3 p)
{
    return onto_picture(v, matrix4_apply(&v->turn, p));
}

static bool has_room(const struct scene *s, const struct object *o)
{
    return s->vertices + o->vertices <= SCENE_VERTICES && s->corners + o->sides <= SCENE_CORNERS &&
           s->surfaces + o->polygons <= SCENE_SURFACES && s->edges + o->edges <= SCENE_EDGES;
}

static bool add_vertices(struct scene *s, const struct object *o, const struct view *v)
{
    for (int i = 0; i < o->vertices; i++) {
        struct vector3 p = matrix4_apply(&v->turn, o->vertex[i]);
        if (v->eye > 0 && p.z > 0.98f * v->eye)
            return false;
        p = onto_picture(v, p);
        if (!(fabsf(p.x) < SCENE_FARTHEST && fabsf(p.y) < SCENE_FARTHEST))
            return false;
        s->vertex[s->vertices + i] = p;
    }
    return true;
}

/* The plane of corners on the picture, about the first. Its normal has length 1, so that what is
 * thinner than a part of a pixel can be told from what is not. */
static struct plane projected_plane(const struct scene *s, const struct surface *f)
{
    struct plane_sums sums = plane_sums_begin(scene_corner(s, f, 0));
    for (int i = 1; i < f->count; i++)
        plane_sums_add(&sums, scene_corner(s, f, i));
    struct vector3 n = vector3_direction(sums.normal);
    if (fabsf(n.z) < 1e-4f)
        n.z = 0;
    return plane_at(sums.origin, n);
}

static bool is_back_face(const struct object *o, int polygon, const struct view *v,
                         struct vector3 normal)
{
    if (v->eye == 0)
        return back_face_parallel(normal, (struct vector3){0, 0, -1});
    struct vector3 p = matrix4_apply(&v->turn, o->vertex[object_corner(o, polygon, 0)]);
    struct plane plane = plane_at(p, normal);
    return back_face_perspective(&plane, (struct vector3){0, 0, v->eye});
}

/* Says in `place` where each polygon's surface is. */
static void add_surfaces(struct scene *s, const struct object *o, const struct view *v,
                         unsigned flags, uint32_t colour, uint16_t *place)
{
    for (int i = 0; i < o->polygons; i++) {
        struct plane plane = plane_of_polygon(o, i);
        struct vector3 normal =
            vector3_direction(matrix4_apply_direction(&v->turn, plane_normal(&plane)));
        place[i] = SURFACE_NONE;
        bool front = !is_back_face(o, i, v, normal);
        if ((flags & SCENE_CULLED) && !front)
            continue;
        struct surface *f = &s->surface[s->surfaces];
        *f = (struct surface){.first = (uint16_t)s->corners,
                              .count = o->polygon[i].count,
                              .polygon = (uint16_t)i,
                              .colour = colour,
                              .normal = normal,
                              .front = front};
        for (int k = 0; k < f->count; k++)
            s->corner[s->corners++] = (uint16_t)(s->vertices + object_corner(o, i, k));
        f->plane = projected_plane(s, f);
        place[i] = (uint16_t)s->surfaces++;
    }
}

static float fold_of(const struct scene *s, const uint16_t surface[2])
{
    if (surface[0] == SURFACE_NONE || surface[1] == SURFACE_NONE)
        return -2;
    const struct surface *a = &s->surface[surface[0]], *b = &s->surface[surface[1]];
    return a->front != b->front ? -2 : vector3_dot(a->normal, b->normal);
}

/* But those of which all surfaces were left out. */
static void add_edges(struct scene *s, const struct object *o, const uint16_t *place)
{
    for (int i = 0; i < o->edges; i++) {
        const struct object_edge *e = &o->edge[i];
        struct scene_edge *to = &s->edge[s->edges];
        for (int k = 0; k < 2; k++) {
            to->vertex[k] = (uint16_t)(s->vertices + e->vertex[k]);
            to->surface[k] = e->polygon[k] == OBJECT_NONE ? SURFACE_NONE : place[e->polygon[k]];
        }
        to->fold = fold_of(s, to->surface);
        bool none = to->surface[0] == SURFACE_NONE && to->surface[1] == SURFACE_NONE;
        s->edges += !none || e->polygon[0] == OBJECT_NONE;
    }
}

bool scene_add(struct scene *s, const struct object *o, const struct view *v, unsigned flags,
               uint32_t colour)
{
    uint16_t place[OBJECT_POLYGONS];
    if (!has_room(s, o) || !add_vertices(s, o, v))
        return false;
    add_surfaces(s, o, v, flags, colour, place);
    add_edges(s, o, place);
    s->vertices += o->vertices;
    return true;
}
