#include "roms/stage/hatch.h"

#include <math.h>

#include "roms/geometry/scalar.h"

enum { LEAST_APART = 3 };

/* Turned by the angle of the lines: x along them, y across. */
static struct point2 turned(struct point2 p, float c, float s)
{
    return (struct point2){p.x * c + p.y * s, p.y * c - p.x * s};
}

/* Where edges cross the line, from left to right. */
static int crossed(const struct point2 *p, int count, float y, float *at)
{
    int found = 0;
    for (int i = 0; i < count; i++) {
        struct point2 a = p[i], b = p[(i + 1) % count];
        if ((a.y <= y) == (b.y <= y))
            continue;
        float x = a.x + (y - a.y) * (b.x - a.x) / (b.y - a.y);
        int k = found++;
        for (; k > 0 && at[k - 1] > x; k--)
            at[k] = at[k - 1];
        at[k] = x;
    }
    return found;
}

void hatch_area(struct stage *stage, const struct point2 *p, int count)
{
    struct point2 q[STAGE_AREA_CORNERS];
    float at[STAGE_AREA_CORNERS], low = INFINITY, high = -INFINITY;
    float apart = scalar_max(stage->hatch_apart, LEAST_APART);
    float angle = stage->hatch_degrees * DEGREE, c = cosf(angle), s = sinf(angle);
    const float farthest = hypotf(STAGE_WIDTH, STAGE_HEIGHT); /* what is beyond is not seen */
    for (int i = 0; i < count; i++) {
        q[i] = turned(p[i], c, s);
        low = scalar_min(low, q[i].y);
        high = scalar_max(high, q[i].y);
    }
    low = scalar_max(low, -farthest);
    high = scalar_min(high, farthest);
    for (float k = ceilf(low / apart); k * apart < high; k++) {
        int found = crossed(q, count, k * apart, at);
        for (int i = 0; i + 1 < found; i += 2) {
            struct point2 a = turned((struct point2){at[i], k * apart}, c, -s);
            struct point2 b = turned((struct point2){at[i + 1], k * apart}, c, -s);
            stage_line(stage, a.x, a.y, b.x, b.y);
        }
    }
}
