/* fast_phong.h — the light of an interpolated normal as a polynomial of second degree.
 *
 *      N(x, y) = A x + B y + C                                  even over the triangle
 *
 *       L·N          a x + b y + c
 *      ─────── = ───────────────────────── ≈ T5 x² + T4 xy + T3 y² + T2 x + T1 y + T0
 *      |L| |N|   √(dx² + exy + fy² + gx + hy + i)
 *
 * Models:     the Taylor series about (0,0), which is to be put into the middle of the triangle;
 *             along a row two additions a pixel give its next value.
 * Cost:       the normal's part 40 operations a triangle, a series 45 a light and kind of
 *             reflection.
 * Domain:     L of length 1. Normals at the corners that differ little: with δ the largest angle
 *             between any two of them, up to 1.5 radians, the error is under 0.25 δ³ (at most 0.172
 *             δ³ in 10 000 random triangles: tests/roms/test_light.c; 0.001 for 10°, 0.02 for 30°).
 * Units:      x and y: pixels, or the caller's.
 * Ownership:  plain values.
 * Errors:     normals that cancel each other in the middle: all terms are 0.
 * Source:     G. Bishop, D. M. Weimer, Fast Phong Shading, Computer Graphics 20 (SIGGRAPH 1986)
 *             103.
 * Not modelled: R·V, which is no quotient of this form: highlights take N·H (illumination.h).
 */
#ifndef ROMS_LIGHT_FAST_PHONG_H
#define ROMS_LIGHT_FAST_PHONG_H

#include "roms/geometry/vector.h"

struct fast_phong_normal {
    struct vector3 a, b, c; /* A, B, C */
    float d, e, f, g, h, i;
    float p1, p3, p5; /* 1/√i, 1/(2 √i³), 3/(8 √i⁵) */
};

struct fast_phong_series {
    float a, b, c;
    float t[6];
};

static inline struct fast_phong_normal fast_phong_normal(struct vector3 a, struct vector3 b,
                                                         struct vector3 c)
{
    struct fast_phong_normal n = {.a = a, .b = b, .c = c};
    n.d = vector3_dot(a, a);
    n.e = 2 * vector3_dot(a, b);
    n.f = vector3_dot(b, b);
    n.g = 2 * vector3_dot(a, c);
    n.h = 2 * vector3_dot(b, c);
    n.i = vector3_dot(c, c);
    if (n.i > 1e-8f) {
        float per_i = 1 / n.i;
        n.p1 = sqrtf(per_i);
        n.p3 = 0.5f * n.p1 * per_i;
        n.p5 = 0.75f * n.p3 * per_i;
    }
    return n;
}

static inline struct fast_phong_series fast_phong_series(const struct fast_phong_normal *n,
                                                         struct vector3 light)
{
    float a = vector3_dot(light, n->a), b = vector3_dot(light, n->b);
    float c = vector3_dot(light, n->c), c5 = c * n->p5;
    struct fast_phong_series s = {a, b, c, {0}};
    s.t[0] = c * n->p1;
    s.t[1] = b * n->p1 - c * n->h * n->p3;
    s.t[2] = a * n->p1 - c * n->g * n->p3;
    s.t[3] = c5 * n->h * n->h - (b * n->h + c * n->f) * n->p3;
    s.t[4] = 2 * c5 * n->g * n->h - (a * n->h + b * n->g + c * n->e) * n->p3;
    s.t[5] = c5 * n->g * n->g - (a * n->g + c * n->d) * n->p3;
    return s;
}

static inline float fast_phong_value(const struct fast_phong_series *s, float x, float y)
{
    const float *t = s->t;
    return (t[5] * x + t[4] * y + t[2]) * x + (t[3] * y + t[1]) * y + t[0];
}

#endif
