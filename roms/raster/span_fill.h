/* span_fill.h — filling what is connected with a seed, a span of a row at a time.
 *
 *            ┌───┐ ┌──┐
 *      above │s  │ │s │     s: a seed for each stretch of inside pixels that touches the span
 *      span  ├───┴─┴──┤ ◀── popped seed, grown to the left and to the right, filled
 *      below │s       │
 *            └────────┘
 *
 * Models:     what boundary_fill.h and flood_fill.h have in common: connection by edges (4) or by
 *             edges and corners (8), a stack of seeds of limited size.
 * Cost:       an open area: 8 instructions a pixel of 8 bits, 17 of 32, nearly all of them looking
 *             at the rows above and below; with every twentieth pixel an obstacle 45; other formats
 *             about 40 more.
 * Domain:     canvases of at most 32767 by 32767.
 * Units:      pixels of the canvas; y downwards.
 * Ownership:  the canvas and the stack are the caller's and must outlive it.
 * Errors:     a seed outside the canvas fills nothing. Seeds that find no room are counted in
 *             `dropped`: then what hung on them was not filled.
 * Source:     A. R. Smith, Tint Fill, Computer Graphics 13 (SIGGRAPH 1979) 276.
 */
#ifndef ROMS_RASTER_SPAN_FILL_H
#define ROMS_RASTER_SPAN_FILL_H

#include <stdbool.h>
#include <stdint.h>

#include "roms/raster/canvas.h"

struct span_seed {
    int16_t x, y;
};

struct span_fill {
    const struct canvas *canvas;
    bool of_limit;          /* inside is what has the value `limit`; else what has neither … */
    uint32_t limit, colour; /* … `limit` nor `colour` */
    bool corners;           /* pixels that touch at a corner are connected */
    struct span_seed *seeds;
    int room, count;
    int deepest, dropped; /* seeds that waited at most; seeds without room */
};

/* A span that was filled, and the seeds it left: the last `pushed` of the stack. */
struct span_filled {
    int seed; /* its x */
    int y, x0, x1;
    int pushed;
};

/* A seed, or one more that was dropped. */
void span_fill_push(struct span_fill *fill, int x, int y);
/* The next seed that is still inside; false: there is none left. */
bool span_fill_next(struct span_fill *fill, struct span_filled *out);

#endif
