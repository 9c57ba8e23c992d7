/* undo.h — the history of a drawing: steps that can be taken back and done again.
 *
 *      undo_begin ─ changes … ─ undo_commit        step k:  slot, what it held on the other side
 *                            └─ undo_cancel        back, again: slot and record exchange contents
 *
 *      … [k-2][k-1] │ [k][k+1] …                   │: now; a new step forgets those after it
 *
 * Models:     a log of reversible changes. Within a step a slot is kept once, however often it
 *             changes; a slot that ends as it was is no change, a step without changes no step.
 * Domain:     the last UNDO_STEPS steps; fewer when they are large, never below UNDO_LEAST.
 * Ownership:  the drawing must outlive it, and tells it of its changes while it is attached.
 * Errors:     none; changes outside begin and commit are not in the history.
 */
#ifndef ROMS_SKETCH_UNDO_H
#define ROMS_SKETCH_UNDO_H

#include "roms/sketch/drawing.h"

enum {
    UNDO_SLOTS = DRAWING_POINTS + DRAWING_FIGURES + DRAWING_MASTERS + 1,
    UNDO_LEAST = 64,
    UNDO_CHANGES = (UNDO_LEAST + 1) * UNDO_SLOTS,
    UNDO_STEPS = 512
};

struct undo_change {
    uint16_t table, index;
    union {
        struct drawing_point point;
        struct figure figure;
        struct master master;
    } held;
};

struct undo {
    struct drawing *drawing;
    bool open;
    /* Of the step that is open: what slots held before it; which have been kept. */
    struct undo_change before[UNDO_SLOTS];
    int count;
    bool kept[UNDO_SLOTS];
    /* Numbers that only grow; places in the rings are their remainders. */
    uint32_t first, now, last; /* steps: kept, done, known */
    uint32_t end[UNDO_STEPS];  /* of step k, which begins where k - 1 ends */
    struct undo_change change[UNDO_CHANGES];
    bool turning; /* changes are its own */
};

void undo_attach(struct undo *u, struct drawing *drawing);
void undo_begin(struct undo *u);
/* True when there is a step more. */
bool undo_commit(struct undo *u);
/* The drawing is as at undo_begin. */
void undo_cancel(struct undo *u);
/* One step back, one step on; false: there is none. Not within a step. */
bool undo_back(struct undo *u);
bool undo_again(struct undo *u);
/* Steps that can be taken back. */
unsigned undo_depth(const struct undo *u);

#endif
