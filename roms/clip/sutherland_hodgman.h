/* sutherland_hodgman.h — a polygon clipped to a window, edge by edge.
 *
 *      from → to       kept            ┌──────────┐      each pass cuts the whole polygon at
 *      in     in       to              │   ╱╲     │      one edge, without end to both sides,
 *      in     out      meeting         │  ╱  ╲────┼─╮    and hands a polygon on to the next pass
 *      out    in       meeting, to     │ ╱        │ │
 *      out    out      —               └──────────┘
 *
 * Models:     passes in the order left, right, below, above.
 * Cost:       a comparison a corner and pass; a multiplication and a division a crossing.
 * Domain:     2…CLIP_POLYGON_MOST corners with finite coordinates; any polygon, also one that
 *             crosses itself. Points on the edge are inside. What is left may have no corners, or
 *             cover no area.
 * Degenerate: what comes out is one polygon. Where a concave one falls into several parts, they
 *             stay joined by edges that run along the window's edge and cover each other in
 *             opposite directions. They add nothing to the area and light no pixels of a filled
 *             one, but are seen in an outline; clip_polygon_doubled counts them.
 * Units:      the caller's.
 * Ownership:  plain values; about 8 KB.
 * Errors:     begin: false when there are too many corners or none; nothing else is then written.
 * Source:     I. E. Sutherland, G. W. Hodgman, Communications of the ACM 17 (1974) 32.
 * Not modelled: separating the parts: K. Weiler, P. Atherton, Computer Graphics (SIGGRAPH) 11
 *               (1977) 214.
 */
#ifndef ROMS_CLIP_SUTHERLAND_HODGMAN_H
#define ROMS_CLIP_SUTHERLAND_HODGMAN_H

#include <stdbool.h>

#include "roms/clip/window.h"

/* A pass makes at most half as many again: 100 · 1.5⁴. */
enum { CLIP_POLYGON_MOST = 100, CLIP_POLYGON_ROOM = 512 };

struct sutherland_hodgman {
    struct point2 corner[CLIP_POLYGON_ROOM]; /* what is left so far */
    int count;
    unsigned edge; /* of the last pass, REGION_… of edge.h; 0: there was none yet */
    /* Private. */
    struct clip_window window;
    struct point2 spare[CLIP_POLYGON_ROOM];
};

bool sutherland_hodgman_begin(struct sutherland_hodgman *s, const struct clip_window *window,
                              const struct point2 *corners, int count);
/* The next pass; false: all four are done. */
bool sutherland_hodgman_next(struct sutherland_hodgman *s);

/* All passes. False: too many corners. */
bool clip_sutherland_hodgman(struct sutherland_hodgman *s, const struct clip_window *window,
                             const struct point2 *corners, int count);

/* How many edges lie on an edge of the window and are covered, at least partly, by one that runs
 * the other way. */
int clip_polygon_doubled(const struct clip_window *window, const struct point2 *corners, int count);

#endif
