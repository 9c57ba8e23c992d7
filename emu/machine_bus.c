/* machine_bus.c — the machine's own ranges on the processor's bus: display processor registers,
 * display memory, identity. */
#include "display_file/df_regs.h"
#include "emu/machine_parts.h"
#include "emu/memmap.h"

/* ---- display processor --------------------------------------------------------------------------
 */

/* One past the last register of a VS60; a VT11 has those up to YPR, the others read 0. */
#define REGISTERS_END 040

static bool dpu_read(void *ctx, uint32_t offset, unsigned width, uint32_t *value)
{
    const struct vm_machine *m = ctx;
    (void)width;
    if (offset >= REGISTERS_END)
        return false;
    *value = df_dpu_read(&m->dpu, offset);
    return true;
}

/* START by a program: what a refresh is follows from the display file as it is now. */
static void start(struct vm_machine *m, uint16_t address, uint64_t t)
{
    bool running = m->refreshes.running;
    m->entry = address;
    m->refreshes.flow = vm_flow_of(m->memory, m->desc.memory_bytes, address);
    m->refreshes.running = running;
    vm_start(m, address, t);
}

/* RESUME after a stop word goes on with the display file behind it: another refresh. */
static void resume(struct vm_machine *m, uint16_t value, uint64_t t)
{
    bool stopped = m->dpu.state == DF_STOPPED;
    struct vm_counts counts = vm_counts(m);
    df_dpu_write(&m->dpu, DF_DPC, value, t);
    if (stopped)
        vm_refreshes_begin(&m->refreshes, m->dpu.t, &counts);
}

static bool dpu_write(void *ctx, uint32_t offset, unsigned width, uint32_t value)
{
    struct vm_machine *m = ctx;
    uint64_t t = vm_board_now(m->desc.board);
    (void)width;
    if (offset >= REGISTERS_END)
        return false;
    if (offset == DF_DPC && !(value & 1))
        start(m, (uint16_t)value, t);
    else if (offset == DF_DPC)
        resume(m, (uint16_t)value, t);
    else
        df_dpu_write(&m->dpu, offset, (uint16_t)value, t);
    rv_attention(&m->desc.board->cpu); /* who is next may have changed */
    return true;
}

/* ---- display memory -----------------------------------------------------------------------------
 */

static bool memory_read(void *ctx, uint32_t offset, unsigned width, uint32_t *value)
{
    const struct vm_machine *m = ctx;
    if (offset + width > m->desc.memory_bytes)
        return false;
    uint32_t word = m->memory[offset / 2];
    if (width == 4)
        *value = word | (uint32_t)m->memory[offset / 2 + 1] << 16;
    else
        *value = width == 2 ? word : word >> 8 * (offset & 1) & 0xFF;
    return true;
}

static bool memory_write(void *ctx, uint32_t offset, unsigned width, uint32_t value)
{
    struct vm_machine *m = ctx;
    if (offset + width > m->desc.memory_bytes)
        return false;
    uint16_t *word = &m->memory[offset / 2];
    if (width == 1) {
        unsigned shift = 8 * (offset & 1);
        *word = (uint16_t)((*word & ~(0xFFu << shift)) | (value & 0xFF) << shift);
        return true;
    }
    word[0] = (uint16_t)value;
    if (width == 4)
        word[1] = (uint16_t)(value >> 16);
    return true;
}

/* ---- identity -----------------------------------------------------------------------------------
 */

#define MAP_VERSION 3 /* 2: raster head; 3: input devices */
#define HEAD_VECTOR 1
#define HEAD_RASTER 2

static bool identity_read(void *ctx, uint32_t offset, unsigned width, uint32_t *value)
{
    const struct vm_machine *m = ctx;
    const struct crt_rate *clock = &m->desc.board->clock;
    (void)width;
    switch (offset) {
    case IDENTITY_MAGIC:
        *value = IDENTITY_KNSC;
        return true;
    case IDENTITY_VERSION:
        *value = MAP_VERSION;
        return true;
    case IDENTITY_HEADS:
        *value = HEAD_VECTOR | (m->desc.buffer ? HEAD_RASTER : 0);
        return true;
    case IDENTITY_ENTRY:
        *value = m->beside;
        return true;
    case IDENTITY_CLOCK:
        *value = (uint32_t)(clock->num / clock->den);
        return true;
    case IDENTITY_TICK:
        *value = (uint32_t)(m->ticks - 1);
        return true;
    default:
        return false;
    }
}

static bool identity_write(void *ctx, uint32_t offset, unsigned width, uint32_t value)
{
    struct vm_machine *m = ctx;
    struct vm_counts counts = vm_counts(m);
    (void)width;
    if (offset == IDENTITY_MARK) {
        m->marks++;
        m->mark = value;
    } else if (offset == IDENTITY_REFRESH) {
        vm_refreshes_declare(&m->refreshes, vm_board_now(m->desc.board), &counts);
    } else {
        return false;
    }
    rv_attention(&m->desc.board->cpu); /* somebody may wait for it */
    return true;
}

void vm_bus_connect(struct vm_machine *m)
{
    const struct bus_range ranges[] = {
        {MAP_DPU, MAP_DPU_SIZE, BUS_16, m, dpu_read, dpu_write},
        {MAP_DISPLAY, MAP_DISPLAY_SIZE, BUS_8 | BUS_16 | BUS_32, m, memory_read, memory_write},
        {MAP_IDENTITY, MAP_IDENTITY_SIZE, BUS_32, m, identity_read, identity_write},
    };
    for (size_t i = 0; i < sizeof ranges / sizeof *ranges; i++)
        bus_add(&m->desc.board->bus, &ranges[i]);
    if (m->desc.buffer)
        vm_raster_connect(m);
    if (m->desc.setup)
        vm_devices_connect(m);
}
