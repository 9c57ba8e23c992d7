#include "roms/raster/ellipse_midpoint.h"

#include "roms/raster/plot.h"

void ellipse_midpoint_begin(struct ellipse_midpoint *e, int rx, int ry)
{
    int64_t a = (int64_t)rx * rx, b = (int64_t)ry * ry;
    *e = (struct ellipse_midpoint){.x = 0, .y = ry, .k = -1, .region = 1, .rx = rx};
    e->rx_squared = a;
    e->ry_squared = b;
    e->slope_y = 2 * a * ry;
    e->p = b - a * ry + a / 4;
    ellipse_midpoint_turn(e);
}

int64_t ellipse_midpoint_second(const struct ellipse_midpoint *e)
{
    int64_t x = e->x, y = e->y - 1;
    return e->ry_squared * (x * x + x) + e->ry_squared / 4 +
           e->rx_squared * (y * y - e->ry_squared);
}

static inline void draw(const struct plot *plot, unsigned bits, int rx, int ry)
{
    struct ellipse_midpoint m;
    ellipse_midpoint_begin(&m, rx, ry);
    while (ellipse_midpoint_next(&m))
        plot_4(plot, bits, m.x, m.y);
}

void canvas_ellipse_midpoint(const struct canvas *c, int x, int y, int rx, int ry, uint32_t colour)
{
    struct plot plot;
    if (rx < 0 || ry < 0 || rx > ELLIPSE_LARGEST || ry > ELLIPSE_LARGEST)
        return;
    bool whole = plot_begin(&plot, c, x, y, rx, ry, colour);
    PLOT_EACH_FORMAT(draw, &plot, whole, rx, ry);
}
