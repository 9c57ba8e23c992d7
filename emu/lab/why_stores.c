#include "emu/lab/why_stores.h"

#include <stdlib.h>

#include "emu/memmap.h"

#define PAGE  4096u
#define PAGES ((MAP_DISPLAY_SIZE + MAP_VIDEO_BUFFER_SIZE) / PAGE)

struct writer {
    uint32_t pc, ra;
    uint64_t clock; /* of the store, plus 1; 0: nobody */
};

struct vm_stores {
    struct vm_board *board; /* tapped; NULL: none */
    struct rv_bus bus;      /* its own */
    bool failed;
    struct writer *page[PAGES];
};

struct vm_stores *vm_stores_create(void)
{
    return calloc(1, sizeof(struct vm_stores));
}

void vm_stores_free(struct vm_stores *s)
{
    if (!s)
        return;
    vm_stores_untap(s);
    for (size_t i = 0; i < PAGES; i++)
        free(s->page[i]);
    free(s);
}

bool vm_stores_intact(const struct vm_stores *s)
{
    return !s->failed;
}

/* ---- the tap --------------------------------------------------------------------------------- */

/* Bytes of display memory, then those of the refresh buffer; false: neither. */
static bool offset_of(uint32_t address, uint32_t *offset)
{
    if (address - MAP_DISPLAY < MAP_DISPLAY_SIZE)
        *offset = address - MAP_DISPLAY;
    else if (address - MAP_VIDEO_BUFFER < MAP_VIDEO_BUFFER_SIZE)
        *offset = MAP_DISPLAY_SIZE + (address - MAP_VIDEO_BUFFER);
    else
        return false;
    return true;
}

/* An aligned store lies within one page. */
static void note(struct vm_stores *s, uint32_t offset, unsigned width)
{
    const struct rv_cpu *cpu = &s->board->cpu;
    struct writer **page = &s->page[offset / PAGE];
    if (!*page && !(*page = calloc(PAGE, sizeof **page))) {
        s->failed = true;
        return;
    }
    for (unsigned i = 0; i < width; i++)
        (*page)[offset % PAGE + i] = (struct writer){cpu->pc, cpu->x[1], cpu->cycle + 1};
}

static bool tap_load(void *ctx, uint32_t address, unsigned width, uint32_t *value)
{
    const struct vm_stores *s = ctx;
    return s->bus.load(s->bus.ctx, address, width, value);
}

static bool tap_store(void *ctx, uint32_t address, unsigned width, uint32_t value)
{
    struct vm_stores *s = ctx;
    uint32_t offset;
    if (!s->bus.store(s->bus.ctx, address, width, value))
        return false;
    if (offset_of(address, &offset))
        note(s, offset, width);
    return true;
}

static uint64_t tap_time(void *ctx)
{
    const struct vm_stores *s = ctx;
    return s->bus.time(s->bus.ctx);
}

void vm_stores_tap(struct vm_stores *s, struct vm_rig *rig)
{
    vm_stores_untap(s);
    if (!rig->board)
        return;
    s->board = rig->board;
    s->bus = s->board->cpu.desc.bus;
    s->board->cpu.desc.bus = (struct rv_bus){s, tap_load, tap_store, s->bus.time ? tap_time : NULL};
}

void vm_stores_untap(struct vm_stores *s)
{
    if (s->board)
        s->board->cpu.desc.bus = s->bus;
    s->board = NULL;
}

/* ---- who it was ------------------------------------------------------------------------------ */

struct vm_why_store vm_stores_last(const struct vm_stores *s, uint32_t address, uint32_t bytes)
{
    static const struct crt_rate clock = {VM_CPU_HZ, 1};
    struct writer last = {0};
    uint32_t offset;
    for (uint32_t i = 0; i < bytes; i++) {
        const struct writer *page = offset_of(address + i, &offset) ? s->page[offset / PAGE] : NULL;
        if (page && page[offset % PAGE].clock > last.clock)
            last = page[offset % PAGE];
    }
    if (!last.clock)
        return (struct vm_why_store){0};
    uint64_t cycle = last.clock - 1;
    return (struct vm_why_store){.known = true,
                                 .pc = last.pc,
                                 .returns_to = last.ra,
                                 .cycle = cycle,
                                 .t = s->board ? vm_board_time(s->board, cycle)
                                               : crt_tick_time(clock, cycle)};
}
