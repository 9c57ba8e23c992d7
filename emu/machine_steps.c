/* machine_steps.c — steps within words and frames: to the end of a stroke, to the next line. */
#include "emu/machine_parts.h"

/* When the first of the strokes delivered so far that is not over yet ends. */
static uint64_t next_end(const struct vm_machine *m)
{
    uint64_t first = VM_NEVER;
    for (int i = 0; i < VM_STROKES_KEPT; i++)
        if (m->recent[i].t1 > m->now && m->recent[i].t1 < first)
            first = m->recent[i].t1;
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

const struct crt_stroke *vm_machine_stroke(const struct vm_machine *m)
{
    const struct crt_stroke *last = NULL;
    for (int i = 0; i < VM_STROKES_KEPT; i++) {
        const struct crt_stroke *s = &m->recent[i];
        if (s->t1 > 0 && s->t0 < m->now && (!last || s->t0 > last->t0))
            last = s;
    }
    return last;
}

bool vm_machine_beam(const struct vm_machine *m, double *x, double *y, bool *lit)
{
    const struct crt_stroke *s = vm_machine_stroke(m);
    if (!s)
        return false;
    *lit = s->t1 > m->now;
    double done = *lit ? (double)(m->now - s->t0) / (double)(s->t1 - s->t0) : 1;
    crt_mm_to_units(&m->dpu.desc.screen, (double)s->x0 + done * (double)(s->x1 - s->x0),
                    (double)s->y0 + done * (double)(s->y1 - s->y0), x, y);
    return true;
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
