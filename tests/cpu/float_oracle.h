/* float_oracle.h — what a single-precision operation must give, from exact arithmetic.
 *
 *      operands ─MPFR─▶ exact value ─÷ spacing─▶ scaled ─▶ whole number ─× spacing─▶ result
 *
 * Models:     the operation's value as an MPFR number with every bit of it, then IEEE 754's definitions
 *             taken literally: the value is divided by the spacing of the format's numbers at its size
 *             and rounded to an integer by MPFR, which has all five modes for that, ties away among
 *             them. Flags follow from the same exact value.
 * Shares:     nothing with emu/cpu but the names of modes and flags.
 * Exact:      sums and fused sums span 2^256 down to 2^-298: 600 bits hold them. Quotients and roots of
 *             24-bit numbers that are not exact lie at least 2^-52 of their size from every 25-bit
 *             number: cutting them off after 600 bits changes no decision.
 * Ownership:  the caller initialises and clears the oracle. Header only: one test needs MPFR.
 * Errors:     none.
 */
#ifndef TESTS_FLOAT_ORACLE_H
#define TESTS_FLOAT_ORACLE_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <mpfr.h>

#include "emu/cpu/rv_float.h"

enum { ORACLE_BITS = 600 };

/* The format: 24 bits, the least spacing 2^-149, numbers below 2^128. */
enum { DIGITS = 24, LEAST_SPACING = -149, GREATEST_SPACING = 128 - DIGITS, LEAST_NORMAL = -126 };

enum oracle_op { ORACLE_ADD, ORACLE_SUB, ORACLE_MUL, ORACLE_DIV, ORACLE_SQRT, ORACLE_FMADD };

struct oracle {
    enum oracle_op op;
    uint32_t bits_a, bits_b, bits_c; /* operands; 0 where the operation has none */
    mpfr_t a, b, c;
    mpfr_t exact;         /* the value, for all modes */
    mpfr_t scaled, whole; /* in units of a spacing, before and after rounding */
};

struct oracle_result {
    uint32_t bits, flags;
};

static inline void oracle_init(struct oracle *o)
{
    mpfr_inits2(ORACLE_BITS, o->a, o->b, o->c, o->exact, o->scaled, o->whole, (mpfr_ptr)0);
}

static inline void oracle_clear(struct oracle *o)
{
    mpfr_clears(o->a, o->b, o->c, o->exact, o->scaled, o->whole, (mpfr_ptr)0);
    mpfr_free_cache();
}

static inline float oracle_float(uint32_t bits)
{
    float f;
    memcpy(&f, &bits, sizeof f);
    return f;
}

static inline uint32_t oracle_bits(float f)
{
    uint32_t bits;
    memcpy(&bits, &f, sizeof bits);
    return bits;
}

static inline bool oracle_signalling(uint32_t bits)
{
    return isnan(oracle_float(bits)) && !(bits & 0x400000);
}

/* Rounds o->scaled to o->whole; whether they differ. */
static inline bool oracle_whole(struct oracle *o, unsigned rm)
{
    switch (rm) {
    case RV_RNE:
        mpfr_roundeven(o->whole, o->scaled);
        break;
    case RV_RTZ:
        mpfr_trunc(o->whole, o->scaled);
        break;
    case RV_RDN:
        mpfr_floor(o->whole, o->scaled);
        break;
    case RV_RUP:
        mpfr_ceil(o->whole, o->scaled);
        break;
    default:
        mpfr_round(o->whole, o->scaled);
        break;
    }
    return !mpfr_equal_p(o->whole, o->scaled);
}

/* o->exact in units of 2^spacing, rounded. */
static inline long oracle_units(struct oracle *o, long spacing, unsigned rm, bool *inexact)
{
    mpfr_mul_2si(o->scaled, o->exact, -spacing, MPFR_RNDN); /* exact: only the exponent changes */
    *inexact = oracle_whole(o, rm);
    return labs(mpfr_get_si(o->whole, MPFR_RNDN));
}

/* IEEE 754, 7.4: what takes the place of a number too large. */
static inline uint32_t oracle_overflow(bool negative, unsigned rm)
{
    if (rm == RV_RNE || rm == RV_RMM || rm == (negative ? RV_RDN : RV_RUP))
        return oracle_bits(negative ? -INFINITY : INFINITY);
    return oracle_bits(negative ? -0x1.fffffep127f : 0x1.fffffep127f);
}

/* IEEE 754, 7.5, after rounding: "rounded as though the exponent range were unbounded" it would be
 * less than the least normal number. */
static inline bool oracle_tiny(struct oracle *o, unsigned rm)
{
    bool ignored;
    long exponent = mpfr_get_exp(o->exact); /* the value is in [2^(exponent − 1), 2^exponent) */
    long units = oracle_units(o, exponent - DIGITS, rm, &ignored);

    return exponent - 1 < LEAST_NORMAL && !(exponent == LEAST_NORMAL && units == 1L << DIGITS);
}

/* o->exact is a number and not 0. */
static inline struct oracle_result oracle_round_number(struct oracle *o, unsigned rm)
{
    struct oracle_result r = {0, 0};
    bool inexact, negative = mpfr_signbit(o->exact) != 0;
    long spacing = mpfr_get_exp(o->exact) - DIGITS;

    if (spacing < LEAST_SPACING)
        spacing = LEAST_SPACING;
    long units = oracle_units(o, spacing, rm, &inexact);
    if (spacing > GREATEST_SPACING || (spacing == GREATEST_SPACING && units == 1L << DIGITS)) {
        r.bits = oracle_overflow(negative, rm);
        r.flags = RV_OF | RV_NX;
        return r;
    }
    float magnitude = (float)ldexp((double)units, (int)spacing); /* exact */
    r.bits = oracle_bits(negative ? -magnitude : magnitude);
    if (inexact)
        r.flags = oracle_tiny(o, rm) ? RV_NX | RV_UF : RV_NX;
    return r;
}

