/* ellipse_midpoint.h — ellipses by whole numbers: a quarter is computed, in two regions.
 *
 *      (0,ry) ■─■─■ ╲  region 1, flat: x + 1 a step; the middle is (x + 1, y − ½)
 *                   ■ ╲    p₁ = ry² − rx² ry + rx²/4
 *      2ry²x = 2rx²y ■     p < 0: y stays,  p += 2ry²x + ry²
 *                    ■     p ≥ 0: y − 1,    p += 2ry²x + ry² − 2rx²y     (the new x and y)
 *             region 2,  steep: y − 1 a step; the middle is (x + ½, y − 1)
 *              (rx,0) ■    p₂ = ry² (x + ½)² + rx² (y − 1)² − rx² ry²    at the first pixel
 *                          p ≥ 0: x stays,  p += rx² − 2rx²y
 *                          p < 0: x + 1,    p += rx² − 2rx²y + 2ry²x
 *
 * Models:     a pixel for each x of region 1 and for each y of region 2, by the sign of the
 *             equation at the middle: within half a pixel of the ellipse, along one of the axes.
 *             Region 1 ends when 2ry²x ≥ 2rx²y, which is looked at after a step: its last step may
 *             go too far by up to a pixel, and at a tip sharper than a pixel (rx² < ry) the steps
 *             after it, too. A flat ellipse reaches y = 0 in region 1 before x = rx: its tip is a
 *             run of pixels of row 0 (region 3), without which the outline would be open.
 *             Quarters: p is kept without the quarter that odd radii give; it changes no sign.
 * Cost:       a step, which lights 4 pixels: 2 comparisons, 3 to 5 additions, of 64 bits each.
 * Domain:     0 ≤ rx, ry ≤ ELLIPSE_LARGEST: p stays below 2^62. A radius 0 is a line, both: a
 *             pixel.
 * Units:      pixels, about the origin.
 * Ownership:  plain values.
 * Errors:     none; radii beyond the domain draw nothing.
 * Source:     J. R. Van Aken, "An efficient ellipse-drawing algorithm", IEEE Computer Graphics and
 *             Applications 4 (1984) 24.
 */
#ifndef ROMS_RASTER_ELLIPSE_MIDPOINT_H
#define ROMS_RASTER_ELLIPSE_MIDPOINT_H

#include <stdbool.h>

#include "roms/raster/canvas.h"

enum { ELLIPSE_LARGEST = 30000 };

struct ellipse_midpoint {
    int x, y;   /* the pixel of the first quadrant, after ellipse_midpoint_next */
    int k;      /* steps taken; 0: at (0, ry) */
    int region; /* 1, 2 or 3: of the step that follows */
    int rx;
    int64_t p;                /* the decision parameter of the step that follows */
    int64_t slope_x, slope_y; /* 2ry²x, 2rx²y */
    int64_t rx_squared, ry_squared;
};

/* Radii within the domain. */
void ellipse_midpoint_begin(struct ellipse_midpoint *e, int rx, int ry);
/* p₂ at the pixel. */
int64_t ellipse_midpoint_second(const struct ellipse_midpoint *e);

static inline void ellipse_midpoint_x(struct ellipse_midpoint *e)
{
    e->x++;
    e->slope_x += 2 * e->ry_squared;
}

static inline void ellipse_midpoint_y(struct ellipse_midpoint *e)
{
    e->y--;
    e->slope_y -= 2 * e->rx_squared;
}

/* The region of the step that follows. */
static inline void ellipse_midpoint_turn(struct ellipse_midpoint *e)
{
    if (e->y == 0) {
        e->region = 3;
    } else if (e->region == 1 && e->slope_x >= e->slope_y) {
        e->region = 2;
        e->p = ellipse_midpoint_second(e);
    }
}

/* Goes to the next pixel, at first to (0, ry); false: (rx, 0) is reached. */
static inline bool ellipse_midpoint_next(struct ellipse_midpoint *e)
{
    if (e->k < 0)
        return ++e->k == 0;
    if (e->region == 3 && e->x >= e->rx)
        return false;
    e->k++;
    if (e->region == 1) {
        bool steps = e->p >= 0;
        ellipse_midpoint_x(e);
        e->p += e->slope_x + e->ry_squared;
        if (steps) {
            ellipse_midpoint_y(e);
            e->p -= e->slope_y;
        }
    } else if (e->region == 2) {
        bool stays = e->p >= 0;
        ellipse_midpoint_y(e);
        e->p += e->rx_squared - e->slope_y;
        if (!stays) {
            ellipse_midpoint_x(e);
            e->p += e->slope_x;
        }
    } else {
        ellipse_midpoint_x(e);
    }
    ellipse_midpoint_turn(e);
    return true;
}

void canvas_ellipse_midpoint(const struct canvas *c, int x, int y, int rx, int ry, uint32_t colour);

#endif
