/* constraint.h — points are moved, and what is kept horizontal or vertical stays so.
 *
 *      ●──────● kept horizontal: one y for both      ●───●───●  one y for all that such lines join;
 *      ▲ moved up: the other end follows                          the same with x for vertical lines
 *
 * Models:     a move gives some points places; a y goes along horizontal lines, an x along vertical
 *             ones, as far as they reach. Such constraints can always be kept together.
 * Units:      as in drawing.h.
 * Ownership:  changes the drawing.
 * Errors:     a status; what fails changes nothing.
 * Source:     the simplest case of Sutherland's propagation of degrees of freedom (Sketchpad, 1963).
 */
#ifndef ROMS_SKETCH_CONSTRAINT_H
#define ROMS_SKETCH_CONSTRAINT_H

#include "roms/sketch/drawing.h"

struct constraint_move {
    bool moved[DRAWING_POINTS];
    struct place to[DRAWING_POINTS];
    bool x_given[DRAWING_POINTS], y_given[DRAWING_POINTS]; /* private */
};

void constraint_begin(struct constraint_move *move);
void constraint_to(struct constraint_move *move, int point, struct place to);
/* Moves them, and what hangs on them. */
enum drawing_status constraint_apply(struct drawing *d, struct constraint_move *move);
/* Keeps a line so from now on, or no longer: its second end goes where the first one says. */
enum drawing_status constraint_set(struct drawing *d, int line, enum constraint constraint,
                                   struct constraint_move *scratch);

#endif
