/* liang_barsky.h — a line clipped to a window by its parameter.
 *
 *      x = x0 + t·dx, y = y0 + t·dy      p₁ = −dx  q₁ = x0 − x_min   p < 0: enters at q/p
 *      p·t <= q for the four edges       p₂ =  dx  q₂ = x_max − x0   p > 0: leaves at q/p
 *                                        p₃ = −dy  q₃ = y0 − y_min   p = 0: parallel; q < 0: out
 *                                        p₄ =  dy  q₄ = y_max − y0   t1 > t2: nothing is left
 *
 * Models:     the algorithm, an edge at a time for those who want to see it.
 * Cost:       at most 4 divisions and 2 multiplications an end; none where the window is missed
 *             early.
 * Domain:     finite coordinates; points on the edge are inside. A line of length 0 is a point.
 * Units:      the caller's.
 * Ownership:  plain values.
 * Errors:     none. A clipped end may miss the edge by rounding: 4 units in the last place of the
 *             largest coordinate.
 * Source:     Y.-D. Liang, B. A. Barsky, ACM Transactions on Graphics 3 (1984) 1.
 */
#ifndef ROMS_CLIP_LIANG_BARSKY_H
#define ROMS_CLIP_LIANG_BARSKY_H

#include <stdbool.h>

#include "roms/clip/window.h"

/* The working: p and q of the left, right, lower and upper edge; the part that is left. */
struct liang_barsky {
    float p[4], q[4];
    float t1, t2; /* t1 > t2: nothing */
    int edges;    /* looked at so far */
    bool left;    /* something is */
};

void liang_barsky_begin(struct liang_barsky *k, const struct clip_window *window, struct point2 a,
                        struct point2 b);
/* Narrows t1…t2 by the next edge; false: there is none, or nothing was left before. */
bool liang_barsky_next(struct liang_barsky *k);

/* Moves the ends onto what is left of the line; false: nothing is left, and they stay. */
bool clip_liang_barsky(const struct clip_window *window, struct point2 *a, struct point2 *b);
/* The same with its working. */
bool clip_liang_barsky_shown(const struct clip_window *window, struct point2 *a, struct point2 *b,
                             struct liang_barsky *working);

#endif
