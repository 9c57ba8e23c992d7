/* line_bresenham.h — lines by whole numbers and the sign of one of them.
 *
 *        d2 ┌───┐ across     the step along the longer axis is sure; whether the shorter axis
 *      ─ ─ ─┼ ╱ │            steps, too, says the decision parameter
 *        d1 └───┘ along         p = longer (d1 − d2):   p₀ = 2 short − long
 *                               p < 0: stays, p += 2 short
 *                               p ≥ 0: steps, p += 2 short − 2 long
 *
 * Models:     the pixel nearest to the line in each column (in each row, where the line is steep),
 *             in all octants, from the first end to the last. A line of length 0 is a pixel.
 *             Ties: a middle between two pixels, p = 0, steps the shorter axis when the longer axis
 *             increases, and stays when it decreases. Both choose the same pixel: the line from A
 *             to B lights the pixels of the line from B to A.
 * Cost:       a pixel: 1 comparison, 1 addition to p, 1 or 2 to x and y. A line: 6 additions; a
 *             line that is cut to a window: up to 8 multiplications and 5 divisions of 64 bits.
 * Domain:     coordinates within ±LINE_FARTHEST.
 * Units:      pixels; either sense of y.
 * Ownership:  plain values.
 * Errors:     none within the domain.
 * Source:     J. E. Bresenham, "Algorithm for computer control of a digital plotter", IBM Systems
 *             Journal 4 (1965) 25.
 * Not modelled: runs of pixels found by division (J. E. Bresenham, 1985), antialiasing.
 */
#ifndef ROMS_RASTER_LINE_BRESENHAM_H
#define ROMS_RASTER_LINE_BRESENHAM_H

#include <stdbool.h>

enum { LINE_FARTHEST = 1 << 28 };

struct line_bresenham {
    int x, y;               /* the pixel, after line_bresenham_next */
    int k;                  /* its number: 0 at the first end */
    int p;                  /* the decision parameter of the step that follows */
    int tie;                /* p at least so much steps: 0 or 1, see Ties */
    int last;               /* k of the last pixel */
    int straight, diagonal; /* what p gains */
    int along_x, along_y;   /* what every step adds */
    int across_x, across_y; /* … and what the shorter axis adds */
};

void line_bresenham_begin(struct line_bresenham *l, int x0, int y0, int x1, int y1);

/* Leaves out the pixels before the first and after the last one within the window, edges included;
 * those between are what they were. After line_bresenham_begin, before the first pixel. False: none
 * is within. */
bool line_bresenham_cut(struct line_bresenham *l, int x_min, int y_min, int x_max, int y_max);

/* Takes the decision: whether the shorter axis steps. */
static inline bool line_bresenham_decide(struct line_bresenham *l)
{
    bool steps = l->p >= l->tie;
    l->p += steps ? l->diagonal : l->straight;
    return steps;
}

/* Goes to the next pixel, at first to the first; false: there is none. */
static inline bool line_bresenham_next(struct line_bresenham *l)
{
    if (l->k == l->last)
        return false;
    l->k++;
    l->x += l->along_x;
    l->y += l->along_y;
    if (line_bresenham_decide(l)) {
        l->x += l->across_x;
        l->y += l->across_y;
    }
    return true;
}

#endif
