#include "roms/stage/graph.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>

#include "roms/geometry/scalar.h"

/* Beyond these a point of the world is not looked at: squares and differences stay finite. */
#define FARTHEST 1e15f
/* A window is not narrower than this part of its distance from the origin: floats must tell its
 * ends apart. */
#define NARROWEST 1e-5f

struct box {
    struct point2 low, high;
};

static struct box box_of(const struct point2 *points, int count)
{
    struct box b = {{0, 0}, {0, 0}};
    bool first = true;
    for (int i = 0; i < count; i++) {
        struct point2 p = points[i];
        if (!(fabsf(p.x) <= FARTHEST && fabsf(p.y) <= FARTHEST))
            continue;
        b.low.x = first || p.x < b.low.x ? p.x : b.low.x;
        b.low.y = first || p.y < b.low.y ? p.y : b.low.y;
        b.high.x = first || p.x > b.high.x ? p.x : b.high.x;
        b.high.y = first || p.y > b.high.y ? p.y : b.high.y;
        first = false;
    }
    return b;
}

struct graph graph_fit(struct stage *stage, float left, float bottom, float width, float height,
                       const struct point2 *points, int count)
{
    enum { MARGIN = 60 }; /* for the axes' figures */
    struct box b = box_of(points, count);
    float x = (b.low.x + b.high.x) / 2, y = (b.low.y + b.high.y) / 2;
    float across = b.high.x - b.low.x, up = b.high.y - b.low.y;
    float least = scalar_max(NARROWEST * scalar_max(fabsf(x), fabsf(y)), 1e-15f);
    if (scalar_max(across, up) <= least)
        across = up =
            scalar_max(x == 0 && y == 0 ? 1 : 0.5f * scalar_max(fabsf(x), fabsf(y)), least);
    float sx = scalar_max(width - 2 * MARGIN, 1) / scalar_max(across, least);
    float sy = scalar_max(height - 2 * MARGIN, 1) / scalar_max(up, least);
    struct graph g = {.stage = stage,
                      .left = left,
                      .bottom = bottom,
                      .width = width,
                      .height = height,
                      .scale = scalar_min(sx, sy)};
    g.x_min = x - width / 2 / g.scale;
    g.y_min = y - height / 2 / g.scale;
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

/* ---- axes ------------------------------------------------------------------------------------ */

enum { APART = 110, TICK = 6, MOST_TICKS = 64, FIGURE = 16 };

/* 1, 2 or 5 times a power of ten: the smallest that is at least so much. */
static float round_step(float at_least)
{
    float power = powf(10, floorf(log10f(at_least)));
    float digit = at_least / power;
    return power * (digit <= 1 ? 1 : digit <= 2 ? 2 : digit <= 5 ? 5 : 10);
}

/* As many decimals as the step has; huge and tiny ones with an exponent. */
static int figure(char text[FIGURE], float value, float step)
{
    int decimals = step < 1 ? (int)ceilf(-log10f(step) - 0.01f) : 0;
    if (fabsf(value) >= 1e6f || decimals > 4)
        return snprintf(text, FIGURE, "%.6g", (double)value);
    return snprintf(text, FIGURE, "%.*f", decimals, (double)value);
}

/* Ticks at multiples of a step, none at the very ends. */
struct ticks {
    float step;
    float first; /* in steps */
    int count;
};

static struct ticks ticks(float low, float high, float step)
{
    struct ticks t = {.step = step, .first = ceilf(low / step + 0.2f)};
    float last = floorf(high / step - 0.2f);
    t.count = (int)scalar_min(scalar_max(last - t.first + 1, 0), MOST_TICKS);
    return t;
}

/* The figures of an axis along x: every n-th, so that they stand clear of each other. */
static int every(const struct graph *g, const struct ticks *t)
{
    char text[FIGURE];
    int longest = 0, n = 1;
    for (int i = 0; i < t->count; i++) {
        int length = figure(text, (t->first + (float)i) * t->step, t->step);
        longest = length > longest ? length : longest;
    }
    while ((float)n * t->step * g->scale < (float)((longest + 1) * STAGE_CHARACTER) &&
           n < MOST_TICKS)
        n++;
    return n;
}

/* Below the axis, or above it where there is no room below. */
static void x_axis(const struct graph *g, float step, float y0)
{
    char text[FIGURE];
    struct ticks t = ticks(g->x_min, g->x_max, step);
    int n = every(g, &t);
    for (int i = 0; i < t.count; i++) {
        float k = t.first + (float)i;
        struct point2 at = graph_place(g, (struct point2){k * step, y0});
        stage_ink(g->stage, INK_GRID);
        stage_line(g->stage, at.x, at.y - TICK, at.x, at.y + TICK);
        figure(text, k * step, step);
        stage_ink(g->stage, INK_TEXT);
        if (k != 0 && fmodf(k, (float)n) == 0)
            stage_text_middle(g->stage, at.x, at.y - g->bottom < 36 ? at.y + 14 : at.y - 32, text);
    }
}

/* Left of the axis, or right of it where there is no room on the left. */
static void y_axis(const struct graph *g, float step, float x0)
{
    char text[FIGURE];
    struct ticks t = ticks(g->y_min, g->y_max, step);
    for (int i = 0; i < t.count; i++) {
        float k = t.first + (float)i;
        struct point2 at = graph_place(g, (struct point2){x0, k * step});
        stage_ink(g->stage, INK_GRID);
        stage_line(g->stage, at.x - TICK, at.y, at.x + TICK, at.y);
        stage_ink(g->stage, INK_TEXT);
        float wide = (float)(figure(text, k * step, step) * STAGE_CHARACTER);
        float left = at.x - TICK - 6 - wide;
        if (k != 0)
            stage_text(g->stage, left < g->left ? at.x + TICK + 6 : left, at.y - 8, text);
    }
}

void graph_axes(const struct graph *g)
{
    float step = round_step(APART / g->scale);
    float y0 = scalar_min(scalar_max(0, g->y_min), g->y_max),
          x0 = scalar_min(scalar_max(0, g->x_min), g->x_max);
    enum ink ink = g->stage->ink;
    stage_ink(g->stage, INK_GRID);
    graph_line(g, (struct point2){g->x_min, y0}, (struct point2){g->x_max, y0});
    graph_line(g, (struct point2){x0, g->y_min}, (struct point2){x0, g->y_max});
    x_axis(g, step, y0);
    y_axis(g, step, x0);
    stage_ink(g->stage, ink);
}
