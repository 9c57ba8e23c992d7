/* A machine in a snapshot: time, counts, what a refresh is, display memory, display processor; and
 * the board with its console where there is one. */
#include <string.h>

#include "emu/machine_parts.h"
#include "emu/memmap.h"

#define VERSION 3

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

static void refreshes_state(struct vm_refreshes *r, struct crt_state *s)
{
    crt_state_bool(s, &r->flow.stops);
    crt_state_bool(s, &r->flow.loops);
    crt_state_bool(s, &r->flow.synchronised);
    crt_state_bool(s, &r->flow.start_begins);
    crt_state_u32(s, &r->flow.head);
    crt_state_bool(s, &r->declared);
    crt_state_bool(s, &r->running);
    refresh_state(&r->current, s);
    refresh_state(&r->last, s);
}

static void program_state(struct vm_machine *m, struct crt_state *s)
{
    crt_state_bool(s, &m->has_program);
    crt_state_u32(s, &m->entry);
    crt_state_u32(s, &m->beside);
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
    crt_state_u64(s, &m->marks);
    crt_state_u32(s, &m->mark);
    for (int line = 0; line < DF_INT_COUNT; line++) {
        crt_state_u64(s, &m->interrupt[line].count);
        crt_state_u64(s, &m->interrupt[line].last_t);
        crt_state_u64(s, &m->interrupt[line].change);
    }
}

/* Acts are not part of the machine, but how many of those at this very time have been done is: a
 * debugger may stop it right after them. */
static void acts_state(struct vm_machine *m, struct crt_state *s)
{
    struct vm_done before = {0, 0}, here;
    if (m->desc.person)
        before = vm_operator_before(m->desc.person, m->now);
    uint64_t script = s->loading ? 0 : m->done.script - before.script;
    uint64_t live = s->loading ? 0 : m->done.live - before.live;
    crt_state_u64(s, &script);
    crt_state_u64(s, &live);
    if (!s->loading || s->failed || !m->desc.person)
        return;
    here = vm_operator_before(m->desc.person, m->now + 1);
    here.script -= before.script;
    here.live -= before.live;
    m->done.script = before.script + (script < here.script ? (size_t)script : here.script);
    m->done.live = before.live + (live < here.live ? (size_t)live : here.live);
}

static void raster_state(struct vm_machine *m, struct crt_state *s)
{
    if (!m->desc.buffer)
        return;
    crt_state_pages(s, m->desc.buffer, VIDEO_BUFFER_BYTES);
}

/* ---- what is possible -------------------------------------------------------------------------- */

static bool sane_entry(const struct vm_machine *m, uint32_t entry)
{
    return entry == VM_NO_ENTRY ||
           (entry % 2 == 0 && entry < m->desc.memory_bytes && entry < DF_ADDRESS_SPACE);
}

static bool sane_program(const struct vm_machine *m)
{
    const struct vm_flow *flow = &m->refreshes.flow;
    bool head = flow->head == VM_NO_HEAD || flow->head < DF_ADDRESS_SPACE;
    /* Firmware may START anywhere, also where there is no memory. */
    bool entry = m->desc.board ? m->entry == VM_NO_ENTRY || m->entry < DF_ADDRESS_SPACE
                               : sane_entry(m, m->entry);
    return entry && head && sane_entry(m, m->beside) &&
           !(m->has_program && (m->recording.count || m->desc.board || m->entry == VM_NO_ENTRY));
}

/* The tick before the next one has happened, the next one has not. */
static bool sane_time(const struct vm_machine *m)
{
    return m->now < CRT_STATE_LATEST && m->loaded <= m->now && m->ticks > 0 &&
           m->ticks - 1 <= crt_tick_at(m->desc.tick, m->now) &&
           crt_tick_time(m->desc.tick, m->ticks) >= m->now;
}

