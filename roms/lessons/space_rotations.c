/* space_rotations.c — turning a house about x, y and z, and about any line. */
#include <math.h>
#include <stdio.h>

#include "roms/geometry/projection_parallel.h"
#include "roms/geometry/rotate_axis.h"
#include "roms/lessons/space_pages.h"
#include "roms/scenery/space_solid.h"

enum { LEFT_WIDTH = 780, COLUMN = 800 };

/* From 0 to 1, slowly at both ends, in the first part of a step; then it stays. */
static float eased(float part)
{
    float t = part / 0.75f;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return t * t * (3 - 2 * t);
}

static struct space_view scene(struct stage *stage, struct space_viewer viewer, float reach)
{
    struct space_view view = {
        .stage = stage,
        .projection = projection_axonometric(-32 + viewer.turn, 22 + viewer.tilt).matrix,
        .scale = LEFT_WIDTH / 2 / reach,
        .x = LEFT_WIDTH / 2 + 20,
        .y = STAGE_HEIGHT * 0.42f};
    return view;
}

/* The rows of a matrix, each number in its column. */
static void show_matrix(struct stage *s, float y, const struct matrix4 *m)
{
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 4; k++) {
            char text[16];
            float v = fabsf(m->at[i][k]) < 0.005f ? 0 : m->at[i][k];
            snprintf(text, sizeof text, "%5.2f", (double)v);
            stage_text(s, COLUMN + 98 * (float)k, y - 42 * (float)i, text);
        }
}

/* ---- about x, y, z --------------------------------------------------------------------------- */

/* A quarter of a circle about the axis, with an arrowhead: which way is positive. */
static void sense(const struct space_view *view, enum axis3 axis, float radius)
{
    enum { PIECES = 12 };
    struct vector3 start = {0, 0, 0}, last;
    struct matrix4 m = transform3_rotate(axis, 10);
    *(axis == AXIS3_X ? &start.y : axis == AXIS3_Y ? &start.z : &start.x) = radius;
    last = matrix4_apply(&m, start);
    for (int i = 1; i <= PIECES; i++) {
        m = transform3_rotate(axis, 10 + 70.0f * (float)i / PIECES);
        struct vector3 next = matrix4_apply(&m, start);
        space_line(view, last, next);
        last = next;
    }
    for (int side = -1; side <= 1; side += 2) {
        m = transform3_rotate(axis, 72);
        struct vector3 wing = matrix4_apply(&m, vector3_times(start, 1 + 0.06f * (float)side));
        space_line(view, last, wing);
    }
}

void space_page_axes(struct stage *stage, float seconds, struct space_viewer viewer)
{
    static const char *const names[] = {"Rx", "Ry", "Rz"};
    static const char *const say[] = {
        "Rx turns y toward z: anticlockwise, seen from the tip of x",
        "Ry turns z toward x: anticlockwise, seen from the tip of y",
        "Rz turns x toward y: anticlockwise, seen from the tip of z",
    };
    enum { LASTS = 6 };
    int axis = (int)(seconds / LASTS) % 3;
    float degrees = 360 * eased((seconds - (float)(axis * LASTS)) / LASTS);
    struct matrix4 m = transform3_rotate((enum axis3)axis, degrees), one = matrix4_identity();
    struct space_view view = scene(stage, viewer, 4.5f);
    char text[32];
    space_axes(&view, 4.6f, false);
    stage_ink(stage, INK_GRID);
    space_draw(&view, &space_house, &one, SPACE_WIRE);
    space_draw(&view, &space_house, &m, SPACE_FILLED);
    stage_ink(stage, INK_YELLOW);
    sense(&view, (enum axis3)axis, 4.2f);
    snprintf(text, sizeof text, "%s( %.0f degrees ) =", names[axis], (double)degrees);
    stage_text(stage, COLUMN, 640, text);
    stage_ink(stage, INK_BRIGHT);
    show_matrix(stage, 580, &m);
    stage_title(stage, "Rotation about an axis");
    stage_caption(stage, say[axis]);
}

/* ---- about a line ---------------------------------------------------------------------------- */

