/* touch.h — a touch panel before a screen: optical, sonic, electrical.
 *
 *      finger at x, y ─▶ broken beams | echoes | plates pressed together ─▶ position ─▶ report
 *           (mm)         touch_optical.c  touch_sonic.c  touch_electrical.c
 *
 * Models:     scans one after the other; a finger of a certain width; what each kind gets wrong; a report
 *             when a finger has come, gone or changed its position since the last scan.
 * Time:       picoseconds since power-on; scan n ends at crt_tick_time(rate, n) after it was switched on.
 * Position:   finger: millimetres from the middle of the screen, y up; positions of the panel from its
 *             lower left (input_regs.h).
 * Ownership:  the caller owns the struct; the setup must outlive it. Allocates nothing.
 * Errors:     a finger beside the panel is not seen; guest trouble is a bit of the status register.
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
    X(rate, "Hz", 40, 10, 200, "scans a second", "estimate")                                       \
    X(finger, "mm", 11, 3, 30, "width of the finger", "estimate")                                  \
    X(noise, "mm", 0.1, 0, 5, "of a measurement, root mean square (sonic, electrical)", "estimate")

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
    uint32_t x, y; /* halves of positions */
    uint32_t raw[TOUCH_RAW_WORDS];
};

struct inp_touch {
    struct inp_touch_desc desc;
    struct inp_hand hand; /* the finger; z is how hard it presses, newton: 0 is taken as 1 */
    uint32_t status, control;
    uint64_t origin, scans; /* since it was switched on */
    uint32_t serial;
    struct inp_touch_report report;
};

void inp_touch_init(struct inp_touch *touch, const struct inp_touch_desc *desc);
void inp_touch_reset(struct inp_touch *touch, uint64_t t);
void inp_touch_act(struct inp_touch *touch, const struct inp_act *act, uint64_t t);
uint64_t inp_touch_next(const struct inp_touch *touch);
bool inp_touch_event(struct inp_touch *touch, uint64_t t); /* true: a report was made */
bool inp_touch_read(const struct inp_touch *touch, uint32_t offset, uint32_t *value);
bool inp_touch_write(struct inp_touch *touch, uint32_t offset, uint32_t value, uint64_t t);
bool inp_touch_ready(const struct inp_touch *touch);

/* A snapshot's section "TOUC". */
void inp_touch_state(struct inp_touch *touch, struct crt_state *s);

#endif
