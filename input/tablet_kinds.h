/* tablet_kinds.h — how each kind of tablet finds the stylus: private to tablet*.c.
 *
 *      true place ─▶ what wires, microphones, edges receive, + noise ─▶ what the tablet makes of it
 *
 * Models:     one measurement at one instant.
 * Position:   millimetres from the lower left corner, z >= 0 up from the surface.
 * Ownership:  plain values.
 * Errors:     false: nothing was measured, *got is then of no use.
 */
#ifndef INPUT_TABLET_KINDS_H
#define INPUT_TABLET_KINDS_H

#include "input/tablet.h"

/* Where a measurement takes its random numbers from: a function of the seed and the time. */
struct tablet_noise {
    uint64_t seed, count;
};

/* Normal, standard deviation 1. At most TABLET_DEVIATES in one measurement. */
double tablet_noise_next(struct tablet_noise *noise);
#define TABLET_DEVIATES 32

/* What the tablet computes. */
struct tablet_measure {
    struct inp_place place;
    bool touches; /* by its signals alone */
    uint32_t raw[TABLET_RAW_WORDS];
};

bool tablet_electrical(const struct inp_tablet_setup *setup, struct inp_place stylus,
                       struct tablet_noise *noise, struct tablet_measure *got);
bool tablet_sonic(const struct inp_tablet_setup *setup, struct inp_place stylus,
                  struct tablet_noise *noise, struct tablet_measure *got);
bool tablet_resistive(const struct inp_tablet_setup *setup, struct inp_place stylus,
                      struct tablet_noise *noise, struct tablet_measure *got);

/* Width and height as a resistive tablet measures them: along its sheet, mm. */
struct inp_place tablet_sheet(const struct inp_tablet_setup *setup);

#endif
