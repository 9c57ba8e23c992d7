/* light_model.h — what the tests of light and shading share: random cases, and the model of
 * illumination in double precision by angles and powers. The sources are compiled in. */
#ifndef TESTS_ROMS_LIGHT_MODEL_H
#define TESTS_ROMS_LIGHT_MODEL_H

#include "roms/geometry/matrix4.c"
#include "roms/light/fast_phong.c"
#include "roms/light/flat.c"
#include "roms/light/fresnel.c"
#include "roms/light/gouraud.c"
#include "roms/light/illumination.c"
#include "roms/light/mesh.c"
#include "roms/light/phong.c"
#include "roms/light/power.c"
#include "roms/light/shade.c"

static struct {
    uint32_t state;
    struct power_table power;
} rig;

static const double pi = 3.14159265358979323846;

static inline double random_unit(void)
{
    rig.state = rig.state * 1664525u + 1013904223u;
    return (rig.state >> 8) / 16777216.0;
}

static inline float between(double low, double high)
{
    return (float)(low + (high - low) * random_unit());
}

static inline struct vector3 random_direction(void)
{
    for (;;) {
        struct vector3 v = {between(-1, 1), between(-1, 1), between(-1, 1)};
        float length = vector3_length(v);
        if (length > 0.1f && length <= 1)
            return vector3_times(v, 1 / length);
    }
}

/* ---- in double precision --------------------------------------------------------------------- */

struct d3 {
    double x, y, z;
};

static inline struct d3 d3(struct vector3 v)
{
    return (struct d3){v.x, v.y, v.z};
}

static inline double dot(struct d3 a, struct d3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline struct d3 unit(struct d3 a)
{
    double k = 1 / sqrt(dot(a, a));
    return (struct d3){a.x * k, a.y * k, a.z * k};
}

static inline struct d3 mix(struct d3 a, struct d3 b, struct d3 c, const double *w)
{
    return (struct d3){a.x * w[0] + b.x * w[1] + c.x * w[2], a.y * w[0] + b.y * w[1] + c.y * w[2],
                       a.z * w[0] + b.z * w[1] + c.z * w[2]};
}

/* Of a point light in the direction L, as the model says it: angles, cosines, powers. */
static inline double model_light(const struct material *m, struct d3 n, struct d3 l, struct d3 v,
                                 double intensity)
{
    double incidence = dot(n, l);
    if (incidence <= 0)
        return 0;
    double w = m->ks;
    if (m->index >
        0) { /* Fresnel's equations by the angles: sin and tan of their difference and sum */
        double in = acos(fmin(incidence, 1)), out = asin(sin(in) / m->index);
        double s = sin(in - out) / sin(in + out), t = tan(in - out) / tan(in + out);
        w = in < 1e-4 ? pow((m->index - 1) / (m->index + 1), 2) : (s * s + t * t) / 2;
    }
    struct d3 r = {2 * incidence * n.x - l.x, 2 * incidence * n.y - l.y, 2 * incidence * n.z - l.z};
    struct d3 h = unit((struct d3){l.x + v.x, l.y + v.y, l.z + v.z});
    double c = m->halfway ? dot(n, h) : dot(r, v);
    return intensity * (m->kd * incidence + (c > 0 ? w * pow(c, m->n) : 0));
}

static inline double model(const struct lighting *g, const struct material *m, struct d3 place,
                           struct d3 n)
{
    struct d3 v = d3(g->eye);
    if (!g->eye_far)
        v = unit((struct d3){g->eye.x - place.x, g->eye.y - place.y, g->eye.z - place.z});
    double sum = m->ka * g->ambient;
    n = unit(n);
    for (int i = 0; i < g->count; i++) {
        const struct light *s = &g->light[i];
        if (s->kind == LIGHT_FAR) {
            sum += model_light(m, n, unit(d3(s->at)), v, s->intensity);
            continue;
        }
        int across = s->kind == LIGHT_NEAR ? 1 : s->samples;
        int down = s->kind == LIGHT_RECTANGLE ? s->samples : 1;
        for (int k = 0; k < across * down; k++) {
            double p = 0, q = 0;
            if (s->kind != LIGHT_NEAR)
                p = (k % across + 0.5) / across;
            if (s->kind == LIGHT_RECTANGLE)
                q = (k / across + 0.5) / down;
            struct d3 to = {s->at.x + p * s->side.x + q * s->other.x - place.x,
                            s->at.y + p * s->side.y + q * s->other.y - place.y,
                            s->at.z + p * s->side.z + q * s->other.z - place.z};
            double d = sqrt(dot(to, to));
            double f = fmin(1, 1 / (g->a0 + g->a1 * d + g->a2 * d * d));
            sum += model_light(m, n, unit(to), v, s->intensity * f / (across * down));
        }
    }
    return sum;
}

static inline struct material random_material(void)
{
    return (struct material){between(0, 1),
                             between(0, 1),
                             between(0, 1),
                             (float)(int)between(1, 60),
                             random_unit() < 0.3 ? between(1.1, 3) : 0,
                             random_unit() < 0.5};
}

static inline struct light random_light(enum light_kind kind)
{
    struct light s = {
        .kind = kind, .intensity = between(0.2, 1), .samples = 1 + (int)between(0, 5)};
    s.at = vector3_times(random_direction(), between(2, 8));
    s.side = vector3_times(random_direction(), between(0.1, 1));
    s.other = vector3_times(random_direction(), between(0.1, 1));
    return s;
}

static const struct material plain = {0.3f, 0.5f, 0.2f, 12, 0, false};

static inline struct shade_vertex random_vertex(float low, float high)
{
    struct shade_vertex v = {.x = between(low, high), .y = between(low, high), .z = between(0, 1)};
    v.place = (struct vector3){v.x / 40, v.y / 40, v.z};
    v.intensity = between(0, 1);
    return v;
}

/* Normals within `spread` of each other, facing the viewer. */
static inline void spread_normals(struct shade_vertex *v, double spread)
{
    struct vector3 middle = random_direction();
    middle.z = fabsf(middle.z) + 0.3f;
    for (int k = 0; k < 3; k++)
        v[k].normal = vector3_direction(vector3_sum(
            vector3_direction(middle), vector3_times(random_direction(), (float)(spread / 2))));
}

static inline double area_of(const struct shade_vertex *v)
{
    return fabs((v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[2].x - v[0].x) * (v[1].y - v[0].y)) / 2;
}

static inline double angle(struct vector3 a, struct vector3 b)
{
    return acos(fmin(1, dot(unit(d3(a)), unit(d3(b)))));
}

#endif
