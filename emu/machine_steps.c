/* machine_steps.c — steps within words and frames: to the end of a stroke, to the next line. */
#include "emu/machine_parts.h"

/* When the first of the strokes delivered so far that is not over yet ends. */
static uint64_t next_end(const struct vm_machine *m)
{
    uint64_t first = VM_NEVER;
    for (int i = 0; i < VM_STROKES_KEPT; i++)
        if (m->ends[i] > m->now && m->ends[i] < first)
            first = m->ends[i];
    return first;
}

/* The same of a recording, which is known beforehand. */
static uint64_t next_played_end(const struct vm_machine *m)
{
    const struct vm_recording *r = &m->recording;
    size_t i = m->played;
    while (i > 0 && r->strokes[i - 1].t1 > m->now)
        i--;
    while (i < r->count && r->strokes[i].t1 <= m->now)
        i++;
    return i < r->count ? r->strokes[i].t1 : VM_NEVER;
}

bool vm_machine_run_stroke(struct vm_machine *m, uint64_t limit)
{
    uint64_t end = m->recording.count ? next_played_end(m) : next_end(m);
    if (end == VM_NEVER && !m->recording.count && vm_run_drawn(m, limit))
        end = next_end(m);
    vm_machine_run(m, end < limit ? end : limit);
    return end <= limit;
}

/* When the line after the one under way begins. */
static uint64_t next_line(const struct vm_machine *m)
{
    const struct ras_head *head = &m->raster;
    if (!m->desc.buffer || !head->on)
        return VM_NEVER;
    uint64_t since = m->now > head->origin ? m->now - head->origin : 0;
    uint64_t line = head->timing.h.total, n = crt_tick_at(head->timing.clock, since) / line;
    return head->origin + crt_tick_time(head->timing.clock, (n + 1) * line);
}

bool vm_machine_run_line(struct vm_machine *m, uint64_t limit)
{
    for (;;) {
        uint64_t line = next_line(m), until = line < limit ? line : limit;
        if (!m->desc.buffer || !vm_run_timing(m, until)) {
            vm_machine_run(m, until);
            return line <= limit;
        }
        if (m->raster.on)
            return true;
    }
}
