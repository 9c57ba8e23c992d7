#include "roms/curves/b_spline.h"

#include <stddef.h>

void b_spline_uniform(struct b_spline *s)
{
    for (int i = 0; i < s->count + s->degree + 1; i++)
        s->knot[i] = (float)i;
}

void b_spline_open(struct b_spline *s)
{
    int pieces = s->count - s->degree;
    for (int i = 0; i < s->count + s->degree + 1; i++) {
        int t = i - s->degree;
        s->knot[i] = (float)(t < 0 ? 0 : t > pieces ? pieces : t);
    }
}

const char *b_spline_trouble(const struct b_spline *s)
{
    if (s->degree < 1 || s->degree > B_SPLINE_DEGREE_MOST)
        return "the degree is not within 1 and 7";
    if (s->count < s->degree + 1 || s->count > B_SPLINE_POINTS_MOST)
        return "it takes degree + 1 points at least, and 32 at most";
    for (int i = 1; i < s->count + s->degree + 1; i++)
        if (!(s->knot[i] >= s->knot[i - 1]))
            return "a knot is before the one that it follows";
    if (!(b_spline_end(s) > b_spline_start(s)))
        return "all knots of the curve coincide";
    return NULL;
}

float b_spline_start(const struct b_spline *s)
{
    return s->knot[s->degree];
}

float b_spline_end(const struct b_spline *s)
{
    return s->knot[s->count];
}

/* The span t_k ≤ t < t_k+1 of the curve; at the end the last one that is not empty. */
static int span_of(const struct b_spline *s, float t)
{
    int k = s->degree;
    for (int i = s->degree; i < s->count; i++)
        if (s->knot[i + 1] > s->knot[i] && t >= s->knot[i])
            k = i;
    return k;
}

/* over / under, where 0/0 is 0. */
static float part(float over, float under)
{
    return under > 0 ? over / under : 0;
}

void b_spline_basis(const struct b_spline *s, float t, float value[])
{
    float level[B_SPLINE_KNOTS_MOST] = {0};
    level[span_of(s, t)] = 1;
    for (int d = 1; d <= s->degree; d++)
        for (int k = 0; k < s->count + s->degree - d; k++) {
            const float *at = &s->knot[k];
            level[k] = part(t - at[0], at[d] - at[0]) * level[k] +
                       part(at[d + 1] - t, at[d + 1] - at[1]) * level[k + 1];
        }
    for (int k = 0; k < s->count; k++)
        value[k] = level[k];
}

void de_boor_begin(struct de_boor *d, const struct b_spline *s, float t)
{
    *d = (struct de_boor){.spline = s, .span = span_of(s, t), .t = t};
    for (int i = 0; i <= s->degree; i++)
        d->at[i] = s->point[d->span - s->degree + i];
}

bool de_boor_next(struct de_boor *d)
{
    const struct b_spline *s = d->spline;
    if (d->level >= s->degree)
        return false;
    d->level++;
    for (int i = 0; i <= s->degree - d->level; i++) {
        const float *at = &s->knot[d->span - s->degree + d->level + i];
        float u = part(d->t - at[0], at[s->degree + 1 - d->level] - at[0]);
        d->at[i] = vector3_sum(vector3_times(d->at[i], 1 - u), vector3_times(d->at[i + 1], u));
    }
    return true;
}

struct vector3 b_spline_point(const struct b_spline *s, float t)
{
    struct de_boor d;
    de_boor_begin(&d, s, t);
    while (de_boor_next(&d))
        continue;
    return d.at[0];
}
