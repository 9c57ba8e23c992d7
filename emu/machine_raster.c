/* machine_raster.c — the raster head: its wires, and its registers on the processor's bus. */
#include "emu/machine_parts.h"
#include "emu/memmap.h"

/* ---- wires --------------------------------------------------------------------------------------
 */

static void scan_line(void *ctx, const struct crt_scan_line *line)
{
    struct vm_machine *m = ctx;
    if (m->desc.raster_tube)
        crt_tube_scan_line(m->desc.raster_tube, line);
    if (m->looks[INP_RASTER])
        inp_unit_line(&m->devices, line);
    if (m->hooks.scan)
        m->hooks.scan(m->hooks.ctx, line);
}

const unsigned vm_raster_lines[RAS_INT_COUNT] = {
    [RAS_INT_RETRACE] = IRQ_LINE_RETRACE, [RAS_INT_COMPARE] = IRQ_LINE_COMPARE};

static void interrupt(void *ctx, enum ras_interrupt which, bool level, uint64_t t)
{
    struct vm_machine *m = ctx;
    if (m->desc.board)
        vm_set_line(m, vm_raster_lines[which], level, t);
}

/* The tube's epochs are the fields of the timing that begins. */
static void retime(void *ctx, struct crt_rate field, uint64_t origin)
{
    struct vm_machine *m = ctx;
    if (!m->desc.raster_tube)
        return;
    vm_raster_advance(m, origin);
    crt_tube_set_epoch(m->desc.raster_tube, field, origin);
}

/* A frame is a refresh, as long as the display processor has never been started. */
static void retrace(void *ctx, uint64_t t, bool frame)
{
    struct vm_machine *m = ctx;
    vm_raster_advance(m, t);
    if (!frame || vm_machine_uses_vector(m))
        return;
    struct vm_counts counts = vm_counts(m);
    vm_refreshes_frame(&m->refreshes, t, &counts);
}

void vm_raster_wire(struct vm_machine *m, struct ras_wires *wires)
{
    *wires =
        (struct ras_wires){.ctx = m,
                           .line = m->desc.raster_tube || m->looks[INP_RASTER] ? scan_line : NULL,
                           .interrupt = interrupt,
                           .retime = retime,
                           .retrace = retrace};
}

void vm_raster_init(struct vm_machine *m)
{
    const struct crt_tube_row *row = m->desc.raster_row;
    struct ras_head_desc desc = {
        .buffer = m->desc.buffer,
        .width_mm = row->width.value,
        .height_mm = row->height.value,
        .border_mm = row->border.value,
        .guns = crt_tube_guns(row),
        .monitor = ras_monitor_of(row),
        .timing = m->desc.raster_timing,
    };
    vm_raster_wire(m, &desc.wires);
    ras_head_init(&m->raster, &desc);
}

void vm_raster_hook(struct vm_machine *m, bool hooked)
{
    static const struct ras_hooks none = {0};
    if (m->desc.buffer)
        ras_head_hook(&m->raster, hooked && m->hooks.raster ? m->hooks.raster : &none, m->now);
}

/* ---- time ---------------------------------------------------------------------------------------
 */

uint64_t vm_raster_next(const struct vm_machine *m)
{
    return m->desc.buffer ? ras_head_next(&m->raster) : VM_NEVER;
}

void vm_raster_event(struct vm_machine *m, uint64_t t)
{
    ras_head_event(&m->raster, t);
}

void vm_raster_advance(struct vm_machine *m, uint64_t t)
{
    if (m->desc.raster_tube && t > m->raster_advanced) {
        crt_tube_advance(m->desc.raster_tube, t);
        m->raster_advanced = t;
    }
}

/* ---- registers ----------------------------------------------------------------------------------
 */

static bool video_read(void *ctx, uint32_t offset, unsigned width, uint32_t *value)
{
    struct vm_machine *m = ctx;
    (void)width;
    return ras_head_read(&m->raster, offset, vm_board_now(m->desc.board), value);
}

static bool video_write(void *ctx, uint32_t offset, unsigned width, uint32_t value)
{
    struct vm_machine *m = ctx;
    (void)width;
    if (!ras_head_write(&m->raster, offset, value, vm_board_now(m->desc.board)))
        return false;
    rv_attention(&m->desc.board->cpu); /* who is next may have changed */
    return true;
}

static bool lut_read(void *ctx, uint32_t offset, unsigned width, uint32_t *value)
{
    const struct vm_machine *m = ctx;
    (void)width;
    *value = ras_head_lut_read(&m->raster, offset / 4);
    return true;
}

static bool lut_write(void *ctx, uint32_t offset, unsigned width, uint32_t value)
{
    struct vm_machine *m = ctx;
    (void)width;
    ras_head_lut_write(&m->raster, offset / 4, value);
    return true;
}

/* ---- refresh buffer -----------------------------------------------------------------------------
 */

static bool buffer_read(void *ctx, uint32_t offset, unsigned width, uint32_t *value)
{
    const uint8_t *byte = ((const struct vm_machine *)ctx)->desc.buffer + offset;
    *value = byte[0];
    for (unsigned i = 1; i < width; i++)
        *value |= (uint32_t)byte[i] << 8 * i;
    return true;
}

static bool buffer_write(void *ctx, uint32_t offset, unsigned width, uint32_t value)
{
    uint8_t *byte = ((struct vm_machine *)ctx)->desc.buffer + offset;
    for (unsigned i = 0; i < width; i++)
        byte[i] = (uint8_t)(value >> 8 * i);
    return true;
}

void vm_raster_connect(struct vm_machine *m)
{
    const struct bus_range ranges[] = {
        {MAP_VIDEO, MAP_VIDEO_SIZE, BUS_32, m, video_read, video_write},
        {MAP_VIDEO_LUT, MAP_VIDEO_LUT_SIZE, BUS_32, m, lut_read, lut_write},
        {MAP_VIDEO_BUFFER, MAP_VIDEO_BUFFER_SIZE, BUS_8 | BUS_16 | BUS_32, m, buffer_read,
         buffer_write},
    };
    for (size_t i = 0; i < sizeof ranges / sizeof *ranges; i++)
        bus_add(&m->desc.board->bus, &ranges[i]);
}
