/* flood_fill.h — gives all connected pixels of one colour another.
 *
 *      ▒▒▒░░▒      the seed's colour ░ is replaced wherever it is connected with the seed,
 *      ▒░░s▒▒      whatever colours the boundary has
 *      ░▒▒▒░░
 *
 * Models:     the flood fill algorithm, by spans (span_fill.h), connected by edges (4) or by edges
 *             and corners (8).
 * Cost, Domain, Units, Ownership: span_fill.h.
 * Errors:     a stack that was too small: false; part of the area was not filled. Where the seed
 *             has the new colour already there is nothing to do.
 * Source:     D. Hearn, M. P. Baker, Computer Graphics (1986), section 4-5; spans: span_fill.h.
 */
#ifndef ROMS_RASTER_FLOOD_FILL_H
#define ROMS_RASTER_FLOOD_FILL_H

#include "roms/raster/span_fill.h"

/* connected: 4 or 8. */
void flood_fill_begin(struct span_fill *fill, const struct canvas *c, int x, int y, int connected,
                      uint32_t colour, struct span_seed *seeds, int room);
/* All of it; true: complete. */
bool canvas_flood_fill(const struct canvas *c, int x, int y, int connected, uint32_t colour,
                       struct span_seed *seeds, int room);

#endif
