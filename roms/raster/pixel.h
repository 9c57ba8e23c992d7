/* pixel.h — what a pixel of the canvas holds.
 *
 * Models:     reading in every format of canvas.h; canvas_dot writes.
 * Position:   pixels of the canvas.
 * Cost:       about 10 instructions.
 * Ownership:  nothing.
 * Errors:     none: a pixel outside the canvas must not be asked for.
 */
#ifndef ROMS_RASTER_PIXEL_H
#define ROMS_RASTER_PIXEL_H

#include <stdbool.h>

#include "roms/raster/canvas.h"

static inline bool canvas_holds(const struct canvas *c, int x, int y)
{
    return (unsigned)x < (unsigned)c->width && (unsigned)y < (unsigned)c->height;
}

/* A colour as pixels hold it. */
static inline uint32_t canvas_held(const struct canvas *c, uint32_t colour)
{
    return c->bits < 32 ? colour & ((1u << c->bits) - 1) : colour;
}

static inline uint32_t canvas_pixel(const struct canvas *c, int x, int y)
{
    const uint8_t *row = c->pixels + (uint32_t)y * c->pitch;
    if (c->bits == 8)
        return row[x];
    if (c->bits == 32)
        return ((const uint32_t *)(const void *)row)[x];
    if (c->bits == 16)
        return ((const uint16_t *)(const void *)row)[x];
    unsigned at = (unsigned)x * c->bits;
    return (unsigned)row[at / 8] >> (8 - c->bits - at % 8) & ((1u << c->bits) - 1);
}

#endif
