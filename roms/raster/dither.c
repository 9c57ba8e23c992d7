#include "roms/raster/dither.h"

#include <stddef.h>

const char *const dither_names[] = {"none", "ordered-4", "ordered-8", "diffusion", NULL};

/* D(2n) is four of 4 D(n), to which 0 2 / 3 1 is added. */
const uint8_t dither_bayer_4[4][4] = {
    {0, 8, 2, 10},
    {12, 4, 14, 6},
    {3, 11, 1, 9},
    {15, 7, 13, 5},
};

const uint8_t dither_bayer_8[8][8] = {
    {0, 32, 8, 40, 2, 34, 10, 42},  {48, 16, 56, 24, 50, 18, 58, 26},
    {12, 44, 4, 36, 14, 46, 6, 38}, {60, 28, 52, 20, 62, 30, 54, 22},
    {3, 35, 11, 43, 1, 33, 9, 41},  {51, 19, 59, 27, 49, 17, 57, 25},
    {15, 47, 7, 39, 13, 45, 5, 37}, {63, 31, 55, 23, 61, 29, 53, 21},
};

void dither_diffusion_begin(struct dither_diffusion *d, float *error, int width, int levels)
{
    *d = (struct dither_diffusion){.error = error, .width = width, .levels = levels};
    for (int i = 0; i < width + 2; i++)
        error[i] = 0;
}

void dither_begin(struct dither *d, enum dither_method method, int levels, float *error, int width)
{
    d->method = method;
    d->levels = levels;
    dither_diffusion_begin(&d->diffusion, error, width, levels);
}
