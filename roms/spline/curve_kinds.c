/* curve_kinds.c — what each kind of curve makes of the points. */
#include <stddef.h>

#include "roms/spline/curve.h"
#include "roms/spline/periodic.h"

static struct vector3 mix(struct vector3 a, struct vector3 b, float part)
{
    return vector3_sum(vector3_times(a, 1 - part), vector3_times(b, part));
}

static int points_of(const struct model *m, struct vector3 *out)
{
    for (int i = 0; i < m->count; i++)
        out[i] = m->point[i].at;
    return m->count;
}

static void equal_knots(struct curve *c)
{
    for (int i = 0; i <= c->pieces; i++)
        c->knot[i] = (float)i;
}

static const char *bezier(const struct model *m, struct curve *c)
{
    c->pieces = 1;
    c->order = model_polygon(m, c->control);
    equal_knots(c);
    return NULL;
}

static const char *handles(const struct model *m, struct curve *c)
{
    c->pieces = c->closed ? m->count : m->count - 1;
    for (int i = 0; i < c->pieces; i++) {
        int next = (i + 1) % m->count;
        struct vector3 *p = c->control + 4 * i;
        p[0] = m->point[i].at;
        p[1] = model_handle(m, i, true);
        p[2] = model_handle(m, next, false);
        p[3] = m->point[next].at;
    }
    equal_knots(c);
    return NULL;
}

static const char *natural(const struct model *m, struct curve *c)
{
    struct vector3 p[MODEL_POINTS_MOST];
    struct spline s;
    int count = points_of(m, p);
    if (!(c->closed ? periodic_spline(p, count, m->parameter, &s)
                    : spline_natural(p, count, m->parameter, &s)))
        return "Points coincide: with knots by distance there is no spline.";
    c->pieces = s.pieces;
    for (int i = 0; i <= s.pieces; i++)
        c->knot[i] = s.knot[i];
    for (int i = 0; i < s.pieces; i++) {
        const struct vector3 *g = s.piece[i].g;
        struct vector3 *q = c->control + 4 * i;
        q[0] = g[0];
        q[1] = vector3_sum(g[0], vector3_times(g[2], 1 / 3.0f));
        q[2] = vector3_difference(g[1], vector3_times(g[3], 1 / 3.0f));
        q[3] = g[1];
    }
    return NULL;
}

bool curve_b_spline(const struct model *m, struct b_spline *out)
{
    bool closed = m->closed && m->count > 2;
    out->degree = 3;
    out->count = m->count + (closed ? 3 : 0);
    for (int i = 0; i < out->count; i++)
        out->point[i] = m->point[i % m->count].at;
    b_spline_uniform(out);
    return m->kind == MODEL_B_SPLINE && b_spline_trouble(out) == NULL;
}

static const char *means(const struct model *m, struct curve *c)
{
    struct b_spline s;
    if (!curve_b_spline(m, &s))
        return "A cubic B-spline takes four points (closed: three).";
    c->pieces = s.count - 3;
    for (int i = 0; i < c->pieces; i++) {
        const struct vector3 *p = s.point + i;
        struct vector3 *q = c->control + 4 * i;
        q[1] = mix(p[1], p[2], 1 / 3.0f);
        q[2] = mix(p[1], p[2], 2 / 3.0f);
        q[0] = mix(mix(p[0], p[1], 2 / 3.0f), q[1], 0.5f);
        q[3] = mix(q[2], mix(p[2], p[3], 1 / 3.0f), 0.5f);
    }
    equal_knots(c);
    return NULL;
}

const char *curve_of(const struct model *m, struct curve *c)
{
    static const char *(*const make[MODEL_KINDS])(const struct model *, struct curve *) = {
        bezier, handles, natural, means};
    c->closed = m->closed && m->count > 2;
    c->order = 4;
    if (m->count < 2)
        return "Touch the drawing area: two points make a curve.";
    return make[m->kind](m, c);
}
