#include "emu/plot/axis.h"

#include <float.h>
#include <math.h>

#include "crt/maths.h"

/* Automatic logarithmic axes show no more below the greatest; estimate of what is of interest. */
#define DECADES 1e8
/* Places are cut to this; drawing cuts finer. */
#define FAR 1e8
/* A range smaller than this share of its ends is widened: labels of more digits say nothing. */
#define NARROW 1e-9

struct range {
    double low, high;
    bool any;
};

static void widen(struct range *r, double v, bool log)
{
    if (!isfinite(v) || (log && !(v > 0)) || fabs(v) > 1e300)
        return;
    r->low = !r->any || v < r->low ? v : r->low;
    r->high = !r->any || v > r->high ? v : r->high;
    r->any = true;
}

static bool given(const struct vm_plot_axis *axis)
{
    return isfinite(axis->low) && isfinite(axis->high) && axis->low < axis->high &&
           fabs(axis->low) <= 1e300 && fabs(axis->high) <= 1e300 && (!axis->log || axis->low > 0);
}

/* The scale has a low end below its high end, by more than the last digits. */
static void settle(struct vm_scale *s, struct range r, bool log)
{
    double size = fmax(fabs(r.low), fabs(r.high));
    s->log = log;
    s->low = r.low;
    s->high = r.high;
    if (log) {
        s->low = fmax(s->low, 1e-300);
        if (!(s->high > s->low * (1 + NARROW))) {
            s->low /= 2;
            s->high *= 2;
        }
    } else if (size < 1e-290) {
        s->low = 0;
        s->high = 1;
    } else if (!(s->high - s->low > NARROW * size)) {
        s->low -= size / 2;
        s->high += size / 2;
    }
    s->a = log ? crt_log(s->low) : s->low;
    s->b = log ? crt_log(s->high) : s->high;
}

/* Whether there are dots or impulses, half of which an edge at the data would cut off. */
static bool stands_alone(const struct vm_plot *plot)
{
    for (int p = 0; p < plot->panel_count; p++)
        for (int i = 0; i < plot->panel[p].series_count; i++)
            if (plot->panel[p].series[i].kind == VM_PLOT_DOTS ||
                plot->panel[p].series[i].kind == VM_PLOT_IMPULSES)
                return true;
    return false;
}

static void beside(struct range *r, bool log)
{
    double margin =
        log ? crt_exp((crt_log(r->high) - crt_log(r->low)) * 0.03) : (r->high - r->low) * 0.03;
    r->low = log ? r->low / margin : r->low - margin;
    r->high = log ? r->high * margin : r->high + margin;
}

bool vm_scale_x(struct vm_scale *scale, const struct vm_plot *plot)
{
    struct range r = {0, 1, false};
    if (given(&plot->x)) {
        r = (struct range){plot->x.low, plot->x.high, true};
    } else {
        for (int p = 0; p < plot->panel_count; p++)
            for (int i = 0; i < plot->panel[p].series_count; i++)
                for (size_t n = 0; n < plot->panel[p].series[i].count; n++)
                    widen(&r, plot->panel[p].series[i].x[n], plot->x.log);
        if (r.any && stands_alone(plot))
            beside(&r, plot->x.log);
        if (!r.any && plot->x.log)
            r = (struct range){1, 10, false};
    }
    settle(scale, r, plot->x.log);
    return r.any;
}

/* Room above and below the data, and 0 where it is near. */
static void pad(struct range *r, bool log, bool from_zero)
{
    if (log) {
        r->low = fmax(r->low, r->high / DECADES);
        double margin = crt_exp((crt_log(r->high) - crt_log(r->low)) * 0.05);
        r->low /= margin;
        r->high *= margin;
        return;
    }
    if (from_zero || (r->low > 0 && r->low < 0.4 * r->high))
        r->low = fmin(r->low, 0);
    if (from_zero || (r->high < 0 && r->high > 0.4 * r->low))
        r->high = fmax(r->high, 0);
    double margin = (r->high - r->low) * 0.06;
    r->high += r->high != 0 ? margin : 0;
    r->low -= r->low != 0 ? margin : 0;
}

bool vm_scale_y(struct vm_scale *scale, const struct vm_plot_panel *panel)
{
    struct range r = {0, 1, false};
    if (given(&panel->y)) {
        r = (struct range){panel->y.low, panel->y.high, true};
        settle(scale, r, panel->y.log);
        return true;
    }
    bool from_zero = false;
    for (int i = 0; i < panel->series_count; i++) {
        const struct vm_plot_series *s = &panel->series[i];
        from_zero = from_zero || s->kind == VM_PLOT_IMPULSES || s->kind == VM_PLOT_AREA;
        for (size_t n = 0; n < s->count; n++)
            widen(&r, s->y[n], panel->y.log);
    }
    for (int i = 0; i < panel->mark_count && r.any; i++)
        if (!panel->mark[i].vertical)
            widen(&r, panel->mark[i].at, panel->y.log);
    if (!r.any && panel->y.log)
        r = (struct range){1, 10, false};
    if (r.any)
        pad(&r, panel->y.log, from_zero);
    settle(scale, r, panel->y.log);
    return r.any;
}

double vm_scale_place(const struct vm_scale *s, double value)
{
    if (!isfinite(value) || (s->log && !(value > 0)))
        return (double)NAN;
    double v = s->log ? crt_log(value) : value;
    /* Halves, so that the difference of the largest numbers is finite. */
    double share = (v / 2 - s->a / 2) / (s->b / 2 - s->a / 2),
           place = s->from + share * (s->to - s->from);
    return fmin(fmax(place, -FAR), FAR);
}
