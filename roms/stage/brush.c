#include "roms/stage/brush.h"

#include "roms/curves/bezier_run.h"

#define TOLERANCE 0.7f /* stage units */

void brush_thin(struct stage *s, struct vector3 a, struct vector3 b, enum ink ink)
{
    stage_ink(s, ink);
    stage_line(s, a.x, a.y, b.x, b.y);
}

/* The line, and itself a dot aside. */
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

void brush_line(struct stage *s, struct vector3 a, struct vector3 b, enum ink ink)
{
    stage_ink(s, ink);
    wide(s, a, b);
}

void brush_path(struct stage *s, const struct vector3 *p, int count, enum ink ink)
{
    for (int i = 1; i < count; i++)
        brush_thin(s, p[i - 1], p[i], ink);
}

void brush_bezier(struct stage *s, const struct vector3 *points, int count, enum ink ink)
{
    struct bezier_run run;
    struct vector3 p;
    stage_ink(s, ink);
    bezier_run_begin(&run, points, count, TOLERANCE);
    bezier_run_next(&run, &p);
    for (struct vector3 before = p; bezier_run_next(&run, &p); before = p)
        wide(s, before, p);
}

void brush_cubic(struct stage *s, const struct cubic *q, enum ink ink)
{
    struct cubic_run run;
    struct vector3 p;
    stage_ink(s, ink);
    cubic_run_begin(&run, q, cubic_steps(q, TOLERANCE));
    cubic_run_next(&run, &p);
    for (struct vector3 before = p; cubic_run_next(&run, &p); before = p)
        wide(s, before, p);
}

void brush_point(struct stage *s, struct vector3 at, float r, enum ink ink)
{
    unsigned heads = s->heads;
    int rows = (int)(r * s->dots + 0.5f);
    if (!(at.x >= 0 && at.y >= 0 && at.x <= STAGE_WIDTH && at.y <= STAGE_HEIGHT))
        return;
    stage_ink(s, ink);
    if (heads & STAGE_RASTER)
        canvas_disc(&s->canvas, (int)(stage_canvas_x(s, at.x) + 0.5f),
                    (int)(stage_canvas_y(s, at.y) + 0.5f), canvas_round_dots(&s->canvas, rows),
                    rows, ink);
    stage_heads(s, heads & STAGE_VECTOR);
    struct point2 lozenge[] = {
        {at.x - r, at.y}, {at.x, at.y + r}, {at.x + r, at.y}, {at.x, at.y - r}};
    stage_polygon(s, lozenge, 4);
    stage_heads(s, heads);
}

void brush_square(struct stage *s, struct vector3 at, float half, enum ink ink)
{
    stage_ink(s, ink);
    stage_rectangle(s, at.x - half, at.y - half, 2 * half, 2 * half);
}

void brush_cursor(struct stage *s, struct vector3 at, bool pressed)
{
    enum { INNER = 8, OUTER = 26 };
    stage_ink(s, pressed ? INK_RED : INK_BRIGHT);
    for (int side = -1; side <= 1; side += 2) {
        float inner = (float)(side * INNER), outer = (float)(side * OUTER);
        stage_line(s, at.x + inner, at.y, at.x + outer, at.y);
        stage_line(s, at.x, at.y + inner, at.x, at.y + outer);
    }
    if (pressed)
        stage_rectangle(s, at.x - INNER, at.y - INNER, 2 * INNER, 2 * INNER);
}
