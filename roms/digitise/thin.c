#include "roms/digitise/thin.h"

#include "roms/geometry/scalar.h"

enum { WAITING = 32 };

/* Squared, to the segment from a to b. */
static float distance2(const struct drawing_point *a, const struct drawing_point *b,
                       const struct drawing_point *p)
{
    float dx = b->x - a->x, dy = b->y - a->y, px = p->x - a->x, py = p->y - a->y;
    float length2 = dx * dx + dy * dy;
    float part = length2 > 0 ? scalar_min(scalar_max((px * dx + py * dy) / length2, 0), 1) : 0;
    px -= part * dx;
    py -= part * dy;
    return px * px + py * py;
}

/* The farthest between two that stay, if it is too far; else -1. */
static int thin_farthest(const struct drawing_point *p, int from, int to, float tolerance)
{
    float most = tolerance * tolerance;
    int at = -1;
    for (int i = from + 1; i < to; i++) {
        float d = distance2(&p[from], &p[to], &p[i]);
        if (d > most) {
            most = d;
            at = i;
        }
    }
    return at;
}

/* Between two points that stay. */
static void thin_between(const struct drawing_point *p, int from, int to, float tolerance,
                         bool *keep)
{
    struct range {
        int from, to;
    } waiting[WAITING];
    int count = 0;
    for (;;) {
        int at = thin_farthest(p, from, to, tolerance);
        if (at >= 0) {
            bool first = at - from < to - at; /* is the smaller part */
            keep[at] = true;
            waiting[count++] = first ? (struct range){at, to} : (struct range){from, at};
            from = first ? from : at;
            to = first ? at : to;
        } else if (count > 0) {
            from = waiting[--count].from;
            to = waiting[count].to;
        } else {
            return;
        }
    }
}

int thin_points(const struct drawing_point *p, int count, float tolerance, bool *keep)
{
    int kept = 0, from = 0;
    for (int i = 0; i < count; i++)
        keep[i] = i == 0 || i == count - 1 || p[i].gap || p[i + 1].gap;
    for (int i = 1; i < count; i++)
        if (keep[i]) {
            if (!p[i].gap)
                thin_between(p, from, i, tolerance, keep);
            from = i;
        }
    for (int i = 0; i < count; i++)
        kept += keep[i];
    return kept;
}
