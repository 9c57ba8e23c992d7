#include "emu/side.h"

#include <assert.h>
#include <string.h>

void vm_image_place(const struct crt_image *part, int x, int y, struct crt_image *whole)
{
    size_t width = (size_t)part->width * 3;
    uint16_t scale = whole->depth == 16 && part->depth == 8 ? 257 : 1; /* 255 becomes 65535 */
    assert(part->depth <= whole->depth);
    assert(x >= 0 && y >= 0 && x + part->width <= whole->width &&
           y + part->height <= whole->height);
    for (int row = 0; row < part->height; row++) {
        const uint16_t *from = part->samples + (size_t)row * width;
        uint16_t *to = whole->samples + ((size_t)(y + row) * (size_t)whole->width + (size_t)x) * 3;
        if (scale == 1)
            memcpy(to, from, width * sizeof *to);
        for (size_t i = 0; scale > 1 && i < width; i++)
            to[i] = (uint16_t)(from[i] * scale);
    }
}

bool vm_side_by_side_apart(const struct crt_image *left, const struct crt_image *right, int gap,
                           struct crt_image *out, struct crt_error *err)
{
    assert(left->depth == right->depth);
    int height = left->height > right->height ? left->height : right->height;
    if (!crt_image_init(out, left->width + gap + right->width, height, left->depth, err))
        return false;
    vm_image_place(left, 0, (height - left->height) / 2, out);
    vm_image_place(right, left->width + gap, (height - right->height) / 2, out);
    return true;
}

bool vm_side_by_side(const struct crt_image *left, const struct crt_image *right,
                     struct crt_image *out, struct crt_error *err)
{
    return vm_side_by_side_apart(left, right, VM_SIDE_GAP, out, err);
}

bool vm_above(const struct crt_image *upper, const struct crt_image *lower, struct crt_image *out,
              struct crt_error *err)
{
    int width = upper->width > lower->width ? upper->width : lower->width;
    int depth = upper->depth > lower->depth ? upper->depth : lower->depth;
    if (!crt_image_init(out, width, upper->height + lower->height, depth, err))
        return false;
    vm_image_place(upper, (width - upper->width) / 2, 0, out);
    vm_image_place(lower, (width - lower->width) / 2, upper->height, out);
    return true;
}
