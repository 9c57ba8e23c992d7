/* b_spline.h — B-splines of any degree over any knots.
 *
 *      knots   t0 ≤ t1 ≤ …  (count + degree + 1 of them);  the curve: t_degree … t_count
 *      B_k,0(t) = 1 within t_k ≤ t < t_k+1, else 0
 *      B_k,d(t) = (t − t_k)/(t_k+d − t_k) · B_k,d−1 + (t_k+d+1 − t)/(t_k+d+1 − t_k+1) · B_k+1,d−1
 *
 *      uniform: 0 1 2 3 4 5 6 …          the curve stays away from the first and the last point
 *      open:    0 0 0 0 1 2 3 3 3 3      ends repeated degree + 1 times: it begins and ends there
 *
 * Models:     the basis by the recursion, and points by de Boor's triangle, level by level for
 *             those who watch.
 * Cost:       basis: (degree + 1)² / 2 steps a span; de Boor: degree(degree + 1)/2 divisions of a
 *             line.
 * Domain:     degree 1 to B_SPLINE_DEGREE_MOST; degree + 1 to B_SPLINE_POINTS_MOST points; t
 *             within the curve's range, its end included. A quotient 0/0 of repeated knots counts
 *             as 0.
 * Units:      the caller's.
 * Ownership:  plain values.
 * Errors:     b_spline_trouble says in words what is wrong with degree, points or knots.
 * Source:     M. G. Cox, J. Inst. Maths Applics 10 (1972) 134; C. de Boor, Journal of Approximation
 *             Theory 6 (1972) 50.
 */
#ifndef ROMS_CURVES_B_SPLINE_H
#define ROMS_CURVES_B_SPLINE_H

#include <stdbool.h>

#include "roms/geometry/vector.h"

enum {
    B_SPLINE_DEGREE_MOST = 7,
    B_SPLINE_POINTS_MOST = 32,
    B_SPLINE_KNOTS_MOST = B_SPLINE_POINTS_MOST + B_SPLINE_DEGREE_MOST + 1
};

struct b_spline {
    int degree, count;
    float knot[B_SPLINE_KNOTS_MOST];
    struct vector3 point[B_SPLINE_POINTS_MOST];
};

/* Knots for the degree and count that are set. */
void b_spline_uniform(struct b_spline *s);
void b_spline_open(struct b_spline *s);
/* NULL: all is well. */
const char *b_spline_trouble(const struct b_spline *s);

float b_spline_start(const struct b_spline *s);
float b_spline_end(const struct b_spline *s);
/* B_k,degree(t) for k = 0…count − 1. */
void b_spline_basis(const struct b_spline *s, float t, float value[]);

/* De Boor's triangle: level j has degree + 1 − j points. */
struct de_boor {
    const struct b_spline *spline;
    struct vector3 at[B_SPLINE_DEGREE_MOST + 1];
    int span, level;
    float t;
};
void de_boor_begin(struct de_boor *d, const struct b_spline *s, float t);
/* One level more; false: at[0] is the point. */
bool de_boor_next(struct de_boor *d);
struct vector3 b_spline_point(const struct b_spline *s, float t);

#endif
