/* Rectangles, whole words at a time. */
#include "roms/raster/canvas.h"
#include "roms/raster/fill_row.h"
#include "roms/raster/pixel.h"

uint32_t canvas_pitch(int width, unsigned bits)
{
    return ((uint32_t)width * bits + 31) / 32 * 4;
}

void canvas_fill(const struct canvas *c, int x, int y, int width, int height, uint32_t colour)
{
    int x1 = x + width < c->width ? x + width : c->width;
    int y1 = y + height < c->height ? y + height : c->height;
    x = x > 0 ? x : 0;
    y = y > 0 ? y : 0;
    if (x >= x1)
        return;
    uint32_t word = canvas_repeated(c, colour);
    for (; y < y1; y++)
        fill_row(c, c->pixels + (uint32_t)y * c->pitch, x, x1, word);
}

void canvas_clear(const struct canvas *c, uint32_t colour)
{
    canvas_fill(c, 0, 0, c->width, c->height, colour);
}

void canvas_frame(const struct canvas *c, int x, int y, int width, int height, int thick,
                  uint32_t colour)
{
    canvas_fill(c, x, y, width, thick, colour);
    canvas_fill(c, x, y + height - thick, width, thick, colour);
    canvas_fill(c, x, y + thick, thick, height - 2 * thick, colour);
    canvas_fill(c, x + width - thick, y + thick, thick, height - 2 * thick, colour);
}

void canvas_dot(const struct canvas *c, int x, int y, uint32_t colour)
{
    if (!canvas_holds(c, x, y))
        return;
    uint8_t *row = c->pixels + (uint32_t)y * c->pitch;
    if (c->bits == 8)
        row[x] = (uint8_t)colour;
    else if (c->bits == 32)
        ((uint32_t *)(void *)row)[x] = colour;
    else if (c->bits == 16)
        ((uint16_t *)(void *)row)[x] = (uint16_t)colour;
    else
        fill_row_small(c, row, x, x + 1, canvas_repeated(c, colour));
}
