/* rv_run.c — the fast loop, and who calls which loop. */
#include "emu/cpu/rv_arithmetic.h"
#include "emu/cpu/rv_decode.h"
#include "emu/cpu/rv_float_fast.h"
#include "emu/cpu/rv_parts.h"

/* Labels as values are an extension of gcc and clang. */
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#define LOOP rv_fast
#define ROOM RV_RUN
#define EACH 0
#include "emu/cpu/rv_loop.inc"
#pragma GCC diagnostic pop

void rv_run(struct rv_cpu *cpu, uint64_t until)
{
    cpu->attention = false;
    while (cpu->state == RV_RUNNING && cpu->cycle < until && !cpu->attention) {
        if (rv_take_interrupt(cpu))
            continue;
        if (!rv_fetchable(cpu, cpu->pc))
            rv_fetch_trap(cpu);
        else if (until - cpu->cycle >= RV_RUN)
            rv_fast(cpu, until);
        else
            rv_exact(cpu, until);
    }
}
