#include "emu/plot/curve.h"

#include <math.h>

/* ---- samples of one pixel column ----------------------------------------------------------------- */

struct point {
    double x, y;
};

/* Takes points one by one and hands on at most four of those that fall into one column. */
struct column {
    struct vm_ink *ink;
    struct vm_ink_pen pen;
    double base; /* of areas */
    bool area;
    struct point before; /* areas: handed on last */
    bool any_before;
    double at; /* which column */
    long count, least_n, most_n;
    struct point first, last, least, most;
};

static void hand_on(struct column *c, struct point p)
{
    if (!c->area) {
        vm_ink_to(c->ink, &c->pen, p.x, p.y);
        return;
    }
    if (c->any_before)
        vm_ink_area(c->ink, c->before.x, c->before.y, p.x, p.y, c->base);
    c->before = p;
    c->any_before = true;
}

static void flush(struct column *c)
{
    if (c->count > 0)
        hand_on(c, c->first);
    struct point a = c->least, b = c->most;
    if (c->most_n < c->least_n) {
        a = c->most;
        b = c->least;
    }
    if (c->count > 2) {
        hand_on(c, a);
        hand_on(c, b);
    }
    if (c->count > 1)
        hand_on(c, c->last);
    c->count = 0;
}

static void gap(struct column *c)
{
    /* A sample between gaps is a dot. */
    bool alone = c->count == 1 && !c->pen.down && !c->area;
    flush(c);
    if (alone)
        vm_ink_segment(c->ink, c->pen.x, c->pen.y, c->pen.x, c->pen.y, c->pen.width);
    vm_ink_lift(&c->pen);
    c->any_before = false;
}

static void take(struct column *c, double x, double y)
{
    struct point p = {x, y};
    if (isnan(x) || isnan(y)) {
        gap(c);
        return;
    }
    if (c->count > 0 && floor(x) != c->at)
        flush(c);
    c->at = floor(x);
    if (c->count == 0 || y < c->least.y) {
        c->least = p;
        c->least_n = c->count;
    }
    if (c->count == 0 || y > c->most.y) {
        c->most = p;
        c->most_n = c->count;
    }
    if (c->count == 0)
        c->first = p;
    c->last = p;
    c->count++;
}

/* ---- kinds of series ------------------------------------------------------------------------------ */

/* Where impulses and areas start: at 0, or at the edge of the panel next to it. */
static double base_of(const struct vm_scale *y)
{
    double base = y->log ? y->from : vm_scale_place(y, 0);
    double low = fmin(y->from, y->to), high = fmax(y->from, y->to);
    return fmin(fmax(base, low), high);
}

static void line(struct column *c, const struct vm_plot_series *s, const struct vm_scale *x,
                 const struct vm_scale *y)
{
    double before = (double)NAN;
    for (size_t i = 0; i < s->count; i++) {
        double px = vm_scale_place(x, s->x[i]), py = vm_scale_place(y, s->y[i]);
        if (s->kind == VM_PLOT_STEPS && !isnan(before) && !isnan(px))
            take(c, px, before);
        take(c, px, py);
        before = isnan(px) ? px : py;
    }
    gap(c);
}

static void dots(struct vm_ink *ink, const struct vm_plot_series *s, const struct vm_scale *x,
                 const struct vm_scale *y, double width)
{
    double last_x = 1e30, last_y = 1e30;
    for (size_t i = 0; i < s->count; i++) {
        double px = vm_scale_place(x, s->x[i]), py = vm_scale_place(y, s->y[i]);
        if (fabs(px - last_x) < 0.05 && fabs(py - last_y) < 0.05)
            continue;
        vm_ink_segment(ink, px, py, px, py, width);
        last_x = px;
        last_y = py;
    }
}

/* Neighbours in one column share one stroke from the least to the greatest. */
static void impulses(struct vm_ink *ink, const struct vm_plot_series *s, const struct vm_scale *x,
                     const struct vm_scale *y, double width)
{
    double base = base_of(y), at = (double)NAN, top = base, bottom = base;
    for (size_t i = 0; i < s->count; i++) {
        double px = vm_scale_place(x, s->x[i]), py = vm_scale_place(y, s->y[i]);
        if (isnan(px) || isnan(py))
            continue;
        if (!isnan(at) && fabs(px - at) >= 0.25) {
            vm_ink_segment(ink, at, top, at, bottom, width);
            top = bottom = base;
            at = px;
        }
        at = isnan(at) ? px : at;
        top = fmin(top, py);
        bottom = fmax(bottom, py);
    }
    if (!isnan(at))
        vm_ink_segment(ink, at, top, at, bottom, width);
}

struct vm_ink_pen vm_curve_pen(double width, int dash)
{
    static const double on[4] = {4, 1.6, 7, 2.5}, off[4] = {2.8, 2.4, 3, 3.5};
    struct vm_ink_pen pen = {.width = width};
    if (dash > 0) {
        pen.on = on[(dash - 1) % 4] * width;
        pen.off = off[(dash - 1) % 4] * width;
    }
    return pen;
}

void vm_curve_cover(struct vm_ink *ink, const struct vm_plot_series *series,
                    const struct vm_scale *x, const struct vm_scale *y, double width, int dash)
{
    if (series->kind == VM_PLOT_DOTS) {
        dots(ink, series, x, y, width * 2.6);
    } else if (series->kind == VM_PLOT_IMPULSES) {
        impulses(ink, series, x, y, width);
    } else {
        struct column c = {.ink = ink, .pen = vm_curve_pen(width, dash)};
        line(&c, series, x, y);
    }
}

void vm_curve_cover_area(struct vm_ink *ink, const struct vm_plot_series *series,
                         const struct vm_scale *x, const struct vm_scale *y)
{
    struct column c = {.ink = ink, .area = true, .base = base_of(y)};
    line(&c, series, x, y);
}
