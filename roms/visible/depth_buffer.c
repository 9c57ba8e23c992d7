#include "roms/visible/depth_buffer.h"

static void fill(float *at, int count, float value)
{
    for (; count >= 8; count -= 8, at += 8)
        at[0] = at[1] = at[2] = at[3] = at[4] = at[5] = at[6] = at[7] = value;
    while (count-- > 0)
        *at++ = value;
}

void depth_clear(const struct depth_buffer *b, float far)
{
    fill(b->depth, b->width * b->height, far);
}

void depth_clear_part(const struct depth_buffer *b, int x, int y, int width, int height, float far)
{
    int x1 = x + width < b->width ? x + width : b->width;
    int y1 = y + height < b->height ? y + height : b->height;
    x = x > 0 ? x : 0;
    for (y = y > 0 ? y : 0; y < y1; y++)
        fill(b->depth + y * b->width + x, x1 - x, far);
}
