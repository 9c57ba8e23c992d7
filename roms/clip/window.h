/* window.h — the rectangle that things are clipped to, and whether a point is within.
 *
 * Models:     an upright rectangle; its edge belongs to it.
 * Units:      the caller's.
 * Ownership:  plain values.
 * Errors:     none; a window whose minimum exceeds its maximum holds nothing.
 * Source:     elementary. Cost: at most 4 comparisons a point.
 */
#ifndef ROMS_CLIP_WINDOW_H
#define ROMS_CLIP_WINDOW_H

#include <stdbool.h>

#include "roms/geometry/vector.h"

struct clip_window {
    float x_min, y_min, x_max, y_max;
};

static inline bool clip_point(const struct clip_window *w, struct point2 p)
{
    return p.x >= w->x_min && p.x <= w->x_max && p.y >= w->y_min && p.y <= w->y_max;
}

#endif
