/* Rectangles, whole words at a time. */
#include "roms/raster/canvas.h"
#include "roms/raster/fill_row.h"
#include "roms/raster/pixel.h"

uint32_t canvas_pitch(int width, unsigned bits)
{
    return ((uint32_t)width * bits + 31) / 32 * 4;
}

/* The bits of a byte under `mask`. */
static void fill_part(uint8_t *at, unsigned mask, uint32_t word)
{
    *at = (uint8_t)((*at & ~mask) | (word & mask));
}

void canvas_fill_small(const struct canvas *c, uint8_t *row, int x0, int x1, uint32_t word)
{
    uint32_t from = (uint32_t)x0 * c->bits, to = (uint32_t)x1 * c->bits;
    uint8_t *first = row + from / 8, *last = row + to / 8;
    unsigned head = 0xFFu >> from % 8, tail = 0xFFu & ~(0xFFu >> to % 8);
    if (first == last) {
        if (head & tail)
            fill_part(first, head & tail, word);
        return;
    }
    if (head != 0xFF)
        fill_part(first++, head, word);
    fill_run_bytes(first, last, word);
    if (tail != 0)
        fill_part(last, tail, word);
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
        canvas_fill_small(c, row, x, x + 1, canvas_repeated(c, colour));
}
