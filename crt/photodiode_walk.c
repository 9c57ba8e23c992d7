/* Luminance from stretch to stretch: the dark between pieces, and pieces span by span. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crt/maths.h"
#include "crt/photodiode_parts.h"
#include "crt/share.h"
#include "crt/tube_parts.h"

struct walk {
    struct crt_photodiode *d;
    uint64_t t0;
    double level; /* cd/m²: stretches that cross it are cut up */
    crt_stretch_fn *each;
    void *context;
    double cd_m2[CRT_MAX_TERMS]; /* where the walk stands */
};

static double since(const struct walk *w, uint64_t t)
{
    return t >= w->t0 ? crt_seconds(w->t0, t) : -crt_seconds(t, w->t0);
}

static double tau_of(const struct walk *w, int k)
{
    return w->d->tube->desc.phosphor->term[k].tau_s;
}

double crt_stretch_at(const struct crt_phosphor *phosphor, const struct crt_diode_stretch *s,
                      double t)
{
    double sum = 0;
    for (int k = 0; k < phosphor->terms; k++)
        sum += s->toward[k] + (s->start[k] - s->toward[k]) * crt_exp(-t / phosphor->term[k].tau_s);
    return sum;
}

static void sum_up(const struct walk *w, struct crt_diode_stretch *s)
{
    for (int k = 0; k < crt_diode_terms(w->d); k++) {
        s->first += s->start[k];
        s->last += s->end[k];
    }
}

/* Goes on from the stretch's end. */
static void tell(struct walk *w, const struct crt_diode_stretch *s)
{
    w->each(w->context, s);
    memcpy(w->cd_m2, s->end, sizeof w->cd_m2);
}

static void walk_dark(struct walk *w, double from, double to)
{
    struct crt_diode_stretch s = {.at_s = from, .seconds = to - from};
    if (!(from < to))
        return;
    memcpy(s.start, w->cd_m2, sizeof s.start);
    for (int k = 0; k < crt_diode_terms(w->d); k++)
        s.end[k] = s.start[k] * crt_flux_fade(s.seconds / tau_of(w, k));
    sum_up(w, &s);
    tell(w, &s);
}

/* The spans of one beam, passed in order of time. */
struct passing {
    const struct crt_flux_span *at, *end;
};

static void find_beams(const struct crt_flux *flux, int beams, struct passing passing[CRT_MAX_GUNS])
{
    const struct crt_flux_span *at = flux->at, *end = at + flux->count;
    for (int beam = 0; beam < beams; beam++) {
        passing[beam].at = at;
        while (at < end && at->beam == beam)
            at++;
        passing[beam].end = at;
    }
}

/* Seconds of the piece at which something begins or ends, after `from`. */
static double next_end(struct passing *passing, int beams, double from, double to)
{
    double next = to;
    for (int beam = 0; beam < beams; beam++) {
        struct passing *p = &passing[beam];
        while (p->at < p->end && p->at->to <= from)
            p->at++;
        if (p->at < p->end)
            next = fmin(next, p->at->from > from ? p->at->from : p->at->to);
    }
    return next;
}

/* A crossing is narrowed down to 2^-14 of a span. */
#define MOST_CUTS 14

/* Whether the light falls evenly: then the stretch is exact as it is. */
static bool falls_evenly(const struct passing *passing, int beams, double to)
{
    for (int beam = 0; beam < beams; beam++)
        if (passing[beam].at < passing[beam].end && passing[beam].at->from < to &&
            !passing[beam].at->constant)
            return false;
    return true;
}

/* Adds what a beam gives between the stretch's ends, in the piece's seconds. */
static void add_beam(const struct walk *w, const struct crt_diode_piece *piece, int beam,
                     const struct crt_flux_part *part, struct crt_diode_stretch *s)
{
    for (int k = 0; k < crt_diode_terms(w->d); k++) {
        double weight = crt_diode_weight(w->d, piece, beam, k), tau = tau_of(w, k);
        if (!(weight > 0))
            continue;
        s->toward[k] += weight * part->m[0] / s->seconds;
        s->end[k] += weight * crt_flux_faded(part, tau) / tau;
    }
}

/* From one end of spans to the next: `offset` is the piece's start in the walk. */
static void walk_span(struct walk *w, const struct crt_diode_piece *piece,
                      const struct passing *passing, double from, double to, double offset,
                      int cuts)
{
    struct crt_diode_stretch s = {.at_s = offset + from, .seconds = to - from, .lit = true};
    memcpy(s.start, w->cd_m2, sizeof s.start);
    for (int k = 0; k < crt_diode_terms(w->d); k++)
        s.end[k] = s.start[k] * crt_flux_fade(s.seconds / tau_of(w, k));
    for (int beam = 0; beam < piece->beams; beam++) {
        const struct crt_flux_span *span = passing[beam].at;
        if (span >= passing[beam].end || span->from >= to)
            continue;
        struct crt_flux_part part = crt_flux_part(span, from, to);
        add_beam(w, piece, beam, &part, &s);
    }
    sum_up(w, &s);
    double middle = (from + to) / 2;
    bool crosses = (s.first > w->level) != (s.last > w->level);
    if (crosses && cuts < MOST_CUTS && from < middle && middle < to &&
        !falls_evenly(passing, piece->beams, to)) {
        walk_span(w, piece, passing, from, middle, offset, cuts + 1);
        walk_span(w, piece, passing, middle, to, offset, cuts + 1);
    } else {
        tell(w, &s);
    }
}

static void walk_piece(struct walk *w, size_t i, double from, double to, double offset)
{
    const struct crt_diode_piece *piece = &w->d->piece[i];
    const struct crt_flux *flux = crt_diode_flux_of(w->d, i);
    struct passing passing[CRT_MAX_GUNS];
    if (!flux)
        return;
    find_beams(flux, piece->beams, passing);
    while (from < to) {
        double next = next_end(passing, piece->beams, from, to);
        walk_span(w, piece, passing, from, next, offset, 0);
        from = next;
    }
}

void crt_diode_walk(struct crt_photodiode *d, uint64_t t0, uint64_t t1, double level,
                    crt_stretch_fn *each, void *context)
{
    struct walk w = {.d = d, .t0 = t0, .level = level, .each = each, .context = context};
    double at = 0, until = crt_seconds(t0, t1);
    crt_photodiode_terms(d, t0, w.cd_m2);
    for (size_t i = d->first; i < d->count && d->piece[i].t0 < t1; i++) {
        const struct crt_diode_piece *piece = &d->piece[i];
        double offset = since(&w, piece->t0);
        double from = fmax(offset + piece->lit0_s, at), to = fmin(offset + piece->lit1_s, until);
        if (piece->done <= t0 || !(from < to))
            continue;
        walk_dark(&w, at, from);
        walk_piece(&w, i, from - offset, to - offset, offset);
        at = to;
    }
    walk_dark(&w, at, until);
}
