/* gdb_back.c — going back: the target remembers, this says what to look for.
 *
 * A breakpoint stops where it stands, a watchpoint before the access, as its effect has been undone.
 * A load or store that will trap counts here, which it does not on the way forward: nobody knows yet.
 *
 * The target goes through stretches of the past, the latest first: through each once to count the
 * places, and through the one that has some once more, to the last of them. ^C makes it stop at the
 * end of the stretch before the one it was in.
 */
#include "emu/debug/gdb_parts.h"

struct search {
    struct vm_gdb_session *s;
    uint64_t last;  /* where the call before ended */
    bool any;       /* places were found */
    bool giving_up; /* in this stretch: every place will do */
    bool here;      /* where the processor is counts */
};

static bool look(void *ctx, struct rv_cpu *cpu)
{
    struct search *search = ctx;
    struct vm_gdb_session *s = search->s;
    struct vm_gdb_stop *stop = &s->run.stop;
    const struct vm_gdb_break *b = vm_gdb_break_at(&s->points, cpu->pc);
    bool here = search->here;
    search->here = true;
    if (!here)
        return false;
    if (!b)
        return s->points.watches > 0 && vm_gdb_reaches(&s->points, cpu, stop);
    *stop = (struct vm_gdb_stop){.reason = b->soft ? VM_GDB_BY_BREAK_SOFT : VM_GDB_BY_BREAK_HARD,
                                 .value = VM_GDB_SIGTRAP};
    return true;
}

static bool give_up(struct search *search, uint64_t limit, bool here)
{
    const struct vm_gdb_target *t = &search->s->target;
    search->s->run.stop = (struct vm_gdb_stop){.reason = VM_GDB_BY_SIGNAL, .value = VM_GDB_SIGINT};
    if (!here)
        t->run(t->ctx, limit);
    return here;
}

static bool find(void *ctx, uint64_t limit, bool here)
{
    struct search *search = ctx;
    struct vm_gdb_session *s = search->s;
    const struct vm_gdb_target *t = &s->target;
    const struct rv_hooks hooks = {search, look, NULL, NULL};
    bool begins = t->now(t->ctx) < search->last;
    if (s->look)
        s->look(s->look_ctx);
    if (begins && !search->any)
        search->giving_up = s->interrupted;
    search->here = here;
    bool found = search->giving_up ? give_up(search, limit, here) : t->watch(t->ctx, limit, &hooks);
    search->last = t->now(t->ctx);
    search->any |= found;
    return found;
}

void vm_gdb_go_back(struct vm_gdb_session *s)
{
    const struct vm_gdb_target *t = &s->target;
    struct search search = {.s = s, .last = UINT64_MAX};
    bool came;
    s->run.stop = (struct vm_gdb_stop){.reason = VM_GDB_BY_SIGNAL, .value = VM_GDB_SIGTRAP};
    if (s->run.how == VM_GDB_STEP_BACK)
        came = t->back(t->ctx);
    else
        came = t->back_until(t->ctx, find, &search);
    if (!came)
        s->run.stop.reason = VM_GDB_BY_BEGINNING;
}
