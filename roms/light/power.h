/* power.h — powers of numbers between 0 and 1, for highlights.
 *
 *      x^n = x^(whole part of n), by squaring, times a root for each binary digit behind the point
 *
 * Models:     x^n for n to POWER_DIGITS binary digits; and a table of it, read with linear
 *             interpolation.
 * Cost:       power: about 10 + 3 log2 n operations, and a square root for each digit behind the
 *             point. power_read: 9 operations. A table: POWER_STEPS powers, once for each n.
 * Domain:     x 0…1, n POWER_LEAST…POWER_MOST; what lies beyond is moved to the end.
 * Accuracy:   power: relative 2e-5. power_read: (n / POWER_STEPS)² / 8 and what float leaves, under
 *             0.002 for n = 100; below `low` a table reads 0 where the power is under 1/512.
 * Units:      none.
 * Ownership:  plain values; a table is the caller's.
 * Errors:     none.
 * Source:     elementary. Only operations that IEEE 754 rounds, so that every machine gives the
 *             same bits.
 * Not modelled: n below 1: the slope at 0 is infinite there and a table could not follow.
 */
#ifndef ROMS_LIGHT_POWER_H
#define ROMS_LIGHT_POWER_H

#include <math.h>

enum { POWER_LEAST = 1, POWER_MOST = 200, POWER_DIGITS = 8, POWER_STEPS = 1024 };

float power(float x, float n);

struct power_table {
    float n;
    float low;                 /* x at which the power begins to count */
    float at[POWER_STEPS + 2]; /* at[k] = (k / POWER_STEPS)^n */
};

/* Nothing when it is a table of that n already. A table must have been all 0 before the first. */
void power_table(struct power_table *table, float n);

/* x must be 0…1. */
static inline float power_read(const struct power_table *table, float x)
{
    float place = x * POWER_STEPS;
    int k = (int)place;
    const float *at = &table->at[k];
    return fmaf(at[1] - at[0], place - (float)k, at[0]);
}

#endif
