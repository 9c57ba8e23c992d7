/* cubic_kind.h — pieces of cubic splines by what controls them, in three equivalent ways.
 *
 *   Hermite     p0 p1 p0′ p1′             p(0) = p0, p(1) = p1, p′(0) = p0′, p′(1) = p1′
 *   Bézier      p0 p1 p2 p3               p(0) = p0, p(1) = p3, p′(0) = 3(p1−p0), p′(1) = 3(p3−p2)
 *   cardinal    p0 p1 p2 p3, tension t    p(0) = p1, p(1) = p2, p′(0) = s(p2−p0), p′(1) = s(p3−p1),
 *                                         s = (1 − t)/2; t = 0: Catmull–Rom
 *   B-spline    p0 p1 p2 p3               p(0) = (p0+4p1+p2)/6, p(1) = (p1+4p2+p3)/6,
 *                                         p′(0) = (p2−p0)/2, p′(1) = (p3−p1)/2
 *
 *      (1) boundary conditions   four equations for a, b, c, d, solved    cubic_conditions.c
 *      (2) characterising matrix A = M · G, p(u) = T · M · G             cubic_matrix.c
 *      (3) blending functions    p(u) = Σ g_k · BF_k(u)                  cubic_blending.c
 *
 * Models:     the three ways, each by itself: none uses another.
 * Cost:       (1) about 60 multiplications and 10 divisions, then 9 a point; (2) 48, then 9 a
 *             point; (3) 8 to 14 for the functions and 12 more, each point.
 * Domain:     finite coordinates and tension. The ways agree within CUBIC_WAYS_TOLERANCE of the
 *             largest coordinate of the geometry (times 1 + |t|): 24 · 2⁻²³; 16 was the most in 12
 *             million cases.
 * Units:      the caller's; curves of the plane have z = 0.
 * Ownership:  plain values.
 * Errors:     none: the equations of (1) always have a solution.
 * Source:     C. Hermite, Crelle's Journal 84 (1878) 70; J. Ferguson, Journal of the ACM 11 (1964)
 *             221; E. Catmull, R. Rom, A class of local interpolating splines (1974); I. J.
 *             Schoenberg, Quarterly of Applied Mathematics 4 (1946) 45.
 */
#ifndef ROMS_CURVES_CUBIC_KIND_H
#define ROMS_CURVES_CUBIC_KIND_H

#include "roms/curves/cubic.h"
#include "roms/geometry/matrix4.h"

#define CUBIC_WAYS_TOLERANCE 2.9e-6f

enum cubic_kind { CUBIC_HERMITE, CUBIC_BEZIER, CUBIC_CARDINAL, CUBIC_B_SPLINE, CUBIC_KINDS };

struct cubic_geometry {
    enum cubic_kind kind;
    float tension; /* of cardinal pieces */
    struct vector3 g[4];
};

/* ---- (1) ---- */

/* Row i says: row · (a b c d) = value; p(0), p(1), p′(0), p′(1). */
struct cubic_conditions {
    float row[4][4];
    struct vector3 value[4];
};
struct cubic_conditions cubic_conditions(const struct cubic_geometry *geometry);
struct cubic cubic_by_conditions(const struct cubic_geometry *geometry);

/* ---- (2) ---- */

struct matrix4 cubic_matrix(enum cubic_kind kind, float tension);
struct cubic cubic_by_matrix(const struct cubic_geometry *geometry);

/* ---- (3) ---- */

void cubic_blending(enum cubic_kind kind, float tension, float u, float value[4]);
struct vector3 cubic_by_blending(const struct cubic_geometry *geometry, float u);

#endif
