/* vecgen.h — the vector generator: vectors, dashes, beam-off moves.
 *
 *      set-up (dark) ─▶ lit at rest ─▶ from unit to unit at constant speed ─▶ lit at rest
 *
 *      k = 0   1       2               units
 *      ├───┼───────┼───────┼─ … ─┼───────┼───┤     unit k is lit from k−½ to k+½,
 *                                                  the end points for half of that and
 *                                                  while it rests
 *
 * Models:     constant-speed vectors (time per unit of the longer axis), the line-type counter, the
 *             pen's cut in mid-vector and what RESUME draws of it, settling after beam-off moves.
 * Rest:       the beam is on a little before it moves and a little after (vector_rest, within the
 *             set-up), so end points are brighter than the line. A line type that is dark there stays dark.
 * Line types: a counter set to 37 (octal) at each vector goes down by one per unit; long dash =
 *             bit 4, short dash = bit 3, dot-dash = bits 2 and 1 without bit 3, or not bit 4.
 * Off screen: a vector with an end off screen draws nothing and takes its time (assumed: the manual
 *             says what is seen, not how).
 * Time:       picoseconds.  Position: head units.
 * Pen latch:  the unit of the longer axis nearest to the beam; the other coordinate is that of the
 *             line there, to the nearest unit, halves away from the start.
 * Ownership:  works on the caller's struct df_dpu, allocates nothing.
 * Errors:     none: every vector has a meaning.
 * Source:     DEC EK-VT11-TM-001; the times are those of the tube's row.
 * Not modelled: slew limits, overshoot of the analog generator.
 */
#ifndef DF_VECGEN_H
#define DF_VECGEN_H

#include "display_file/dpu.h"

/* Draws (on) or moves by (dx, dy); null vectors take no time. */
void df_vecgen_vector(struct df_dpu *dpu, bool on, int32_t dx, int32_t dy);

/* Draws what the pen left of dpu->vector from dpu->clock on, with hits disabled. */
void df_vecgen_resume(struct df_dpu *dpu);

/* Settling after a beam-off move of that many units along the longer axis, ps. */
uint64_t df_vecgen_settle_ps(const struct df_timing *timing, uint32_t units);

/* Units of the longer axis from (x0, y0) to (x1, y1). */
uint32_t df_vecgen_units(int32_t x0, int32_t y0, int32_t x1, int32_t y1);

/* Which of the 32 units of a period are lit: bit k is unit k from the start. */
extern const uint32_t df_line_patterns[4];

#endif
