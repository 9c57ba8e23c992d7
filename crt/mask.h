/* mask.h — shadow masks and aperture grilles: which beam lights which phosphor, and where.
 *
 *      delta: dots in triads          slot: stripes, bridges,       grille: stripes, two
 *      B   ·   B   ·   B              columns staggered             damper wires
 *        ·   ·   ·   ·                 ▌▐ ▌    ▌▐ ▌                 ▌▐ ▌▌▐ ▌▌▐ ▌
 *      R G B R G B R G                 R G B   ▌▐ ▌                 ▔▔▔▔▔▔▔▔▔▔▔ wire
 *                                      ▌▐ ▌    R G B                ▌▐ ▌▌▐ ▌▌▐ ▌
 *
 * Models:     what a beam lights is the picture of the holes of the mask. A beam that lands where it
 *             should lights the middle of phosphor of its own colour; the rest of that phosphor is the
 *             guard band. One that misses by more lights the neighbours, too, as far as its picture
 *             and their phosphor overlap.
 *             - Delta: holes on a hexagonal lattice, the nearest a pitch apart, in upright columns
 *               √3/2 of it apart; round; each with a triad of touching round dots that stands as the
 *               guns do (crt/optics.h).
 *             - Slot: upright stripes of a third of the pitch each; slots CRT_SLOT_PITCH pitches from
 *               one to the next, CRT_SLOT_BRIDGE of which is bridge; every other column is half a slot
 *               higher.
 *             - Grille: the same stripes; damper wires at a third and two thirds of the height throw
 *               shadows of CRT_DAMPER_MM.
 *             Holes are of the size that lets mask_transmission of the beam pass, on average over the
 *             addressable area.
 * Units:      mm from the centre of the screen, x right, y up; shares of an area.
 * Source:     hexagonal and stripe geometry are elementary; pitch and transmission from the tube row.
 * Ownership:  plain values.
 * Errors:     none; the row must have a mask and have passed crt_tube_check.
 * Determinism: only + − × ÷ √; every cell by itself, so the same samples for any number of threads.
 * Not modelled: rounded ends of slots, the crossing of the beams at the mask (it would turn the
 *             triads by half a turn), electrons scattered by the mask. Light of a foreign phosphor
 *             fades as that of the gun's own.
 */
#ifndef CRT_MASK_H
#define CRT_MASK_H

#include "crt/optics.h"
#include "crt/pool.h"
#include "crt/tube.h"

#define CRT_SLOT_PITCH  1.8  /* estimate: slots are some 0.7 mm long in stripes of 0.4 mm */
#define CRT_SLOT_BRIDGE 0.15 /* estimate: bridges of about 0.1 mm */
#define CRT_DAMPER_MM   0.03 /* estimate: wires of 15 to 20 um and their half-shadow */

struct crt_mask {
    enum crt_mask_kind kind;
    double pitch, transmission;
    double hole;               /* what a beam lights: radius of a disc, or width of a stripe */
    double dot;                /* phosphor: radius of a dot, or width of a stripe */
    double slot_pitch, slot;   /* slots: from one to the next, and length of what is lit */
    double wire_y, wire;       /* grille: shadows at ±wire_y, and their width */
    double way_x[3], way_y[3]; /* from a hole to the phosphor of each colour */
    struct crt_optics optics;
};

void crt_mask_init(struct crt_mask *mask, const struct crt_tube_row *row);

/* The largest mask_transmission at which beams do not overlap on the phosphor. */
double crt_mask_most_transmission(enum crt_mask_kind kind);

/* The guard band: how far a beam may miss before another colour lights up. */
double crt_mask_guard(const struct crt_mask *mask);

/* The share of a square of side cell_mm about (x, y) in which `gun` lights phosphor of `colour`, to
 * 1e-4. */
double crt_mask_cover(const struct crt_mask *mask, int gun, int colour, double x_mm, double y_mm,
                      double cell_mm);

/* The same on average over the pattern (without damper wires), with the landing of (x, y). */
double crt_mask_mean(const struct crt_mask *mask, int gun, int colour, double x_mm, double y_mm);

/* Turns the light of guns on a complete film into that of phosphor colours. With `microscope` the
 * pattern is drawn, cell by cell, and the light stays the same on average; else each place gets the
 * mean of its pattern, which changes nothing while beams miss by less than the guard band. A foreign
 * phosphor gives the light it would give for the same current: per gun light in proportion to the
 * colours' shares of white (the sums of the phosphor's terms). */
void crt_mask_film(const struct crt_mask *mask, const struct crt_phosphor *phosphor,
                   struct crt_film *film, bool microscope, struct crt_pool *pool);

/* The same for a tube's film, when the tube has a mask. */
void crt_mask_complete(const struct crt_tube_desc *desc, struct crt_film *film,
                       struct crt_pool *pool);

#endif
