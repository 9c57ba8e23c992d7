/* curves_patch.c — page about a Bézier patch: it turns, and one control point moves. */
#include <stdio.h>

#include "roms/curves/bezier_patch.h"
#include "roms/lessons/curves.h"
#include "roms/raster/polygon_fill.h"

enum { CELLS = 12, FACES = CELLS * CELLS, CURVES = 8 };

/* Turned about the upright axis, then tilted toward the viewer. */
struct patch_view {
    float c, s; /* of the turn */
    float tilt_c, tilt_s;
};

static struct vector3 turn(const struct patch_view *view, struct vector3 p)
{
    float x = view->c * p.x - view->s * p.y, away = view->s * p.x + view->c * p.y;
    return (struct vector3){x, away * view->tilt_s + p.z * view->tilt_c,
                            p.z * view->tilt_s - away * view->tilt_c};
}

/* On the stage; z: depth, larger is nearer. */
static struct vector3 seen(const struct patch_view *view, struct vector3 p)
{
    const float scale = 172;
    struct vector3 t = turn(view, p);
    return (struct vector3){600 + scale * t.x, 415 + scale * t.y, t.z};
}

static struct bezier_patch patch_of(float value)
{
    static const float heights[4][4] = {
        {-1, 0.2f, 0.6f, -0.6f}, {0.3f, 0, 0, 0.8f}, {0.7f, 0, 1.2f, -0.2f}, {-0.8f, 0.9f, 0, -1}};
    struct bezier_patch patch;
    for (int j = 0; j < 4; j++)
        for (int k = 0; k < 4; k++)
            patch.at[j][k] =
                (struct vector3){1.2f * ((float)k - 1.5f), 1.2f * ((float)j - 1.5f), heights[j][k]};
    patch.at[1][1].z = 5.4f * value - 2.7f;
    return patch;
}

/* ---- raster head: shaded faces, the far ones first ---- */

struct face {
    int cell;
    float depth;
};

static void sort_faces(struct face *face)
{
    for (int i = 1; i < FACES; i++) {
        struct face f = face[i];
        int k = i;
        for (; k > 0 && face[k - 1].depth > f.depth; k--)
            face[k] = face[k - 1];
        face[k] = f;
    }
}

static float light_on(const struct bezier_patch *patch, const struct patch_view *view, float u,
                      float v)
{
    static const struct vector3 light = {-0.45f, 0.6f, 0.66f};
    struct vector3 n = turn(view, bezier_patch_normal(patch, u, v));
    float facing = n.z < 0 ? -vector3_dot(n, light) : vector3_dot(n, light);
    return 0.06f + 0.64f * fmaxf(facing, 0);
}

static void draw_face(struct stage *s, const struct bezier_patch *patch,
                      const struct patch_view *view, struct vector3 (*at)[CELLS + 1], int cell)
{
    int j = cell / CELLS, k = cell % CELLS;
    const struct vector3 corner[] = {at[j][k], at[j][k + 1], at[j + 1][k + 1], at[j + 1][k]};
    struct point2 q[4];
    for (int i = 0; i < 4; i++)
        q[i] = (struct point2){stage_canvas_x(s, corner[i].x), stage_canvas_y(s, corner[i].y)};
    float u = ((float)j + 0.5f) / CELLS, v = ((float)k + 0.5f) / CELLS;
    bool back = turn(view, bezier_patch_normal(patch, u, v)).z < 0;
    canvas_polygon(&s->canvas, q, 4, POLYGON_EVEN_ODD,
                   ink_shade(back ? RAMP_BLUE : RAMP_COPPER, light_on(patch, view, u, v)));
}

static void draw_faces(struct stage *s, const struct bezier_patch *patch,
                       const struct patch_view *view)
{
    struct vector3 at[CELLS + 1][CELLS + 1];
    struct face face[FACES];
    for (int j = 0; j <= CELLS; j++)
        for (int k = 0; k <= CELLS; k++)
            at[j][k] = seen(view, bezier_patch_point(patch, (float)j / CELLS, (float)k / CELLS));
    for (int i = 0; i < FACES; i++) {
        int j = i / CELLS, k = i % CELLS;
        face[i] =
            (struct face){i, at[j][k].z + at[j][k + 1].z + at[j + 1][k].z + at[j + 1][k + 1].z};
    }
    sort_faces(face);
    for (int i = 0; i < FACES; i++)
        draw_face(s, patch, view, at, face[i].cell);
}

/* ---- both heads: the control net; vector head: curves ---- */

static void draw_net(struct stage *s, const struct bezier_patch *patch,
                     const struct patch_view *view)
{
    for (int j = 0; j < 4; j++) {
        struct vector3 row[4], column[4];
        for (int k = 0; k < 4; k++) {
            row[k] = seen(view, patch->at[j][k]);
            column[k] = seen(view, patch->at[k][j]);
        }
        brush_path(s, row, 4, INK_TEXT);
        brush_path(s, column, 4, INK_TEXT);
        for (int k = 0; k < 4; k++)
            brush_point(s, row[k], j == 1 && k == 1 ? 16 : 8,
                        j == 1 && k == 1 ? INK_RED : INK_CYAN);
    }
}

static void draw_curves(struct stage *s, const struct bezier_patch *patch,
                        const struct patch_view *view)
{
    for (int i = 0; i <= CURVES; i++) {
        struct vector3 along_v[4], along_u[4];
        bezier_patch_along_v(patch, (float)i / CURVES, along_v);
        bezier_patch_along_u(patch, (float)i / CURVES, along_u);
        for (int k = 0; k < 4; k++) {
            along_v[k] = seen(view, along_v[k]);
            along_u[k] = seen(view, along_u[k]);
            along_v[k].z = along_u[k].z = 0;
        }
        brush_bezier(s, along_v, 4, INK_YELLOW);
        brush_bezier(s, along_u, 4, INK_YELLOW);
    }
}

static void patch_page(const struct curves_view *v, struct stage *s)
{
    float angle = 0.5f + 0.35f * v->clock;
    const struct patch_view view = {cosf(angle), sinf(angle), 0.83f, 0.56f};
    struct bezier_patch patch = patch_of(v->value);
    draw_faces(s, &patch, &view);
    stage_heads(s, STAGE_VECTOR);
    draw_curves(s, &patch, &view);
    stage_heads(s, STAGE_BOTH);
    draw_net(s, &patch, &view);
}

const struct curves_page curves_page_patch = {
    .title = "Bezier patch: 4 x 4 control points",
    .caption = "The surface follows its net; the red point pulls all of it.",
    .period = 9,
    .drift = 0,
    .count = 0,
    .draw = patch_page};
