/* head.h — the raster head: refresh buffer, timing, registers, scan-out.
 *
 *            ┌──────────── counters: dot, line, field ───────────┐
 *   bus ────▶│ registers     latches (base, pitch, format)       │──▶ lines: retrace, compare
 *   buffer ──┼──────▶ one event a line: pixels ▶ look-up table ──┼──▶ sink: scan lines in mm
 *            └───────────────────────────────────────────────────┘──▶ retime: a new timing began
 *
 * Models:     the head to the dot. Time 0 of a timing is when it was taken (VIDEO_LOAD, or sync
 *             switched on); dot n begins crt_tick_time(clock, n) later. In order of time, a field has
 *             its visible lines, then blanking with the sync pulse. At the start of the vertical sync
 *             pulse (retrace) base, pitch and format are taken and RETRACE is set.
 * Scan-out:   the event at a line's first visible dot reads its pixels and the look-up table as they
 *             are then and hands the line to the sink; what is stored later shows in the next field.
 *             Overscan: the tube's border left, right, above and below is scanned in the overscan
 *             colour as far as blanking has room (porches; never during sync).
 * Interlace:  the first field has rows 0, 2, 4 …; the second begins half a line later, so its lines
 *             lie half a line pitch lower: rows 1, 3, 5 …
 * Time:       picoseconds since power-on.
 * Position:   the picture fills the addressable width and height of the tube; sweeps go from left to
 *             right at constant speed, level; millimetres from the centre, y up.
 * Mono tubes: the drive is luma, (77·R + 150·G + 29·B + 128) >> 8.
 * Ownership:  the caller owns the struct and everything the desc points at. Allocates nothing.
 * Errors:     guest trouble becomes status bits (raster/video_regs.h); misuse asserts.
 * Not modelled: bus contention; slope of the lines; time the monitor takes to lock to a new timing.
 */
#ifndef RASTER_HEAD_H
#define RASTER_HEAD_H

#include "crt/piece.h"
#include "crt/state.h"
#include "raster/mode.h"
#include "raster/video_regs.h"

enum ras_interrupt { RAS_INT_RETRACE, RAS_INT_COMPARE, RAS_INT_COUNT };

/* Where lines go, and what else follows; any may be NULL. */
struct ras_wires {
    void *ctx;
    void (*line)(void *ctx, const struct crt_scan_line *line); /* NULL: nobody looks */
    void (*interrupt)(void *ctx, enum ras_interrupt which, bool level, uint64_t t);
    void (*retime)(void *ctx, struct crt_rate field, uint64_t origin); /* fields from here on */
    /* Vertical retrace begins; `frame`: the frame is complete, too (always when not interlaced). */
    void (*retrace)(void *ctx, uint64_t t, bool frame);
};

/* For traces: sync pulses and picture, each as it happens. */
enum ras_signal { RAS_HSYNC, RAS_VSYNC, RAS_PICTURE };
struct ras_hooks {
    void *ctx;
    /* Sync pulses begin (level true) and end; RAS_PICTURE: a row of the picture begins and ends. */
    void (*signal)(void *ctx, enum ras_signal signal, bool level, uint64_t t);
    /* Base, pitch and format were taken. */
    void (*latch)(void *ctx, uint64_t t);
};

struct ras_head_desc {
    uint8_t *buffer; /* VIDEO_BUFFER_BYTES */
    double width_mm, height_mm, border_mm;
    int guns; /* 1 or 3 */
    struct ras_monitor monitor;
    struct ras_timing timing; /* at power-on; the monitor follows it */
    struct ras_wires wires;
};

/* What is taken at retrace. */
struct ras_latch {
    uint32_t base, pitch, format;
};

struct ras_head {
    struct ras_head_desc desc;
    struct ras_hooks hooks;   /* zero: none */
    struct ras_timing timing; /* that runs */
    struct ras_timing wanted; /* the timing registers */
    bool on, blank;
    uint32_t status, irq_enable, overscan, compare; /* status: the bits that stay */
    struct ras_latch latch, next;
    uint32_t lut[VIDEO_LUT_ENTRIES];
    uint64_t origin;     /* when dot 0 of the timing began */
    uint64_t fields;     /* begun since then, the present one included */
    uint64_t next_event; /* dot since origin of the next event; private, as what follows */
    uint32_t step;       /* which event of the field that is */
    uint8_t dots[CRT_MAX_GUNS][CRT_MAX_DOTS];
};

void ras_head_init(struct ras_head *head, const struct ras_head_desc *desc);
/* Power-on state at t, the buffer as it is. */
void ras_head_reset(struct ras_head *head, uint64_t t);

/* When something happens by itself next; UINT64_MAX: never. And what happens then. */
uint64_t ras_head_next(const struct ras_head *head);
void ras_head_event(struct ras_head *head, uint64_t t);

/* Registers at time t, everything before which has happened; false: there is none at that offset. A
 * write may change ras_head_next(). */
bool ras_head_read(const struct ras_head *head, uint32_t offset, uint64_t t, uint32_t *value);
bool ras_head_write(struct ras_head *head, uint32_t offset, uint32_t value, uint64_t t);

/* The beam at time t: see VIDEO_BEAM_LINE. False while the head is off. */
bool ras_head_beam(const struct ras_head *head, uint64_t t, uint32_t *line, uint32_t *dot);

/* All but the buffer, which is the caller's to save; hostile when loaded. */
void ras_head_state(struct ras_head *head, struct crt_state *s);

#endif
