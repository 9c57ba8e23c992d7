/* line.c — Bresenham's line into pixels: an address moves instead of x and y. */
#include <stddef.h>
#include <stdlib.h>

#include "roms/raster/canvas.h"
#include "roms/raster/line_bresenham.h"
#include "roms/raster/pixel.h"
#include "roms/raster/plot.h"

/* The walk for pixels of whole bytes; `along` and `across` in pixels. */
#define WALK(name, pixel)                                                                          \
    static void name(struct line_bresenham l, pixel *at, ptrdiff_t along, ptrdiff_t across,        \
                     pixel colour)                                                                 \
    {                                                                                              \
        for (int left = l.last - l.k; left > 0; left--) {                                          \
            at += along;                                                                           \
            if (line_bresenham_decide(&l))                                                         \
                at += across;                                                                      \
            *at = colour;                                                                          \
        }                                                                                          \
    }

WALK(walk_8, uint8_t)
WALK(walk_16, uint16_t)
WALK(walk_32, uint32_t)

/* For several pixels a byte, the first in its high bits. */
static void walk_small(const struct canvas *c, struct line_bresenham l, uint32_t colour)
{
    unsigned bits = c->bits, top = 0xFFu & ~(0xFFu >> bits), value = 0;
    for (unsigned at = 0; at < 8; at += bits)
        value = value << bits | (colour & ((1u << bits) - 1));
    while (line_bresenham_next(&l)) {
        unsigned bit = (unsigned)l.x * bits, mask = top >> bit % 8;
        uint8_t *at = c->pixels + (unsigned)l.y * c->pitch + bit / 8;
        *at = (uint8_t)((*at & ~mask) | (value & mask));
    }
}

void canvas_line(const struct canvas *c, int x0, int y0, int x1, int y1, uint32_t colour)
{
    struct line_bresenham l;
    if (!plot_line_near(x0, y0, x1, y1, LINE_FARTHEST))
        return;
    if (y0 == y1) {
        canvas_fill(c, x0 < x1 ? x0 : x1, y0, abs(x1 - x0) + 1, 1, colour);
        return;
    }
    line_bresenham_begin(&l, x0, y0, x1, y1);
    if ((!canvas_holds(c, x0, y0) || !canvas_holds(c, x1, y1)) &&
        !line_bresenham_cut(&l, 0, 0, c->width - 1, c->height - 1))
        return;
    if (c->bits < 8) {
        walk_small(c, l, colour);
        return;
    }
    /* The address before the first pixel is only counted with. */
    int bytes = (int)c->bits / 8, row = (int)c->pitch / bytes;
    int along = l.along_y * row + l.along_x, across = l.across_y * row + l.across_x;
    uintptr_t at = (uintptr_t)c->pixels + (uintptr_t)((l.y * row + l.x) * bytes);
    if (bytes == 1)
        walk_8(l, (uint8_t *)at, along, across, (uint8_t)colour);
    else if (bytes == 2)
        walk_16(l, (uint16_t *)at, along, across, (uint16_t)colour);
    else
        walk_32(l, (uint32_t *)at, along, across, colour);
}
