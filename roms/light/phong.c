/* phong.c — a normal a corner, interpolated, and the light of every pixel.
 *
 * With lights and eye at infinity N·L and N·V (or N·H) are planes over the triangle and N·N is
 * stepped by its second difference; a pixel then takes a square root and a division, and the power
 * where a highlight is. Otherwise a pixel asks illumination.h.
 */
#include "roms/geometry/scalar.h"
#include "roms/light/fresnel.h"
#include "roms/light/run.h"

/* What a light needs in a triangle. */
struct lamp {
    struct gradient d, s;    /* N·L; N·V or N·H */
    float toward_view;       /* L·V */
    float diffuse, specular; /* pixel values for N·L = 1 and for the power */
};

/* … and in a run: with values there and what a pixel adds. */
struct lit {
    float d, dd, s, ds, toward_view, diffuse, specular;
};

struct phong {
    struct gradient z, x, y, w; /* depth and normal */
    int count;
    struct lamp lamp[LIGHTS_MOST];
};

/* What is the same for all pixels. */
struct phong_surface {
    float ambient, top, low;
    const struct power_table *power;
    float index;
};

static struct gradient dot_gradient(const struct triangle *t, struct vector3 v)
{
    return triangle_gradient(t, vector3_dot(t->a->normal, v), vector3_dot(t->b->normal, v),
                             vector3_dot(t->c->normal, v));
}

static void far_begin(const struct shade *s, const struct triangle *t, struct phong *p)
{
    const struct lighting *l = s->lighting;
    const struct material *m = s->material;
    const struct vector3 *a = &t->a->normal, *b = &t->b->normal, *c = &t->c->normal;
    p->z = triangle_gradient(t, t->a->z, t->b->z, t->c->z);
    p->x = triangle_gradient(t, a->x, b->x, c->x);
    p->y = triangle_gradient(t, a->y, b->y, c->y);
    p->w = triangle_gradient(t, a->z, b->z, c->z);
    p->count = l->count;
    for (int i = 0; i < l->count; i++) {
        struct vector3 to = l->light[i].at, other = l->eye;
        if (m->halfway)
            other = vector3_direction(vector3_sum(to, l->eye));
        float intensity = l->light[i].intensity * s->scale;
        p->lamp[i] =
            (struct lamp){dot_gradient(t, to), dot_gradient(t, other), vector3_dot(to, l->eye),
                          intensity * m->kd, m->index > 0 ? intensity : intensity * m->ks};
    }
}

/* The pixel value of a pixel; `per_length` is 1/|N|. */
RUN_LOOP float phong_pixel(const struct phong_surface *u, const struct lit *lit, int count,
                           bool halfway, float per_length)
{
    float value = u->ambient;
    for (int i = 0; i < count; i++) {
        float c = lit[i].d * per_length;
        if (c > 0) {
            float r = lit[i].s * per_length;
            if (!halfway)
                r = fmaf(c + c, r, -lit[i].toward_view);
            value = fmaf(lit[i].diffuse, c, value);
            if (r > u->low) {
                float w = u->index > 0 ? fresnel(u->index, c) : 1;
                value = fmaf(lit[i].specular * w, power_read(u->power, scalar_min(r, 1)), value);
            }
        }
    }
    return scalar_min(value, u->top);
}

/* N·N along a run: its value, the change to the next pixel, and the change of that. */
struct square {
    float at, change, second;
};

RUN_LOOP struct square square_of(const struct triangle *t, const struct phong *p)
{
    struct vector3 step = {p->x.dx, p->y.dx, p->w.dx};
    struct vector3 n = {triangle_value(t, &p->x), triangle_value(t, &p->y),
                        triangle_value(t, &p->w)};
    float steps = vector3_dot(step, step);
    return (struct square){vector3_dot(n, n), 2 * vector3_dot(n, step) + steps, 2 * steps};
}

RUN_LOOP void lit_begin(const struct triangle *t, const struct phong *p, struct lit *lit, int count)
{
    for (int i = 0; i < count; i++) {
        const struct lamp *l = &p->lamp[i];
        lit[i].d = triangle_value(t, &l->d);
        lit[i].s = triangle_value(t, &l->s);
        lit[i].dd = l->d.dx;
        lit[i].ds = l->s.dx;
        lit[i].toward_view = l->toward_view;
        lit[i].diffuse = l->diffuse;
        lit[i].specular = l->specular;
    }
}

RUN_LOOP void phong_step(struct square *square, struct lit *lit, int count)
{
    square->at += square->change;
    square->change += square->second;
    for (int i = 0; i < count; i++) {
        lit[i].d += lit[i].dd;
        lit[i].s += lit[i].ds;
    }
}

