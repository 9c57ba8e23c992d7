#include "roms/visible/depth_buffer.h"

#include "roms/raster/fill_run.h"

void depth_clear(const struct depth_buffer *b, float far)
{
    fill_run_floats(b->depth, b->depth + b->width * b->height, far);
}

void depth_clear_part(const struct depth_buffer *b, int x, int y, int width, int height, float far)
{
    int x1 = x + width < b->width ? x + width : b->width;
    int y1 = y + height < b->height ? y + height : b->height;
    x = x > 0 ? x : 0;
    for (y = y > 0 ? y : 0; y < y1; y++) {
        float *row = b->depth + y * b->width;
        fill_run_floats(row + x, row + x1, far);
    }
}
