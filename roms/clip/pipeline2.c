#include "roms/clip/pipeline2.h"

#include "roms/clip/liang_barsky.h"
#include "roms/clip/window_viewport.h"

bool pipeline2_begin(struct pipeline2 *p, const struct view2 *v)
{
    static const struct clip_window unit = {0, 0, 1, 1};
    struct pipeline2 made = {.viewport = v->viewport};
    if (!view_frame(v->origin, v->up, &made.view) ||
        !window_to_viewport(&v->window, &v->viewport, &made.normalize) ||
        !window_to_viewport(&unit, &v->device, &made.device))
        return false;
    struct matrix3 same = matrix3_identity();
    *p = made;
    pipeline2_model(p, &same);
    return true;
}

void pipeline2_model(struct pipeline2 *p, const struct matrix3 *model)
{
    p->model = *model;
    struct matrix3 to_view = matrix3_product(&p->view, &p->model);
    p->before = matrix3_product(&p->normalize, &to_view);
    p->whole = matrix3_product(&p->device, &p->before);
}

bool pipeline2_point(const struct pipeline2 *p, struct point2 *at)
{
    struct point2 normal = matrix3_apply(&p->before, *at);
    if (!clip_point(&p->viewport, normal))
        return false;
    *at = matrix3_apply(&p->device, normal);
    return true;
}

bool pipeline2_line(const struct pipeline2 *p, struct point2 *a, struct point2 *b)
{
    struct point2 from = matrix3_apply(&p->before, *a), to = matrix3_apply(&p->before, *b);
    if (!clip_liang_barsky(&p->viewport, &from, &to))
        return false;
    *a = matrix3_apply(&p->device, from);
    *b = matrix3_apply(&p->device, to);
    return true;
}

void pipeline2_polyline(const struct pipeline2 *p, const struct point2 *points, int count,
                        void (*line)(void *ctx, struct point2 a, struct point2 b), void *ctx)
{
    struct point2 before = {0, 0};
    for (int i = 0; i < count; i++) {
        struct point2 now = matrix3_apply(&p->before, points[i]), a = before, b = now;
        if (i > 0 && clip_liang_barsky(&p->viewport, &a, &b))
            line(ctx, matrix3_apply(&p->device, a), matrix3_apply(&p->device, b));
        before = now;
    }
}

int pipeline2_polygon(const struct pipeline2 *p, const struct point2 *corners, int count,
                      struct sutherland_hodgman *work)
{
    struct point2 normal[CLIP_POLYGON_MOST];
    if (count < 1 || count > CLIP_POLYGON_MOST)
        return 0;
    for (int i = 0; i < count; i++)
        normal[i] = matrix3_apply(&p->before, corners[i]);
    clip_sutherland_hodgman(work, &p->viewport, normal, count);
    for (int i = 0; i < work->count; i++)
        work->corner[i] = matrix3_apply(&p->device, work->corner[i]);
    return work->count;
}
