/* check_lines — lines, circles and ellipses in the machine: 10000 random cases of each property, in
 * whole numbers. Prints a line a property; exit status 1 when one does not hold. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "roms/raster/circle_midpoint.h"
#include "roms/raster/circle_midpoint_side.h"
#include "roms/raster/ellipse_midpoint.h"
#include "roms/raster/line_bresenham.h"
#include "roms/raster/line_dda.h"
#include "roms/raster/line_dda_integer.h"

enum { CASES = 10000, FAR = 24, MOST = 2 * FAR + 1, SIDE = 20 };

struct place {
    int x, y;
};

struct line {
    int x0, y0, x1, y1;
};

static uint32_t seed = 20261126;

static int within(int low, int high)
{
    seed = seed * 1664525u + 1013904223u;
    return low + (int)((uint64_t)seed * (uint64_t)(high - low + 1) >> 32);
}

static struct line random_line(void)
{
    struct line l = {within(-FAR, FAR), within(-FAR, FAR), 0, 0};
    l.x1 = within(-FAR, FAR);
    l.y1 = within(-FAR, FAR);
    return l;
}

static int longer(struct line l)
{
    int dx = abs(l.x1 - l.x0), dy = abs(l.y1 - l.y0);
    return dx > dy ? dx : dy;
}

/* Twice the distance along the shorter axis, times the longer one. */
static int off(struct line l, int x, int y)
{
    return 2 * abs((l.x1 - l.x0) * (y - l.y0) - (l.y1 - l.y0) * (x - l.x0));
}

static int bresenham(struct line line, struct place *out)
{
    struct line_bresenham l;
    int count = 0;
    line_bresenham_begin(&l, line.x0, line.y0, line.x1, line.y1);
    while (count < MOST && line_bresenham_next(&l))
        out[count++] = (struct place){l.x, l.y};
    return count;
}

/* Both ends, longer + 1 pixels, each next to the one before. */
static bool connected(struct line l, const struct place *p, int count)
{
    if (count != longer(l) + 1 || p[0].x != l.x0 || p[0].y != l.y0 || p[count - 1].x != l.x1 ||
        p[count - 1].y != l.y1)
        return false;
    for (int i = 1; i < count; i++)
        if (abs(p[i].x - p[i - 1].x) > 1 || abs(p[i].y - p[i - 1].y) > 1)
            return false;
    return true;
}

/* ---- properties of one random case ----------------------------------------------------------- */

static bool nearest(void)
{
    static struct place p[MOST];
    struct line l = random_line();
    int count = bresenham(l, p);
    for (int i = 0; i < count; i++)
        if (off(l, p[i].x, p[i].y) > longer(l))
            return false;
    return connected(l, p, count);
}

static bool symmetric(void)
{
    static struct place there[MOST], back[MOST];
    struct line l = random_line();
    int count = bresenham(l, there);
    if (bresenham((struct line){l.x1, l.y1, l.x0, l.y0}, back) != count)
        return false;
    for (int i = 0; i < count; i++)
        if (there[i].x != back[count - 1 - i].x || there[i].y != back[count - 1 - i].y)
            return false;
    return true;
}

/* The canvas lies in the middle of where lines go: most are cut. */
static bool cut(void)
{
    static struct place p[MOST];
    static uint8_t pixels[SIDE * SIDE];
    struct canvas c = {pixels, SIDE, SIDE, SIDE, 8, 1};
    struct line l = random_line();
    int count = bresenham(l, p);
    canvas_line(&c, l.x0, l.y0, l.x1, l.y1, 1);
    for (int i = 0; i < count; i++)
        if (p[i].x >= 0 && p[i].y >= 0 && p[i].x < SIDE && p[i].y < SIDE) {
            uint8_t *at = &pixels[p[i].y * SIDE + p[i].x];
            if (*at != 1)
                return false;
            *at = 0;
        }
    for (int i = 0; i < SIDE * SIDE; i += 4)
        if (*(uint32_t *)(void *)&pixels[i] != 0)
            return false;
    return true;
}

