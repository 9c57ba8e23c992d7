#include "tests/support/tube_model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

uint32_t model_random(uint32_t *state)
{
    uint32_t x = *state;
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    return *state = x;
}

double model_uniform(uint32_t *state, double low, double high)
{
    return low + (high - low) * model_random(state) / 4294967296.0;
}

struct crt_tube_row model_row(double sigma0_mm, double growth_mm)
{
    struct crt_tube_row row = {.name = "MODEL", .phosphor = "MODEL"};
    row.spot.value = CRT_WIDTH60_SIGMA * sigma0_mm;
    row.spot_growth.value = growth_mm;
    row.spot_exponent.value = 0.5;
    row.gun_exponent.value = 2.5;
    row.line_luminance.value = 100;
    row.line_speed.value = 1;
    row.line_refresh.value = 60;
    return row;
}

struct crt_phosphor model_phosphor(int terms, const double *w, const double *tau_ms)
{
    struct crt_phosphor p = {.name = "MODEL", .colours = 1, .terms = terms};
    for (int k = 0; k < terms; k++)
        p.term[k] = (struct crt_phosphor_term){w[k], tau_ms[k] * 1e-3, 0};
    return p;
}

static const double node[8] = {-0.9602898564975363, -0.7966664774136267, -0.5255324099163290,
                               -0.1834346424956498, 0.1834346424956498,  0.5255324099163290,
                               0.7966664774136267,  0.9602898564975363};
static const double load[8] = {0.1012285362903763, 0.2223810344533745, 0.3137066458778873,
                               0.3626837833783620, 0.3626837833783620, 0.3137066458778873,
                               0.2223810344533745, 0.1012285362903763};

/* Share of a deposit at t (s) that term k emits between a and b. */
static double share(double tau, double t, double a, double b)
{
    if (t >= b)
        return 0;
    if (t < a)
        return exp(-(a - t) / tau) - exp(-(b - t) / tau);
    return -expm1(-(b - t) / tau);
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Times are seconds from the stroke's start, so that nothing is lost late in a run. */
static double stroke_light(const struct model_stroke *m, const struct crt_phosphor *p, int colour,
                           double x, double y, double a, double b)
{
    const struct crt_stroke *s = &m->stroke;
    double t = (double)(s->t1 - s->t0) * 1e-12, sigma = m->sigma_mm, sum = 0;
    double dx = (double)s->x1 - (double)s->x0, dy = (double)s->y1 - (double)s->y0;
    double px = x - (double)s->x0, py = y - (double)s->y0;
    double length2 = dx * dx + dy * dy, along = length2 > 0 ? (px * dx + py * dy) / length2 : 0;
    double crossing = length2 > 0 ? sigma / sqrt(length2) : 0; /* of the stroke per sigma */
    double at[400];
    int n = 0;
    at[n++] = 0;
    at[n++] = t;
    at[n++] = a;
    at[n++] = b;
    for (int i = -16; i <= 16 && crossing > 0; i++)
        at[n++] = (along + i * 0.5 * crossing) * t;
    for (int k = 0; k < p->terms; k++)
        for (double back = 0.25; back < 40; back *= 1.6) {
            at[n++] = a - back * p->term[k].tau_s;
            at[n++] = b - back * p->term[k].tau_s;
        }
    for (int i = 0; i < n; i++)
        at[i] = fmin(fmax(at[i], 0), t);
    qsort(at, (size_t)n, sizeof at[0], ascending);
    for (int i = 0; i + 1 < n; i++)
        for (int j = 0; j < 8 && at[i + 1] > at[i]; j++) {
            double half = (at[i + 1] - at[i]) / 2, td = at[i] + half * (1 + node[j]), w = 0;
            double ex = px - dx * td / t, ey = py - dy * td / t;
            for (int k = 0; k < p->terms; k++)
                if (p->term[k].colour == colour)
                    w += p->term[k].w * share(p->term[k].tau_s, td, a, b);
            sum += half * load[j] * w * exp(-(ex * ex + ey * ey) / (2 * sigma * sigma));
        }
    return sum * m->power / (2 * acos(-1) * sigma * sigma);
}

double model_light(const struct model_stroke *strokes, int count, const struct crt_phosphor *p,
                   int colour, double x, double y, uint64_t a, uint64_t b)
{
    double sum = 0;
    for (int i = 0; i < count; i++) {
        uint64_t t0 = strokes[i].stroke.t0;
        double from = ((double)a - (double)t0) * 1e-12, to = ((double)b - (double)t0) * 1e-12;
        sum += stroke_light(&strokes[i], p, colour, x, y, from, to);
    }
    return sum;
}
