/* tridiagonal.h — equations in which each unknown knows only its neighbours.
 *
 *      | b0 c0          | | x0 |   | r0 |
 *      | a1 b1 c1       | | x1 |   | r1 |      forward: each row takes a part of the row above;
 *      |    a2 b2 c2    | | x2 | = | r2 |      backward: the unknowns from the last one on
 *      |       …  …  …  | | …  |   | …  |
 *
 * Models:     Gaussian elimination without exchange of rows, for three right-hand sides at once.
 * Cost:       n unknowns: 2n divisions and 7n multiplications; elimination of a full matrix takes
 *             n³/3.
 * Domain:     |b| > |a| + |c| in each row (then no division is by 0 and errors do not grow), as for
 *             splines.
 * Units:      the caller's.
 * Ownership:  arrays are the caller's; `b` and `r` are used up, r becomes x.
 * Errors:     none within the domain.
 * Source:     L. H. Thomas, Elliptic problems in linear difference equations, Watson Sci. Comput.
 *             Lab. (1949).
 */
#ifndef ROMS_CURVES_TRIDIAGONAL_H
#define ROMS_CURVES_TRIDIAGONAL_H

#include "roms/geometry/vector.h"

/* a[0] and c[count − 1] are not looked at. */
void tridiagonal_solve(const float *a, float *b, const float *c, struct vector3 *r, int count);

#endif
