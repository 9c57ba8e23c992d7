/* operator.h — the person at the terminal, as the machine sees her: acts, each at its time.
 *
 *      --input SCRIPT ─▶ script ─┐
 *      window         ─▶ live  ──┴─▶ in order of time ─▶ devices
 *
 * Models:     two lists of acts (input/act.h), merged; at equal times the script's come first.
 * Time:       picoseconds since power-on.
 * State:      none of its own: what has been done by a time is what comes before it, and some or all
 *             of what comes at it. A machine taken back in time is acted upon the same again; a new live
 *             act makes those forgotten that came later.
 * Ownership:  vm_operator_free releases both lists.
 * Errors:     out of memory: false, and nothing has changed.
 */
#ifndef EMU_OPERATOR_H
#define EMU_OPERATOR_H

#include <stdbool.h>
#include <stddef.h>

#include "input/act.h"

struct vm_acts {
    struct inp_act *act; /* in order of t */
    size_t count, room;
};

struct vm_operator {
    struct vm_acts script, live;
};

/* How many of either have been done. */
struct vm_done {
    size_t script, live;
};

/* Copies of the script's acts; there were none before. */
bool vm_operator_read(struct vm_operator *o, const struct inp_act *act, size_t count);
/* Does it, not before any live act that was done already. */
bool vm_operator_do(struct vm_operator *o, const struct inp_act *act);
void vm_operator_free(struct vm_operator *o);

/* The act that comes after those done, NULL: none; and that it is done now. */
const struct inp_act *vm_operator_next(const struct vm_operator *o, const struct vm_done *done);
void vm_operator_done(const struct vm_operator *o, struct vm_done *done);
/* What is done when everything before t has happened. */
struct vm_done vm_operator_before(const struct vm_operator *o, uint64_t t);

#endif
