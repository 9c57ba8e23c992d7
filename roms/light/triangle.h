/* triangle.h — a triangle on the canvas: its rows, and quantities that change evenly over it.
 *
 *      a ●                 rows from ceil(a.y) up to, not including, ceil(c.y);
 *        │╲  ◀─ run ─▶     pixels from ceil(left) up to, not including, ceil(right)
 *      b ●──╲──
 *          ╲ ╲             v(x, y) = v(0, 0) + ∂v/∂x x + ∂v/∂y y
 *            ● c
 *
 * Models:     scan conversion between two edges that are stepped in fixed point, and the plane
 *             through three values. A pixel belongs to the triangle when its middle does; a middle
 *             on an edge belongs to the triangle on its right or below. An edge's places depend on
 *             its two ends alone, so that triangles which share an edge share no pixel and leave
 *             none out.
 * Cost:       about 85 instructions a triangle, 16 a row, 8 a quantity and 4 more a row for each.
 * Domain:     corners within ±TRIANGLE_LIMIT pixels; others are not drawn: clip before.
 * Units:      pixels, y downwards, middles of pixels are whole numbers; edges: 1/65536 pixel.
 * Ownership:  plain values.
 * Errors:     triangles without rows, without area, or beyond the limit (and what is not a number):
 *             false.
 * Source:     elementary; W. J. Bouknight, CACM 13 (1970) 527, for stepping along scan lines.
 * Not modelled: edges of curves; perspective within a triangle (values are even on the screen).
 */
#ifndef ROMS_LIGHT_TRIANGLE_H
#define ROMS_LIGHT_TRIANGLE_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#include "roms/geometry/scalar.h"
#include "roms/geometry/vector.h"

enum { TRIANGLE_LIMIT = 8192 };
/* An edge less high than this counts as upright: beside it a slope is beyond floats. */
#define TRIANGLE_LOWEST 1e-30f

/* A corner: where it is on the canvas and how near (depth_buffer.h), and what it is in space. */
struct shade_vertex {
    float x, y, z;
    struct vector3 place, normal; /* in space; the normal of length 1 */
    float intensity;              /* of its light */
};

struct triangle {
    const struct shade_vertex *a, *b, *c; /* from top to bottom */
    float abx, aby, acx, acy;             /* from a to b and c */
    float inverse;                        /* 1 / twice the area, with sign */
    /* Rows. */
    int y, x0, x1; /* the present run */
    int end, middle, width;
    int32_t left, right, left_step, right_step;
    bool bends_left; /* the edge that ends at b is the left one */
    int covered;     /* pixels of all runs so far */
};

/* What changes evenly: its value at the canvas' first pixel, and a pixel to the right and down. */
struct gradient {
    float at, dx, dy;
};

/* Always: rows are short. */
#define TRIANGLE_INLINE static inline __attribute__((always_inline))

/* Where the edge is in its first row that is shown, and what a row adds. */
static inline int32_t triangle_edge(const struct shade_vertex *a, const struct shade_vertex *b,
                                    int32_t *step)
{
    int first = scalar_ceil(a->y);
    float start = (float)(first > 0 ? first : 0), down = b->y - a->y;
    float slope = down > TRIANGLE_LOWEST ? (b->x - a->x) / down : 0;
    float x = fmaf(slope, start - a->y, a->x);
    *step = b->y - start > 1 ? (int32_t)lrintf(slope * 65536) : 0;
    return (int32_t)(x * 65536);
}

static inline bool triangle_corner_fits(const struct shade_vertex *v)
{
    return fabsf(v->x) <= TRIANGLE_LIMIT && fabsf(v->y) <= TRIANGLE_LIMIT;
}

/* The edge that begins at b. */
static inline void triangle_bend(struct triangle *t)
{
    if (t->bends_left)
        t->left = triangle_edge(t->b, t->c, &t->left_step);
    else
        t->right = triangle_edge(t->b, t->c, &t->right_step);
}

/* For a canvas so wide and high. The corners must outlive the triangle. */
static inline bool triangle_begin(struct triangle *t, int width, int height,
                                  const struct shade_vertex *a, const struct shade_vertex *b,
                                  const struct shade_vertex *c)
{
    const struct shade_vertex *kept;
    if (!triangle_corner_fits(a) || !triangle_corner_fits(b) || !triangle_corner_fits(c))
        return false;
    if (a->y > b->y)
        kept = a, a = b, b = kept;
    if (b->y > c->y)
        kept = b, b = c, c = kept;
    if (a->y > b->y)
        kept = a, a = b, b = kept;
    t->a = a, t->b = b, t->c = c;
    t->abx = b->x - a->x, t->aby = b->y - a->y;
    t->acx = c->x - a->x, t->acy = c->y - a->y;
    float area = t->abx * t->acy - t->acx * t->aby;
    int first = scalar_ceil(a->y), end = scalar_ceil(c->y);
    t->y = (first > 0 ? first : 0) - 1;
    t->end = end < height ? end : height;
    if (area == 0 || t->y + 1 >= t->end)
        return false;
    t->inverse = 1 / area;
    t->width = width;
    t->covered = 0;
    t->bends_left = area < 0;
    t->middle = scalar_ceil(b->y);
    int32_t whole_step, whole = triangle_edge(a, c, &whole_step), part_step = 0, part = 0;
    if (t->middle > first && t->middle > 0) {
        part = triangle_edge(a, b, &part_step);
    } else {
        part = triangle_edge(b, c, &part_step);
        t->middle = -1;
    }
    t->left = t->bends_left ? part : whole, t->left_step = t->bends_left ? part_step : whole_step;
    t->right = t->bends_left ? whole : part;
    t->right_step = t->bends_left ? whole_step : part_step;
    return true;
}

/* The next row with pixels: row y, pixels x0 up to, not including, x1. */
TRIANGLE_INLINE bool triangle_next(struct triangle *t)
{
    do {
        if (++t->y >= t->end)
            return false;
        if (t->y == t->middle)
            triangle_bend(t);
        int x0 = (t->left + 0xFFFF) >> 16, x1 = (t->right + 0xFFFF) >> 16;
        t->x0 = x0 > 0 ? x0 : 0;
        t->x1 = x1 < t->width ? x1 : t->width;
        t->left += t->left_step;
        t->right += t->right_step;
    } while (t->x0 >= t->x1);
    t->covered += t->x1 - t->x0;
    return true;
}

/* Through the values at t->a, t->b and t->c. */
TRIANGLE_INLINE struct gradient triangle_gradient(const struct triangle *t, float a, float b,
                                                  float c)
{
    float ab = (b - a) * t->inverse, ac = (c - a) * t->inverse;
    float dx = ab * t->acy - ac * t->aby, dy = ac * t->abx - ab * t->acx;
    return (struct gradient){fmaf(-dx, t->a->x, fmaf(-dy, t->a->y, a)), dx, dy};
}

/* At the first pixel of the present run. */
TRIANGLE_INLINE float triangle_value(const struct triangle *t, const struct gradient *p)
{
    return fmaf(p->dx, (float)t->x0, fmaf(p->dy, (float)t->y, p->at));
}

#endif
