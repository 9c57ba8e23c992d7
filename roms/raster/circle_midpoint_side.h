/* circle_midpoint_side.h — the midpoint circle that begins at the side.
 *
 *          ╲ ■        from (r,0) to the diagonal, y + 1 a step; is the middle between the two
 *           ╲ ■       pixels that may follow, (x − ½, y + 1), within the circle?
 *            ■            p₀ = 1 − r
 *            ■ (r,0)      p < 0: x stays,  p += 2y + 1
 *                         p ≥ 0: x − 1,    p += 2y + 1 − 2x       (the new x and y)
 *
 * Models:     for each y the pixel nearest to the circle; all octants together are the pixels of
 *             circle_midpoint.h. The last pixel may lie past the octant (y = x + 1), as there.
 * Cost:       a step, which lights 8 pixels: 1 comparison, 3 or 4 additions.
 * Domain:     0 ≤ r ≤ CIRCLE_LARGEST.
 * Units:      pixels, about the origin.
 * Ownership:  plain values.
 * Errors:     none; a radius below 0 draws nothing.
 * Source:     as circle_midpoint.h.
 */
#ifndef ROMS_RASTER_CIRCLE_MIDPOINT_SIDE_H
#define ROMS_RASTER_CIRCLE_MIDPOINT_SIDE_H

#include <stdbool.h>

#include "roms/raster/canvas.h"

struct circle_midpoint_side {
    int x, y; /* the pixel of the second octant, after circle_midpoint_side_next */
    int k;    /* steps taken; 0: at (r, 0) */
    int p;    /* the decision parameter of the step that follows */
};

static inline void circle_midpoint_side_begin(struct circle_midpoint_side *c, int r)
{
    *c = (struct circle_midpoint_side){.x = r, .y = 0, .k = -1, .p = 1 - r};
}

/* Goes to the next pixel, at first to (r, 0); false: the diagonal is reached. */
static inline bool circle_midpoint_side_next(struct circle_midpoint_side *c)
{
    if (c->k < 0)
        return ++c->k == 0 && c->x >= 0;
    if (c->y >= c->x)
        return false;
    c->k++;
    c->y++;
    if (c->p >= 0) {
        c->x--;
        c->p -= 2 * c->x;
    }
    c->p += 2 * c->y + 1;
    return true;
}

void canvas_circle_side(const struct canvas *c, int x, int y, int r, uint32_t colour);

#endif
