/* machine_steps.c — steps of each kind; those within words and frames: to the end of a stroke, to the next line. */
#include "emu/machine_parts.h"

/* ---- strokes ------------------------------------------------------------------------------------
 */

static bool moves(const struct crt_stroke *s)
{
    return s->x0 != s->x1 || s->y0 != s->y1;
}

/* Pieces of one vector (crt/piece.h), which are one stroke: the later goes on where the former ends, and just
 * one of the two is at rest. */
static bool joined(const struct crt_stroke *s, const struct crt_stroke *next)
{
    return next->t0 == s->t1 && next->x0 == s->x1 && next->y0 == s->y1 &&
           next->source == s->source && moves(s) != moves(next);
}

/* The piece that goes on where s ends; NULL: it is a stroke's last. */
static const struct crt_stroke *rest_of(const struct vm_machine *m, const struct crt_stroke *s)
{
    for (int i = 0; i < VM_STROKES_KEPT; i++)
        if (joined(s, &m->recent[i]))
            return &m->recent[i];
    return NULL;
}

/* When the first of the strokes delivered so far that is not over yet ends. */
static uint64_t next_end(const struct vm_machine *m)
{
    const struct crt_stroke *first = NULL, *rest;
    for (int i = 0; i < VM_STROKES_KEPT; i++)
        if (m->recent[i].t1 > m->now && (!first || m->recent[i].t1 < first->t1))
            first = &m->recent[i];
    while (first && (rest = rest_of(m, first)))
        first = rest;
    return first ? first->t1 : VM_NEVER;
}

uint64_t vm_machine_stroke_before(const struct vm_machine *m, uint64_t t)
{
    uint64_t last = 0;
    for (int i = 0; i < VM_STROKES_KEPT; i++) {
        const struct crt_stroke *s = &m->recent[i];
        if (s->t1 < t && s->t1 > last && !rest_of(m, s))
            last = s->t1;
    }
    return last;
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
    while (i + 1 < r->count && joined(&r->strokes[i], &r->strokes[i + 1]))
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

/* ---- lines --------------------------------------------------------------------------------------
 */

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

/* ---- all ----------------------------------------------------------------------------------------
 */

bool vm_machine_run_unit(struct vm_machine *m, enum vm_unit unit, uint64_t limit)
{
    switch (unit) {
    case VM_UNIT_INSTRUCTION:
        return vm_machine_run_retired(m, rv_retired(&m->desc.board->cpu) + 1, limit);
    case VM_UNIT_WORD:
        return vm_machine_run_words(m, m->dpu.words + 1, limit);
    case VM_UNIT_REFRESH:
        return vm_machine_run_refresh(m, limit);
    case VM_UNIT_STROKE:
        return vm_machine_run_stroke(m, limit);
    case VM_UNIT_LINE:
        return vm_machine_run_line(m, limit);
    }
    return false;
}
