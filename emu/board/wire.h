/* wire.h — one output of a device: who is told when its level changes.
 *
 *      device ──level, t──▶ set(ctx, …)        the device knows neither who listens nor why
 *
 * Models:     a wire that is high or low. A device tells of changes only; low at power-on.
 * Time:       picoseconds since power-on.
 * Ownership:  ctx belongs to whoever listens.
 * Errors:     none; set may be NULL: nobody listens.
 * Source:     the habit of one wire a device: TinyEMU's iomem.h.
 * Not modelled: delays.
 */
#ifndef EMU_BOARD_WIRE_H
#define EMU_BOARD_WIRE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct vm_wire {
    void *ctx;
    void (*set)(void *ctx, bool level, uint64_t t);
};

/* `level` is what the device remembers of the wire. */
static inline void vm_wire_drive(const struct vm_wire *wire, bool *level, bool now, uint64_t t)
{
    if (*level == now)
        return;
    *level = now;
    if (wire->set != NULL)
        wire->set(wire->ctx, now, t);
}

#endif
