/* pen_slow.h — the light pen once more, slowly and in another way, for tests to compare with.
 *
 * Models:     the spot as points on rings of the aperture, its light at any moment; phosphor, detector and
 *             coupling as differential equations by Runge and Kutta's fourth-order steps. No noise.
 * Ownership:  plain values.
 */
#ifndef TESTS_INPUT_PEN_SLOW_H
#define TESTS_INPUT_PEN_SLOW_H

#include <math.h>
#include <string.h>

#include "input/pen.h"

#define SLOW_PI 3.14159265358979324

static inline struct inp_pen_setup slow_setup(void)
{
    return (struct inp_pen_setup){
#define X(field, unit, value, low, high, meaning, source) .field = {value, low, high, source},
        INP_PEN_FIGURES(X)
#undef X
    };
}

/* Without noise and room. */
static inline struct inp_pen_setup slow_still_setup(void)
{
    struct inp_pen_setup setup = slow_setup();
    setup.noise.value = 0;
    setup.room.value = 0;
    return setup;
}

/* Share of a Gaussian of width sigma, d away, within a disc: midpoints of rings and of their halves. */
static inline double slow_share(double radius, double sigma, double d, int rings, int angles)
{
    double sum = 0;
    for (int i = 0; i < rings; i++) {
        double rho = radius * (i + 0.5) / rings;
        for (int j = 0; j < angles; j++) {
            double angle = SLOW_PI * (j + 0.5) / angles;
            double far2 = rho * rho + d * d - 2 * rho * d * cos(angle);
            sum += rho * exp(-far2 / (2 * sigma * sigma));
        }
    }
    return sum * (radius / rings) * (SLOW_PI / angles) / (SLOW_PI * sigma * sigma);
}

/* The same by a table. */
#define SLOW_SHARES 200
struct slow_shares {
    double step;
    double share[SLOW_SHARES + 1];
};

static inline void slow_shares_make(struct slow_shares *s, double radius, double sigma)
{
    s->step = (radius + 6 * sigma) / SLOW_SHARES;
    for (int i = 0; i <= SLOW_SHARES; i++)
        s->share[i] = slow_share(radius, sigma, i * s->step, 60, 48);
}

/* Cubic between four points of the table. */
static inline double slow_share_at(const struct slow_shares *s, double d)
{
    double at = d / s->step;
    int i = (int)at;
    if (i >= SLOW_SHARES - 1)
        return 0;
    double t = at - i, b = s->share[i], c = s->share[i + 1], e = s->share[i + 2];
    double a = i > 0 ? s->share[i - 1] : c; /* even in d */
    return b + t / 2 * (c - a + t * (2 * a - 5 * b + 4 * c - e + t * (3 * (b - c) + e - a)));
}

/* State: terms, detector, coupling. */
struct slow_pen {
    const struct crt_phosphor *phosphor;
    double response, couple; /* us */
    double v[CRT_MAX_TERMS + 2];
};

static inline void slow_rates(const struct slow_pen *pen, const double power[CRT_MAX_COLOURS],
                              const double *v, double *rate)
{
    const struct crt_phosphor *p = pen->phosphor;
    const int n = p->terms;
    double light = 0;
    for (int k = 0; k < n; k++) {
        const struct crt_phosphor_term *term = &p->term[k];
        rate[k] = (term->w * power[term->colour] / p->colour[term->colour].y - v[k]) /
                  (term->tau_s * 1e6);
        light += v[k];
    }
    rate[n] = (light - v[n]) / pen->response;
    rate[n + 1] = (v[n] - v[n + 1]) / pen->couple;
}

/* A step of h us with power at its begin, middle and end. */
static inline void slow_step(struct slow_pen *pen, double power[3][CRT_MAX_COLOURS], double h)
{
    const int n = pen->phosphor->terms + 2;
    double k[4][CRT_MAX_TERMS + 2], v[CRT_MAX_TERMS + 2];
    static const double part[4] = {0, 0.5, 0.5, 1};
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < n; j++)
            v[j] = pen->v[j] + (i > 0 ? part[i] * h * k[i - 1][j] : 0);
        slow_rates(pen, power[(i + 1) / 2], v, k[i]);
    }
    for (int j = 0; j < n; j++)
        pen->v[j] += h / 6 * (k[0][j] + 2 * k[1][j] + 2 * k[2][j] + k[3][j]);
}

static inline double slow_signal(const struct slow_pen *pen)
{
    const int n = pen->phosphor->terms;
    return pen->v[n] - pen->v[n + 1];
}

#endif
