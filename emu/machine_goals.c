/* machine_goals.c — runs until something happens. */
#include "emu/machine_parts.h"

static bool run_to(struct vm_machine *m, uint64_t limit, enum vm_goal_kind kind, uint64_t count)
{
    return vm_run_goal(m, limit, (struct vm_goal){.kind = kind, .count = count});
}

bool vm_machine_run_refresh(struct vm_machine *m, uint64_t limit)
{
    return run_to(m, limit, VM_GOAL_REFRESH, m->refreshes.last.number);
}

bool vm_machine_run_stop(struct vm_machine *m, uint64_t limit)
{
    return run_to(m, limit, VM_GOAL_STOP, m->stops);
}

bool vm_machine_run_console(struct vm_machine *m, uint64_t limit)
{
    return run_to(m, limit, VM_GOAL_CONSOLE, 0);
}

bool vm_machine_run_mark(struct vm_machine *m, uint32_t mark, uint64_t limit)
{
    return vm_run_goal(m, limit, (struct vm_goal){VM_GOAL_MARK, m->marks, mark, false});
}

bool vm_machine_run_end(struct vm_machine *m, uint64_t limit)
{
    return run_to(m, limit, VM_GOAL_END, 0);
}

bool vm_machine_run_retired(struct vm_machine *m, uint64_t retired, uint64_t limit)
{
    return run_to(m, limit, VM_GOAL_RETIRED, retired);
}

bool vm_machine_run_words(struct vm_machine *m, uint64_t words, uint64_t limit)
{
    return run_to(m, limit, VM_GOAL_WORDS, words);
}

bool vm_run_drawn(struct vm_machine *m, uint64_t limit)
{
    return run_to(m, limit, VM_GOAL_DRAWN, m->strokes);
}

bool vm_run_timing(struct vm_machine *m, uint64_t limit)
{
    return vm_run_goal(m, limit,
                       (struct vm_goal){VM_GOAL_TIMING, m->raster.origin, 0, m->raster.on});
}
