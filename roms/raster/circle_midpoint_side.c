#include "roms/raster/circle_midpoint_side.h"

#include "roms/raster/circle_midpoint.h"
#include "roms/raster/plot.h"

static inline void draw(const struct plot *plot, unsigned bits, int r)
{
    struct circle_midpoint_side m;
    circle_midpoint_side_begin(&m, r);
    while (circle_midpoint_side_next(&m))
        plot_8(plot, bits, m.x, m.y);
}

void canvas_circle_side(const struct canvas *c, int x, int y, int r, uint32_t colour)
{
    struct plot plot;
    bool whole = plot_begin(&plot, c, x, y, r, r, colour);
    if (r >= 0 && r <= CIRCLE_LARGEST)
        PLOT_EACH_FORMAT(draw, &plot, whole, r);
}
