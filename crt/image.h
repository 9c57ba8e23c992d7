/* image.h — pictures in memory: RGB samples, 8 or 16 bits each, sRGB-encoded unless said otherwise.
 *
 * Models:     nothing; row 0 is the top.
 * Ownership:  crt_image_init allocates, crt_image_free releases.
 * Errors:     out of memory and impossible sizes give a sentence.
 */
#ifndef CRT_IMAGE_H
#define CRT_IMAGE_H

#include <stdbool.h>
#include <stdint.h>

#include "crt/error.h"

#define CRT_IMAGE_MAX_SIDE 16384

struct crt_image {
    int width, height;
    int depth;         /* 8 or 16 */
    uint16_t *samples; /* width × height × 3, rows from the top; 0…255 or 0…65535 */
};

bool crt_image_init(struct crt_image *image, int width, int height, int depth,
                    struct crt_error *err);
void crt_image_free(struct crt_image *image);

/* SHA-256 over width, height, depth (32-bit big-endian each) and the samples (big-endian,
 * 1 or 2 bytes each), as 64 lower-case hex digits. */
void crt_image_hash(const struct crt_image *image, char hex[65]);

/* How two pictures of one size and depth differ. */
struct crt_image_difference {
    bool same_shape;
    int max_difference; /* in steps of the samples' depth */
    double mean_difference;
    double psnr_db;            /* infinity when equal */
    uint64_t pixels_differing; /* by more than the tolerance in any sample */
    int first_x, first_y;      /* of those, the first in reading order; −1 when none */
};
struct crt_image_difference crt_image_compare(const struct crt_image *a, const struct crt_image *b,
                                              int tolerance);
/* A picture of where they differ: differing pixels bright on a dimmed copy of `a`. */
bool crt_image_difference_picture(const struct crt_image *a, const struct crt_image *b,
                                  int tolerance, struct crt_image *out, struct crt_error *err);

#endif
