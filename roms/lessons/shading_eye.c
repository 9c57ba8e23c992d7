/* shading_eye.c — pages about a lamp with an extent, and about what the eye makes of steps and of
 * few levels. */
#include <math.h>
#include <stdio.h>

#include "roms/scenery/depth.h"
#include "roms/scenery/eye.h"
#include "roms/lessons/shading.h"

/* ---- a lamp over a table --------------------------------------------------------------------- */

enum { FLOOR_COLUMNS = 33, FLOOR_ROWS = 21 };
#define FLOOR_HALF 2.4f /* of its width */

static float floor_x(int column)
{
    return ((float)column / (FLOOR_COLUMNS - 1) * 2 - 1) * FLOOR_HALF;
}

static float floor_z(int row)
{
    return ((float)row / (FLOOR_ROWS - 1) * 2 - 1) * 1.5f;
}

void shading_lamp_begin(struct shading_lesson *l)
{
    struct mesh *mesh = &l->studio->mesh;
    mesh->vertices = mesh->triangles = 0;
    for (int r = 0; r < FLOOR_ROWS; r++)
        for (int c = 0; c < FLOOR_COLUMNS; c++) {
            mesh->place[mesh->vertices] = (struct vector3){floor_x(c), 0, floor_z(r)};
            mesh->normal[mesh->vertices++] = (struct vector3){0, 1, 0};
        }
    for (int r = 0; r + 1 < FLOOR_ROWS; r++)
        for (int c = 0; c + 1 < FLOOR_COLUMNS; c++) {
            uint16_t a = (uint16_t)(r * FLOOR_COLUMNS + c), b = (uint16_t)(a + FLOOR_COLUMNS);
            uint16_t *first = mesh->corner[mesh->triangles],
                     *second = mesh->corner[mesh->triangles + 1];
            first[0] = a, first[1] = b, first[2] = (uint16_t)(b + 1);
            second[0] = a, second[1] = (uint16_t)(b + 1), second[2] = (uint16_t)(a + 1);
            mesh->triangles += 2;
        }
}

/* The table's frame: looked at from before and above. */
struct table_view {
    struct matrix4 turn;
    float eye, scale;
};

static struct table_view table_view(void)
{
    struct table_view v = {matrix4_identity(), 7, 200};
    float c = cosf(0.62f), s = sinf(0.62f);
    v.turn.at[1][1] = v.turn.at[2][2] = c;
    v.turn.at[1][2] = -s;
    v.turn.at[2][1] = s;
    return v;
}

static struct point2 table_place(const struct table_view *v, struct vector3 p)
{
    p = matrix4_apply(&v->turn, p);
    float k = v->scale * v->eye / (v->eye - p.z);
    return (struct point2){600 + k * p.x, 470 + k * p.y};
}

static void table_line(struct stage *s, const struct table_view *v, struct vector3 a,
                       struct vector3 b)
{
    struct point2 p = table_place(v, a), q = table_place(v, b);
    stage_line(s, p.x, p.y, q.x, q.y);
}

static void draw_table(struct shading_lesson *l, struct stage *stage, const struct table_view *v)
{
    struct studio *s = l->studio;
    struct depth_buffer depth = lesson_depth(&stage->canvas);
    struct shade shade = shade_begin(&stage->canvas, &depth, ink_shade(RAMP_GOLD, 0), INK_LEVELS);
    shade.lighting = &s->lighting;
    shade.material = &s->material;
    s->view.model = matrix4_identity();
    s->view.model = v->turn;
    s->view.distance = v->eye;
    s->view.x = stage_canvas_x(stage, 600);
    s->view.y = stage_canvas_y(stage, 470);
    s->view.dots_x = s->view.dots_y = v->scale * stage->dots;
    mesh_project(&s->mesh, &s->view);
    depth_clear(&depth, -1e30f);
    /* The light is that of places and normals before they are turned. */
    for (int i = 0; i < s->mesh.vertices; i++)
        s->view.vertex[i].intensity = illumination_sum(
            illuminate(&s->lighting, &s->material, s->mesh.place[i], s->mesh.normal[i]));
    mesh_shade(&s->mesh, &s->view, &shade, SHADE_GOURAUD);
    stage_heads(stage, STAGE_VECTOR);
    stage_ink(stage, INK_GRID);
    for (int r = 0; r < FLOOR_ROWS; r += 4)
        table_line(stage, v, (struct vector3){-FLOOR_HALF, 0, floor_z(r)},
                   (struct vector3){FLOOR_HALF, 0, floor_z(r)});
    for (int c = 0; c < FLOOR_COLUMNS; c += 4)
        table_line(stage, v, (struct vector3){floor_x(c), 0, -1.5f},
                   (struct vector3){floor_x(c), 0, 1.5f});
    stage_heads(stage, STAGE_BOTH);
}

