/* Reading a photodiode: luminance, shares, integrals. */
#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crt/maths.h"
#include "crt/photodiode_parts.h"
#include "crt/share.h"
#include "crt/tube_parts.h"

#define TWO_PI 6.28318530717958648

/* ---- the cursor ---------------------------------------------------------------------------------- */

void crt_diode_decay(const struct crt_photodiode *d, const struct crt_diode_store *store,
                     uint64_t t, double cd_m2[CRT_MAX_TERMS])
{
    double ago = crt_seconds(store->t, t);
    for (int k = 0; k < crt_diode_terms(d); k++)
        cd_m2[k] = store->cd_m2[k] * crt_exp(-ago / d->tube->desc.phosphor->term[k].tau_s);
}

void crt_diode_pass(const struct crt_photodiode *d, struct crt_diode_store *store, size_t i)
{
    const struct crt_diode_piece *piece = &d->piece[i];
    const double *end = d->end + i * (size_t)crt_diode_terms(d);
    bool later = piece->done >= store->t; /* as pieces that do not overlap are */
    double ago = later ? crt_seconds(store->t, piece->done) : crt_seconds(piece->done, store->t);
    for (int k = 0; k < crt_diode_terms(d); k++) {
        double fade = crt_exp(-ago / d->tube->desc.phosphor->term[k].tau_s);
        store->cd_m2[k] = later ? store->cd_m2[k] * fade + end[k] : store->cd_m2[k] + end[k] * fade;
    }
    store->t = later ? piece->done : store->t;
}

/* Remembers where the cursor stands, unless memory is out: then going back takes longer. */
static void mark(struct crt_photodiode *d)
{
    size_t last = d->marks > 0 ? d->mark[d->marks - 1].at : d->first;
    if (d->cursor_at < last + CRT_MARK_STEP)
        return;
    if (d->marks == d->mark_room) {
        size_t room = d->mark_room ? 2 * d->mark_room : 16;
        struct crt_diode_mark *marks = realloc(d->mark, room * sizeof *marks);
        if (!marks)
            return;
        d->mark = marks;
        d->mark_room = room;
    }
    d->mark[d->marks++] = (struct crt_diode_mark){d->cursor, d->cursor_at};
}

/* To the last mark not after t, or the base. */
static void go_back(struct crt_photodiode *d, uint64_t t)
{
    size_t low = 0, high = d->marks;
    while (low < high) {
        size_t middle = (low + high) / 2;
        if (d->mark[middle].store.t <= t)
            low = middle + 1;
        else
            high = middle;
    }
    d->cursor = low > 0 ? d->mark[low - 1].store : d->base;
    d->cursor_at = low > 0 ? d->mark[low - 1].at : d->first;
}

void crt_diode_drop_marks(struct crt_photodiode *d, size_t first)
{
    size_t gone = 0;
    while (gone < d->marks && d->mark[gone].at < first)
        gone++;
    d->marks -= gone;
    if (gone > 0)
        memmove(d->mark, d->mark + gone, d->marks * sizeof d->mark[0]);
}

void crt_diode_move_marks(struct crt_photodiode *d, size_t by)
{
    for (size_t i = 0; i < d->marks; i++)
        d->mark[i].at -= by;
}

static void move_cursor(struct crt_photodiode *d, uint64_t t)
{
    if (t < d->cursor.t)
        go_back(d, t);
    while (d->cursor_at < d->count && d->piece[d->cursor_at].done <= t) {
        crt_diode_pass(d, &d->cursor, d->cursor_at++);
        mark(d);
    }
}

void crt_photodiode_terms(struct crt_photodiode *d, uint64_t t, double cd_m2[CRT_MAX_TERMS])
{
    assert(t >= d->from && t <= d->tube->now);
    for (int k = 0; k < CRT_MAX_TERMS; k++)
        cd_m2[k] = 0;
    move_cursor(d, t);
    crt_diode_decay(d, &d->cursor, t, cd_m2);
    for (size_t i = d->cursor_at; i < d->count && d->piece[i].t0 < t; i++)
        crt_diode_piece_at(d, i, t, cd_m2);
}

void crt_photodiode_read(struct crt_photodiode *d, uint64_t t, double cd_m2[CRT_MAX_COLOURS])
{
    double term[CRT_MAX_TERMS];
    crt_photodiode_terms(d, t, term);
    for (int c = 0; c < CRT_MAX_COLOURS; c++)
        cd_m2[c] = 0;
    for (int k = 0; k < crt_diode_terms(d); k++)
        cd_m2[d->tube->desc.phosphor->term[k].colour] += term[k];
}

