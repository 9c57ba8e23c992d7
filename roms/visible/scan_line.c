#include "roms/visible/scan_line.h"

#include "roms/geometry/scalar.h"

/* ---- edge table ------------------------------------------------------------------------------ */

static void enter(struct scan_line *s, int surface, struct scan_edge edge)
{
    struct scan_line_edge *e = &s->edge[s->edges];
    *e = (struct scan_line_edge){edge, (uint16_t)surface, s->row[edge.first]};
    s->row[edge.first] = (uint16_t)s->edges++;
}

void scan_line_begin(struct scan_line *s, const struct scene *scene, int width, int height)
{
    s->scene = scene;
    s->width = width;
    s->height = height < SCAN_ROWS ? height : SCAN_ROWS;
    s->y = -1;
    s->edges = s->active_count = s->flags = 0;
    for (int y = 0; y < s->height; y++)
        s->row[y] = SCAN_END;
    for (int i = 0; i < scene->surfaces; i++) {
        const struct surface *f = &scene->surface[i];
        for (int k = 0; k < f->count && f->plane.c != 0; k++) {
            struct scan_edge e = scan_edge_between(
                scene_corner(scene, f, k), scene_corner(scene, f, k + 1 < f->count ? k + 1 : 0));
            if (e.first <= e.last && e.first < s->height)
                enter(s, i, e);
        }
    }
}

/* ---- active edges ---------------------------------------------------------------------------- */

/* Takes out those that have ended, moves the others on. */
static void move_active(struct scan_line *s)
{
    int kept = 0;
    for (int i = 0; i < s->active_count; i++) {
        struct scan_edge *e = &s->edge[s->active[i]].edge;
        if (e->last < s->y)
            continue;
        e->x += e->slope;
        s->active[kept++] = s->active[i];
    }
    s->active_count = kept;
}

/* Puts the edge at place `i` where it belongs by x among those before it. */
static void sift(struct scan_line *s, int i)
{
    uint16_t number = s->active[i];
    float x = s->edge[number].edge.x;
    for (; i > 0 && s->edge[s->active[i - 1]].edge.x > x; i--)
        s->active[i] = s->active[i - 1];
    s->active[i] = number;
}

bool scan_line_next(struct scan_line *s)
{
    if (++s->y >= s->height)
        return false;
    move_active(s);
    for (unsigned e = s->row[s->y]; e != SCAN_END; e = s->edge[e].next)
        s->active[s->active_count++] = (uint16_t)e;
    for (int i = 1; i < s->active_count; i++)
        sift(s, i);
    s->at = s->x = s->flags = 0;
    return true;
}

/* ---- runs ------------------------------------------------------------------------------------ */

/* Turns a surface's flag; the list stays in the order of the scene. */
static void turn_flag(struct scan_line *s, uint16_t surface)
{
    int i = 0;
    while (i < s->flags && s->flagged[i] < surface)
        i++;
    if (i < s->flags && s->flagged[i] == surface) {
        s->flags--;
        for (; i < s->flags; i++)
            s->flagged[i] = s->flagged[i + 1];
        return;
    }
    for (int k = s->flags++; k > i; k--)
        s->flagged[k] = s->flagged[k - 1];
    s->flagged[i] = surface;
}

/* The first pixel that is not left of an edge. */
static int edge_pixel(const struct scan_line *s, int i)
{
    float x = s->edge[s->active[i]].edge.x;
    return x <= 0 ? 0 : x >= (float)s->width ? s->width : scalar_ceil(x);
}

static float depth_at(const struct scan_line *s, int surface, int x)
{
    return surface_depth(&s->scene->surface[surface], (float)x, (float)s->y);
}

static float step_of(const struct scan_line *s, int surface)
{
    const struct plane *p = &s->scene->surface[surface].plane;
    return -p->a / p->c;
}

/* The nearest of the flagged surfaces at run->x0, and the run shortened to where another one comes
 * to the front. */
static void choose_nearest(const struct scan_line *s, struct scan_run *run)
{
    run->surface = s->flagged[0];
    run->depth = depth_at(s, run->surface, run->x0);
    for (int i = 1; i < s->flags; i++) {
        float z = depth_at(s, s->flagged[i], run->x0);
        if (z > run->depth) {
            run->depth = z;
            run->surface = s->flagged[i];
        }
    }
    float step = step_of(s, run->surface);
    for (int i = 0; i < s->flags; i++) {
        float gain = step_of(s, s->flagged[i]) - step;
        float behind = run->depth - depth_at(s, s->flagged[i], run->x0);
        /* In front from the first whole x with gain·x > behind, or >= behind if it comes first. */
        if (gain <= 0 || behind >= gain * (float)(run->x1 - run->x0))
            continue;
        int x = run->x0 + scalar_ceil(behind / gain);
        if (s->flagged[i] > run->surface && gain * (float)(x - run->x0) <= behind)
            x++;
        x = x > run->x0 ? x : run->x0 + 1;
        run->x1 = x < run->x1 ? x : run->x1;
    }
}

bool scan_line_run(struct scan_line *s, struct scan_run *run)
{
    /* Flags turn at all edges that are not right of this pixel. */
    while (s->at < s->active_count && edge_pixel(s, s->at) <= s->x)
        turn_flag(s, s->edge[s->active[s->at++]].surface);
    if (s->x >= s->width)
        return false;
    int end = s->at < s->active_count ? edge_pixel(s, s->at) : s->width;
    *run = (struct scan_run){s->x, end, SURFACE_NONE, 0};
    if (s->flags == 1) {
        run->surface = s->flagged[0];
        run->depth = depth_at(s, run->surface, run->x0);
    } else if (s->flags > 1) {
        choose_nearest(s, run);
    }
    s->x = run->x1;
    return true;
}

void scan_line_scene(struct scan_line *s, const struct canvas *c, const struct scene *scene)
{
    struct scan_run run;
    scan_line_begin(s, scene, c->width, c->height);
    while (scan_line_next(s))
        while (scan_line_run(s, &run))
            if (run.surface != SURFACE_NONE)
                canvas_fill(c, run.x0, s->y, run.x1 - run.x0, 1,
                            scene->surface[run.surface].colour);
}
