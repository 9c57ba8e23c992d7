#include "crt/image.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

#include "crt/maths.h"

bool crt_image_init(struct crt_image *image, int width, int height, int depth,
                    struct crt_error *err)
{
    assert(depth == 8 || depth == 16);
    *image = (struct crt_image){0};
    if (width < 1 || height < 1 || width > CRT_IMAGE_MAX_SIDE || height > CRT_IMAGE_MAX_SIDE)
        return crt_fail(err, "a picture of %d by %d pixels is impossible; each side may be 1 to %d",
                        width, height, CRT_IMAGE_MAX_SIDE);
    uint16_t *samples = calloc((size_t)width * (size_t)height, 3 * sizeof *samples);
    if (!samples)
        return crt_fail(err,
                        "not enough memory for a picture of %d by %d pixels; choose a smaller one",
                        width, height);
    *image = (struct crt_image){width, height, depth, samples};
    return true;
}

void crt_image_free(struct crt_image *image)
{
    free(image->samples);
    *image = (struct crt_image){0};
}

static size_t sample_count(const struct crt_image *image)
{
    return (size_t)image->width * (size_t)image->height * 3;
}

static bool same_shape(const struct crt_image *a, const struct crt_image *b)
{
    return a->width == b->width && a->height == b->height && a->depth == b->depth;
}

/* The greatest difference of a pixel's samples. */
static int pixel_difference(const struct crt_image *a, const struct crt_image *b, size_t pixel)
{
    int most = 0;
    for (size_t i = 3 * pixel; i < 3 * pixel + 3; i++) {
        int d = abs((int)a->samples[i] - (int)b->samples[i]);
        most = d > most ? d : most;
    }
    return most;
}

struct crt_image_difference crt_image_compare(const struct crt_image *a, const struct crt_image *b,
                                              int tolerance)
{
    struct crt_image_difference r = {.first_x = -1, .first_y = -1};
    r.same_shape = same_shape(a, b);
    if (!r.same_shape)
        return r;
    size_t pixels = (size_t)a->width * (size_t)a->height;
    uint64_t sum = 0, squares = 0; /* at most 2^30 samples of 2^16 steps: 2^62 */
    for (size_t p = 0; p < pixels; p++) {
        for (size_t i = 3 * p; i < 3 * p + 3; i++) {
            uint64_t d = (uint64_t)abs((int)a->samples[i] - (int)b->samples[i]);
            sum += d;
            squares += d * d;
        }
        int most = pixel_difference(a, b, p);
        r.max_difference = most > r.max_difference ? most : r.max_difference;
        if (most > tolerance && r.pixels_differing++ == 0) {
            r.first_x = (int)(p % (size_t)a->width);
            r.first_y = (int)(p / (size_t)a->width);
        }
    }
    double count = (double)sample_count(a), max = a->depth == 8 ? 255.0 : 65535.0;
    r.mean_difference = (double)sum / count;
    r.psnr_db = (double)INFINITY;
    if (squares > 0)
        r.psnr_db = 10.0 * crt_log(max * max * count / (double)squares) / crt_log(10.0);
    return r;
}

bool crt_image_difference_picture(const struct crt_image *a, const struct crt_image *b,
                                  int tolerance, struct crt_image *out, struct crt_error *err)
{
    if (!same_shape(a, b))
        return crt_fail(err,
                        "a picture of %d by %d pixels, %d bits, cannot be compared with one of "
                        "%d by %d, %d bits; capture both with the same --size and --depth",
                        a->width, a->height, a->depth, b->width, b->height, b->depth);
    if (!crt_image_init(out, a->width, a->height, a->depth, err))
        return false;
    uint16_t max = a->depth == 8 ? 255 : 65535;
    size_t pixels = (size_t)a->width * (size_t)a->height;
    for (size_t p = 0; p < pixels; p++) {
        bool differs = pixel_difference(a, b, p) > tolerance;
        /* Magenta: no phosphor looks like it. */
        const uint16_t mark[3] = {max, 0, max};
        for (size_t i = 0; i < 3; i++)
            out->samples[3 * p + i] = differs ? mark[i] : (uint16_t)(a->samples[3 * p + i] / 4);
    }
    return true;
}
