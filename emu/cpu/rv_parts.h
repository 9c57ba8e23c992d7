/* rv_parts.h — what the parts of the processor offer each other; not for users of rv.h.
 *
 *      rv_run, rv_watch ─▶ loops (rv_fast, rv_exact) ─▶ rv_slow ─▶ rv_csr, rv_trap, rv_memory
 *
 * Models:     nothing by itself.
 * Ownership:  all of it works on the caller's processor.
 * Errors:     guest trouble becomes a trap (rv_trap).
 */
#ifndef EMU_CPU_RV_PARTS_H
#define EMU_CPU_RV_PARTS_H

#include <string.h>

#include "emu/cpu/rv.h"
#include "emu/cpu/rv_float.h"

/* mstatus. */
enum {
    RV_MSTATUS_MIE = 1 << 3,
    RV_MSTATUS_MPIE = 1 << 7,
    RV_MSTATUS_MPP = 3 << 11,
    RV_MSTATUS_FS = 3 << 13, /* off, initial, clean, dirty */
};

/* ---- loops: execute while cycle < until and nothing else is to be looked at; pc is fetchable ---- */

/* Needs RV_RUN clocks at least, and may leave up to so many. */
void rv_fast(struct rv_cpu *cpu, uint64_t until);
void rv_exact(struct rv_cpu *cpu, uint64_t until);

/* The instruction at pc, whatever it is except integer arithmetic. True: it retired and the next
 * one follows it in memory. False: look at the processor again (it jumped or trapped, or what it
 * did may concern interrupts or the loop). */
bool rv_slow(struct rv_cpu *cpu);

/* ---- traps ---- */

/* The instruction at pc traps instead of retiring. Costs its clock. */
void rv_trap(struct rv_cpu *cpu, uint32_t cause, uint32_t value);
/* True: one was pending and is taken. */
bool rv_take_interrupt(struct rv_cpu *cpu);
void rv_mret(struct rv_cpu *cpu);
/* Leaves WFI when an interrupt is pending and enabled in mie. */
void rv_wake(struct rv_cpu *cpu);
/* Whether pc points into program memory, at an instruction. */
bool rv_fetchable(const struct rv_cpu *cpu, uint32_t pc);
/* pc is not fetchable: the trap that it raises. */
void rv_fetch_trap(struct rv_cpu *cpu);

/* ---- memory ---- */

#define RV_PAGE 4096u /* what rv_cpu.decoded counts in */

/* Aligned. False: access fault. Outside memory they ask the bus. */
bool rv_load(struct rv_cpu *cpu, uint32_t address, unsigned width, uint32_t *value);
bool rv_store(struct rv_cpu *cpu, uint32_t address, unsigned width, uint32_t value);
/* Words of this page are being decoded: stores to it need a second look from now on. */
void rv_mark_decoded(struct rv_cpu *cpu, uint32_t offset);

/* Little-endian bytes, `width` of them. */
static inline uint32_t rv_bytes_get(const uint8_t *at, unsigned width)
{
    uint32_t value = 0;
    for (unsigned i = 0; i < width; i++)
        value |= (uint32_t)at[i] << 8 * i;
    return value;
}

static inline void rv_bytes_put(uint8_t *at, unsigned width, uint32_t value)
{
    for (unsigned i = 0; i < width; i++)
        at[i] = (uint8_t)(value >> 8 * i);
}

/* ---- CSRs and floats ---- */

bool rv_csr_exists(const struct rv_cpu *cpu, unsigned csr);
bool rv_csr_read_only(unsigned csr);

static inline bool rv_float_on(const struct rv_cpu *cpu)
{
    return (cpu->mstatus & RV_MSTATUS_FS) != 0;
}

static inline bool rv_float_dirty(const struct rv_cpu *cpu)
{
    return (cpu->mstatus & RV_MSTATUS_FS) == RV_MSTATUS_FS;
}

/* What the loops may do with float instructions. */
enum rv_float_mode {
    RV_FLOAT_OFF,   /* nothing: mstatus.FS is off, or is to become dirty */
    RV_FLOAT_EXACT, /* move and compare; rounding is for rv_float.h */
    RV_FLOAT_HOST,  /* all that rv_float_fast.h has */
};

static inline enum rv_float_mode rv_float_mode(const struct rv_cpu *cpu)
{
    if (!rv_float_dirty(cpu))
        return RV_FLOAT_OFF;
    return (cpu->fflags & RV_NX) != 0 && cpu->frm == RV_RNE ? RV_FLOAT_HOST : RV_FLOAT_EXACT;
}

/* An instruction on float registers (opcodes MADD … OP-FP). False: illegal. */
bool rv_float_slow(struct rv_cpu *cpu, uint32_t word);

#endif
