/* phong.c — a normal a corner, interpolated, and the light of every pixel.
 *
 * With lights and eye at infinity N·L and N·V (or N·H) are planes over the triangle and N·N is stepped by its
 * second difference; a pixel then takes a square root and a division, and the power where a highlight is.
 * Otherwise a pixel asks illumination.h.
 */
#include "roms/light/fresnel.h"
#include "roms/light/run.h"

/* What a light needs in a run: N·L and its change; N·V or N·H likewise. */
struct lit {
    float d, dd, s, ds;
};

/* … and in a triangle. */
struct lamp {
    struct plane d, s;
    float toward_view;       /* L·V */
    float diffuse, specular; /* pixel values for N·L = 1 and for the power */
};

struct phong {
    struct plane z, x, y, w; /* depth and normal */
    float ambient, low;
    bool halfway;
    int count;
    struct lamp lamp[LIGHTS_MOST];
};

static struct plane dot_plane(const struct triangle *t, struct vector3 v)
{
    return triangle_plane(t, vector3_dot(t->a->normal, v), vector3_dot(t->b->normal, v),
                          vector3_dot(t->c->normal, v));
}

static void far_begin(const struct shade *s, const struct triangle *t, struct phong *p)
{
    const struct lighting *l = s->lighting;
    const struct material *m = s->material;
    p->z = triangle_plane(t, t->a->z, t->b->z, t->c->z);
    p->x = triangle_plane(t, t->a->normal.x, t->b->normal.x, t->c->normal.x);
    p->y = triangle_plane(t, t->a->normal.y, t->b->normal.y, t->c->normal.y);
    p->w = triangle_plane(t, t->a->normal.z, t->b->normal.z, t->c->normal.z);
    p->ambient = s->first + m->ka * l->ambient * s->scale;
    p->low = s->power->low;
    p->halfway = m->halfway;
    p->count = l->count;
    for (int i = 0; i < l->count; i++) {
        struct vector3 to = l->light[i].at;
        struct vector3 half = vector3_direction(vector3_sum(to, l->eye));
        float intensity = l->light[i].intensity * s->scale;
        p->lamp[i] = (struct lamp){dot_plane(t, to), dot_plane(t, m->halfway ? half : l->eye),
                                   vector3_dot(to, l->eye), intensity * m->kd, intensity * m->ks};
        if (m->index > 0)
            p->lamp[i].specular = intensity;
    }
}

/* The pixel value of one light's highlight; `c` is N·L. */
RUN_LOOP float highlight(const struct shade *s, const struct lamp *lamp, float r, float c)
{
    float value = lamp->specular * power_read(s->power, smaller(r, 1));
    return s->material->index > 0 ? value * fresnel(s->material->index, c) : value;
}

/* `per_length` is 1/|N|. */
RUN_LOOP float value_of(const struct shade *s, const struct phong *p, const struct lit *lit,
                        int count, bool halfway, float per_length)
{
    float value = p->ambient;
    for (int i = 0; i < count; i++) {
        const struct lamp *lamp = &p->lamp[i];
        float c = lit[i].d * per_length;
        if (c > 0) {
            float r = lit[i].s * per_length;
            if (!halfway)
                r = fmaf(2 * c, r, -lamp->toward_view);
            value = fmaf(lamp->diffuse, c, value);
            if (r > p->low)
                value += highlight(s, lamp, r, c);
        }
    }
    return value;
}

RUN_LOOP void far_run(const struct shade *s, const struct phong *p, const struct triangle *t,
                      unsigned bits, int count, bool halfway)
{
    struct run r = run_of(s, t, &p->z, bits);
    struct lit lit[LIGHTS_MOST];
    for (int i = 0; i < count; i++)
        lit[i] = (struct lit){triangle_value(t, &p->lamp[i].d), p->lamp[i].d.dx,
                              triangle_value(t, &p->lamp[i].s), p->lamp[i].s.dx};
    struct vector3 step = {p->x.dx, p->y.dx, p->w.dx};
    struct vector3 n = {triangle_value(t, &p->x), triangle_value(t, &p->y),
                        triangle_value(t, &p->w)};
    float square = vector3_dot(n, n), steps = vector3_dot(step, step);
    float change = 2 * vector3_dot(n, step) + steps; /* of N·N, to the next pixel */
    for (; r.count > 0; r.count--) {
        if (r.z > *r.near) {
            *r.near = r.z;
            float value = value_of(s, p, lit, count, halfway, 1 / sqrtf(square));
            run_put(r.at, 0, bits, s->colours, (int)smaller(value, s->top));
        }
        r.z += r.dz;
        square += change;
        change += 2 * steps;
        for (int i = 0; i < count; i++) {
            lit[i].d += lit[i].dd;
            lit[i].s += lit[i].ds;
        }
        r.at += bits / 8;
        r.near++;
    }
}

RUN_LOOP void far_rows(const struct shade *s, struct triangle *t, unsigned bits, int count,
                       bool halfway)
{
    struct phong p;
    far_begin(s, t, &p);
    while (triangle_next(t))
        far_run(s, &p, t, bits, count > 0 ? count : p.count, halfway);
}

/* A loop for what is drawn most: one light. */
RUN_LOOP void far_triangle(const struct shade *s, struct triangle *t, unsigned bits)
{
    if (s->lighting->count != 1)
        far_rows(s, t, bits, 0, s->material->halfway);
    else if (s->material->halfway)
        far_rows(s, t, bits, 1, true);
    else
        far_rows(s, t, bits, 1, false);
}

/* ---- lights or eye at a place ------------------------------------------------------------------- */

struct vector_plane {
    struct plane x, y, z;
};

static struct vector_plane vector_plane(const struct triangle *t, struct vector3 a, struct vector3 b,
                                        struct vector3 c)
{
    return (struct vector_plane){triangle_plane(t, a.x, b.x, c.x), triangle_plane(t, a.y, b.y, c.y),
                                 triangle_plane(t, a.z, b.z, c.z)};
}

static struct vector3 vector_value(const struct triangle *t, const struct vector_plane *p)
{
    return (struct vector3){triangle_value(t, &p->x), triangle_value(t, &p->y),
                            triangle_value(t, &p->z)};
}

static struct vector3 vector_step(const struct vector_plane *p)
{
    return (struct vector3){p->x.dx, p->y.dx, p->z.dx};
}

static void near_run(const struct shade *s, struct run *r, struct vector3 place,
                     struct vector3 place_step, struct vector3 normal, struct vector3 normal_step)
{
    for (; r->count > 0; r->count--) {
        if (r->z > *r->near) {
            *r->near = r->z;
            uint32_t pixel = shade_pixel(s, illumination_sum(illuminate(s->lighting, s->material,
                                                                        place, normal)));
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
    struct plane z = triangle_plane(t, t->a->z, t->b->z, t->c->z);
    struct vector_plane place = vector_plane(t, t->a->place, t->b->place, t->c->place);
    struct vector_plane normal = vector_plane(t, t->a->normal, t->b->normal, t->c->normal);
    while (triangle_next(t)) {
        struct run r = run_of(s, t, &z, s->bits);
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
