/* rv_switch.h — the processor's loops as a compiler without computed goto gets them.
 *
 * Models:     rv_run over the same handlers, as the cases of a switch (RV_SWITCH).
 * Ownership:  as in rv.h.
 * Errors:     as in rv.h.
 */
#ifndef TESTS_RV_SWITCH_H
#define TESTS_RV_SWITCH_H

#include "emu/cpu/rv.h"

void rv_switch_run(struct rv_cpu *cpu, uint64_t until);

#endif
