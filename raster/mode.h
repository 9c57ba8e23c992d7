/* mode.h — video timing: modes by table and by formula, and what a monitor can follow.
 *
 *      │◀──────── visible ────────▶│◀front▶│◀sync▶│◀back▶│       a line; a frame likewise, in lines
 *      0                      visible  sync_start  sync_end  total
 *
 * Models:     VESA DMT modes from a table; any other size and rate as libxcvt computes CVT; a TV-like
 *             525/60i mode. Interlaced: vertical figures are lines of the whole frame; total is odd,
 *             so that the second field begins in the middle of a line. Half of the front porch, of sync and
 *             of the back porch less half a line are then what the second field has, in its own lines;
 *             the first has half a line more before its sync pulse (raster/head.h).
 * Units:      dots, lines, Hz.
 * Sources:    VESA Display Monitor Timing Standard 1.0 rev. 13; VESA CVT by libxcvt; for 525/60i see
 *             mode_table.c.
 * Ownership:  plain values.
 * Errors:     one sentence, with the figures.
 * Not modelled: tolerance of sync pulses and polarities; a monitor takes any.
 */
#ifndef RASTER_MODE_H
#define RASTER_MODE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "crt/error.h"
#include "crt/ticks.h"
#include "crt/tube_table.h"

#define RAS_MAX_DOTS 4096 /* visible, of a line */

struct ras_span {
    uint32_t visible, sync_start, sync_end, total;
};

struct ras_timing {
    struct crt_rate clock; /* dots a second */
    struct ras_span h, v;
    bool interlaced, h_plus, v_plus; /* polarity of sync pulses */
};

struct ras_mode {
    const char *name; /* "1024x768@60" */
    const char *description;
    struct ras_timing timing;
    const char *source;
};

/* The table. */
const struct ras_mode *ras_modes(size_t *count);

/* "1024x768@60", "1024x768" (60 Hz), "640x480@59.94", "1024x768@60i" (fields a second), "525/60i": the
 * mode of that name, else the table's of that size and, rounded to as many places, that rate, else CVT.
 * ("1024x768@43i" has its name by frames.) False and a sentence for what cannot be. */
bool ras_mode_parse(const char *text, struct ras_timing *timing, struct crt_error *err);

/* Whether a timing makes sense at all: 8 … 4096 dots and 1 … 4096 lines visible, at most 16384 in all,
 * parts in order, sync not empty; interlaced: an odd number of lines, one of them after sync, an even
 * number of dots; dot clock 0.1 … 1000 MHz, at most 1000 fields a second. */
bool ras_timing_check(const struct ras_timing *timing, struct crt_error *err);

/* Rates as exact ratios. A field is a frame when not interlaced. */
struct crt_rate ras_line_rate(const struct ras_timing *timing);
struct crt_rate ras_field_rate(const struct ras_timing *timing);

/* Dots of a field; a whole number also when interlaced. */
uint64_t ras_field_dots(const struct ras_timing *timing);

/* For titles: the table's name, else like "1024x768@60", the rate of fields rounded. */
void ras_timing_name(const struct ras_timing *timing, char *text, size_t size);

/* What a monitor can follow. */
struct ras_monitor {
    double h_min_khz, h_max_khz, v_min_hz, v_max_hz, clock_max_mhz;
};
struct ras_monitor ras_monitor_of(const struct crt_tube_row *row);

/* False and a sentence with the figures, as in "1280x1024@75 needs 79.98 kHz and 75.02 Hz; COLOR15
 * follows 30 to 66 kHz and 50 to 90 Hz". `tube` is the monitor's name. */
bool ras_monitor_follows(const struct ras_monitor *monitor, const struct ras_timing *timing,
                         const char *tube, struct crt_error *err);

#endif
