/* curves_draw.c — curves, control points and tangents over axes. */
#include "roms/commands/curves.h"

#include <math.h>
#include <stdio.h>

#include "roms/curves/bezier_run.h"

/* Of lines that stand for a curve, stage units: a quarter of a raster head's pixel. */
#define TOLERANCE 0.5f

struct point2 curves_flat(struct vector3 p)
{
    const float half = 0.35355339f; /* half a unit, 45° */
    return (struct point2){p.x - p.z * half, p.y - p.z * half};
}

void curves_include(struct curves_bounds *b, const struct vector3 *points, int count)
{
    for (int i = 0; i < count; i++) {
        struct point2 p = curves_flat(points[i]);
        if (!b->any)
            b->low = b->high = p;
        b->any = true;
        b->low = (struct point2){fminf(b->low.x, p.x), fminf(b->low.y, p.y)};
        b->high = (struct point2){fmaxf(b->high.x, p.x), fmaxf(b->high.y, p.y)};
    }
}

void curves_include_spline(struct curves_bounds *b, const struct spline *s)
{
    enum { STEPS = 16 };
    for (int i = 0; i < s->pieces; i++) {
        struct cubic q = cubic_by_matrix(&s->piece[i]);
        struct cubic_run run;
        struct vector3 p;
        cubic_run_begin(&run, &q, STEPS);
        while (cubic_run_next(&run, &p))
            curves_include(b, &p, 1);
    }
}

/* Points that hardly differ are shown with room about them: axes have figures that differ. */
static void widen(struct curves_bounds *b)
{
    float far =
        fmaxf(fmaxf(fabsf(b->low.x), fabsf(b->high.x)), fmaxf(fabsf(b->low.y), fabsf(b->high.y)));
    float least = fmaxf(0.001f, far * 0.002f);
    if (b->high.x - b->low.x >= least || b->high.y - b->low.y >= least)
        return;
    b->low = (struct point2){b->low.x - least, b->low.y - least};
    b->high = (struct point2){b->high.x + least, b->high.y + least};
}

struct graph curves_frame(struct monitor *m, const char *title, const struct curves_bounds *bounds)
{
    struct curves_bounds b = *bounds;
    widen(&b);
    struct point2 corners[] = {b.low, b.high};
    stage_begin(&m->stage);
    struct graph g = graph_whole(&m->stage, corners, 2);
    graph_axes(&g);
    stage_title(&m->stage, title);
    return g;
}

void curves_draw_lines(const struct graph *g, const struct vector3 *points, int count, enum ink ink)
{
    stage_ink(g->stage, ink);
    for (int i = 1; i < count; i++)
        graph_line(g, curves_flat(points[i - 1]), curves_flat(points[i]));
}

void curves_draw_points(const struct graph *g, char name, const struct vector3 *points, int count,
                        enum ink ink)
{
    char text[16];
    stage_ink(g->stage, ink);
    for (int i = 0; i < count; i++) {
        snprintf(text, sizeof text, "%c%d", name, i);
        graph_marker(g, curves_flat(points[i]));
        graph_text(g, curves_flat(points[i]), text);
    }
}

void curves_draw_bezier(const struct graph *g, const struct vector3 *points, int count,
                        enum ink ink)
{
    struct bezier_run run;
    struct vector3 p;
    bezier_run_begin(&run, points, count, TOLERANCE / g->scale);
    bezier_run_next(&run, &p);
    stage_ink(g->stage, ink);
    for (struct vector3 before = p; bezier_run_next(&run, &p); before = p)
        graph_line(g, curves_flat(before), curves_flat(p));
}

static void draw_cubic(const struct graph *g, const struct cubic *q)
{
    struct cubic_run run;
    struct vector3 p;
    cubic_run_begin(&run, q, cubic_steps(q, TOLERANCE / g->scale));
    cubic_run_next(&run, &p);
    for (struct vector3 before = p; cubic_run_next(&run, &p); before = p)
        graph_line(g, curves_flat(before), curves_flat(p));
}

void curves_draw_spline(const struct graph *g, const struct spline *s, enum ink ink)
{
    stage_ink(g->stage, ink);
    for (int i = 0; i < s->pieces; i++) {
        struct cubic q = cubic_by_matrix(&s->piece[i]);
        draw_cubic(g, &q);
    }
}

void curves_draw_marker(const struct graph *g, struct vector3 at, enum ink ink)
{
    stage_ink(g->stage, ink);
    graph_marker(g, curves_flat(at));
}

void curves_draw_arrow(const struct graph *g, struct vector3 from, struct vector3 along,
                       enum ink ink)
{
    enum { HEAD = 16 };
    struct point2 a = graph_place(g, curves_flat(from));
    struct point2 b = graph_place(g, curves_flat(vector3_sum(from, along)));
    float dx = b.x - a.x, dy = b.y - a.y, length = sqrtf(dx * dx + dy * dy);
    stage_ink(g->stage, ink);
    stage_line(g->stage, a.x, a.y, b.x, b.y);
    if (!(length > HEAD))
        return;
    dx *= HEAD / length;
    dy *= HEAD / length;
    stage_line(g->stage, b.x, b.y, b.x - dx - dy * 0.4f, b.y - dy + dx * 0.4f);
    stage_line(g->stage, b.x, b.y, b.x - dx + dy * 0.4f, b.y - dy - dx * 0.4f);
}
