/* How often light comes again at a place. */
#include "crt/waveform.h"

#include <math.h>
#include <stdlib.h>

#include "crt/share.h"

/* A refresh is a run of `lag` deposits whose sources come again in the same order. */
#define MOST_LAG 8192
#define STRAY    0.02 /* of the deposits may be out of order, or far from the median: pauses */
#define FAR      0.1
#define PAUSES   4 /* times longer than the median the mean may be because of them */

struct again {
    double seconds, weight;
};

struct repeats {
    const struct crt_deposit *at;
    size_t count;
    struct again *again;
};

static int by_seconds(const void *a, const void *b)
{
    double x = ((const struct again *)a)->seconds, y = ((const struct again *)b)->seconds;
    return (x > y) - (x < y);
}

static double light_of(const struct crt_deposit *d)
{
    return d->fluence[0] + d->fluence[1] + d->fluence[2];
}

static double median(struct again *again, size_t count)
{
    double all = 0, sum = 0;
    qsort(again, count, sizeof again[0], by_seconds);
    for (size_t i = 0; i < count; i++)
        all += again[i].weight;
    for (size_t i = 0; i < count; i++) {
        sum += again[i].weight;
        if (2 * sum >= all)
            return again[i].seconds;
    }
    return 0;
}

/* Intervals between deposits `lag` apart that have the same source; 0 when too few have. */
static size_t intervals(const struct repeats *r, size_t lag)
{
    size_t pairs = r->count - lag, found = 0, strays = 0;
    for (size_t i = 0; i < pairs; i++) {
        const struct crt_deposit *a = &r->at[i], *b = &r->at[i + lag];
        if (a->source == b->source) {
            double between = crt_seconds(a->t0, b->t0) + b->mean_t_s - a->mean_t_s;
            r->again[found++] = (struct again){between, light_of(a)};
        } else if (++strays > (size_t)(STRAY * (double)pairs)) {
            return 0;
        }
    }
    return found;
}

/* How far intervals are from their median, on average, in parts of it; above 1: not even at all. */
static double unevenness(const struct repeats *r, size_t found, double *middle)
{
    double off = 0, all = 0;
    size_t strays = 0;
    *middle = median(r->again, found);
    for (size_t i = 0; i < found; i++) {
        double away = fabs(r->again[i].seconds - *middle);
        strays += away > FAR * *middle;
        off += fmin(away, FAR * *middle);
        all += r->again[i].seconds;
    }
    if (!(*middle > 0) || (double)strays > STRAY * (double)found ||
        all > PAUSES * *middle * (double)found)
        return 2;
    return off / *middle / (double)found;
}

/* The period of the whole run of deposits; 0: none. */
static double run_period(const struct repeats *r)
{
    double best = 1, period = 0;
    size_t last = r->count - 1 < MOST_LAG ? r->count - 1 : MOST_LAG;
    for (size_t lag = 1; lag <= last; lag++) {
        double middle = 0;
        size_t found = intervals(r, lag);
        double uneven = found > 0 ? unevenness(r, found, &middle) : 2;
        if (uneven < best - 1e-9) {
            best = uneven;
            period = middle;
            last = last < lag + lag / 2 ? last : lag + lag / 2; /* twice is no better */
        }
    }
    return period;
}

/* ---- pictures that change --------------------------------------------------------------------------- */

/* Of deposits with one source, with what comes next to each other taken as one. */
static int by_source(const void *a, const void *b)
{
    const struct crt_deposit *x = *(const struct crt_deposit *const *)a;
    const struct crt_deposit *y = *(const struct crt_deposit *const *)b;
    if (x->source != y->source)
        return x->source < y->source ? -1 : 1;
    return (x->t0 > y->t0) - (x->t0 < y->t0);
}

/* A tenth of the longest gap parts what comes again from what belongs together. */
static size_t source_intervals(const struct crt_deposit *const *at, size_t count,
                               struct again *again)
{
    double longest = 0, last = 0, weight = 0;
    size_t found = 0;
    for (size_t i = 1; i < count; i++)
        longest = fmax(longest, crt_seconds(at[i - 1]->t0, at[i]->t0));
    for (size_t i = 0; i < count; i++) {
        double now = crt_seconds(at[0]->t0, at[i]->t0);
        if (i > 0 && crt_seconds(at[i - 1]->t0, at[i]->t0) > longest / 10) {
            again[found++] = (struct again){now - last, weight};
            last = now;
            weight = 0;
        }
        weight += light_of(at[i]);
    }
    return found;
}

static double source_period(const struct repeats *r)
{
    const struct crt_deposit **at = malloc(r->count * sizeof *at);
    size_t found = 0;
    if (!at)
        return 0;
    for (size_t i = 0; i < r->count; i++)
        at[i] = &r->at[i];
    qsort(at, r->count, sizeof *at, by_source);
    for (size_t i = 0, next; i < r->count; i = next) {
        for (next = i + 1; next < r->count && at[next]->source == at[i]->source; next++)
            ;
        found += source_intervals(at + i, next - i, r->again + found);
    }
    free(at);
    return found > 0 ? median(r->again, found) : 0;
}

double crt_waveform_repeats_hz(const struct crt_photodiode *diode, uint64_t t0, uint64_t t1)
{
    struct repeats r = {0};
    r.at = crt_photodiode_deposits(diode, &r.count);
    while (r.count > 0 && r.at->t0 < t0)
        r.at++, r.count--;
    while (r.count > 0 && r.at[r.count - 1].t0 >= t1)
        r.count--;
    if (r.count < 2)
        return 0;
    r.again = malloc(r.count * sizeof *r.again);
    if (!r.again)
        return 0;
    double period = run_period(&r);
    if (!(period > 0))
        period = source_period(&r);
    free(r.again);
    return period > 0 ? 1 / period : 0;
}
