/* bytes.h — what the programs of the cross-compiled comparison share: a file in, a picture's bytes out. */
#ifndef TESTS_CROSS_BYTES_H
#define TESTS_CROSS_BYTES_H

#include <stdio.h>
#include <stdlib.h>

#include "crt/image.h"

static inline int die(const char *sentence)
{
    fprintf(stderr, "%s\n", sentence);
    return 1;
}

static inline char *slurp(const char *path, size_t *length)
{
    const size_t most = 1u << 22;
    FILE *in = fopen(path, "rb");
    char *bytes = malloc(most);
    if (in == NULL || bytes == NULL)
        return NULL;
    *length = fread(bytes, 1, most, in);
    fclose(in);
    return bytes;
}

/* What SHA-256 is taken of: width, height, depth, big-endian samples of 16 bits. */
static inline bool put_image(const struct crt_image *image)
{
    const unsigned head[] = {(unsigned)image->width, (unsigned)image->height, 16};
    for (int i = 0; i < 3; i++)
        for (int shift = 24; shift >= 0; shift -= 8)
            putchar((int)(head[i] >> shift & 255));
    const size_t samples = (size_t)image->width * (size_t)image->height * 3;
    for (size_t i = 0; i < samples; i++) {
        putchar(image->samples[i] >> 8);
        putchar(image->samples[i] & 255);
    }
    return fflush(stdout) == 0;
}

#endif
