#include "roms/raster/line_bresenham.h"

#include <stdint.h>
#include <stdlib.h>

static int sign(int v)
{
    return (v > 0) - (v < 0);
}

/* Puts it one step before pixel `k`, the shorter axis having stepped `across` times until there.
 * That step is a straight one whatever the line: p is below 0 before it. */
static void stand_before(struct line_bresenham *l, int k, int across, int p)
{
    l->x += (k - 1) * l->along_x + across * l->across_x;
    l->y += (k - 1) * l->along_y + across * l->across_y;
    l->k = k - 1;
    l->p = p - l->straight;
}

void line_bresenham_begin(struct line_bresenham *l, int x0, int y0, int x1, int y1)
{
    int dx = abs(x1 - x0), dy = abs(y1 - y0), step_x = sign(x1 - x0), step_y = sign(y1 - y0);
    bool steep = dy > dx;
    int longer = steep ? dy : dx, shorter = steep ? dx : dy;
    *l = (struct line_bresenham){.x = x0, .y = y0, .last = longer};
    l->straight = 2 * shorter;
    l->diagonal = 2 * shorter - 2 * longer;
    l->along_x = steep ? 0 : step_x;
    l->along_y = steep ? step_y : 0;
    l->across_x = steep ? step_x : 0;
    l->across_y = steep ? 0 : step_y;
    l->tie = l->along_x + l->along_y < 0;
    stand_before(l, 0, 0, 2 * shorter - longer);
}

/* ---- the part within a window ---------------------------------------------------------------- */

struct range {
    int64_t low, high;
};

/* Steps k for which from + k * step is within low…high; step is 1 or −1. */
static struct range while_within(int from, int step, int low, int high)
{
    return step > 0 ? (struct range){(int64_t)low - from, (int64_t)high - from}
                    : (struct range){(int64_t)from - high, (int64_t)from - low};
}

static struct range both(struct range a, struct range b)
{
    return (struct range){a.low > b.low ? a.low : b.low, a.high < b.high ? a.high : b.high};
}

/* The smallest whole number at least a / b, for b above 0. */
static int64_t quotient_up(int64_t a, int64_t b)
{
    return a / b + (a % b > 0);
}

/* The shorter axis has stepped floor((2 short k + long − tie) / 2 long) times at pixel k: the steps
 * k for which that is within low…high. */
static struct range while_across(const struct line_bresenham *l, struct range across)
{
    int64_t twice_short = l->straight, twice_long = l->straight - l->diagonal;
    int64_t rest = twice_long / 2 - l->tie;
    return (struct range){quotient_up(twice_long * across.low - rest, twice_short),
                          quotient_up(twice_long * (across.high + 1) - rest, twice_short) - 1};
}

bool line_bresenham_cut(struct line_bresenham *l, int x_min, int y_min, int x_max, int y_max)
{
    bool steep = l->along_y != 0;
    int x0 = l->x + l->along_x, y0 = l->y + l->along_y;
    struct range k = {0, l->last};
    if (l->last == 0)
        return x0 >= x_min && x0 <= x_max && y0 >= y_min && y0 <= y_max;
    struct range along = steep ? while_within(y0, l->along_y, y_min, y_max)
                               : while_within(x0, l->along_x, x_min, x_max);
    int from = steep ? x0 : y0, low = steep ? x_min : y_min, high = steep ? x_max : y_max;
    k = both(k, along);
    if (l->straight != 0)
        k = both(k, while_across(l, while_within(from, l->across_x + l->across_y, low, high)));
    else if (from < low || from > high)
        return false;
    if (k.low > k.high)
        return false;
    int64_t twice_long = l->straight - l->diagonal;
    int64_t to_k = l->straight * k.low, across = (to_k + twice_long / 2 - l->tie) / twice_long;
    l->x = x0;
    l->y = y0;
    l->last = (int)k.high;
    stand_before(l, (int)k.low, (int)across,
                 (int)(to_k + l->straight - twice_long * across - twice_long / 2));
    return true;
}
