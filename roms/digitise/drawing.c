#include "roms/digitise/drawing.h"

#include <math.h>

bool drawing_add(struct drawing *d, const struct drawing_point *point)
{
    if (d->count == DRAWING_POINTS_MOST)
        return false;
    d->point[d->count] = *point;
    if (d->count == 0)
        d->point[0].start = true;
    d->count++;
    return true;
}

bool drawing_delete_point(struct drawing *d)
{
    if (d->count == 0)
        return false;
    d->point[drawing_last_line(d).first].closed = false;
    d->count--;
    return true;
}

bool drawing_delete_line(struct drawing *d)
{
    struct drawing_line line = drawing_last_line(d);
    d->count = line.first;
    return line.count > 0;
}

bool drawing_close(struct drawing *d)
{
    struct drawing_line line = drawing_last_line(d);
    if (line.count < 3 || line.alone)
        return false;
    d->point[line.first].closed = true;
    return true;
}

/* ---- lines --------------------------------------------------------------------------------------- */

static struct drawing_line line_from(const struct drawing *d, int first)
{
    struct drawing_line line = {.first = first};
    if (first < d->count) {
        line.count = 1;
        line.closed = d->point[first].closed;
        line.alone = d->point[first].alone;
    }
    while (first + line.count < d->count && !d->point[first + line.count].start)
        line.count++;
    return line;
}

bool drawing_next_line(const struct drawing *d, struct drawing_line *line)
{
    *line = line_from(d, line->count ? line->first + line->count : 0);
    return line->count > 0;
}

struct drawing_line drawing_last_line(const struct drawing *d)
{
    int first = d->count > 0 ? d->count - 1 : 0;
    while (first > 0 && !d->point[first].start)
        first--;
    return line_from(d, first);
}

/* ---- measures ------------------------------------------------------------------------------------ */

static void add_segment(struct drawing_measure *m, const struct drawing_point *a,
                        const struct drawing_point *b, bool gap)
{
    float dx = b->x - a->x, dy = b->y - a->y, dz = b->z - a->z;
    float length = sqrtf(dx * dx + dy * dy);
    m->gaps += gap;
    if (gap) {
        m->bridged += length;
        return;
    }
    m->length += length;
    m->space += sqrtf(dx * dx + dy * dy + dz * dz);
}

/* Twice the triangle of the first point and a segment. */
static float triangle2(const struct drawing_point *o, const struct drawing_point *a,
                       const struct drawing_point *b)
{
    return (a->x - o->x) * (b->y - o->y) - (b->x - o->x) * (a->y - o->y);
}

struct drawing_measure drawing_measure(const struct drawing *d, const struct drawing_line *line)
{
    struct drawing_measure m = {0};
    const struct drawing_point *p = d->point + line->first;
    int last = line->count - 1;
    if (line->count == 0)
        return m;
    for (int i = 1; i <= last; i++) {
        add_segment(&m, &p[i - 1], &p[i], p[i].gap);
        m.area += triangle2(p, &p[i - 1], &p[i]) / 2;
    }
    m.perimeter = m.length + hypotf(p[0].x - p[last].x, p[0].y - p[last].y);
    if (line->closed)
        add_segment(&m, &p[last], &p[0], false);
    return m;
}