static const struct vector3 line_a = {1.5f, 0.5f, 0}, line_b = {2.5f, 2.5f, 1};
enum { STEP_LASTS = 3, TURN = 120 };

/* A part of a step: as far along, or turned by as much of the angle. */
static struct matrix4 part_of_step(const struct transform3 *t, int step, float part)
{
    static const enum axis3 axes[] = {0, AXIS3_X, AXIS3_Y, AXIS3_Z, AXIS3_Y, AXIS3_X, 0};
    const struct matrix4 *m = &t->step[step].matrix;
    if (step == 0 || step == 6)
        return transform3_translate(
            (struct vector3){part * m->at[0][3], part * m->at[1][3], part * m->at[2][3]});
    int from = ((int)axes[step] + 1) % 3, to = ((int)axes[step] + 2) % 3;
    float angle = part * atan2f(m->at[to][from], m->at[from][from]);
    return transform3_turn(axes[step], sinf(angle), cosf(angle));
}

static void list_steps(struct stage *s, const struct transform3 *t, int now)
{
    static const char *const what[] = {
        "A to the origin", "AB into xz plane", "AB onto the z axis", "turn by 120",
        "undo Ry",         "undo Rx",          "A back to its place"};
    for (int i = 0; i < t->steps; i++) {
        float y = 700 - 44 * (float)i;
        stage_ink(s, i == now ? INK_YELLOW : i < now ? INK_TEXT : INK_GRID);
        stage_text(s, COLUMN - 20, y, t->step[i].name);
        stage_text(s, COLUMN + 80, y, what[i]);
    }
}

static void draw_axis(const struct space_view *view, const struct matrix4 *m)
{
    struct vector3 along = vector3_difference(line_b, line_a);
    struct vector3 low = vector3_difference(line_a, vector3_times(along, 0.6f));
    struct vector3 high = vector3_sum(line_b, vector3_times(along, 0.6f));
    stage_ink(view->stage, INK_YELLOW);
    space_line(view, matrix4_apply(m, low), matrix4_apply(m, high));
    space_text(view, matrix4_apply(m, line_a), "A");
    space_text(view, matrix4_apply(m, line_b), "B");
}

void space_page_line(struct stage *stage, float seconds, struct space_viewer viewer)
{
    static const char *const say[] = {
        "T: the axis shall pass through the origin",
        "Rx by alpha: sin = b/d, cos = c/d, d = sqrt(b^2 + c^2)",
        "Ry by -beta: sin = a, cos = d; now AB is the z axis",
        "Rz: the rotation itself is one about z",
        "Then back, step by step: Ry^-1",
        "Then back, step by step: Rx^-1",
        "T^-1: all back in place, the house turned about AB",
        "M = T^-1 Rx^-1 Ry^-1 Rz Ry Rx T",
    };
    struct rotate_axis r;
    struct matrix4 m = matrix4_identity(), home = transform3_scale((struct vector3){.5f, .5f, .5f});
    int step = (int)(seconds / STEP_LASTS);
    step = step > 7 ? 7 : step;
    rotate_axis(line_a, line_b, TURN, &r);
    for (int i = 0; i < step && i < 7; i++)
        m = matrix4_product(&r.transform.step[i].matrix, &m);
    if (step < 7) {
        struct matrix4 now =
            part_of_step(&r.transform, step, eased(seconds / STEP_LASTS - (float)step));
        m = matrix4_product(&now, &m);
    }
    struct matrix4 model = matrix4_product(&m, &home);
    struct space_view view = scene(stage, viewer, 3.5f);
    space_axes(&view, 3.2f, false);
    stage_ink(stage, INK_GRID);
    space_draw(&view, &space_house, &home, SPACE_WIRE);
    space_draw(&view, &space_house, &model, SPACE_FILLED);
    draw_axis(&view, &m);
    list_steps(stage, &r.transform, step);
    stage_ink(stage, INK_BRIGHT);
    stage_text(stage, COLUMN - 20, 340, "M so far =");
    show_matrix(stage, 290, &m);
    stage_title(stage, "Rotation about any line, in seven steps");
    stage_caption(stage, say[step]);
}
