/* rv_float_fast.h — the same floats from the host's float unit, where that is certain to be right.
 *
 *      operands ─▶ host ─▶ result ─▶ is it certain? ─▶ yes: it is the result, and no flag changes
 *                                                  └▶ no: rv_float.h works it out
 *
 * Models:     round to nearest even, with NX raised already (RV_FLOAT_HOST): whether a result is
 *             inexact is then no news, and nobody needs to know. What else could raise a flag shows
 *             in the result: overflow, division by zero and NaNs in an exponent of all ones,
 *             underflow in a result that is not above the smallest normal number. Those, and all
 *             NaNs, go to rv_float.h.
 * Host:       IEEE 754 single and double precision in its default mode, which nobody ever changes:
 *             x86-64 (SSE) and AArch64. Nothing here depends on the host's flags, on how it detects
 *             underflow or on the NaNs it makes.
 * Ownership:  pure functions.
 * Errors:     false: not certain, *r is worth nothing.
 * Source:     the idea of QEMU's "hardfloat" (E. Cota, 2018).
 */
#ifndef EMU_CPU_RV_FLOAT_FAST_H
#define EMU_CPU_RV_FLOAT_FAST_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

static inline float rv_float_of(uint32_t bits)
{
    float f;
    memcpy(&f, &bits, sizeof f);
    return f;
}

static inline uint32_t rv_bits_of(float f)
{
    uint32_t bits;
    memcpy(&bits, &f, sizeof bits);
    return bits;
}

/* Above the smallest normal number, and finite. The smallest itself may have come by rounding from
 * below it, which underflows. */
static inline bool rv_is_plain(float r)
{
    return __builtin_expect((rv_bits_of(r) & 0x7FFFFFFFu) - 0x00800001u < 0x7EFFFFFFu, 1);
}

/* Sums cannot underflow: what is below the normal numbers is exact. */
static inline bool rv_fast_add(float a, float b, float *r)
{
    *r = a + b;
    return rv_bits_of(*r) << 1 < 0xFF000000u;
}

static inline bool rv_fast_sub(float a, float b, float *r)
{
    *r = a - b;
    return rv_bits_of(*r) << 1 < 0xFF000000u;
}

static inline bool rv_fast_mul(float a, float b, float *r)
{
    *r = a * b;
    return rv_is_plain(*r) || (*r == 0 && (a == 0 || b == 0));
}

static inline bool rv_fast_div(float a, float b, float *r)
{
    *r = a / b;
    return rv_is_plain(*r) || (*r == 0 && a == 0);
}

/* The root of a positive normal number is one. */
static inline bool rv_fast_sqrt(float a, float *r)
{
    if (rv_bits_of(a) - 0x00800000u >= 0x7F800000u - 0x00800000u)
        return false;
    *r = sqrtf(a);
    return true;
}

/* product + c, by double precision; the product of two floats is exact there (24 + 24 bits of 53).
 * The sum is rounded to 53 bits, and then again to 24. Rounding twice goes wrong only where the first
 * lands on the middle between two floats without having been there: if the sum is not such a middle,
 * then it lies on the same side of every middle as the exact value does, because rounding keeps order
 * and middles are doubles. If it is one, it is certain when the first rounding was exact (Knuth's
 * TwoSum). */
static inline bool rv_fast_fma(double product, double c, float *r)
{
    double sum = product + c;
    uint64_t bits;
    memcpy(&bits, &sum, sizeof bits);
    *r = (float)sum;
    if (__builtin_expect((bits & 0x1FFFFFFFu) == 0x10000000u, 0)) {
        double c_part = sum - product;
        if ((product - (sum - c_part)) + (c - c_part) != 0)
            return false;
    }
    return rv_is_plain(*r) || sum == 0;
}

/* Toward zero; |a| < 2³¹. */
static inline bool rv_fast_to_w(float a, uint32_t *r)
{
    if ((rv_bits_of(a) & 0x7FFFFFFFu) >= 0x4F000000u)
        return false;
    *r = (uint32_t)(int32_t)a;
    return true;
}

/* Toward zero; 0 <= a < 2³². */
static inline bool rv_fast_to_wu(float a, uint32_t *r)
{
    if (rv_bits_of(a) >= 0x4F800000u)
        return false;
    *r = (uint32_t)a;
    return true;
}

#endif
