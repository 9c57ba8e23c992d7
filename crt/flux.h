/* flux.h — light falling on a place while a beam passes it, as a function of time; private to photodiodes.
 *
 *      rate │    ╭─╮
 *           │   ╱   ╲          spans: [from, to) with the rate at the nodes of Gauss and Legendre,
 *           └──┴─┴─┴─┴──▶ t    which stand for a polynomial
 *
 * Models:     the rate q(t) of a piece at a place as a polynomial of degree 7 on each of a few spans, which its
 *             maker chooses so short that it is smooth there. Integrals of q against exponentials and waves are
 *             those of that polynomial.
 * Units:      seconds after the piece's start; q in cd/m² (fluence per second).
 * Accuracy:   1e-6 of the highest rate at an instant, for Gaussians of spans of one sigma; integrals 1e-10.
 * Ownership:  a zeroed crt_flux is empty; crt_flux_free releases.
 * Errors:     crt_flux_add: false when memory is out.
 */
#ifndef CRT_FLUX_H
#define CRT_FLUX_H

#include <stdbool.h>
#include <stddef.h>

#include "crt/maths.h"

#define CRT_FLUX_NODES   8
#define CRT_FLUX_MOMENTS 6

struct crt_flux_span {
    double from, to; /* s */
    int beam;        /* gun */
    bool constant;   /* all of q is q[0] */
    double q[CRT_FLUX_NODES];
};

/* Spans of a beam are in order of time and do not overlap; beams one after the other. */
struct crt_flux {
    struct crt_flux_span *at;
    size_t count, room;
};

extern const double crt_flux_node[CRT_FLUX_NODES], crt_flux_load[CRT_FLUX_NODES];

/* Light of a beam as a whole: ∫ q·(t − middle)^n. */
struct crt_flux_moments {
    double middle, half; /* s: it falls within middle ± half */
    double m[CRT_FLUX_MOMENTS];
};

bool crt_flux_add(struct crt_flux *flux, const struct crt_flux_span *span);
void crt_flux_free(struct crt_flux *flux);

/* Time of node i of [from, to). */
double crt_flux_time(double from, double to, int i);

/* [a, b) of a span, with its light's moments ∫ q·(b − t)^n. */
struct crt_flux_part {
    const struct crt_flux_span *span;
    double a, b, m[CRT_FLUX_MOMENTS];
};
struct crt_flux_part crt_flux_part(const struct crt_flux_span *span, double a, double b);

/* ∫ q·e^(−(b − t)/tau) over the part, to 1e-9; and ∫ q·e^(−jωt) over [a, b) of a span. */
double crt_flux_faded(const struct crt_flux_part *part, double tau_s);
void crt_flux_turned(const struct crt_flux_span *span, double a, double b, double omega, double *re,
                     double *im);

struct crt_flux_moments crt_flux_moments(const struct crt_flux *flux, int beam);

/* From moments alone, where the light falls at once compared with tau or 1/omega: ∫ q·e^(−(at − t)/tau), `at` after
 * all of it; ∫ q·e^(−jωt). Good to 1e-9. */
bool crt_flux_brief(const struct crt_flux_moments *m, double rate);
double crt_flux_brief_faded(const struct crt_flux_moments *m, double at, double tau_s);
void crt_flux_brief_turned(const struct crt_flux_moments *m, double omega, double *re, double *im);

/* e^(−x), x >= 0: in the short steps of a walk along spans x is small. */
static inline double crt_flux_fade(double x)
{
    return x < 1e-3 ? 1 - x * (1 - x / 2 * (1 - x / 3 * (1 - x / 4))) : crt_exp(-x);
}

#endif
