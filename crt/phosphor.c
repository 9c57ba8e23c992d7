#include "crt/phosphor.h"

#include <math.h>

#include "crt/maths.h"
#include "crt/names.h"

const struct crt_phosphor *crt_phosphor_find(const char *name)
{
    size_t n;
    const struct crt_phosphor *p = crt_phosphors(&n);
    for (size_t i = 0; i < n; i++)
        if (crt_same_name(p[i].name, name))
            return &p[i];
    return NULL;
}

double crt_phosphor_impulse(const struct crt_phosphor *p, double t_s)
{
    double sum = 0;
    for (int k = 0; k < p->terms; k++)
        sum += p->term[k].w / p->term[k].tau_s * crt_exp(-t_s / p->term[k].tau_s);
    return sum;
}

double crt_phosphor_decay_time(const struct crt_phosphor *p, double fraction)
{
    if (fraction >= 1)
        return 0;
    if (!(fraction > 0))
        return INFINITY;
    double slowest = 0;
    for (int k = 0; k < p->terms; k++)
        slowest = fmax(slowest, p->term[k].tau_s);
    /* The light falls monotonically, and faster than its slowest term alone: a bracket. */
    double goal = fraction * crt_phosphor_impulse(p, 0);
    double low = 0, high = -crt_log(fraction) * slowest * 1.000001;
    for (;;) {
        double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high)
            return high;
        if (crt_phosphor_impulse(p, middle) > goal)
            low = middle;
        else
            high = middle;
    }
}

double crt_phosphor_c1(const struct crt_phosphor *p, double hz)
{
    double re = 0, im = 0;
    for (int k = 0; k < p->terms; k++) {
        double x = 6.283185307179586 * hz * p->term[k].tau_s;
        re += p->term[k].w / (1 + x * x);
        im += p->term[k].w * x / (1 + x * x);
    }
    return 2 * sqrt(re * re + im * im);
}
