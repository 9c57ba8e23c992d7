/* run.h — what the inner loops of all shadings share: the present run's pixels and depths.
 *
 * Models:     addresses, and stores of either format. The loops keep what they need in values of
 *             their own: a store of a byte might change anything else.
 * Ownership:  into the canvas and the depth buffer of a struct shade.
 * Errors:     none; for the shadings' own use.
 */
#ifndef ROMS_LIGHT_RUN_H
#define ROMS_LIGHT_RUN_H

#include "roms/light/shade.h"

/* A function whose parameters are constants where it is called: a loop for each of them. */
#define RUN_LOOP static inline __attribute__((always_inline))

struct run_target {
    uint8_t *pixels;
    float *depth;
    uint32_t pitch;
    int width;
    const uint32_t *colours;
};

struct run {
    uint8_t *at;      /* its first pixel */
    float *near;      /* and the depth there */
    const float *end; /* the first that is not in it */
    int count;
    float z, dz;
};

RUN_LOOP struct run_target run_target(const struct shade *s)
{
    return (struct run_target){s->pixels, s->depth, s->pitch, s->width, s->colours};
}

RUN_LOOP struct run run_of(const struct run_target *to, const struct triangle *t,
                           const struct gradient *z, unsigned bits)
{
    uint8_t *at = to->pixels + (uint32_t)t->y * to->pitch + (uint32_t)t->x0 * (bits / 8);
    float *near = to->depth + t->y * to->width + t->x0;
    int count = t->x1 - t->x0;
    return (struct run){at, near, near + count, count, triangle_value(t, z), z->dx};
}

/* `value` as shade_pixel makes it. */
RUN_LOOP void run_put(uint8_t *at, int k, unsigned bits, const uint32_t *colours, int value)
{
    if (bits == 8)
        at[k] = (uint8_t)value;
    else
        ((uint32_t *)(void *)at)[k] = colours[value];
}

/* Carries out PIXEL(k) for each pixel of the run, four without a step of addresses between. */
#define RUN_EACH(run, bits, PIXEL)                                                                 \
    do {                                                                                           \
        if ((run).count & 1) {                                                                     \
            PIXEL(0);                                                                              \
            (run).at += (bits) / 8;                                                                \
            (run).near += 1;                                                                       \
        }                                                                                          \
        if ((run).count & 2) {                                                                     \
            PIXEL(0);                                                                              \
            PIXEL(1);                                                                              \
            (run).at += 2 * (bits) / 8;                                                            \
            (run).near += 2;                                                                       \
        }                                                                                          \
        while ((run).near != (run).end) {                                                          \
            PIXEL(0);                                                                              \
            PIXEL(1);                                                                              \
            PIXEL(2);                                                                              \
            PIXEL(3);                                                                              \
            (run).at += 4 * (bits) / 8;                                                            \
            (run).near += 4;                                                                       \
        }                                                                                          \
    } while (0)

#endif
