#include "roms/scenery/workroom.h"

#include <stddef.h>

#include "roms/geometry/projection_parallel.h"
#include "roms/geometry/scalar.h"
#include "roms/geometry/transform3.h"
#include "roms/solids/models.h"
#include "roms/solids/normals.h"

const char *const scene_names[] = {"object", "solids", "two", "cycle", "pierce", NULL};

struct object_attribute scene_attribute(const char *name, enum ink_ramp ramp)
{
    return (struct object_attribute){.name = name,
                                     .ramp = ramp,
                                     .ambient = 0.2f,
                                     .diffuse = 0.7f,
                                     .specular = 0.3f,
                                     .shininess = 20};
}

struct object *present_object(void)
{
    static struct object object;
    if (object.polygons == 0) {
        object_clear(&object);
        struct object_attribute clay = scene_attribute("clay", RAMP_COPPER);
        object_box(&object, 2, 2, 2, object_attribute(&object, &clay));
        object_normals(&object, NORMALS_CREASE);
    }
    return &object;
}

struct workroom *workroom(void)
{
    static struct workroom room;
    return &room;
}

/* ---- named scenes ---------------------------------------------------------------------------- */

static void quad(struct object *o, const struct vector3 p[4], int attribute)
{
    int corner[4];
    for (int i = 0; i < 4; i++)
        corner[i] = object_vertex(o, p[i].x, p[i].y, p[i].z);
    object_polygon(o, corner, 4, attribute);
}

/* Moves the vertices from `first` on. */
static void move(struct object *o, int first, float x, float y, float z)
{
    struct matrix4 m = transform3_translate((struct vector3){x, y, z});
    object_transform(o, first, &m);
}

static void make_solids(struct object *o)
{
    object_box(o, 1.3f, 1.3f, 1.3f, 0);
    move(o, 0, -1.0f, 0.75f, 0);
    int first = o->vertices;
    object_sphere(o, 0.8f, 16, 10, 1);
    move(o, first, 0.85f, 0.7f, -0.45f);
    first = o->vertices;
    object_torus(o, 0.68f, 0.27f, 20, 10, 2);
    move(o, first, -0.75f, -0.75f, 0.45f);
    first = o->vertices;
    object_cylinder(o, 0.45f, 1.2f, 16, 3);
    move(o, first, 0.8f, -0.8f, 0.2f);
}

static void make_two(struct object *o)
{
    static const struct vector3 s1[4] = {
        {-1.7f, -0.9f, 0.6f}, {0.1f, -1.1f, 0.9f}, {0.8f, 0.9f, 0.3f}, {-1.4f, 1.1f, 0}};
    struct vector3 s2[4] = {
        {-0.5f, -0.5f, 0}, {1.5f, -0.8f, -0.6f}, {1.8f, 0.6f, -1.2f}, {-0.1f, 0.5f, 0}};
    struct plane p = plane_through(s2[0], s2[1], s2[2]);
    s2[3].z = -(p.a * s2[3].x + p.b * s2[3].y + p.d) / p.c;
    struct vector3 t[4] = {s1[0], s1[1], s1[2], s1[3]};
    p = plane_through(t[0], t[1], t[2]);
    t[3].z = -(p.a * t[3].x + p.b * t[3].y + p.d) / p.c;
    quad(o, t, 0);
    quad(o, s2, 3);
}

/* Each bar rises toward its end, which lies over the beginning of the next. */
static void make_cycle(struct object *o)
{
    static const struct point2 corner[3] = {{0, 1.25f}, {-1.2f, -0.75f}, {1.2f, -0.75f}};
    for (int i = 0; i < 3; i++) {
        struct point2 a = corner[i], b = corner[(i + 1) % 3];
        float dx = (b.x - a.x) * 0.25f, dy = (b.y - a.y) * 0.25f;
        float wide = 0.26f / sqrtf(dx * dx + dy * dy), nx = -dy * wide, ny = dx * wide;
        struct vector3 from = {a.x - dx, a.y - dy, -0.5f}, to = {b.x + dx, b.y + dy, 0.5f};
        struct vector3 bar[4] = {{from.x + nx, from.y + ny, from.z},
                                 {from.x - nx, from.y - ny, from.z},
                                 {to.x - nx, to.y - ny, to.z},
                                 {to.x + nx, to.y + ny, to.z}};
        quad(o, bar, i);
    }
}

