#include "crt/line_state.h"

#include <math.h>

#include "crt/maths.h"

/* Lines lit longer than this are none that a head could have drawn, ps (two and a half hours). */
#define LONGEST (UINT64_C(1) << 53)

#define MOST_KNOB 1e6

/* ---- timing ---------------------------------------------------------------------------------- */

static bool has_plane(const struct crt_tube *tube, unsigned term)
{
    for (int k = 0; k < tube->planes.count; k++)
        if ((unsigned)tube->planes.plane[k].term == term)
            return true;
    return false;
}

/* Planes of the terms of a snapshot, in its order. */
static void take_planes(struct crt_tube *tube, struct crt_state *s, unsigned count,
                        const unsigned term[])
{
    double epoch_s = (double)tube->desc.epoch.den / (double)tube->desc.epoch.num;
    crt_planes_clear(&tube->planes);
    for (unsigned i = 0; i < count; i++) {
        double tau = tube->desc.phosphor->term[term[i]].tau_s;
        if (!crt_state_check(s, !has_plane(tube, term[i]), "phosphor term"))
            return;
        if (!crt_planes_add(&tube->planes, (int)term[i], (float)crt_exp(-epoch_s / tau))) {
            crt_state_fail(s, "not enough memory for the snapshot's light; close other programs");
            return;
        }
    }
    crt_tube_note_quick(tube);
}

void crt_line_timing_state(struct crt_tube *tube, struct crt_state *s)
{
    struct crt_rate *rate = &tube->desc.epoch;
    unsigned count = (unsigned)tube->planes.count, term[CRT_MAX_TERMS] = {0};
    struct crt_rate old = *rate;
    crt_state_u64(s, &rate->num);
    crt_state_u64(s, &rate->den);
    crt_state_u64(s, &tube->origin);
    crt_state_u64(s, &tube->first);
    /* Epochs between a microsecond and some minutes. */
    bool sane = rate->num > 0 && rate->den > 0 && rate->num < UINT64_C(1) << 40 &&
                rate->den < UINT64_C(1) << 40 && rate->num / rate->den <= 1000000 &&
                rate->den / rate->num <= 1000;
    if (!crt_state_check(s,
                         sane && tube->origin < CRT_STATE_LATEST && tube->first < CRT_STATE_LATEST,
                         "timing")) {
        *rate = old;
        tube->origin = tube->first = 0;
    }
    crt_state_unsigned(s, &count, (unsigned)tube->desc.phosphor->terms);
    for (unsigned i = 0; i < count && !s->failed; i++) {
        term[i] = s->loading ? 0 : (unsigned)tube->planes.plane[i].term;
        crt_state_unsigned(s, &term[i], (unsigned)tube->desc.phosphor->terms - 1);
    }
    if (s->loading && !s->failed)
        take_planes(tube, s, count, term);
}

/* ---- lines ----------------------------------------------------------------------------------- */

static bool sane_line(const struct crt_tube *tube, const struct crt_scan_line *line,
                      const struct crt_knobs *knobs)
{
    return line->t0 <= tube->last_start && line->t1 > line->t0 && line->t1 - line->t0 <= LONGEST &&
           isfinite(line->x0) && isfinite(line->x1) && isfinite(line->y0) && line->x0 < line->x1 &&
           line->dots >= 1 && line->dots <= CRT_MAX_DOTS && fabs(knobs->brightness) <= MOST_KNOB &&
           fabs(knobs->contrast) <= MOST_KNOB && fabs(knobs->focus) <= MOST_KNOB;
}

/* All but the dots. False: refused. */
static bool line_state(const struct crt_tube *tube, struct crt_scan_line *line,
                       struct crt_knobs *knobs, struct crt_state *s)
{
    int32_t dots = line->dots;
    crt_state_u64(s, &line->t0);
    crt_state_u64(s, &line->t1);
    crt_state_f32(s, &line->x0);
    crt_state_f32(s, &line->x1);
    crt_state_f32(s, &line->y0);
    crt_state_i32(s, &dots);
    crt_state_u32(s, &line->source);
    crt_state_f64(s, &knobs->brightness);
    crt_state_f64(s, &knobs->contrast);
    crt_state_f64(s, &knobs->focus);
    line->dots = dots;
    line->y1 = line->y0;
    return crt_state_check(s, sane_line(tube, line, knobs), "scan line");
}

static void save_line(const struct crt_tube *tube, const struct crt_line *line, struct crt_state *s)
{
    const struct crt_strip *strip = line->strip;
    struct crt_scan_line l = {.t0 = line->t0,
                              .t1 = line->t1,
                              .x0 = strip->way.x0,
                              .x1 = strip->way.x1,
                              .y0 = strip->y[line->lane],
                              .dots = strip->way.dots,
                              .source = line->source};
    struct crt_knobs knobs = strip->way.knobs;
    line_state(tube, &l, &knobs, s);
    size_t dots = (size_t)strip->way.dots;
    for (int gun = 0; gun < crt_tube_guns(tube->desc.row); gun++)
        crt_state_bytes(s, strip->drive + (size_t)(gun * CRT_STRIP_LINES + line->lane) * dots,
                        dots);
}

static void load_line(struct crt_tube *tube, struct crt_line_list *list, bool before,
                      uint64_t *last, struct crt_state *s)
{
    static const char memory[] = "not enough memory for the snapshot's scan lines; close other "
                                 "programs";
    uint8_t drive[CRT_MAX_GUNS][CRT_MAX_DOTS];
    struct crt_scan_line line = {.guns = crt_tube_guns(tube->desc.row)};
    struct crt_knobs knobs = {0};
    if (!line_state(tube, &line, &knobs, s))
        return;
    bool here = before ? line.t0 < tube->begin : line.t1 > tube->begin;
    if (!crt_state_check(s, here && line.t0 >= *last, "order of scan lines"))
        return;
    *last = line.t0;
    for (int gun = 0; gun < line.guns; gun++) {
        crt_state_bytes(s, drive[gun], (size_t)line.dots);
        line.drive[gun] = drive[gun];
    }
    if (!s->failed && !crt_lines_push(&tube->lines, list, tube->desc.row, &knobs, &line))
        crt_state_fail(s, memory);
}

static void list_state(struct crt_tube *tube, struct crt_line_list *list, bool before,
                       struct crt_state *s)
{
    size_t count = list->count;
    uint64_t last = 0;
    if (s->loading)
        crt_line_list_clear(list);
    crt_state_size(s, &count, SIZE_MAX);
    for (size_t i = 0; i < count && !s->failed; i++)
        if (s->loading)
            load_line(tube, list, before, &last, s);
        else
            save_line(tube, &list->at[i], s);
}

void crt_lines_state(struct crt_tube *tube, struct crt_state *s)
{
    list_state(tube, &tube->lines.before, true, s);
    list_state(tube, &tube->lines.now, false, s);
}
