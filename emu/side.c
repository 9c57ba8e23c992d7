#include "emu/side.h"

#include <assert.h>
#include <string.h>

static void place(const struct crt_image *part, int x, struct crt_image *out)
{
    int y = (out->height - part->height) / 2;
    for (int row = 0; row < part->height; row++)
        memcpy(out->samples + ((size_t)(y + row) * (size_t)out->width + (size_t)x) * 3,
               part->samples + (size_t)row * (size_t)part->width * 3,
               (size_t)part->width * 3 * sizeof *part->samples);
}

bool vm_side_by_side(const struct crt_image *left, const struct crt_image *right,
                     struct crt_image *out, struct crt_error *err)
{
    assert(left->depth == right->depth);
    int height = left->height > right->height ? left->height : right->height;
    if (!crt_image_init(out, left->width + VM_SIDE_GAP + right->width, height, left->depth, err))
        return false;
    place(left, 0, out);
    place(right, left->width + VM_SIDE_GAP, out);
    return true;
}
