/* rv_trap.c — traps and interrupts. */
#include "emu/cpu/rv_parts.h"

#define INTERRUPT 0x80000000u

bool rv_fetchable(const struct rv_cpu *cpu, uint32_t pc)
{
    return pc - cpu->desc.memory_base < cpu->desc.memory_size && (pc & 3) == 0;
}

static uint32_t handler_of(const struct rv_cpu *cpu, uint32_t cause)
{
    uint32_t base = cpu->mtvec & ~3u;
    bool vectored = (cpu->mtvec & 3) == 1 && (cause & INTERRUPT) != 0;
    return vectored ? base + 4 * (cause & ~INTERRUPT) : base;
}

/* pc goes to the handler; without one the processor halts as it was when this happened. */
static void enter(struct rv_cpu *cpu, uint32_t cause, uint32_t value, uint64_t cycle)
{
    uint32_t handler = handler_of(cpu, cause);
    if (!rv_fetchable(cpu, handler)) {
        cpu->state = RV_HALTED;
        cpu->trouble = (struct rv_trouble){cause, cpu->pc, value, cycle};
        return;
    }
    cpu->mepc = cpu->pc & ~3u;
    cpu->mcause = cause;
    cpu->mtval = value;
    uint32_t was_on = cpu->mstatus & RV_MSTATUS_MIE;
    cpu->mstatus &= ~(uint32_t)(RV_MSTATUS_MIE | RV_MSTATUS_MPIE);
    if (was_on)
        cpu->mstatus |= RV_MSTATUS_MPIE;
    cpu->pc = handler;
}

void rv_trap(struct rv_cpu *cpu, uint32_t cause, uint32_t value)
{
    uint64_t cycle = cpu->cycle++;
    cpu->idle++;
    enter(cpu, cause, value, cycle);
}

void rv_fetch_trap(struct rv_cpu *cpu)
{
    rv_trap(cpu, cpu->pc & 3 ? RV_FETCH_MISALIGNED : RV_FETCH_FAULT, cpu->pc);
}

bool rv_take_interrupt(struct rv_cpu *cpu)
{
    uint32_t pending = cpu->mip & cpu->mie;
    if (pending == 0 || !(cpu->mstatus & RV_MSTATUS_MIE))
        return false;
    static const unsigned order[] = {RV_INT_EXTERNAL, RV_INT_SOFTWARE, RV_INT_TIMER};
    for (unsigned i = 0; i < sizeof order / sizeof order[0]; i++)
        if (pending & 1u << order[i]) {
            enter(cpu, INTERRUPT | order[i], 0, cpu->cycle);
            return true;
        }
    return false;
}

void rv_mret(struct rv_cpu *cpu)
{
    cpu->mstatus &= ~(uint32_t)RV_MSTATUS_MIE;
    if (cpu->mstatus & RV_MSTATUS_MPIE)
        cpu->mstatus |= RV_MSTATUS_MIE;
    cpu->mstatus |= RV_MSTATUS_MPIE;
    cpu->pc = cpu->mepc;
}

void rv_wake(struct rv_cpu *cpu)
{
    if (cpu->state == RV_WAITING && (cpu->mip & cpu->mie) != 0)
        cpu->state = RV_RUNNING;
}

void rv_set_interrupt(struct rv_cpu *cpu, int line, bool level)
{
    uint32_t bit = 1u << line, was = cpu->mip;
    cpu->mip = level ? was | bit : was & ~bit;
    if (cpu->mip != was)
        cpu->attention = true;
    rv_wake(cpu);
}

void rv_attention(struct rv_cpu *cpu)
{
    cpu->attention = true;
}

void rv_wait(struct rv_cpu *cpu, uint64_t until)
{
    if (cpu->state != RV_WAITING || until <= cpu->cycle)
        return;
    cpu->idle += until - cpu->cycle;
    cpu->cycle = until;
}

const char *rv_cause_name(uint32_t cause)
{
    switch (cause) {
    case RV_FETCH_MISALIGNED:
        return "instruction address misaligned";
    case RV_FETCH_FAULT:
        return "instruction access fault";
    case RV_ILLEGAL:
        return "illegal instruction";
    case RV_BREAKPOINT:
        return "breakpoint";
    case RV_LOAD_MISALIGNED:
        return "load address misaligned";
    case RV_LOAD_FAULT:
        return "load access fault";
    case RV_STORE_MISALIGNED:
        return "store address misaligned";
    case RV_STORE_FAULT:
        return "store access fault";
    case RV_ECALL_M:
        return "environment call";
    case INTERRUPT | RV_INT_SOFTWARE:
        return "software interrupt";
    case INTERRUPT | RV_INT_TIMER:
        return "timer interrupt";
    case INTERRUPT | RV_INT_EXTERNAL:
        return "external interrupt";
    default:
        return "unknown cause";
    }
}
