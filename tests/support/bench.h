/* bench.h — what the benchmarks share: a clock, and the floor that memory sets.
 *
 * Units:      seconds; nanoseconds a cell.
 * Ownership:  allocates for the time of a call only.
 * Errors:     out of memory makes the floor meaningless (1e18), nothing else.
 */
#ifndef TESTS_BENCH_H
#define TESTS_BENCH_H

#include <stddef.h>

/* Processor time of this thread, so that other work on the machine counts as little as can be. */
double bench_seconds(void);

/* The time that passes, for what runs in several threads. */
double bench_wall_seconds(void);

/* A plane read and written and a film written, float each: nanoseconds a cell, the best of 20 rounds. No
 * method of exposing gets under it. */
double bench_floor_ns(size_t cells);

#endif
