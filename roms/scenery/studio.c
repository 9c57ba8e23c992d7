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

void studio_wires(struct studio *s, struct stage *stage, const struct studio_pose *pose)
{
    const float flat = 0.9962f; /* 5 degrees */
    const struct matrix4 turn = view_turn(pose->yaw, pose->pitch);
    const struct view view =
        view_on_stage(&turn, pose->eye * s->reach, pose->radius / s->reach, pose->x, pose->y);
    struct scene *scene = &workroom()->lines;
    scene_clear(scene);
    if (!scene_add(scene, s->object, &view, SCENE_CULLED, 0))
        return;
    for (int i = 0; i < scene->edges; i++) {
        const struct scene_edge *e = &scene->edge[i];
        struct vector3 a = scene->vertex[e->vertex[0]], b = scene->vertex[e->vertex[1]];
        if (e->fold <= flat)
            stage_line(stage, a.x, a.y, b.x, b.y);
    }
}
