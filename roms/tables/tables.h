/* tables.h — tables of what instructions give, printed on the console.
 *
 * Models:     nothing: the program asks the processor. Each line is a case, or the check sum of many.
 * Units:      values as bits, hexadecimal.
 * Ownership:  nothing.
 * Errors:     none: another processor's tables tell whether these are right.
 * Source:     the same program on QEMU's riscv32 "virt" board prints the same.
 */
#ifndef ROMS_TABLES_TABLES_H
#define ROMS_TABLES_TABLES_H

#include <stdint.h>

/* A check sum that tells the order of its words: FNV-1a, a word at a time. */
#define TABLES_SUM_START 2166136261u

static inline uint32_t tables_sum(uint32_t sum, uint32_t word)
{
    sum = (sum ^ word) * 16777619u;
    return sum ^ sum >> 15;
}

/* The next of a fixed sequence of words; `*state` is not 0. */
static inline uint32_t tables_random(uint32_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 17;
    *state ^= *state << 5;
    return *state;
}

void tables_integers(void);
void tables_memory(void);
void tables_control(void);
void tables_floats(void);
void tables_functions(void);

#endif
