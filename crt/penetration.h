/* penetration.h — beam-penetration colour: what the beam voltage does to light, spot and place.
 *
 *      gun ──▶ ░░ red layer ░░▒▒ green layer ▒▒ glass ──▶ viewer
 *              6 kV: stops in the first layer … 12 kV: spends its energy in the second
 *
 * Models:     beam voltage V of a colour, V0 = kv_dead, current I:
 *             - energy turned into radiation: I·((V − V0)/(kv_green − V0))^kv_exponent, in parts of
 *               what a green stroke of full current gives;
 *             - of that the second layer (green) has the share smoothstep(kv_red, kv_green, V), the
 *               first (red) the rest;
 *             - luminance: radiation of layer c is worth its colour's share of the luminous energy in
 *               the phosphor row, which says what both layers give for the same energy. In parts of
 *               the green layer's: light[c] = energy · share_c · w_c/w_green. So line_luminance of the
 *               row is that of a green line, and the other colours are dimmer;
 *             - spot: sigma·sqrt(kv_green/V). Thermal velocities bound the current density of a
 *               focused spot by a multiple of V, so that at a given current its area goes with 1/V;
 *             - place: magnetic deflection goes with 1/sqrt(V); the gain is corrected, and of the
 *               error colour_register is left: positions are multiplied by
 *               1 + colour_register·(sqrt(kv_green/V) − 1).
 * Units:      kV; light and sigma in parts of a green stroke's.
 * Source:     two layers and four voltages: J. D. Foley, A. van Dam, Fundamentals of Interactive
 *             Computer Graphics, 1982, ch. 3 (principle); power law: usual for cathodoluminescence,
 *             with 1.5 to 2 as its exponent; smoothstep: estimate; spot: D. B. Langmuir, Theoretical
 *             limitations of cathode-ray tubes, Proc. IRE 25, 1937; figures: the tube row.
 * Ownership:  plain values.
 * Errors:     crt_penetration_fits: one sentence; figures must have passed crt_tube_check.
 * Not modelled: light while the voltage changes (the beam is off), a change of beam current with the
 *             voltage, focus that does not follow it, the barrier between the layers.
 */
#ifndef CRT_PENETRATION_H
#define CRT_PENETRATION_H

#include "crt/phosphor.h"
#include "crt/piece.h"
#include "crt/tube_table.h"

#define CRT_LEVELS (CRT_LEVEL_GREEN + 1)

/* What a tube multiplies light, sigma and positions of a stroke by. */
struct crt_voltage {
    double light[CRT_MAX_COLOURS]; /* per colour of the phosphor: 0 is the red layer, 1 the green */
    double sigma, place;
};

/* All ones for a tube that is no penetration tube; CRT_LEVEL_ONLY is as CRT_LEVEL_GREEN. */
struct crt_voltage crt_voltage_at(const struct crt_tube_row *row,
                                  const struct crt_phosphor *phosphor, enum crt_level level);

/* A penetration tube needs a phosphor with the colours of its two layers; others take any. */
bool crt_penetration_fits(const struct crt_tube_row *row, const struct crt_phosphor *phosphor,
                          struct crt_error *err);

/* "red", "orange", "yellow", "green"; "only" for CRT_LEVEL_ONLY. */
const char *crt_level_name(enum crt_level level);
/* The level of that name; CRT_LEVEL_ONLY when it names none of the four. */
enum crt_level crt_level_named(const char *name);

#endif
