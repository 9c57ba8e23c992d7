/* rv_random.h — random programs for the rig.
 *
 *      0000  code: RANDOM_CODE words        0800  handler
 *      8000  data                           device: raises the external interrupt, drops it again
 *
 * Models:     every kind of instruction, with loops, traps of all causes, stores into the code (words
 *             copied from elsewhere in it), device accesses, interrupts, wfi, CSRs, counters. The
 *             handler skips what trapped and drops the external interrupt.
 * Ownership:  writes into the caller's rig.
 * Errors:     none.
 */
#ifndef TESTS_RV_RANDOM_H
#define TESTS_RV_RANDOM_H

#include "tests/support/rv_rig.h"

#define RANDOM_CODE 400u

/* The same program for the same seed. Registers are set, pc is at the start, interrupts are on. */
void random_program(struct rig *r, uint32_t seed);

#endif
