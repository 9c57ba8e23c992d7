/* For traces: sync pulses and rows of the picture as they happen. Only a head with a hook comes here. */
#include "raster/head_parts.h"

/* What begins and what ends, in the order in which it is told at one dot. */
enum { PICTURE_END, HSYNC_END, VSYNC_END, HSYNC_BEGIN, VSYNC_BEGIN, PICTURE_BEGIN, KINDS };

static uint64_t picture(const struct ras_head *head, int64_t after, int64_t offset)
{
    int64_t last = (int64_t)head->timing.v.visible - 1;
    uint64_t begin = ras_line_after(head, after - offset, 0, last);
    return begin == RAS_NEVER ? begin : begin + (uint64_t)offset;
}

static uint64_t next_of(const struct ras_head *head, int kind, int64_t after)
{
    const struct ras_sweep *w = &head->sweep;
    const struct ras_span *h = &head->timing.h;
    switch (kind) {
    case PICTURE_END:
        return picture(head, after, h->visible);
    case HSYNC_END:
        return ras_periodic_after(after, h->sync_end, w->line);
    case VSYNC_END:
        return ras_periodic_after(after, w->sync_end, w->field);
    case HSYNC_BEGIN:
        return ras_periodic_after(after, h->sync_start, w->line);
    case VSYNC_BEGIN:
        return ras_periodic_after(after, w->sync_begin, w->field);
    default:
        return picture(head, after, 0);
    }
}

static void schedule(struct ras_head *head, uint64_t dot, unsigned kind)
{
    head->signal_dot = RAS_NEVER;
    for (unsigned k = 0; k < KINDS; k++) {
        uint64_t at = next_of(head, (int)k, (int64_t)dot - (k >= kind));
        if (at < head->signal_dot) {
            head->signal_dot = at;
            head->signal_kind = k;
        }
    }
    head->signal_time = ras_dot_time(head, head->signal_dot);
}

void ras_signals_from(struct ras_head *head, uint64_t dot)
{
    schedule(head, dot, 0);
}

void ras_signals_until(struct ras_head *head, uint64_t t)
{
    static const struct {
        enum ras_signal signal;
        bool level;
    } calls[KINDS] = {
        [PICTURE_END] = {RAS_PICTURE, false}, [HSYNC_END] = {RAS_HSYNC, false},
        [VSYNC_END] = {RAS_VSYNC, false},     [HSYNC_BEGIN] = {RAS_HSYNC, true},
        [VSYNC_BEGIN] = {RAS_VSYNC, true},    [PICTURE_BEGIN] = {RAS_PICTURE, true},
    };
    while (head->on && head->signal_time <= t) {
        unsigned kind = head->signal_kind;
        head->hooks.signal(head->hooks.ctx, calls[kind].signal, calls[kind].level,
                           head->signal_time);
        schedule(head, head->signal_dot, kind + 1);
    }
}

void ras_head_hook(struct ras_head *head, const struct ras_hooks *hooks, uint64_t t)
{
    head->hooks = *hooks;
    if (!head->on)
        return;
    if (t > head->origin) /* what happens at t itself is still to be told */
        schedule(head, ras_dot_at(head, t - 1), KINDS);
    else
        schedule(head, 0, 0);
}
