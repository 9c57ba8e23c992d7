#include "roms/spline/hull.h"

#include <stdbool.h>

static bool comes_before(struct point2 a, struct point2 b)
{
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

static int sorted(const struct vector3 *points, int count, struct point2 *out)
{
    int n = 0;
    for (int i = 0; i < count; i++) {
        struct point2 p = {points[i].x, points[i].y};
        int at = n;
        while (at > 0 && comes_before(p, out[at - 1]))
            at--;
        if (at > 0 && out[at - 1].x == p.x && out[at - 1].y == p.y)
            continue;
        for (int k = n++; k > at; k--)
            out[k] = out[k - 1];
        out[at] = p;
    }
    return n;
}

/* The way a → b → c turns to the left. */
static bool turns_left(struct point2 a, struct point2 b, struct point2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0;
}

/* Adds p behind the chain that begins at `first`; corners that it makes hollow go. */
static int hull_extend(struct point2 *out, int first, int count, struct point2 p)
{
    while (count - first >= 2 && !turns_left(out[count - 2], out[count - 1], p))
        count--;
    out[count++] = p;
    return count;
}

int convex_hull(const struct vector3 *points, int count, struct point2 *out)
{
    struct point2 p[HULL_MOST], chain[2 * HULL_MOST];
    int n = sorted(points, count < HULL_MOST ? count : HULL_MOST, p), corners = 0;
    for (int i = 0; i < n; i++)
        corners = hull_extend(chain, 0, corners, p[i]);
    int upper = corners - 1;
    for (int i = n - 2; i >= 0; i--)
        corners = hull_extend(chain, upper, corners, p[i]);
    corners = corners > 1 ? corners - 1 : corners; /* the first again */
    for (int i = 0; i < corners; i++)
        out[i] = chain[i];
    return corners;
}
