/* edge.h — regions about a window, and where a line meets one of its edges.
 *
 *      1001 │ 1000 │ 1010        A B R L: above, below, right of, left of the window
 *      ─────┼──────┼─────
 *      0001 │ 0000 │ 0010        an edge is named by the region beyond it
 *      ─────┼──────┼─────
 *      0101 │ 0100 │ 0110
 *
 * Models:     what Cohen-Sutherland and Sutherland-Hodgman have in common.
 * Cost:       a region takes 4 comparisons, a meeting one multiplication and one division.
 * Units:      the caller's.
 * Ownership:  plain values.
 * Errors:     none; clip_meeting wants ends on different sides of the edge.
 * Source:     W. M. Newman, R. F. Sproull, Principles of Interactive Computer Graphics (1973).
 */
#ifndef ROMS_CLIP_EDGE_H
#define ROMS_CLIP_EDGE_H

#include "roms/clip/window.h"

enum { REGION_LEFT = 1, REGION_RIGHT = 2, REGION_BELOW = 4, REGION_ABOVE = 8 };

static inline unsigned clip_region(const struct clip_window *w, struct point2 p)
{
    unsigned code = 0;
    if (p.x < w->x_min)
        code |= REGION_LEFT;
    if (p.x > w->x_max)
        code |= REGION_RIGHT;
    if (p.y < w->y_min)
        code |= REGION_BELOW;
    if (p.y > w->y_max)
        code |= REGION_ABOVE;
    return code;
}

/* Where the line from a to b meets an edge; on the edge exactly. Reckoned from a. */
static inline struct point2 clip_meeting(const struct clip_window *w, unsigned edge,
                                         struct point2 a, struct point2 b)
{
    if (edge & (REGION_LEFT | REGION_RIGHT)) {
        float x = edge == REGION_LEFT ? w->x_min : w->x_max;
        return (struct point2){x, a.y + (x - a.x) * (b.y - a.y) / (b.x - a.x)};
    }
    float y = edge == REGION_BELOW ? w->y_min : w->y_max;
    return (struct point2){a.x + (y - a.y) * (b.x - a.x) / (b.y - a.y), y};
}

#endif
