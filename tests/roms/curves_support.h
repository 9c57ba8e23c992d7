/* curves_support.h — random points and slow exact curves for the tests of roms/curves. */
#ifndef TESTS_ROMS_CURVES_SUPPORT_H
#define TESTS_ROMS_CURVES_SUPPORT_H

#include "roms/curves/bezier.h"

enum { CASES = 3000 };

static uint32_t random_state = 1;

static inline uint32_t random_below(uint32_t limit)
{
    random_state = random_state * 1664525u + 1013904223u;
    return (random_state >> 8) % limit;
}

static inline float random_in(float low, float high)
{
    return low + (high - low) * (float)random_below(1 << 20) / (1 << 20);
}

static inline struct vector3 random_vector(float size)
{
    return (struct vector3){random_in(-size, size), random_in(-size, size), random_in(-size, size)};
}

static inline void random_points(struct vector3 *points, int count, float size)
{
    for (int i = 0; i < count; i++)
        points[i] = random_vector(size);
}

static inline double coordinate(struct vector3 v, int axis)
{
    return axis == 0 ? (double)v.x : axis == 1 ? (double)v.y : (double)v.z;
}

static inline double farthest(struct vector3 a, struct vector3 b)
{
    double most = 0;
    for (int axis = 0; axis < 3; axis++)
        most = fmax(most, fabs(coordinate(a, axis) - coordinate(b, axis)));
    return most;
}

#define assert_near(a, b, tolerance)                                                               \
    do {                                                                                           \
        double near_a = (a), near_b = (b), near_t = (tolerance);                                   \
        if (!(fabs(near_a - near_b) <= near_t))                                                    \
            fail_msg("%s = %.9g, not %.9g within %.3g", #a, near_a, near_b, near_t);               \
    } while (0)

/* De Casteljau in double precision, a coordinate. */
static inline double slow_bezier(const struct vector3 *points, int count, int axis, double u)
{
    double at[BEZIER_POINTS_MOST];
    for (int i = 0; i < count; i++)
        at[i] = coordinate(points[i], axis);
    for (int n = count - 1; n > 0; n--)
        for (int i = 0; i < n; i++)
            at[i] += u * (at[i + 1] - at[i]);
    return at[0];
}

/* Distance of a place from a line. */
static inline double from_line(const double at[3], struct vector3 a, struct vector3 b)
{
    double along[3], to[3], square = 0, dot = 0, rest = 0;
    for (int k = 0; k < 3; k++) {
        along[k] = coordinate(b, k) - coordinate(a, k);
        to[k] = at[k] - coordinate(a, k);
        square += along[k] * along[k];
        dot += along[k] * to[k];
    }
    double t = square > 0 ? fmin(fmax(dot / square, 0), 1) : 0;
    for (int k = 0; k < 3; k++)
        rest += (to[k] - t * along[k]) * (to[k] - t * along[k]);
    return sqrt(rest);
}

#endif
