/* spline.h — curves of cubic pieces through points, or near them.
 *
 *          p1 ·╮        ╭· p3       natural:   p″ = 0 at both ends        C2, through the points
 *        ╭──╯   ╰╮    ╭─╯           clamped:   given p′ at both ends      C2, through the points
 *      p0 ·      ╰· p2╯             Hermite:   given p′ at each point     C1, through the points
 *      |———h0——|—h1—|—h2——|         cardinal:  p′_i = s(p_i+1 − p_i−1)    C1, through inner points
 *      t0      t1   t2   t3         B-spline:  weighted means             C2, near the points
 *                                   Bézier:    every third point          C0, as the points lie
 *
 * Models:     the parameter t along the whole curve with a knot at each end of a piece: at equal
 *             distances, or as far apart as the points (chordal), or as the roots of that
 *             (centripetal); each piece as a geometry (cubic_kind.h) over u = (t − t_i) / h_i.
 * Cost:       natural, clamped: a tridiagonal system, some 20 operations a point and coordinate;
 *             the others nothing but copies.
 * Domain:     2 to SPLINE_POINTS_MOST points; cardinal and B-spline at least 4, Bézier 3k + 1. The
 *             cardinal curve runs from the second point to the last but one.
 * Units:      the caller's. Slopes are dp/dt.
 * Ownership:  plain values.
 * Errors:     false: too few or too many points, or neighbours that coincide where the parameter is
 *             their distance; nothing useful is in `out`.
 * Source:     I. J. Schoenberg, Quarterly of Applied Mathematics 4 (1946) 45; J. H. Ahlberg, E. N.
 *             Nilson, J. L. Walsh, The Theory of Splines and Their Applications (1967); E. T. Y.
 *             Lee, Computer-Aided Design 21 (1989) 363, for parameters.
 * Not modelled: closed curves.
 */
#ifndef ROMS_CURVES_SPLINE_H
#define ROMS_CURVES_SPLINE_H

#include "roms/curves/continuity.h"
#include "roms/curves/cubic_kind.h"

enum { SPLINE_POINTS_MOST = 32, SPLINE_PIECES_MOST = SPLINE_POINTS_MOST - 1 };
enum spline_parameter { SPLINE_UNIFORM, SPLINE_CHORDAL, SPLINE_CENTRIPETAL };

struct spline {
    int pieces;
    float knot[SPLINE_PIECES_MOST + 1];
    struct cubic_geometry piece[SPLINE_PIECES_MOST];
};

bool spline_natural(const struct vector3 *points, int count, enum spline_parameter parameter,
                    struct spline *out);
bool spline_clamped(const struct vector3 *points, int count, enum spline_parameter parameter,
                    struct vector3 slope0, struct vector3 slope1, struct spline *out);
bool spline_hermite(const struct vector3 *points, const struct vector3 *slopes, int count,
                    struct spline *out);
bool spline_cardinal(const struct vector3 *points, int count, float tension, struct spline *out);
bool spline_b_spline(const struct vector3 *points, int count, struct spline *out);
bool spline_bezier(const struct vector3 *points, int count, struct spline *out);

/* The point at t; beyond the ends the first and the last piece go on. */
struct vector3 spline_point(const struct spline *spline, float t);
/* What meets at the end of a piece, derivatives with respect to t: 0 ≤ piece < pieces − 1. */
struct join spline_join(const struct spline *spline, int piece);

#endif
