/* beam.h — lights stretches of beam: offers them to the pen, cuts them at a hit, commits them.
 *
 *      stretch ─▶ offer ─▶ no hit ─▶ commit
 *                   └─▶ hit at t ─▶ commit up to t ─▶ latch, intensify spot ─▶ (rest, if any)
 *
 * Models:     the hit flag and position latch; the spot of level 7 that pen intensify adds at
 *             a hit.
 * Time:       picoseconds.  Position: head units, fractional.
 * Ownership:  works on the caller's struct df_dpu, allocates nothing.
 * Errors:     none. Stretches of no duration are dropped. A firing time outside the stroke counts
 *             as none when late and as the stroke's start when early.
 * Source:     DEC EK-VT11-TM-001; one hit per vector, point or character is assumed.
 * Not modelled: the pen itself: its aperture, band and threshold are the caller's.
 */
#ifndef DF_BEAM_H
#define DF_BEAM_H

#include "display_file/dpu.h"

struct df_stretch {
    uint64_t t0, t1;       /* ps */
    double x0, y0, x1, y1; /* head units */
};

/* Lights the stretch at the current intensity. Returns true when the pen fired and `hits` allows
 * it: then only the part before *when was lit, and the caller goes on with df_beam_hit(). */
bool df_beam_light(struct df_dpu *dpu, const struct df_stretch *s, bool hits, uint64_t *when);

/* Sets the hit flag, latches head units (x, y) and lights the intensify spot at (ux, uy). Returns
 * the time at which the beam is free again. */
uint64_t df_beam_hit(struct df_dpu *dpu, int32_t x, int32_t y, double ux, double uy, uint64_t when);

/* Lights a resting beam at (ux, uy), whole even when hit; (x, y) is what a hit latches. Returns the
 * ps that the intensify spot took; *hits becomes false at a hit. */
uint64_t df_beam_dot(struct df_dpu *dpu, int32_t x, int32_t y, double ux, double uy, uint64_t t0,
                     uint64_t t1, bool *hits);

#endif
