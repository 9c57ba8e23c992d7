#include "roms/stage/grid.h"

#include <stdio.h>

enum { EDGE = 44 /* for the coordinates, stage units */, SMALLEST_RULED = 8, SMALLEST_FIGURE = 26 };

struct grid grid_fit(struct stage *stage, float left, float bottom, float width, float height,
                     int x0, int y0, int x1, int y1)
{
    struct grid g = {.stage = stage, .x0 = x0 - 1, .y0 = y0 - 1, .x1 = x1 + 1, .y1 = y1 + 1};
    float across = (float)(g.x1 - g.x0 + 1), up = (float)(g.y1 - g.y0 + 1);
    float wide = (width - 2 * EDGE) / across, high = (height - 2 * EDGE) / up;
    g.cell = wide < high ? wide : high;
    g.left = left + (width - g.cell * across) / 2;
    g.bottom = bottom + (height - g.cell * up) / 2;
    return g;
}

struct point2 grid_place(const struct grid *g, float x, float y)
{
    return (struct point2){g->left + (x - (float)g->x0 + 0.5f) * g->cell,
                           g->bottom + (y - (float)g->y0 + 0.5f) * g->cell};
}

static void figures(const struct grid *g)
{
    char text[16];
    int every = g->cell >= 2 * SMALLEST_FIGURE ? 1 : g->cell >= SMALLEST_FIGURE ? 2 : 5;
    for (int x = g->x0; x <= g->x1; x++) {
        struct point2 at = grid_place(g, (float)x, (float)g->y0);
        snprintf(text, sizeof text, "%d", x);
        if (x % every == 0)
            stage_text_middle(g->stage, at.x, g->bottom - 30, text);
    }
    for (int y = g->y0; y <= g->y1; y++) {
        struct point2 at = grid_place(g, (float)g->x0, (float)y);
        snprintf(text, sizeof text, "%d", y);
        if (y % every == 0)
            stage_text_middle(g->stage, g->left - 26, at.y - 8, text);
    }
}

void grid_rules(const struct grid *g)
{
    float right = g->left + g->cell * (float)(g->x1 - g->x0 + 1);
    float top = g->bottom + g->cell * (float)(g->y1 - g->y0 + 1);
    stage_ink(g->stage, INK_GRID);
    for (int x = g->x0; x <= g->x1 + 1 && g->cell >= SMALLEST_RULED; x++) {
        float at = g->left + (float)(x - g->x0) * g->cell;
        stage_line(g->stage, at, g->bottom, at, top);
    }
    for (int y = g->y0; y <= g->y1 + 1 && g->cell >= SMALLEST_RULED; y++) {
        float at = g->bottom + (float)(y - g->y0) * g->cell;
        stage_line(g->stage, g->left, at, right, at);
    }
    figures(g);
}

void grid_run(const struct grid *g, int y, int x0, int x1, enum ink ink)
{
    x0 = x0 < g->x0 ? g->x0 : x0;
    x1 = x1 > g->x1 ? g->x1 : x1;
    if (y < g->y0 || y > g->y1 || x0 > x1)
        return;
    float gap = g->cell >= SMALLEST_RULED ? g->cell * 0.12f : 0;
    struct point2 low = grid_place(g, (float)x0 - 0.5f, (float)y - 0.5f);
    struct point2 high = grid_place(g, (float)x1 + 0.5f, (float)y + 0.5f);
    struct point2 corners[] = {{low.x + gap, low.y + gap},
                               {high.x - gap, low.y + gap},
                               {high.x - gap, high.y - gap},
                               {low.x + gap, high.y - gap}};
    stage_ink(g->stage, ink);
    stage_area(g->stage, corners, 4);
}

void grid_pixel(const struct grid *g, int x, int y, enum ink ink)
{
    grid_run(g, y, x, x, ink);
}

void grid_candidate(const struct grid *g, int x, int y, enum ink ink)
{
    float gap = g->cell * 0.06f;
    if (x < g->x0 || x > g->x1 || y < g->y0 || y > g->y1)
        return;
    struct point2 low = grid_place(g, (float)x - 0.5f, (float)y - 0.5f);
    stage_ink(g->stage, ink);
    stage_rectangle(g->stage, low.x + gap, low.y + gap, g->cell - 2 * gap, g->cell - 2 * gap);
}

void grid_line(const struct grid *g, float x0, float y0, float x1, float y1, enum ink ink)
{
    struct point2 a = grid_place(g, x0, y0), b = grid_place(g, x1, y1);
    stage_ink(g->stage, ink);
    stage_line(g->stage, a.x, a.y, b.x, b.y);
}
