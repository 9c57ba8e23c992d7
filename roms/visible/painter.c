#include "roms/visible/painter.h"

#include "roms/geometry/scalar.h"
#include "roms/visible/surface_scan.h"

/* Picture units: surfaces that touch do not overlap. */
static const float touching = 0.01f;

static struct painter_extent extent_of(const struct scene *scene, const struct surface *s)
{
    struct vector3 p = scene_corner(scene, s, 0);
    struct painter_extent e = {p.x, p.x, p.y, p.y, p.z, p.z};
    for (int i = 1; i < s->count; i++) {
        p = scene_corner(scene, s, i);
        e.x0 = scalar_min(e.x0, p.x);
        e.x1 = scalar_max(e.x1, p.x);
        e.y0 = scalar_min(e.y0, p.y);
        e.y1 = scalar_max(e.y1, p.y);
        e.z0 = scalar_min(e.z0, p.z);
        e.z1 = scalar_max(e.z1, p.z);
    }
    return e;
}

/* Shell sort by the farthest point; of equal ones the first stays first. */
static void sort_by_depth(struct painter *p)
{
    for (int gap = p->count / 2; gap > 0; gap /= 2)
        for (int i = gap; i < p->count; i++) {
            uint16_t s = p->order[i];
            int k = i;
            for (; k >= gap; k -= gap) {
                uint16_t before = p->order[k - gap];
                float z = p->extent[before].z0, mine = p->extent[s].z0;
                if (z < mine || (z == mine && before < s))
                    break;
                p->order[k] = before;
            }
            p->order[k] = s;
        }
}

void painter_begin(struct painter *p, const struct scene *scene)
{
    p->scene = scene;
    p->next = p->circles = p->count = 0;
    for (int i = 0; i < scene->surfaces; i++) {
        p->moved[i] = false;
        if (scene->surface[i].plane.c == 0)
            continue;
        p->extent[i] = extent_of(scene, &scene->surface[i]);
        p->order[p->count++] = (uint16_t)i;
    }
    sort_by_depth(p);
}

/* Are all corners of `s` in front of the plane of `of` (side 1), or behind it (-1)? */
static bool all_on_side(const struct scene *scene, const struct surface *s,
                        const struct surface *of, float side)
{
    /* In front is where z is larger than the plane's. */
    float front = of->plane.c > 0 ? side : -side;
    for (int i = 0; i < s->count; i++)
        if (front * plane_value(&of->plane, scene_corner(scene, s, i)) < -touching)
            return false;
    return true;
}

/* The overlap of two outlines. */
struct overlap {
    struct vector3 corner[2 * SURFACE_CORNERS];
    int count;
};

/* How far within the side from…to a point is, times the side's length. */
static float inward(struct vector3 from, struct vector3 to, struct vector3 p)
{
    float dx = to.x - from.x, dy = to.y - from.y;
    return dx * (p.y - from.y) - dy * (p.x - from.x) - touching * (fabsf(dx) + fabsf(dy));
}

/* Keeps what is within a side. */
static void cut(struct overlap *o, struct vector3 from, struct vector3 to)
{
    struct overlap in = *o;
    o->count = 0;
    for (int i = 0; i < in.count; i++) {
        struct vector3 a = in.corner[i], b = in.corner[i + 1 < in.count ? i + 1 : 0];
        float fa = inward(from, to, a), fb = inward(from, to, b);
        if (fa > 0 && o->count < 2 * SURFACE_CORNERS)
            o->corner[o->count++] = a;
        if ((fa > 0) != (fb > 0) && o->count < 2 * SURFACE_CORNERS)
            o->corner[o->count++] =
                vector3_sum(a, vector3_times(vector3_difference(b, a), fa / (fa - fb)));
    }
}

static bool overlap_of(const struct scene *scene, const struct surface *a, const struct surface *b,
                       struct overlap *o)
{
    o->count = a->count;
    for (int i = 0; i < a->count; i++)
        o->corner[i] = scene_corner(scene, a, i);
    bool turned = b->plane.c < 0;
    for (int i = 0; i < b->count && o->count > 0; i++) {
        struct vector3 from = scene_corner(scene, b, i);
        struct vector3 to = scene_corner(scene, b, i + 1 < b->count ? i + 1 : 0);
        cut(o, turned ? to : from, turned ? from : to);
    }
    return o->count > 0;
}

/* Is p nowhere nearer than q where they overlap? Depths are linear: the overlap's corners tell. */
static bool nowhere_nearer(const struct overlap *o, const struct surface *p,
                           const struct surface *q)
{
    for (int i = 0; i < o->count; i++) {
        float x = o->corner[i].x, y = o->corner[i].y;
        if (surface_depth(p, x, y) > surface_depth(q, x, y) + touching)
            return false;
    }
    return true;
}

/* May p be painted before q? */
static bool may_precede(const struct painter *all, unsigned p, unsigned q)
{
    const struct painter_extent *a = &all->extent[p], *b = &all->extent[q];
    const struct surface *sp = &all->scene->surface[p], *sq = &all->scene->surface[q];
    struct overlap o;
    return a->x1 <= b->x0 || b->x1 <= a->x0 || a->y1 <= b->y0 || b->y1 <= a->y0 ||
           all_on_side(all->scene, sp, sq, -1) || all_on_side(all->scene, sq, sp, 1) ||
           !overlap_of(all->scene, sp, sq, &o) || nowhere_nearer(&o, sp, sq);
}

/* Moves the surface at place `from` to the front of those that are left. */
static void move_to_front(struct painter *p, int from)
{
    uint16_t s = p->order[from];
    for (int k = from; k > p->next; k--)
        p->order[k] = p->order[k - 1];
    p->order[p->next] = s;
    p->moved[s] = true;
}

/* One that must precede the first of those left and was not moved before: its place; -1: none. */
static int obstacle(struct painter *p)
{
    unsigned first = p->order[p->next];
    for (int i = p->next + 1; i < p->count; i++) {
        unsigned s = p->order[i];
        /* The list is sorted by z0 but for those that were moved, which precede all others. */
        if (p->extent[s].z0 >= p->extent[first].z1 && !p->moved[s])
            break;
        if (p->extent[s].z0 >= p->extent[first].z1 || may_precede(p, first, s))
            continue;
        if (!p->moved[s])
            return i;
        p->circles++;
    }
    return -1;
}

int painter_next(struct painter *p)
{
    if (p->next == p->count)
        return -1;
    for (int i = obstacle(p); i >= 0; i = obstacle(p))
        move_to_front(p, i);
    return p->order[p->next++];
}

void paint_surface(const struct canvas *c, const struct scene *scene, const struct surface *s)
{
    struct surface_scan row;
    surface_scan_begin(&row, scene, s, c->width, c->height);
    while (surface_scan_next(&row))
        canvas_fill(c, row.x0, row.y, row.x1 - row.x0, 1, s->colour);
}

void painter_scene(struct painter *p, const struct canvas *c, const struct scene *scene)
{
    painter_begin(p, scene);
    for (int s = painter_next(p); s >= 0; s = painter_next(p))
        paint_surface(c, scene, &scene->surface[s]);
}
