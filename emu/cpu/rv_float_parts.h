/* rv_float_parts.h — a single-precision number taken apart, for the rv_float files only.
 *
 *      bits ──rv_unpack──▶ sign, exponent, significand ──▶ exact, or with a sticky bit ──rv_pack──▶ bits
 *
 * Models:     a finite number as (−1)^sign × significand × 2^(exponent − 62). Normalised, the highest
 *             bit of the significand is bit 62, so the number lies in [2^exponent, 2^(exponent + 1)),
 *             and the sum of two significands still fits. A single has 24 bits: 39 stay free below it.
 *             What falls off the lower end is kept as a 1 in bit 0, the sticky bit: every rounding
 *             looks only at whether the discarded part is zero, below, at or above the half, and bit 0
 *             lies at least two places below the half in all that is rounded here.
 * Ownership:  pure functions.
 * Errors:     none.
 * Source:     IEEE 754-2008, clauses 3.4 (the format), 4.3 (rounding) and 7 (flags).
 */
#ifndef EMU_CPU_RV_FLOAT_PARTS_H
#define EMU_CPU_RV_FLOAT_PARTS_H

#include <stdbool.h>
#include <stdint.h>

#define RV_SIGN     0x80000000u
#define RV_INFINITY 0x7F800000u
#define RV_QUIET    0x00400000u /* a NaN with this bit is quiet */

struct rv_unpacked {
    bool sign;
    int exponent;
    uint64_t significand; /* 0: the number is zero, whatever the exponent */
};

/* Not normalised ones are welcome. Rounds, raises RV_NX, RV_UF and RV_OF. */
uint32_t rv_pack(struct rv_unpacked p, unsigned rm, uint32_t *flags);

/* significand / 2^drop as an integer, rounded; 0 < drop < 64. */
uint64_t rv_round_off(uint64_t significand, unsigned drop, bool sign, unsigned rm, bool *inexact);

static inline bool rv_is_nan(uint32_t a)
{
    return (a & ~RV_SIGN) > RV_INFINITY;
}

static inline bool rv_is_signalling(uint32_t a)
{
    return rv_is_nan(a) && !(a & RV_QUIET);
}

static inline bool rv_is_infinite(uint32_t a)
{
    return (a & ~RV_SIGN) == RV_INFINITY;
}

static inline bool rv_is_zero(uint32_t a)
{
    return (a & ~RV_SIGN) == 0;
}

static inline bool rv_is_negative(uint32_t a)
{
    return (a & RV_SIGN) != 0;
}

/* The significand's highest bit goes to bit 62. A zero becomes smaller than everything else, so that
 * aligning it with another number leaves the other one as it is. */
static inline struct rv_unpacked rv_normalise(struct rv_unpacked p)
{
    if (p.significand == 0) {
        p.exponent = -1000;
        return p;
    }
    int zeros = __builtin_clzll(p.significand);
    if (zeros == 0) {
        p.significand = p.significand >> 1 | (p.significand & 1);
        p.exponent += 1;
    } else {
        p.significand <<= zeros - 1;
        p.exponent -= zeros - 1;
    }
    return p;
}

/* Finite numbers only; normalised. */
static inline struct rv_unpacked rv_unpack(uint32_t a)
{
    int field = (int)(a >> 23 & 0xFF);
    uint64_t fraction = a & 0x7FFFFF;
    struct rv_unpacked p = {.sign = rv_is_negative(a)};

    if (field != 0) {
        p.exponent = field - 127;
        p.significand = (fraction | 0x800000) << 39;
        return p;
    }
    p.exponent = -126; /* subnormal: the least exponent, and no hidden bit */
    p.significand = fraction << 39;
    return rv_normalise(p);
}

/* Shifts right by any distance ≥ 0; what falls off stays as the sticky bit. */
static inline uint64_t rv_shift_sticky(uint64_t significand, int distance)
{
    if (distance == 0)
        return significand;
    if (distance > 63)
        return significand != 0;
    uint64_t lost = significand << (64 - distance);
    return significand >> distance | (lost != 0);
}

#endif
