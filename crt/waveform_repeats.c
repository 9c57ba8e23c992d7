/* How often light comes again at a place. */
#include "crt/waveform.h"

#include <math.h>
#include <stdlib.h>

#include "crt/share.h"

/* A refresh is a run of `lag` deposits whose sources come again in the same order. */
#define MOST_LAG 8192
#define STRAY    0.02 /* of the deposits may be out of order, or far from the median: pauses */
#define FAR      0.1
#define PAUSES   4   /* times longer than the median the mean may be because of them */
#define LUCK     0.1 /* of the unevenness that averaging alone leaves: more is no repeat */
#define GLANCE   32
#define EVEN     0.5 /* of the light of a changing picture comes again after about the same time */

struct again {
    double seconds, weight;
};

struct repeats {
    const struct crt_deposit *at;
    size_t count;
    struct again *again;
    double shortest; /* seconds: what comes again sooner belongs to one refresh; 0: not known */
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

/* How far single intervals are from their mean, all of them, in parts of it. */
static double scatter(const struct repeats *r, size_t found)
{
    double sum = 0, off = 0;
    for (size_t i = 0; i < found; i++)
        sum += r->again[i].seconds;
    double mean = sum / (double)found;
    for (size_t i = 0; i < found; i++)
        off += fabs(r->again[i].seconds - mean);
    return mean > 0 ? off / (double)found / mean : 0;
}

/* A glance at a few intervals, as most lags are none: many have other sources, or are far from the middle one. */
static bool is_hopeless(const struct repeats *r, size_t lag)
{
    struct again some[GLANCE];
    size_t pairs = r->count - lag, far = 0;
    if (pairs < 4 * GLANCE)
        return false;
    for (size_t i = 0; i < GLANCE; i++) {
        size_t at = i * pairs / GLANCE;
        some[i] = (struct again){crt_seconds(r->at[at].t0, r->at[at + lag].t0), 1};
        far += r->at[at].source != r->at[at + lag].source;
    }
    double middle = median(some, GLANCE);
    for (size_t i = 0; i < GLANCE; i++)
        far += fabs(some[i].seconds - middle) > 2 * FAR * middle;
    return far > GLANCE / 4;
}

/* Of sums of irregular intervals, as a part of that of single ones; overlapping sums differ by what is not in both.
 * 0: there are too few. */
static double evenness(size_t lag, size_t pairs, size_t first)
{
    size_t differ = lag < pairs ? lag : pairs;
    return pairs < lag / 4 ? 0 : sqrt((double)differ * (double)first) / (double)lag;
}

/* The period of the whole run of deposits; 0: none. Sums of many irregular intervals are even, too: they scatter
 * by the root of their number less. */
static double run_period(const struct repeats *r)
{
    double best = 1, period = 0, single = 0;
    size_t last = r->count - 1 < MOST_LAG ? r->count - 1 : MOST_LAG, first = 0;
    for (size_t lag = 1; lag <= last; lag++) {
        double middle = 0;
        if (first > 0 && is_hopeless(r, lag))
            continue;
        size_t found = intervals(r, lag);
        if (found > 0 && first == 0) {
            first = lag;
            single = scatter(r, found);
        }
        if (lag > first && r->count - lag < lag / 4)
            break;
        double uneven = found > 0 ? unevenness(r, found, &middle) : 2;
        if (lag > first && uneven > evenness(lag, r->count - lag, first) * LUCK * single + 1e-9)
            continue;
        if (uneven < best - 1e-9 && middle > (1 - FAR) * r->shortest) {
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

/* Each with the one about a shortest period later, or else the next one after that. */
static size_t refresh_intervals(const struct crt_deposit *const *at, size_t count, double shortest,
                                struct again *again)
{
    size_t found = 0, next = 0;
    for (size_t i = 0; i < count; i++) {
        double best = 0;
        while (next < count && crt_seconds(at[i]->t0, at[next]->t0) < (1 - FAR) * shortest)
            next++;
        for (size_t k = next; k < count; k++) {
            double between = crt_seconds(at[i]->t0, at[k]->t0);
            if (best > 0 && fabs(between - shortest) >= fabs(best - shortest))
                break;
            best = between;
        }
        if (best > 0)
            again[found++] = (struct again){best, light_of(at[i])};
    }
    return found;
}

/* The median, if enough of the light comes again after about that time. */
static double common(struct again *again, size_t found)
{
    double middle = median(again, found), all = 0, near = 0;
    for (size_t i = 0; i < found; i++) {
        all += again[i].weight;
        if (fabs(again[i].seconds - middle) <= FAR * middle)
            near += again[i].weight;
    }
    return near >= EVEN * all ? middle : 0;
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
        found += r->shortest > 0
                     ? refresh_intervals(at + i, next - i, r->shortest, r->again + found)
                     : source_intervals(at + i, next - i, r->again + found);
    }
    free(at);
    double period = found > 0 ? common(r->again, found) : 0;
    /* What moves within refreshes comes a little sooner or later each time. */
    return fabs(period - r->shortest) < FAR * r->shortest ? r->shortest : period;
}

double crt_waveform_repeats_hz(const struct crt_photodiode *diode, uint64_t t0, uint64_t t1,
                               double refresh_hz)
{
    struct repeats r = {.shortest = refresh_hz > 0 ? 1 / refresh_hz : 0};
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
