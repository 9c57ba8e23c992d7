#include "roms/visible/hidden_lines.h"

static const float touch_depth = 0.05f, touch_side = 0.01f;

void hidden_begin(struct hidden_lines *h, const struct scene *scene, float fold)
{
    h->scene = scene;
    h->fold = fold;
    h->edge = -1;
    h->part = h->parts = 0;
    h->at = 1;
    for (int i = 0; i < scene->surfaces; i++) {
        const struct surface *s = &scene->surface[i];
        struct vector3 p = scene_corner(scene, s, 0);
        float x0 = p.x, x1 = p.x, y0 = p.y, y1 = p.y, z1 = p.z;
        for (int k = 1; k < s->count; k++) {
            p = scene_corner(scene, s, k);
            x0 = p.x < x0 ? p.x : x0;
            x1 = p.x > x1 ? p.x : x1;
            y0 = p.y < y0 ? p.y : y0;
            y1 = p.y > y1 ? p.y : y1;
            z1 = p.z > z1 ? p.z : z1;
        }
        h->extent[i].x0 = x0;
        h->extent[i].x1 = x1;
        h->extent[i].y0 = y0;
        h->extent[i].y1 = y1;
        h->extent[i].z1 = z1;
    }
}

/* Narrows from…to to where the line from f0 (t = 0) to f1 (t = 1) is above 0; false: nowhere. */
static bool narrow_to_positive(float f0, float f1, float *from, float *to)
{
    if (f0 <= 0 && f1 <= 0)
        return false;
    if (f0 > 0 && f1 > 0)
        return true;
    float t = f0 / (f0 - f1);
    if (f0 > 0)
        *to = t < *to ? t : *to;
    else
        *from = t > *from ? t : *from;
    return *from < *to;
}

/* How far within a side of the outline a point is, times the side's length. */
static float within(struct vector3 from, struct vector3 to, struct vector3 p)
{
    return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
}

/* The part of a…b that a surface hides; false: none. */
static bool hidden_by(const struct scene *scene, const struct surface *s, struct vector3 a,
                      struct vector3 b, float *from, float *to)
{
    float turn = s->plane.c > 0 ? 1.0f : -1.0f;
    float slope = (fabsf(s->plane.a) + fabsf(s->plane.b)) / fabsf(s->plane.c);
    float margin = touch_depth + touch_side * slope;
    *from = 0;
    *to = 1;
    if (!narrow_to_positive(surface_depth(s, a.x, a.y) - a.z - margin,
                            surface_depth(s, b.x, b.y) - b.z - margin, from, to))
        return false;
    struct vector3 p = scene_corner(scene, s, s->count - 1);
    for (int i = 0; i < s->count; i++) {
        struct vector3 q = scene_corner(scene, s, i);
        float limit = touch_side * (fabsf(q.x - p.x) + fabsf(q.y - p.y));
        if (!narrow_to_positive(turn * within(p, q, a) - limit, turn * within(p, q, b) - limit,
                                from, to))
            return false;
        p = q;
    }
    return true;
}

/* Joins the two neighbours that are nearest to each other: what lies between them is hidden, too. */
static void join_nearest(struct hidden_lines *h)
{
    int nearest = 1;
    for (int i = 2; i < h->parts; i++)
        if (h->hidden[i].from - h->hidden[i - 1].to <
            h->hidden[nearest].from - h->hidden[nearest - 1].to)
            nearest = i;
    h->hidden[nearest - 1].to = h->hidden[nearest].to;
    h->parts--;
    for (int i = nearest; i < h->parts; i++)
        h->hidden[i] = h->hidden[i + 1];
}

/* Adds a hidden part to the ordered list, joining those that it meets. There is room for one. */
static void add_hidden(struct hidden_lines *h, float from, float to)
{
    int first = 0, last;
    while (first < h->parts && h->hidden[first].to < from)
        first++;
    for (last = first; last < h->parts && h->hidden[last].from <= to; last++) {
        from = h->hidden[last].from < from ? h->hidden[last].from : from;
        to = h->hidden[last].to > to ? h->hidden[last].to : to;
    }
    int gone = last - first;
    if (gone == 0)
        for (int i = h->parts; i > first; i--)
            h->hidden[i] = h->hidden[i - 1];
    for (int i = last; gone > 1 && i < h->parts; i++)
        h->hidden[i - gone + 1] = h->hidden[i];
    h->parts += 1 - gone;
    h->hidden[first].from = from;
    h->hidden[first].to = to;
    if (h->parts > HIDDEN_PARTS)
        join_nearest(h);
}

/* All that hides an edge. */
static void gather(struct hidden_lines *h, const struct scene_edge *e)
{
    struct vector3 a = h->scene->vertex[e->vertex[0]], b = h->scene->vertex[e->vertex[1]];
    float x0 = fminf(a.x, b.x), x1 = fmaxf(a.x, b.x), y0 = fminf(a.y, b.y), y1 = fmaxf(a.y, b.y);
    float z0 = fminf(a.z, b.z), from, to;
    h->parts = 0;
    for (int i = 0; i < h->scene->surfaces; i++) {
        const struct surface *s = &h->scene->surface[i];
        if (h->extent[i].x1 <= x0 || h->extent[i].x0 >= x1 || h->extent[i].y1 <= y0 ||
            h->extent[i].y0 >= y1 || h->extent[i].z1 <= z0)
            continue;
        if (i == e->surface[0] || i == e->surface[1] || s->plane.c == 0)
            continue;
        if (hidden_by(h->scene, s, a, b, &from, &to))
            add_hidden(h, from, to);
    }
}

static bool next_edge(struct hidden_lines *h)
{
    const struct scene *s = h->scene;
    do
        h->edge++;
    while (h->edge < s->edges && s->edge[h->edge].fold >= h->fold);
    if (h->edge >= s->edges)
        return false;
    gather(h, &s->edge[h->edge]);
    h->part = 0;
    h->at = 0;
    return true;
}

static struct vector3 along(struct vector3 a, struct vector3 b, float t)
{
    return vector3_sum(a, vector3_times(vector3_difference(b, a), t));
}

/* The part from h->at on. */
static void take_part(struct hidden_lines *h, struct hidden_part *out)
{
    const struct scene_edge *e = &h->scene->edge[h->edge];
    struct vector3 a = h->scene->vertex[e->vertex[0]], b = h->scene->vertex[e->vertex[1]];
    float from = h->at;
    out->edge = h->edge;
    out->seen = h->part == h->parts || from < h->hidden[h->part].from;
    if (out->seen)
        h->at = h->part < h->parts ? h->hidden[h->part].from : 1;
    else
        h->at = h->hidden[h->part++].to;
    out->a = along(a, b, from);
    out->b = along(a, b, h->at);
}

bool hidden_next(struct hidden_lines *h, struct hidden_part *out)
{
    for (;;) {
        while (h->at >= 1)
            if (!next_edge(h))
                return false;
        take_part(h, out);
        if (fabsf(out->b.x - out->a.x) + fabsf(out->b.y - out->a.y) >= HIDDEN_SHORTEST)
            return true;
    }
}
