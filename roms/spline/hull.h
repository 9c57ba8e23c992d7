/* hull.h — the convex hull of points in the plane.
 *
 *           ╭─────●          corners counter-clockwise, the leftmost first; points on an edge are
 *          ●  ·  ·  ╲        not corners
 *            ╲  ·    ●
 *             ●─────╯
 *
 * Models:     the lower and the upper chain over points in order of x.
 * Cost:       sorting by insertion: n² / 4 steps; there are few points.
 * Domain:     0 to HULL_MOST points, finite.
 * Units:      the caller's.
 * Ownership:  plain values.
 * Errors:     none; points on one line have a hull of two corners, equal points of one.
 * Source:     A. M. Andrew, Information Processing Letters 9 (1979) 216.
 */
#ifndef ROMS_SPLINE_HULL_H
#define ROMS_SPLINE_HULL_H

#include "roms/geometry/vector.h"

enum { HULL_MOST = 32 };

/* Returns how many corners; `out` takes as many as there are points. */
int convex_hull(const struct vector3 *points, int count, struct point2 *out);

#endif
