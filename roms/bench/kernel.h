/* kernel.h — what a benchmark program works at; the same object code runs as firmware and, for
 * comparison, as a program of a Linux user (tests/bench/user).
 *
 * Models:     nothing: work whose result anybody can check.
 * Ownership:  memory of its own, not on the stack.
 * Errors:     none.
 * Source:     each kernel says where its method is from. No library functions are called.
 */
#ifndef ROMS_BENCH_KERNEL_H
#define ROMS_BENCH_KERNEL_H

#include <stdint.h>

extern const char kernel_name[];
/* Does the work; a check sum of its result. */
uint32_t kernel_run(void);

/* A check sum that tells the order of its words: FNV-1a, a word at a time. */
static inline uint32_t kernel_sum(uint32_t sum, uint32_t word)
{
    return (sum ^ word) * 16777619u;
}

#define KERNEL_SUM_START 2166136261u

#endif
