/* polygon_fill.h — areas between edges, scan line by scan line.
 *
 *      edges, by their lowest row ──▶ active edges, by x ──▶ pairs of crossings ──▶ runs of pixels
 *
 * Models:     the even-odd rule and the non-zero winding rule. A pixel belongs to the area when its middle
 *             does; a middle on an edge belongs to the area on its right or below, so that areas which
 *             share an edge share no pixel.
 * Units:      pixels; middles of pixels are whole numbers.
 * Ownership:  plain values.
 * Errors:     a polygon of fewer than 3 or more than POLYGON_CORNERS corners is not filled.
 * Source:     J. D. Foley et al., Computer Graphics (1990), section 3.6.
 */
#ifndef ROMS_RASTER_POLYGON_FILL_H
#define ROMS_RASTER_POLYGON_FILL_H

#include "roms/geometry/vector.h"
#include "roms/raster/canvas.h"

enum { POLYGON_CORNERS = 128 };
enum polygon_rule { POLYGON_EVEN_ODD, POLYGON_NON_ZERO };

void canvas_polygon(const struct canvas *c, const struct point2 *corners, int count,
                    enum polygon_rule rule, uint32_t colour);

#endif
