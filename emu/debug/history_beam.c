#include "emu/debug/history_beam.h"

/* Longer than a word draws: who has run so long knows all strokes under way. */
#define LONGEST_WORD CRT_PS_PER_MS

/* Runs again to t from a snapshot at least `before` earlier. */
static bool go_to(struct vm_history *h, struct vm_machine *m, uint64_t t, uint64_t before)
{
    struct crt_error err;
    if (!vm_history_recall(h, t > before ? t - before : 0, &err) || m->now > t)
        return false;
    while (m->now < t) {
        uint64_t next = m->now + CRT_PS_PER_S / 10;
        vm_machine_run(m, next < t ? next : t);
        vm_history_note(h);
    }
    return true;
}

/* The last end of a stroke before t, if need be found by looking again how it went; m is at t then. 0: not known. */
static uint64_t end_before(struct vm_history *h, struct vm_machine *m, uint64_t t)
{
    uint64_t end = vm_machine_stroke_before(m, t);
    for (uint64_t before = LONGEST_WORD; end == 0 && before <= 10 * CRT_PS_PER_S; before *= 10) {
        if (!go_to(h, m, t, before))
            return 0;
        end = vm_machine_stroke_before(m, t);
    }
    return end;
}

/* When the last line before t began; within the first of a timing, as if the timing had run before. */
static uint64_t line_before(const struct vm_machine *m, uint64_t t)
{
    const struct ras_head *head = &m->raster;
    const struct ras_timing *timing = &head->timing;
    if (!m->desc.buffer || !head->on)
        return 0;
    uint64_t line = timing->h.total, length = crt_tick_time(timing->clock, line);
    if (t <= head->origin)
        return t > length ? t - length : 0;
    return head->origin +
           crt_tick_time(timing->clock,
                         crt_tick_at(timing->clock, t - head->origin - 1) / line * line);
}

bool vm_history_back_beam(struct vm_history *h, struct vm_machine *m, enum vm_unit unit, uint64_t n,
                          struct crt_error *err)
{
    for (uint64_t i = 0; i < n; i++) {
        uint64_t t = unit == VM_UNIT_LINE ? line_before(m, m->now) : end_before(h, m, m->now);
        if (t == 0)
            return vm_history_recall(h, 0, err) && false;
        if (!go_to(h, m, t, 0))
            return false;
    }
    return true;
}
