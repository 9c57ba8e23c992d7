/* The mask as the glass shows it: one period of its pattern, filtered for the size of a pixel. */
#include <math.h>
#include <stdlib.h>

#include "crt/glass_private.h"

/* Sides of the table: multiples of 6, so that the patterns of the colours, a third of the period
 * apart (a sixth of two columns), are the same texels. */
#define LEAST_SIDE 192
#define MOST_SIDE  768

void crt_glass_pattern_period(const struct crt_mask *mask, double *width_mm, double *height_mm)
{
    switch (mask->kind) {
    case CRT_MASK_NONE:
        *width_mm = *height_mm = 1;
        return;
    case CRT_MASK_DELTA:
        *width_mm = mask->pitch * 1.73205080756887729;
        *height_mm = mask->pitch;
        return;
    case CRT_MASK_SLOT:
        *width_mm = 2 * mask->pitch;
        *height_mm = mask->slot_pitch;
        return;
    case CRT_MASK_GRILLE:
        *width_mm = *height_mm = mask->pitch; /* upright nothing changes */
    }
}

double crt_glass_mask_depth(const struct crt_mask *mask, double pixel_mm)
{
    double shortest =
        mask->kind == CRT_MASK_DELTA ? mask->pitch * 0.86602540378443865 : mask->pitch;
    double t = fmin(fmax(shortest / pixel_mm - 2, 0), 1);
    return t * t * (3 - 2 * t);
}

/* Some 30 texels a pixel at the scale where the mask begins to show, and 12 or more beyond, until the
 * pixels are a hundredth of the period. */
static int side_for(double period_mm, double pixel_mm)
{
    int side = LEAST_SIDE;
    while (side < MOST_SIDE && side * pixel_mm < 12 * period_mm)
        side *= 2;
    return side;
}

/* Colour 1 is worked out; the others are the same, moved by whole texels. */
static void fill(const struct crt_mask *mask, double w, double h, double pixel_mm, int side,
                 float *rgba)
{
    size_t n = (size_t)side;
    int shift_x[3], shift_y[3];
    for (int c = 0; c < 3; c++) {
        shift_x[c] = (int)floor((mask->way_x[c] - mask->way_x[1]) / w * side + 0.5);
        shift_y[c] = (int)floor((mask->way_y[1] - mask->way_y[c]) / h * side + 0.5);
    }
    for (int y = 0; y < side; y++)
        for (int x = 0; x < side; x++) {
            double share =
                crt_mask_cover(mask, 1, 1, (x + 0.5) * w / side, -(y + 0.5) * h / side, pixel_mm) /
                mask->transmission;
            for (int c = 0; c < 3; c++) {
                size_t to_x = (size_t)((x + shift_x[c] + side) % side);
                size_t to_y = (size_t)((y + shift_y[c] + side) % side);
                rgba[(to_y * n + to_x) * 4 + (size_t)c] = (float)share;
            }
        }
}

static bool same_pattern(const struct crt_mask *a, const struct crt_mask *b)
{
    return a->kind == b->kind && a->pitch == b->pitch && a->transmission == b->transmission &&
           a->hole == b->hole;
}

bool crt_glass_upload_pattern(struct crt_glass *glass, const struct crt_mask *mask, double pixel_mm)
{
    if (glass->mask_pixel == pixel_mm && same_pattern(&glass->mask, mask))
        return true;
    double w, h;
    crt_glass_pattern_period(mask, &w, &h);
    int side = side_for(fmax(w, h), pixel_mm);
    float *rgba = calloc((size_t)side * (size_t)side * 4, sizeof *rgba);
    if (!rgba)
        return crt_fail(&glass->trouble, "out of memory for the mask's pattern");
    struct crt_mask even = *mask; /* film has the wrong landing, the shader the wires */
    even.optics.landing = even.optics.landing_edge = 0;
    even.wire = 0;
    fill(&even, w, h, pixel_mm, side, rgba);
    crt_glass_texture_resize(glass, &glass->pattern, GL_RGBA32F, side, side, GL_LINEAR);
    glass->gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glass->gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    glass->gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, side, side, GL_RGBA, GL_FLOAT, rgba);
    free(rgba);
    glass->mask = *mask;
    glass->mask_pixel = pixel_mm;
    return true;
}