static bool dda(void)
{
    static struct place p[MOST];
    struct line line = random_line();
    struct line_dda l;
    int count = 0;
    line_dda_begin(&l, line.x0, line.y0, line.x1, line.y1);
    while (count < MOST && line_dda_next(&l)) {
        /* What floats may lose is less than the least distance that is not a half. */
        if (off(line, l.plot_x, l.plot_y) > longer(line))
            return false;
        p[count++] = (struct place){l.plot_x, l.plot_y};
    }
    return connected(line, p, count);
}

static bool dda_integer(void)
{
    static struct place p[MOST];
    struct line line = random_line();
    struct line_dda_integer l;
    int count = 0;
    line_dda_integer_begin(&l, line.x0, line.y0, line.x1, line.y1, LINE_FRACTION_BITS);
    while (count < MOST && line_dda_integer_next(&l)) {
        if (off(line, l.plot_x, l.plot_y) > longer(line))
            return false;
        p[count++] = (struct place){l.plot_x, l.plot_y};
    }
    return connected(line, p, count);
}

/* y is the whole number nearest to sqrt(r² − x²), and the octant from the side is its image. */
static bool circle(void)
{
    struct circle_midpoint c;
    struct circle_midpoint_side s;
    int r = within(0, 60);
    circle_midpoint_begin(&c, r);
    circle_midpoint_side_begin(&s, r);
    while (circle_midpoint_next(&c)) {
        int square = 4 * (r * r - c.x * c.x), y = 2 * c.y;
        if (!circle_midpoint_side_next(&s) || s.x != c.y || s.y != c.x)
            return false;
        if (c.x <= c.y && ((y + 1) * (y + 1) <= square || (y > 0 && (y - 1) * (y - 1) >= square)))
            return false;
    }
    return !circle_midpoint_side_next(&s) && c.x >= c.y;
}

/* Each step is the one that the ellipse's equation at the middle wants; it ends at (rx, 0). */
static bool ellipse(void)
{
    struct ellipse_midpoint e;
    int rx = within(0, 20), ry = within(0, 20);
    int a = rx * rx, b = ry * ry, x = 0, y = ry, region = 1;
    ellipse_midpoint_begin(&e, rx, ry);
    if (!ellipse_midpoint_next(&e))
        return false;
    for (;;) {
        if (e.x != x || e.y != y)
            return false;
        region = y == 0 ? 3 : region == 2 || b * x >= a * y ? 2 : 1;
        if (!ellipse_midpoint_next(&e))
            return x == rx && y == 0;
        int u = 2 * x + (region == 1 ? 2 : 1), v = 2 * y - (region == 1 ? 1 : 2);
        bool outside = b * u * u + a * v * v - 4 * a * b >= 0;
        x += region != 2 || !outside;
        y -= region == 2 || (region == 1 && outside);
    }
}

static bool holds(const char *what, bool (*property)(void))
{
    int failed = 0;
    for (int i = 0; i < CASES; i++)
        failed += !property();
    printf("%d %s", CASES, what);
    if (failed > 0)
        printf(": %d times not", failed);
    printf("\n");
    return failed == 0;
}

int main(void)
{
    bool right = holds("lines after Bresenham: within half a pixel, connected, both ends", nearest);
    right &= holds("lines after Bresenham: the same pixels from either end", symmetric);
    right &= holds("lines cut at the canvas: the pixels of the whole line", cut);
    right &= holds("lines by the DDA: within half a pixel, connected, both ends", dda);
    right &= holds("lines by the DDA in whole numbers: the same", dda_integer);
    right &= holds("circles: nearest pixels, the same from (0,r) and from (r,0)", circle);
    right &= holds("ellipses: the steps that the equation wants, to (rx,0)", ellipse);
    return right ? 0 : 1;
}
