/* rv_watch.c — one instruction at a time, for debuggers and traces. */
#include "emu/cpu/rv_parts.h"

bool rv_watch(struct rv_cpu *cpu, uint64_t until, const struct rv_hooks *hooks)
{
    cpu->attention = false;
    while (cpu->state == RV_RUNNING && cpu->cycle < until && !cpu->attention) {
        if (rv_take_interrupt(cpu)) {
            /* Without a handler to take it the processor has halted. */
            if (hooks->interrupt != NULL && cpu->state != RV_HALTED)
                hooks->interrupt(hooks->ctx, cpu, cpu->mcause);
            continue;
        }
        if (hooks->before != NULL && hooks->before(hooks->ctx, cpu))
            return true;
        uint32_t pc = cpu->pc, word = 0;
        uint64_t idle = cpu->idle;
        if (rv_fetch(cpu, pc, &word))
            rv_exact(cpu, cpu->cycle + 1);
        else
            rv_fetch_trap(cpu);
        if (hooks->after != NULL)
            hooks->after(hooks->ctx, cpu, pc, word, cpu->idle != idle);
    }
    return false;
}
