/* head_parts.h — what the files of the raster head share.
 *
 * Events: at a dot, in the order of their kinds. Everything is worked out from the dot count; only the
 * next event is remembered.
 */
#ifndef RASTER_HEAD_PARTS_H
#define RASTER_HEAD_PARTS_H

#include "raster/head.h"

#define RAS_NEVER UINT64_MAX

enum ras_event {
    RAS_EVENT_RETRACE, /* vertical sync begins */
    RAS_EVENT_COMPARE, /* the row LINE_COMPARE begins */
    RAS_EVENT_LINE,    /* pixels of a line are read */
    RAS_EVENTS
};

#define RAS_STATUS_IRQ (VIDEO_STATUS_RETRACE | VIDEO_STATUS_COMPARE)
#define RAS_STATUS_STAYS                                                                           \
    (RAS_STATUS_IRQ | VIDEO_STATUS_BAD_MODE | VIDEO_STATUS_OUT_RANGE | VIDEO_STATUS_BAD_FORMAT |   \
     VIDEO_STATUS_BAD_BASE)
#define RAS_COLOUR 0xffffffu

/* ---- head_time.c: dots and time ----------------------------------------------------------------- */

void ras_sweep_of(struct ras_sweep *w, const struct ras_timing *timing,
                  const struct ras_head_desc *desc);
uint64_t ras_dot_time(const struct ras_head *head, uint64_t dot);
uint64_t ras_dot_at(const struct ras_head *head, uint64_t t);

/* The row that begins at this dot, within sweep.top … V_TOTAL − 1. */
int64_t ras_row_at(const struct ras_head *head, uint64_t begin);
/* Where the first line begins that does so after dot `after` (below 0: any) and whose row lies within
 * first … last; RAS_NEVER when there is none. */
uint64_t ras_line_after(const struct ras_head *head, int64_t after, int64_t first, int64_t last);
/* Dot within the period of the first such one after `after`. */
uint64_t ras_periodic_after(int64_t after, int64_t offset, int64_t period);

/* The next event, when those up to `dot` have happened, at `dot` itself kinds before `kind` only. */
void ras_schedule(struct ras_head *head, uint64_t dot, unsigned kind);

/* ---- head_scan.c: lines -------------------------------------------------------------------------- */

/* A line whose row begins at this dot. */
void ras_scan(struct ras_head *head, uint64_t begin);
/* Whether all pixels of a row lie in the buffer; where they begin. */
bool ras_row_address(const struct ras_head *head, uint32_t row, uint32_t *at);

/* ---- head_pixels.c: formats ---------------------------------------------------------------------- */

bool ras_format_exists(uint32_t format);
/* Bytes that `count` pixels take. */
uint32_t ras_format_bytes(uint32_t format, uint32_t count);
/* `count` pixels, at least one, as xxRRGGBB; up to 7 more of `colour` are overwritten. */
void ras_read_pixels(uint32_t format, const uint8_t *from, uint32_t count,
                     const uint32_t lut[VIDEO_LUT_ENTRIES], uint32_t *colour);
/* Drives of guns from xxRRGGBB. */
void ras_drive_guns(const uint32_t *colour, uint32_t count, uint8_t *red, uint8_t *green,
                    uint8_t *blue);
void ras_drive_luma(const uint32_t *colour, uint32_t count, uint8_t *luma);

/* ---- head_signals.c: hooks ----------------------------------------------------------------------- */

void ras_signals_from(struct ras_head *head, uint64_t dot);
void ras_signals_until(struct ras_head *head, uint64_t t);

/* ---- head.c -------------------------------------------------------------------------------------- */

/* The timing begins at t with a first field. */
void ras_start(struct ras_head *head, uint64_t t);
void ras_stop(struct ras_head *head);
/* Sets and clears status bits and interrupts' enables, and tells the wires. */
void ras_change(struct ras_head *head, uint32_t status, uint32_t irq_enable, uint64_t t);

#endif
