#include "tests/support/dpu_rig.h"

#include <math.h>
#include <string.h>

static uint64_t offer(void *ctx, const struct crt_stroke *s)
{
    struct dpu_rig *r = ctx;
    r->offered++;
    return r->pen_at >= s->t0 && r->pen_at < s->t1 ? r->pen_at : DF_NO_HIT;
}

static void commit(void *ctx, const struct crt_stroke *s)
{
    struct dpu_rig *r = ctx;
    assert_true(r->count < RIG_STROKES);
    r->strokes[r->count++] = *s;
}

static void interrupt(void *ctx, enum df_interrupt line, bool level, uint64_t t)
{
    struct dpu_rig *r = ctx;
    assert_true(r->event_count < DPU_RIG_EVENTS);
    r->events[r->event_count++] = (struct dpu_rig_event){line, level, t};
}

static void bell(void *ctx, uint64_t t)
{
    struct dpu_rig *r = ctx;
    (void)t;
    r->bells++;
}

void dpu_rig_restart(struct dpu_rig *r)
{
    r->count = r->event_count = r->bells = 0;
    r->offered = 0;
    r->pen_at = UINT64_MAX;
    df_dpu_init(&r->dpu, &r->desc);
}

void dpu_rig_init(struct dpu_rig *r)
{
    memset(r, 0, sizeof *r);
    for (size_t i = 0; i < sizeof r->memory / sizeof r->memory[0]; i++)
        r->memory[i] = DF_STOP;
    r->desc = (struct df_dpu_desc){
        .memory = r->memory,
        .memory_bytes = sizeof r->memory,
        .screen = {1024, 1024, 1024, 1024},
        .timing = RIG_TIMING,
        .drive = {0.30, 0.40, 0.50, 0.60, 0.70, 0.80, 0.90, 1.00},
        .beam = {r, offer, commit},
        .wires = {r, interrupt, bell},
    };
    dpu_rig_restart(r);
}

void dpu_rig_load(struct dpu_rig *r, uint16_t address, const uint16_t *words, size_t count)
{
    assert_true(address / 2 + count <= sizeof r->memory / sizeof r->memory[0]);
    memcpy(&r->memory[address / 2], words, count * sizeof *words);
}

void dpu_rig_continue(struct dpu_rig *r)
{
    for (int i = 0; i < 10000 && r->dpu.state == DF_RUNNING; i++)
        df_dpu_step(&r->dpu);
}

void dpu_rig_go(struct dpu_rig *r, uint16_t address)
{
    df_dpu_write(&r->dpu, DF_DPC, address, r->dpu.t);
    dpu_rig_continue(r);
}

uint16_t dpu_rig_reg(const struct dpu_rig *r, unsigned offset)
{
    return df_dpu_read(&r->dpu, offset);
}

double rig_x0(const struct crt_stroke *s)
{
    return (double)s->x0 + 511.5;
}

double rig_y0(const struct crt_stroke *s)
{
    return (double)s->y0 + 511.5;
}

double rig_x1(const struct crt_stroke *s)
{
    return (double)s->x1 + 511.5;
}

double rig_y1(const struct crt_stroke *s)
{
    return (double)s->y1 + 511.5;
}

void dpu_rig_expect_stroke(const struct dpu_rig *r, size_t index, double x0, double y0, double x1,
                           double y1)
{
    const struct crt_stroke *s = &r->strokes[index];
    assert_true(index < r->count);
    if (fabs(rig_x0(s) - x0) > 1e-4 || fabs(rig_y0(s) - y0) > 1e-4 || fabs(rig_x1(s) - x1) > 1e-4 ||
        fabs(rig_y1(s) - y1) > 1e-4)
        fail_msg("stroke %zu goes (%g, %g) to (%g, %g), not (%g, %g) to (%g, %g)", index, rig_x0(s),
                 rig_y0(s), rig_x1(s), rig_y1(s), x0, y0, x1, y1);
}
