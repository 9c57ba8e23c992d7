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

static inline bool rv_is_zero(uint32_t a)
{
    return a << 1 == 0;
}

/* Above the smallest normal number, and finite. The smallest itself may have come by rounding from
 * below it, which underflows. */
static inline bool rv_is_plain(uint32_t r)
{
    return (r & 0x7FFFFFFFu) - 0x00800001u < 0x7F800000u - 0x00800001u;
}

/* Sums cannot underflow: what is below the normal numbers is exact. */
static inline bool rv_fast_add(uint32_t a, uint32_t b, uint32_t *r)
{
    *r = rv_bits_of(rv_float_of(a) + rv_float_of(b));
    return *r << 1 < 0xFF000000u;
}

static inline bool rv_fast_sub(uint32_t a, uint32_t b, uint32_t *r)
{
    *r = rv_bits_of(rv_float_of(a) - rv_float_of(b));
    return *r << 1 < 0xFF000000u;
}

static inline bool rv_fast_mul(uint32_t a, uint32_t b, uint32_t *r)
{
    *r = rv_bits_of(rv_float_of(a) * rv_float_of(b));
    return rv_is_plain(*r) || (rv_is_zero(*r) && (rv_is_zero(a) || rv_is_zero(b)));
}

static inline bool rv_fast_div(uint32_t a, uint32_t b, uint32_t *r)
{
    *r = rv_bits_of(rv_float_of(a) / rv_float_of(b));
    return rv_is_plain(*r) || (rv_is_zero(*r) && rv_is_zero(a));
}

/* The root of a positive normal number is one. */
static inline bool rv_fast_sqrt(uint32_t a, uint32_t *r)
{
    if (a - 0x00800000u >= 0x7F800000u - 0x00800000u)
        return false;
    *r = rv_bits_of(sqrtf(rv_float_of(a)));
    return true;
}

/* a·b + c, by double precision. The product is exact (24 + 24 bits of 53). The sum is rounded to 53
 * bits, and then again to 24. Rounding twice goes wrong only where the first lands on the middle
 * between two floats without having been there: if the sum is not such a middle, then it lies on the
 * same side of every middle as the exact value does, because rounding keeps order and middles are
 * doubles. If it is one, it is certain when the first rounding was exact (Knuth's TwoSum). */
static inline bool rv_fast_fma(double product, double c, uint32_t *r)
{
    double sum = product + c;
    uint64_t bits;
    memcpy(&bits, &sum, sizeof bits);
    *r = rv_bits_of((float)sum);
    if ((bits & 0x1FFFFFFFu) == 0x10000000u) {
        double c_part = sum - product;
        if ((product - (sum - c_part)) + (c - c_part) != 0)
            return false;
    }
    return rv_is_plain(*r) || sum == 0;
}

/* The signs of product and c are 1 or −1, known when compiling. */
static inline bool rv_fast_madd(uint32_t a, uint32_t b, uint32_t c, double product_sign,
                                double c_sign, uint32_t *r)
{
    double product = (double)rv_float_of(a) * (double)rv_float_of(b);
    return rv_fast_fma(product_sign < 0 ? -product : product,
                       c_sign < 0 ? -(double)rv_float_of(c) : (double)rv_float_of(c), r);
}

/* Comparisons and the like need no rounding mode. NaNs are not certain. */
static inline bool rv_ordered(uint32_t a, uint32_t b)
{
    return !isunordered(rv_float_of(a), rv_float_of(b));
}

/* Toward zero; |a| < 2³¹. */
static inline bool rv_fast_to_w(uint32_t a, uint32_t *r)
{
    if ((a & 0x7FFFFFFFu) >= 0x4F000000u)
        return false;
    *r = (uint32_t)(int32_t)rv_float_of(a);
    return true;
}

/* Toward zero; 0 <= a < 2³². */
static inline bool rv_fast_to_wu(uint32_t a, uint32_t *r)
{
    if (a >= 0x4F800000u)
        return false;
    *r = (uint32_t)rv_float_of(a);
    return true;
}

#endif
