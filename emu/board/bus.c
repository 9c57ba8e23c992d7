#include "emu/board/bus.h"

#include <assert.h>
#include <stddef.h>

void bus_init(struct bus *bus)
{
    bus->count = 0;
}

/* How many ranges begin at or below an address. */
static int ranges_from(const struct bus *bus, uint32_t address)
{
    int low = 0, high = bus->count;
    while (low < high) {
        int middle = (low + high) / 2;
        if (bus->range[middle].base <= address)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static uint64_t end_of(const struct bus_range *range)
{
    return (uint64_t)range->base + range->size;
}

void bus_add(struct bus *bus, const struct bus_range *range)
{
    int at = ranges_from(bus, range->base);

    assert(bus->count < BUS_MAX_RANGES);
    assert(range->size > 0 && end_of(range) <= UINT64_C(1) << 32);
    assert(range->read && range->write);
    assert((range->widths & ~(unsigned)(BUS_8 | BUS_16 | BUS_32)) == 0);
    assert(at == 0 || end_of(&bus->range[at - 1]) <= range->base);
    assert(at == bus->count || end_of(range) <= bus->range[at].base);
    for (int i = bus->count; i > at; i--)
        bus->range[i] = bus->range[i - 1];
    bus->range[at] = *range;
    bus->count++;
}

/* Widths in bytes are the bits of `widths`. */
static const struct bus_range *find(const struct bus *bus, uint32_t address, unsigned width)
{
    int n = ranges_from(bus, address);
    const struct bus_range *range = n > 0 ? &bus->range[n - 1] : NULL;

    if (range == NULL || (uint64_t)address + width > end_of(range) || !(range->widths & width))
        return NULL;
    return range;
}

bool bus_load(struct bus *bus, uint32_t address, unsigned width, uint32_t *value)
{
    const struct bus_range *range = find(bus, address, width);
    return range && range->read(range->ctx, address - range->base, width, value);
}

bool bus_store(struct bus *bus, uint32_t address, unsigned width, uint32_t value)
{
    const struct bus_range *range = find(bus, address, width);
    return range && range->write(range->ctx, address - range->base, width, value);
}
