/* clint.h — the core-local interruptor: a clock that counts, a time to interrupt at, a software
 * interrupt.
 *
 *   ps ─÷ 100 000─▶ mtime ──┐
 *                           ├─ mtime >= mtimecmp ─▶ timer
 *               mtimecmp ───┘             msip ───▶ software
 *
 * Models:     msip, mtimecmp and mtime of one hart at the offsets of emu/memmap.h, 32 bits each, all
 *             readable and writable. 64-bit registers are written in halves; what the halves mean in
 *             between is what the comparison sees.
 * Time:       picoseconds since power-on. mtime counts at 10 MHz, exactly: floor(t / 100 000 ps) plus
 *             what a write to it has added; wraps at 2^64.
 * Power-on:   msip 0, mtimecmp all ones: no interrupt. On QEMU's board mtimecmp is 0 and the timer
 *             interrupt pending: programs for both write mtimecmp before they enable it.
 * Ownership:  the caller owns the struct; contexts must outlive it. Allocates nothing.
 * Errors:     other offsets read 0 and ignore writes.
 * Source:     RISC-V Advanced Core Local Interruptor Specification 1.0-rc4 (registers as SiFive's
 *             CLINT); rate as on QEMU's riscv32 "virt" board.
 * Not modelled: more harts, 64-bit accesses (RV32 has none), 8- and 16-bit ones.
 */
#ifndef EMU_BOARD_CLINT_H
#define EMU_BOARD_CLINT_H

#include <stdbool.h>
#include <stdint.h>

#include "crt/state.h"
#include "emu/board/wire.h"

struct vm_clint_desc {
    struct vm_wire timer, software;
};

struct vm_clint {
    struct vm_clint_desc desc;
    uint64_t mtimecmp;
    uint64_t offset; /* mtime - floor(t / 100 000 ps), modulo 2^64 */
    uint64_t next;   /* ps: when the timer line next changes by itself; UINT64_MAX: never */
    bool timer;      /* levels */
    bool software;   /* = msip */
};

void vm_clint_init(struct vm_clint *c, const struct vm_clint_desc *desc);
void vm_clint_reset(struct vm_clint *c, uint64_t t);

bool vm_clint_read(struct vm_clint *c, uint32_t offset, uint32_t *value, uint64_t t);
bool vm_clint_write(struct vm_clint *c, uint32_t offset, uint32_t value, uint64_t t);

/* mtime. */
uint64_t vm_clint_time(const struct vm_clint *c, uint64_t t);

/* When the timer line next changes without a write, and the change. */
uint64_t vm_clint_next(const struct vm_clint *c);
void vm_clint_event(struct vm_clint *c, uint64_t t);

/* A snapshot's section "CLNT". */
void vm_clint_state(struct vm_clint *c, struct crt_state *s);

#endif
