/* finisher.h — how a program ends the run and gives it an exit status.
 *
 *   store FINISHER_PASS              ─▶ status 0
 *   store FINISHER_FAIL | code << 16 ─▶ status code & 255, or 255 where that is 0
 *
 * Models:     one 32-bit register, that of emu/memmap.h. The low 16 bits of a store choose; the first
 *             that ends the run counts, later ones change nothing.
 * Time:       picoseconds since power-on.
 * Ownership:  the caller owns the struct; contexts must outlive it. Allocates nothing.
 * Errors:     other values and offsets are ignored; reads give 0. Status 0 never comes from a
 *             failure: a code whose low 8 bits are 0 would look like success to a shell.
 * Source:     SiFive's test finisher as QEMU has it (hw/misc/sifive_test.c), which takes 16-bit
 *             stores, too.
 * Not modelled: 0x7777, which resets QEMU's machine: ignored here.
 */
#ifndef EMU_BOARD_FINISHER_H
#define EMU_BOARD_FINISHER_H

#include <stdbool.h>
#include <stdint.h>

#include "crt/state.h"

struct vm_finisher_desc {
    void *ctx;
    void (*finished)(void *ctx, uint8_t status, uint64_t t); /* may be NULL */
};

struct vm_finisher {
    struct vm_finisher_desc desc;
    bool done;
    uint8_t status; /* exit status, when done */
    uint64_t t;     /* when it was stored */
};

void vm_finisher_init(struct vm_finisher *f, const struct vm_finisher_desc *desc);
void vm_finisher_reset(struct vm_finisher *f);

bool vm_finisher_read(struct vm_finisher *f, uint32_t offset, uint32_t *value, uint64_t t);
bool vm_finisher_write(struct vm_finisher *f, uint32_t offset, uint32_t value, uint64_t t);

/* A snapshot's section "FINI". */
void vm_finisher_state(struct vm_finisher *f, struct crt_state *s);

#endif
