/* gdb_back.c — going back: from a moment kept earlier forward again, to just before now.
 *
 *      kept ──── the last place to stop at ──── goal: where the processor was
 *        │  1. look for it, running to the goal │
 *        │  2. rewind again, run to it ◀────────┘      none: the same from the moment kept before
 *
 * The machine is deterministic, so what is executed again is what was executed. A watchpoint stops
 * after the access, also where the processor is already: gdb goes back over that by itself, as on the
 * way forward it steps over it.
 */
#include "emu/debug/gdb_parts.h"

#define CLOSE 64 /* clocks: where most instructions before the goal are */

struct search {
    struct vm_gdb_session *s;
    bool any; /* instruction will do */
    bool found, reaching;
    uint64_t cycle; /* where what was found stops */
    struct vm_gdb_stop stop, access;
};

static void find(struct search *search, uint64_t cycle, const struct vm_gdb_stop *stop)
{
    search->found = true;
    search->cycle = cycle;
    search->stop = *stop;
}

static bool look_before(void *ctx, struct rv_cpu *cpu)
{
    struct search *search = ctx;
    const struct vm_gdb_points *points = &search->s->points;
    struct vm_gdb_stop stop = {.reason = VM_GDB_BY_SIGNAL, .value = VM_GDB_SIGTRAP};
    search->reaching = false;
    if (search->any) {
        find(search, cpu->cycle, &stop);
        return false;
    }
    const struct vm_gdb_break *b = vm_gdb_break_at(points, cpu->pc);
    if (b) {
        stop.reason = b->soft ? VM_GDB_BY_BREAK_SOFT : VM_GDB_BY_BREAK_HARD;
        find(search, cpu->cycle, &stop);
    } else if (points->watches > 0) {
        search->reaching = vm_gdb_reaches(points, cpu, &search->access);
    }
    return false;
}

static void look_after(void *ctx, struct rv_cpu *cpu, uint32_t pc, uint32_t word, bool trapped)
{
    struct search *search = ctx;
    (void)pc;
    (void)word;
    if (search->reaching && !trapped)
        find(search, cpu->cycle, &search->access);
}

static bool at_cycle(void *ctx, struct rv_cpu *cpu)
{
    return cpu->cycle >= *(const uint64_t *)ctx;
}

static void look(struct search *search, uint64_t goal)
{
    const struct vm_gdb_target *t = &search->s->target;
    const struct rv_hooks hooks = {search, look_before, look_after, NULL};
    t->watch(t->ctx, t->time(t->ctx, goal), &hooks);
}

/* Rewinds and looks through everything from there to the goal, or the last bit of it. */
static bool search_from(struct search *search, uint64_t goal, bool close)
{
    const struct vm_gdb_target *t = &search->s->target;
    if (!t->rewind(t->ctx, goal))
        return false;
    if (close && goal - t->cpu->cycle > CLOSE)
        t->run(t->ctx, t->time(t->ctx, goal - CLOSE));
    look(search, goal);
    return true;
}

bool vm_gdb_go_back(struct vm_gdb_session *s)
{
    const struct vm_gdb_target *t = &s->target;
    bool step = s->run.how == VM_GDB_STEP_BACK;
    struct search search = {.s = s, .any = step};
    uint64_t goal = s->run.goal;
    if (!search_from(&search, goal, step)) {
        s->run.stop = (struct vm_gdb_stop){.reason = VM_GDB_BY_BEGINNING, .value = VM_GDB_SIGTRAP};
        return true;
    }
    if (step && !search.found) /* it waited for longer than that */
        search_from(&search, goal, false);
    t->rewind(t->ctx, goal);
    if (!search.found) {
        s->run.goal = t->cpu->cycle;
        return false;
    }
    s->reported_cycle = UINT64_MAX;
    const struct rv_hooks hooks = {&search.cycle, at_cycle, NULL, NULL};
    t->watch(t->ctx, t->time(t->ctx, search.cycle + 1), &hooks);
    s->run.stop = search.stop;
    return true;
}
