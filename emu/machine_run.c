/* machine_run.c — time: whose turn it is, until a moment or a goal. */
#include "display_file/df_regs.h"
#include "emu/machine_parts.h"

struct run {
    uint64_t until;
    struct vm_goal goal;
    bool hooked;
    bool came, stopped; /* the goal; a debugger's hook */
};

/* ---- ticks --------------------------------------------------------------------------------------
 */

/* What a refresh program would do when the tick interrupts it. */
static void stand_in(struct vm_machine *m, uint64_t t)
{
    struct df_dpu *dpu = &m->dpu;
    if (!m->has_program || dpu->t > t)
        return;
    if (dpu->state == DF_STOPPED && m->desc.on_stop == VM_RESTART)
        vm_start(m, (uint16_t)m->entry, t);
    else if (dpu->state == DF_WAITING_RESUME && !dpu->timeout)
        df_dpu_write(dpu, DF_DPC, 1, t);
}

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
        struct vm_counts counts = vm_counts(m);
        if (m->refreshes.flow.head == VM_NO_HEAD)
            vm_refreshes_begin(&m->refreshes, m->dpu.t, &counts);
        return;
    }
    stand_in(m, t);
}

/* ---- words --------------------------------------------------------------------------------------
 */

/* The display processor has stopped running: by a stop word, a sync word, an interrupt or a
 * time-out. */
static void pause_refresh(struct vm_machine *m)
{
    struct vm_counts counts = vm_counts(m);
    if (m->dpu.state == DF_STOPPED) {
        m->stops++;
        m->last_stop = m->dpu.t;
    }
    if (m->dpu.state == DF_STOPPED || m->dpu.state == DF_WAITING_SYNC)
        vm_refreshes_end(&m->refreshes, m->dpu.t, &counts);
}

static void come_round(struct vm_machine *m)
{
    struct vm_counts counts = vm_counts(m);
    vm_refreshes_end(&m->refreshes, m->dpu.t, &counts);
    vm_refreshes_begin(&m->refreshes, m->dpu.t, &counts);
}

static void hooked_step(struct vm_machine *m)
{
    uint64_t t = m->dpu.t;
    uint16_t address = m->dpu.dpc;
    bool fetched = address < m->desc.memory_bytes;
    uint16_t word = fetched ? m->memory[address / 2] : 0;
    df_dpu_step(&m->dpu);
    if (m->hooks.word)
        m->hooks.word(m->hooks.ctx, t, address, word, fetched, &m->dpu);
}

static void step(struct vm_machine *m, bool hooked)
{
    if (m->dpu.dpc == m->refreshes.flow.head && m->dpu.phase == 0)
        come_round(m);
    if (hooked)
        hooked_step(m);
    else
        df_dpu_step(&m->dpu);
    if (m->dpu.state != DF_RUNNING)
        pause_refresh(m);
}

/* Strokes of a recording. */
static void play(struct vm_machine *m, uint64_t until)
{
    const struct vm_recording *r = &m->recording;
    for (; m->played < r->count && r->strokes[m->played].t0 < until; m->played++)
        m->dpu.desc.beam.commit(m, &r->strokes[m->played]);
}

/* ---- goals --------------------------------------------------------------------------------------
 */

static bool processor_ended(const struct vm_machine *m)
{
    const struct vm_board *b = m->desc.board;
    return b && (b->finisher.done || b->cpu.state == RV_HALTED);
}

static bool reached(const struct vm_machine *m, const struct vm_goal *g)
{
    switch (g->kind) {
    case VM_GOAL_NONE:
        return false;
    case VM_GOAL_REFRESH:
        return m->refreshes.last.number > g->count;
    case VM_GOAL_STOP:
        return m->stops > g->count;
    case VM_GOAL_WORDS:
        return m->dpu.words >= g->count;
    case VM_GOAL_RETIRED:
        return m->desc.board && rv_retired(&m->desc.board->cpu) >= g->count;
    case VM_GOAL_CONSOLE:
        return m->desc.console && m->desc.console->found;
    case VM_GOAL_MARK:
        return m->marks > g->count && m->mark == g->mark;
    case VM_GOAL_END:
        return processor_ended(m);
    case VM_GOAL_DRAWN:
        return m->strokes > g->count;
    case VM_GOAL_TIMING:
        return m->raster.on != g->on || m->raster.origin != g->count;
    }
    return false;
}

