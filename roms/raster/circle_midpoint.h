/* circle_midpoint.h — circles by whole numbers: an eighth is computed, symmetry gives the rest.
 *
 *      (0,r) ■─■─■ ╲       from (0,r) to the diagonal, x + 1 a step; is the middle between the
 *                  ■─■ ╲   two pixels that may follow, (x + 1, y − ½), within the circle?
 *                      ■       p₀ = 1 − r       (5/4 − r: the quarter changes no sign)
 *                              p < 0: y stays,  p += 2x + 1
 *                              p ≥ 0: y − 1,    p += 2x + 1 − 2y       (the new x and y)
 *
 * Models:     for each x the pixel nearest to the circle. About the origin: the middle is added
 *             when plotting. The last pixel may lie past the octant (x = y + 1): it is the image of
 *             the one before.
 * Cost:       a step, which lights 8 pixels: 1 comparison, 3 or 4 additions.
 * Domain:     0 ≤ r ≤ CIRCLE_LARGEST. Radius 0 is a pixel. No ties: r² − x² is not the square of
 *             a whole number and a half.
 * Units:      pixels; round where pixels are square (canvas_round_dots, ellipse_midpoint.h where
 *             not).
 * Ownership:  plain values.
 * Errors:     none; a radius below 0 draws nothing.
 * Source:     J. E. Bresenham, "A linear algorithm for incremental digital display of circular
 *             arcs", Communications of the ACM 20 (1977) 100; the midpoint form: J. R. Van Aken,
 *             M. Novak, ACM Transactions on Graphics 4 (1985) 147.
 */
#ifndef ROMS_RASTER_CIRCLE_MIDPOINT_H
#define ROMS_RASTER_CIRCLE_MIDPOINT_H

#include <stdbool.h>

#include "roms/raster/canvas.h"

enum { CIRCLE_LARGEST = 30000 };

struct circle_midpoint {
    int x, y; /* the pixel of the first octant, after circle_midpoint_next */
    int k;    /* steps taken; 0: at (0, r) */
    int p;    /* the decision parameter of the step that follows */
};

static inline void circle_midpoint_begin(struct circle_midpoint *c, int r)
{
    *c = (struct circle_midpoint){.x = 0, .y = r, .k = -1, .p = 1 - r};
}

/* Goes to the next pixel, at first to (0, r); false: the diagonal is reached. */
static inline bool circle_midpoint_next(struct circle_midpoint *c)
{
    if (c->k < 0)
        return ++c->k == 0 && c->y >= 0;
    if (c->x >= c->y)
        return false;
    c->k++;
    c->x++;
    if (c->p >= 0) {
        c->y--;
        c->p -= 2 * c->y;
    }
    c->p += 2 * c->x + 1;
    return true;
}

void canvas_circle(const struct canvas *c, int x, int y, int r, uint32_t colour);

#endif
