/* bezier_run.h — a Bézier curve as the ends of lines, short where it bends.
 *
 *      flat enough?  yes ──▶ its end point           bound of the distance from curve to chord:
 *                    no ──▶ two halves (casteljau.h),        n(n−1)/8 · max |p_k+2 − 2p_k+1 + p_k|
 *                           the first one next
 *
 * Models:     adaptive subdivision at u = ½; the bound holds for every curve, and each halving
 *             makes it four times smaller.
 * Cost:       lines: some √(bound / 4·tolerance) to √(bound / tolerance) of the whole curve; a
 *             line takes a subdivision, n(n+1)/2 divisions of a line, and n − 1 lengths.
 * Domain:     1 to BEZIER_POINTS_MOST points; at most 2^BEZIER_RUN_DEPTH lines, which a curve of
 *             1000 units and a tolerance of ½ do not need.
 * Units:      the caller's; tolerance: the points' unit, above 0.
 * Ownership:  plain value of about 3 KB; copies the points.
 * Errors:     none.
 * Source:     J. M. Lane, R. F. Riesenfeld, IEEE Trans. Pattern Analysis and Machine Intelligence
 *             2 (1980) 35; the bound: D. Filip, R. Magedson, R. Markot, Computer Aided Geometric
 *             Design 3 (1986) 295.
 */
#ifndef ROMS_CURVES_BEZIER_RUN_H
#define ROMS_CURVES_BEZIER_RUN_H

#include <stdbool.h>

#include "roms/curves/bezier.h"

enum { BEZIER_RUN_DEPTH = 10 };

struct bezier_run {
    struct vector3 waiting[BEZIER_RUN_DEPTH + 1][BEZIER_POINTS_MOST]; /* the next one is the last */
    int depth[BEZIER_RUN_DEPTH + 1];
    int pieces, count;
    float tolerance;
    bool started;
};

/* What the distance from the curve to its chord does not exceed. */
float bezier_flatness(const struct vector3 *points, int count);

void bezier_run_begin(struct bezier_run *run, const struct vector3 *points, int count,
                      float tolerance);
/* The next point: the first is the curve's first; false: that was the last. */
bool bezier_run_next(struct bezier_run *run, struct vector3 *out);

#endif