/* When what has just been reached has happened. What a word brings about has when the word is done;
 * at the time of its fetch others have their turn, too. */
static uint64_t moment_of(const struct vm_machine *m, const struct vm_goal *g)
{
    bool by_word =
        g->kind == VM_GOAL_STOP || (g->kind == VM_GOAL_REFRESH && !m->refreshes.declared);
    if (by_word && m->dpu.t > m->now)
        return m->dpu.t;
    return g->kind == VM_GOAL_WORDS ? m->now + 1 : m->now;
}

/* The goal is reached: from here on everything else only catches up with its moment. */
static void come(struct run *r, uint64_t moment)
{
    r->until = moment;
    r->came = true;
    r->goal.kind = VM_GOAL_NONE;
}

/* ---- the processor ------------------------------------------------------------------------------
 */

static bool processor_runs(const struct vm_machine *m)
{
    const struct vm_board *b = m->desc.board;
    return b && b->cpu.state == RV_RUNNING && !b->finisher.done;
}

/* Lets it execute what it begins before `stop`. */
static void run_processor(struct vm_machine *m, uint64_t stop, struct run *r)
{
    struct vm_board *b = m->desc.board;
    uint64_t cycle = vm_board_cycle(b, stop);
    if (r->goal.kind == VM_GOAL_RETIRED) {
        uint64_t left = r->goal.count - rv_retired(&b->cpu);
        cycle = cycle - b->cpu.cycle > left ? b->cpu.cycle + left : cycle;
    }
    if (r->hooked && m->hooks.processor)
        r->stopped = rv_watch(&b->cpu, cycle, m->hooks.processor);
    else
        rv_run(&b->cpu, cycle);
    uint64_t now = vm_board_now(b);
    m->now = now < stop ? now : stop;
}

/* Its clock goes on while it waits. */
static void wait_processor(struct vm_machine *m, uint64_t t)
{
    struct vm_board *b = m->desc.board;
    if (b && b->cpu.state == RV_WAITING)
        rv_wait(&b->cpu, vm_board_cycle(b, t));
}

/* ---- whose turn it is ---------------------------------------------------------------------------
 */

/* In order of precedence at equal times. A line changes before a word that would change it again. */
enum source {
    SOURCE_RASTER,
    SOURCE_TICK,
    SOURCE_WIRES,
    SOURCE_WORD,
    SOURCE_INPUT,
    SOURCE_CONSOLE,
    SOURCE_BOARD,
    SOURCE_COUNT
};

static uint64_t console_next(const struct vm_machine *m)
{
    if (!m->desc.console)
        return VM_NEVER;
    uint64_t ready = vm_uart_ready_at(&m->desc.board->uart);
    uint64_t t = ready == VM_NEVER ? VM_NEVER : vm_console_next(m->desc.console, ready);
    return t > m->now ? t : m->now;
}

static void list_next(const struct vm_machine *m, uint64_t next[SOURCE_COUNT])
{
    next[SOURCE_RASTER] = vm_raster_next(m);
    next[SOURCE_TICK] = m->tick_time;
    next[SOURCE_INPUT] = vm_devices_next(m);
    next[SOURCE_WORD] = m->dpu.state == DF_RUNNING ? m->dpu.t : VM_NEVER;
    next[SOURCE_WIRES] = next[SOURCE_CONSOLE] = next[SOURCE_BOARD] = VM_NEVER;
    if (m->desc.board) {
        next[SOURCE_WIRES] = vm_wires_next(m);
        next[SOURCE_CONSOLE] = console_next(m);
        next[SOURCE_BOARD] = vm_board_next(m->desc.board);
    }
}

static enum source first_of(const uint64_t next[SOURCE_COUNT])
{
    enum source first = SOURCE_RASTER;
    for (int i = 1; i < SOURCE_COUNT; i++)
        if (next[i] < next[first])
            first = (enum source)i;
    return first;
}

/* Words, as long as nobody else can see one: to the next turn of somebody else, and one by one
 * while the processor runs. */
