/* rv.h — the processor: RV32IMF with Zicsr, Zifencei and Zicntr, machine mode only.
 *
 *                    ┌──────────────────────────────────────┐
 *  program memory ──▶│ decode once ─▶ entries ─▶ interpreter │──▶ bus: everything else
 *  interrupt lines ─▶│ x0…x31  f0…f31  pc  CSRs              │
 *                    └──────────────────────────────────────┘
 *
 * Models:     every instruction of RV32I, M, F, Zicsr, Zifencei; precise traps; direct and vectored
 *             interrupts; WFI; mcycle, minstret, cycle, time, instret; mscratch and the other
 *             machine CSRs. Floats to the last flag, rounding mode and canonical NaN.
 * Time:       one instruction a clock cycle, an instruction that traps too. `cycle` counts clocks
 *             since power-on; waiting in WFI lets them pass. What a cycle is in picoseconds is the
 *             machine's affair.
 * Units:      addresses in bytes, little-endian. Memory is a plain array of bytes.
 * Code:       runs from program memory only. Stores, also from outside, to words already decoded
 *             take effect at once: the cache of decoded words cannot be seen (stricter than
 *             Zifencei asks). Misaligned loads, stores and jumps trap.
 * Ownership:  rv_init allocates the cache of decoded words, rv_free releases it; memory and
 *             contexts belong to the caller and must outlive the processor.
 * Errors:     guest trouble is a trap. A trap whose handler cannot be fetched (mtvec points outside
 *             program memory) halts: RV_HALTED, with rv_cpu.trouble saying what happened first.
 * Source:     The RISC-V Instruction Set Manual, volumes I (20191213) and II (20211203).
 * Not modelled: user and supervisor mode, compressed and atomic instructions, PMP, debug mode.
 */
#ifndef EMU_CPU_RV_H
#define EMU_CPU_RV_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "crt/state.h"

/* Causes: mcause without the interrupt bit. */
enum rv_cause {
    RV_FETCH_MISALIGNED = 0,
    RV_FETCH_FAULT = 1,
    RV_ILLEGAL = 2,
    RV_BREAKPOINT = 3,
    RV_LOAD_MISALIGNED = 4,
    RV_LOAD_FAULT = 5,
    RV_STORE_MISALIGNED = 6,
    RV_STORE_FAULT = 7,
    RV_ECALL_M = 11,
};

/* Interrupt bits in mip and mie, and their causes. External, software, timer: in this order. */
enum { RV_INT_SOFTWARE = 3, RV_INT_TIMER = 7, RV_INT_EXTERNAL = 11 };

/* Everything outside program memory. `width` is 1, 2 or 4 bytes, the address is aligned to it, and
 * a value to be stored has no bits above it. False: access fault. cpu->cycle is the access's own
 * clock while they run. They may call rv_set_interrupt and rv_attention, nothing else of the
 * processor. */
struct rv_bus {
    void *ctx;
    bool (*load)(void *ctx, uint32_t address, unsigned width, uint32_t *value);
    bool (*store)(void *ctx, uint32_t address, unsigned width, uint32_t value);
    uint64_t (*time)(void *ctx); /* what the time CSR reads; NULL: cycle */
};

struct rv_desc {
    uint8_t *memory;      /* program memory */
    uint32_t memory_base; /* multiple of 4096 */
    uint32_t memory_size; /* multiple of 4096 */
    struct rv_bus bus;
};

enum rv_state { RV_RUNNING, RV_WAITING /* in WFI */, RV_HALTED /* until reset */ };

/* A trap nobody can handle. */
struct rv_trouble {
    uint32_t cause; /* as mcause */
    uint32_t pc;    /* of the instruction that trapped */
    uint32_t value; /* as mtval */
    uint64_t cycle;
};

#define RV_MAX_ROM 16

struct rv_range {
    uint32_t low, high; /* addresses, high excluded */
};

struct rv_entry; /* a decoded instruction (emu/cpu/rv_decode.h) */

struct rv_cpu {
    struct rv_desc desc;

