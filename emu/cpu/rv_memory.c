/* rv_memory.c — program memory where it needs a second look: read-only ranges, decoded words.
 *
 * A page is marked when a word in it is decoded. Stores are free of looks within one window: the
 * largest stretch of memory that has no marked page and no read-only byte. Programs keep code and
 * constants together, so the window has data, heap and stack in it. */
#include "emu/cpu/rv_decode.h"
#include "emu/cpu/rv_parts.h"

static uint32_t low_of(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

static uint32_t high_of(uint32_t a, uint32_t b)
{
    return a > b ? a : b;
}

/* Offsets of a range within memory, cut off at its ends; high may lie behind it. */
static bool clip(const struct rv_cpu *cpu, uint32_t low, uint32_t high, uint32_t *from,
                 uint32_t *to)
{
    uint64_t base = cpu->desc.memory_base, end = base + cpu->desc.memory_size;
    uint64_t first = low > base ? low : base, last = high < end ? high : end;
    if (first >= last)
        return false;
    *from = (uint32_t)(first - base);
    *to = (uint32_t)(last - base);
    return true;
}

static bool read_only(const struct rv_cpu *cpu, uint32_t address, unsigned width)
{
    for (int i = 0; i < cpu->rom_count; i++)
        if (address + (width - 1) >= cpu->rom[i].low && address < cpu->rom[i].high)
            return true;
    return false;
}

/* Where the next read-only byte at or behind `offset` begins, and the first byte after its range. */
static uint32_t next_rom(const struct rv_cpu *cpu, uint32_t offset, uint32_t *behind)
{
    uint32_t first = cpu->desc.memory_size;
    *behind = first;
    for (int i = 0; i < cpu->rom_count; i++) {
        uint32_t from, to;
        if (!clip(cpu, cpu->rom[i].low, cpu->rom[i].high, &from, &to) || to <= offset)
            continue;
        if (high_of(from, offset) < first) {
            first = high_of(from, offset);
            *behind = to;
        }
    }
    return first;
}

/* Keeps [from, to), shrunk to whole words, as the window if it is the largest so far. */
static void offer(struct rv_cpu *cpu, uint32_t from, uint32_t to)
{
    from = (from + 3) & ~3u;
    to &= ~3u;
    if (to > from && to - from > cpu->store_size) {
        cpu->store_low = from;
        cpu->store_size = to - from;
    }
}

/* The stretch without marked pages [from, to), less read-only ranges. */
static void offer_stretch(struct rv_cpu *cpu, uint32_t from, uint32_t to)
{
    while (from < to) {
        uint32_t behind, rom = next_rom(cpu, from, &behind);
        offer(cpu, from, low_of(rom, to));
        from = behind;
    }
}

static void find_window(struct rv_cpu *cpu)
{
    uint32_t pages = cpu->desc.memory_size / RV_PAGE, page = 0;
    cpu->store_low = cpu->store_size = 0;
    while (page < pages) {
        uint32_t first = page;
        while (page < pages && !cpu->decoded[page])
            page++;
        offer_stretch(cpu, first * RV_PAGE, page * RV_PAGE);
        while (page < pages && cpu->decoded[page])
            page++;
    }
}

void rv_mark_decoded(struct rv_cpu *cpu, uint32_t offset)
{
    uint32_t page = offset / RV_PAGE;
    if (cpu->decoded[page])
        return;
    cpu->decoded[page] = 1;
    /* Most code lies outside the window anyway. */
    if ((page + 1) * RV_PAGE > cpu->store_low && page * RV_PAGE < cpu->store_low + cpu->store_size)
        find_window(cpu);
}

bool rv_protect(struct rv_cpu *cpu, uint32_t low, uint32_t high)
{
    if (cpu->rom_count == RV_MAX_ROM)
        return false;
    cpu->rom[cpu->rom_count++] = (struct rv_range){low, high};
    find_window(cpu);
    return true;
}

void rv_writable(struct rv_cpu *cpu)
{
    cpu->rom_count = 0;
    find_window(cpu);
}

/* Words first … last are to be decoded anew. The entry before them stays, because another one may use
 * its operands, but it does no longer do the work of the first of them. */
static void forget(struct rv_cpu *cpu, uint32_t first, uint32_t last)
{
    uint32_t from = rv_index_of_word(first), to = rv_index_of_word(last);
    memset(cpu->entries + from, 0, (size_t)(to - from + 1) * sizeof *cpu->entries);
    if (from > 0)
        rv_part(cpu->entries + from - 1);
}

void rv_changed(struct rv_cpu *cpu, uint32_t low, uint32_t high)
{
    uint32_t from, to;
    bool unmarked = false;
    if (!clip(cpu, low, high, &from, &to))
        return;
    for (uint32_t page = from / RV_PAGE; page * RV_PAGE < to; page++) {
        uint32_t start = page * RV_PAGE, end = start + RV_PAGE;
        if (!cpu->decoded[page])
            continue;
        forget(cpu, high_of(from, start) / 4, (low_of(to, end) - 1) / 4);
        if (from <= start && end <= to) {
            cpu->decoded[page] = 0;
            unmarked = true;
        }
    }
    if (unmarked)
        find_window(cpu);
}

bool rv_load(struct rv_cpu *cpu, uint32_t address, unsigned width, uint32_t *value)
{
    uint32_t offset = address - cpu->desc.memory_base;
    if (offset >= cpu->desc.memory_size)
        return cpu->desc.bus.load(cpu->desc.bus.ctx, address, width, value);
    *value = rv_bytes_get(cpu->desc.memory + offset, width);
    return true;
}

bool rv_store(struct rv_cpu *cpu, uint32_t address, unsigned width, uint32_t value)
{
    uint32_t offset = address - cpu->desc.memory_base;
    if (width < 4)
        value &= (1u << 8 * width) - 1;
    if (offset >= cpu->desc.memory_size)
        return cpu->desc.bus.store(cpu->desc.bus.ctx, address, width, value);
    if (read_only(cpu, address, width))
        return false;
    rv_bytes_put(cpu->desc.memory + offset, width, value);
    if (cpu->decoded[offset / RV_PAGE])
        forget(cpu, offset / 4, offset / 4);
    return true;
}

bool rv_fetch(const struct rv_cpu *cpu, uint32_t pc, uint32_t *word)
{
    if (!rv_fetchable(cpu, pc))
        return false;
    *word = rv_bytes_get(cpu->desc.memory + (pc - cpu->desc.memory_base), 4);
    return true;
}