static double sum_of(const struct crt_photodiode *d, const double term[CRT_MAX_TERMS])
{
    double sum = 0;
    for (int k = 0; k < crt_diode_terms(d); k++)
        sum += term[k];
    return sum;
}

double crt_photodiode_luminance(struct crt_photodiode *d, uint64_t t)
{
    double term[CRT_MAX_TERMS];
    crt_photodiode_terms(d, t, term);
    return sum_of(d, term);
}

/* ---- shares -------------------------------------------------------------------------------------- */

double crt_photodiode_share(struct crt_photodiode *d, size_t i, uint64_t t)
{
    double term[CRT_MAX_TERMS] = {0};
    assert(i < d->shown - d->first && t >= d->from);
    crt_diode_piece_at(d, d->first + i, t, term);
    return sum_of(d, term);
}

double crt_photodiode_older(const struct crt_photodiode *d, uint64_t t)
{
    double term[CRT_MAX_TERMS];
    assert(t >= d->from);
    crt_diode_decay(d, &d->base, t, term);
    return sum_of(d, term);
}

/* ---- integrals ----------------------------------------------------------------------------------- */

/* e^(−j2π·hz·seconds), times a phasor; whole turns are left out first. */
static struct crt_phasor turn(struct crt_phasor p, double turns)
{
    double angle = TWO_PI * (turns - floor(turns)), c = crt_cos(angle), s = crt_sin(angle);
    return (struct crt_phasor){p.re * c + p.im * s, p.im * c - p.re * s};
}

/* What falls between t0 and t1 on each term, turned from t0 on. */
static void falling(struct crt_photodiode *d, uint64_t t0, uint64_t t1, double hz,
                    struct crt_phasor term[CRT_MAX_TERMS])
{
    for (size_t i = d->first; i < d->count && d->piece[i].t0 < t1; i++) {
        const struct crt_diode_piece *piece = &d->piece[i];
        struct crt_phasor beam[CRT_MAX_GUNS];
        if (piece->done <= t0)
            continue;
        crt_diode_piece_turned(d, i, t0, t1, TWO_PI * hz, beam);
        double after = piece->t0 >= t0 ? crt_seconds(t0, piece->t0) : -crt_seconds(piece->t0, t0);
        for (int n = 0; n < piece->beams; n++) {
            beam[n] = turn(beam[n], hz * after);
            for (int k = 0; k < crt_diode_terms(d); k++) {
                double weight = crt_diode_weight(d, piece, n, k);
                term[k].re += weight * beam[n].re;
                term[k].im += weight * beam[n].im;
            }
        }
    }
}

/* ∫ of each term's luminance, turned: stored light S has dS/dt = −S/τ + q. */
static void integrals(struct crt_photodiode *d, uint64_t t0, uint64_t t1, double hz,
                      struct crt_phasor term[CRT_MAX_TERMS])
{
    double first[CRT_MAX_TERMS], last[CRT_MAX_TERMS];
    assert(t0 <= t1);
    crt_photodiode_terms(d, t0, first);
    crt_photodiode_terms(d, t1, last);
    for (int k = 0; k < CRT_MAX_TERMS; k++)
        term[k] = (struct crt_phasor){0, 0};
    falling(d, t0, t1, hz, term);
    for (int k = 0; k < crt_diode_terms(d); k++) {
        double tau = d->tube->desc.phosphor->term[k].tau_s, x = TWO_PI * hz * tau;
        struct crt_phasor left =
            turn((struct crt_phasor){last[k] * tau, 0}, hz * crt_seconds(t0, t1));
        double re = first[k] * tau - left.re + term[k].re, im = term[k].im - left.im;
        term[k] = (struct crt_phasor){(re + im * x) / (1 + x * x), (im - re * x) / (1 + x * x)};
    }
}

void crt_photodiode_gather(struct crt_photodiode *d, uint64_t t0, uint64_t t1,
                           double cd_s_m2[CRT_MAX_COLOURS])
{
    struct crt_phasor term[CRT_MAX_TERMS];
    integrals(d, t0, t1, 0, term);
    for (int c = 0; c < CRT_MAX_COLOURS; c++)
        cd_s_m2[c] = 0;
    for (int k = 0; k < crt_diode_terms(d); k++)
        cd_s_m2[d->tube->desc.phosphor->term[k].colour] += term[k].re;
}

struct crt_phasor crt_photodiode_harmonic(struct crt_photodiode *d, uint64_t t0, uint64_t t1,
                                          double hz)
{
    struct crt_phasor term[CRT_MAX_TERMS], sum = {0, 0};
    integrals(d, t0, t1, hz, term);
    for (int k = 0; k < crt_diode_terms(d); k++) {
        sum.re += term[k].re;
        sum.im += term[k].im;
    }
    return sum;
}
