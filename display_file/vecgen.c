#include "display_file/vecgen.h"

#include <stdlib.h>

#include "display_file/beam.h"
#include "display_file/df_regs.h"
#include "display_file/dpu_internal.h"

/* The counter of unit k is 31 − k modulo 32; the conditions of vecgen.h turned into bits. */
const uint32_t df_line_patterns[4] = {
    [DF_LINE_SOLID] = UINT32_MAX,
    [DF_LINE_LONG] = UINT32_C(0x0000ffff),    /* counter 31…16 */
    [DF_LINE_SHORT] = UINT32_C(0x00ff00ff),   /* 31…24, 15…8 */
    [DF_LINE_DOTDASH] = UINT32_C(0xffff0300), /* 23, 22, 15…0 */
};

uint64_t df_vecgen_settle_ps(const struct df_timing *timing, uint32_t units)
{
    uint64_t ps = timing->settle_ps + timing->settle_unit_ps * units;
    return ps < timing->settle_max_ps ? ps : timing->settle_max_ps;
}

uint32_t df_vecgen_units(int32_t x0, int32_t y0, int32_t x1, int32_t y1)
{
    int32_t dx = abs(x1 - x0), dy = abs(y1 - y0);
    return (uint32_t)(dx > dy ? dx : dy);
}

/* Does the segment touch the screen rectangle? Both are convex: they are apart only when a side of
 * the rectangle or the line itself parts them. */
static bool touches_screen(const struct df_dpu *dpu, int32_t x0, int32_t y0, int32_t x1, int32_t y1)
{
    int32_t dx = x1 - x0, dy = y1 - y0;
    int32_t mx = dpu->max_x, my = dpu->max_y;
    int64_t c = (int64_t)dx * y0 - (int64_t)dy * x0; /* cross(d, p − p0) = dx·y − dy·x − c */
    int64_t a = -c, b = -(int64_t)dy * mx - c;
    int64_t e = (int64_t)dx * my - c, f = (int64_t)dx * my - (int64_t)dy * mx - c;

    if ((x0 < 0 && x1 < 0) || (x0 > mx && x1 > mx) || (y0 < 0 && y1 < 0) || (y0 > my && y1 > my))
        return false;
    return !((a > 0 && b > 0 && e > 0 && f > 0) || (a < 0 && b < 0 && e < 0 && f < 0));
}

/* How long the beam moves, and how long it has been moving `done` ps into the vector. */
static uint64_t motion(const struct df_pending_vector *v)
{
    return v->span - 2 * v->rest;
}

static uint64_t moved(const struct df_pending_vector *v, uint64_t done)
{
    uint64_t most = motion(v);
    return done < v->rest ? 0 : done - v->rest < most ? done - v->rest : most;
}

static double along(const struct df_pending_vector *v, int32_t from, int32_t to, uint64_t done)
{
    return from + (double)(to - from) * ((double)moved(v, done) / (double)motion(v));
}

/* The unit the beam is nearest to `done` ps into the vector; see "Pen latch" in vecgen.h. */
static void latched_unit(const struct df_pending_vector *v, uint64_t done, int32_t *x, int32_t *y)
{
    uint64_t n = v->units, whole = motion(v);
    int32_t k = (int32_t)((2 * n * moved(v, done) + whole) / (2 * whole));
    int32_t two_n = 2 * (int32_t)n;
    int32_t dx = v->x1 - v->x0, dy = v->y1 - v->y0;

    *x = v->x0 + (dx < 0 ? -1 : 1) * ((2 * abs(dx) * k + (int32_t)n) / two_n);
    *y = v->y0 + (dy < 0 ? -1 : 1) * ((2 * abs(dy) * k + (int32_t)n) / two_n);
}

/* Where the beam next starts or stops moving, at or before `to`. */
static uint64_t next_turn(const struct df_pending_vector *v, uint64_t from, uint64_t to)
{
    uint64_t start = v->rest, stop = v->span - v->rest;
    uint64_t turn = from < start ? start : from < stop ? stop : v->span;
    return turn < to ? turn : to;
}

/* Lights [from, to) of the vector, ps after its start, and goes on behind a pen hit that does not
 * stop it. `base` is the time at which the vector's first unit was or would have been lit. Returns
 * false when the pen stopped the vector; v->done then says where. */
