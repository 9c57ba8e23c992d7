#include "roms/clip/liang_barsky.h"

#include "roms/geometry/scalar.h"

void liang_barsky_begin(struct liang_barsky *k, const struct clip_window *w, struct point2 a,
                        struct point2 b)
{
    float dx = b.x - a.x, dy = b.y - a.y;
    *k =
        (struct liang_barsky){.p = {-dx, dx, -dy, dy},
                              .q = {a.x - w->x_min, w->x_max - a.x, a.y - w->y_min, w->y_max - a.y},
                              .t1 = 0,
                              .t2 = 1,
                              .left = true};
}

/* Narrows t1…t2 by one edge; false: nothing is left. */
static bool narrow(float p, float q, float *t1, float *t2)
{
    if (p == 0)
        return q >= 0;
    float t = q / p;
    if (p < 0)
        *t1 = t > *t1 ? t : *t1;
    else
        *t2 = t < *t2 ? t : *t2;
    return *t1 <= *t2;
}

bool liang_barsky_next(struct liang_barsky *k)
{
    if (k->edges == 4 || !k->left)
        return false;
    k->left = narrow(k->p[k->edges], k->q[k->edges], &k->t1, &k->t2);
    k->edges++;
    return true;
}

/* Far ends make steps of t coarse: what lies a little beyond an edge belongs onto it. */
static struct point2 onto_window(const struct clip_window *w, float x, float y)
{
    return (struct point2){scalar_clamp(x, w->x_min, w->x_max),
                           scalar_clamp(y, w->y_min, w->y_max)};
}

bool clip_liang_barsky_shown(const struct clip_window *w, struct point2 *a, struct point2 *b,
                             struct liang_barsky *k)
{
    liang_barsky_begin(k, w, *a, *b);
    while (liang_barsky_next(k))
        ;
    if (!k->left)
        return false;
    float dx = k->p[1], dy = k->p[3];
    if (k->t2 < 1)
        *b = onto_window(w, a->x + k->t2 * dx, a->y + k->t2 * dy);
    if (k->t1 > 0)
        *a = onto_window(w, a->x + k->t1 * dx, a->y + k->t1 * dy);
    return true;
}

bool clip_liang_barsky(const struct clip_window *w, struct point2 *a, struct point2 *b)
{
    struct liang_barsky working;
    return clip_liang_barsky_shown(w, a, b, &working);
}
