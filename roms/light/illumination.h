/* illumination.h — the intensity of the light that a point of a surface sends to the eye.
 *
 *        L   N   R                 N  the surface's normal
 *         ╲θ │ θ╱   V              L  toward the light
 *          ╲ │ ╱ φ ╱               R  = 2 (N·L) N − L, the direction of ideal reflection
 *           ╲│╱ ╱                  V  toward the eye
 *      ──────●──────               H  = (L + V) / |L + V|, half-way
 *
 *      I = ka Ia + Σ f(d) Il [ kd (N·L) + w (R·V)^n ]      w = ks, or w(θ) by Fresnel
 *
 * Models:     ambient light; diffuse reflection by Lambert's law; specular reflection by Phong's
 *             model, or with (N·H)^n by Blinn's; lights at infinity, at a place, along a line and
 *             on a rectangle (as samples at the middles of equal parts, so that nothing is left to
 *             chance); attenuation f(d) = min(1, 1/(a0 + a1 d + a2 d²)) of lights that are at a
 *             place.
 * Cost:       about 60 operations a light at infinity, 80 a light at a place and 80 a sample; the
 *             power (power.h) where a highlight is.
 * Domain:     LIGHTS_MOST lights of at most LIGHT_SAMPLES by LIGHT_SAMPLES samples. N·L, R·V and
 *             N·H below 0 count as 0, and there is no highlight where N·L is: the light is behind
 *             the surface.
 * Units:      intensities: 1 is what a screen shows as white; lengths the caller's; N need not be
 *             of length 1: it is made so.
 * Ownership:  plain values.
 * Errors:     none: a light in the very point lights it along the normal.
 * Source:     J. H. Lambert, Photometria (1760); Bui Tuong Phong, CACM 18 (1975) 311; J. F. Blinn,
 *             Computer Graphics 11 (1977) 192; C. P. Verbeck, D. P. Greenberg, IEEE Computer
 *             Graphics and Applications 4, 7 (1984) 66, for sources with an extent.
 * Not modelled: shadows, colour of light, light from one surface to another.
 */
#ifndef ROMS_LIGHT_ILLUMINATION_H
#define ROMS_LIGHT_ILLUMINATION_H

#include <stdbool.h>

#include "roms/geometry/vector.h"

enum { LIGHTS_MOST = 8, LIGHT_SAMPLES = 16 };

enum light_kind { LIGHT_FAR, LIGHT_NEAR, LIGHT_LINE, LIGHT_RECTANGLE, LIGHT_KINDS };

struct light {
    enum light_kind kind;
    struct vector3 at;          /* FAR: toward it; NEAR: its place; else a corner or end */
    struct vector3 side, other; /* from there to the next corners: LINE takes `side` only */
    int samples;                /* along each side */
    float intensity;            /* of all samples together */
};

struct lighting {
    float ambient; /* Ia */
    struct light light[LIGHTS_MOST];
    int count;
    float a0, a1, a2; /* attenuation */
    bool eye_far;     /* the eye is at infinity: `eye` is the direction toward it, of length 1 */
    struct vector3 eye;
};

struct material {
    float ka, kd, ks, n;
    float index;  /* of refraction, for w(θ); 0: w is ks */
    bool halfway; /* (N·H)^n instead of (R·V)^n */
};

/* What one light, or one sample of it, adds. */
struct light_term {
    struct vector3 toward;   /* L, of length 1 */
    float distance;          /* 0: at infinity */
    float attenuation;       /* f(d) */
    float incidence;         /* N·L, not below 0 */
    float reflection;        /* R·V or N·H, not below 0; 0 where N·L is */
    float w;                 /* ks or w(θ) */
    float diffuse, specular; /* intensities */
};

struct illumination {
    float ambient, diffuse, specular;
};

/* No light but this ambient one, no attenuation; the eye at infinity on the z axis. */
struct lighting lighting_dark(float ambient);
/* Adds a light; false: there is no room. A light at infinity is given by any vector toward it. */
bool lighting_add(struct lighting *lighting, struct light light);

/* The term of a light, of lighting->count, at a place with this normal. */
struct light_term illumination_term(const struct lighting *lighting,
                                    const struct material *material, struct vector3 place,
                                    struct vector3 normal, int light);
/* All of them. */
struct illumination illuminate(const struct lighting *lighting, const struct material *material,
                               struct vector3 place, struct vector3 normal);

static inline float illumination_sum(struct illumination i)
{
    return i.ambient + i.diffuse + i.specular;
}

/* Toward the eye, of length 1. */
static inline struct vector3 lighting_view(const struct lighting *l, struct vector3 place)
{
    return l->eye_far ? l->eye : vector3_direction(vector3_difference(l->eye, place));
}

#endif
