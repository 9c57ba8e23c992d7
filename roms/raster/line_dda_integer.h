/* line_dda_integer.h — the DDA without floats: increments as whole and fraction parts.
 *
 *      m = dy / n ──one division──▶ │ whole │ fraction / 2^bits │
 *      y: │ whole │ fraction │ ──+ m──▶ the fraction's carry goes to the whole part; a fraction
 *                                       of at least a half plots the next pixel
 *
 * Models:     the DDA (line_dda.h) with fractions of a chosen number of bits. From the first end to
 *             the last, both drawn.
 * Cost:       a pixel: 8 additions and shifts of whole numbers. A line: 2 divisions of whole
 *             numbers.
 * Domain:     1 to 16 bits of fraction; coordinates within ±LINE_DDA_INTEGER_FARTHEST, so that dx
 *             times 2^bits does not overflow. An increment is wrong by at most 2^-(bits+1), so that
 *             pixel k is within a half and k / 2^(bits+1) of the line; with LINE_FRACTION_BITS a
 *             line of 4000 steps is within 0.531 pixels, and its last pixel is its end.
 * Units:      pixels; fractions: 2^-bits pixels.
 * Ownership:  plain values.
 * Errors:     lines with an end farther out are not drawn. A line of length 0 is a pixel. Too few bits miss the end: that can be seen.
 * Source:     J. D. Foley et al., Computer Graphics (1990), section 3.2.1; fixed point is older
 *             than floats.
 */
#ifndef ROMS_RASTER_LINE_DDA_INTEGER_H
#define ROMS_RASTER_LINE_DDA_INTEGER_H

#include <stdbool.h>

#include "roms/raster/canvas.h"

enum { LINE_FRACTION_BITS = 16, LINE_DDA_INTEGER_FARTHEST = 8192 };

/* whole + fraction / 2^bits; the fraction is not negative. */
struct line_parts {
    int whole, fraction;
};

struct line_dda_integer {
    struct line_parts x, y;   /* after line_dda_integer_next */
    int plot_x, plot_y;       /* the pixel */
    struct line_parts dx, dy; /* what a step adds */
    int bits;                 /* of fractions */
    int k, last;              /* the pixel's number: 0 at the first end */
};

void line_dda_integer_begin(struct line_dda_integer *l, int x0, int y0, int x1, int y1, int bits);

static inline void line_parts_add(struct line_parts *to, struct line_parts more, int bits)
{
    int sum = to->fraction + more.fraction, carry = sum >> bits;
    to->fraction = sum - (carry << bits);
    to->whole += more.whole + carry;
}

static inline int line_parts_round(struct line_parts v, int bits)
{
    return v.whole + (v.fraction >> (bits - 1));
}

/* Goes to the next pixel, at first to the first; false: there is none. */
static inline bool line_dda_integer_next(struct line_dda_integer *l)
{
    if (l->k == l->last)
        return false;
    if (++l->k > 0) {
        line_parts_add(&l->x, l->dx, l->bits);
        line_parts_add(&l->y, l->dy, l->bits);
    }
    l->plot_x = line_parts_round(l->x, l->bits);
    l->plot_y = line_parts_round(l->y, l->bits);
    return true;
}

void canvas_line_dda_integer(const struct canvas *c, int x0, int y0, int x1, int y1,
                             uint32_t colour);

#endif
