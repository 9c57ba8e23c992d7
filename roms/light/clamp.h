/* clamp.h — the larger and the smaller of two floats, as one instruction each.
 *
 * Models:     fmax and fmin without what the C library adds for signalling NaNs.
 * Cost:       1 instruction.
 * Ownership:  nothing.
 * Errors:     none; of a NaN and a number, the number.
 * Source:     the compiler's own.
 */
#ifndef ROMS_LIGHT_CLAMP_H
#define ROMS_LIGHT_CLAMP_H

/* Always: a call would take longer than what it does. */
#define CLAMP_INLINE static inline __attribute__((always_inline))

CLAMP_INLINE float larger(float a, float b)
{
    return __builtin_fmaxf(a, b);
}

CLAMP_INLINE float smaller(float a, float b)
{
    return __builtin_fminf(a, b);
}

CLAMP_INLINE float clamp(float v, float low, float high)
{
    return smaller(larger(v, low), high);
}

#endif
