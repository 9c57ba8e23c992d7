/* head.h — the raster head: refresh buffer, timing, registers, scan-out.
 *
 *            ┌──────────── counters: dot, line, field ───────────┐
 *   bus ────▶│ registers     latches (base, pitch, format)       │──▶ lines: retrace, compare
 *   buffer ──┼──────▶ one event a line: pixels ▶ look-up table ──┼──▶ sink: scan lines in mm
 *            └───────────────────────────────────────────────────┘──▶ retime: a new timing began
 *
 * Models:     the head to the dot. Time 0 of a timing is when it was taken (VIDEO_LOAD, or sync
 *             switched on); dot n begins crt_tick_time(clock, n) later. A line begins with its visible
 *             dots, a field with its visible lines; then comes blanking with the sync pulse. Where the
 *             vertical sync pulse begins (retrace) base, pitch and format are taken and RETRACE is set;
 *             they are taken, too, when a timing begins.
 * Scan-out:   at one instant before each line its pixels and the look-up table are read as they are
 *             then, and the line goes to the sink; what is stored later shows in the next field. That
 *             is where the overscan on its left begins whatever its colour: as many dots before dot 0 as
 *             the tube's border is wide, in the back porch at most.
 * Overscan:   the tube's border left, right, above and below is scanned in the overscan colour as far
 *             as blanking has room (porches; never during sync); black overscan is left out. Rows above
 *             the picture count -1, -2 … upwards, in `source` modulo 2^32.
 * Interlace:  the first field has rows 0, 2, 4 …; the second begins half a line later, so its lines
 *             lie half a line pitch lower: rows 1, 3, 5 … Row r begins r half lines after its field. The
 *             sync pulse of either field begins one half line after its place in the table, so that
 *             the second field has room for its last row: fields have their pulses at the same place.
 * Time:       picoseconds since power-on.
 * Position:   the picture fills the addressable width and height of the tube; sweeps go from left to
 *             right at constant speed, level; millimetres from the centre, y up.
 * Mono tubes: the drive is luma, (77·R + 150·G + 29·B + 128) >> 8.
 * A new timing while a line is under way: that line is finished; lines that would begin before its end
 *             are not scanned.
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

/* For traces: sync pulses and picture, each as it happens. Set while sync is off, or by
 * ras_head_hook(). */
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

/* The running timing worked out; private. Dots, but for rows. */
struct ras_sweep {
    int64_t line;                 /* a line */
    int64_t unit;                 /* from the beginning of a row to that of the next */
    int64_t field;                /* a field */
    int64_t sync_begin, sync_end; /* vertical sync, from the beginning of a field */
    int64_t left, right;          /* overscan on either side */
    int64_t step;                 /* rows from line to line: 1, or 2 when interlaced */
    int64_t top, bottom;          /* first and last row with overscan */
};

struct ras_head {
    struct ras_head_desc desc;
    struct ras_hooks hooks;   /* zero: none */
    struct ras_timing timing; /* that runs, or would */
    struct ras_timing wanted; /* the timing registers */
    bool on, blank;
    uint32_t status, irq_enable, overscan, compare; /* status: the bits that stay */
    struct ras_latch latch, next;
    uint32_t lut[VIDEO_LUT_ENTRIES]; /* 00RRGGBB */
    uint64_t origin;                 /* when dot 0 of the timing began */
    /* Private. */
    struct ras_sweep sweep;
    uint64_t next_dot, next_time; /* of the next event; dots since origin */
    unsigned next_kind;
    uint64_t signal_dot, signal_time; /* of the next call of hooks.signal */
    unsigned signal_kind;
    uint64_t lit_until; /* when the last line ends */
    uint8_t dots[CRT_MAX_GUNS][CRT_MAX_DOTS];
};

void ras_head_init(struct ras_head *head, const struct ras_head_desc *desc);
/* Power-on state at t, the buffer as it is. */
void ras_head_reset(struct ras_head *head, uint64_t t);

/* When something happens by itself next; UINT64_MAX: never. And what happens then. */
uint64_t ras_head_next(const struct ras_head *head);
void ras_head_event(struct ras_head *head, uint64_t t);

/* Sets the hooks at time t, everything before which has happened. */
void ras_head_hook(struct ras_head *head, const struct ras_hooks *hooks, uint64_t t);

/* Registers at time t, everything before which has happened; false: there is none at that offset. A
 * write may change ras_head_next(), to t at the earliest. Those that can only be read are left as they
 * are by a write. */
bool ras_head_read(const struct ras_head *head, uint32_t offset, uint64_t t, uint32_t *value);
bool ras_head_write(struct ras_head *head, uint32_t offset, uint32_t value, uint64_t t);

/* The look-up table, entry by entry. */
uint32_t ras_head_lut_read(const struct ras_head *head, uint32_t entry);
void ras_head_lut_write(struct ras_head *head, uint32_t entry, uint32_t value);

/* The beam at time t: see VIDEO_BEAM_LINE. False while the head is off: both are 0. */
bool ras_head_beam(const struct ras_head *head, uint64_t t, uint32_t *line, uint32_t *dot);
/* Fields begun since the timing was taken, the present one included; 0 while the head is off. */
uint64_t ras_head_fields(const struct ras_head *head, uint64_t t);

/* A row of the picture as the buffer, base, pitch, format and look-up table are now, H_VISIBLE pixels
 * 00RRGGBB; in the overscan colour beyond the buffer. `colour` has room for 7 more. */
void ras_head_pixels(const struct ras_head *head, uint32_t row, uint32_t *colour);

/* All but the buffer, which is the caller's to save; hostile when loaded. The caller checks that
 * ras_head_next() is not before its time and that the levels of the interrupt wires, which are not
 * called, are those it has. A head whose loading failed is as after
 * power-on. */
void ras_head_state(struct ras_head *head, struct crt_state *s);
/* The level of an interrupt wire. */
bool ras_head_interrupt(const struct ras_head *head, enum ras_interrupt which);

#endif
