/* rv_state.c — what a snapshot holds of the processor: what a program could see, and the clocks. Not
 * the decoded words, which cannot be seen, nor ROM ranges, which come with the program. */
#include "emu/cpu/rv_parts.h"

#define VERSION 1

#define MIP_BITS     (1u << RV_INT_SOFTWARE | 1u << RV_INT_TIMER | 1u << RV_INT_EXTERNAL)
#define MSTATUS_BITS (uint32_t)(RV_MSTATUS_MIE | RV_MSTATUS_MPIE | RV_MSTATUS_FS)
#define INHIBIT_BITS 5u /* cycle and instret */

static void registers(struct rv_cpu *cpu, struct crt_state *s)
{
    for (int i = 1; i < 32; i++)
        crt_state_u32(s, &cpu->x[i]);
    for (int i = 0; i < 32; i++)
        crt_state_u32(s, &cpu->f[i]);
    crt_state_u32(s, &cpu->pc);
}

static void csrs(struct rv_cpu *cpu, struct crt_state *s)
{
    crt_state_u32(s, &cpu->fflags);
    crt_state_u32(s, &cpu->frm);
    crt_state_u32(s, &cpu->mstatus);
    crt_state_u32(s, &cpu->mie);
    crt_state_u32(s, &cpu->mip);
    crt_state_u32(s, &cpu->mtvec);
    crt_state_u32(s, &cpu->mscratch);
    crt_state_u32(s, &cpu->mepc);
    crt_state_u32(s, &cpu->mcause);
    crt_state_u32(s, &cpu->mtval);
    crt_state_u32(s, &cpu->mcountinhibit);
}

static void clocks(struct rv_cpu *cpu, struct crt_state *s)
{
    unsigned state = cpu->state;
    crt_state_u64(s, &cpu->cycle);
    crt_state_u64(s, &cpu->idle);
    crt_state_u64(s, &cpu->cycle_offset);
    crt_state_u64(s, &cpu->retire_offset);
    crt_state_u64(s, &cpu->cycle_held);
    crt_state_u64(s, &cpu->retire_held);
    crt_state_unsigned(s, &state, RV_HALTED);
    cpu->state = (enum rv_state)state;
    crt_state_u32(s, &cpu->trouble.cause);
    crt_state_u32(s, &cpu->trouble.pc);
    crt_state_u32(s, &cpu->trouble.value);
    crt_state_u64(s, &cpu->trouble.cycle);
}

void rv_state(struct rv_cpu *cpu, struct crt_state *s)
{
    crt_state_begin(s, "RV32", VERSION);
    registers(cpu, s);
    csrs(cpu, s);
    clocks(cpu, s);
    crt_state_end(s);
    if (!s->loading)
        return;
    crt_state_check(s, cpu->fflags < 32 && cpu->frm < 8, "float control");
    crt_state_check(s, !(cpu->mstatus & ~MSTATUS_BITS) && !((cpu->mie | cpu->mip) & ~MIP_BITS),
                    "processor status");
    crt_state_check(s, !(cpu->mtvec & 2) && !(cpu->mepc & 3), "trap vector");
    crt_state_check(s, !(cpu->mcountinhibit & ~INHIBIT_BITS), "counter inhibition");
    crt_state_check(s, cpu->idle <= cpu->cycle && cpu->cycle < UINT64_MAX / 4, "cycle count");
    cpu->x[0] = 0;
    cpu->attention = false;
    rv_changed(cpu, cpu->desc.memory_base, cpu->desc.memory_base + cpu->desc.memory_size);
}
