/* plane.c — the lesson on transformations of the plane: a boat is moved, turned, mirrored, sheared.
 *
 *      page:  steps, first to last ──▶ the boat goes through them ──▶ product so far, as a matrix
 */
#include <math.h>
#include <stdio.h>

#include "roms/clip/liang_barsky.h"
#include "roms/clip/sutherland_hodgman.h"
#include "roms/geometry/transform2.h"
#include "roms/lessons/large_text.h"
#include "roms/lessons/lesson.h"
#include "roms/lessons/pages.h"
#include "roms/stage/graph.h"

/* ---- scenes ---------------------------------------------------------------------------------- */

enum act { TRANSLATE, ROTATE, SCALE, MIRROR_LINE, MIRROR_IN_X, MIRROR_IN_Y, SHEAR_X, SHEAR_Y };
enum { STEPS = 5, WAYS = 2 };

struct step {
    const char *name;
    enum act act;
    float a, b;
};

struct transformation {
    const char *title, *caption;
    struct step way[WAYS]
                   [STEPS]; /* up to one without a name; a second way is drawn beside the first */
    struct point2 mark;     /* pivot, fixed point */
    bool marked, lined;
    float m, c; /* of the mirror */
};

static const struct transformation table[] = {
    {.title = "Translation: x' = x + tx, y' = y + ty",
     .caption = "Every point moves by the same amount: the last column.",
     .way = {{{"T(-5,1.5)", TRANSLATE, -5, 1.5f}, {"T(1,-5)", TRANSLATE, 1, -5}}}},
    {.title = "Rotation about the origin",
     .caption = "Anticlockwise is positive. Lengths stay; R(90) has only 0, 1 and -1.",
     .way = {{{"R(90)", ROTATE, 90, 0}, {"R(120)", ROTATE, 120, 0}, {"R(-60)", ROTATE, -60, 0}}}},
    {.title = "Scaling about the origin",
     .caption = "Above 1: larger and farther from the origin; below 1: the reverse.",
     .way = {{{"S(1.5,1.6)", SCALE, 1.5f, 1.6f}, {"S(0.25,0.5)", SCALE, 0.25f, 0.5f}}}},
    {.title = "Reflection in the axes",
     .caption = "One changes left and right; two together are R(180).",
     .way = {{{"x axis", MIRROR_IN_X, 0, 0}, {"y axis", MIRROR_IN_Y, 0, 0}}}},
    {.title = "Reflection in y = x",
     .caption = "The same as the x axis, then R(90): x and y exchange.",
     .way = {{{"y = x", MIRROR_LINE, 1, 0}},
             {{"x axis", MIRROR_IN_X, 0, 0}, {"R(90)", ROTATE, 90, 0}}},
     .lined = true,
     .m = 1},
    {.title = "Reflection in y = mx + c: five steps",
     .caption = "Bring the mirror onto the x axis, reflect, and go back.",
     .way = {{{"T(0,-2)", TRANSLATE, 0, -2},
              {"R(-26.6)", ROTATE, -26.565f, 0},
              {"x axis", MIRROR_IN_X, 0, 0},
              {"R(26.6)", ROTATE, 26.565f, 0},
              {"T(0,2)", TRANSLATE, 0, 2}}},
     .lined = true,
     .m = 0.5f,
     .c = 2},
    {.title = "Shear: x' = x + k y, then y' = y + k x",
     .caption = "Points of the axis stay, others slide: the farther, the more.",
     .way = {{{"x-shear 0.8", SHEAR_X, 0.8f, 0}, {"y-shear -0.7", SHEAR_Y, -0.7f, 0}}}},
    {.title = "Rotation about a pivot, in three steps",
     .caption = "Pivot to the origin, turn there, and back: one matrix does all three.",
     .way = {{{"T(-3.4,-1.2)", TRANSLATE, -3.4f, -1.2f},
              {"R(75)", ROTATE, 75, 0},
              {"T(3.4,1.2)", TRANSLATE, 3.4f, 1.2f}}},
     .mark = {3.4f, 1.2f},
     .marked = true},
    {.title = "Scaling about a fixed point",
     .caption = "The fixed point stays; everything else moves away from it.",
     .way = {{{"T(-3.4,-0.5)", TRANSLATE, -3.4f, -0.5f},
              {"S(1.8,1.5)", SCALE, 1.8f, 1.5f},
              {"T(3.4,0.5)", TRANSLATE, 3.4f, 0.5f}}},
     .mark = {3.4f, 0.5f},
     .marked = true},
    {.title = "Order matters: matrices do not commute",
     .caption = "Turned and then moved, or moved and then turned: not the same place.",
     .way = {{{"R(90)", ROTATE, 90, 0}, {"T(2.5,0)", TRANSLATE, 2.5f, 0}},
             {{"T(2.5,0)", TRANSLATE, 2.5f, 0}, {"R(90)", ROTATE, 90, 0}}}},
};
enum { PAGES = sizeof table / sizeof table[0] };

