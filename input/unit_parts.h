/* unit_parts.h — what the files of the input unit share; not for others.
 *
 *      unit.c      acts, light, events, the interrupt     unit_registers.c registers
 *                                                         unit_state.c     snapshots
 *
 * Models:     see input/unit.h.
 * Time:       picoseconds since power-on.
 * Ownership:  all of it works on the caller's unit.
 * Errors:     none.
 */
#ifndef INPUT_UNIT_PARTS_H
#define INPUT_UNIT_PARTS_H

#include "input/unit.h"

/* INPUT_BIT_… of the pens. */
extern const uint32_t inp_pen_bit[INP_SCREENS];

bool inp_unit_has_pen(const struct inp_unit *unit, int screen);
/* INPUT_PRESENT, INPUT_STATUS. */
uint32_t inp_unit_present(const struct inp_unit *unit);
uint32_t inp_unit_status(const struct inp_unit *unit);
/* When something happens by itself next. */
uint64_t inp_unit_next(const struct inp_unit *unit);
/* After whatever may have changed: unit->next, and the interrupt wire. */
void inp_unit_settle(struct inp_unit *unit, uint64_t t);

#endif
