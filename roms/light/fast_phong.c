/* fast_phong.c — Phong shading by fast_phong.h.
 *
 * A pixel: diffuse and specular polynomial stepped by two additions each; the power where a
 * highlight is. Lights and an eye that are at a place are taken as they are seen from the
 * triangle's middle, and so is w(θ). Where the model has (R·V)^n, (N·H)^4n stands for it: φ is
 * twice the angle between N and H.
 */
#include "roms/light/fast_phong.h"

#include "roms/geometry/scalar.h"
#include "roms/light/run.h"

/* A light's polynomials in a triangle, about its middle; and in a run. */
struct glow {
    struct fast_phong_series d, s;
    float floor; /* no less than that is diffuse */
    float specular;
};

struct stepped {
    float d, dd, ddd, s, ds, dds, floor, specular;
};

struct fast_phong {
    struct gradient z;
    float x, y; /* the middle */
    float low;  /* of N·H */
    bool fourth;
    int count;
    struct glow glow[LIGHTS_MOST];
};

static struct vector3 fast_mean(struct vector3 a, struct vector3 b, struct vector3 c)
{
    return vector3_times(vector3_sum(vector3_sum(a, b), c), 1.0f / 3);
}

static struct fast_phong_normal fast_normal(const struct triangle *t)
{
    const struct vector3 *a = &t->a->normal, *b = &t->b->normal, *c = &t->c->normal;
    struct gradient x = triangle_gradient(t, a->x, b->x, c->x),
                    y = triangle_gradient(t, a->y, b->y, c->y);
    struct gradient z = triangle_gradient(t, a->z, b->z, c->z);
    return fast_phong_normal((struct vector3){x.dx, y.dx, z.dx}, (struct vector3){x.dy, y.dy, z.dy},
                             fast_mean(*a, *b, *c));
}

/* What the light does in the triangle's middle; `toward`, `attenuation` and `w` count. */
static struct light_term fast_term(const struct shade *s, struct vector3 place,
                                   struct vector3 normal, int i)
{
    const struct light *light = &s->lighting->light[i];
    if (light->kind != LIGHT_FAR || s->material->index > 0)
        return illumination_term(s->lighting, s->material, place, normal, i);
    return (struct light_term){.toward = light->at, .attenuation = 1, .w = s->material->ks};
}

static void fast_begin(const struct shade *s, const struct triangle *t, struct fast_phong *p)
{
    const struct lighting *l = s->lighting;
    const struct material *m = s->material;
    struct vector3 place = fast_mean(t->a->place, t->b->place, t->c->place);
    struct vector3 view = lighting_view(l, place);
    struct fast_phong_normal n = fast_normal(t);
    p->z = triangle_gradient(t, t->a->z, t->b->z, t->c->z);
    p->x = (t->abx + t->acx) * (1.0f / 3) + t->a->x;
    p->y = (t->aby + t->acy) * (1.0f / 3) + t->a->y;
    p->fourth = !m->halfway;
    p->low = p->fourth ? sqrtf(sqrtf(s->power->low)) : s->power->low;
    p->count = l->count;
    float floor = s->first + m->ka * l->ambient * s->scale;
    for (int i = 0; i < l->count; i++) {
        struct light_term term = fast_term(s, place, n.c, i);
        struct glow *g = &p->glow[i];
        float intensity = l->light[i].intensity * term.attenuation * s->scale;
        g->d = fast_phong_series(&n, vector3_times(term.toward, intensity * m->kd));
        g->s = fast_phong_series(&n, vector3_direction(vector3_sum(term.toward, view)));
        g->d.t[0] += floor;
        g->floor = floor;
        g->specular = intensity * term.w;
        floor = 0;
    }
}

/* A polynomial at the run's beginning, with its first and second differences. */
RUN_LOOP void fast_step_begin(const struct fast_phong_series *s, float x, float y, float *value,
                              float *first, float *second)
{
    float across = s->t[4] * y + s->t[2];
    *value = fast_phong_value(s, x, y);
    *first = s->t[5] * (2 * x + 1) + across;
    *second = 2 * s->t[5];
}

/* What is the same for all pixels. */
struct fast_surface {
    float top, low; /* low: of N·H */
    bool fourth;
    const struct power_table *power;
};

RUN_LOOP float fast_pixel(const struct fast_surface *u, const struct stepped *at, int count)
{
    float value = scalar_max(at[0].d, at[0].floor);
    for (int i = 1; i < count; i++)
        value += scalar_max(at[i].d, at[i].floor);
    for (int i = 0; i < count; i++) {
        float r = at[i].s;
        if (r > u->low && at[i].d > at[i].floor) {
            if (u->fourth)
                r *= r, r *= r;
            value = fmaf(at[i].specular, power_read(u->power, scalar_min(r, 1)), value);
        }
    }
    return scalar_min(value, u->top);
}

RUN_LOOP void fast_step(struct stepped *at, int count)
{
    for (int i = 0; i < count; i++) {
        at[i].d += at[i].dd;
        at[i].dd += at[i].ddd;
        at[i].s += at[i].ds;
        at[i].ds += at[i].dds;
    }
}

RUN_LOOP void fast_run_begin(const struct triangle *t, const struct fast_phong *p,
                             struct stepped *at, int count)
{
    float x = (float)t->x0 - p->x, y = (float)t->y - p->y;
    for (int i = 0; i < count; i++) {
        const struct glow *g = &p->glow[i];
        fast_step_begin(&g->d, x, y, &at[i].d, &at[i].dd, &at[i].ddd);
        fast_step_begin(&g->s, x, y, &at[i].s, &at[i].ds, &at[i].dds);
        at[i].floor = g->floor;
        at[i].specular = g->specular;
    }
}

RUN_LOOP void fast_rows(const struct shade *s, struct triangle *t, unsigned bits, bool one)
{
    struct fast_phong p;
    struct run_target to = run_target(s);
    fast_begin(s, t, &p);
    struct fast_surface u = {s->top, p.low, p.fourth, s->power};
    int count = one ? 1 : p.count;
    while (triangle_next(t)) {
        struct run r = run_of(&to, t, &p.z, bits);
        struct stepped at[LIGHTS_MOST];
        at[0] = (struct stepped){0};
        fast_run_begin(t, &p, at, count);
#define PIXEL(k)                                                                                   \
    if (r.z > r.near[k]) {                                                                         \
        r.near[k] = r.z;                                                                           \
        run_put(r.at, k, bits, to.colours, (int)fast_pixel(&u, at, count));                        \
    }                                                                                              \
    r.z += r.dz;                                                                                   \
    fast_step(at, count)
        RUN_EACH(r, bits, PIXEL);
#undef PIXEL
    }
}

void shade_fast_phong(struct shade *s, const struct shade_vertex *a, const struct shade_vertex *b,
                      const struct shade_vertex *c)
{
    struct triangle t;
    if (s->lighting->count == 0) {
        shade_flat(s, s->material->ka * s->lighting->ambient, a, b, c);
        return;
    }
    if (!triangle_begin(&t, s->width, s->height, a, b, c))
        return;
    s->triangles++;
    if (s->bits == 8 && s->lighting->count == 1)
        fast_rows(s, &t, 8, true);
    else if (s->bits == 8)
        fast_rows(s, &t, 8, false);
    else
        fast_rows(s, &t, 32, false);
    s->covered += (uint32_t)t.covered;
}
