/* run.h — what the inner loops of all shadings share: the present run's pixels and depths.
 *
 * Models:     addresses, and stores of either format.
 * Ownership:  into the canvas and the depth buffer of a struct shade.
 * Errors:     none; for the shadings' own use.
 */
#ifndef ROMS_LIGHT_RUN_H
#define ROMS_LIGHT_RUN_H

#include "roms/light/shade.h"

/* A function whose parameters are constants where it is called: a loop for each of them. */
#define RUN_LOOP static inline __attribute__((always_inline))

struct run {
    uint8_t *at; /* its first pixel */
    float *near; /* and the depth there */
    int count;
    float z, dz;
};

RUN_LOOP struct run run_of(const struct shade *s, const struct triangle *t, const struct plane *z,
                           unsigned bits)
{
    return (struct run){s->pixels + (uint32_t)t->y * s->pitch + (uint32_t)t->x0 * (bits / 8),
                        s->depth + t->y * s->width + t->x0, t->x1 - t->x0, triangle_value(t, z),
                        z->dx};
}

/* `value` as shade_pixel makes it. */
RUN_LOOP void run_put(uint8_t *at, int k, unsigned bits, const uint32_t *colours, int value)
{
    if (bits == 8)
        at[k] = (uint8_t)value;
    else
        ((uint32_t *)(void *)at)[k] = colours[value];
}

/* Carries out PIXEL(k) for each pixel of the run, four without a step between. */
#define RUN_EACH(run, bits, PIXEL)                                                                 \
    do {                                                                                           \
        for (; (run).count >= 4; (run).count -= 4) {                                               \
            PIXEL(0);                                                                              \
            PIXEL(1);                                                                              \
            PIXEL(2);                                                                              \
            PIXEL(3);                                                                              \
            (run).at += 4 * (bits) / 8;                                                            \
            (run).near += 4;                                                                       \
        }                                                                                          \
        for (; (run).count > 0; (run).count--) {                                                   \
            PIXEL(0);                                                                              \
            (run).at += (bits) / 8;                                                                \
            (run).near++;                                                                          \
        }                                                                                          \
    } while (0)

#endif
