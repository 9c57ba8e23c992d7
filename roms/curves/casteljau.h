/* casteljau.h — a point of a Bézier curve by repeated division of lines, and the curve cut in two.
 *
 *      p0 ╲            level 0: the control points
 *      p1 ─╳ p01 ╲     level j: point i = (1 − u) · (level j−1, i) + u · (level j−1, i + 1)
 *      p2 ─╳ p12 ─╳ p012 ╲
 *      p3 ─╳ p23 ─╳ p123 ─╳ p0123 = p(u)
 *     left half: the upper edge p0 p01 p012 p0123; right half: the lower edge p0123 p123 p23 p3
 *
 * Models:     de Casteljau's triangle, level by level for those who watch; subdivision.
 * Cost:       degree n: n(n+1)/2 divisions of a line, 6 multiplications each.
 * Domain:     1 to BEZIER_POINTS_MOST points; any u (0…1 is division, beyond is extrapolation).
 * Units:      the caller's.
 * Ownership:  plain values; the triangle holds copies.
 * Errors:     none.
 * Source:     P. de Casteljau, Courbes et surfaces à pôles, A. Citroën (1963); W. Boehm, A.
 *             Müller, On de Casteljau's algorithm, Computer Aided Geometric Design 16 (1999) 587.
 */
#ifndef ROMS_CURVES_CASTELJAU_H
#define ROMS_CURVES_CASTELJAU_H

#include <stdbool.h>

#include "roms/curves/bezier.h"

enum { CASTELJAU_POINTS_MOST = BEZIER_POINTS_MOST * (BEZIER_POINTS_MOST + 1) / 2 };

struct casteljau {
    struct vector3 at[CASTELJAU_POINTS_MOST]; /* level after level, the control points first */
    int count;                                /* control points */
    int level;                                /* the last one that is there */
    float u;
};

/* Level 0. */
void casteljau_begin(struct casteljau *c, const struct vector3 *points, int count, float u);
/* One level more; false: the point was there already. */
bool casteljau_next(struct casteljau *c);
/* Point i of a level that is there; level j has count − j points. */
struct vector3 casteljau_at(const struct casteljau *c, int level, int i);
/* The control points of both parts, after the last level; `count` each. */
void casteljau_halves(const struct casteljau *c, struct vector3 *left, struct vector3 *right);

#endif
