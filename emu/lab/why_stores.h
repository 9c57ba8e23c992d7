/* why_stores.h — who wrote what: the last store to each byte of display memory and refresh buffer.
 *
 *      processor ──store──▶ tap ──▶ bus
 *                            └──▶ page of 4096 bytes: pc, ra and clock for each
 *
 * Models:     every store that the bus took, as it happens; one pass at the processor's full speed (the
 *             tap is on the bus, which program memory is not behind).
 * Memory:     16 bytes for each byte, in pages that exist once something in them was stored to: 12.6 MB for
 *             a picture of 1024 × 768 bytes.
 * Ownership:  vm_stores_create allocates, vm_stores_free releases. While it taps a rig, that must stay
 *             where it is; vm_stores_untap gives it its bus back.
 * Errors:     out of memory: vm_stores_intact is false.
 */
#ifndef EMU_LAB_WHY_STORES_H
#define EMU_LAB_WHY_STORES_H

#include "emu/lab/why.h"

struct vm_stores;

struct vm_stores *vm_stores_create(void);      /* NULL: out of memory */
void vm_stores_free(struct vm_stores *stores); /* NULL is nothing */
bool vm_stores_intact(const struct vm_stores *stores);

/* Records what the rig's processor stores from now on; of a rig without one nothing. */
void vm_stores_tap(struct vm_stores *stores, struct vm_rig *rig);
void vm_stores_untap(struct vm_stores *stores);

/* The last store to any of `bytes` bytes from a bus address on. Without its instruction word. */
struct vm_why_store vm_stores_last(const struct vm_stores *stores, uint32_t address,
                                   uint32_t bytes);

#endif
