/* bus.h — address ranges and who answers there.
 *
 *      processor ──load, store──▶ range ──▶ device (read, write)
 *
 * Models:     a range has a base, a size and the widths it takes; an access that no range takes, or
 *             of another width, is an access fault. Accesses are aligned.
 * Ownership:  the bus keeps copies of ranges; contexts belong to the devices.
 * Errors:     ranges that overlap, or too many: assert.
 * Source:     the plan of TinyEMU's iomem.h: {base, size, read, write, context} a device.
 * Not modelled: wait states, bursts, bus masters other than the processor.
 */
#ifndef EMU_BOARD_BUS_H
#define EMU_BOARD_BUS_H

#include <stdbool.h>
#include <stdint.h>

/* Widths a range takes, ORed. */
enum { BUS_8 = 1, BUS_16 = 2, BUS_32 = 4 };

struct bus_range {
    uint32_t base, size;
    unsigned widths;
    void *ctx;
    /* Offsets from base. False: access fault. */
    bool (*read)(void *ctx, uint32_t offset, unsigned width, uint32_t *value);
    bool (*write)(void *ctx, uint32_t offset, unsigned width, uint32_t value);
};

#define BUS_MAX_RANGES 16

struct bus {
    struct bus_range range[BUS_MAX_RANGES]; /* in order of base */
    int count;
};

void bus_init(struct bus *bus);
void bus_add(struct bus *bus, const struct bus_range *range);
bool bus_load(struct bus *bus, uint32_t address, unsigned width, uint32_t *value);
bool bus_store(struct bus *bus, uint32_t address, unsigned width, uint32_t value);

#endif
