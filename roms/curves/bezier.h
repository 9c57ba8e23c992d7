/* bezier.h — Bézier curves of any degree by their blending functions.
 *
 *           p1 ·- - - - -· p2             p(u) = Σ p_k · BEZ_k,n(u),   0 ≤ u ≤ 1
 *             ╱  ╭───╮    ╲               BEZ_k,n(u) = C(n,k) · u^k · (1 − u)^(n−k)
 *         p0 ·──╯     ╰────· p3           n + 1 control points: degree n
 *
 * Models:     the Bernstein polynomials, points, derivatives, and both derivatives at both ends.
 * Cost:       degree n: blending 4n multiplications and n(n−1)/2 products for the C(n,k); a point
 *             3(n+1) more.
 * Domain:     1 to BEZIER_POINTS_MOST points; u is meant to be within 0…1 (there the curve lies in
 *             the convex hull of its control points). C(n,k) is exact up to that degree.
 * Units:      the caller's. Curves of the plane have z = 0.
 * Ownership:  plain values.
 * Errors:     none: derivatives that a degree does not have are 0.
 * Source:     S. Bernstein, Comm. Soc. Math. Kharkov 13 (1912) 1; P. Bézier, Numerical Control
 *             (1972); A. R. Forrest, Computer Journal 15 (1972) 71.
 * Not modelled: rational curves.
 */
#ifndef ROMS_CURVES_BEZIER_H
#define ROMS_CURVES_BEZIER_H

#include "roms/geometry/vector.h"

enum { BEZIER_DEGREE_MOST = 20, BEZIER_POINTS_MOST = BEZIER_DEGREE_MOST + 1 };

/* C(n,k), 0 ≤ k ≤ n ≤ BEZIER_DEGREE_MOST. */
float bezier_binomial(int n, int k);
/* BEZ_k,n(u) for k = 0…n. */
void bezier_blending(int n, float u, float value[]);
struct vector3 bezier_point(const struct vector3 *points, int count, float u);
/* p′(u) = n · Σ (p_k+1 − p_k) · BEZ_k,n−1(u). */
struct vector3 bezier_derivative(const struct vector3 *points, int count, float u);

/* p′ and p″ at u = 0 and u = 1. */
struct bezier_ends {
    struct vector3 first0, first1; /* n(p1 − p0), n(pn − pn−1) */
    struct vector3 second0,
        second1; /* n(n−1)[(p2 − p1) − (p1 − p0)], the same from the other end */
};
struct bezier_ends bezier_ends(const struct vector3 *points, int count);

#endif
