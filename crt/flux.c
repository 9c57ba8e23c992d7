#include "crt/flux.h"

#include <math.h>
#include <stdlib.h>

#include "crt/maths.h"

const double crt_flux_node[CRT_FLUX_NODES] = {
    -0.9602898564975363, -0.7966664774136267, -0.5255324099163290, -0.1834346424956498,
    0.1834346424956498,  0.5255324099163290,  0.7966664774136267,  0.9602898564975363};
const double crt_flux_load[CRT_FLUX_NODES] = {
    0.1012285362903763, 0.2223810344533745, 0.3137066458778873, 0.3626837833783620,
    0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};

bool crt_flux_add(struct crt_flux *flux, const struct crt_flux_span *span)
{
    if (flux->count == flux->room) {
        size_t room = flux->room ? flux->room * 2 : 64;
        struct crt_flux_span *at = realloc(flux->at, room * sizeof *at);
        if (!at)
            return false;
        flux->at = at;
        flux->room = room;
    }
    flux->at[flux->count++] = *span;
    return true;
}

void crt_flux_free(struct crt_flux *flux)
{
    free(flux->at);
    *flux = (struct crt_flux){0};
}

double crt_flux_time(double from, double to, int i)
{
    return (from + to) / 2 + (to - from) / 2 * crt_flux_node[i];
}

/* ---- parts of a span --------------------------------------------------------------------------- */

/* The polynomial through the nodes at x in −1…1: barycentric, with the weights of Gauss-Legendre nodes,
 * (−1)^i·sqrt((1 − x_i²)·load_i). */
static double value_at(const double q[CRT_FLUX_NODES], double x)
{
    double sum = 0, weights = 0;
    for (int i = 0; i < CRT_FLUX_NODES; i++) {
        double off = x - crt_flux_node[i];
        if (off == 0)
            return q[i];
        double w = sqrt((1 - crt_flux_node[i] * crt_flux_node[i]) * crt_flux_load[i]) / off;
        w = i % 2 ? -w : w;
        sum += w * q[i];
        weights += w;
    }
    return sum / weights;
}

/* q at the nodes of [a, b). */
static void part_of(const struct crt_flux_span *span, double a, double b, double q[CRT_FLUX_NODES])
{
    bool whole = a == span->from && b == span->to;
    double half = (span->to - span->from) / 2, middle = (span->from + span->to) / 2;
    for (int i = 0; i < CRT_FLUX_NODES; i++)
        q[i] = whole || span->constant
                   ? span->q[i]
                   : value_at(span->q, (crt_flux_time(a, b, i) - middle) / half);
}

struct crt_flux_part crt_flux_part(const struct crt_flux_span *span, double a, double b)
{
    struct crt_flux_part part = {.span = span, .a = a, .b = b};
    double q[CRT_FLUX_NODES], half = (b - a) / 2;
    part_of(span, a, b, q);
    for (int i = 0; i < CRT_FLUX_NODES; i++) {
        double light = crt_flux_load[i] * q[i] * half, before = half * (1 - crt_flux_node[i]);
        for (int n = 0; n < CRT_FLUX_MOMENTS; n++, light *= before)
            part.m[n] += light;
    }
    return part;
}

/* Of a stretch in which the exponential is smooth. */
static double faded_smoothly(const struct crt_flux_span *span, double a, double b, double end,
                             double tau_s)
{
    double q[CRT_FLUX_NODES], sum = 0;
    part_of(span, a, b, q);
    for (int i = 0; i < CRT_FLUX_NODES; i++)
        sum += crt_flux_load[i] * q[i] * crt_exp(-(end - crt_flux_time(a, b, i)) / tau_s);
    return sum * (b - a) / 2;
}

