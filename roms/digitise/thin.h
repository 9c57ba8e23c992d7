/* thin.h — fewer points for the same line: none that is left out lies farther than a tolerance away.
 *
 *          ·   ·  ●            the farthest point from the chord stays when it is farther than the
 *        ·  ╱─────  ╲  ·       tolerance, and both parts are looked at again
 *       ●─╱──────────╲─●
 *
 * Models:     Douglas and Peucker's method, in the plane, distances to the chord as a segment.
 * Cost:       n distances a level; n² at the worst. Ranges that wait: log₂ n at most, as the smaller
 *             part is looked at first.
 * Domain:     finite points.
 * Units:      millimetres.
 * Ownership:  the caller's arrays.
 * Errors:     none. Ends stay always.
 * Source:     D. H. Douglas, T. K. Peucker, The Canadian Cartographer 10 (1973) 112.
 */
#ifndef ROMS_DIGITISE_THIN_H
#define ROMS_DIGITISE_THIN_H

#include <stdbool.h>

#include "roms/digitise/drawing.h"

/* keep[i]: the point stays. Returns how many. Gaps (drawing.h) are never thinned across: the points on
 * both sides stay. */
int thin_points(const struct drawing_point *points, int count, float tolerance, bool *keep);

#endif
