/* Lines after Bresenham: the nearest pixel of each column, or row where the line is steep. */
#include <stdlib.h>

#include "roms/raster/canvas.h"

void canvas_line(const struct canvas *c, int x0, int y0, int x1, int y1, uint32_t colour)
{
    int dx = abs(x1 - x0), dy = abs(y1 - y0);
    int step_x = x0 < x1 ? 1 : -1, step_y = y0 < y1 ? 1 : -1;
    int error = dx - dy; /* of the next diagonal step, doubled below */
    for (;;) {
        canvas_dot(c, x0, y0, colour);
        if (x0 == x1 && y0 == y1)
            return;
        int twice = 2 * error;
        if (twice > -dy) {
            error -= dy;
            x0 += step_x;
        }
        if (twice < dx) {
            error += dx;
            y0 += step_y;
        }
    }
}
