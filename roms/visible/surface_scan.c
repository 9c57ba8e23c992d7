#include "roms/visible/surface_scan.h"

#include "roms/geometry/scalar.h"

static void insert(struct surface_scan *s, struct scan_edge e)
{
    int k = s->count++;
    for (; k > 0 && s->edge[k - 1].first > e.first; k--)
        s->edge[k] = s->edge[k - 1];
    s->edge[k] = e;
}

void surface_scan_begin(struct surface_scan *s, const struct scene *scene, const struct surface *f,
                        int width, int height)
{
    s->width = width;
    s->count = 0;
    s->next = 0;
    s->last = -1;
    s->y = 0;
    for (int i = 0; i < f->count && f->plane.c != 0; i++) {
        struct scan_edge e = scan_edge_between(
            scene_corner(scene, f, i), scene_corner(scene, f, i + 1 < f->count ? i + 1 : 0));
        if (e.first > e.last || e.first >= height)
            continue;
        s->last = e.last > s->last ? e.last : s->last;
        insert(s, e);
    }
    s->last = s->last < height - 1 ? s->last : height - 1;
    if (s->count < 2) {
        s->last = -1;
        return;
    }
    /* Both begin with the first row. */
    s->y = s->edge[0].first - 1;
    s->a.last = s->b.last = s->y;
}

/* Goes on to row y; an edge that has ended is followed by the next one. */
static bool advance(struct surface_scan *s, struct scan_edge *e)
{
    if (s->y <= e->last) {
        e->x += e->slope;
        return true;
    }
    if (s->next == s->count)
        return false;
    *e = s->edge[s->next++];
    return true;
}

bool surface_scan_next(struct surface_scan *s)
{
    if (++s->y > s->last || !advance(s, &s->a) || !advance(s, &s->b))
        return false;
    float left = s->a.x < s->b.x ? s->a.x : s->b.x, right = s->a.x < s->b.x ? s->b.x : s->a.x;
    s->x0 = left > 0 ? scalar_ceil(left) : 0;
    s->x1 = right < (float)s->width ? scalar_ceil(right) : s->width;
    return true;
}
