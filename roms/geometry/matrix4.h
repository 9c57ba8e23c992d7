/* matrix4.h — 4 by 4 matrices: transformations of space in homogeneous coordinates.
 *
 *      | x' |            | x |      a point is a column; the matrix that is applied first stands
 *      | y' | = (4 × 4) ·| y |      rightmost in a product
 *      | z' |            | z |
 *      | h  |            | 1 |
 *
 * Models:     product, application with and without the division by h, inverse.
 * Units:      the caller's.
 * Ownership:  plain values.
 * Errors:     a singular matrix has no inverse: false, and nothing is written. A point with h = 0 lies
 *             at infinity: clip before the division.
 * Source:     elementary; the inverse by elimination with the largest pivot. Cost: a product takes 64
 *             multiplications, a point 16.
 */
#ifndef ROMS_GEOMETRY_MATRIX4_H
#define ROMS_GEOMETRY_MATRIX4_H

#include <stdbool.h>

#include "roms/geometry/vector.h"

struct matrix4 {
    float at[4][4]; /* row, column */
};

/* A point before the division by h. */
struct vector4 {
    float x, y, z, h;
};

struct matrix4 matrix4_identity(void);
struct matrix4 matrix4_product(const struct matrix4 *a, const struct matrix4 *b);
struct vector4 matrix4_homogeneous(const struct matrix4 *m, struct vector3 p);
struct vector3 matrix4_apply(const struct matrix4 *m, struct vector3 p);
/* Without translation and perspective. */
struct vector3 matrix4_apply_direction(const struct matrix4 *m, struct vector3 v);
bool matrix4_inverse(const struct matrix4 *m, struct matrix4 *out);

#endif
