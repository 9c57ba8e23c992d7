#include "roms/scenery/studio.h"

#include <stddef.h>

#include "roms/bsp/csr.h"
#include "roms/geometry/scalar.h"
#include "roms/scenery/depth.h"
#include "roms/scenery/workroom.h"
#include "roms/solids/models.h"
#include "roms/solids/normals.h"

const char *const studio_names[] = {"present", "sphere", "torus", "vessel", NULL};

void studio_reset(struct studio *s)
{
    s->lighting = lighting_dark(0.4f);
    lighting_add(&s->lighting,
                 (struct light){.kind = LIGHT_FAR, .at = {-1, 1, 1.4f}, .intensity = 1});
    s->material = (struct material){.ka = 0.15f, .kd = 0.6f, .ks = 0.4f, .n = 20};
}

struct studio *studio(void)
{
    static struct studio room;
    if (room.lighting.count == 0 && room.material.n == 0)
        studio_reset(&room);
    return &room;
}

static void make(struct object *o, enum studio_model model, int fineness)
{
    struct object_attribute clay = scene_attribute("clay", RAMP_COPPER);
    object_clear(o);
    object_attribute(o, &clay);
    if (model == STUDIO_SPHERE)
        object_sphere(o, 1, fineness, fineness / 2, 0);
    else if (model == STUDIO_TORUS)
        object_torus(o, 1, 0.45f, fineness, fineness / 2, 0);
    else
        object_vessel(o, 1, fineness > VESSEL_SEGMENTS ? VESSEL_SEGMENTS : fineness, 0);
    object_normals(o, model == STUDIO_VESSEL ? NORMALS_CREASE : NORMALS_ROUND);
}

/* Edges that a wire picture can do without: 5°. */
static void mark_flat(struct studio *s)
{
    static struct vector3 normal[OBJECT_POLYGONS];
    const struct object *o = s->object;
    for (int i = 0; i < o->polygons; i++) {
        struct vector3 a = o->vertex[object_corner(o, i, 0)];
        struct vector3 b = o->vertex[object_corner(o, i, 1)];
        struct vector3 c = o->vertex[object_corner(o, i, 2)];
        normal[i] =
            vector3_direction(vector3_cross(vector3_difference(b, a), vector3_difference(c, a)));
    }
    for (int i = 0; i < o->edges; i++) {
        const uint16_t *p = o->edge[i].polygon;
        s->flat[i] = p[0] != OBJECT_NONE && p[1] != OBJECT_NONE &&
                     vector3_dot(normal[p[0]], normal[p[1]]) > 0.9962f;
    }
}

void studio_solid(struct studio *s, enum studio_model model, int fineness)
{
    struct object *o = &workroom()->object;
    if (model == STUDIO_PRESENT)
        o = present_object();
    else
        make(o, model, fineness);
    s->object = o;
    s->reach = object_reach(o);
    mesh_of_object(&s->mesh, o);
    mark_flat(s);
    power_table(&s->power, s->material.n);
}

/* ---- the raster head ------------------------------------------------------------------------- */

static void place(struct studio *s, const struct stage *stage, const struct studio_pose *pose)
{
    struct mesh_view *v = &s->view;
    v->model = view_turn(pose->yaw, pose->pitch);
    v->distance = pose->eye * s->reach;
    v->x = stage_canvas_x(stage, pose->x);
    v->y = stage_canvas_y(stage, pose->y);
    v->dots_x = v->dots_y = pose->radius * stage->dots / s->reach;
    mesh_project(&s->mesh, v);
}

/* Clears the part of the depth buffer in which the mesh is. */
static void clear_depth(const struct studio *s, const struct depth_buffer *depth)
{
    const struct shade_vertex *v = s->view.vertex;
    float left = v->x, right = v->x, top = v->y, bottom = v->y;
    for (int i = 1; i < s->mesh.vertices; i++) {
        left = scalar_min(left, v[i].x);
        right = scalar_max(right, v[i].x);
        top = scalar_min(top, v[i].y);
        bottom = scalar_max(bottom, v[i].y);
    }
    int x = (int)scalar_clamp(left, 0, (float)depth->width),
        y = (int)scalar_clamp(top, 0, (float)depth->height);
    depth_clear_part(depth, x, y, (int)scalar_clamp(right, 0, (float)depth->width) + 1 - x,
                     (int)scalar_clamp(bottom, 0, (float)depth->height) + 1 - y, -1e30f);
}

struct studio_cost studio_shade(struct studio *s, const struct stage *stage,
                                const struct studio_pose *pose, enum shading shading,
                                enum ink_ramp ramp)
{
    struct depth_buffer depth = lesson_depth(&stage->canvas);
    struct shade shade = shade_begin(&stage->canvas, &depth, ink_shade(ramp, 0), INK_LEVELS);
    uint32_t start = csr_read_minstret();
    power_table(&s->power, s->material.n);
    shade.lighting = &s->lighting;
    shade.material = &s->material;
    shade.power = &s->power;
    place(s, stage, pose);
    uint32_t placed = csr_read_minstret();
    clear_depth(s, &depth);
    uint32_t cleared = csr_read_minstret();
    mesh_shade(&s->mesh, &s->view, &shade, shading);
    return (struct studio_cost){shade.triangles, shade.covered, cleared - placed, placed - start,
                                csr_read_minstret() - cleared};
}

/* ---- the vector head ------------------------------------------------------------------------- */

static bool is_front(const struct object *o, int polygon, const struct point2 *at)
{
    if (polygon == OBJECT_NONE)
        return false;
    float area = 0;
    int count = o->polygon[polygon].count;
    struct point2 a = at[object_corner(o, polygon, count - 1)];
    for (int k = 0; k < count; k++) {
        struct point2 b = at[object_corner(o, polygon, k)];
        area += a.x * b.y - a.y * b.x;
        a = b;
    }
    return area > 0;
}

/* As mesh_project does it. */
static struct point2 wire_place(const struct studio *s, const struct matrix4 *m,
                                const struct studio_pose *pose, struct vector3 p)
{
    float x = m->at[0][0] * p.x + m->at[0][1] * p.y + m->at[0][2] * p.z;
    float y = m->at[1][0] * p.x + m->at[1][1] * p.y + m->at[1][2] * p.z;
    float z = m->at[2][0] * p.x + m->at[2][1] * p.y + m->at[2][2] * p.z;
    float eye = pose->eye * s->reach, scale = pose->radius / s->reach;
    if (eye > 0)
        scale *= eye / (eye - z);
    return (struct point2){pose->x + x * scale, pose->y + y * scale};
}

void studio_wires(struct studio *s, struct stage *stage, const struct studio_pose *pose)
{
    static struct point2 at[OBJECT_VERTICES];
    static bool front[OBJECT_POLYGONS];
    const struct object *o = s->object;
    const struct matrix4 turn = view_turn(pose->yaw, pose->pitch);
    for (int i = 0; i < o->vertices; i++)
        at[i] = wire_place(s, &turn, pose, o->vertex[i]);
    for (int i = 0; i < o->polygons; i++)
        front[i] = is_front(o, i, at);
    for (int i = 0; i < o->edges; i++) {
        const struct object_edge *e = &o->edge[i];
        bool one = e->polygon[0] != OBJECT_NONE && front[e->polygon[0]];
        bool other = e->polygon[1] != OBJECT_NONE && front[e->polygon[1]];
        if (!(one || other) || (one == other && s->flat[i]))
            continue;
        struct point2 a = at[e->vertex[0]], b = at[e->vertex[1]];
        stage_line(stage, a.x, a.y, b.x, b.y);
    }
}
