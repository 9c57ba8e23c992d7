/* window_viewport.h — a window of the world onto a viewport; zoom, pan and turned windows.
 *
 *      ┌─ window ─┐                ┌─ viewport ┐      (x − xw_min) / (xw_max − xw_min) =
 *      │        P │  ──matrix──▶   │        P' │          (x' − xv_min) / (xv_max − xv_min)
 *      └──────────┘                └───────────┘
 *
 * Models:     where a point lies in the window, there it lies in the viewport; other windows give
 *             other views of the same world.
 * Cost:       2 divisions and 2 multiplications for the matrix, then 2 multiplications a point.
 * Domain:     windows with an area. A viewport without one is taken: everything falls onto a line.
 * Units:      the caller's.
 * Ownership:  plain values.
 * Errors:     false for a window without an area, a frame without a direction up; nothing is
 *             written.
 * Source:     W. M. Newman, R. F. Sproull, Principles of Interactive Computer Graphics (1973).
 */
#ifndef ROMS_CLIP_WINDOW_VIEWPORT_H
#define ROMS_CLIP_WINDOW_VIEWPORT_H

#include <stdbool.h>

#include "roms/clip/window.h"
#include "roms/geometry/matrix3.h"

bool window_to_viewport(const struct clip_window *window, const struct clip_window *viewport,
                        struct matrix3 *out);

/* The window moved: positive dx shows what lies to the right. */
struct clip_window window_pan(const struct clip_window *window, float dx, float dy);
/* The window made smaller about its middle: a factor above 1 enlarges the picture; must not be
 * 0. */
struct clip_window window_zoom(const struct clip_window *window, float factor);

/* A viewing frame: world to view. Its origin is at `origin`, its y axis along `up` of any
 * length. */
bool view_frame(struct point2 origin, struct point2 up, struct matrix3 *out);

#endif
