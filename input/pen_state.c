/* The light pen in a snapshot. What is worked out of figures, tube and knobs is worked out again. */
#include "input/pen_parts.h"

#include <math.h>

#define VERSION 1

/* No signal is larger, ucd: a spot at rest gives some 1e7. */
#define MOST_SIGNAL 1e12

static bool sane(double v)
{
    return v >= -MOST_SIGNAL && v <= MOST_SIGNAL; /* not when it is no number */
}

static void signal_state(double *v, struct crt_state *s)
{
    crt_state_f64(s, v);
    if (!crt_state_check(s, sane(*v), "light that a pen has seen"))
        *v = 0;
}

static void sight_state(struct inp_pen_sight *sight, int terms, struct crt_state *s)
{
    unsigned count = (unsigned)terms;
    crt_state_u64(s, &sight->t);
    if (!crt_state_check(s, sight->t < CRT_STATE_LATEST, "time of a pen"))
        sight->t = 0;
    crt_state_unsigned(s, &count, INP_PEN_TERMS);
    crt_state_check(s, count == (unsigned)terms, "phosphor before a pen");
    for (int k = 0; k < terms; k++)
        signal_state(&sight->stored[k], s);
    signal_state(&sight->fast, s);
    signal_state(&sight->slow, s);
    crt_state_bool(s, &sight->armed);
    crt_state_u64(s, &sight->pulse);
    if (!crt_state_check(s, sight->pulse < CRT_STATE_LATEST || sight->pulse == INP_NEVER,
                         "pulse of a pen"))
        sight->pulse = INP_NEVER;
}

static void knobs_state(struct crt_knobs *knobs, struct crt_state *s)
{
    crt_state_f64(s, &knobs->brightness);
    crt_state_f64(s, &knobs->contrast);
    crt_state_f64(s, &knobs->focus);
    if (!crt_state_check(s,
                         fabs(knobs->brightness) <= 1e6 && fabs(knobs->contrast) <= 1e6 &&
                             fabs(knobs->focus) <= 1e6,
                         "knobs before a pen"))
        *knobs = (struct crt_knobs){0, 1, 0};
}

void inp_pen_state(struct inp_pen *pen, struct crt_state *s)
{
    crt_state_begin(s, "PEN ", VERSION);
    knobs_state(&pen->knobs, s);
    inp_hand_state(&pen->hand, s);
    crt_state_bool(s, &pen->tip);
    sight_state(&pen->sight, pen->model.terms, s);
    crt_state_end(s);
    if (!s->loading)
        return;
    pen_model_make(pen);
    pen_settle(pen);
}