static bool light_run(struct df_dpu *dpu, uint64_t from, uint64_t to, uint64_t *base, bool *hits)
{
    struct df_pending_vector *v = &dpu->vector;
    uint64_t when;

    while (from < to) {
        uint64_t end = next_turn(v, from, to);
        struct df_stretch s = {
            *base + from,
            *base + end,
            along(v, v->x0, v->x1, from),
            along(v, v->y0, v->y1, from),
            along(v, v->x0, v->x1, end),
            along(v, v->y0, v->y1, end),
        };
        uint64_t free;
        int32_t x, y;

        if (!df_beam_light(dpu, &s, *hits, &when)) {
            from = end;
            continue;
        }
        *hits = false;
        from = when - *base;
        latched_unit(v, from, &x, &y);
        free = df_beam_hit(dpu, x, y, along(v, v->x0, v->x1, from), along(v, v->y0, v->y1, from),
                           when);
        *base += free - when;
        if (dpu->stopping) {
            v->done = from;
            dpu->clock = free;
            df_dpu_stop_for_pen(dpu, when);
            return false;
        }
    }
    return true;
}

/* The time offset of the boundary before half-unit h (0 … 2·units). */
static uint64_t boundary(const struct df_pending_vector *v, uint32_t h)
{
    return v->rest + motion(v) * h / (2 * v->units);
}

/* Draws the vector from v->done on; its first unit's time is `base`. */
static void draw(struct df_dpu *dpu, uint64_t base, bool hits)
{
    struct df_pending_vector *v = &dpu->vector;
    uint32_t pattern = df_line_patterns[dpu->line_type];
    uint32_t k = 0, last = v->units;

    v->active = true;
    if (pattern == UINT32_MAX) {
        if (!light_run(dpu, v->done, v->span, &base, &hits))
            return;
        k = last + 1;
    }
    while (k <= last) {
        uint32_t first;
        uint64_t from, to;

        for (; k <= last && !(pattern >> (k & 31) & 1); k++)
            ;
        if (k > last)
            break;
        first = k;
        for (; k <= last && (pattern >> (k & 31) & 1); k++)
            ;
        from = first == 0 ? 0 : boundary(v, 2 * first - 1);
        to = k > last ? v->span : boundary(v, 2 * k - 1);
        if (from < v->done)
            from = v->done;
        if (!light_run(dpu, from, to, &base, &hits))
            return;
    }
    v->active = false;
    dpu->clock = base + v->span;
}

void df_vecgen_vector(struct df_dpu *dpu, bool on, int32_t dx, int32_t dy)
{
    const struct df_timing *timing = &dpu->desc.timing;
    struct df_pending_vector *v = &dpu->vector;
    int32_t x0 = dpu->x, y0 = dpu->y, x1 = x0 + dx, y1 = y0 + dy;
    uint32_t units = df_vecgen_units(x0, y0, x1, y1);
    bool starts_on, visible;
    uint64_t t0, t1, moving, resting;

    if (units == 0)
        return;
    dpu->x = df_wrap12(x1);
    dpu->y = df_wrap12(y1);
    starts_on = df_on_screen(dpu, x0, y0);
    visible = starts_on && df_on_screen(dpu, x1, y1);
    /* Assumed: the edge indicator is set by a vector that comes in from off screen. */
    if (!starts_on && touches_screen(dpu, x0, y0, x1, y1))
        dpu->edge = true;
    if (!on) {
        dpu->usage.moves++;
        df_dpu_schedule(dpu, df_vecgen_settle_ps(timing, units), 0, &t0, &t1);
        return;
    }
    dpu->usage.vectors++;
    moving = timing->vector_unit_ps * units;
    resting = 2 * timing->vector_rest_ps;
    df_dpu_schedule(dpu, timing->vector_setup_ps - resting, moving + resting, &t0, &t1);
    if (!visible || t1 <= t0 || df_blinked_out(dpu, t0))
        return;
    *v = (struct df_pending_vector){
        .x0 = x0, .y0 = y0, .x1 = x1, .y1 = y1, .units = units, .span = t1 - t0};
    v->rest = df_ratio(v->span, timing->vector_rest_ps, moving + resting);
    draw(dpu, t0, true);
}

void df_vecgen_resume(struct df_dpu *dpu)
{
    draw(dpu, dpu->clock - dpu->vector.done, false);
}
