/* flow.h — where a display file goes round: what one refresh of it is.
 *
 *      entry ─▶ preamble ─▶ head ─▶ … ─▶ jump head    loops without sync: a refresh begins at head
 *      entry ─▶ … sync … ─▶ jump                      loops with sync: it begins at each release
 *      entry ─▶ … ─▶ stop                             the stand-in restarts it: it begins at START
 *
 * Models:     the VT11 has neither conditions nor subroutines, so the order of its words follows
 *             from the words alone. A refresh ends where the processor stops, starts to wait for a
 *             sync tick, or comes back to the head. A lone sync word is not a refresh.
 * Addresses:  even byte addresses.
 * Ownership:  plain value.
 * Errors:     none; a file that leaves memory or hangs simply has no loop.
 */
#ifndef EMU_FLOW_H
#define EMU_FLOW_H

#include <stdbool.h>
#include <stdint.h>

#define VM_NO_HEAD 0xFFFFFFFFu

struct vm_flow {
    bool stops;        /* reaches a stop word */
    bool loops;        /* comes back to a word already executed, with no stop between */
    bool synchronised; /* waits for the sync tick somewhere in what repeats */
    bool start_begins; /* START begins a refresh: something is drawn before the first sync */
    uint32_t head;     /* a fetch here begins a refresh; VM_NO_HEAD when ticks or stops do that */
};

struct vm_flow vm_flow_of(const uint16_t *memory, uint32_t memory_bytes, uint32_t entry);

#endif
