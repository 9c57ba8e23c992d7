/* vector.h — points and vectors of the plane and of space.
 *
 *           y                   right-handed: x to the right, y up,
 *           ▲                   z toward the viewer
 *           └──▶ x   (z: out of the page)
 *
 * Models:     pairs and triples of floats with their sums, products and lengths.
 * Units:      the caller's.
 * Ownership:  plain values.
 * Errors:     none: the direction of a vector of length 0 is that vector.
 * Source:     elementary.
 */
#ifndef ROMS_GEOMETRY_VECTOR_H
#define ROMS_GEOMETRY_VECTOR_H

#include <math.h>

struct point2 {
    float x, y;
};

struct vector3 {
    float x, y, z;
};

static inline struct vector3 vector3_sum(struct vector3 a, struct vector3 b)
{
    return (struct vector3){a.x + b.x, a.y + b.y, a.z + b.z};
}

/* From b to a. */
static inline struct vector3 vector3_difference(struct vector3 a, struct vector3 b)
{
    return (struct vector3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline struct vector3 vector3_times(struct vector3 a, float k)
{
    return (struct vector3){a.x * k, a.y * k, a.z * k};
}

static inline float vector3_dot(struct vector3 a, struct vector3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline struct vector3 vector3_cross(struct vector3 a, struct vector3 b)
{
    return (struct vector3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline float vector3_length(struct vector3 a)
{
    return sqrtf(vector3_dot(a, a));
}

/* Of length 1. */
static inline struct vector3 vector3_direction(struct vector3 a)
{
    float length = vector3_length(a);
    return length > 0 ? vector3_times(a, 1.0f / length) : a;
}

#endif
