/* scan_edge.h — an edge row by row, and which pixels are between two edges.
 *
 *      low  ●╲         rows: low.y <= y < high.y, whole y        x of the next row: x + dx/dy
 *             ╲        pixels between edges at xl and xr: xl <= x < xr, whole x
 *         high ●
 *
 * The ends are put in order first: two polygons that share an edge get the same x on every row, so
 *             that
 * they share no pixel and leave none out.
 *
 * Models:     edges for scan conversion; a horizontal one has no rows.
 * Cost:       about 25 instructions and a division to begin, one addition a row.
 * Domain:     coordinates within ±30000.
 * Units:      pixels, y downwards; middles of pixels are whole numbers.
 * Ownership:  plain values.
 * Errors:     none.
 * Source:     J. D. Foley et al., Computer Graphics (1990), section 3.6.
 */
#ifndef ROMS_VISIBLE_SCAN_EDGE_H
#define ROMS_VISIBLE_SCAN_EDGE_H

#include <stdbool.h>

#include "roms/geometry/scalar.h"
#include "roms/geometry/vector.h"

struct scan_edge {
    int first, last; /* rows; first > last: none */
    float x, slope;  /* on the first row, then on the row at hand; dx/dy */
};

/* Rows below 0 are left out. */
static inline struct scan_edge scan_edge_between(struct vector3 a, struct vector3 b)
{
    bool down = a.y < b.y || (a.y == b.y && a.x < b.x);
    struct vector3 low = down ? a : b, high = down ? b : a;
    struct scan_edge e = {scalar_ceil(low.y), scalar_ceil(high.y) - 1, low.x, 0};
    if (e.first < 0)
        e.first = 0;
    if (e.first <= e.last) {
        e.slope = (high.x - low.x) / (high.y - low.y);
        e.x = low.x + ((float)e.first - low.y) * e.slope;
    }
    return e;
}

#endif