static void run_words(struct vm_machine *m, const uint64_t next[SOURCE_COUNT], struct run *r)
{
    uint64_t limit = r->until;
    if (processor_runs(m))
        limit = m->dpu.t + 1;
    for (int i = 0; i < SOURCE_COUNT; i++)
        if (i != SOURCE_WORD && next[i] < limit)
            limit = next[i] > m->dpu.t ? next[i] : m->dpu.t + 1;
    do {
        m->now = m->dpu.t;
        step(m, r->hooked);
        if (r->goal.kind != VM_GOAL_NONE && reached(m, &r->goal))
            return;
    } while (m->dpu.state == DF_RUNNING && m->dpu.t < limit &&
             !(m->desc.board && vm_wires_next(m) <= m->dpu.t) &&
             !(m->looks[INP_VECTOR] && vm_devices_next(m) <= m->dpu.t));
}

static void take_turn(struct vm_machine *m, enum source who, const uint64_t next[SOURCE_COUNT],
                      struct run *r)
{
    uint64_t t = next[who];
    int byte;
    wait_processor(m, t);
    m->now = t;
    switch (who) {
    case SOURCE_RASTER:
        vm_raster_event(m, t);
        break;
    case SOURCE_TICK:
        play(m, t);
        tick(m);
        break;
    case SOURCE_WORD:
        run_words(m, next, r);
        break;
    case SOURCE_WIRES:
        vm_wires_change(m, t);
        break;
    case SOURCE_INPUT:
        vm_devices_event(m, t);
        break;
    case SOURCE_CONSOLE:
        byte = vm_console_take(m->desc.console, t);
        if (byte >= 0)
            vm_uart_receive(&m->desc.board->uart, (uint8_t)byte, t);
        break;
    case SOURCE_BOARD:
        vm_board_event(m->desc.board, t);
        break;
    case SOURCE_COUNT:
        break;
    }
}

static void run(struct vm_machine *m, struct run *r)
{
    if (r->goal.kind != VM_GOAL_NONE && reached(m, &r->goal))
        come(r, m->now);
    while (!r->stopped) {
        uint64_t next[SOURCE_COUNT];
        list_next(m, next);
        enum source who = first_of(next);
        uint64_t stop = next[who] < r->until ? next[who] : r->until;
        if (processor_runs(m) && vm_board_now(m->desc.board) < stop)
            run_processor(m, stop, r);
        else if (next[who] < r->until)
            take_turn(m, who, next, r);
        else
            break;
        if (r->goal.kind != VM_GOAL_NONE && reached(m, &r->goal))
            come(r, moment_of(m, &r->goal));
    }
    if (!r->stopped) {
        wait_processor(m, r->until);
        play(m, r->until);
        m->now = r->until > m->now ? r->until : m->now;
    }
    advance_tube(m, m->now);
    vm_raster_advance(m, m->now);
}

bool vm_run_goal(struct vm_machine *m, uint64_t limit, struct vm_goal goal)
{
    struct run r = {.until = limit, .goal = goal};
    run(m, &r);
    return r.came;
}

/* ---- from outside -------------------------------------------------------------------------------
 */

void vm_machine_run(struct vm_machine *m, uint64_t until)
{
    vm_run_goal(m, until, (struct vm_goal){.kind = VM_GOAL_NONE});
}

void vm_machine_trace(struct vm_machine *m, uint64_t until, const struct vm_hooks *hooks)
{
    struct run r = {.until = until, .hooked = true};
    m->hooks = *hooks;
    vm_wire_hooks(m, true);
    vm_raster_hook(m, true);
    run(m, &r);
    vm_wire_hooks(m, false);
    vm_raster_hook(m, false);
    m->hooks = (struct vm_hooks){0};
}

bool vm_machine_watch(struct vm_machine *m, uint64_t until, const struct rv_hooks *hooks)
{
    struct run r = {.until = until, .hooked = true};
    m->hooks = (struct vm_hooks){.processor = hooks};
    run(m, &r);
    m->hooks = (struct vm_hooks){0};
    return r.stopped;
}

void vm_machine_step(struct vm_machine *m)
{
    uint64_t t = m->dpu.state == DF_RUNNING ? m->dpu.t : m->tick_time;
    vm_machine_run(m, (t > m->now ? t : m->now) + 1);
}
