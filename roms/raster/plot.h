/* plot.h — a pixel and its mirror images about a middle, without a test for each.
 *
 *      (−x, y) ■ │ ■ (x, y)        struct plot: the address of the middle; a row and a pixel are
 *      ────────┼────────           so many bytes. All images lie within the canvas, or plot_begin
 *      (−x,−y) ■ │ ■ (x,−y)        says no and canvas_dot does it
 *
 * Models:     mirror images in both axes (4), and in the diagonals, too (8); single pixels (1).
 * Cost:       4 images: 1 multiplication, 6 to 10 additions, 4 stores.
 * Domain:     pixels of 8, 16 and 32 bits; others go by canvas_dot.
 * Units:      pixels.
 * Ownership:  plain values.
 * Errors:     none: what lies outside is left out.
 * Source:     elementary.
 */
#ifndef ROMS_RASTER_PLOT_H
#define ROMS_RASTER_PLOT_H

#include <stdbool.h>
#include <stdint.h>

#include "roms/raster/canvas.h"

struct plot {
    const struct canvas *canvas;
    uint8_t *middle;
    int x, y; /* of the middle */
    uint32_t colour;
};

/* False: some pixel within rx and ry of the middle lies outside, or pixels are smaller than a
 * byte. */
static inline bool plot_begin(struct plot *p, const struct canvas *c, int x, int y, int rx, int ry,
                              uint32_t colour)
{
    *p = (struct plot){.canvas = c, .x = x, .y = y, .colour = colour};
    if (c->bits < 8 || x < rx || y < ry || c->width - x <= rx || c->height - y <= ry)
        return false;
    p->middle = c->pixels + (uint32_t)y * c->pitch + (uint32_t)x * (c->bits / 8);
    return true;
}

static inline void plot_store(uint8_t *at, unsigned bits, uint32_t colour)
{
    if (bits == 8)
        *at = (uint8_t)colour;
    else if (bits == 16)
        *(uint16_t *)(void *)at = (uint16_t)colour;
    else
        *(uint32_t *)(void *)at = colour;
}

/* For lines from end to end: one place, and all between the ends lies within the canvas when they
 * do. */
static inline bool plot_begin_line(struct plot *p, const struct canvas *c, int x0, int y0, int x1,
                                   int y1, uint32_t colour)
{
    return plot_begin(p, c, 0, 0, 0, 0, colour) && x0 >= 0 && y0 >= 0 && x1 >= 0 && y1 >= 0 &&
           x0 < c->width && x1 < c->width && y0 < c->height && y1 < c->height;
}

/* Are both ends within ±farthest, so that differences do not overflow? */
static inline bool plot_line_near(int x0, int y0, int x1, int y1, int farthest)
{
    return x0 >= -farthest && x0 <= farthest && y0 >= -farthest && y0 <= farthest &&
           x1 >= -farthest && x1 <= farthest && y1 >= -farthest && y1 <= farthest;
}

/* `bits` is a constant where these are called: 8, 16 or 32 after plot_begin, 0 after its no. */
static inline void plot_1(const struct plot *p, unsigned bits, int x, int y)
{
    if (bits == 0)
        canvas_dot(p->canvas, x, y, p->colour);
    else
        plot_store(p->middle + y * (int)p->canvas->pitch + x * (int)(bits / 8), bits, p->colour);
}

static inline void plot_4(const struct plot *p, unsigned bits, int x, int y)
{
    if (bits == 0) {
        canvas_dot(p->canvas, p->x + x, p->y + y, p->colour);
        canvas_dot(p->canvas, p->x - x, p->y + y, p->colour);
        canvas_dot(p->canvas, p->x + x, p->y - y, p->colour);
        canvas_dot(p->canvas, p->x - x, p->y - y, p->colour);
        return;
    }
    int row = y * (int)p->canvas->pitch, dots = x * (int)(bits / 8);
    uint8_t *lower = p->middle + row, *upper = p->middle - row;
    plot_store(lower + dots, bits, p->colour);
    plot_store(lower - dots, bits, p->colour);
    plot_store(upper + dots, bits, p->colour);
    plot_store(upper - dots, bits, p->colour);
}

static inline void plot_8(const struct plot *p, unsigned bits, int x, int y)
{
    plot_4(p, bits, x, y);
    plot_4(p, bits, y, x);
}

/* Calls draw(plot, bits, …) with the constant for the canvas: one copy of the loop a format. */
#define PLOT_EACH_FORMAT(draw, plot, whole, ...)                                                   \
    do {                                                                                           \
        if (!(whole))                                                                              \
            draw(plot, 0, __VA_ARGS__);                                                            \
        else if ((plot)->canvas->bits == 8)                                                        \
            draw(plot, 8, __VA_ARGS__);                                                            \
        else if ((plot)->canvas->bits == 16)                                                       \
            draw(plot, 16, __VA_ARGS__);                                                           \
        else                                                                                       \
            draw(plot, 32, __VA_ARGS__);                                                           \
    } while (0)

#endif
