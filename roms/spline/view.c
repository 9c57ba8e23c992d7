#include "roms/spline/view.h"

#include <stdio.h>

#include "roms/stage/brush.h"
#include "roms/spline/hull.h"

enum { POINT = 9, CHOSEN = 12, HANDLE = 7 };

/* ---- what controls the curve --------------------------------------------------------------------- */

static void draw_polygon(const struct editor *e, struct stage *s)
{
    struct vector3 corner[MODEL_POINTS_MOST + 1];
    int corners = model_polygon(&e->model, corner);
    brush_path(s, corner, corners, INK_GRID);
}

/* Of the piece that the mark is in; of a B-spline, of its four points. */
static void draw_hull(const struct editor *e, const struct curve *c, struct stage *s)
{
    struct point2 corner[BEZIER_POINTS_MOST];
    struct b_spline b;
    int piece = curve_at(c, curve_t(c, e->part)).piece;
    const struct vector3 *points =
        curve_b_spline(&e->model, &b) ? b.point + piece : curve_piece(c, piece);
    int count = convex_hull(points, c->order, corner);
    stage_heads(s, STAGE_RASTER);
    stage_ink(s, (enum ink)ink_shade(RAMP_BLUE, 0.03f));
    stage_area(s, corner, count);
    stage_heads(s, STAGE_BOTH);
    stage_ink(s, INK_BLUE);
    stage_line_type(s, STAGE_LONG_DASH);
    stage_polygon(s, corner, count);
    stage_line_type(s, STAGE_SOLID);
}

static void draw_handles(const struct editor *e, struct stage *s)
{
    for (int i = 0; i < e->model.count; i++)
        for (int side = 0; side < 2; side++) {
            if (!model_has_handle(&e->model, i, side))
                continue;
            struct vector3 at = e->model.point[i].at, end = model_handle(&e->model, i, side);
            brush_thin(s, at, end, INK_GREEN);
            brush_square(s, end, HANDLE, i == e->chosen ? INK_BRIGHT : INK_GREEN);
        }
}

static void draw_points(const struct editor *e, struct stage *s)
{
    char text[8];
    for (int i = 0; i < e->model.count; i++) {
        struct vector3 at = e->model.point[i].at;
        bool chosen = i == e->chosen;
        brush_point(s, at, chosen ? CHOSEN : POINT, chosen ? INK_BRIGHT : INK_CYAN);
        snprintf(text, sizeof text, "%d", i);
        stage_ink(s, INK_CYAN);
        stage_text(s, at.x + 14, at.y + 12, text);
    }
}

static void draw_curve(const struct curve *c, struct stage *s)
{
    for (int i = 0; i < c->pieces; i++)
        brush_bezier(s, curve_piece(c, i), c->order, i % 2 ? INK_ORANGE : INK_YELLOW);
}

/* ---- t ------------------------------------------------------------------------------------------- */

static void draw_slider(const struct editor *e, struct stage *s)
{
    struct vector3 left = {SLIDER_LEFT, SLIDER_Y, 0}, right = {SLIDER_RIGHT, SLIDER_Y, 0};
    struct vector3 at = {SLIDER_LEFT + (SLIDER_RIGHT - SLIDER_LEFT) * e->part, SLIDER_Y, 0};
    brush_thin(s, left, right, INK_TEXT);
    brush_point(s, at, 11, INK_RED);
    stage_ink(s, INK_TEXT);
    stage_text(s, SLIDER_LEFT - 40, SLIDER_Y - 8, "t");
}

/* ---- the picture --------------------------------------------------------------------------------- */

static void draw_with_curve(const struct editor *e, const struct curve *c, struct stage *s)
{
    if (e->hull)
        draw_hull(e, c, s);
    if (e->comb)
        comb_draw(c, s);
    if (e->polygon)
        draw_polygon(e, s);
    draw_curve(c, s);
    draw_handles(e, s);
    draw_points(e, s);
    joints_draw(c, s);
    if (e->construction) {
        construction_draw(e, c, s);
        draw_slider(e, s);
    }
}

void view_draw(const struct editor *e, struct stage *s, struct menu_kept *menu)
{
    struct curve c;
    const char *trouble = curve_of(&e->model, &c);
    menu_draw(e, s, menu);
    if (trouble) {
        draw_polygon(e, s);
        draw_points(e, s);
    } else {
        draw_with_curve(e, &c, s);
    }
    figures_draw(e, &c, trouble, s);
    if (e->near)
        brush_cursor(s, e->at, e->pressed);
}
