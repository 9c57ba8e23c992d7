/* Ellipses row by row: half the length of a row from the square root, and an outline that has no
 * gaps where the ellipse is flat. */
#include <math.h>
#include <stdlib.h>

#include "roms/raster/canvas.h"

int canvas_round_dots(const struct canvas *c, int rows)
{
    return (int)((float)rows * c->dots_a_row + 0.5f);
}

int canvas_chord(int rx, int ry, int dy)
{
    if (abs(dy) > ry)
        return -1;
    /* Half a pixel more than the radius: the ellipse touches the outer edge of its extreme ones. */
    float t = (float)dy / ((float)ry + 0.5f);
    return (int)(((float)rx + 0.5f) * sqrtf(1.0f - t * t));
}

void canvas_disc(const struct canvas *c, int x, int y, int rx, int ry, uint32_t colour)
{
    for (int dy = -ry; dy <= ry; dy++) {
        int half = canvas_chord(rx, ry, dy);
        canvas_fill(c, x - half, y + dy, 2 * half + 1, 1, colour);
    }
}

void canvas_ellipse(const struct canvas *c, int x, int y, int rx, int ry, uint32_t colour)
{
    for (int dy = 0; dy <= ry; dy++) {
        int outer = canvas_chord(rx, ry, dy);
        int inner = canvas_chord(rx, ry, dy + 1) + 1; /* where the next row leaves off */
        if (inner > outer)
            inner = outer;
        int width = outer - inner + 1;
        for (int side = -1; side <= 1; side += 2) {
            canvas_fill(c, x + inner, y + side * dy, width, 1, colour);
            canvas_fill(c, x - outer, y + side * dy, width, 1, colour);
        }
    }
}
