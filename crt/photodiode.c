#include "crt/photodiode.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crt/photodiode_parts.h"
#include "crt/share.h"
#include "crt/tube_parts.h"

static bool sane_desc(const struct crt_photodiode_desc *desc, struct crt_error *err)
{
    if (desc->kind == CRT_DIODE_SCREEN)
        return true;
    if (!(fabs(desc->x_mm) < 1e6 && fabs(desc->y_mm) < 1e6))
        return crt_fail(err, "a photodiode at %g,%g mm is nowhere near the screen", desc->x_mm,
                        desc->y_mm);
    if (desc->kind == CRT_DIODE_DISC && !(desc->diameter_mm > 1e-3 && desc->diameter_mm < 1e4))
        return crt_fail(err, "a photodiode of %g mm is impossible; use 0.001 to 10000 mm",
                        desc->diameter_mm);
    return true;
}

/* ---- deposits ------------------------------------------------------------------------------------- */

static struct crt_deposit deposit_of(const struct crt_photodiode *d,
                                     const struct crt_diode_piece *piece)
{
    const struct crt_phosphor *phosphor = d->tube->desc.phosphor;
    uint64_t t0 = piece->t0 > d->from ? piece->t0 : d->from;
    struct crt_deposit deposit = {.t0 = t0, .t1 = piece->t1, .source = piece->source};
    double light = 0, moment = 0;
    for (int beam = 0; beam < piece->beams; beam++) {
        const struct crt_flux_moments *m = &piece->beam[beam];
        for (int k = 0; k < phosphor->terms; k++) {
            double weight = crt_diode_weight(d, piece, beam, k);
            deposit.fluence[phosphor->term[k].colour] += weight * m->m[0];
            light += weight * m->m[0];
            moment += weight * (m->m[1] + m->middle * m->m[0]);
        }
    }
    if (light > 0)
        deposit.mean_t_s = moment / light - crt_seconds(piece->t0, t0);
    return deposit;
}

/* Deposits of pieces that have begun. */
static void show(struct crt_photodiode *d)
{
    size_t until = d->shown;
    while (until < d->count && d->piece[until].t0 < d->tube->now)
        until++;
    if (until > d->deposit_room) {
        size_t room = until * 2;
        struct crt_deposit *deposit = realloc(d->deposit, room * sizeof *deposit);
        if (!deposit) {
            d->lost++;
            return;
        }
        d->deposit = deposit;
        d->deposit_room = room;
    }
    for (; d->shown < until; d->shown++)
        d->deposit[d->shown] = deposit_of(d, &d->piece[d->shown]);
}

struct crt_photodiode *crt_photodiode_open(struct crt_tube *tube,
                                           const struct crt_photodiode_desc *desc,
                                           struct crt_error *err)
{
    if (!sane_desc(desc, err))
        return NULL;
    struct crt_photodiode *d = calloc(1, sizeof *d);
    if (!d) {
        crt_fail(err, "out of memory for a photodiode");
        return NULL;
    }
    d->tube = tube;
    d->desc = *desc;
    d->flux_of = SIZE_MAX;
    crt_aperture_init(&d->aperture, desc, tube->desc.row);
    crt_diode_begin(d);
    show(d);
    d->next = tube->diodes;
    tube->diodes = d;
    return d;
}

static void drop_pieces(struct crt_photodiode *d)
{
    for (size_t i = d->first; i < d->count; i++)
        free(d->piece[i].cut);
    d->first = d->count = d->shown = d->cursor_at = d->marks = 0;
    d->flux_of = SIZE_MAX;
}

void crt_photodiode_close(struct crt_photodiode *d)
{
    if (!d)
        return;
    struct crt_photodiode **link = &d->tube->diodes;
    while (*link && *link != d)
        link = &(*link)->next;
    assert(*link);
    *link = d->next;
    drop_pieces(d);
    crt_aperture_free(&d->aperture);
    crt_flux_free(&d->flux);
    for (int i = 0; i < CRT_DOT_ENERGIES; i++)
        free(d->energy[i]);
    free(d->piece);
    free(d->end);
    free(d->mark);
    free(d->deposit);
    free(d);
}

const struct crt_photodiode_desc *crt_photodiode_desc(const struct crt_photodiode *d)
{
    return &d->desc;
}

bool crt_photodiode_intact(const struct crt_photodiode *d, struct crt_error *err)
{
    if (d->lost + d->aperture.lost == 0)
        return true;
    return crt_fail(err, "out of memory: the photodiode has missed light; look at a shorter time");
}

uint64_t crt_photodiode_from(const struct crt_photodiode *d)
{
    return d->from;
}

uint64_t crt_photodiode_now(const struct crt_photodiode *d)
{
    return d->tube->now;
}

/* ---- feeding ------------------------------------------------------------------------------------- */

