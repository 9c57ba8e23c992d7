#include "roms/stage/graph.h"

#include <math.h>
#include <stdio.h>

struct graph graph_fit(struct stage *stage, float left, float bottom, float width, float height,
                       const struct point2 *points, int count)
{
    enum { MARGIN = 60 }; /* for the axes' figures */
    struct point2 low = {0, 0}, high = {0, 0};
    for (int i = 0; i < count; i++) {
        low.x = i == 0 || points[i].x < low.x ? points[i].x : low.x;
        low.y = i == 0 || points[i].y < low.y ? points[i].y : low.y;
        high.x = i == 0 || points[i].x > high.x ? points[i].x : high.x;
        high.y = i == 0 || points[i].y > high.y ? points[i].y : high.y;
    }
    float across = high.x - low.x, up = high.y - low.y;
    if (across <= 0 && up <= 0)
        across = up = 1;
    float sx = (width - 2 * MARGIN) / across, sy = (height - 2 * MARGIN) / up;
    struct graph g = {.stage = stage,
                      .left = left,
                      .bottom = bottom,
                      .width = width,
                      .height = height,
                      .scale = across <= 0 || sy < sx ? sy : sx};
    g.x_min = (low.x + high.x) / 2 - width / 2 / g.scale;
    g.y_min = (low.y + high.y) / 2 - height / 2 / g.scale;
    g.x_max = g.x_min + width / g.scale;
    g.y_max = g.y_min + height / g.scale;
    return g;
}

struct graph graph_whole(struct stage *stage, const struct point2 *points, int count)
{
    return graph_fit(stage, 0, 0, STAGE_WIDTH, STAGE_HEIGHT, points, count);
}

struct point2 graph_place(const struct graph *g, struct point2 w)
{
    return (struct point2){g->left + (w.x - g->x_min) * g->scale,
                           g->bottom + (w.y - g->y_min) * g->scale};
}

void graph_line(const struct graph *g, struct point2 a, struct point2 b)
{
    a = graph_place(g, a);
    b = graph_place(g, b);
    stage_line(g->stage, a.x, a.y, b.x, b.y);
}

void graph_polyline(const struct graph *g, const struct point2 *p, int count)
{
    for (int i = 1; i < count; i++)
        graph_line(g, p[i - 1], p[i]);
}

void graph_polygon(const struct graph *g, const struct point2 *p, int count)
{
    graph_polyline(g, p, count);
    if (count > 2)
        graph_line(g, p[count - 1], p[0]);
}

void graph_marker(const struct graph *g, struct point2 at)
{
    at = graph_place(g, at);
    stage_marker(g->stage, at.x, at.y);
}

void graph_text(const struct graph *g, struct point2 at, const char *text)
{
    at = graph_place(g, at);
    stage_text(g->stage, at.x + 10, at.y + 8, text);
}

/* ---- axes --------------------------------------------------------------------------------------- */

/* 1, 2 or 5 times a power of ten: the smallest that is at least so much. */
static float round_step(float at_least)
{
    float power = powf(10, floorf(log10f(at_least)));
    float digit = at_least / power;
    return power * (digit <= 1 ? 1 : digit <= 2 ? 2 : digit <= 5 ? 5 : 10);
}

static void figure(const struct graph *g, struct point2 at, float value)
{
    char text[16];
    snprintf(text, sizeof text, "%g", (double)value);
    stage_text_middle(g->stage, at.x, at.y, text);
}

void graph_axes(const struct graph *g)
{
    enum { APART = 110, TICK = 6 };
    float step = round_step(APART / g->scale);
    float y0 = fminf(fmaxf(0, g->y_min), g->y_max), x0 = fminf(fmaxf(0, g->x_min), g->x_max);
    enum ink ink = g->stage->ink;
    stage_ink(g->stage, INK_GRID);
    graph_line(g, (struct point2){g->x_min, y0}, (struct point2){g->x_max, y0});
    graph_line(g, (struct point2){x0, g->y_min}, (struct point2){x0, g->y_max});
    for (float k = ceilf(g->x_min / step + 0.2f); k * step < g->x_max - 0.2f * step; k++) {
        struct point2 at = graph_place(g, (struct point2){k * step, y0});
        stage_line(g->stage, at.x, at.y - TICK, at.x, at.y + TICK);
        if (k != 0)
            figure(g, (struct point2){at.x, at.y - 30}, k * step);
    }
    for (float k = ceilf(g->y_min / step + 0.2f); k * step < g->y_max - 0.2f * step; k++) {
        struct point2 at = graph_place(g, (struct point2){x0, k * step});
        stage_line(g->stage, at.x - TICK, at.y, at.x + TICK, at.y);
        if (k != 0)
            figure(g, (struct point2){at.x - 34, at.y - 8}, k * step);
    }
    stage_ink(g->stage, ink);
}