/* A part of the way: rotations by a part of the angle, the others on a straight line to the end. */
static struct matrix3 step_matrix(const struct step *s, float part)
{
    struct matrix3 m, same = matrix3_identity();
    switch (s->act) {
    case ROTATE:
        return transform2_rotate(s->a * part);
    case TRANSLATE:
        m = transform2_translate(s->a, s->b);
        break;
    case SCALE:
        m = transform2_scale(s->a, s->b);
        break;
    case MIRROR_LINE:
        m = transform2_reflect_line(s->a, s->b);
        break;
    case MIRROR_IN_X:
        m = transform2_reflect(MIRROR_X_AXIS);
        break;
    case MIRROR_IN_Y:
        m = transform2_reflect(MIRROR_Y_AXIS);
        break;
    case SHEAR_X:
        m = transform2_shear_x(s->a, 0);
        break;
    default:
        m = transform2_shear_y(s->a, 0);
        break;
    }
    for (int i = 0; i < 9; i++)
        m.at[i / 3][i % 3] =
            same.at[i / 3][i % 3] + part * (m.at[i / 3][i % 3] - same.at[i / 3][i % 3]);
    return m;
}

static int steps_of(const struct step *way)
{
    int n = 0;
    while (n < STEPS && way[n].name != NULL)
        n++;
    return n;
}

static int longest(const struct transformation *s)
{
    int a = steps_of(s->way[0]), b = steps_of(s->way[1]);
    return a > b ? a : b;
}

/* ---- the boat -------------------------------------------------------------------------------- */

enum { PARTS = 4, PART_CORNERS = 4 };

static const struct {
    struct point2 corner[PART_CORNERS];
    int count;
    enum ink ink;
} boat[PARTS] = {
    {{{1, 1.2f}, {3.4f, 1.2f}, {2.9f, 0.5f}, {1.5f, 0.5f}}, 4, INK_ORANGE},
    {{{2.3f, 1.4f}, {2.3f, 3.5f}, {3.6f, 1.4f}}, 3, INK_BRIGHT},
    {{{2.1f, 1.4f}, {2.1f, 3.1f}, {1.2f, 1.4f}}, 3, INK_CYAN},
    {{{2.2f, 3.5f}, {2.2f, 4}, {1.5f, 3.75f}}, 3, INK_RED},
};
static const struct point2 mast[2] = {{2.2f, 1.2f}, {2.2f, 4}};
static const struct point2 top = {1.5f, 3.75f}; /* of the pennant: the point P */

static const struct clip_window shown = {-6, -7, 6, 7};

static struct graph graph_of(struct stage *stage)
{
    return (struct graph){.stage = stage,
                          .scale = 55,
                          .left = 0,
                          .bottom = 0,
                          .width = 660,
                          .height = 770,
                          .x_min = shown.x_min,
                          .y_min = shown.y_min,
                          .x_max = shown.x_max,
                          .y_max = shown.y_max};
}

static void draw_part(const struct graph *g, int part, const struct matrix3 *m, bool filled)
{
    static struct sutherland_hodgman work;
    struct point2 p[PART_CORNERS];
    for (int i = 0; i < boat[part].count; i++)
        p[i] = matrix3_apply(m, boat[part].corner[i]);
    clip_sutherland_hodgman(&work, &shown, p, boat[part].count);
    for (int i = 0; i < work.count; i++)
        work.corner[i] = graph_place(g, work.corner[i]);
    if (filled)
        stage_area(g->stage, work.corner, work.count);
    else
        stage_polygon(g->stage, work.corner, work.count);
}

static void draw_boat(const struct graph *g, const struct matrix3 *m)
{
    stage_ink(g->stage, INK_BROWN);
    graph_line(g, matrix3_apply(m, mast[0]), matrix3_apply(m, mast[1]));
    for (int i = 0; i < PARTS; i++) {
        stage_ink(g->stage, boat[i].ink);
        draw_part(g, i, m, true);
    }
}

static void draw_ghost(const struct graph *g, const struct matrix3 *m, enum ink ink)
{
    stage_ink(g->stage, ink);
    for (int i = 0; i < PARTS; i++)
        draw_part(g, i, m, false);
}

/* ---- the picture ----------------------------------------------------------------------------- */

#define STEP_SECONDS 3.2f
#define MOVE_SECONDS 2.2f
#define LAST_SECONDS 3.0f

static void ruled_paper(const struct graph *g)
{
    stage_heads(g->stage, STAGE_RASTER);
    stage_ink(g->stage, (enum ink)ink_shade(RAMP_GREY, 0.03f));
    for (float k = -7; k <= 7; k++) {
        if (fabsf(k) <= 6)
            graph_line(g, (struct point2){k, shown.y_min}, (struct point2){k, shown.y_max});
        graph_line(g, (struct point2){shown.x_min, k}, (struct point2){shown.x_max, k});
    }
    stage_heads(g->stage, STAGE_BOTH);
    stage_ink(g->stage, INK_TEXT);
    graph_axes(g);
}

