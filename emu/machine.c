#include "emu/machine.h"

#include <assert.h>
#include <string.h>

#include "display_file/df_regs.h"

/* ---- wires --------------------------------------------------------------------------------------
 */

static void count_stroke(struct vm_machine *m, const struct crt_stroke *stroke)
{
    m->strokes++;
    m->lit += stroke->t1 - stroke->t0;
    m->last_light = stroke->t1;
    if (m->desc.tube)
        crt_tube_stroke(m->desc.tube, stroke);
}

static void commit(void *ctx, const struct crt_stroke *stroke)
{
    count_stroke(ctx, stroke);
}

static void commit_traced(void *ctx, const struct crt_stroke *stroke)
{
    struct vm_machine *m = ctx;
    count_stroke(m, stroke);
    if (m->hooks.stroke)
        m->hooks.stroke(m->hooks.ctx, stroke);
}

static void interrupt(void *ctx, enum df_interrupt line, bool level, uint64_t t)
{
    struct vm_interrupt *i = &((struct vm_machine *)ctx)->interrupt[line];
    if (level && !i->pending) {
        i->count++;
        i->last_t = t;
    }
    i->pending = level;
}

static void bell(void *ctx, uint64_t t)
{
    (void)t;
    ((struct vm_machine *)ctx)->bells++;
}

void vm_machine_init(struct vm_machine *m, const struct vm_machine_desc *desc)
{
    memset(m, 0, sizeof *m);
    m->desc = *desc;
    m->flow.head = VM_NO_HEAD;
    m->ticks = 1;
    m->tick_time = crt_tick_time(desc->tick, 1);
    struct df_dpu_desc d = {
        .memory = m->memory,
        .memory_bytes = desc->memory_bytes,
        .screen = crt_tube_screen(desc->row),
        .timing = desc->timing,
        .beam = {m, NULL, commit},
        .wires = {m, interrupt, bell},
    };
    double low = desc->row->drive_low.value;
    for (int level = 0; level < 8; level++)
        d.drive[level] = low + (1 - low) * level / 7;
    df_dpu_init(&m->dpu, &d);
    df_dpu_reset(&m->dpu, 0);
}

/* ---- refreshes ----------------------------------------------------------------------------------
 */

static void begin_refresh(struct vm_machine *m, uint64_t t)
{
    m->in_refresh = true;
    m->current = (struct vm_refresh){.begin = t,
                                     .words = m->dpu.words,
                                     .instructions = m->dpu.instructions,
                                     .strokes = m->strokes,
                                     .lit = m->lit};
}

static void end_refresh(struct vm_machine *m, uint64_t t)
{
    uint64_t words = m->dpu.words - m->current.words;
    if (!m->in_refresh)
        return;
    m->in_refresh = false;
    if (words <= 1)
        return;
    m->refresh = (struct vm_refresh){.number = m->refresh.number + 1,
                                     .begin = m->current.begin,
                                     .end = t,
                                     .words = words,
                                     .instructions = m->dpu.instructions - m->current.instructions,
                                     .strokes = m->strokes - m->current.strokes,
                                     .lit = m->lit - m->current.lit};
}

static void start(struct vm_machine *m, uint64_t t)
{
    df_dpu_write(&m->dpu, DF_DPC, (uint16_t)m->entry, t);
    if (m->flow.start_begins)
        begin_refresh(m, m->dpu.t);
}

bool vm_machine_load(struct vm_machine *m, const struct df_program *program, const char *name,
                     struct crt_error *err)
{
    if (program->low >= program->high)
        return crt_fail(err, "%.200s holds no words; a display file needs at least one", name);
    if (program->high > m->desc.memory_bytes)
        return crt_fail(
            err,
            "%.200s has a word at address %o, beyond the display memory of %u bytes; give "
            "--set memory=64K or move the words",
            name, program->high - 2, m->desc.memory_bytes);
    if (program->entry >= m->desc.memory_bytes || program->entry >= DF_ADDRESS_SPACE)
        return crt_fail(
            err,
            "%.200s starts at %o, which the display processor cannot reach: its memory "
            "ends at %o",
            name, program->entry,
            (m->desc.memory_bytes < DF_ADDRESS_SPACE ? m->desc.memory_bytes : DF_ADDRESS_SPACE) -
                2);
    df_dpu_reset(&m->dpu, m->now);
    m->in_refresh = false;
    memcpy(m->memory, program->words, sizeof m->memory);
    m->entry = program->entry & ~1u;
    m->has_program = true;
    m->loaded = m->now;
    m->strokes_before = m->strokes;
    m->flow = vm_flow_of(m->memory, m->desc.memory_bytes, m->entry);
    start(m, m->now);
    return true;
}

void vm_machine_play(struct vm_machine *m, struct vm_recording recording)
{
    m->recording = recording;
    m->played = 0;
}

void vm_machine_copy(struct vm_machine *copy, const struct vm_machine *m)
{
    *copy = *m;
    copy->desc.tube = NULL;
    copy->dpu.desc.memory = copy->memory;
    copy->dpu.desc.beam.ctx = copy;
    copy->dpu.desc.wires.ctx = copy;
}

