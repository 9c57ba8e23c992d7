/* Light that was on the place before the photodiode: planes and journal, per term. */
#include <math.h>
#include <stdlib.h>

#include "crt/line_look.h"
#include "crt/maths.h"
#include "crt/photodiode_parts.h"
#include "crt/share.h"
#include "crt/tube_parts.h"

/* ---- planes -------------------------------------------------------------------------------------- */

/* Mean over the disc: rings at the nodes of Gauss and Legendre, eight to three sigma, and points two thirds of a sigma
 * apart along each. What is stored is a sum of spots, so that it is smooth over a sigma. Discs of hundreds of sigma
 * have coarser rings (64 panels, 2048 points): a single spot on them is seen to a tenth. */
static void planes_on_disc(struct crt_photodiode *d, double cd_m2[CRT_MAX_TERMS])
{
    const struct crt_aperture *a = &d->aperture;
    double sigma = crt_spot_sigma0(d->tube->desc.row), ratio = a->radius_mm / sigma;
    int panels = (int)fmin(ceil(ratio / 3), 64) + 1;
    for (int p = 0; p < panels; p++)
        for (int i = 0; i < CRT_FLUX_NODES; i++) {
            double from = a->radius_mm * p / panels, to = a->radius_mm * (p + 1) / panels;
            double r = crt_flux_time(from, to, i);
            double ring = crt_flux_load[i] * (to - from) / 2 * 2 * r / a->radius_mm / a->radius_mm;
            int points = (int)fmin(ceil(6.3 * r / sigma * 1.5), 2048) + 12;
            for (int n = 0; n < points; n++) {
                double angle = 6.28318530717958648 * n / points, here[CRT_MAX_TERMS] = {0};
                crt_tube_look_at_planes(d->tube, a->x_mm + r * crt_cos(angle),
                                        a->y_mm + r * crt_sin(angle), d->tube->now, here);
                for (int k = 0; k < crt_diode_terms(d); k++)
                    cd_m2[k] += ring / points * here[k];
            }
        }
}

static void planes_at(struct crt_photodiode *d, double cd_m2[CRT_MAX_TERMS])
{
    const struct crt_tube *tube = d->tube;
    if (d->desc.kind == CRT_DIODE_POINT) {
        crt_tube_look_at_planes(tube, d->desc.x_mm, d->desc.y_mm, tube->now, cd_m2);
    } else if (d->desc.kind == CRT_DIODE_DISC) {
        planes_on_disc(d, cd_m2);
    } else {
        double cell = tube->desc.grid.cell_mm, sum[CRT_MAX_TERMS] = {0};
        crt_tube_planes_stored(tube, tube->now, sum);
        for (int k = 0; k < crt_diode_terms(d); k++)
            cd_m2[k] +=
                sum[k] * cell * cell / d->aperture.area_mm2 / tube->desc.phosphor->term[k].tau_s;
    }
}

/* ---- journal --------------------------------------------------------------------------------------- */

/* Adds what a piece gave between `from` and `to`, by the terms of `mask`; its cut is its caller's. */
static void look_at(struct crt_photodiode *d, struct crt_diode_piece *piece, uint64_t from,
                    uint64_t to, uint32_t mask)
{
    double end[CRT_MAX_TERMS];
    uint64_t now = d->tube->now;
    to = to < piece->t1 ? to : piece->t1;
    if (to <= piece->t0 || to <= from)
        return;
    piece->from_s = from > piece->t0 ? crt_seconds(piece->t0, from) : 0;
    piece->to_s = crt_seconds(piece->t0, to);
    d->flux_of = SIZE_MAX;
    if (!crt_diode_flux(d, piece, &d->flux))
        d->lost++;
    else if (crt_diode_finish(d, piece, &d->flux, end))
        for (int k = 0; k < crt_diode_terms(d); k++)
            if (mask >> k & 1)
                d->base.cd_m2[k] += end[k] * crt_exp(-crt_seconds(piece->done, now) /
                                                     d->tube->desc.phosphor->term[k].tau_s);
}

static void look_at_entries(struct crt_photodiode *d, const struct crt_entries *list, uint64_t from,
                            uint64_t to, uint32_t mask)
{
    for (size_t i = 0; i < list->count; i++) {
        const struct crt_stroke *s = &list->at[i].stroke;
        struct crt_diode_piece piece = {.t0 = s->t0, .t1 = s->t1, .beams = 1};
        piece.entry = list->at[i];
        look_at(d, &piece, from, to, mask);
    }
}

static struct crt_scan_line scan_line_of(const struct crt_tube *tube, const struct crt_line *line)
{
    const struct crt_strip *strip = line->strip;
    struct crt_scan_line s = {line->t0,           line->t1,
                              strip->way.x0,      strip->y[line->lane],
                              strip->way.x1,      strip->y[line->lane],
                              strip->way.dots,    crt_tube_guns(tube->desc.row),
                              {NULL, NULL, NULL}, line->source};
    for (int gun = 0; gun < s.guns; gun++)
        s.drive[gun] =
            strip->drive + (size_t)(gun * CRT_STRIP_LINES + line->lane) * (size_t)strip->way.dots;
    return s;
}

static void look_at_lines(struct crt_photodiode *d, const struct crt_line_list *list, uint64_t from,
                          uint64_t to, uint32_t mask)
{
    for (size_t i = 0; i < list->count; i++) {
        const struct crt_line *line = &list->at[i];
        struct crt_scan_line s = scan_line_of(d->tube, line);
        struct crt_diode_piece piece = {.t0 = s.t0, .t1 = s.t1, .beams = s.guns};
        if (s.t0 >= to || s.t1 <= from)
            continue;
        if (!crt_line_cut(d, &s, &line->strip->way.knobs, &piece.cut))
            d->lost++;
        else if (piece.cut)
            look_at(d, &piece, from, to, mask);
        free(piece.cut);
    }
}

/* ---- both ------------------------------------------------------------------------------------------- */

void crt_diode_begin(struct crt_photodiode *d)
{
    const struct crt_tube *tube = d->tube;
    const struct crt_entries *entries = &tube->journal.now;
    const struct crt_line_list *lines = &tube->lines.now;
    d->from = tube->now;
    d->base = (struct crt_diode_store){.t = tube->now};
    planes_at(d, d->base.cd_m2);
    look_at_entries(d, &tube->journal.before, 0, tube->begin, tube->quick);
    look_at_entries(d, entries, tube->begin, tube->now, UINT32_MAX);
    if (tube->line_pass) {
        look_at_lines(d, &tube->lines.before, 0, tube->begin, tube->quick);
        look_at_lines(d, lines, tube->begin, tube->now, UINT32_MAX);
    }
    for (size_t i = 0; i < entries->count; i++)
        if (entries->at[i].stroke.t1 > tube->now)
            crt_diode_add_entry(d, &entries->at[i], tube->now);
    for (size_t i = 0; i < lines->count; i++) {
        struct crt_scan_line s = scan_line_of(tube, &lines->at[i]);
        if (s.t1 > tube->now)
            crt_diode_add_line(d, &s, &lines->at[i].strip->way.knobs, tube->now);
    }
    d->cursor = d->base;
}
