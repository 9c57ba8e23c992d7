/* mouse.h — a mouse: relative counts and buttons.
 *
 *      hand moves dx, dy ─▶ toothed wheels, two detectors each | lines of a pad crossed ─▶ counts
 *
 * Models:     mechanical: a roller turns two slotted wheels, each between a light and two detectors a quarter
 *             of a slot apart; each change of light is a count, its direction by which detector leads.
 *             optical: dark lines of a pad, as wide as the light between them; a count when the first
 *             detector comes off a line onto light, or back, the second being dark: one a line crossed.
 *             Lifted, it moves without counting: the roller stands still; the pad is out of sight.
 * Overrun:    the counters follow `fastest` counts a second on each axis, evenly. A straight move slower
 *             than that loses nothing. Of a faster one, count k comes when the hand has crossed so many
 *             and not before free + (k - 1) / fastest, `free` being when the move began, or when the counts
 *             before it were through if that is later; what has not come when the move ends is missing,
 *             and MOUSE_OVERRUN is set then. Whole counts are missing: the detectors' light still fits.
 *             A move of duration 0 is what a window tells of afterwards: it counts as having taken the time
 *             since the counts before it were through, at most INP_MOUSE_WHILE, and its counts are
 *             there at once. So 60 moves a second lose nothing below `fastest` all in all.
 * Moves:      one begins where the hand has come to; what was left of the one before is not made.
 * Time:       picoseconds since power-on. Counts come when the hand crosses them, to the picosecond.
 * Units:      places in whole picometres, so that sums of moves never drift.
 * Ownership:  the caller owns the struct; the setup must outlive it. Allocates nothing.
 * Errors:     none; guest trouble is a bit of the status register.
 * Not modelled: a roller that slips; turning the mouse, which turns its axes.
 */
#ifndef INPUT_MOUSE_H
#define INPUT_MOUSE_H

#include <stdbool.h>
#include <stdint.h>

#include "crt/state.h"
#include "crt/ticks.h"
#include "crt/tube_table.h"
#include "input/act.h"
#include "input/input_regs.h"

/* X(field, unit, value, low, high, meaning, source) */
#define INP_MOUSE_FIGURES(X)                                                                       \
    X(slot, "mm", 1, 0.05, 10, "way of the hand for one slot, four counts (mechanical)",           \
      "estimate: 100 counts an inch")                                                              \
    X(line, "mm", 0.5, 0.05, 10, "from line to line of the pad (optical)",                         \
      "estimate: 50 lines an inch")                                                                \
    X(fastest, "1/s", 4000, 100, 1e6, "counts a second that the counters follow",                  \
      "estimate: a metre a second at 100 counts an inch")

struct inp_mouse_setup {
    unsigned kind; /* MOUSE_NONE … MOUSE_OPTICAL */
#define X(field, unit, value, low, high, meaning, source) struct crt_figure field;
    INP_MOUSE_FIGURES(X)
#undef X
};

struct inp_mouse_desc {
    const struct inp_mouse_setup *setup;
};

/* So long before it a move of duration 0 has begun at most, ps. */
#define INP_MOUSE_WHILE (50 * CRT_PS_PER_MS)

/* One axis: x, y. Within a move, the hand has gone way · (t - t0) / (t1 - t0) from `from`. */
struct inp_mouse_axis {
    int64_t from;   /* pm, from a slot's or a line's beginning; 0 … one period */
    int64_t way;    /* pm */
    uint64_t done;  /* counts of this move that have come */
    uint64_t free;  /* when the counter can take the first count of this move */
    uint32_t count; /* modulo 2^32 */
};

struct inp_mouse {
    struct inp_mouse_desc desc;
    unsigned buttons;
    uint32_t status;
    /* Private: see mouse.c. */
    bool lifted, moving;
    uint64_t t0, t1; /* of the last move */
    struct inp_mouse_axis axis[2];
};

void inp_mouse_init(struct inp_mouse *mouse, const struct inp_mouse_desc *desc);
void inp_mouse_reset(struct inp_mouse *mouse, uint64_t t);
void inp_mouse_act(struct inp_mouse *mouse, const struct inp_act *act, uint64_t t);
/* When MOVED is next set by a count (while it stands, counts need no event: reads tell them at their time), or
 * the move under way ends; UINT64_MAX: neither comes. */
uint64_t inp_mouse_next(const struct inp_mouse *mouse);
bool inp_mouse_event(struct inp_mouse *mouse, uint64_t t); /* true: something changed */
bool inp_mouse_read(const struct inp_mouse *mouse, uint32_t offset, uint64_t t, uint32_t *value);
bool inp_mouse_write(struct inp_mouse *mouse, uint32_t offset, uint32_t value, uint64_t t);
bool inp_mouse_ready(const struct inp_mouse *mouse);

/* A snapshot's section "MOUS". */
void inp_mouse_state(struct inp_mouse *mouse, struct crt_state *s);

#endif