/* ---- time ---------------------------------------------------------------------------------------
 */

/* What a refresh program would do when the tick interrupts it. */
static void stand_in(struct vm_machine *m, uint64_t t)
{
    struct df_dpu *dpu = &m->dpu;
    if (!m->has_program || dpu->t > t)
        return;
    if (dpu->state == DF_STOPPED && m->desc.on_stop == VM_RESTART)
        start(m, t);
    else if (dpu->state == DF_WAITING_RESUME && !dpu->timeout)
        df_dpu_write(dpu, DF_DPC, 1, t);
}

/* Tells the tube that time has passed; a tick may fall within a word after whose end we paused. */
static void advance_tube(struct vm_machine *m, uint64_t t)
{
    if (m->desc.tube && t > m->advanced) {
        crt_tube_advance(m->desc.tube, t);
        m->advanced = t;
    }
}

static void tick(struct vm_machine *m)
{
    uint64_t t = m->tick_time;
    m->tick_time = crt_tick_time(m->desc.tick, ++m->ticks);
    advance_tube(m, t);
    bool waited = m->dpu.state == DF_WAITING_SYNC;
    df_dpu_sync(&m->dpu, t);
    if (waited && m->dpu.state == DF_RUNNING) {
        if (m->flow.head == VM_NO_HEAD)
            begin_refresh(m, m->dpu.t);
        return;
    }
    stand_in(m, t);
}

/* The processor has stopped running: by a stop word, a sync word, an interrupt or a time-out. */
static void pause_refresh(struct vm_machine *m)
{
    if (m->dpu.state == DF_STOPPED) {
        m->stops++;
        m->last_stop = m->dpu.t;
    }
    if (m->dpu.state == DF_STOPPED || m->dpu.state == DF_WAITING_SYNC)
        end_refresh(m, m->dpu.t);
}

static void traced_step(struct vm_machine *m)
{
    uint64_t t = m->dpu.t;
    uint16_t address = m->dpu.dpc;
    bool fetched = address < m->desc.memory_bytes;
    uint16_t word = fetched ? m->memory[address / 2] : 0;
    df_dpu_step(&m->dpu);
    if (m->hooks.word)
        m->hooks.word(m->hooks.ctx, t, address, word, fetched, &m->dpu);
}

static inline void step(struct vm_machine *m, bool traced)
{
    if (m->dpu.dpc == m->flow.head && m->dpu.phase == 0) {
        end_refresh(m, m->dpu.t);
        begin_refresh(m, m->dpu.t);
    }
    if (traced)
        traced_step(m);
    else
        df_dpu_step(&m->dpu);
    if (m->dpu.state != DF_RUNNING)
        pause_refresh(m);
}

static void play(struct vm_machine *m, uint64_t until, bool traced)
{
    const struct vm_recording *r = &m->recording;
    for (; m->played < r->count && r->strokes[m->played].t0 < until; m->played++)
        if (traced)
            commit_traced(m, &r->strokes[m->played]);
        else
            count_stroke(m, &r->strokes[m->played]);
}

/* When to return before `until`. */
enum pause { PAUSE_NEVER, PAUSE_AT_REFRESH, PAUSE_AT_STOP };

/* The constant arguments are folded: vm_machine_run gets a loop without tests for the others. */
static inline bool run(struct vm_machine *m, uint64_t until, bool traced, enum pause pause)
{
    uint64_t refreshes = m->refresh.number, stops = m->stops;
    while (m->now < until) {
        uint64_t limit = m->tick_time < until ? m->tick_time : until;
        while (m->dpu.state == DF_RUNNING && m->dpu.t < limit) {
            step(m, traced);
            if ((pause == PAUSE_AT_REFRESH && m->refresh.number != refreshes) ||
                (pause == PAUSE_AT_STOP && m->stops != stops)) {
                m->now = m->dpu.t;
                advance_tube(m, m->now);
                return true;
            }
        }
        play(m, limit, traced);
        if (m->tick_time < until)
            tick(m);
        else
            m->now = until;
    }
    advance_tube(m, m->now);
    return false;
}

void vm_machine_run(struct vm_machine *m, uint64_t until)
{
    run(m, until, false, PAUSE_NEVER);
}

void vm_machine_trace(struct vm_machine *m, uint64_t until, const struct vm_hooks *hooks)
{
    m->hooks = *hooks;
    m->dpu.desc.beam.commit = commit_traced;
    run(m, until, true, PAUSE_NEVER);
    m->dpu.desc.beam.commit = commit;
}

bool vm_machine_run_refresh(struct vm_machine *m, uint64_t limit)
{
    return run(m, limit, false, PAUSE_AT_REFRESH);
}

bool vm_machine_run_stop(struct vm_machine *m, uint64_t limit)
{
    return run(m, limit, false, PAUSE_AT_STOP);
}

void vm_machine_step(struct vm_machine *m)
{
    uint64_t t = m->dpu.state == DF_RUNNING ? m->dpu.t : m->tick_time;
    vm_machine_run(m, (t > m->now ? t : m->now) + 1);
}
