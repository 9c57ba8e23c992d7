/* tablet.h — a digitising tablet: where a stylus or puck is, measured some 30 to 60 times a second.
 *
 *      stylus at x, y, z ─▶ grid of wires | spark and microphones | resistive sheet ─▶ counts ─▶ report
 *            (mm)            tablet_electrical.c  tablet_sonic.c    tablet_resistive.c
 *
 * Models:     one measurement a period, at that instant; resolution, noise and what each kind gets wrong:
 *             the electrical one interpolates between wires and is less sure the higher the stylus is; the
 *             sonic one takes the air to have the temperature it assumes; the resistive one's lines are
 *             bent a little. Proximity, tip switch or buttons, place for one report, and what is
 *             lost (input_regs.h).
 * Heights:    electrical: as far as `near`, less when the signal drowns in the noise; measured, Z. Sonic: as
 *             far as `reach`; measured, Z; no surface is needed. Resistive: as far as `near`; not
 *             measured, Z is 0.
 * Accuracy:   with the figures as listed, root mean square of x on the surface, 5 mm and 12 mm up: electrical
 *             0.03, 0.10, 0.37 mm (interpolation alone is off by 0.015 mm at most), sonic 0.03 mm everywhere,
 *             resistive 0.04, 0.09, 0.15 mm; z: electrical 0.02, 0.06, 0.17 mm, sonic 0.08 mm.
 * Touching:   the tip switch of a stylus, button 0, is closed while the person presses it (INP_PRESS 0) or
 *             its tip rests on the surface (z <= 0): both is TOUCH. A puck touches by lying on the surface,
 *             and its buttons are those pressed. The electrical tablet also takes a measured height up
 *             to the figure `touch` for touching. Below the surface is on it.
 * Edges:      electrical: as far as the wires, half a pitch or more beyond; sonic: as far as the sound
 *             arrives before the counter's end, 1.2 times the longest way on the tablet; resistive: the
 *             sheet ends at the edges. Beyond is far.
 * Time:       picoseconds since power-on; report n is measured at crt_tick_time(rate, n) after it was
 *             switched on. The rate is in thousandths of a report a second.
 * Position:   millimetres from the lower left corner, z up from the surface. A resistive tablet over a tube
 *             reports along its sheet, from the sheet's corner: the hand's x and y are those of the plane
 *             that touches the tube in the middle.
 * Ownership:  the caller owns the struct; the setup must outlive it. Allocates nothing.
 * Errors:     places off the surface are far; guest trouble is a bit of the status register.
 * Determinism: noise is a function of seed and time (input/noise.h).
 * Not modelled: the time that sound and computing take: a report is there at the instant it is of.
 */
#ifndef INPUT_TABLET_H
#define INPUT_TABLET_H

#include <stdbool.h>
#include <stdint.h>

#include "crt/state.h"
#include "crt/ticks.h"
#include "crt/tube_table.h"
#include "input/act.h"
#include "input/hand.h"
#include "input/input_regs.h"

