/* matrix3.h — 3 by 3 matrices: transformations of the plane in homogeneous coordinates.
 *
 *      | x' |   | a b c |   | x |      a point is a column; the matrix that is applied first
 *      | y' | = | d e f | · | y |      stands rightmost in a product
 *      | h  |   | . . . |   | 1 |
 *
 * Models:     product, application with the division by h, inverse.
 * Units:      the caller's.
 * Ownership:  plain values.
 * Errors:     a singular matrix has no inverse: false, and nothing is written.
 * Source:     elementary; the inverse by the adjugate. Cost: a product takes 27 multiplications.
 */
#ifndef ROMS_GEOMETRY_MATRIX3_H
#define ROMS_GEOMETRY_MATRIX3_H

#include <stdbool.h>

#include "roms/geometry/vector.h"

struct matrix3 {
    float at[3][3]; /* row, column */
};

struct matrix3 matrix3_identity(void);
struct matrix3 matrix3_product(const struct matrix3 *a, const struct matrix3 *b);
struct point2 matrix3_apply(const struct matrix3 *m, struct point2 p);
bool matrix3_inverse(const struct matrix3 *m, struct matrix3 *out);

#endif
