#include "roms/stage/grid.h"

#include <stdio.h>

#include "roms/clip/liang_barsky.h"

enum {
    EDGE = 44,   /* above and below, for the coordinates; stage units */
    MARGIN = 12, /* beside those on the left */
    SMALLEST_RULED = 8,
    FIGURE_WIDTH = 17, /* of a digit, with what is between */
    FIGURE_HEIGHT = 26,
};

/* Characters of the longest coordinate. */
static int longest(int low, int high)
{
    char text[16];
    int a = snprintf(text, sizeof text, "%d", low), b = snprintf(text, sizeof text, "%d", high);
    return a > b ? a : b;
}

struct grid grid_fit(struct stage *stage, float left, float bottom, float width, float height,
                     int x0, int y0, int x1, int y1)
{
    struct grid g = {.stage = stage, .x0 = x0 - 1, .y0 = y0 - 1, .x1 = x1 + 1, .y1 = y1 + 1};
    float across = (float)(g.x1 - g.x0 + 1), up = (float)(g.y1 - g.y0 + 1);
    float edge = (float)(MARGIN + FIGURE_WIDTH * longest(g.y0, g.y1));
    float wide = (width - 2 * edge) / across, high = (height - 2 * EDGE) / up;
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

/* 1, 2 or 5 times a power of ten: so many cells are at least `room` long. */
static int every(const struct grid *g, float room)
{
    int step = 1, power = 1;
    static const int digits[] = {1, 2, 5};
    for (int i = 0; (float)step * g->cell < room && power <= 1000000; i++) {
        step = digits[i % 3] * power;
        power *= i % 3 == 2 ? 10 : 1;
    }
    return step;
}

/* The first multiple from `low` on. */
static int first_of(int step, int low)
{
    int rest = low % step;
    return low - rest + (rest > 0 ? step : 0);
}

bool grid_ruled(const struct grid *g)
{
    return g->cell >= SMALLEST_RULED;
}

static void figures(const struct grid *g)
{
    char text[16];
    int length = longest(g->x0, g->x1);
    int step = every(g, (float)(FIGURE_WIDTH * (length + (length > 1))));
    for (int x = first_of(step, g->x0); x <= g->x1; x += step) {
        struct point2 at = grid_place(g, (float)x, (float)g->y0);
        snprintf(text, sizeof text, "%d", x);
        stage_text_middle(g->stage, at.x, g->bottom - 30, text);
    }
    step = every(g, FIGURE_HEIGHT);
    for (int y = first_of(step, g->y0); y <= g->y1; y += step) {
        struct point2 at = grid_place(g, (float)g->x0, (float)y);
        length = snprintf(text, sizeof text, "%d", y);
        stage_text_middle(g->stage, g->left - MARGIN - 0.5f * (float)(FIGURE_WIDTH * length),
                          at.y - 8, text);
    }
}

void grid_rules(const struct grid *g)
{
    float right = g->left + g->cell * (float)(g->x1 - g->x0 + 1);
    float top = g->bottom + g->cell * (float)(g->y1 - g->y0 + 1);
    stage_ink(g->stage, INK_GRID);
    for (int x = g->x0; x <= g->x1 + 1 && grid_ruled(g); x++) {
        float at = g->left + (float)(x - g->x0) * g->cell;
        stage_line(g->stage, at, g->bottom, at, top);
    }
    for (int y = g->y0; y <= g->y1 + 1 && grid_ruled(g); y++) {
        float at = g->bottom + (float)(y - g->y0) * g->cell;
        stage_line(g->stage, g->left, at, right, at);
    }
    figures(g);
}

/* Cells too small for rules: the run's middle line on the vector head; on the raster head, too,
 * where cells are smaller than dots. */
static void small_run(const struct grid *g, struct point2 low, struct point2 high)
{
    unsigned heads = g->stage->heads;
    float half = g->cell * 0.5f, y = low.y + half;
    struct point2 corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
    stage_heads(g->stage, heads & STAGE_RASTER);
    if (g->cell * g->stage->dots >= 1.5f)
        stage_area(g->stage, corners, 4);
    else
        stage_line(g->stage, low.x + half, y, high.x - half, y);
    stage_heads(g->stage, heads & STAGE_VECTOR);
    if (high.x - low.x > 1.5f * g->cell)
        stage_line(g->stage, low.x + half, y, high.x - half, y);
    else
        stage_dot(g->stage, low.x + half, y);
    stage_heads(g->stage, heads);
}

void grid_run(const struct grid *g, int y, int x0, int x1, enum ink ink)
{
    x0 = x0 < g->x0 ? g->x0 : x0;
    x1 = x1 > g->x1 ? g->x1 : x1;
    if (y < g->y0 || y > g->y1 || x0 > x1)
        return;
    float gap = g->cell * 0.12f;
    struct point2 low = grid_place(g, (float)x0 - 0.5f, (float)y - 0.5f);
    struct point2 high = grid_place(g, (float)x1 + 0.5f, (float)y + 0.5f);
    stage_ink(g->stage, ink);
    if (!grid_ruled(g)) {
        small_run(g, low, high);
        return;
    }
    struct point2 corners[] = {{low.x + gap, low.y + gap},
                               {high.x - gap, low.y + gap},
                               {high.x - gap, high.y - gap},
                               {low.x + gap, high.y - gap}};
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
    struct clip_window shown = {(float)g->x0 - 0.5f, (float)g->y0 - 0.5f, (float)g->x1 + 0.5f,
                                (float)g->y1 + 0.5f};
    struct point2 a = {x0, y0}, b = {x1, y1};
    if (!clip_liang_barsky(&shown, &a, &b))
        return;
    a = grid_place(g, a.x, a.y);
    b = grid_place(g, b.x, b.y);
    stage_ink(g->stage, ink);
    stage_line(g->stage, a.x, a.y, b.x, b.y);
}
