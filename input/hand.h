/* hand.h — where a hand is: a straight line at constant speed, then rest.
 *
 * Time:       picoseconds since power-on.
 * Position:   millimetres, whichever the device's are (act.h).
 * Ownership:  plain value.
 * Errors:     none.
 * Not modelled: the way a real hand speeds up and slows down, tremor: a script can say that as moves.
 */
#ifndef INPUT_HAND_H
#define INPUT_HAND_H

#include <stdbool.h>
#include <stdint.h>

#include "crt/state.h"

struct inp_place {
    double x, y, z; /* mm */
};

struct inp_hand {
    bool there;      /* not away */
    uint64_t t0, t1; /* of the last move */
    struct inp_place from, to;
};

struct inp_place inp_hand_at(const struct inp_hand *hand, uint64_t t);
/* From t on it goes to `to` within `duration` (0: at once); one that was away is at once there. */
void inp_hand_move(struct inp_hand *hand, struct inp_place to, uint64_t t, uint64_t duration);
void inp_hand_away(struct inp_hand *hand);

/* Within an open section. Hostile when loaded: checked to be finite and within INP_FURTHEST, t0 <= t1. */
void inp_hand_state(struct inp_hand *hand, struct crt_state *s);

#endif
