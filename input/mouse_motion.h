/* mouse_motion.h — where detectors change and how many counts get through; private to the mouse.
 *
 * Models:     one axis within one straight move; closed form, so that long and fast moves cost what short
 *             and slow ones do.
 * Units:      pm, ps, counts. Whole numbers: exact, the same everywhere.
 */
#ifndef INPUT_MOUSE_MOTION_H
#define INPUT_MOUSE_MOTION_H

#include "input/mouse.h"

/* A straight move, or the part of it that is left. */
struct inp_mouse_move {
    uint64_t t0, t1;
};

/* Of the kind's wheel or pad. */
struct inp_mouse_pitch {
    int64_t quarter; /* of a slot or of a line's distance, pm */
    int64_t cell;    /* from count to count, pm */
    uint64_t rate;   /* counts that the counters follow, in 1000 s */
};

struct inp_mouse_pitch inp_mouse_pitch(const struct inp_mouse_setup *setup);

/* How far the hand has gone at t, pm, rounded down. */
int64_t inp_mouse_gone(const struct inp_mouse_axis *axis, struct inp_mouse_move move, uint64_t t);
/* Counts that it has crossed at t, and those of them that the counter has taken. */
uint64_t inp_mouse_crossed(const struct inp_mouse_axis *axis, struct inp_mouse_move move,
                           struct inp_mouse_pitch pitch, uint64_t t);
uint64_t inp_mouse_taken(const struct inp_mouse_axis *axis, struct inp_mouse_move move,
                         struct inp_mouse_pitch pitch, uint64_t t);
/* When the count after axis->done comes, whether the move goes on so long or not. */
uint64_t inp_mouse_due(const struct inp_mouse_axis *axis, struct inp_mouse_move move,
                       struct inp_mouse_pitch pitch);
/* When the counter is through with so many counts of the move, which rests at t: at most one count later. */
uint64_t inp_mouse_through(const struct inp_mouse_axis *axis, struct inp_mouse_pitch pitch,
                           uint64_t counts, uint64_t t);
/* Numbers from 0 in the period: quarter of a slot, of a line. */
unsigned inp_mouse_quarter(int64_t place, struct inp_mouse_pitch pitch);
/* The same place in the first period. */
int64_t inp_mouse_wrapped(int64_t place, struct inp_mouse_pitch pitch);

#endif
