#include "roms/light/illumination.h"

#include "roms/geometry/scalar.h"
#include "roms/light/fresnel.h"
#include "roms/light/power.h"

/* Always: who wants sums only then pays for nothing else. */
#define LIGHT_INLINE static inline __attribute__((always_inline))

struct lighting lighting_dark(float ambient)
{
    return (struct lighting){.ambient = ambient, .a0 = 1, .eye_far = true, .eye = {0, 0, 1}};
}

bool lighting_add(struct lighting *l, struct light light)
{
    if (l->count == LIGHTS_MOST)
        return false;
    if (light.kind == LIGHT_FAR)
        light.at = vector3_direction(light.at);
    l->light[l->count++] = light;
    return true;
}

LIGHT_INLINE float attenuation(const struct lighting *l, float d)
{
    float by = l->a0 + d * (l->a1 + d * l->a2);
    return by > 1 ? 1 / by : 1;
}

/* (R·V) or (N·H), where N·L = `incidence` > 0. */
LIGHT_INLINE float reflection(const struct material *m, struct vector3 n, struct vector3 to,
                              struct vector3 view, float incidence)
{
    if (m->halfway)
        return scalar_max(vector3_dot(n, vector3_direction(vector3_sum(to, view))), 0);
    return scalar_max(2 * incidence * vector3_dot(n, view) - vector3_dot(to, view), 0);
}

/* The normal is of length 1; `distance` 0: the light is at infinity in the direction `to`. */
LIGHT_INLINE struct light_term term(const struct lighting *l, const struct material *m,
                                    struct vector3 n, struct vector3 view, struct vector3 to,
                                    float distance, float intensity)
{
    struct light_term t = {.toward = to, .distance = distance, .attenuation = 1, .w = m->ks};
    if (distance > 0) {
        t.attenuation = attenuation(l, distance);
        intensity *= t.attenuation;
    }
    t.incidence = scalar_max(vector3_dot(n, to), 0);
    if (m->index > 0)
        t.w = fresnel(m->index, t.incidence);
    if (t.incidence <= 0)
        return t;
    t.diffuse = intensity * m->kd * t.incidence;
    t.reflection = reflection(m, n, to, view, t.incidence);
    if (t.reflection > 0)
        t.specular = intensity * t.w * power(t.reflection, m->n);
    return t;
}

/* A light or a sample that is at a place. */
LIGHT_INLINE struct light_term near_term(const struct lighting *l, const struct material *m,
                                         struct vector3 place, struct vector3 n,
                                         struct vector3 view, struct vector3 source,
                                         float intensity)
{
    struct vector3 to = vector3_difference(source, place);
    float distance = vector3_length(to);
    if (distance <= 0)
        return term(l, m, n, view, n, 0, intensity * attenuation(l, 0));
    return term(l, m, n, view, vector3_times(to, 1 / distance), distance, intensity);
}

/* The middle of a part of a source with an extent. */
static struct vector3 sample_at(const struct light *light, int i, int k)
{
    float step = 1 / (float)light->samples;
    struct vector3 at = vector3_times(light->side, ((float)i + 0.5f) * step);
    if (light->kind == LIGHT_RECTANGLE)
        at = vector3_sum(at, vector3_times(light->other, ((float)k + 0.5f) * step));
    return vector3_sum(light->at, at);
}

/* Sums and means over the samples. */
static struct light_term spread_term(const struct lighting *l, const struct material *m,
                                     struct vector3 place, struct vector3 n, struct vector3 view,
                                     const struct light *light)
{
    int rows = light->kind == LIGHT_RECTANGLE ? light->samples : 1;
    float part = 1 / (float)(rows * light->samples);
    struct light_term all = {.w = 0};
    for (int k = 0; k < rows; k++) {
        for (int i = 0; i < light->samples; i++) {
            struct light_term t =
                near_term(l, m, place, n, view, sample_at(light, i, k), light->intensity * part);
            all.toward = vector3_sum(all.toward, t.toward);
            all.distance += t.distance * part;
            all.attenuation += t.attenuation * part;
            all.incidence += t.incidence * part;
            all.reflection += t.reflection * part;
            all.w += t.w * part;
            all.diffuse += t.diffuse;
            all.specular += t.specular;
        }
    }
    all.toward = vector3_direction(all.toward);
    return all;
}

/* The normal and `view` are of length 1. */
LIGHT_INLINE struct light_term light_term(const struct lighting *l, const struct material *m,
                                          struct vector3 place, struct vector3 n,
                                          struct vector3 view, int number)
{
    const struct light *light = &l->light[number];
    switch (light->kind) {
    case LIGHT_FAR:
        return term(l, m, n, view, light->at, 0, light->intensity);
    case LIGHT_NEAR:
        return near_term(l, m, place, n, view, light->at, light->intensity);
    default:
        return spread_term(l, m, place, n, view, light);
    }
}

struct light_term illumination_term(const struct lighting *l, const struct material *m,
                                    struct vector3 place, struct vector3 normal, int light)
{
    return light_term(l, m, place, vector3_direction(normal), lighting_view(l, place), light);
}

struct illumination illuminate(const struct lighting *l, const struct material *m,
                               struct vector3 place, struct vector3 normal)
{
    struct vector3 n = vector3_direction(normal), view = lighting_view(l, place);
    struct illumination sum = {.ambient = m->ka * l->ambient};
    for (int i = 0; i < l->count; i++) {
        struct light_term t = light_term(l, m, place, n, view, i);
        sum.diffuse += t.diffuse;
        sum.specular += t.specular;
    }
    return sum;
}
