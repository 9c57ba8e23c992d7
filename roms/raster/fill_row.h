/* fill_row.h — the same colour over a stretch of a row, in every format of canvas.h.
 *
 *      first byte ─▶ ··██ ████ ████ █··· ◀─ last byte      small pixels: what is around is kept
 *
 * Models:     what rectangles and text are made of.
 * Cost:       that of fill_run.h, and about 10 instructions; 25 for pixels smaller than a byte.
 * Position:   pixels of the canvas.
 * Ownership:  nothing.
 * Errors:     none: what is outside the canvas must not be asked for.
 * Source:     elementary.
 */
#ifndef ROMS_RASTER_FILL_ROW_H
#define ROMS_RASTER_FILL_ROW_H

#include "roms/raster/fill_run.h"
#include "roms/raster/pixel.h"

/* The colour as often as a word holds it. */
static inline uint32_t canvas_repeated(const struct canvas *c, uint32_t colour)
{
    colour = canvas_held(c, colour);
    for (unsigned bits = c->bits; bits < 32; bits *= 2)
        colour |= colour << bits;
    return colour;
}

/* Pixels smaller than a byte fill it from its high bits on. Not inline: what is inline around it would save more
 * registers for it than short rows are long. */
void canvas_fill_small(const struct canvas *c, uint8_t *row, int x0, int x1, uint32_t word);

/* Pixels x0 to x1 of a row. */
static inline void fill_row(const struct canvas *c, uint8_t *row, int x0, int x1, uint32_t word)
{
    if (c->bits == 8)
        fill_run_bytes(row + x0, row + x1, word);
    else if (c->bits == 32)
        fill_run_words((uint32_t *)(void *)row + x0, (uint32_t *)(void *)row + x1, word);
    else if (c->bits == 16)
        fill_run_halves((uint16_t *)(void *)row + x0, (uint16_t *)(void *)row + x1, word);
    else
        canvas_fill_small(c, row, x0, x1, word);
}

#endif
