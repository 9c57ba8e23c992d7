#include "input/pen_parts.h"

#include <math.h>

#include "crt/maths.h"

#define APART 1e-5

/* tau·(1 − e^(−t/tau)) */
static double grown(double tau, double t)
{
    double part = t / tau;
    if (part < 0.01) /* Taylor, to 2e-15 */
        return t *
               (1 - part / 2 * (1 - part / 3 * (1 - part / 4 * (1 - part / 5 * (1 - part / 6)))));
    return -tau * crt_expm1(-part);
}

static double away_from(double tau, const double *others, int count)
{
    for (int tries = 0; tries <= count; tries++) {
        bool near = false;
        for (int i = 0; i < count; i++)
            near = near || fabs(tau - others[i]) < APART * others[i];
        if (!near)
            break;
        tau *= 1 + 2 * APART;
    }
    return tau;
}

void pen_signal_part(struct inp_pen_model *model)
{
    double others[INP_PEN_TERMS + 1];
    for (int k = 0; k < model->terms; k++)
        others[k] = model->tau[k];
    model->response = away_from(model->response, others, model->terms);
    others[model->terms] = model->response;
    model->couple = away_from(model->couple, others, model->terms + 1);
}

/* Each stage divides what the one before gives by how far its time constant is from the pole's. */
void pen_course_begin(struct pen_course *course, const struct inp_pen_model *model,
                      const struct inp_pen_sight *sight, const struct pen_input *input)
{
    const int n = model->terms;
    const double td = model->response, tc = model->couple;
    double light = 0, detector = 0, falls = 0;

    course->poles = n + 2;
    course->start = sight->fast - sight->slow;
    course->fast_rise = 0;
    for (int k = 0; k < n; k++) {
        double tau = model->tau[k], stored = sight->stored[k];
        double power = model->gain[k] * input->power[model->colour[k]];
        double slope = model->gain[k] * input->slope[model->colour[k]];
        double back = (stored - power) / tau + slope;
        light += stored;
        detector -= (slope * td + stored - power) / (tau - td);
        course->tau[k] = tau;
        course->rise[k] = slope;
        course->back[k] = back;
        course->fast_rise += slope;
        course->fast_back[k] = back * tau / (tau - td);
        course->fall[k] = course->fast_back[k] * tc / (tc - tau);
        falls += course->fall[k];
    }
    double speed = (light - sight->fast) / td; /* of the detector at t = 0 */
    course->tau[n] = td;
    course->fast_back[n] = detector - speed;
    course->fall[n] = course->fast_back[n] * tc / (tc - td);
    course->tau[n + 1] = tc;
    course->fast_back[n + 1] = 0;
    course->fall[n + 1] = -(speed - course->start / tc) - falls - course->fall[n];
}

double pen_course_at(const struct pen_course *course, double us)
{
    double v = course->start;
    for (int i = 0; i < course->poles; i++)
        v -= course->fall[i] * grown(course->tau[i], us);
    return v;
}

double pen_course_slope(const struct pen_course *course, double us)
{
    double slope = 0;
    for (int i = 0; i < course->poles; i++)
        slope -= course->fall[i] * (1 - grown(course->tau[i], us) / course->tau[i]);
    return slope;
}

struct pen_bounds pen_course_within(const struct pen_course *course, double us)
{
    struct pen_bounds v = {course->start, course->start};
    for (int i = 0; i < course->poles; i++) {
        double change = -course->fall[i] * fmin(course->tau[i], us);
        v.low += fmin(change, 0);
        v.high += fmax(change, 0);
    }
    return v;
}

struct pen_bounds pen_course_between(const struct pen_course *course, double us)
{
    double at = course->start, slope0 = 0, slope1 = 0;
    for (int i = 0; i < course->poles; i++) {
        double x = grown(course->tau[i], us);
        at -= course->fall[i] * x;
        slope0 -= course->fall[i];
        slope1 -= course->fall[i] * (1 - x / course->tau[i]);
    }
    if ((slope0 > 0) != (slope1 > 0))
        return pen_course_within(course, us);
    return (struct pen_bounds){fmin(course->start, at), fmax(course->start, at)};
}

void pen_course_end(const struct pen_course *course, struct inp_pen_sight *sight, uint64_t ps)
{
    double us = (double)ps * 1e-6, v = course->start;
    double fast = sight->fast + course->fast_rise * us;
    const int terms = course->poles - 2;
    for (int i = 0; i < course->poles; i++) {
        double x = grown(course->tau[i], us);
        v -= course->fall[i] * x;
        fast -= course->fast_back[i] * x;
        if (i < terms)
            sight->stored[i] += course->rise[i] * us - course->back[i] * x;
    }
    sight->fast = fast;
    sight->slow = fast - v;
    sight->t += ps;
}
