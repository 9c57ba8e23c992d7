/* select.h — figures that were chosen: by pointing, and by a box.
 *
 * Models:     a set of figures of one picture.
 * Ownership:  plain value.
 * Errors:     none; figures that are gone are no longer selected.
 * Source:     elementary.
 */
#ifndef ROMS_SKETCH_SELECT_H
#define ROMS_SKETCH_SELECT_H

#include "roms/sketch/drawing.h"

struct selection {
    bool figure[DRAWING_FIGURES];
    int count;
};

void select_none(struct selection *s);
void select_turn(struct selection *s, int figure); /* in, or out again */
/* Those that lie in the box with all that they show are added; how many. */
int select_box(struct selection *s, const struct drawing_state *state, int picture, struct place a,
               struct place b);
/* What is gone, or in another picture, is selected no longer. */
void select_check(struct selection *s, const struct drawing_state *state, int picture);

#endif
