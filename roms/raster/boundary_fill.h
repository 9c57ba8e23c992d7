/* boundary_fill.h — fills outward from a seed until a boundary of one colour.
 *
 *      ■■■■■■■          4-connected: through edges; a boundary of diagonal steps holds
 *      ■     ■          8-connected: through corners, too; it leaks where a boundary
 *      ■  s  ■▒▒              touches itself only by corners
 *       ■■■■■
 *
 * Models:     the boundary fill algorithm, by spans (span_fill.h). Pixels that have the fill colour
 *             already are taken for filled: what lies behind them is not reached.
 * Cost, Domain, Units, Ownership: span_fill.h.
 * Errors:     a stack that was too small: false; part of the area was not filled.
 * Source:     D. Hearn, M. P. Baker, Computer Graphics (1986), section 4-5; spans: span_fill.h.
 */
#ifndef ROMS_RASTER_BOUNDARY_FILL_H
#define ROMS_RASTER_BOUNDARY_FILL_H

#include "roms/raster/span_fill.h"

/* connected: 4 or 8. */
void boundary_fill_begin(struct span_fill *fill, const struct canvas *c, int x, int y,
                         int connected, uint32_t boundary, uint32_t colour, struct span_seed *seeds,
                         int room);
/* All of it; true: complete. */
bool canvas_boundary_fill(const struct canvas *c, int x, int y, int connected, uint32_t boundary,
                          uint32_t colour, struct span_seed *seeds, int room);

#endif
