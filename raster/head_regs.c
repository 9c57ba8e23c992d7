/* The registers. */
#include <assert.h>
#include <string.h>

#include "raster/head_parts.h"

/* The timing register at this offset; NULL: it is none. */
static uint32_t *timing_register(struct ras_timing *t, uint32_t offset)
{
    switch (offset) {
    case VIDEO_H_VISIBLE:
        return &t->h.visible;
    case VIDEO_H_SYNC_START:
        return &t->h.sync_start;
    case VIDEO_H_SYNC_END:
        return &t->h.sync_end;
    case VIDEO_H_TOTAL:
        return &t->h.total;
    case VIDEO_V_VISIBLE:
        return &t->v.visible;
    case VIDEO_V_SYNC_START:
        return &t->v.sync_start;
    case VIDEO_V_SYNC_END:
        return &t->v.sync_end;
    case VIDEO_V_TOTAL:
        return &t->v.total;
    default:
        return NULL;
    }
}

/* ---- reading ---------------------------------------------------------------------------------- */

/* Which part of its line, field and frame the beam is in. */
static uint32_t beam_status(const struct ras_head *head, uint64_t t)
{
    const struct ras_span *h = &head->timing.h, *v = &head->timing.v;
    uint32_t line, dot;
    if (!ras_head_beam(head, t, &line, &dot))
        return VIDEO_STATUS_VBLANK | VIDEO_STATUS_HBLANK;
    int64_t n = (int64_t)ras_dot_at(head, t), field = n / head->sweep.field;
    int64_t in_field = n % head->sweep.field;
    uint32_t status = 0;
    status |= line >= v->visible ? VIDEO_STATUS_VBLANK : 0;
    status |= dot >= h->visible ? VIDEO_STATUS_HBLANK : 0;
    status |= dot >= h->sync_start && dot < h->sync_end ? VIDEO_STATUS_HSYNC : 0;
    if (in_field >= head->sweep.sync_begin && in_field < head->sweep.sync_end)
        status |= VIDEO_STATUS_VSYNC;
    if (head->timing.interlaced && field % 2)
        status |= VIDEO_STATUS_FIELD;
    return status;
}

static uint32_t status(const struct ras_head *head, uint64_t t)
{
    bool waiting = memcmp(&head->next, &head->latch, sizeof head->next) != 0;
    return head->status | beam_status(head, t) | (waiting ? VIDEO_STATUS_WAITING : 0);
}

static uint32_t sync_register(const struct ras_timing *t)
{
    return (t->h_plus ? VIDEO_SYNC_H_PLUS : 0u) | (t->v_plus ? VIDEO_SYNC_V_PLUS : 0u) |
           (t->interlaced ? VIDEO_SYNC_INTERLACED : 0u);
}

static uint32_t micrometres(double mm)
{
    return (uint32_t)(mm * 1000 + 0.5);
}

static bool read_timing(const struct ras_head *head, uint32_t offset, uint32_t *value)
{
    struct ras_timing wanted = head->wanted;
    const uint32_t *field = timing_register(&wanted, offset);
    if (field)
        *value = *field;
    else if (offset == VIDEO_CLOCK)
        *value = (uint32_t)(wanted.clock.num / wanted.clock.den);
    else if (offset == VIDEO_SYNC)
        *value = sync_register(&wanted);
    else if (offset == VIDEO_LOAD)
        *value = 0;
    else
        return false;
    return true;
}

bool ras_head_read(const struct ras_head *head, uint32_t offset, uint64_t t, uint32_t *value)
{
    uint32_t line, dot;
    switch (offset) {
    case VIDEO_CONTROL:
        *value = (head->on ? VIDEO_CONTROL_ON : 0u) | (head->blank ? VIDEO_CONTROL_BLANK : 0u);
        return true;
    case VIDEO_STATUS:
        *value = status(head, t);
        return true;
    case VIDEO_IRQ_ENABLE:
        *value = head->irq_enable;
        return true;
    case VIDEO_BASE:
        *value = head->next.base;
        return true;
    case VIDEO_PITCH:
        *value = head->next.pitch;
        return true;
    case VIDEO_FORMAT:
        *value = head->next.format;
        return true;
    case VIDEO_OVERSCAN:
        *value = head->overscan;
        return true;
    case VIDEO_LINE_COMPARE:
        *value = head->compare;
        return true;
    case VIDEO_BEAM_LINE:
        ras_head_beam(head, t, value, &dot);
        return true;
    case VIDEO_BEAM_DOT:
        ras_head_beam(head, t, &line, value);
        return true;
    case VIDEO_FIELDS:
        *value = (uint32_t)ras_head_fields(head, t);
        return true;
    case VIDEO_WIDTH_UM:
        *value = micrometres(head->desc.width_mm);
        return true;
    case VIDEO_HEIGHT_UM:
        *value = micrometres(head->desc.height_mm);
        return true;
    default:
        return read_timing(head, offset, value);
    }
}

