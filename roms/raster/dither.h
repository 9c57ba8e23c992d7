/* dither.h — many intensities from few levels.
 *
 *      ordered:    level = ⌊v·(levels − 1) + threshold⌋,       error diffusion:      ·   X  7/16
 *                  threshold from a matrix that repeats                             3/16 5/16 1/16
 *                  over the picture (Bayer)                     what a pixel could not show goes
 *                                                               to those that come after it
 *
 * Models:     methods by their names; Bayer's matrices of 4 by 4 and 8 by 8, and the weights of Floyd and Steinberg. The
 *             mean over an area is that of the intensities.
 * Cost:       ordered: a look-up and a multiplication, about 13 instructions a pixel; diffusion:
 *             about 38, and a row of errors.
 * Domain:     intensities 0…1 as light (or as anything that the eye adds up); 2…256 levels; rows of
 *             diffusion are done from the top, each from left to right.
 * Units:      levels 0…levels − 1.
 * Ownership:  the row of errors is the caller's.
 * Errors:     none: intensities beyond 0…1 are moved to the end.
 * Source:     B. E. Bayer, An Optimum Method for Two-Level Rendition of Continuous-Tone Pictures,
 *             IEEE International Conference on Communications (1973) 26-11; R. W. Floyd, L.
 *             Steinberg, An Adaptive Algorithm for Spatial Greyscale, Proceedings of the SID 17
 *             (1976) 75.
 * Not modelled: rows in alternating directions; colours that are chosen from a palette.
 */
#ifndef ROMS_RASTER_DITHER_H
#define ROMS_RASTER_DITHER_H

#include <stdint.h>

#include "roms/geometry/scalar.h"

enum dither_method {
    DITHER_NONE,
    DITHER_ORDERED_4,
    DITHER_ORDERED_8,
    DITHER_DIFFUSION,
    DITHER_METHODS
};
/* "none", "ordered-4" ...; ends with NULL. */
extern const char *const dither_names[];

extern const uint8_t dither_bayer_4[4][4]; /* 0…15 */
extern const uint8_t dither_bayer_8[8][8]; /* 0…63 */

/* The level of a pixel by any method but diffusion. DITHER_NONE: the nearest one. */
static inline int dither_ordered(enum dither_method method, int levels, int x, int y,
                                 float intensity)
{
    float threshold = 0.5f;
    if (method == DITHER_ORDERED_4)
        threshold = ((float)dither_bayer_4[y & 3][x & 3] + 0.5f) / 16;
    else if (method == DITHER_ORDERED_8)
        threshold = ((float)dither_bayer_8[y & 7][x & 7] + 0.5f) / 64;
    return (int)(scalar_clamp(intensity, 0, 1) * (float)(levels - 1) + threshold);
}

/* Error diffusion, pixel by pixel. */
struct dither_diffusion {
    float *error; /* what each pixel of the next row gets; width + 2 of them */
    int width, levels;
    int x;            /* the pixel that comes next */
    float here, last; /* what it gets from its left, and what was to go below that */
};

/* `error` has room for width + 2. */
void dither_diffusion_begin(struct dither_diffusion *d, float *error, int width, int levels);

/* The level of the next pixel of the row; after the last one comes the next row's first. */
static inline int dither_diffusion_next(struct dither_diffusion *d, float intensity)
{
    float scale = (float)(d->levels - 1);
    float *at = d->error + 1 + d->x;
    float wanted = scalar_clamp(intensity, 0, 1) * scale + *at + d->here;
    float most = scalar_clamp(wanted, 0, scale);
    int level = (int)(most + 0.5f);
    float error = wanted - (float)level;
    d->here = error * (7.0f / 16);
    at[-1] += error * (3.0f / 16);
    *at = d->last + error * (5.0f / 16);
    d->last = error * (1.0f / 16);
    if (++d->x == d->width) {
        d->x = 0;
        d->here = d->last = 0;
    }
    return level;
}

/* A picture by one of the methods. */
struct dither {
    enum dither_method method;
    int levels;
    struct dither_diffusion diffusion;
};

/* `error` has room for width + 2. */
void dither_begin(struct dither *d, enum dither_method method, int levels, float *error, int width);

/* The level of the next pixel, which is at x, y: row by row from the top, each from the left. */
static inline int dither_next(struct dither *d, int x, int y, float intensity)
{
    return d->method == DITHER_DIFFUSION ? dither_diffusion_next(&d->diffusion, intensity)
                                         : dither_ordered(d->method, d->levels, x, y, intensity);
}

#endif
