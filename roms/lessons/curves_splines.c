/* curves_splines.c — pages about splines: natural and clamped, tension, B-splines. */
#include <stdio.h>

#include "roms/lessons/curves.h"

static void words_at(struct stage *s, float x, float y, enum ink ink, const char *format, float a)
{
    char text[48];
    snprintf(text, sizeof text, format, (double)a);
    pen_words(s, x, y, ink, text);
}

/* ---- natural and clamped ---- */

static void splines(const struct curves_view *v, struct stage *s)
{
    struct spline natural, clamped;
    float angle = (v->value - 0.5f) * 4.4f;
    struct vector3 slope0 = {700 * cosf(angle), 700 * sinf(angle), 0};
    struct vector3 slope1 = {700 * cosf(angle), -700 * sinf(angle), 0};
    if (!spline_natural(v->point, v->count, SPLINE_UNIFORM, &natural) ||
        !spline_clamped(v->point, v->count, SPLINE_UNIFORM, slope0, slope1, &clamped))
        return;
    pen_spline(s, &natural, INK_CYAN);
    pen_spline(s, &clamped, INK_YELLOW);
    pen_arrow(s, v->point[0], vector3_times(slope0, 0.25f), INK_RED);
    pen_arrow(s, v->point[v->count - 1], vector3_times(slope1, 0.25f), INK_RED);
    curves_draw_controls(v, s, INK_GREEN);
    pen_words(s, 300, 30, INK_CYAN, "natural: p\" = 0");
    pen_words(s, 900, 30, INK_YELLOW, "clamped: p' given");
}

const struct curves_page curves_page_splines = {
    .title = "Cubic splines through points",
    .caption = "Both are C2, through all points. How far do the slopes reach?",
    .period = 10,
    .drift = 1,
    .count = 6,
    .start = {{140, 280}, {330, 640}, {520, 260}, {700, 620}, {880, 300}, {1060, 580}},
    .draw = splines};

/* ---- cardinal splines ---- */

/* The first and the last point twice: the curve goes through all. */
static bool cardinal_through(const struct curves_view *v, float tension, struct spline *out)
{
    struct vector3 p[CURVES_PAGE_POINTS + 2];
    p[0] = v->point[0];
    for (int i = 0; i < v->count; i++)
        p[i + 1] = v->point[i];
    p[v->count + 1] = v->point[v->count - 1];
    return spline_cardinal(p, v->count + 2, tension, out);
}

static void tension(const struct curves_view *v, struct stage *s)
{
    static const float others[] = {-1, 0, 1};
    struct spline spline;
    float t = 2 * v->value - 1;
    for (int i = 0; i < 3; i++)
        if (cardinal_through(v, others[i], &spline))
            for (int k = 0; k < spline.pieces; k++) {
                struct vector3 before = spline_point(&spline, (float)k), p;
                for (int n = 1; n <= 10; n++, before = p) {
                    p = spline_point(&spline, (float)k + (float)n / 10);
                    brush_thin(s, before, p, INK_GRID);
                }
            }
    if (!cardinal_through(v, t, &spline))
        return;
    pen_spline(s, &spline, INK_YELLOW);
    for (int i = 1; i + 1 < v->count; i++) {
        struct vector3 chord = vector3_difference(v->point[i + 1], v->point[i - 1]);
        pen_arrow(s, v->point[i], vector3_times(chord, (1 - t) / 4), INK_RED);
    }
    curves_draw_controls(v, s, INK_CYAN);
    words_at(s, 600, 30, INK_YELLOW, "tension t = %.2f", t);
}

const struct curves_page curves_page_tension = {
    .title = "Cardinal splines: tension",
    .caption = "p' = (1-t)/2 (next - last). Grey: t = -1, 0 (Catmull-Rom), 1",
    .period = 12,
    .drift = 1,
    .count = 6,
    .start = {{110, 220}, {300, 660}, {520, 210}, {700, 670}, {900, 220}, {1090, 600}},
    .draw = tension};

/* ---- B-splines ---- */

static void b_spline(const struct curves_view *v, struct stage *s)
{
    struct spline spline;
    struct curves_view moved = *v;
    int point = v->chosen >= 0 ? v->chosen : 3;
    if (v->chosen < 0)
        moved.point[point].y += 240 * (v->value - 0.5f);
    if (!spline_b_spline(moved.point, moved.count, &spline))
        return;
    brush_path(s, moved.point, moved.count, INK_GRID);
    for (int i = 0; i < spline.pieces; i++) {
        struct cubic q = cubic_by_matrix(&spline.piece[i]);
        brush_cubic(s, &q, point >= i && point <= i + 3 ? INK_RED : INK_YELLOW);
    }
    for (int i = 0; i <= spline.pieces; i++)
        brush_point(s, spline_point(&spline, spline.knot[i]), 7, INK_GREEN);
    moved.chosen = point;
    curves_draw_controls(&moved, s, INK_CYAN);
    pen_words(s, 600, 30, INK_RED, "one point moves: four pieces at most");
}

const struct curves_page curves_page_b_spline = {
    .title = "Uniform cubic B-spline",
    .caption = "It only comes near its points, but it is C2. Green: where pieces meet.",
    .period = 7,
    .drift = 1,
    .count = 8,
    .start = {{80, 300},
              {220, 620},
              {400, 660},
              {480, 330},
              {660, 250},
              {780, 560},
              {960, 660},
              {1110, 300}},
    .draw = b_spline};
