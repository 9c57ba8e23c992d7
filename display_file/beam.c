#include "display_file/beam.h"

#include <stddef.h>

#include "display_file/df_regs.h"
#include "display_file/dpu_internal.h"

#define INTENSIFY_LEVEL 7

static void make_stroke(const struct df_dpu *dpu, const struct df_stretch *s, unsigned level,
                        struct crt_stroke *stroke)
{
    const struct crt_placing *placing = &dpu->placing;
    bool still = s->x0 == s->x1 && s->y0 == s->y1;
    float x, y;

    /* In this order nothing is read back as a whole that has just been stored in parts, which
     * would cost a stall or two a dot. */
    crt_place(placing, s->x0, s->y0, &x, &y);
    stroke->x0 = stroke->x1 = x;
    stroke->y0 = stroke->y1 = y;
    if (!still)
        crt_place(placing, s->x1, s->y1, &stroke->x1, &stroke->y1);
    stroke->t0 = s->t0;
    stroke->t1 = s->t1;
    stroke->drive = (float)dpu->desc.drive[level];
    stroke->source = dpu->source;
    stroke->level = df_dpu_level(dpu);
}

static void commit(struct df_dpu *dpu, const struct crt_stroke *stroke)
{
    dpu->usage.strokes++;
    dpu->usage.lit_ps += stroke->t1 - stroke->t0;
    dpu->desc.beam.commit(dpu->desc.beam.ctx, stroke);
}

static uint64_t offer(struct df_dpu *dpu, const struct crt_stroke *stroke)
{
    const struct df_beam *beam = &dpu->desc.beam;
    return beam->offer ? beam->offer(beam->ctx, stroke) : DF_NO_HIT;
}

bool df_beam_light(struct df_dpu *dpu, const struct df_stretch *s, bool hits, uint64_t *when)
{
    struct crt_stroke stroke;
    uint64_t fired;

    if (s->t1 <= s->t0)
        return false;
    make_stroke(dpu, s, dpu->intensity, &stroke);
    fired = offer(dpu, &stroke);
    if (!hits || fired > s->t1) {
        commit(dpu, &stroke);
        return false;
    }
    if (fired < s->t0)
        fired = s->t0;
    *when = fired;
    if (fired > s->t0) {
        double part = (double)(fired - s->t0) / (double)(s->t1 - s->t0);
        struct df_stretch lit = *s;
        lit.t1 = fired;
        lit.x1 = s->x0 + (s->x1 - s->x0) * part;
        lit.y1 = s->y0 + (s->y1 - s->y0) * part;
        make_stroke(dpu, &lit, dpu->intensity, &stroke);
        commit(dpu, &stroke);
    }
    return true;
}

uint64_t df_beam_hit(struct df_dpu *dpu, int32_t x, int32_t y, double ux, double uy, uint64_t when)
{
    dpu->hit = true;
    dpu->hit_x = (uint16_t)(x & DF_XPR_X);
    dpu->hit_y = (uint16_t)(y & DF_YPR_Y);
    if (dpu->pen_interrupt)
        dpu->stopping = true;
    if (dpu->pen_intensify && dpu->desc.timing.intensify_ps > 0) {
        struct df_stretch spot = {when, when + dpu->desc.timing.intensify_ps, ux, uy, ux, uy};
        struct crt_stroke stroke;
        make_stroke(dpu, &spot, INTENSIFY_LEVEL, &stroke);
        (void)offer(dpu, &stroke);
        commit(dpu, &stroke);
        when = spot.t1;
    }
    return when;
}

uint64_t df_beam_dot(struct df_dpu *dpu, int32_t x, int32_t y, double ux, double uy, uint64_t t0,
                     uint64_t t1, bool *hits)
{
    struct df_stretch dot = {t0, t1, ux, uy, ux, uy};
    uint64_t when, ignored, free;

    if (!df_beam_light(dpu, &dot, *hits, &when))
        return 0;
    *hits = false;
    free = df_beam_hit(dpu, x, y, ux, uy, when);
    dot.t0 = free;
    dot.t1 = t1 + (free - when);
    (void)df_beam_light(dpu, &dot, false, &ignored);
    return free - when;
}
