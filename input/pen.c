#include "input/pen.h"

#include <math.h>
#include <string.h>

#include "input/pen_parts.h"

/* A stroke that is cut where the pulse arrives has its end rounded, in time and place: a pulse that is
 * late by no more than that has arrived by its end. */
#define ROUND_PS 1000.0
#define ROUND_MM 1e-4

/* How far a look for noise goes; a pulse that was not taken for so long, as the pen was elsewhere, is over. */
#define LOOK_AHEAD UINT64_C(1000000000) /* 1 ms */

static const struct pen_input no_light;

/* ---- what follows from the state ---------------------------------------------------------------- */

/* After each change. */
void pen_settle(struct inp_pen *pen)
{
    pen->quiet = pen_is_quiet(pen, &pen->sight);
    pen->wake = INP_NEVER;
    if (!pen->model.raster || pen->quiet || pen->sight.pulse != INP_NEVER)
        return;
    struct inp_pen_sight ahead = pen->sight;
    pen_run(pen, &ahead, no_light, ahead.t + LOOK_AHEAD, true);
    if (!pen_is_quiet(pen, &ahead))
        pen->wake = ahead.pulse != INP_NEVER ? ahead.pulse : ahead.t;
}

void inp_pen_init(struct inp_pen *pen, const struct inp_pen_desc *desc)
{
    *pen = (struct inp_pen){.desc = *desc, .knobs = desc->knobs};
    pen_model_make(pen);
    inp_pen_reset(pen, 0);
}

void inp_pen_reset(struct inp_pen *pen, uint64_t t)
{
    pen->sight = (struct inp_pen_sight){.t = t, .armed = true, .pulse = INP_NEVER};
    pen_settle(pen);
}

static bool within(double a, double b, double half)
{
    return fmin(a, b) < half && fmax(a, b) > -half;
}

bool inp_pen_looks(const struct inp_pen *pen)
{
    const struct crt_tube_row *row = pen->desc.row;
    const struct inp_hand *hand = &pen->hand;
    double more = row->border.value + pen->model.radius;
    return hand->there && within(hand->from.x, hand->to.x, row->width.value / 2 + more) &&
           within(hand->from.y, hand->to.y, row->height.value / 2 + more);
}

/* ---- strokes ------------------------------------------------------------------------------------ */

static void drop_old(const struct inp_pen_model *m, struct inp_pen_sight *sight, uint64_t t)
{
    if (sight->pulse != INP_NEVER && sight->pulse + m->hold < t)
        sight->pulse = INP_NEVER;
}

static double rounding(const struct crt_stroke *s)
{
    double dx = (double)s->x1 - (double)s->x0, dy = (double)s->y1 - (double)s->y0;
    double span = (double)(s->t1 - s->t0), length = sqrt(dx * dx + dy * dy);
    return ROUND_PS + (length > ROUND_MM ? span * (ROUND_MM / length) : 0);
}

/* Were it to go on for so much longer, would it fire? */
static void see_end(const struct inp_pen *pen, struct inp_pen_sight *sight, double late)
{
    const struct inp_pen_model *m = &pen->model;
    if (!sight->armed || sight->pulse != INP_NEVER || (double)m->delay > late)
        return;
    double light = 0;
    for (int k = 0; k < m->terms; k++)
        light += sight->stored[k];
    double v = sight->fast - sight->slow;
    double slope = (light - sight->fast) / m->response - v / m->couple;
    double end = v + fmax(slope, 0) * (late - (double)m->delay) * 1e-6;
    if (end + pen_stir_of(pen, sight->t / m->cell) >= m->threshold) {
        sight->armed = false;
        sight->pulse = sight->t;
    }
}

/* Sees a stroke drawn; the pulse that arrives during it. */
static uint64_t see(const struct inp_pen *pen, struct inp_pen_sight *sight,
                    const struct crt_stroke *s, bool first)
{
    const struct inp_pen_model *m = &pen->model;
    double late = rounding(s);
    drop_old(m, sight, s->t0);
    pen_dark(pen, sight, s->t0);
    drop_old(m, sight, s->t0);
    if (!(first && sight->pulse <= s->t1)) {
        if (pen_far_stroke(pen, s))
            pen_run(pen, sight, no_light, s->t1, first);
        else
            pen_light_stroke(pen, sight, s, first);
        see_end(pen, sight, late);
    }
    if (sight->pulse == INP_NEVER)
        return INP_NEVER;
    if (sight->pulse > s->t1 && (double)(sight->pulse - s->t1) > late)
        return INP_NEVER;
    if (sight->pulse < s->t0)
        return s->t0;
    return sight->pulse < s->t1 ? sight->pulse : s->t1;
}

uint64_t inp_pen_offer(const struct inp_pen *pen, const struct crt_stroke *stroke)
{
    if (pen->quiet && pen_far_stroke(pen, stroke))
        return INP_NEVER;
    struct inp_pen_sight sight = pen->sight;
    return see(pen, &sight, stroke, true);
}

bool inp_pen_stroke(struct inp_pen *pen, const struct crt_stroke *stroke, uint64_t *when)
{
    if (pen->quiet && pen_far_stroke(pen, stroke))
        return false;
    uint64_t pulse = see(pen, &pen->sight, stroke, false);
    if (pulse != INP_NEVER) {
        *when = pulse;
        pen->sight.pulse = INP_NEVER;
    }
    pen_settle(pen);
    return pulse != INP_NEVER;
}

/* ---- scan lines --------------------------------------------------------------------------------- */

void inp_pen_line(struct inp_pen *pen, const struct crt_scan_line *line)
{
    if (pen_far_line(pen, line))
        return;
    pen_dark(pen, &pen->sight, line->t0);
    pen_light_line(pen, &pen->sight, line);
    pen_settle(pen);
}

uint64_t inp_pen_next(const struct inp_pen *pen)
{
    if (!pen->model.raster)
        return INP_NEVER;
    if (pen->sight.pulse != INP_NEVER)
        return pen->sight.pulse;
    return inp_pen_looks(pen) ? pen->wake : INP_NEVER;
}

bool inp_pen_event(struct inp_pen *pen, uint64_t t)
{
    if (!pen->model.raster)
        return false;
    if (pen->sight.pulse == INP_NEVER)
        pen_dark(pen, &pen->sight, t + 1); /* t itself, too */
    uint64_t pulse = pen->sight.pulse;
    if (pulse <= t)
        pen->sight.pulse = INP_NEVER;
    pen_settle(pen);
    return pulse <= t && t - pulse <= LOOK_AHEAD;
}

void inp_pen_set_knobs(struct inp_pen *pen, struct crt_knobs knobs)
{
    pen->knobs = knobs;
    pen_model_make(pen);
}
