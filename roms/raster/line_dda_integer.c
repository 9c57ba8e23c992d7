#include "roms/raster/line_dda_integer.h"

#include <stdlib.h>

#include "roms/raster/plot.h"

/* v / n to the nearest fraction of so many bits, for |v| at most n. */
static struct line_parts parts_of(int v, int n, int bits)
{
    if (n == 0)
        return (struct line_parts){0, 0};
    int scaled = v * (1 << bits);
    int nearest = (scaled + (scaled < 0 ? -n / 2 : n / 2)) / n;
    int whole = nearest >> bits; /* downward */
    return (struct line_parts){whole, nearest - whole * (1 << bits)};
}

void line_dda_integer_begin(struct line_dda_integer *l, int x0, int y0, int x1, int y1, int bits)
{
    int dx = x1 - x0, dy = y1 - y0;
    int longer = abs(dx) > abs(dy) ? abs(dx) : abs(dy);
    *l = (struct line_dda_integer){
        .x = {x0, 0}, .y = {y0, 0}, .bits = bits, .k = -1, .last = longer};
    l->dx = parts_of(dx, longer, bits);
    l->dy = parts_of(dy, longer, bits);
}

static inline void draw_integer(const struct plot *plot, unsigned bits, struct line_dda_integer l)
{
    while (line_dda_integer_next(&l))
        plot_1(plot, bits, l.plot_x, l.plot_y);
}

void canvas_line_dda_integer(const struct canvas *c, int x0, int y0, int x1, int y1,
                             uint32_t colour)
{
    struct line_dda_integer l;
    struct plot plot;
    if (!plot_line_near(x0, y0, x1, y1, LINE_DDA_INTEGER_FARTHEST))
        return;
    bool whole = plot_begin_line(&plot, c, x0, y0, x1, y1, colour);
    line_dda_integer_begin(&l, x0, y0, x1, y1, LINE_FRACTION_BITS);
    PLOT_EACH_FORMAT(draw_integer, &plot, whole, l);
}