/* A line through the shown part of the world, after a transformation. */
static void draw_mirror(const struct graph *g, const struct transformation *s,
                        const struct matrix3 *m)
{
    struct point2 a = matrix3_apply(m, (struct point2){-30, s->c - 30 * s->m});
    struct point2 b = matrix3_apply(m, (struct point2){30, s->c + 30 * s->m});
    if (clip_liang_barsky(&shown, &a, &b))
        graph_line(g, a, b);
}

/* The mirror, or the point that stays: where they are, and where the steps so far have brought
 * them. */
static void draw_marks(const struct graph *g, const struct transformation *s,
                       const struct matrix3 *m)
{
    const struct matrix3 same = matrix3_identity();
    if (s->lined) {
        stage_ink(g->stage, INK_GRID);
        draw_mirror(g, s, &same);
        stage_ink(g->stage, INK_GREEN);
        draw_mirror(g, s, m);
    }
    if (s->marked) {
        struct point2 at = matrix3_apply(m, s->mark);
        stage_ink(g->stage, INK_YELLOW);
        graph_marker(g, s->mark);
        graph_marker(g, at);
        graph_text(g, at, s->way[0][1].act == ROTATE ? "pivot" : "fixed");
    }
}

/* Goes one way up to a time: ghosts of what was, the boat where it is. Its product so far. */
static struct matrix3 go(const struct graph *g, const struct step *way, float seconds)
{
    struct matrix3 product = matrix3_identity();
    draw_ghost(g, &product, INK_BLUE);
    for (int i = 0; i < steps_of(way); i++) {
        float part = (seconds - (float)i * STEP_SECONDS - 0.6f) / MOVE_SECONDS;
        if (part <= 0)
            break;
        part = part < 1 ? part * part * (3 - 2 * part) : 1;
        if (i > 0)
            draw_ghost(g, &product, INK_GRID);
        struct matrix3 m = step_matrix(&way[i], part);
        product = transform2_then(&product, &m);
    }
    draw_boat(g, &product);
    return product;
}

enum { PANEL = 680 }; /* where the text beside the graph begins */

static void list_steps(struct stage *s, const struct step *way, float top_row, float seconds)
{
    for (int i = 0; i < steps_of(way); i++) {
        char text[32];
        bool now = seconds >= (float)i * STEP_SECONDS && seconds < (float)(i + 1) * STEP_SECONDS;
        stage_ink(s, now ? INK_YELLOW : seconds < (float)i * STEP_SECONDS ? INK_GRID : INK_TEXT);
        snprintf(text, sizeof text, "%d %s", i + 1, way[i].name);
        large_text(s, PANEL, 730 - ((float)i + top_row) * LARGE_LINE, text);
    }
}

static void point_p(const struct graph *g, const struct matrix3 *m)
{
    stage_ink(g->stage, INK_RED);
    graph_text(g, top, "P");
    graph_text(g, matrix3_apply(m, top), "P'");
}

static void matrix_panel(struct stage *s, const struct matrix3 *m)
{
    char text[48];
    struct point2 p = matrix3_apply(m, top);
    stage_ink(s, INK_GREEN);
    large_text(s, PANEL, 420, "product M");
    stage_ink(s, INK_BRIGHT);
    large_matrix3(s, PANEL - 12, 340, m);
    stage_ink(s, INK_RED);
    snprintf(text, sizeof text, "P  (%.2f,%.2f)", (double)top.x, (double)top.y);
    large_text(s, PANEL, 140, text);
    snprintf(text, sizeof text, "P' (%.2f,%.2f)", (double)p.x, (double)p.y);
    large_text(s, PANEL, 140 - LARGE_LINE, text);
}

static float draw(void *own, struct stage *stage, int page, float seconds)
{
    (void)own;
    const struct transformation *s = &table[page];
    struct graph g = graph_of(stage);
    ruled_paper(&g);
    struct matrix3 m = go(&g, s->way[0], seconds);
    draw_marks(&g, s, &m);
    if (steps_of(s->way[1]) > 0) {
        go(&g, s->way[1], seconds);
        list_steps(stage, s->way[1], (float)steps_of(s->way[0]) + 0.4f, seconds);
    }
    list_steps(stage, s->way[0], 0, seconds);
    matrix_panel(stage, &m);
    point_p(&g, &m);
    stage_title(stage, s->title);
    stage_caption(stage, s->caption);
    return (float)longest(s) * STEP_SECONDS + LAST_SECONDS;
}

static struct pages pages = {.count = PAGES, .again = 0.04f, .draw = draw};

extern const struct lesson lesson_plane;
const struct lesson lesson_plane = {
    "plane",   "Transformations of the plane", PAGES_KEYS, &pages, pages_begin, pages_key,
    pages_draw};
