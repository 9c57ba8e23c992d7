#include "roms/clip/sutherland_hodgman.h"

#include <string.h>

#include "roms/clip/edge.h"

bool sutherland_hodgman_begin(struct sutherland_hodgman *s, const struct clip_window *window,
                              const struct point2 *corners, int count)
{
    if (count < 1 || count > CLIP_POLYGON_MOST)
        return false;
    s->window = *window;
    s->edge = 0;
    s->count = count;
    memcpy(s->corner, corners, (size_t)count * sizeof *corners);
    return true;
}

static bool inside(const struct clip_window *w, unsigned edge, struct point2 p)
{
    return (clip_region(w, p) & edge) == 0;
}

/* Reckoned from the end that is inside, so that polygons which share an edge still do. */
static struct point2 crossing(const struct sutherland_hodgman *s, struct point2 from,
                              struct point2 to, bool to_in)
{
    return to_in ? clip_meeting(&s->window, s->edge, to, from)
                 : clip_meeting(&s->window, s->edge, from, to);
}

bool sutherland_hodgman_next(struct sutherland_hodgman *s)
{
    if (s->edge == REGION_ABOVE)
        return false;
    s->edge = s->edge == 0 ? REGION_LEFT : s->edge << 1;
    int kept = 0;
    for (int i = 0; i < s->count; i++) {
        struct point2 from = s->corner[i > 0 ? i - 1 : s->count - 1], to = s->corner[i];
        bool to_in = inside(&s->window, s->edge, to);
        if (inside(&s->window, s->edge, from) != to_in)
            s->spare[kept++] = crossing(s, from, to, to_in);
        if (to_in)
            s->spare[kept++] = to;
    }
    memcpy(s->corner, s->spare, (size_t)kept * sizeof *s->corner);
    s->count = kept;
    return true;
}

bool clip_sutherland_hodgman(struct sutherland_hodgman *s, const struct clip_window *window,
                             const struct point2 *corners, int count)
{
    if (!sutherland_hodgman_begin(s, window, corners, count))
        return false;
    while (sutherland_hodgman_next(s))
        ;
    return true;
}

/* ---- doubled edges -------------------------------------------------------------------------- */

/* An edge as a stretch of a side of the window. */
struct stretch {
    int side;       /* 0…3; -1: it lies on none */
    float from, to; /* along it */
};

static struct stretch stretch(const struct clip_window *w, struct point2 a, struct point2 b)
{
    if (a.x == b.x && (a.x == w->x_min || a.x == w->x_max))
        return (struct stretch){a.x == w->x_min ? 0 : 1, a.y, b.y};
    if (a.y == b.y && (a.y == w->y_min || a.y == w->y_max))
        return (struct stretch){a.y == w->y_min ? 2 : 3, a.x, b.x};
    return (struct stretch){-1, 0, 0};
}

static bool cover(struct stretch a, struct stretch b)
{
    bool up = a.from < a.to;
    if (a.side < 0 || a.side != b.side || a.from == a.to || b.from == b.to || up == (b.from < b.to))
        return false;
    float low = up ? a.from : a.to, high = up ? a.to : a.from;
    float other_low = up ? b.to : b.from, other_high = up ? b.from : b.to;
    return low < other_high && other_low < high;
}

int clip_polygon_doubled(const struct clip_window *w, const struct point2 *p, int count)
{
    int doubled = 0;
    for (int i = 0; i < count; i++) {
        struct stretch a = stretch(w, p[i], p[(i + 1) % count]);
        bool covered = false;
        for (int k = 0; k < count && !covered; k++)
            covered = cover(a, stretch(w, p[k], p[(k + 1) % count]));
        doubled += covered;
    }
    return doubled;
}
