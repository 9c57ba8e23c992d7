/* line_dda.h — lines by the digital differential analyser: a float a step.
 *
 *      |m| ≤ 1: x ± 1, y ± m        ■         x₀ ──+ 1──▶ x ──nearest──▶ pixel
 *      |m| > 1: y ± 1, x ± 1/m    ╱           y₀ ──+ m──▶ y ──nearest──▶ pixel
 *                               ■
 *
 * Models:     dx and dy over the greater of |dx|, |dy|; x and y summed up in floats of 32 bits and
 *             rounded, a half upward, for each pixel. From the first end to the last, both drawn.
 * Cost:       a pixel: 2 float additions, 2 roundings (a float addition, a conversion and its
 *             correction each). A line: 2 float divisions.
 * Domain:     coordinates within ±LINE_DDA_FARTHEST. What n additions lose adds up to n / 2 units of the last
 *             binary place of the greatest coordinate: below 2^13 at most 2^-12 a step, so that
 *             long lines drift away.
 * Units:      pixels; cases are named for y up.
 * Ownership:  plain values.
 * Errors:     lines with an end farther out are not drawn. A line of length 0 is a pixel.
 * Source:     J. D. Foley et al., Computer Graphics (1990), section 3.2.1; the name is that of
 *             machines that integrated by adding, such as MADDIDA (1949).
 */
#ifndef ROMS_RASTER_LINE_DDA_H
#define ROMS_RASTER_LINE_DDA_H

#include <stdbool.h>

#include "roms/geometry/scalar.h"
#include "roms/raster/canvas.h"

enum { LINE_DDA_FARTHEST = 1 << 22 };

struct line_dda {
    float x, y;         /* not rounded, after line_dda_next */
    int plot_x, plot_y; /* the pixel */
    float dx, dy;       /* what a step adds */
    int k, last;        /* the pixel's number: 0 at the first end */
};

void line_dda_begin(struct line_dda *l, int x0, int y0, int x1, int y1);

/* Goes to the next pixel, at first to the first; false: there is none. */
static inline bool line_dda_next(struct line_dda *l)
{
    if (l->k == l->last)
        return false;
    if (++l->k > 0) {
        l->x += l->dx;
        l->y += l->dy;
    }
    l->plot_x = scalar_nearest(l->x);
    l->plot_y = scalar_nearest(l->y);
    return true;
}

/* Which of the eight cases of slope and direction a line is, and what a step does. */
struct line_case {
    bool negative;     /* the slope */
    bool leftward;     /* from right to left */
    bool steep;        /* |m| > 1 */
    char along_letter; /* of the two equations, A…P */
    char across_letter;
    const char *along;  /* "y + 1" */
    const char *across; /* "x + 1/m": m with its sign */
};

/* A horizontal line counts as one of positive slope, an upright one, too: upward from left to
 * right. */
struct line_case line_case_of(int x0, int y0, int x1, int y1);

void canvas_line_dda(const struct canvas *c, int x0, int y0, int x1, int y1, uint32_t colour);

#endif
