/* mouse.h — a mouse: relative counts and buttons.
 *
 *      hand moves dx, dy ─▶ toothed wheels, two detectors each | lines of a pad crossed ─▶ counts
 *
 * Models:     mechanical: a roller turns two slotted wheels, each between a light and two detectors a quarter
 *             of a slot apart; each change of light is a count, its direction by which detector leads.
 *             optical: dark lines of a pad crossed, each a count. Lifted, it moves without counting. Counters
 *             that follow at most so many counts a second on each axis: faster movement loses counts,
 *             which a status bit tells.
 * Time:       picoseconds since power-on. Counts come when the hand crosses them.
 * Ownership:  the caller owns the struct; the setup must outlive it. Allocates nothing.
 * Errors:     none; guest trouble is a bit of the status register.
 */
#ifndef INPUT_MOUSE_H
#define INPUT_MOUSE_H

#include <stdbool.h>
#include <stdint.h>

#include "crt/state.h"
#include "crt/tube_table.h"
#include "input/act.h"
#include "input/hand.h"
#include "input/input_regs.h"

/* X(field, unit, value, low, high, meaning, source) */
#define INP_MOUSE_FIGURES(X)                                                                       \
    X(slot, "mm", 1, 0.05, 10, "way of the hand for one slot, four counts (mechanical)",           \
      "estimate: 100 counts an inch")                                                              \
    X(line, "mm", 0.5, 0.05, 10, "from line to line of the pad (optical)", "estimate")             \
    X(fastest, "1/s", 4000, 100, 1e6, "counts a second that the counters follow", "estimate")

struct inp_mouse_setup {
    unsigned kind; /* MOUSE_NONE … MOUSE_OPTICAL */
#define X(field, unit, value, low, high, meaning, source) struct crt_figure field;
    INP_MOUSE_FIGURES(X)
#undef X
};

struct inp_mouse_desc {
    const struct inp_mouse_setup *setup;
};

struct inp_mouse {
    struct inp_mouse_desc desc;
    struct inp_hand hand; /* where it has come to on the pad; there: not lifted */
    unsigned buttons;
    uint32_t status;
    int64_t x, y; /* counted */
    /* Private: see mouse.c. */
    uint64_t counted; /* everything until then has been counted */
};

void inp_mouse_init(struct inp_mouse *mouse, const struct inp_mouse_desc *desc);
void inp_mouse_reset(struct inp_mouse *mouse, uint64_t t);
void inp_mouse_act(struct inp_mouse *mouse, const struct inp_act *act, uint64_t t);
/* When the next count is due; UINT64_MAX: none is. */
uint64_t inp_mouse_next(const struct inp_mouse *mouse);
bool inp_mouse_event(struct inp_mouse *mouse, uint64_t t); /* true: something changed */
bool inp_mouse_read(const struct inp_mouse *mouse, uint32_t offset, uint64_t t, uint32_t *value);
bool inp_mouse_write(struct inp_mouse *mouse, uint32_t offset, uint32_t value, uint64_t t);
bool inp_mouse_ready(const struct inp_mouse *mouse);

/* A snapshot's section "MOUS". */
void inp_mouse_state(struct inp_mouse *mouse, struct crt_state *s);

#endif
