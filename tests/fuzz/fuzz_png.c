/* Any bytes as a PNG: never a crash; a picture that is read survives being written and read again.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crt/png_file.h"
#include "tests/support/png_crc.h"

static void require(int holds)
{
    if (!holds)
        abort();
}

/* Large pictures only cost time: width · height of the header, when there is one. */
static int too_large(const uint8_t *data, size_t size)
{
    if (size < 24)
        return 0;
    uint64_t width = 0, height = 0;
    for (int i = 16; i < 20; i++) {
        width = width << 8 | data[i];
        height = height << 8 | data[i + 4];
    }
    return width <= CRT_IMAGE_MAX_SIDE && height <= CRT_IMAGE_MAX_SIDE && width * height > 1 << 18;
}

static void check_round_trip(const struct crt_image *image)
{
    struct crt_image again;
    struct crt_error err;
    char *bytes;
    size_t count;
    FILE *out = open_memstream(&bytes, &count);
    require(out != NULL);
    require(crt_png_write_stream(out, "memory", image, NULL, 0, &err));
    fclose(out);
    FILE *in = fmemopen(bytes, count, "rb");
    require(crt_png_read_stream(in, "memory", &again, &err));
    fclose(in);
    struct crt_image_difference d = crt_image_compare(image, &again, 0);
    require(d.same_shape && d.max_difference == 0);
    crt_image_free(&again);
    free(bytes);
}

static void put_check_sums_right(uint8_t *data, size_t size)
{
    for (size_t at = 8; at + 12 <= size;) {
        size_t length = (size_t)data[at] << 24 | (size_t)data[at + 1] << 16 |
                        (size_t)data[at + 2] << 8 | data[at + 3];
        if (length > size - at - 12)
            return;
        uint32_t crc = png_crc(data + at + 4, length + 4);
        for (int i = 0; i < 4; i++)
            data[at + 8 + length + (size_t)i] = (uint8_t)(crc >> (24 - 8 * i));
        at += 12 + length;
    }
}

static void read_one(uint8_t *data, size_t size)
{
    FILE *in = fmemopen(data, size, "rb");
    if (!in)
        return;
    struct crt_image image;
    struct crt_error err;
    if (crt_png_read_stream(in, "fuzz", &image, &err)) {
        check_round_trip(&image);
        crt_image_free(&image);
    } else {
        require(strncmp(err.text, "fuzz: ", 6) == 0 && image.samples == NULL);
    }
    fclose(in);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size == 0 || too_large(data, size)) /* fmemopen refuses no bytes at all */
        return 0;
    uint8_t *copy = malloc(size);
    require(copy != NULL);
    memcpy(copy, data, size);
    read_one(copy, size);
    put_check_sums_right(copy, size);
    read_one(copy, size);
    free(copy);
    return 0;
}
