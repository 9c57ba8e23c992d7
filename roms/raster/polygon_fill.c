#include "roms/raster/polygon_fill.h"

#include <math.h>

struct crossing {
    float x;
    int winding;
};

static int crossings(const struct point2 *p, int count, float y, struct crossing *at)
{
    int found = 0;
    for (int i = 0; i < count; i++) {
        struct point2 a = p[i], b = p[(i + 1) % count];
        if ((a.y <= y) == (b.y <= y))
            continue;
        struct crossing c = {a.x + (y - a.y) * (b.x - a.x) / (b.y - a.y), a.y <= y ? 1 : -1};
        int k = found++;
        for (; k > 0 && at[k - 1].x > c.x; k--)
            at[k] = at[k - 1];
        at[k] = c;
    }
    return found;
}

void canvas_polygon(const struct canvas *c, const struct point2 *p, int count,
                    enum polygon_rule rule, uint32_t colour)
{
    struct crossing at[POLYGON_CORNERS];
    if (count < 3 || count > POLYGON_CORNERS)
        return;
    float low = p[0].y, high = p[0].y;
    for (int i = 1; i < count; i++) {
        low = fminf(low, p[i].y);
        high = fmaxf(high, p[i].y);
    }
    for (int y = (int)fmaxf(0, ceilf(low)); y <= (int)fminf(high, (float)c->height - 1); y++) {
        int found = crossings(p, count, (float)y, at), inside = 0;
        for (int i = 0; i + 1 < found; i++) {
            inside = rule == POLYGON_EVEN_ODD ? !inside : inside + at[i].winding;
            int x0 = (int)ceilf(at[i].x), x1 = (int)ceilf(at[i + 1].x);
            if (inside)
                canvas_fill(c, x0, y, x1 - x0, 1, colour);
        }
    }
}
