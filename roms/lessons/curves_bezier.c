/* curves_bezier.c — pages about Bézier curves: de Casteljau's construction, blending functions. */
#include <stdio.h>

#include "roms/curves/casteljau.h"
#include "roms/lessons/curves.h"

static const enum ink levels[] = {INK_CYAN, INK_GREEN, INK_ORANGE, INK_VIOLET, INK_RED};

/* The curve up to u, and the rest behind. */
static void draw_up_to(const struct curves_view *v, struct stage *s, const struct casteljau *c)
{
    struct vector3 left[BEZIER_POINTS_MOST], right[BEZIER_POINTS_MOST];
    casteljau_halves(c, left, right);
    brush_bezier(s, right, v->count, INK_GRID);
    brush_bezier(s, left, v->count, INK_YELLOW);
}

/* A line with a mark at u, and u in big figures. */
static void draw_scale(struct stage *s, float u)
{
    enum { LEFT = 200, RIGHT = 800, Y = 40 };
    char text[16];
    struct vector3 at = {LEFT + (RIGHT - LEFT) * u, Y, 0};
    brush_thin(s, (struct vector3){LEFT, Y, 0}, (struct vector3){RIGHT, Y, 0}, INK_TEXT);
    brush_point(s, at, 12, INK_RED);
    snprintf(text, sizeof text, "u = %.2f", (double)u);
    pen_words(s, 1000, Y - 16, INK_RED, text);
    stage_ink(s, INK_TEXT);
    stage_text_middle(s, LEFT - 24, Y - 8, "0");
    stage_text_middle(s, RIGHT + 24, Y - 8, "1");
}

static void draw_level(struct stage *s, const struct casteljau *c, int level)
{
    static const char *const names[3][4] = {
        {"p01", "p12", "p23", "p34"}, {"p012", "p123", "p234", ""}, {"p0123", "p1234", "", ""}};
    int count = c->count - level;
    for (int i = 0; i + 1 < count; i++)
        brush_line(s, casteljau_at(c, level, i), casteljau_at(c, level, i + 1), levels[level]);
    for (int i = 0; i < count; i++) {
        struct vector3 p = casteljau_at(c, level, i);
        brush_point(s, p, level + 1 == c->count ? 14 : 8,
                    level + 1 == c->count ? INK_RED : levels[level]);
        if (level <= 3 && i < 4 && c->count - 1 > level)
            stage_text(s, p.x + 14, p.y + 10, names[level - 1][i]);
    }
}

static void casteljau(const struct curves_view *v, struct stage *s)
{
    struct casteljau c;
    casteljau_begin(&c, v->point, v->count, v->value);
    while (casteljau_next(&c))
        continue;
    brush_path(s, v->point, v->count, INK_TEXT);
    draw_up_to(v, s, &c);
    for (int level = 1; level < c.count; level++)
        draw_level(s, &c, level);
    curves_draw_controls(v, s, INK_CYAN);
    draw_scale(s, v->value);
}

const struct curves_page curves_page_casteljau = {
    .title = "de Casteljau: divide again",
    .caption = "Each line is divided u : 1 - u. The last point is on the curve.",
    .period = 12,
    .drift = 1,
    .count = 4,
    .start = {{150, 180}, {330, 690}, {860, 700}, {1060, 200}},
    .draw = casteljau};

/* ---- blending functions ---- */

enum { PLOT_LEFT = 690, PLOT_BOTTOM = 170, PLOT_SIZE = 440 };
static const enum ink functions[] = {INK_CYAN, INK_GREEN, INK_ORANGE, INK_VIOLET};

static struct vector3 plot_at(float u, float value)
{
    return (struct vector3){PLOT_LEFT + PLOT_SIZE * u, PLOT_BOTTOM + PLOT_SIZE * value, 0};
}

static void draw_plot(struct stage *s, float u)
{
    enum { STEPS = 32 };
    float before[4], value[4];
    brush_thin(s, plot_at(0, 0), plot_at(1, 0), INK_TEXT);
    brush_thin(s, plot_at(0, 0), plot_at(0, 1), INK_TEXT);
    stage_text_middle(s, PLOT_LEFT, PLOT_BOTTOM - 36, "u = 0");
    stage_text_middle(s, PLOT_LEFT + PLOT_SIZE, PLOT_BOTTOM - 36, "1");
    stage_text_middle(s, PLOT_LEFT - 26, PLOT_BOTTOM + PLOT_SIZE - 8, "1");
    bezier_blending(3, 0, before);
    for (int i = 1; i <= STEPS; i++) {
        bezier_blending(3, (float)i / STEPS, value);
        for (int k = 0; k < 4; k++) {
            brush_line(s, plot_at((float)(i - 1) / STEPS, before[k]),
                       plot_at((float)i / STEPS, value[k]), functions[k]);
            before[k] = value[k];
        }
    }
    brush_thin(s, plot_at(u, 0), plot_at(u, 1), INK_BRIGHT);
    bezier_blending(3, u, value);
    for (int k = 0; k < 4; k++)
        brush_point(s, plot_at(u, value[k]), 10, functions[k]);
}

/* How much each point counts: a disc of that area, and the figure. */
static void draw_weights(const struct curves_view *v, struct stage *s, float u)
{
    float value[4];
    char text[24];
    bezier_blending(3, u, value);
    for (int k = 0; k < 4; k++) {
        brush_point(s, v->point[k], 6 + 46 * sqrtf(value[k]), functions[k]);
        snprintf(text, sizeof text, "%.3f", (double)value[k]);
        stage_text_middle(s, v->point[k].x, v->point[k].y - 84, text);
    }
}

static void blending(const struct curves_view *v, struct stage *s)
{
    static const char *const names[] = {"BEZ0,3", "BEZ1,3", "BEZ2,3", "BEZ3,3"};
    brush_path(s, v->point, 4, INK_GRID);
    draw_weights(v, s, v->value);
    brush_bezier(s, v->point, 4, INK_YELLOW);
    brush_point(s, bezier_point(v->point, 4, v->value), 14, INK_RED);
    draw_plot(s, v->value);
    for (int k = 0; k < 4; k++) {
        stage_ink(s, functions[k]);
        stage_text_middle(s, PLOT_LEFT + 65 + 115 * (float)k, PLOT_BOTTOM + PLOT_SIZE + 40,
                          names[k]);
    }
    if (v->chosen >= 0)
        brush_point(s, v->point[v->chosen], 8, INK_BRIGHT);
}

const struct curves_page curves_page_blending = {
    .title = "How much each point counts",
    .caption = "p(u) = sum of p_k BEZ_k,3(u). The functions sum to 1.",
    .period = 12,
    .drift = 1,
    .count = 4,
    .start = {{80, 230}, {170, 600}, {480, 610}, {570, 240}},
    .draw = blending};
