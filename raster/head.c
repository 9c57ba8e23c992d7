#include "raster/head.h"

#include <assert.h>
#include <math.h>

#include "raster/head_parts.h"

/* ---- interrupts ------------------------------------------------------------------------------- */

static const uint32_t bit_of[RAS_INT_COUNT] = {
    [RAS_INT_RETRACE] = VIDEO_STATUS_RETRACE,
    [RAS_INT_COMPARE] = VIDEO_STATUS_COMPARE,
};

bool ras_head_interrupt(const struct ras_head *head, enum ras_interrupt which)
{
    return (head->status & head->irq_enable & bit_of[which]) != 0;
}

void ras_change(struct ras_head *head, uint32_t status, uint32_t irq_enable, uint64_t t)
{
    const struct ras_wires *wires = &head->desc.wires;
    uint32_t before = head->status & head->irq_enable, after = status & irq_enable;
    head->status = status;
    head->irq_enable = irq_enable;
    for (int i = 0; wires->interrupt && i < RAS_INT_COUNT; i++)
        if ((before ^ after) & bit_of[i])
            wires->interrupt(wires->ctx, (enum ras_interrupt)i, (after & bit_of[i]) != 0, t);
}

/* ---- on and off ------------------------------------------------------------------------------- */

static void take(struct ras_head *head, uint64_t t)
{
    head->latch = head->next;
    if (head->hooks.latch)
        head->hooks.latch(head->hooks.ctx, t);
}

void ras_start(struct ras_head *head, uint64_t t)
{
    const struct ras_wires *wires = &head->desc.wires;
    head->on = true;
    head->origin = t;
    ras_sweep_of(&head->sweep, &head->timing, &head->desc);
    ras_schedule(head, 0, 0);
    ras_signals_from(head, 0);
    if (wires->retime)
        wires->retime(wires->ctx, ras_field_rate(&head->timing), t);
    take(head, t);
}

void ras_stop(struct ras_head *head)
{
    head->on = false;
    head->next_dot = head->next_kind = 0;
    head->next_time = head->signal_time = RAS_NEVER;
}

/* ---- events ----------------------------------------------------------------------------------- */

uint64_t ras_head_next(const struct ras_head *head)
{
    bool signal = head->hooks.signal && head->signal_time < head->next_time;
    return signal ? head->signal_time : head->next_time;
}

/* The second field of a frame is the odd one. */
static void retrace(struct ras_head *head, uint64_t dot, uint64_t t)
{
    const struct ras_wires *wires = &head->desc.wires;
    bool odd = dot / ras_field_dots(&head->timing) & 1;
    if (wires->retrace)
        wires->retrace(wires->ctx, t, odd || !head->timing.interlaced);
}

static void happen(struct ras_head *head)
{
    uint64_t dot = head->next_dot, t = head->next_time, left = (uint64_t)head->sweep.left;
    unsigned kind = head->next_kind;
    ras_schedule(head, dot, kind + 1);
    switch (kind) {
    case RAS_EVENT_RETRACE:
        take(head, t);
        ras_change(head, head->status | VIDEO_STATUS_RETRACE, head->irq_enable, t);
        retrace(head, dot, t);
        break;
    case RAS_EVENT_COMPARE:
        ras_change(head, head->status | VIDEO_STATUS_COMPARE, head->irq_enable, t);
        break;
    default:
        ras_scan(head, dot ? dot + left : 0);
        break;
    }
}

void ras_head_event(struct ras_head *head, uint64_t t)
{
    while (head->next_time <= t) {
        if (head->hooks.signal)
            ras_signals_until(head, head->next_time);
        happen(head);
    }
    if (head->hooks.signal)
        ras_signals_until(head, t);
}

/* ---- set-up ----------------------------------------------------------------------------------- */

void ras_head_init(struct ras_head *head, const struct ras_head_desc *desc)
{
    struct crt_error err;
    assert(desc->buffer && (desc->guns == 1 || desc->guns == 3));
    assert(desc->width_mm > 0 && desc->height_mm > 0 && desc->border_mm >= 0);
    assert(isfinite(desc->width_mm + desc->height_mm + desc->border_mm));
    assert(ras_timing_check(&desc->timing, &err));
    assert(ras_monitor_follows(&desc->monitor, &desc->timing, "", &err));
    (void)err;
    *head = (struct ras_head){.desc = *desc};
    ras_head_reset(head, 0);
}

void ras_head_reset(struct ras_head *head, uint64_t t)
{
    ras_change(head, 0, 0, t);
    ras_stop(head);
    head->timing = head->wanted = head->desc.timing;
    head->blank = false;
    head->overscan = 0;
    head->compare = UINT32_MAX;
    head->next = (struct ras_latch){0, (head->timing.h.visible + 3) & ~3u, VIDEO_FORMAT_8};
    head->latch = head->next;
    for (uint32_t i = 0; i < VIDEO_LUT_ENTRIES; i++)
        head->lut[i] = i << 16 | i << 8 | i;
    head->origin = t;
    ras_sweep_of(&head->sweep, &head->timing, &head->desc);
}