static bool make_room(struct crt_photodiode *d)
{
    if (d->count < d->room)
        return true;
    size_t room = d->room ? d->room * 2 : 64;
    struct crt_diode_piece *piece = realloc(d->piece, room * sizeof *piece);
    if (!piece)
        return false;
    d->piece = piece;
    double *end = realloc(d->end, room * (size_t)crt_diode_terms(d) * sizeof *end);
    if (!end)
        return false;
    d->end = end;
    d->room = room;
    return true;
}

/* Takes the piece's cut. */
static void add(struct crt_photodiode *d, struct crt_diode_piece *piece)
{
    size_t terms = (size_t)crt_diode_terms(d);
    d->flux_of = SIZE_MAX;
    if (!make_room(d) || !crt_diode_flux(d, piece, &d->flux)) {
        d->lost++;
        free(piece->cut);
        return;
    }
    if (!crt_diode_finish(d, piece, &d->flux, d->end + d->count * terms)) {
        free(piece->cut);
        return;
    }
    d->flux_of = d->count;
    d->piece[d->count++] = *piece;
}

static struct crt_diode_piece piece_of(uint64_t t0, uint64_t t1, uint32_t source, uint64_t from)
{
    return (struct crt_diode_piece){.t0 = t0,
                                    .t1 = t1,
                                    .source = source,
                                    .beams = 1,
                                    .from_s = from > t0 ? crt_seconds(t0, from) : 0,
                                    .to_s = crt_seconds(t0, t1)};
}

void crt_diode_add_entry(struct crt_photodiode *d, const struct crt_entry *entry, uint64_t from)
{
    const struct crt_stroke *s = &entry->stroke;
    struct crt_diode_piece piece = piece_of(s->t0, s->t1, s->source, from);
    piece.entry = *entry;
    add(d, &piece);
}

void crt_diode_add_line(struct crt_photodiode *d, const struct crt_scan_line *line,
                        const struct crt_knobs *knobs, uint64_t from)
{
    struct crt_diode_piece piece = piece_of(line->t0, line->t1, line->source, from);
    piece.beams = line->guns;
    if (!crt_line_cut(d, line, knobs, &piece.cut))
        d->lost++;
    else if (piece.cut)
        add(d, &piece);
}

void crt_diodes_stroke(struct crt_photodiode *list, const struct crt_entry *entry)
{
    for (; list; list = list->next)
        crt_diode_add_entry(list, entry, 0);
}

void crt_diodes_scan_line(struct crt_photodiode *list, const struct crt_scan_line *line,
                          const struct crt_knobs *knobs)
{
    for (; list; list = list->next)
        crt_diode_add_line(list, line, knobs, 0);
}

void crt_diodes_advance(struct crt_photodiode *list)
{
    for (; list; list = list->next)
        show(list);
}

const struct crt_deposit *crt_photodiode_deposits(const struct crt_photodiode *d, size_t *count)
{
    *count = d->shown - d->first;
    return d->deposit ? d->deposit + d->first : NULL;
}

/* ---- forgetting ----------------------------------------------------------------------------------- */

/* Moves what is left to the front once that is the smaller part. */
static void close_up(struct crt_photodiode *d)
{
    size_t gone = d->first, left = d->count - gone, terms = (size_t)crt_diode_terms(d);
    if (gone < left || gone == 0)
        return;
    memmove(d->piece, d->piece + gone, left * sizeof d->piece[0]);
    memmove(d->end, d->end + gone * terms, left * terms * sizeof d->end[0]);
    memmove(d->deposit, d->deposit + gone, (d->shown - gone) * sizeof d->deposit[0]);
    d->first = 0;
    d->count -= gone;
    d->shown -= gone;
    d->cursor_at -= gone;
    crt_diode_move_marks(d, gone);
    d->flux_of = SIZE_MAX;
}

void crt_photodiode_forget(struct crt_photodiode *d, uint64_t t)
{
    t = t < d->tube->now ? t : d->tube->now;
    if (t <= d->from)
        return;
    size_t first = d->first;
    for (; first < d->shown && d->piece[first].done <= t; first++) {
        crt_diode_pass(d, &d->base, first);
        free(d->piece[first].cut);
        d->piece[first].cut = NULL;
    }
    crt_diode_drop_marks(d, first);
    d->first = first;
    d->from = t;
    if (d->cursor_at < first) {
        d->cursor_at = first;
        d->cursor = d->base;
    }
    close_up(d);
}

void crt_diodes_restart(struct crt_photodiode *list, bool dark)
{
    for (; list; list = list->next) {
        drop_pieces(list);
        if (dark)
            list->base = (struct crt_diode_store){.t = list->tube->now};
        else
            crt_diode_begin(list);
        list->from = list->tube->now;
        list->cursor = list->base;
        show(list);
    }
}
