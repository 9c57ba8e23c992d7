/* fit.h — where the paper lies on the tablet: from counts to millimetres of the drawing.
 *
 *      touched  u, v (counts)  ──▶  known x, y (mm)
 *
 *      similarity  x = a·u − b·v + c     turned, moved, scaled: two points or more
 *                  y = b·u + a·v + f
 *      affine      x = a·u + b·v + c     also stretched and skewed, as a sonic tablet in warm air and a
 *                  y = d·u + e·v + f     copy of a drawing are: three points or more, not on a line
 *
 * Models:     the transformation with the least sum of squared distances; with as few points as it
 *             takes it is exact and its residual says nothing.
 * Cost:       some 20 operations a point.
 * Domain:     up to FIT_POINTS_MOST points; counts and millimetres up to some thousands.
 * Units:      counts, millimetres.
 * Ownership:  plain values.
 * Errors:     a sentence: too few points, points that coincide or lie on a line. The old fit stays.
 * Source:     normal equations about the centroids: C. F. Gauss (1809), in every book.
 */
#ifndef ROMS_DIGITISE_FIT_H
#define ROMS_DIGITISE_FIT_H

#include <stdbool.h>

#include "roms/geometry/vector.h"

enum { FIT_POINTS_MOST = 8 };

struct fit_pair {
    struct point2 touched; /* counts */
    struct point2 known;   /* mm */
};

struct fit {
    float a, b, c, d, e, f; /* x = a·u + b·v + c, y = d·u + e·v + f */
    struct point2 origin;   /* of u, v: counts; sums stay small */
    bool affine;
    int points;
    float residual; /* mm, root mean square of the distances */
    bool checked;   /* there are more points than it takes */
};

/* No paper: millimetres of the tablet. */
struct fit fit_tablet(float mm_a_count);
/* NULL: done. */
const char *fit_points(const struct fit_pair *pair, int count, bool affine, struct fit *out);
struct point2 fit_place(const struct fit *fit, struct point2 counts);
/* Millimetres a count, about. */
float fit_scale(const struct fit *fit);
/* Degrees by which the paper is turned on the tablet, counter-clockwise. */
float fit_turn(const struct fit *fit);

#endif
