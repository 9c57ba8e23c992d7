/* The head in a snapshot: registers, and how far the timing has come. */
#include "raster/head_parts.h"

#define VERSION 1

static void span_state(struct ras_span *span, struct crt_state *s)
{
    crt_state_u32(s, &span->visible);
    crt_state_u32(s, &span->sync_start);
    crt_state_u32(s, &span->sync_end);
    crt_state_u32(s, &span->total);
}

static void timing_state(struct ras_timing *t, struct crt_state *s)
{
    crt_state_u64(s, &t->clock.num);
    crt_state_u64(s, &t->clock.den);
    span_state(&t->h, s);
    span_state(&t->v, s);
    crt_state_bool(s, &t->interlaced);
    crt_state_bool(s, &t->h_plus);
    crt_state_bool(s, &t->v_plus);
}

static void latch_state(struct ras_latch *latch, struct crt_state *s)
{
    crt_state_u32(s, &latch->base);
    crt_state_u32(s, &latch->pitch);
    crt_state_u32(s, &latch->format);
    crt_state_check(
        s, latch->base % 4 == 0 && latch->pitch % 4 == 0 && ras_format_exists(latch->format),
        "video base, pitch or format");
}

static void register_state(struct ras_head *head, struct crt_state *s)
{
    crt_state_bool(s, &head->blank);
    crt_state_u32(s, &head->status);
    crt_state_u32(s, &head->irq_enable);
    crt_state_u32(s, &head->overscan);
    crt_state_u32(s, &head->compare);
    latch_state(&head->latch, s);
    latch_state(&head->next, s);
    uint32_t colours = head->overscan;
    for (int i = 0; i < VIDEO_LUT_ENTRIES; i++) {
        crt_state_u32(s, &head->lut[i]);
        colours |= head->lut[i];
    }
    crt_state_check(s, (head->status & ~(uint32_t)RAS_STATUS_STAYS) == 0, "video status");
    crt_state_check(s, (head->irq_enable & ~(uint32_t)RAS_STATUS_IRQ) == 0, "video interrupt");
    crt_state_check(s, (colours & ~RAS_COLOUR) == 0, "video colour");
}

/* A timing that the head would have taken. The registers hold any numbers. */
static void timings_state(struct ras_head *head, struct crt_state *s)
{
    struct crt_error err;
    timing_state(&head->timing, s);
    timing_state(&head->wanted, s);
    crt_state_check(s, head->wanted.clock.den > 0, "video dot clock");
    crt_state_check(s,
                    ras_timing_check(&head->timing, &err) &&
                        ras_monitor_follows(&head->desc.monitor, &head->timing, "", &err),
                    "video timing");
}

/* The next event is one that the timing has there. */
static bool sane_event(struct ras_head *head, uint64_t dot, unsigned kind)
{
    if (!head->on)
        return dot == 0 && kind == 0;
    if (dot > crt_tick_at(head->timing.clock, CRT_STATE_LATEST - head->origin))
        return false;
    ras_schedule(head, dot, kind);
    return head->next_dot == dot && head->next_kind == kind;
}

static void progress_state(struct ras_head *head, struct crt_state *s)
{
    uint64_t dot = head->next_dot;
    unsigned kind = head->next_kind;
    crt_state_bool(s, &head->on);
    crt_state_u64(s, &head->origin);
    crt_state_u64(s, &head->lit_until);
    crt_state_u64(s, &dot);
    crt_state_unsigned(s, &kind, RAS_EVENTS - 1);
    if (!crt_state_check(s, head->origin < CRT_STATE_LATEST && head->lit_until < CRT_STATE_LATEST,
                         "video time"))
        return;
    if (s->loading)
        ras_sweep_of(&head->sweep, &head->timing, &head->desc);
    crt_state_check(s, sane_event(head, dot, kind), "next video event");
}

void ras_head_state(struct ras_head *head, struct crt_state *s)
{
    crt_state_begin(s, "VID ", VERSION);
    register_state(head, s);
    timings_state(head, s);
    progress_state(head, s);
    crt_state_end(s);
    if (!s->loading)
        return;
    if (s->failed) {
        head->status = head->irq_enable = 0; /* so that no wire is called */
        ras_head_reset(head, 0);
    } else if (head->on) {
        ras_signals_from(head, head->next_dot);
    } else {
        ras_stop(head);
    }
}
