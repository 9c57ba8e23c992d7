/* A machine in a snapshot: time, counts, what a refresh is, display memory, display processor. */
#include "emu/machine.h"

#define VERSION 1

/* Later times leave too little of 64 bits to go on, ps. */
#define LATEST (UINT64_C(1) << 63)

/* A word takes less, ps: ticks that fall within it are this far back at most. */
#define LONGEST (UINT64_C(1) << 51)

static void refresh_state(struct vm_refresh *r, struct crt_state *s)
{
    crt_state_u64(s, &r->number);
    crt_state_u64(s, &r->begin);
    crt_state_u64(s, &r->end);
    crt_state_u64(s, &r->words);
    crt_state_u64(s, &r->instructions);
    crt_state_u64(s, &r->strokes);
    crt_state_u64(s, &r->lit);
}

static void program_state(struct vm_machine *m, struct crt_state *s)
{
    crt_state_bool(s, &m->has_program);
    crt_state_u32(s, &m->entry);
    crt_state_bool(s, &m->flow.stops);
    crt_state_bool(s, &m->flow.loops);
    crt_state_bool(s, &m->flow.synchronised);
    crt_state_bool(s, &m->flow.start_begins);
    crt_state_u32(s, &m->flow.head);
    crt_state_size(s, &m->played, m->recording.count);
    crt_state_u64(s, &m->loaded);
    crt_state_u64(s, &m->strokes_before);
}

static void counts_state(struct vm_machine *m, struct crt_state *s)
{
    crt_state_u64(s, &m->now);
    crt_state_u64(s, &m->ticks);
    crt_state_u64(s, &m->strokes);
    crt_state_u64(s, &m->lit);
    crt_state_u64(s, &m->last_light);
    crt_state_u64(s, &m->stops);
    crt_state_u64(s, &m->last_stop);
    crt_state_u64(s, &m->bells);
    crt_state_bool(s, &m->in_refresh);
    refresh_state(&m->current, s);
    refresh_state(&m->refresh, s);
    for (int line = 0; line < DF_INT_COUNT; line++) {
        crt_state_u64(s, &m->interrupt[line].count);
        crt_state_u64(s, &m->interrupt[line].last_t);
    }
}

/* ---- what is possible -------------------------------------------------------------------------- */

static bool sane_program(const struct vm_machine *m)
{
    bool reachable = m->entry < m->desc.memory_bytes && m->entry < DF_ADDRESS_SPACE;
    bool head = m->flow.head == VM_NO_HEAD || m->flow.head < DF_ADDRESS_SPACE;
    return m->entry % 2 == 0 && head && (reachable || !m->has_program) &&
           !(m->has_program && m->recording.count);
}

/* The tick before the next one has happened. The next one has not, unless it falls within a word
 * after whose end the machine paused. */
static bool sane_time(const struct vm_machine *m)
{
    if (m->now >= LATEST || m->loaded > m->now || m->ticks == 0 ||
        m->ticks - 1 > crt_tick_at(m->desc.tick, m->now))
        return false;
    uint64_t next = crt_tick_time(m->desc.tick, m->ticks);
    return next >= m->now || (m->dpu.t >= m->now && m->now - next <= LONGEST);
}

static bool sane_counts(const struct vm_machine *m)
{
    const struct vm_refresh *current = &m->current, *last = &m->refresh;
    return m->strokes_before <= m->strokes && current->words <= m->dpu.words &&
           current->instructions <= m->dpu.instructions && current->strokes <= m->strokes &&
           current->lit <= m->lit && current->begin <= m->dpu.t && last->begin <= last->end &&
           last->end <= m->dpu.t;
}

/* What is to be drawn next comes in time, and nothing else draws while a recording plays. */
static bool sane_beam(const struct vm_machine *m)
{
    const struct vm_recording *r = &m->recording;
    if (m->dpu.state == DF_RUNNING && m->dpu.t < m->now)
        return false;
    if (r->count == 0)
        return true;
    return m->dpu.state == DF_STOPPED &&
           (m->played == 0 || r->strokes[m->played - 1].t0 < m->now) &&
           (m->played == r->count || r->strokes[m->played].t0 >= m->now);
}

/* The tube has seen all that was drawn and nothing more. */
static bool sane_tube(const struct vm_machine *m)
{
    if (!m->desc.tube)
        return true;
    struct crt_tube_times times = crt_tube_times(m->desc.tube);
    const struct vm_recording *r = &m->recording;
    uint64_t drawn = m->played ? r->strokes[m->played - 1].t0 : m->dpu.t;
    return times.now == m->now && times.last_start <= drawn;
}

static void check(struct vm_machine *m, struct crt_state *s)
{
    crt_state_check(s, sane_time(m), "time");
    crt_state_check(s, sane_program(m), "program");
    crt_state_check(s, sane_counts(m), "count of a refresh");
    crt_state_check(s, sane_beam(m), "next stroke");
    crt_state_check(s, sane_tube(m), "time of the tube");
}

void vm_machine_state(struct vm_machine *m, struct crt_state *s)
{
    df_dpu_state(&m->dpu, s);
    crt_state_begin(s, "MACH", VERSION);
    program_state(m, s);
    counts_state(m, s);
    crt_state_word_pages(s, m->memory, sizeof m->memory / sizeof m->memory[0]);
    check(m, s);
    crt_state_end(s);
    if (!s->loading || s->failed)
        return;
    m->tick_time = crt_tick_time(m->desc.tick, m->ticks);
    m->advanced = m->desc.tube ? m->now : 0;
    for (int line = 0; line < DF_INT_COUNT; line++)
        m->interrupt[line].pending = m->dpu.pending[line];
}