    /* What a program sees. x[0] is 0; x[32] takes what is written to x0. Float registers as bits. */
    uint32_t x[33];
    uint32_t f[32];
    uint32_t pc;
    uint32_t fflags, frm;
    uint32_t mstatus; /* MIE, MPIE, FS; MPP reads as machine, SD follows FS */
    uint32_t mie, mip, mtvec, mscratch, mepc, mcause, mtval, mcountinhibit;
    uint64_t cycle;         /* clocks since power-on */
    uint64_t idle;          /* clocks that retired nothing: in WFI, or trapping */
    uint64_t cycle_offset;  /* mcycle = cycle + this (mcycle can be written) */
    uint64_t retire_offset; /* minstret = cycle - idle + this */
    uint64_t cycle_held, retire_held; /* their values while mcountinhibit holds them */
    enum rv_state state;
    struct rv_trouble trouble; /* valid when RV_HALTED */

    /* How it is done; not part of the machine's state. */
    struct rv_entry *entries;
    uint8_t *decoded; /* a page of 4096 bytes each: 1 when it has decoded words */
    struct rv_range rom[RV_MAX_ROM];
    int rom_count;
    uint32_t store_low, store_size; /* where a store needs no second look, from memory_base */
    bool attention;
};

/* False: out of memory for the cache. Resets. */
bool rv_init(struct rv_cpu *cpu, const struct rv_desc *desc);
void rv_free(struct rv_cpu *cpu);
/* Power-on: pc = memory_base, registers 0, interrupts off. ROM ranges, cycle and the levels of
 * interrupt lines stay. */
void rv_reset(struct rv_cpu *cpu);

/* Stores to [low, high) within program memory trap from now on; false when there are too many
 * ranges. rv_writable makes all of memory writable again. */
bool rv_protect(struct rv_cpu *cpu, uint32_t low, uint32_t high);
void rv_writable(struct rv_cpu *cpu);

/* Somebody else (loader, debugger, snapshot) changed program memory in [low, high). */
void rv_changed(struct rv_cpu *cpu, uint32_t low, uint32_t high);

/* Executes instructions while cycle < until, the processor runs and nobody asked for attention.
 * Interrupts are taken before the first one. In WFI it returns at once, with cycle as it was;
 * rv_wait moves it on. Exact: cycle never passes `until`. */
void rv_run(struct rv_cpu *cpu, uint64_t until);

/* In WFI: lets clocks pass up to `until`. */
void rv_wait(struct rv_cpu *cpu, uint64_t until);

/* A second loop for debuggers and traces. `before` is called with the instruction at pc about to be
 * executed (after an interrupt was taken, when one is); true: stop before it. `after` follows it:
 * `pc` and `word` are the instruction's own, `trapped` when it did not retire. Either may be NULL.
 * rv_watch returns true when `before` stopped it. An interrupt taken calls `interrupt`. */
struct rv_hooks {
    void *ctx;
    bool (*before)(void *ctx, struct rv_cpu *cpu);
    void (*after)(void *ctx, struct rv_cpu *cpu, uint32_t pc, uint32_t word, bool trapped);
    void (*interrupt)(void *ctx, struct rv_cpu *cpu, uint32_t cause);
};
bool rv_watch(struct rv_cpu *cpu, uint64_t until, const struct rv_hooks *hooks);

/* Level of an interrupt line (RV_INT_…). Leaves WFI when it is high and enabled in mie. A change asks
 * for attention. */
void rv_set_interrupt(struct rv_cpu *cpu, int line, bool level);
/* From within a bus access: rv_run is to return after this instruction. */
void rv_attention(struct rv_cpu *cpu);

/* minstret as it would count from power-on without writes to it. */
uint64_t rv_retired(const struct rv_cpu *cpu);

/* CSRs by number, as csrr and csrw do; false: there is no such CSR, or it is read-only. */
bool rv_csr_read(struct rv_cpu *cpu, unsigned csr, uint32_t *value);
bool rv_csr_write(struct rv_cpu *cpu, unsigned csr, uint32_t value);

/* Bytes of program memory as an instruction sees them; false when outside. */
bool rv_fetch(const struct rv_cpu *cpu, uint32_t pc, uint32_t *word);

/* What a load or store would do; false when `word` is none. Reads registers as they are. */
struct rv_access {
    uint32_t address;
    unsigned width;
    bool store;
};
bool rv_access_of(const struct rv_cpu *cpu, uint32_t word, struct rv_access *access);

/* A snapshot's section "RV32": everything but the decoded words and ROM ranges. Memory is the
 * caller's to save, and to load before this. */
void rv_state(struct rv_cpu *cpu, struct crt_state *s);

/* "load access fault" and the like; an interrupt's name when bit 31 is set. */
const char *rv_cause_name(uint32_t cause);

#endif
