#include "roms/raster/line_dda.h"

#include <stdlib.h>

#include "roms/raster/plot.h"

void line_dda_begin(struct line_dda *l, int x0, int y0, int x1, int y1)
{
    int dx = x1 - x0, dy = y1 - y0;
    int longer = abs(dx) > abs(dy) ? abs(dx) : abs(dy);
    *l = (struct line_dda){.x = (float)x0, .y = (float)y0, .k = -1, .last = longer};
    if (longer > 0) {
        l->dx = (float)dx / (float)longer;
        l->dy = (float)dy / (float)longer;
    }
}

struct line_case line_case_of(int x0, int y0, int x1, int y1)
{
    static const struct line_case cases[8] = {
        {false, false, true, 'A', 'B', "y + 1", "x + 1/m"},
        {false, false, false, 'C', 'D', "x + 1", "y + m"},
        {false, true, true, 'E', 'F', "y - 1", "x - 1/m"},
        {false, true, false, 'G', 'H', "x - 1", "y - m"},
        {true, false, true, 'I', 'J', "y - 1", "x - 1/m"},
        {true, false, false, 'K', 'L', "x + 1", "y + m"},
        {true, true, true, 'M', 'N', "y + 1", "x + 1/m"},
        {true, true, false, 'O', 'P', "x - 1", "y - m"},
    };
    int dx = x1 - x0, dy = y1 - y0;
    bool negative = (dx > 0 && dy < 0) || (dx < 0 && dy > 0);
    bool leftward = dx < 0 || (dx == 0 && dy < 0), level = abs(dy) <= abs(dx);
    return cases[4 * negative + 2 * leftward + level];
}

static inline void draw_dda(const struct plot *plot, unsigned bits, struct line_dda l)
{
    while (line_dda_next(&l))
        plot_1(plot, bits, l.plot_x, l.plot_y);
}

void canvas_line_dda(const struct canvas *c, int x0, int y0, int x1, int y1, uint32_t colour)
{
    enum {
        STRAIGHT = 2048
    }; /* drifts by less than half a pixel, so that it stays between its ends */
    struct line_dda l;
    struct plot plot;
    if (!plot_line_near(x0, y0, x1, y1, LINE_DDA_FARTHEST))
        return;
    bool whole = plot_begin_line(&plot, c, x0, y0, x1, y1, colour);
    line_dda_begin(&l, x0, y0, x1, y1);
    PLOT_EACH_FORMAT(draw_dda, &plot, whole && l.last <= STRAIGHT, l);
}
