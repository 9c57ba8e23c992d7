#include "roms/commands/plane_picture.h"

#include <math.h>
#include <stdio.h>

#include "roms/monitor/print.h"

enum { LETTERED_MOST = 12 };

struct plane_figure plane_figure_default(void)
{
    return (struct plane_figure){
        .corner = {{1, 1}, {2, 1}, {2, 3}, {3, 3}, {3, 4}, {2, 4}, {2, 5}, {4, 5}, {4, 6}, {1, 6}},
        .count = 10};
}

struct plane_figure plane_figure_image(const struct plane_figure *f, const struct matrix3 *m)
{
    struct plane_figure image = {.count = f->count};
    for (int i = 0; i < f->count; i++)
        image.corner[i] = matrix3_apply(m, f->corner[i]);
    return image;
}

bool plane_figure_sane(const struct plane_figure *f)
{
    for (int i = 0; i < f->count; i++)
        if (!(fabsf(f->corner[i].x) <= 1e9f && fabsf(f->corner[i].y) <= 1e9f))
            return false;
    return true;
}

void plane_figure_print(const struct plane_figure *before, const struct plane_figure *after)
{
    for (int i = 0; i < before->count; i++) {
        print_point2(before->corner[i]);
        printf(" -> ");
        print_point2(after->corner[i]);
        printf("\n");
    }
}

/* Twice the area of a triangle, with its sign. */
static float turn(struct point2 a, struct point2 b, struct point2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/* Four corners that were given row by row cross themselves: 0 1 3 2 goes round. */
static bool crosses(const struct plane_figure *f)
{
    const struct point2 *p = f->corner;
    return f->count == 4 && turn(p[1], p[2], p[0]) * turn(p[1], p[2], p[3]) < 0 &&
           turn(p[3], p[0], p[1]) * turn(p[3], p[0], p[2]) < 0;
}

static void letters(const struct graph *g, const struct plane_figure *f, const char *mark)
{
    for (int i = 0; i < f->count && f->count <= LETTERED_MOST; i++) {
        char text[8];
        snprintf(text, sizeof text, "%c%s", 'A' + i, mark);
        graph_text(g, f->corner[i], text);
    }
}

void plane_picture_figure(const struct graph *g, const struct plane_figure *f, enum ink ink,
                          bool filled, const char *mark)
{
    struct point2 placed[FLAT_POINTS];
    for (int i = 0; i < f->count; i++)
        placed[i] = graph_place(g, f->corner[i]);
    if (crosses(f)) {
        struct point2 third = placed[2];
        placed[2] = placed[3];
        placed[3] = third;
    }
    stage_ink(g->stage, ink);
    if (filled && f->count > 2)
        stage_area(g->stage, placed, f->count);
    stage_polygon(g->stage, placed, f->count);
    stage_ink(g->stage, INK_BRIGHT);
    for (int i = 0; i < f->count && f->count <= LETTERED_MOST; i++)
        graph_marker(g, f->corner[i]);
    letters(g, f, mark);
}

void plane_picture_both(struct monitor *m, const struct plane_figure *before,
                        const struct plane_figure *after)
{
    struct point2 all[2 * FLAT_POINTS + 1] = {{0, 0}};
    for (int i = 0; i < before->count; i++) {
        all[1 + i] = before->corner[i];
        all[1 + before->count + i] = after->corner[i];
    }
    struct graph g = graph_whole(&m->stage, all, 2 * before->count + 1);
    graph_axes(&g);
    plane_picture_figure(&g, after, INK_ORANGE, true, "'");
    plane_picture_figure(&g, before, INK_CYAN, false, "");
}

void plane_picture_rectangle(const struct graph *g, const struct clip_window *w, enum ink ink)
{
    const struct point2 corners[] = {
        {w->x_min, w->y_min}, {w->x_max, w->y_min}, {w->x_max, w->y_max}, {w->x_min, w->y_max}};
    stage_ink(g->stage, ink);
    graph_polygon(g, corners, 4);
}
