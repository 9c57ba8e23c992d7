/* A piece as a photodiode keeps it: where its light falls in time, and what it gives at an instant. */
#include <math.h>

#include "crt/maths.h"
#include "crt/photodiode_parts.h"
#include "crt/share.h"
#include "crt/tube_parts.h"

/* Terms that have faded for this many time constants are out. */
#define FADED 700.0

int crt_diode_terms(const struct crt_photodiode *d)
{
    return d->tube->desc.phosphor->terms;
}

double crt_diode_weight(const struct crt_photodiode *d, const struct crt_diode_piece *piece,
                        int beam, int k)
{
    const struct crt_phosphor_term *term = &d->tube->desc.phosphor->term[k];
    if (!piece->cut)
        return term->w * piece->entry.light[term->colour];
    return piece->beams == 1 || term->colour == beam ? term->w : 0;
}

bool crt_diode_flux(struct crt_photodiode *d, const struct crt_diode_piece *piece,
                    struct crt_flux *flux)
{
    flux->count = 0;
    if (!piece->cut)
        return crt_flux_stroke(flux, &d->aperture, &piece->entry, piece->from_s, piece->to_s);
    return crt_flux_line(flux, &d->aperture, crt_line_pass_beams(d->tube->line_pass), piece->cut,
                         piece->from_s, piece->to_s);
}

const struct crt_flux *crt_diode_flux_of(struct crt_photodiode *d, size_t i)
{
    if (d->flux_of == i)
        return &d->flux;
    d->flux_of = SIZE_MAX;
    if (!crt_diode_flux(d, &d->piece[i], &d->flux)) {
        d->lost++;
        return NULL;
    }
    d->flux_of = i;
    return &d->flux;
}

/* What of the part's light a term shows later, cd/m² per weight. */
static double shown(const struct crt_flux_part *part, double at, double tau_s)
{
    double ago = (at - part->b) / tau_s;
    return ago > FADED ? 0 : crt_flux_faded(part, tau_s) / tau_s * crt_flux_fade(ago);
}

/* All of a beam at a moment after it. */
static double beam_at(const struct crt_diode_piece *piece, const struct crt_flux *flux, int beam,
                      double at, double tau_s)
{
    const struct crt_flux_moments *m = &piece->beam[beam];
    if (crt_flux_brief(m, 1 / tau_s))
        return crt_flux_brief_faded(m, at, tau_s) / tau_s;
    double sum = 0;
    for (size_t i = 0; i < flux->count; i++) {
        const struct crt_flux_span *span = &flux->at[i];
        if (span->beam != beam)
            continue;
        struct crt_flux_part part = crt_flux_part(span, span->from, span->to);
        sum += shown(&part, at, tau_s);
    }
    return sum;
}

bool crt_diode_finish(struct crt_photodiode *d, struct crt_diode_piece *piece,
                      const struct crt_flux *flux, double end[CRT_MAX_TERMS])
{
    piece->lit0_s = INFINITY;
    piece->lit1_s = 0;
    for (size_t i = 0; i < flux->count; i++) {
        piece->lit0_s = fmin(piece->lit0_s, flux->at[i].from);
        piece->lit1_s = fmax(piece->lit1_s, flux->at[i].to);
    }
    if (flux->count == 0)
        return false;
    uint64_t lasts = (uint64_t)ceil(piece->lit1_s * 1e12);
    piece->done = piece->t0 + lasts;
    for (int beam = 0; beam < piece->beams; beam++)
        piece->beam[beam] = crt_flux_moments(flux, beam);
    for (int k = 0; k < crt_diode_terms(d); k++) {
        double tau = d->tube->desc.phosphor->term[k].tau_s;
        end[k] = 0;
        for (int beam = 0; beam < piece->beams; beam++) {
            double weight = crt_diode_weight(d, piece, beam, k);
            if (weight > 0 && piece->beam[beam].m[0] > 0)
                end[k] += weight * beam_at(piece, flux, beam, (double)lasts * 1e-12, tau);
        }
    }
    return true;
}

void crt_diode_piece_at(struct crt_photodiode *d, size_t i, uint64_t t, double cd_m2[CRT_MAX_TERMS])
{
    const struct crt_diode_piece *piece = &d->piece[i];
    const struct crt_phosphor_term *term = d->tube->desc.phosphor->term;
    int terms = crt_diode_terms(d);
    if (t <= piece->t0)
        return;
    if (t >= piece->done) {
        double ago = crt_seconds(piece->done, t);
        for (int k = 0; k < terms; k++)
            cd_m2[k] += d->end[i * (size_t)terms + (size_t)k] * crt_exp(-ago / term[k].tau_s);
        return;
    }
    double at = crt_seconds(piece->t0, t);
    const struct crt_flux *flux = at > piece->lit0_s ? crt_diode_flux_of(d, i) : NULL;
    for (size_t n = 0; flux && n < flux->count; n++) {
        const struct crt_flux_span *span = &flux->at[n];
        if (span->from >= at)
            continue;
        struct crt_flux_part part = crt_flux_part(span, span->from, fmin(span->to, at));
        for (int k = 0; k < terms; k++) {
            double weight = crt_diode_weight(d, piece, span->beam, k);
            if (weight > 0)
                cd_m2[k] += weight * shown(&part, at, term[k].tau_s);
        }
    }
}

void crt_diode_piece_turned(struct crt_photodiode *d, size_t i, uint64_t a, uint64_t b,
                            double omega, struct crt_phasor beam[CRT_MAX_GUNS])
{
    const struct crt_diode_piece *piece = &d->piece[i];
    double from = a > piece->t0 ? crt_seconds(piece->t0, a) : 0;
    double to = b > piece->t0 ? crt_seconds(piece->t0, b) : 0;
    bool all = from <= piece->lit0_s && to >= piece->lit1_s;
    for (int n = 0; n < CRT_MAX_GUNS; n++)
        beam[n] = (struct crt_phasor){0, 0};
    for (int n = 0; n < piece->beams; n++)
        all &= crt_flux_brief(&piece->beam[n], omega);
    if (all) {
        for (int n = 0; n < piece->beams; n++)
            crt_flux_brief_turned(&piece->beam[n], omega, &beam[n].re, &beam[n].im);
        return;
    }
    if (to <= piece->lit0_s || from >= piece->lit1_s)
        return;
    const struct crt_flux *flux = crt_diode_flux_of(d, i);
    for (size_t n = 0; flux && n < flux->count; n++) {
        const struct crt_flux_span *span = &flux->at[n];
        double low = fmax(span->from, from), high = fmin(span->to, to);
        if (low < high)
            crt_flux_turned(span, low, high, omega, &beam[span->beam].re, &beam[span->beam].im);
    }
}