double crt_flux_faded(const struct crt_flux_part *part, double tau_s)
{
    const struct crt_flux_span *span = part->span;
    double a = part->a, b = part->b, rate = 1 / tau_s;
    if ((b - a) * rate < 0.1) {
        const double *m = part->m; /* 0.1^6/720 = 1e-9 */
        return m[0] -
               rate * (m[1] -
                       rate / 2 * (m[2] - rate / 3 * (m[3] - rate / 4 * (m[4] - rate / 5 * m[5]))));
    }
    if (span->constant)
        return span->q[0] * tau_s * -crt_expm1(-(b - a) / tau_s);
    /* Back from the end, in time constants; what is older is below e^−40. */
    static const double back[] = {0, 2, 6, 14, 40};
    double sum = 0, to = b;
    for (int i = 0; i < 4 && to > a; i++) {
        double from = fmax(b - back[i + 1] * tau_s, a);
        sum += faded_smoothly(span, from, to, b, tau_s);
        to = from;
    }
    return sum;
}

/* q·e^(−jωt) over a stretch in which the wave is smooth. */
static void turned_smoothly(const struct crt_flux_span *span, double a, double b, double omega,
                            double *re, double *im)
{
    double q[CRT_FLUX_NODES];
    part_of(span, a, b, q);
    for (int i = 0; i < CRT_FLUX_NODES; i++) {
        double angle = omega * crt_flux_time(a, b, i),
               light = crt_flux_load[i] * q[i] * (b - a) / 2;
        *re += light * crt_cos(angle);
        *im -= light * crt_sin(angle);
    }
}

void crt_flux_turned(const struct crt_flux_span *span, double a, double b, double omega, double *re,
                     double *im)
{
    double turns = fabs(omega) * (b - a);
    if (span->constant && turns > 4) {
        *re += span->q[0] * (crt_sin(omega * b) - crt_sin(omega * a)) / omega;
        *im += span->q[0] * (crt_cos(omega * b) - crt_cos(omega * a)) / omega;
        return;
    }
    int parts = (int)fmin(ceil(turns / 4), 1e6);
    parts = parts > 0 ? parts : 1;
    for (int i = 0; i < parts; i++) {
        double from = a + (b - a) * i / parts,
               to = i + 1 == parts ? b : a + (b - a) * (i + 1) / parts;
        turned_smoothly(span, from, to, omega, re, im);
    }
}

/* ---- moments ----------------------------------------------------------------------------------- */

struct crt_flux_moments crt_flux_moments(const struct crt_flux *flux, int beam)
{
    struct crt_flux_moments m = {0};
    double from = INFINITY, to = -INFINITY;
    for (size_t i = 0; i < flux->count; i++)
        if (flux->at[i].beam == beam) {
            from = fmin(from, flux->at[i].from);
            to = fmax(to, flux->at[i].to);
        }
    if (!(from < to))
        return m;
    m.middle = (from + to) / 2;
    m.half = (to - from) / 2;
    for (size_t i = 0; i < flux->count; i++) {
        const struct crt_flux_span *span = &flux->at[i];
        for (int k = 0; k < CRT_FLUX_NODES && span->beam == beam; k++) {
            double t = crt_flux_time(span->from, span->to, k) - m.middle;
            double light = crt_flux_load[k] * span->q[k] * (span->to - span->from) / 2;
            for (int n = 0; n < CRT_FLUX_MOMENTS; n++, light *= t)
                m.m[n] += light;
        }
    }
    return m;
}

bool crt_flux_brief(const struct crt_flux_moments *m, double rate)
{
    return m->half * fabs(rate) <= 0.05; /* 0.05^6/720 = 2e-11 */
}

double crt_flux_brief_faded(const struct crt_flux_moments *m, double at, double tau_s)
{
    double sum = 0, factor = 1;
    for (int n = 0; n < CRT_FLUX_MOMENTS; n++) {
        sum += m->m[n] * factor;
        factor /= (n + 1) * tau_s;
    }
    return sum * crt_exp(-(at - m->middle) / tau_s);
}

void crt_flux_brief_turned(const struct crt_flux_moments *m, double omega, double *re, double *im)
{
    double w2 = omega * omega;
    double even = m->m[0] - w2 * (m->m[2] / 2 - w2 * m->m[4] / 24);
    double odd = omega * (m->m[1] - w2 * (m->m[3] / 6 - w2 * m->m[5] / 120));
    double c = crt_cos(omega * m->middle), s = crt_sin(omega * m->middle);
    /* (even − j·odd)·(c − j·s) */
    *re += even * c - odd * s;
    *im -= even * s + odd * c;
}