/* X(field, unit, value, low, high, meaning, source) */
#define INP_TABLET_FIGURES(X)                                                                      \
    X(width, "mm", 280, 150, 1830, "across", "11 inches; 6 to 72 inches were made")                \
    X(height, "mm", 280, 150, 1830, "up", "11 inches; 6 to 72 inches were made")                   \
    X(resolution, "mm", 0.1, 0.01, 5, "of a count",                                                \
      "estimate: accuracy of tablets is below 0.2 mm")                                             \
    X(noise, "mm", 0.03, 0, 0.2,                                                                   \
      "of a measurement at the surface, root mean square (sonic: of a distance)",                  \
      "estimate: well below the accuracy of 0.2 mm")                                               \
    X(rate, "Hz", 60, 30, 60, "reports a second", "30 to 60 are usual")                            \
    X(near, "mm", 12.7, 1, 25, "height below which the stylus is near (not sonic)",                \
      "half an inch")                                                                              \
    X(buttons, "1", 1, 1, 4, "1: a stylus with its tip switch; more: a puck with so many",         \
      "the person's choice")                                                                       \
    X(pitch, "mm", 6.35, 6.35, 12.7, "from one wire to the next (electrical)",                     \
      "a quarter to half an inch are usual")                                                       \
    X(coil, "mm", 10, 8, 20, "from the wires to the coil of a stylus that touches (electrical)",   \
      "estimate: 4 mm of board above the wires, the coil 6 mm up the stylus")                      \
    X(touch, "mm", 0.5, 0.1, 1, "height below which it takes the stylus to touch (electrical)",    \
      "estimate: several times the noise of a height")                                             \
    X(temperature, "C", 20, -20, 50, "of the air (sonic)", "the room's")                           \
    X(assumed, "C", 20, -20, 50, "of the air, as the tablet takes it to be (sonic)",               \
      "estimate: room temperature")                                                                \
    X(post, "mm", 100, 50, 500, "height of microphones 1 and 2 (sonic)",                           \
      "estimate: out of the plane of the others, for heights")                                     \
    X(clock, "MHz", 10, 1, 50, "of the counter of travel times (sonic)",                           \
      "estimate: 0.034 mm of air a count")                                                         \
    X(reach, "mm", 300, 10, 1000, "height below which it is heard (sonic)",                        \
      "estimate: about the width of the tablet")                                                   \
    X(radius, "mm", 0, 0, 5000,                                                                    \
      "of curvature: it lies over a tube (resistive), never less than 0.55 of its diagonal; 0: "   \
      "flat",                                                                                      \
      "the person's choice")                                                                       \
    X(bow, "mm", 0.1, 0, 2, "by how much lines bend at most (resistive)",                          \
      "estimate: what remains of the other edges' conductors")

struct inp_tablet_setup {
    unsigned kind; /* TABLET_NONE … TABLET_RESISTIVE */
#define X(field, unit, value, low, high, meaning, source) struct crt_figure field;
    INP_TABLET_FIGURES(X)
#undef X
};

struct inp_tablet_desc {
    const struct inp_tablet_setup *setup;
    uint64_t seed;
};

/* What one measurement gives. */
struct inp_tablet_report {
    int32_t x, y, z; /* counts */
    unsigned proximity, buttons;
    uint32_t raw[TABLET_RAW_WORDS];
    uint32_t serial; /* its number: 1 is the first since power-on */
};

struct inp_tablet {
    struct inp_tablet_desc desc;
    struct inp_hand hand; /* away at power-on */
    unsigned buttons;     /* held */
    uint32_t status, control;
    uint64_t origin;                 /* when it was switched on */
    uint64_t measured;               /* measurements since then */
    uint32_t serial;                 /* reports made since power-on */
    bool sensed;                     /* the latest measurement since then found it */
    struct inp_tablet_report latest; /* the latest made, taken or lost */
    struct inp_tablet_report report; /* what the registers hold */
};

void inp_tablet_init(struct inp_tablet *tablet, const struct inp_tablet_desc *desc);
void inp_tablet_reset(struct inp_tablet *tablet, uint64_t t);

/* An act of INP_TABLET at t, in millimetres. A button beyond figure `buttons` is ignored; a hand that goes
 * away lets go of all. */
void inp_tablet_act(struct inp_tablet *tablet, const struct inp_act *act, uint64_t t);

/* When it next measures; UINT64_MAX: never. And what happens then: true, when a report was made, also
 * one that is lost. */
uint64_t inp_tablet_next(const struct inp_tablet *tablet);
bool inp_tablet_event(struct inp_tablet *tablet, uint64_t t);

/* INPUT_TABLET_… of input_regs.h at time t; false: there is none at that offset. */
bool inp_tablet_read(const struct inp_tablet *tablet, uint32_t offset, uint32_t *value);
bool inp_tablet_write(struct inp_tablet *tablet, uint32_t offset, uint32_t value, uint64_t t);
/* Its bit of INPUT_STATUS. */
bool inp_tablet_ready(const struct inp_tablet *tablet);

/* A snapshot's section "TABL". */
void inp_tablet_state(struct inp_tablet *tablet, struct crt_state *s);

#endif
