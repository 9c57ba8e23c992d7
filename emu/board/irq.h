/* irq.h — the interrupt controller: one line a device, one wire to the processor.
 *
 *   line 1 ──▶┌─────────┐   ┌────────┐
 *     …       │ PENDING │─&─│ ENABLE │──any──▶ external interrupt
 *   line 8 ──▶└─────────┘   └────────┘
 *                    CLAIM = the lowest that is both
 *
 * Models:     the registers of emu/memmap.h, 32 bits each. Level-triggered: a line is pending while
 *             its device holds it high, so reading CLAIM changes nothing and there is nothing to
 *             complete; a handler quiets the device.
 * Time:       picoseconds since power-on, passed on with the wire.
 * Power-on:   all lines low, none enabled.
 * Ownership:  the caller owns the struct; contexts must outlive it. Allocates nothing.
 * Errors:     other offsets read 0 and ignore writes, as do the bits of lines that are none; a line
 *             outside 1…8 in vm_irq_set asserts.
 * Source:     this project's own (emu/memmap.h); QEMU's "virt" board has a PLIC elsewhere.
 * Not modelled: priorities, thresholds, edge triggers.
 */
#ifndef EMU_BOARD_IRQ_H
#define EMU_BOARD_IRQ_H

#include <stdbool.h>
#include <stdint.h>

#include "crt/state.h"
#include "emu/board/wire.h"

struct vm_irq_desc {
    struct vm_wire external;
};

struct vm_irq {
    struct vm_irq_desc desc;
    uint32_t pending, enable; /* bit n: line n */
    bool level;               /* of external */
};

void vm_irq_init(struct vm_irq *q, const struct vm_irq_desc *desc);
/* Lines are the devices': they stay as they are. */
void vm_irq_reset(struct vm_irq *q, uint64_t t);

void vm_irq_set(struct vm_irq *q, unsigned line, bool level, uint64_t t);

bool vm_irq_read(struct vm_irq *q, uint32_t offset, uint32_t *value, uint64_t t);
bool vm_irq_write(struct vm_irq *q, uint32_t offset, uint32_t value, uint64_t t);

/* A snapshot's section "IRQC". */
void vm_irq_state(struct vm_irq *q, struct crt_state *s);

#endif