static void make_pierce(struct object *o)
{
    static const struct vector3 plates[3][4] = {
        {{-1.5f, -1, 0.9f}, {0.9f, -1, -1}, {0.9f, 1, -1}, {-1.5f, 1, 0.9f}},
        {{-0.9f, -0.7f, -1}, {1.5f, -0.7f, 0.9f}, {1.5f, 1.3f, 0.9f}, {-0.9f, 1.3f, -1}},
        {{-1.3f, -0.8f, 0.8f}, {1.3f, -0.8f, 0.8f}, {1.3f, 0.6f, -1}, {-1.3f, 0.6f, -1}}};
    for (int i = 0; i < 3; i++)
        quad(o, plates[i], i);
}

bool scene_make(struct object *o, enum scene_which which)
{
    static const struct {
        const char *name;
        enum ink_ramp ramp;
    } paints[] = {
        {"clay", RAMP_COPPER}, {"leaf", RAMP_GREEN}, {"brass", RAMP_GOLD}, {"glaze", RAMP_BLUE}};
    if (which == SCENE_OBJECT)
        return true;
    object_clear(o);
    for (int i = 0; i < 4; i++) {
        struct object_attribute a = scene_attribute(paints[i].name, paints[i].ramp);
        object_attribute(o, &a);
    }
    if (which == SCENE_SOLIDS)
        make_solids(o);
    else if (which == SCENE_TWO)
        make_two(o);
    else if (which == SCENE_CYCLE)
        make_cycle(o);
    else
        make_pierce(o);
    object_normals(o, NORMALS_CREASE);
    return which == SCENE_SOLIDS;
}

/* ---- views ----------------------------------------------------------------------------------- */

struct matrix4 view_turn(float yaw, float pitch)
{
    return projection_axonometric(yaw, pitch).matrix;
}

struct view view_on_canvas(const struct stage *stage, const struct matrix4 *turn, float eye,
                           float scale, float x, float y)
{
    return (struct view){
        *turn, eye, scale * stage->dots, stage_canvas_x(stage, x), stage_canvas_y(stage, y), -1};
}

struct view view_on_stage(const struct matrix4 *turn, float eye, float scale, float x, float y)
{
    return (struct view){*turn, eye, scale, x, y, 1};
}

float object_reach(const struct object *o)
{
    float reach = 0;
    for (int i = 0; i < o->vertices; i++)
        reach = scalar_max(reach, vector3_length(o->vertex[i]));
    return reach;
}

/* ---- colours and lines ----------------------------------------------------------------------- */

float scene_light(struct vector3 n)
{
    static const struct vector3 to_light = {0.37f, 0.56f, 0.74f};
    float k = vector3_dot(n, to_light);
    if (n.z < 0)
        k = -k;
    return 0.1f + 0.66f * (k > 0 ? k : 0);
}

void scene_shade(struct scene *scene, const struct object *o)
{
    for (int i = 0; i < scene->surfaces; i++) {
        struct surface *s = &scene->surface[i];
        enum ink_ramp ramp = (enum ink_ramp)o->attribute[o->polygon[s->polygon].attribute].ramp;
        s->colour = ink_shade(ramp, scene_light(s->normal));
    }
}

void stage_hidden_lines(struct stage *stage, const struct scene *scene, float fold)
{
    struct hidden_lines *h = &workroom()->hidden;
    struct hidden_part part;
    hidden_begin(h, scene, fold);
    while (hidden_next(h, &part))
        if (part.seen)
            stage_line(stage, part.a.x, part.a.y, part.b.x, part.b.y);
}

void stage_wireframe(struct stage *stage, const struct scene *scene)
{
    for (int i = 0; i < scene->edges; i++) {
        struct vector3 a = scene->vertex[scene->edge[i].vertex[0]];
        struct vector3 b = scene->vertex[scene->edge[i].vertex[1]];
        stage_line(stage, a.x, a.y, b.x, b.y);
    }
}