static void draw_source(struct stage *stage, const struct table_view *v, const struct light *light)
{
    struct vector3 a = light->at, b = vector3_sum(a, light->side), c = vector3_sum(b, light->other);
    struct vector3 d = vector3_sum(a, light->other);
    stage_ink(stage, INK_BRIGHT);
    if (light->kind == LIGHT_NEAR) {
        struct point2 p = table_place(v, a);
        stage_marker(stage, p.x, p.y);
        stage_marker(stage, p.x + 1, p.y + 1);
        return;
    }
    table_line(stage, v, a, b);
    if (light->kind == LIGHT_LINE)
        return;
    table_line(stage, v, b, c);
    table_line(stage, v, c, d);
    table_line(stage, v, d, a);
}

/* The light along the table's middle. */
static void draw_profile(const struct shading_lesson *l, struct stage *stage)
{
    enum { LOW = 30, HIGH = 170, POINTS = 49 };
    struct point2 p[POINTS];
    for (int i = 0; i < POINTS; i++) {
        float at = (float)i / (POINTS - 1) * 2 - 1;
        struct illumination light =
            illuminate(&l->studio->lighting, &l->studio->material,
                       (struct vector3){at * FLOOR_HALF, 0, 0}, (struct vector3){0, 1, 0});
        p[i] = (struct point2){600 + at * 500, LOW + illumination_sum(light) * (HIGH - LOW)};
    }
    stage_ink(stage, INK_GRID);
    stage_line(stage, 100, LOW, 1100, LOW);
    stage_ink(stage, INK_YELLOW);
    stage_polyline(stage, p, POINTS);
    stage_ink(stage, INK_TEXT);
    stage_text(stage, 20, HIGH, "intensity");
}

void shading_lamp(struct shading_lesson *l, struct stage *stage, float t)
{
    static const char *const what[] = {"a point", "a tube (a line of 12 points)",
                                       "a panel (a rectangle of 6 by 6 points)"};
    struct lighting *g = &l->studio->lighting;
    struct table_view v = table_view();
    int which = (int)(t / 5) % 3;
    float height = 0.75f + 0.3f * sinf(1.2f * t);
    struct light source = {.kind = which == 0   ? LIGHT_NEAR
                                   : which == 1 ? LIGHT_LINE
                                                : LIGHT_RECTANGLE,
                           .at = {0, height, 0},
                           .samples = which == 1 ? 12 : 6,
                           .intensity = 0.8f};
    if (which > 0) {
        source.at = (struct vector3){-1.4f, height, which == 2 ? -0.5f : 0};
        source.side = (struct vector3){2.8f, 0, 0};
        source.other = (struct vector3){0, 0, 1};
    }
    *g = lighting_dark(0.1f);
    g->a0 = 0.3f;
    g->a2 = 0.6f;
    lighting_add(g, source);
    l->studio->material = (struct material){0.5f, 1, 0, 1, 0, false};
    draw_table(l, stage, &v);
    draw_profile(l, stage);
    draw_source(stage, &v, &source);
    stage_ink(stage, INK_BRIGHT);
    stage_text(stage, 20, 760, what[which]);
    stage_caption(
        stage,
        "A source with an extent is many points that share its intensity: its light is spread, and "
        "falls off more slowly.");
}

/* ---- Mach bands ------------------------------------------------------------------------------ */

void shading_mach_begin(struct shading_lesson *l)
{
    (void)l;
}

void shading_mach(struct shading_lesson *l, struct stage *stage, float t)
{
    static struct eye_profile profile;
    bool interpolated = l->shading >= 0 ? l->shading > 0 : (int)(t / 8) % 2 == 1;
    int facets = 5 + (int)(t / 2) % 4 * 2;
    eye_profile_make(&profile, facets, interpolated);
    eye_mach_draw(stage, &profile);
    stage_ink(stage, INK_BRIGHT);
    stage_text(stage, 860, 385, interpolated ? "Gouraud" : "flat");
    stage_caption(
        stage,
        interpolated
            ? "Interpolated: no steps are left, but at every bend of the intensity (yellow) the "
              "eye "
              "still sees a stripe (red)."
            : "Each strip is of one intensity (yellow). Beside its darker neighbour it looks "
              "brighter: that is what the eye makes of it (red).");
}

/* ---- few levels ------------------------------------------------------------------------------ */

void shading_dither_begin(struct shading_lesson *l)
{
    (void)l;
}

void shading_dither(struct shading_lesson *l, struct stage *stage, float t)
{
    static const char *const labels[] = {"nearest level", "Bayer 4 x 4", "Bayer 8 x 8",
                                         "Floyd-Steinberg"};
    static const int counts[] = {2, 3, 4, 8};
    int levels = counts[l->shading >= 0 ? l->shading : (int)(t / 4) % 4];
    char text[32];
    for (int i = 0; i < DITHER_METHODS; i++) {
        float x = i % 2 ? 890 : 310, y = i < 2 ? 610 : 205;
        eye_halftone_draw(stage, x, y, 165, levels, (enum dither_method)i);
        stage_ink(stage, INK_TEXT);
        stage_text_middle(stage, x, y - 195, labels[i]);
    }
    snprintf(text, sizeof text, "%d", levels);
    stage_ink(stage, INK_BRIGHT);
    stage_text_middle(stage, 600, 430, text);
    stage_text_middle(stage, 600, 395, "levels");
    stage_caption(stage, "Every ball is made of these few levels. Dots that are close together are "
                         "seen as their mean.");
}
