#include "input/pen_parts.h"

#include <math.h>

#include "crt/maths.h"
#include "input/noise.h"

#define TWO_PI 6.28318530717958648
#define EXACT  2.5e-7 /* us to which a crossing is found */
#define TRIES  64     /* of a bisection: more than enough for any stretch */

/* A stretch of constant noise: V + stir against the threshold. */
struct stretch {
    const struct pen_course *course;
    double a, b, stir; /* us */
};

double pen_stir_of(const struct inp_pen *pen, uint64_t cell)
{
    const struct inp_pen_model *m = &pen->model;
    double stir = 0;
    if (m->sigma > 0)
        stir = m->sigma * inp_noise_normal(pen->desc.seed, cell);
    if (m->ripple > 0) {
        double turns = ((double)cell + 0.5) * (double)m->cell * m->lamp;
        stir += m->ripple * crt_sin(TWO_PI * (turns - floor(turns)));
    }
    return stir;
}

/* ---- crossings ---------------------------------------------------------------------------------- */

/* sign·V has come from below sign·level at a to above it at b: when, just above. */
static double cross(const struct pen_course *course, double a, double b, double level, double sign)
{
    for (int i = 0; i < TRIES && b - a > EXACT; i++) {
        double middle = a + (b - a) / 2;
        if (sign * (pen_course_at(course, middle) - level) >= 0)
            b = middle;
        else
            a = middle;
    }
    return b;
}

/* sign·V rises at a and falls at b: the summit between. */
static double summit(const struct pen_course *course, double a, double b, double sign)
{
    for (int i = 0; i < TRIES && b - a > EXACT; i++) {
        double middle = a + (b - a) / 2;
        if (sign * pen_course_slope(course, middle) > 0)
            a = middle;
        else
            b = middle;
    }
    return a;
}

/* When in [a, b] sign·V first reaches sign·level; below 0: never. */
static double reaches(const struct stretch *s, double level, double sign)
{
    if (sign * (pen_course_at(s->course, s->a) - level) >= 0)
        return s->a;
    if (sign * (pen_course_at(s->course, s->b) - level) >= 0)
        return cross(s->course, s->a, s->b, level, sign);
    if (sign * pen_course_slope(s->course, s->a) <= 0 ||
        sign * pen_course_slope(s->course, s->b) >= 0)
        return -1;
    double top = summit(s->course, s->a, s->b, sign);
    if (sign * (pen_course_at(s->course, top) - level) >= 0)
        return cross(s->course, s->a, top, level, sign);
    return -1;
}

/* One pulse at a time: what comes while one is on its way or stands makes no other. */
static void fire(const struct inp_pen_model *m, struct inp_pen_sight *sight, double us)
{
    uint64_t when = sight->t + (uint64_t)ceil(us * 1e6);
    sight->armed = false;
    if (sight->pulse == INP_NEVER || (!m->raster && when > sight->pulse + m->hold))
        sight->pulse = when + m->delay;
}

/* The comparator within a stretch, which has room for a dip and a summit. */
static void compare(const struct inp_pen_model *m, struct inp_pen_sight *sight, struct stretch s)
{
    for (int turn = 0; turn < 4; turn++) {
        double level = sight->armed ? m->threshold : m->threshold / 2;
        double at = reaches(&s, level - s.stir, sight->armed ? 1 : -1);
        if (at < 0)
            return;
        if (sight->armed)
            fire(m, sight, at);
        else
            sight->armed = true;
        s.a = at;
    }
}

/* ---- going on in time --------------------------------------------------------------------------- */

/* Whether with noise between `least` and `most` nothing can happen but that it is armed. */
static bool idle(const struct inp_pen_model *m, struct inp_pen_sight *sight,
                 const struct pen_bounds *v, double least, double most)
{
    if (v->high + most < m->threshold / 2)
        sight->armed = true;
    return sight->armed ? v->high + most < m->threshold : v->low + least >= m->threshold / 2;
}

static void search(const struct inp_pen *pen, struct inp_pen_sight *sight,
                   const struct pen_course *course, uint64_t span, bool first)
{
    const struct inp_pen_model *m = &pen->model;
    const struct pen_bounds v = pen_course_between(course, (double)span * 1e-6);
    if (idle(m, sight, &v, -m->stir, m->stir))
        return;
    for (uint64_t at = 0; at < span && !(first && sight->pulse != INP_NEVER);) {
        uint64_t end = span;
        double stir = 0;
        if (m->stir > 0) {
            uint64_t cell = (sight->t + at) / m->cell, left = (cell + 1) * m->cell - sight->t;
            end = left < span ? left : span;
            stir = pen_stir_of(pen, cell);
        }
        if (!idle(m, sight, &v, stir, stir))
            compare(m, sight,
                    (struct stretch){course, (double)at * 1e-6, (double)end * 1e-6, stir});
        at = end;
    }
}

/* In spans that grow from a fraction of the detector's time constant, so that the signal turns but once
 * in each: what is fast in it is over soon. */
void pen_run(const struct inp_pen *pen, struct inp_pen_sight *sight, struct pen_input input,
             uint64_t until, bool first)
{
    const struct inp_pen_model *m = &pen->model;
    struct pen_course course;
    for (uint64_t span = m->cell / 4 + 1; sight->t < until; span += span) {
        uint64_t left = until - sight->t;
        pen_course_begin(&course, m, sight, &input);
        struct pen_bounds v = pen_course_within(&course, (double)left * 1e-6);
        if (!idle(m, sight, &v, -m->stir, m->stir)) {
            left = span < left ? span : left;
            search(pen, sight, &course, left, first);
            if (first && sight->pulse != INP_NEVER)
                return;
        }
        pen_course_end(&course, sight, left);
        for (int c = 0; c < CRT_MAX_COLOURS; c++)
            input.power[c] += input.slope[c] * ((double)left * 1e-6);
    }
}

static const struct pen_input no_light;

void pen_dark(const struct inp_pen *pen, struct inp_pen_sight *sight, uint64_t until)
{
    const struct inp_pen_model *m = &pen->model;
    /* Of the vector head older pulses are lost; of the raster head nobody asked for them. */
    uint64_t memory = m->raster ? UINT64_C(2000000000) : m->delay + m->hold;
    if (sight->t >= until)
        return;
    if (m->stir > 0 && until - sight->t > memory && sight->pulse == INP_NEVER) {
        struct pen_course course;
        pen_course_begin(&course, m, sight, &no_light);
        struct pen_bounds v = pen_course_within(&course, HUGE_VAL);
        if (!idle(m, sight, &v, -m->stir, m->stir)) {
            pen_course_end(&course, sight, until - memory - sight->t);
            double now = sight->fast - sight->slow;
            sight->armed = now < m->threshold / 2 || (sight->armed && now < m->threshold);
        }
    }
    pen_run(pen, sight, no_light, until, false);
}

bool pen_is_quiet(const struct inp_pen *pen, const struct inp_pen_sight *sight)
{
    struct pen_course course;
    pen_course_begin(&course, &pen->model, sight, &no_light);
    return sight->pulse == INP_NEVER &&
           pen_course_within(&course, HUGE_VAL).high + pen->model.stir < pen->model.threshold;
}
