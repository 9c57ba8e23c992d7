/* touch.h — a touch panel before a screen: optical, sonic, electrical.
 *
 *      finger at x, y ─▶ broken beams | echoes | plates pressed together ─▶ position ─▶ report
 *           (mm)         touch_optical.c  touch_sonic.c  touch_electrical.c
 *
 * Models:     scans one after the other, each of so many samples, evenly spaced, the last at its end; a sample sees
 *             the finger where it is then. A report when a finger has come, gone or changed its position since
 *             the last scan, or is sure where it was not. Positions are whole micrometres apart and cover
 *             the area: LEFT + PITCH_X · X / 2 is exactly where the panel has them.
 *             optical: a sample a beam, across and then up. A finger so wide breaks the beams between its
 *             edges; one thinner than their distance may break none and is not seen. On the one broken,
 *             or between the outermost; unsure when they are not neighbours: it moved within the scan.
 *             sonic: a burst across at half the scan, one up at its end; the time of the echo by a clock's
 *             ticks. Echoes weaken with distance: unsure, and the noisier, below `hear`; not heard 6 dB
 *             below that. Raw words: two times.
 *             electrical: a voltage across at half the scan, one up at its end. No contact below `force`;
 *             the load of the measurement draws the voltage down, more at a light press: unsure when by
 *             more than half a position.
 * Time:       picoseconds since power-on; scan n ends at crt_tick_time(rate, n) after it was switched on.
 *             Scans that inp_touch_event() was not called for are passed over.
 * Position:   finger: millimetres from the middle of the screen, y up; positions of the panel from its
 *             lower left (input_regs.h).
 * Ownership:  the caller owns the struct; the setup must outlive it. Allocates nothing.
 * Errors:     a finger beside the panel is not seen; guest trouble is a bit of the status register.
 * Not modelled: two fingers; light from the room that blinds detectors; what the finger does while an echo
 *             travels; the hollow in which plates touch.
 */
#ifndef INPUT_TOUCH_H
#define INPUT_TOUCH_H

#include <stdbool.h>
#include <stdint.h>

#include "crt/state.h"
#include "crt/ticks.h"
#include "crt/tube_table.h"
#include "input/act.h"
#include "input/hand.h"
#include "input/input_regs.h"

/* X(field, unit, value, low, high, meaning, source) */
#define INP_TOUCH_FIGURES(X)                                                                       \
    X(columns, "1", 50, 10, 50, "beams across (optical)", "10 to 50 positions are usual")          \
    X(rows, "1", 50, 10, 50, "beams up (optical)", "as columns")                                   \
    X(steps, "1", 500, 100, 1000, "positions across and up (sonic, electrical)", "about 500")      \
    X(rate, "Hz", 40, 10, 200, "scans a second", "estimate: follows a finger within a picture")    \
    X(finger, "mm", 11, 3, 30, "width of the finger (optical)", "estimate: tip of a forefinger")   \
    X(noise, "mm", 0.1, 0, 5, "of a measurement, root mean square (sonic, electrical)",            \
      "estimate: below a position")                                                                \
    X(velocity, "m/s", 3100, 2000, 6000, "of surface waves in the glass (sonic)",                  \
      "estimate: Rayleigh waves go at 0.92 of the 3.4 km/s of shear waves in soda-lime glass")     \
    X(timer, "MHz", 20, 1, 100, "clock that measures the echo (sonic)",                            \
      "estimate: 0.08 mm a tick, well below a position")                                           \
    X(loss, "dB/m", 30, 0, 100, "by which the waves weaken on their way (sonic)",                  \
      "estimate: half the 0.6 dB/cm at 5.53 MHz of good glass (US patent 6236391), at a lower "    \
      "frequency")                                                                                 \
    X(hear, "dB", 30, 6, 60, "weaker than at the near edge by this, echoes are unsure (sonic)",    \
      "estimate: above the receiver's noise")                                                      \
    X(force, "N", 0.3, 0.01, 5, "at which the plates touch (electrical)",                          \
      "estimate: a light press; spacers hold the plates apart")                                    \
    X(sheet, "ohm", 400, 50, 2000, "of the resistive plate from edge to edge (electrical)",        \
      "estimate: tin oxide, some hundred ohms a square")                                           \
    X(contact, "ohm", 500, 1, 1e5, "of the contact at 1 N; inversely as the force (electrical)",   \
      "estimate: films pressed together")                                                          \
    X(input, "ohm", 1e6, 1e5, 1e9, "load of what measures the voltage (electrical)",               \
      "estimate: a junction field-effect amplifier with its bias resistor")

struct inp_touch_setup {
    unsigned kind;   /* TOUCH_NONE … TOUCH_ELECTRICAL */
    unsigned screen; /* enum inp_screen: the head it lies over */
#define X(field, unit, value, low, high, meaning, source) struct crt_figure field;
    INP_TOUCH_FIGURES(X)
#undef X
};

struct inp_touch_desc {
    const struct inp_touch_setup *setup;
    double width_mm, height_mm; /* addressable area of that head, which the panel covers */
    uint64_t seed;
};

/* What one scan finds. */
struct inp_touch_report {
    bool touched, unsure;
    uint32_t x, y; /* halves of positions; when not touched the last ones found */
    uint32_t raw[TOUCH_RAW_WORDS];
};

/* What has been found on one axis. */
struct inp_touch_found {
    bool found, unsure;
    uint32_t at; /* halves of positions */
};

/* The scan under way: so many of its samples have been taken, beams or bursts or voltages. */
struct inp_touch_scan {
    unsigned sampled;
    uint32_t raw[TOUCH_RAW_WORDS];
    struct inp_touch_found axis[2];
};

struct inp_touch {
    struct inp_touch_desc desc;
    struct inp_hand hand; /* the finger; z is how hard it presses, newton: 0 is taken as 1 */
    uint32_t status, control;
    uint64_t origin, scans;         /* since it was switched on */
    uint32_t serial;                /* of `report` */
    uint32_t made;                  /* reports since power-on, lost ones included, modulo 2^32 */
    struct inp_touch_report report; /* for the program */
    struct inp_touch_report last;   /* what the last scan found */
    struct inp_touch_scan scan;
};

void inp_touch_init(struct inp_touch *touch, const struct inp_touch_desc *desc);
void inp_touch_reset(struct inp_touch *touch, uint64_t t);
void inp_touch_act(struct inp_touch *touch, const struct inp_act *act, uint64_t t);
uint64_t inp_touch_next(const struct inp_touch *touch);
bool inp_touch_event(struct inp_touch *touch, uint64_t t); /* true: a report was made or lost */
bool inp_touch_read(const struct inp_touch *touch, uint32_t offset, uint32_t *value);
bool inp_touch_write(struct inp_touch *touch, uint32_t offset, uint32_t value, uint64_t t);
bool inp_touch_ready(const struct inp_touch *touch);

/* A snapshot's section "TOUC". */
void inp_touch_state(struct inp_touch *touch, struct crt_state *s);

#endif
