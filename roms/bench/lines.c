/* lines — 200 000 lines between random places into a raster of bytes: whole numbers only.
 *
 * Bresenham's method with one decision a dot (J. E. Bresenham, "Algorithm for computer control of a
 * digital plotter", IBM Systems Journal 4, 1965), all octants, both end points drawn.
 */
#include "roms/bench/kernel.h"

enum { SIZE = 512, LINES = 200000 };

const char kernel_name[] = "lines";

static uint8_t raster[SIZE * SIZE];

/* `along` and `across`: what a step adds to the address in each direction. */
static void walk(uint8_t *at, int long_way, int short_way, int along, int across, uint8_t colour)
{
    int decision = 2 * short_way - long_way;
    int straight = 2 * short_way, diagonal = 2 * (short_way - long_way);
    for (int left = long_way; left >= 0; left--) {
        *at = colour;
        at += along;
        if (decision > 0) {
            at += across;
            decision += diagonal;
        } else {
            decision += straight;
        }
    }
}

static void line(int x0, int y0, int x1, int y1, uint8_t colour)
{
    int dx = x1 - x0, dy = y1 - y0, step_x = 1, step_y = SIZE;
    uint8_t *at = &raster[y0 * SIZE + x0];
    if (dx < 0) {
        dx = -dx;
        step_x = -1;
    }
    if (dy < 0) {
        dy = -dy;
        step_y = -SIZE;
    }
    if (dx >= dy)
        walk(at, dx, dy, step_x, step_y, colour);
    else
        walk(at, dy, dx, step_y, step_x, colour);
}

uint32_t kernel_run(void)
{
    uint32_t state = 12345, sum = KERNEL_SUM_START;
    for (int i = 0; i < LINES; i++) {
        /* A linear congruential generator; its high bits are the good ones. */
        state = state * 1664525u + 1013904223u;
        int x0 = (int)(state >> 23), y0 = (int)(state >> 14 & 511);
        state = state * 1664525u + 1013904223u;
        int x1 = (int)(state >> 23), y1 = (int)(state >> 14 & 511);
        line(x0, y0, x1, y1, (uint8_t)i);
    }
    for (int i = 0; i < SIZE * SIZE; i++)
        sum = kernel_sum(sum, raster[i]);
    return sum;
}