RUN_LOOP void far_rows(const struct shade *s, struct triangle *t, unsigned bits, int one,
                       bool halfway)
{
    struct phong p;
    struct run_target to = run_target(s);
    struct phong_surface u = {fmaf(s->material->ka * s->lighting->ambient, s->scale, s->first),
                              s->top, s->power->low, s->power, s->material->index};
    far_begin(s, t, &p);
    int count = one ? 1 : p.count;
    while (triangle_next(t)) {
        struct run r = run_of(&to, t, &p.z, bits);
        struct square square = square_of(t, &p);
        struct lit lit[LIGHTS_MOST];
        lit_begin(t, &p, lit, count);
#define PIXEL(k)                                                                                   \
    if (r.z > r.near[k]) {                                                                         \
        r.near[k] = r.z;                                                                           \
        float value = phong_pixel(&u, lit, count, halfway, 1 / sqrtf(square.at));                  \
        run_put(r.at, k, bits, to.colours, (int)value);                                            \
    }                                                                                              \
    r.z += r.dz;                                                                                   \
    phong_step(&square, lit, count)
        RUN_EACH(r, bits, PIXEL);
#undef PIXEL
    }
}

/* A loop of its own for what is drawn most: one light. */
RUN_LOOP void far_triangle(const struct shade *s, struct triangle *t, unsigned bits)
{
    if (s->lighting->count != 1 || bits == 32)
        far_rows(s, t, bits, 0, s->material->halfway);
    else if (s->material->halfway)
        far_rows(s, t, bits, 1, true);
    else
        far_rows(s, t, bits, 1, false);
}

/* ---- lights or eye at a place ---------------------------------------------------------------- */

struct vector_gradient {
    struct gradient x, y, z;
};

static struct vector_gradient vector_gradient(const struct triangle *t, struct vector3 a,
                                              struct vector3 b, struct vector3 c)
{
    return (struct vector_gradient){triangle_gradient(t, a.x, b.x, c.x),
                                    triangle_gradient(t, a.y, b.y, c.y),
                                    triangle_gradient(t, a.z, b.z, c.z)};
}

static struct vector3 vector_value(const struct triangle *t, const struct vector_gradient *p)
{
    return (struct vector3){triangle_value(t, &p->x), triangle_value(t, &p->y),
                            triangle_value(t, &p->z)};
}

static struct vector3 vector_step(const struct vector_gradient *p)
{
    return (struct vector3){p->x.dx, p->y.dx, p->z.dx};
}

static void near_run(const struct shade *s, struct run *r, struct vector3 place,
                     struct vector3 place_step, struct vector3 normal, struct vector3 normal_step)
{
    for (; r->count > 0; r->count--) {
        if (r->z > *r->near) {
            *r->near = r->z;
            uint32_t pixel = shade_pixel(
                s, illumination_sum(illuminate(s->lighting, s->material, place, normal)));
            if (s->bits == 8)
                *r->at = (uint8_t)pixel;
            else
                *(uint32_t *)(void *)r->at = pixel;
        }
        r->z += r->dz;
        place = vector3_sum(place, place_step);
        normal = vector3_sum(normal, normal_step);
        r->at += s->bits / 8;
        r->near++;
    }
}

static void near_triangle(const struct shade *s, struct triangle *t)
{
    struct gradient z = triangle_gradient(t, t->a->z, t->b->z, t->c->z);
    struct vector_gradient place = vector_gradient(t, t->a->place, t->b->place, t->c->place);
    struct vector_gradient normal = vector_gradient(t, t->a->normal, t->b->normal, t->c->normal);
    struct run_target to = run_target(s);
    while (triangle_next(t)) {
        struct run r = run_of(&to, t, &z, s->bits);
        near_run(s, &r, vector_value(t, &place), vector_step(&place), vector_value(t, &normal),
                 vector_step(&normal));
    }
}

static bool all_far(const struct lighting *l)
{
    for (int i = 0; i < l->count; i++)
        if (l->light[i].kind != LIGHT_FAR)
            return false;
    return l->eye_far;
}

void shade_phong(struct shade *s, const struct shade_vertex *a, const struct shade_vertex *b,
                 const struct shade_vertex *c)
{
    struct triangle t;
    if (!triangle_begin(&t, s->width, s->height, a, b, c))
        return;
    s->triangles++;
    if (!all_far(s->lighting))
        near_triangle(s, &t);
    else if (s->bits == 8)
        far_triangle(s, &t, 8);
    else
        far_triangle(s, &t, 32);
    s->covered += (uint32_t)t.covered;
}