/* ---- writing ---------------------------------------------------------------------------------- */

static void control(struct ras_head *head, uint32_t value, uint64_t t)
{
    bool on = value & VIDEO_CONTROL_ON;
    head->blank = value & VIDEO_CONTROL_BLANK;
    if (on && !head->on)
        ras_start(head, t);
    else if (!on && head->on)
        ras_stop(head);
}

static void load(struct ras_head *head, uint64_t t)
{
    struct crt_error err;
    uint32_t refused = 0;
    if (!ras_timing_check(&head->wanted, &err))
        refused = VIDEO_STATUS_BAD_MODE;
    else if (!ras_monitor_follows(&head->desc.monitor, &head->wanted, "the monitor", &err))
        refused = VIDEO_STATUS_OUT_RANGE;
    head->status |= refused;
    if (refused)
        return;
    head->timing = head->wanted;
    if (head->on)
        ras_start(head, t);
}

static void format(struct ras_head *head, uint32_t value)
{
    if (ras_format_exists(value))
        head->next.format = value;
    else
        head->status |= VIDEO_STATUS_BAD_FORMAT;
}

static void compare(struct ras_head *head, uint32_t value, uint64_t t)
{
    head->compare = value;
    if (head->on)
        ras_schedule(head, ras_dot_at(head, t), RAS_EVENTS);
}

static bool write_timing(struct ras_head *head, uint32_t offset, uint32_t value, uint64_t t)
{
    uint32_t *field = timing_register(&head->wanted, offset);
    if (field) {
        *field = value;
    } else if (offset == VIDEO_CLOCK) {
        head->wanted.clock = (struct crt_rate){value, 1};
    } else if (offset == VIDEO_SYNC) {
        head->wanted.h_plus = value & VIDEO_SYNC_H_PLUS;
        head->wanted.v_plus = value & VIDEO_SYNC_V_PLUS;
        head->wanted.interlaced = value & VIDEO_SYNC_INTERLACED;
    } else if (offset == VIDEO_LOAD) {
        load(head, t);
    } else {
        return false;
    }
    return true;
}

bool ras_head_write(struct ras_head *head, uint32_t offset, uint32_t value, uint64_t t)
{
    switch (offset) {
    case VIDEO_CONTROL:
        control(head, value, t);
        return true;
    case VIDEO_STATUS:
        ras_change(head, head->status & ~value, head->irq_enable, t);
        return true;
    case VIDEO_IRQ_ENABLE:
        ras_change(head, head->status, value & RAS_STATUS_IRQ, t);
        return true;
    case VIDEO_BASE:
        head->next.base = value & ~3u;
        return true;
    case VIDEO_PITCH:
        head->next.pitch = value & ~3u;
        return true;
    case VIDEO_FORMAT:
        format(head, value);
        return true;
    case VIDEO_OVERSCAN:
        head->overscan = value & RAS_COLOUR;
        return true;
    case VIDEO_LINE_COMPARE:
        compare(head, value, t);
        return true;
    case VIDEO_BEAM_LINE:
    case VIDEO_BEAM_DOT:
    case VIDEO_FIELDS:
    case VIDEO_WIDTH_UM:
    case VIDEO_HEIGHT_UM:
        return true;
    default:
        return write_timing(head, offset, value, t);
    }
}

uint32_t ras_head_lut_read(const struct ras_head *head, uint32_t entry)
{
    assert(entry < VIDEO_LUT_ENTRIES);
    return head->lut[entry];
}

void ras_head_lut_write(struct ras_head *head, uint32_t entry, uint32_t value)
{
    assert(entry < VIDEO_LUT_ENTRIES);
    head->lut[entry] = value & RAS_COLOUR;
}