static inline void oracle_apply(struct oracle *o, mpfr_rnd_t direction)
{
    switch (o->op) {
    case ORACLE_ADD:
        mpfr_add(o->exact, o->a, o->b, direction);
        break;
    case ORACLE_SUB:
        mpfr_sub(o->exact, o->a, o->b, direction);
        break;
    case ORACLE_MUL:
        mpfr_mul(o->exact, o->a, o->b, direction);
        break;
    case ORACLE_DIV:
        mpfr_div(o->exact, o->a, o->b, direction);
        break;
    case ORACLE_SQRT:
        mpfr_sqrt(o->exact, o->a, direction);
        break;
    case ORACLE_FMADD:
        mpfr_fma(o->exact, o->a, o->b, o->c, direction);
        break;
    }
}

/* Computes the value, for oracle_round in any mode. Operands that the operation has not: 0. */
static inline void oracle_compute(struct oracle *o, enum oracle_op op, uint32_t a, uint32_t b,
                                  uint32_t c)
{
    o->op = op;
    o->bits_a = a;
    o->bits_b = b;
    o->bits_c = c;
    mpfr_set_d(o->a, (double)oracle_float(a), MPFR_RNDN);
    mpfr_set_d(o->b, (double)oracle_float(b), MPFR_RNDN);
    mpfr_set_d(o->c, (double)oracle_float(c), MPFR_RNDN);
    oracle_apply(o, MPFR_RNDZ);
}

/* Why there is no number: a signalling operand, or no NaN went in, or RISC-V's own rule for the
 * product of infinity and zero (11.6: "even when the addend is a quiet NaN"). */
static inline bool oracle_invalid(const struct oracle *o)
{
    bool zero_times_infinity = o->op == ORACLE_FMADD && ((mpfr_inf_p(o->a) && mpfr_zero_p(o->b)) ||
                                                         (mpfr_zero_p(o->a) && mpfr_inf_p(o->b)));

    if (oracle_signalling(o->bits_a) || oracle_signalling(o->bits_b) ||
        oracle_signalling(o->bits_c))
        return true;
    return zero_times_infinity || !(mpfr_nan_p(o->a) || mpfr_nan_p(o->b) || mpfr_nan_p(o->c));
}

static inline struct oracle_result oracle_round(struct oracle *o, unsigned rm)
{
    struct oracle_result r = {0, 0};

    if (mpfr_nan_p(o->exact)) {
        r.bits = 0x7fc00000;
        r.flags = oracle_invalid(o) ? RV_NV : 0;
    } else if (mpfr_inf_p(o->exact)) {
        r.bits = oracle_bits(mpfr_signbit(o->exact) ? -INFINITY : INFINITY);
        r.flags = o->op == ORACLE_DIV && !mpfr_inf_p(o->a) ? RV_DZ : 0;
    } else if (mpfr_zero_p(o->exact)) {
        /* x − x is −0 when rounding down, here as in MPFR. */
        oracle_apply(o, rm == RV_RDN ? MPFR_RNDD : MPFR_RNDN);
        r.bits = oracle_bits(mpfr_signbit(o->exact) ? -0.0f : 0.0f);
    } else {
        r = oracle_round_number(o, rm);
    }
    return r;
}

/* Out of range, infinite, NaN: "clipped to the nearest value", NaN to the greatest, and invalid. */
static inline struct oracle_result oracle_to_integer(struct oracle *o, uint32_t a, bool is_signed,
                                                     unsigned rm)
{
    struct oracle_result least = {is_signed ? 0x80000000 : 0, RV_NV};
    struct oracle_result greatest = {is_signed ? 0x7fffffff : 0xffffffff, RV_NV};
    struct oracle_result r;

    mpfr_set_d(o->scaled, (double)oracle_float(a), MPFR_RNDN);
    if (mpfr_nan_p(o->scaled))
        return greatest;
    bool inexact = oracle_whole(o, rm);
    if (is_signed ? mpfr_cmp_si(o->whole, -2147483647L - 1) < 0 : mpfr_cmp_si(o->whole, 0) < 0)
        return least;
    if (is_signed ? mpfr_cmp_si(o->whole, 2147483647L) > 0
                  : mpfr_cmp_ui(o->whole, 4294967295UL) > 0)
        return greatest;
    r.bits = is_signed ? (uint32_t)mpfr_get_si(o->whole, MPFR_RNDN)
                       : (uint32_t)mpfr_get_ui(o->whole, MPFR_RNDN);
    r.flags = inexact ? RV_NX : 0;
    return r;
}

static inline struct oracle_result oracle_from_integer(struct oracle *o, uint32_t a, bool is_signed,
                                                       unsigned rm)
{
    if (is_signed)
        mpfr_set_si(o->exact, (int32_t)a, MPFR_RNDN);
    else
        mpfr_set_ui(o->exact, a, MPFR_RNDN);
    if (mpfr_zero_p(o->exact))
        return (struct oracle_result){0, 0};
    return oracle_round_number(o, rm);
}

#endif
