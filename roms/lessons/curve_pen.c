#include "roms/lessons/curve_pen.h"

#include <string.h>

#include "roms/curves/bezier_run.h"
#include "roms/raster/font.h"

#define TOLERANCE 0.7f /* stage units */

void pen_thin(struct stage *s, struct vector3 a, struct vector3 b, enum ink ink)
{
    stage_ink(s, ink);
    stage_line(s, a.x, a.y, b.x, b.y);
}

/* Two dots wide: the line, and itself a dot aside. */
static void wide(struct stage *s, struct vector3 a, struct vector3 b)
{
    unsigned heads = s->heads;
    stage_line(s, a.x, a.y, b.x, b.y);
    if (s->dots <= 0 || !(heads & STAGE_RASTER))
        return;
    float dot = 1 / s->dots, dx = fabsf(b.x - a.x), dy = fabsf(b.y - a.y);
    float across = dx < dy ? dot : 0, up = dx < dy ? 0 : dot;
    stage_heads(s, STAGE_RASTER);
    stage_line(s, a.x + across, a.y + up, b.x + across, b.y + up);
    stage_heads(s, heads);
}

void pen_line(struct stage *s, struct vector3 a, struct vector3 b, enum ink ink)
{
    stage_ink(s, ink);
    wide(s, a, b);
}

void pen_polyline(struct stage *s, const struct vector3 *p, int count, enum ink ink)
{
    for (int i = 1; i < count; i++)
        pen_thin(s, p[i - 1], p[i], ink);
}

void pen_bezier(struct stage *s, const struct vector3 *points, int count, enum ink ink)
{
    struct bezier_run run;
    struct vector3 p;
    stage_ink(s, ink);
    bezier_run_begin(&run, points, count, TOLERANCE);
    bezier_run_next(&run, &p);
    for (struct vector3 before = p; bezier_run_next(&run, &p); before = p)
        wide(s, before, p);
}

void pen_cubic(struct stage *s, const struct cubic *q, enum ink ink)
{
    struct cubic_run run;
    struct vector3 p;
    stage_ink(s, ink);
    cubic_run_begin(&run, q, cubic_steps(q, TOLERANCE));
    cubic_run_next(&run, &p);
    for (struct vector3 before = p; cubic_run_next(&run, &p); before = p)
        wide(s, before, p);
}

void pen_spline(struct stage *s, const struct spline *spline, enum ink ink)
{
    for (int i = 0; i < spline->pieces; i++) {
        struct cubic q = cubic_by_matrix(&spline->piece[i]);
        pen_cubic(s, &q, ink);
    }
}

void pen_point(struct stage *s, struct vector3 at, float radius, enum ink ink)
{
    unsigned heads = s->heads;
    int rows = (int)(radius * s->dots + 0.5f);
    if (at.x < 0 || at.y < 0 || at.x > STAGE_WIDTH || at.y > STAGE_HEIGHT)
        return;
    stage_ink(s, ink);
    if (heads & STAGE_RASTER)
        canvas_disc(&s->canvas, (int)(stage_canvas_x(s, at.x) + 0.5f),
                    (int)(stage_canvas_y(s, at.y) + 0.5f), canvas_round_dots(&s->canvas, rows),
                    rows, ink);
    stage_heads(s, heads & STAGE_VECTOR);
    stage_line(s, at.x - radius, at.y, at.x, at.y + radius);
    stage_line(s, at.x, at.y + radius, at.x + radius, at.y);
    stage_line(s, at.x + radius, at.y, at.x, at.y - radius);
    stage_line(s, at.x, at.y - radius, at.x - radius, at.y);
    stage_heads(s, heads);
}

void pen_arrow(struct stage *s, struct vector3 from, struct vector3 along, enum ink ink)
{
    enum { HEAD = 22 };
    struct vector3 tip = vector3_sum(from, along),
                   d = vector3_times(vector3_direction(along), HEAD);
    pen_line(s, from, tip, ink);
    pen_line(s, tip, (struct vector3){tip.x - d.x - d.y * 0.4f, tip.y - d.y + d.x * 0.4f, 0}, ink);
    pen_line(s, tip, (struct vector3){tip.x - d.x + d.y * 0.4f, tip.y - d.y - d.x * 0.4f, 0}, ink);
}

void pen_words(struct stage *s, float x, float y, enum ink ink, const char *text)
{
    enum { BIG = 2 };
    unsigned heads = s->heads;
    stage_ink(s, ink);
    if (heads & STAGE_RASTER)
        canvas_text_middle(&s->canvas, (int)stage_canvas_x(s, x),
                           (int)stage_canvas_y(s, y) - FONT_HEIGHT * BIG, BIG, BIG, ink, text);
    stage_heads(s, heads & STAGE_VECTOR);
    stage_text_middle(s, x, y, text);
    stage_heads(s, heads);
}

int pen_collect(const struct vector3 bezier[4], int steps, struct point2 *out, int count, int most)
{
    for (int i = count > 0; i <= steps && count < most; i++) {
        struct vector3 p = bezier_point(bezier, 4, (float)i / (float)steps);
        out[count++] = (struct point2){p.x, p.y};
    }
    return count;
}
