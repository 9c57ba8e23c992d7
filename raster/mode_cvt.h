/* mode_cvt.h — timings by formula: VESA CVT with normal blanking, as libxcvt computes it.
 *
 * Models:     CVT without margins, negative horizontal and positive vertical sync. libxcvt works in
 *             floats, which IEEE 754 makes the same everywhere but where the library was built with
 *             fused multiply-add; its results are whole dots, lines and quarters of a megahertz.
 * Interlaced: libxcvt gives the porch before vertical sync and the pulse in lines of a field, where
 *             all else is in lines of the frame, drops the half line of a field from the total, and
 *             forgets the polarities. All this is put right.
 * Sync:       libxcvt makes the horizontal pulse a cell too short where 8 % of the line is a whole number
 *             of cells, and takes 15:9 for an aspect ratio CVT knows only at heights that are multiples
 *             of 9 (10 lines of vertical sync instead of 7). Both are put right; the lines go to the
 *             back porch.
 * Units:      dots, lines; fields a second.
 * Ownership:  plain values.
 * Errors:     one sentence for what CVT cannot do: widths that are no multiple of its cell of 8 dots,
 *             odd heights interlaced.
 */
#ifndef RASTER_MODE_CVT_H
#define RASTER_MODE_CVT_H

#include "raster/mode.h"

/* width and height within 8 … 4096 and 1 … 4096, rate within 1 … 1000. What comes out still needs
 * ras_timing_check(). */
bool ras_cvt(uint32_t width, uint32_t height, double fields_hz, bool interlaced,
             struct ras_timing *timing, struct crt_error *err);

#endif
