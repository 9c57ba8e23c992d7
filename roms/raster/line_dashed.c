#include "roms/raster/line_dashed.h"

#include <math.h>

static bool pattern_reaches(int v)
{
    enum { REACH = 30000 };
    return v >= -REACH && v <= REACH;
}

void line_dashed_begin(struct line_dashed *l, int x0, int y0, int x1, int y1,
                       const struct dash_pattern *pattern, struct dash_phase *phase)
{
    *l = (struct line_dashed){.pattern = pattern, .phase = phase};
    if (!pattern_reaches(x0) || !pattern_reaches(y0) || !pattern_reaches(x1) ||
        !pattern_reaches(y1))
        return;
    line_bresenham_begin(&l->pixels, x0, y0, x1, y1);
    float dx = (float)(x1 - x0), dy = (float)(y1 - y0), longer = (float)l->pixels.last;
    if (longer > 0)
        l->advance = (int32_t)(sqrtf(dx * dx + dy * dy) / longer * 65536 + 0.5f);
}

void canvas_line_dashed(const struct canvas *c, int x0, int y0, int x1, int y1,
                        const struct dash_pattern *pattern, struct dash_phase *phase,
                        uint32_t colour)
{
    struct line_dashed line;
    int x, y;
    bool on;
    line_dashed_begin(&line, x0, y0, x1, y1, pattern, phase);
    while (line_dashed_next(&line, &x, &y, &on))
        if (on)
            canvas_dot(c, x, y, colour);
}
