/* Refresh rate against the length of the list, with the rate below which it flickers. */
#include <math.h>
#include <stdlib.h>

#include "emu/lab/sweep_length.h"

#define STEPS 400

/* Rates above so many ticks are of no interest, and would press the rest together. */
#define TICKS_SHOWN 2.0

struct curves {
    double *x, *rate[VM_TIMINGS], *locked;
};

static bool curves_alloc(struct curves *c, size_t n)
{
    c->x = calloc(n, sizeof *c->x);
    c->locked = calloc(n, sizeof *c->locked);
    bool ok = c->x && c->locked;
    for (int t = 0; t < VM_TIMINGS; t++)
        ok = (c->rate[t] = calloc(n, sizeof *c->rate[t])) && ok;
    return ok;
}

static void curves_free(struct curves *c)
{
    free(c->x);
    free(c->locked);
    for (int t = 0; t < VM_TIMINGS; t++)
        free(c->rate[t]);
}

static double top_of(const struct vm_length *l)
{
    double hz = TICKS_SHOWN * crt_rate_hz(l->steady.tick);
    return hz > 1.5 * l->steady.hz ? hz : 1.5 * l->steady.hz;
}

static void fill(const struct vm_length *l, const struct vm_growth *g, struct curves *c)
{
    double top = top_of(l);
    for (int i = 0; i < g->count; i++) {
        c->x[i] = g->row[i].amount;
        c->locked[i] = g->row[i].locked_hz;
        for (int t = 0; t < VM_TIMINGS; t++) {
            double hz = vm_steady_free_hz(g->row[i].ps[t]);
            c->rate[t][i] = hz <= top ? hz : NAN;
        }
    }
}

static void add_series(struct vm_plot_panel *p, const char *label, enum vm_plot_kind kind,
                       const double *x, const double *y, int count, int colour, bool dashed)
{
    p->series[p->series_count++] =
        (struct vm_plot_series){label, kind, x, y, (size_t)count, colour, dashed};
}

static void add_mark(struct vm_plot_panel *p, bool vertical, double at, const char *label)
{
    p->mark[p->mark_count++] = (struct vm_plot_mark){vertical, at, label};
}

/* Where it begins to flicker, along the list. */
static double end_of_steady(const struct vm_length *l, bool locked)
{
    if (locked && l->steady.ticks == 0)
        return 0;
    if (l->program.given)
        return vm_length_times(l, locked, DF_TIMING_VALUE);
    struct vm_longest most = vm_length_longest(l, l->kind);
    return (double)(locked ? most.locked : most.free)[DF_TIMING_VALUE];
}

static void add_ends(const struct vm_length *l, struct vm_plot_panel *p, char text[2][48])
{
    for (int locked = 0; locked < 2; locked++) {
        double end = end_of_steady(l, locked);
        snprintf(text[locked], sizeof text[0], l->program.given ? "%s: %.2f" : "%s: %.0f",
                 locked ? "locked" : "free", end);
        if (end > 0)
            add_mark(p, true, end, text[locked]);
    }
}

bool vm_length_draw(const struct vm_length *l, struct vm_size size, enum vm_plot_style style,
                    struct crt_image *image, struct crt_error *err)
{
    const struct vm_monitor *m = &l->settings->monitor[VM_VECTOR];
    const struct vm_steady *s = &l->steady;
    struct vm_growth g;
    struct curves c = {0};
    char title[160], below[80], x_label[112], locked[64], ends[2][48];
    if (!vm_length_growth(l, STEPS, true, &g, err))
        return false;
    struct vm_plot plot = {.title = title, .note = vm_steady_model, .panel_count = 1};
    bool ok = curves_alloc(&c, (size_t)g.count) ||
              crt_fail(err, "not enough memory for the plot; close other programs");
    if (ok) {
        fill(l, &g, &c);
        snprintf(title, sizeof title,
                 "%s with %s, %.3g cd/m² at %.4g Hz: how long may the display list be?",
                 m->row.name, m->phosphor.name, s->cd_m2, s->at_hz);
        snprintf(below, sizeof below, "below %.1f Hz it flickers (field of %.0f°)", s->hz,
                 crt_fields_deg[s->viewer.field]);
        snprintf(x_label, sizeof x_label, "%s%s", l->program.given ? "" : "number of ", g.label);
        snprintf(locked, sizeof locked, "locked to the tick of %.4g Hz", crt_rate_hz(s->tick));
        plot.x = (struct vm_plot_axis){x_label, false, 0, c.x[g.count - 1]};
        struct vm_plot_panel *p = &plot.panel[0];
        p->y = (struct vm_plot_axis){"refresh rate, Hz", false, 0, top_of(l)};
        add_series(p, "free running", VM_PLOT_LINE, c.x, c.rate[DF_TIMING_VALUE], g.count, 0,
                   false);
        add_series(p, "the same, range of the tube's times", VM_PLOT_LINE, c.x,
                   c.rate[DF_TIMING_LOW], g.count, 0, true);
        add_series(p, NULL, VM_PLOT_LINE, c.x, c.rate[DF_TIMING_HIGH], g.count, 0, true);
        add_series(p, locked, VM_PLOT_STEPS, c.x, c.locked, g.count, 1, false);
        if (s->hz > VM_STEADY_LEAST_HZ) {
            add_mark(p, false, s->hz, below);
            add_ends(l, p, ends);
        }
        ok = vm_plot_draw(&plot, size, style, image, err);
    }
    curves_free(&c);
    free(g.row);
    return ok;
}
