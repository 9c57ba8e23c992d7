#include "emu/y4m.h"

#include <assert.h>
#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

static bool trouble(const struct vm_y4m *y, struct crt_error *err)
{
    return crt_fail(err, "%.300s cannot be written: %s", y->out.path, strerror(errno));
}

bool vm_y4m_open(struct vm_y4m *y, const char *path, int width, int height, struct crt_rate fps,
                 struct crt_error *err)
{
    *y = (struct vm_y4m){.width = width + width % 2, .height = height + height % 2};
    signal(SIGPIPE, SIG_IGN);
    if (!vm_out_open(&y->out, path, err))
        return false;
    y->file = y->out.file;
    size_t pixels = (size_t)y->width * (size_t)y->height;
    y->planes = malloc(pixels * 3);
    if (!y->planes)
        return crt_fail(err, "not enough memory for a frame of %dx%d", width, height);
    memset(y->planes, 16, pixels); /* black, also beyond the picture */
    memset(y->planes + pixels, 128, 2 * pixels);
    fprintf(y->file, "YUV4MPEG2 W%d H%d F%llu:%llu Ip A1:1 C444 XCOLORRANGE=LIMITED\n", y->width,
            y->height, (unsigned long long)fps.num, (unsigned long long)fps.den);
    return !ferror(y->file) || trouble(y, err);
}

/* Integer BT.709 with 16 bits of fraction; Kr 0.2126, Kb 0.0722. */
static void convert(const uint16_t *rgb, size_t pixels, uint8_t *luma, uint8_t *cb, uint8_t *cr)
{
    for (size_t i = 0; i < pixels; i++, rgb += 3) {
        int r = rgb[0], g = rgb[1], b = rgb[2];
        luma[i] = (uint8_t)((11966 * r + 40254 * g + 4064 * b + (16 << 16) + 32768) >> 16);
        cb[i] = (uint8_t)((-6596 * r - 22189 * g + 28785 * b + (128 << 16) + 32768) >> 16);
        cr[i] = (uint8_t)((28785 * r - 26145 * g - 2640 * b + (128 << 16) + 32768) >> 16);
    }
}

bool vm_y4m_frame(struct vm_y4m *y, const struct crt_image *image, struct crt_error *err)
{
    size_t pixels = (size_t)y->width * (size_t)y->height;
    assert(image->depth == 8 && image->width <= y->width && image->height <= y->height);
    for (int row = 0; row < image->height; row++) {
        const uint16_t *rgb = image->samples + (size_t)row * (size_t)image->width * 3;
        uint8_t *luma = y->planes + (size_t)row * (size_t)y->width;
        convert(rgb, (size_t)image->width, luma, luma + pixels, luma + 2 * pixels);
    }
    if (fputs("FRAME\n", y->file) == EOF || fwrite(y->planes, 3, pixels, y->file) != pixels)
        return trouble(y, err);
    return true;
}

bool vm_y4m_close(struct vm_y4m *y, bool keep, struct crt_error *err)
{
    bool ok = vm_out_close(&y->out, keep, err);
    free(y->planes);
    *y = (struct vm_y4m){0};
    return ok;
}
