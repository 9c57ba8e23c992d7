/* areas_seed.c — pages: a flood fill spreading; a boundary fill that leaks. */
#include <stdio.h>

#include "roms/lessons/areas.h"
#include "roms/raster/boundary_fill.h"
#include "roms/raster/flood_fill.h"
#include "roms/raster/pixel.h"
#include "roms/stage/grid.h"

enum { WIDEST = 48, HIGHEST = 30, SEEDS = 200 };

/* Pixels to be filled, enlarged; rows go down in the canvas and up in the picture. */
struct scenery {
    uint32_t pixels[WIDEST / 4 * HIGHEST];
    struct canvas canvas;
    struct span_seed seeds[SEEDS];
    struct span_fill fill;
    int spans, filled;
};

static void clear(struct scenery *s, int width, int height)
{
    s->canvas = (struct canvas){.pixels = (uint8_t *)s->pixels,
                                .width = width,
                                .height = height,
                                .bits = 8,
                                .dots_a_row = 1,
                                .pitch = canvas_pitch(width, 8)};
    s->spans = s->filled = 0;
    canvas_clear(&s->canvas, INK_BLACK);
}

/* Closed, through so many points. */
static void boundary(const struct canvas *c, const int (*p)[2], int count, const enum ink *inks)
{
    for (int i = 0; i < count; i++) {
        const int *a = p[i], *b = p[(i + 1) % count];
        canvas_line(c, a[0], a[1], b[0], b[1], inks[i % 4]);
    }
}

static void cells(const struct scenery *s, const struct grid *grid)
{
    const struct canvas *c = &s->canvas;
    for (int y = 0; y < c->height; y++)
        for (int x = 0; x < c->width; x++) {
            uint32_t ink = canvas_pixel(c, x, y);
            int first = x;
            while (x + 1 < c->width && canvas_pixel(c, x + 1, y) == ink)
                x++;
            if (ink != INK_BLACK)
                grid_run(grid, c->height - 1 - y, first, x, (enum ink)ink);
        }
}

/* As many spans as there were in this time; the last one bright, waiting seeds outlined. */
static bool fill(struct scenery *s, const struct grid *grid, int spans)
{
    struct span_filled now = {.x1 = -1};
    bool going = true;
    while (s->spans < spans && (going = span_fill_next(&s->fill, &now))) {
        s->spans++;
        s->filled += now.x1 - now.x0 + 1;
    }
    cells(s, grid);
    if (!going)
        return false;
    int top = s->canvas.height - 1;
    grid_run(grid, top - now.y, now.x0, now.x1, INK_BRIGHT);
    for (int i = 0; i < s->fill.count; i++)
        grid_candidate(grid, s->seeds[i].x, top - s->seeds[i].y, INK_YELLOW);
    return true;
}

static void count(struct stage *s, const struct scenery *scenery, float x, float y)
{
    char text[64];
    stage_ink(s, INK_TEXT);
    snprintf(text, sizeof text, "%d spans, %d pixels, %d seeds wait", scenery->spans,
             scenery->filled, scenery->fill.count);
    stage_text_middle(s, x, y, text);
}

void areas_spreading(struct stage *s, float seconds)
{
    static const int coast[][2] = {{2, 4},   {9, 1},   {20, 3},  {30, 0},  {43, 5}, {41, 13},
                                   {45, 20}, {34, 25}, {27, 22}, {17, 26}, {4, 23}, {7, 13}};
    static const int island[][2] = {{14, 8}, {22, 7}, {24, 14}, {18, 18}, {12, 14}};
    static const int rock[][2] = {{31, 8}, {36, 11}, {33, 18}, {29, 14}};
    static const enum ink inks[] = {INK_ORANGE, INK_GREEN, INK_VIOLET, INK_RED};
    struct scenery scenery;
    clear(&scenery, 46, 27);
    boundary(&scenery.canvas, coast, 12, inks);
    boundary(&scenery.canvas, island, 5, inks);
    boundary(&scenery.canvas, rock, 4, inks);
    flood_fill_begin(&scenery.fill, &scenery.canvas, 10, 18, 4, INK_BLUE, scenery.seeds, SEEDS);
    struct grid grid = grid_fit(s, -30, 0, STAGE_WIDTH + 60, STAGE_HEIGHT + 20, 0, 0, 45, 26);
    fill(&scenery, &grid, (int)(seconds * 4));
    count(s, &scenery, STAGE_WIDTH / 2, 6);
}

static void one_leak(struct stage *s, float left, int connected, int spans)
{
    static const int wall[][2] = {{8, 2}, {13, 2}, {13, 8}, {8, 13}, {2, 7}, {2, 3}, {5, 3}};
    static const enum ink inks[] = {INK_ORANGE, INK_ORANGE, INK_ORANGE, INK_ORANGE};
    struct scenery scenery;
    char text[24];
    clear(&scenery, 16, 16);
    boundary(&scenery.canvas, wall, 7, inks);
    boundary_fill_begin(&scenery.fill, &scenery.canvas, 7, 6, connected, INK_ORANGE, INK_BLUE,
                        scenery.seeds, SEEDS);
    struct grid grid = grid_fit(s, left, 40, 600, 740, 0, 0, 15, 15);
    grid_rules(&grid);
    fill(&scenery, &grid, spans);
    stage_ink(s, INK_BRIGHT);
    snprintf(text, sizeof text, "%d-connected", connected);
    stage_text_middle(s, left + 300, 750, text);
    count(s, &scenery, left + 300, 30);
}

void areas_leak(struct stage *s, float seconds)
{
    int spans = (int)(seconds * 3);
    one_leak(s, 0, 4, spans);
    one_leak(s, 600, 8, spans);
}