static bool sane_counts(const struct vm_machine *m)
{
    const struct vm_refresh *current = &m->refreshes.current, *last = &m->refreshes.last;
    uint64_t latest = m->dpu.t > m->now ? m->dpu.t : m->now; /* firmware may declare refreshes */
    return m->strokes_before <= m->strokes && current->words <= m->dpu.words &&
           current->instructions <= m->dpu.instructions && current->strokes <= m->strokes &&
           current->lit <= m->lit && current->begin <= latest && last->begin <= last->end &&
           last->end <= latest;
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

/* A line of the board is as the display processor has it, or has still to change. */
static bool sane_lines(const struct vm_machine *m)
{
    for (int i = 0; i < DF_INT_COUNT; i++) {
        uint64_t change = m->interrupt[i].change;
        if (change != VM_NEVER && (!m->desc.board || change < m->now || change >= CRT_STATE_LATEST))
            return false;
        if (m->desc.board && change == VM_NEVER &&
            (m->desc.board->irq.pending >> vm_lines[i] & 1) != m->dpu.pending[i])
            return false;
    }
    return true;
}

static bool sane_devices(const struct vm_machine *m)
{
    return !m->desc.setup || !m->desc.board ||
           (m->desc.board->irq.pending >> IRQ_LINE_INPUT & 1) == m->devices.level;
}

/* The processor has executed what it begins before now, and nothing that it begins later. */
static bool sane_processor(const struct vm_machine *m)
{
    const struct vm_board *b = m->desc.board;
    if (!b)
        return true;
    if (vm_board_next(b) < m->now)
        return false;
    return b->cpu.state == RV_HALTED || b->finisher.done ||
           b->cpu.cycle == vm_board_cycle(b, m->now);
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

/* So has the raster tube, whose next line begins after the last one; the raster head's lines are as
 * it has them. */
static bool sane_raster(const struct vm_machine *m)
{
    if (!m->desc.buffer)
        return true;
    if (vm_raster_next(m) < m->now)
        return false;
    for (int i = 0; i < RAS_INT_COUNT; i++)
        if ((m->desc.board->irq.pending >> vm_raster_lines[i] & 1) !=
            ras_head_interrupt(&m->raster, (enum ras_interrupt)i))
            return false;
    if (!m->desc.raster_tube)
        return true;
    struct crt_tube_times times = crt_tube_times(m->desc.raster_tube);
    return times.now == m->now && times.last_start <= m->raster.lit_until;
}

static void check(struct vm_machine *m, struct crt_state *s)
{
    crt_state_check(s, sane_raster(m), "raster head");
    crt_state_check(s, sane_devices(m), "interrupt of the input devices");
    crt_state_check(s, sane_time(m), "time");
    crt_state_check(s, sane_program(m), "program");
    crt_state_check(s, sane_counts(m), "count of a refresh");
    crt_state_check(s, sane_beam(m), "next stroke");
    crt_state_check(s, sane_tube(m), "time of the tube");
    crt_state_check(s, sane_lines(m), "interrupt line");
    crt_state_check(s, sane_processor(m), "time of the processor");
}

void vm_machine_state(struct vm_machine *m, struct crt_state *s)
{
    df_dpu_state(&m->dpu, s);
    if (m->desc.board)
        vm_board_state(m->desc.board, s);
    if (m->desc.console)
        vm_console_state(m->desc.console, s);
    if (m->desc.buffer)
        ras_head_state(&m->raster, s);
    if (m->desc.setup)
        vm_devices_state(m, s);
    crt_state_begin(s, "MACH", VERSION);
    program_state(m, s);
    refreshes_state(&m->refreshes, s);
    counts_state(m, s);
    acts_state(m, s);
    crt_state_word_pages(s, m->memory, sizeof m->memory / sizeof m->memory[0]);
    raster_state(m, s);
    check(m, s);
    crt_state_end(s);
    if (!s->loading || s->failed)
        return;
    memset(m->recent, 0, sizeof m->recent);
    m->tick_time = crt_tick_time(m->desc.tick, m->ticks);
    m->advanced = m->desc.tube ? m->now : 0;
    m->raster_advanced = m->desc.raster_tube ? m->now : 0;
    for (int line = 0; line < DF_INT_COUNT; line++)
        m->interrupt[line].pending = m->dpu.pending[line];
}
