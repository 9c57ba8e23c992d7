#include "roms/clip/cohen_sutherland.h"

void cohen_sutherland_begin(struct cohen_sutherland *k, const struct clip_window *window,
                            struct point2 a, struct point2 b)
{
    *k = (struct cohen_sutherland){
        .end = {a, b},
        .code = {clip_region(window, a), clip_region(window, b)},
        .window = *window,
        .line = {a, b},
    };
}

/* Back onto edges that it was cut at. */
static void settle(const struct clip_window *w, unsigned edges, struct point2 *p)
{
    if (edges & REGION_LEFT)
        p->x = w->x_min;
    if (edges & REGION_RIGHT)
        p->x = w->x_max;
    if (edges & REGION_BELOW)
        p->y = w->y_min;
    if (edges & REGION_ABOVE)
        p->y = w->y_max;
}

bool cohen_sutherland_next(struct cohen_sutherland *k)
{
    if ((k->code[0] & k->code[1]) != 0)
        return false;
    k->accepted = (k->code[0] | k->code[1]) == 0;
    if (k->accepted)
        return false;
    int e = k->code[0] != 0 ? 0 : 1;
    k->cut = e;
    k->edge = k->code[e] & (0u - k->code[e]); /* its lowest bit */
    k->end[e] = clip_meeting(&k->window, k->edge, k->line[e], k->line[1 - e]);
    settle(&k->window, clip_region(&k->window, k->end[e]) & k->done[e], &k->end[e]);
    k->done[e] |= k->edge;
    k->code[e] = clip_region(&k->window, k->end[e]);
    return true;
}

bool clip_cohen_sutherland(const struct clip_window *window, struct point2 *a, struct point2 *b)
{
    struct cohen_sutherland k;
    cohen_sutherland_begin(&k, window, *a, *b);
    while (cohen_sutherland_next(&k))
        ;
    if (k.accepted) {
        *a = k.end[0];
        *b = k.end[1];
    }
    return k.accepted;
}
