/* share.h — how much of a deposit's energy a plane or a film gets, as a function of when it was
 * made.
 *
 *      plane of term k at time ref:        w_k·e^(−(ref − t)/τ_k)
 *      film from a to b, deposit before a: Σ w_k·(1 − e^(−(b−a)/τ_k))·e^(−(a − t)/τ_k)
 *      film from a to b, deposit within:   Σ w_k·(1 − e^(−(b − t)/τ_k))
 *
 * Models:     exactly that, averaged over a stretch of time during which the spot moves evenly: the
 *             mean and the slope along the stretch, and a bound on what a straight line misses.
 * Time:       picoseconds; τ in seconds.
 * Errors:     none; plain values.
 */
#ifndef CRT_SHARE_H
#define CRT_SHARE_H

#include <stdbool.h>
#include <stdint.h>

#include "crt/phosphor.h"

struct crt_share {
    bool within; /* 1 − e^(…) instead of e^(…) */
    int terms;
    double amount[CRT_MAX_TERMS], rate[CRT_MAX_TERMS]; /* 1/s */
    uint64_t ref;
    uint64_t from, to; /* for deposits in [from, to), to <= ref */
};

void crt_share_add(struct crt_share *share, double amount, double tau_s);

/* The most that a share can be. */
double crt_share_total(const struct crt_share *share);

/* Of a stretch of strokes [t0, t1): the share's mean, its change from the middle to the end when
 * fitted by a straight line, and how far the ends are off a constant and off that line. */
struct crt_share_fit {
    double mean, slope;
    double off_constant, off_line;
};
struct crt_share_fit crt_share_over(const struct crt_share *share, uint64_t t0, uint64_t t1);

/* Seconds from a to b, b >= a. */
double crt_seconds(uint64_t a, uint64_t b);

#endif
