/* rv_float.c — rounding, and sum, product, quotient, root and the fused operation.
 *
 * Each operation first settles NaNs and infinities on the bits, then works with parts
 * (rv_float_parts.h): the exact result, or one that is cut off and marked sticky, is rounded once. */
#include "emu/cpu/rv_float.h"

#include <assert.h>

#include "emu/cpu/rv_float_parts.h"

enum { LEAST_EXPONENT = -126, GREATEST_FIELD = 254 };

/* Bits of a normalised significand that a single has no room for: 63 − 24. */
enum { SPARE = 39 };

uint64_t rv_round_off(uint64_t significand, unsigned drop, bool sign, unsigned rm, bool *inexact)
{
    assert(rm <= RV_RMM && drop > 0 && drop < 64);
    uint64_t half = UINT64_C(1) << (drop - 1);
    uint64_t rest = significand & (half - 1 + half);
    uint64_t kept = significand >> drop;
    bool up = false;

    switch (rm) {
    case RV_RNE:
        up = rest > half || (rest == half && (kept & 1));
        break;
    case RV_RTZ:
        break;
    case RV_RDN:
        up = sign && rest != 0;
        break;
    case RV_RUP:
        up = !sign && rest != 0;
        break;
    default: /* RMM: ties go away from zero */
        up = rest >= half;
        break;
    }
    *inexact = rest != 0;
    return kept + up;
}

/* Too large to be a number: infinity, or the greatest finite number where the mode rounds toward
 * zero on this side. */
static uint32_t overflow(bool sign, unsigned rm, uint32_t *flags)
{
    bool toward_zero = rm == RV_RTZ || rm == (sign ? RV_RUP : RV_RDN);

    *flags |= RV_OF | RV_NX;
    return (sign ? RV_SIGN : 0) | (RV_INFINITY - toward_zero);
}

/* Smaller than the least normal number. The spacing of numbers is that of the least exponent. It is
 * tiny, in the sense of RV_UF, unless rounding to 24 bits with an exponent without limits would reach
 * the least normal number: tininess is detected after rounding. */
static uint32_t pack_subnormal(struct rv_unpacked p, unsigned rm, uint32_t *flags)
{
    bool inexact, ignored;
    uint64_t unlimited = rv_round_off(p.significand, SPARE, p.sign, rm, &ignored);
    bool tiny = p.exponent < LEAST_EXPONENT - 1 || unlimited < 1u << 24;

    p.significand = rv_shift_sticky(p.significand, LEAST_EXPONENT - p.exponent);
    /* When this rounds up to 2^23 it is the bits of the least normal number. */
    uint64_t kept = rv_round_off(p.significand, SPARE, p.sign, rm, &inexact);
    if (inexact)
        *flags |= tiny ? RV_NX | RV_UF : RV_NX;
    return (p.sign ? RV_SIGN : 0) | (uint32_t)kept;
}

uint32_t rv_pack(struct rv_unpacked p, unsigned rm, uint32_t *flags)
{
    bool inexact;

    p = rv_normalise(p);
    if (p.significand == 0)
        return p.sign ? RV_SIGN : 0;
    if (p.exponent < LEAST_EXPONENT)
        return pack_subnormal(p, rm, flags);

    int field = p.exponent + 127;
    uint64_t kept = rv_round_off(p.significand, SPARE, p.sign, rm, &inexact);
    if (kept == 1u << 24) { /* rounded up to the next power of two */
        kept >>= 1;
        field++;
    }
    if (field > GREATEST_FIELD)
        return overflow(p.sign, rm, flags);
    if (inexact)
        *flags |= RV_NX;
    return (p.sign ? RV_SIGN : 0) | (uint32_t)field << 23 | ((uint32_t)kept & 0x7FFFFF);
}

/* The result where at least one operand is a NaN. RISC-V hands on no payloads. */
static uint32_t from_nan(bool signalling, uint32_t *flags)
{
    if (signalling)
        *flags |= RV_NV;
    return RV_NAN;
}

static uint32_t invalid(uint32_t *flags)
{
    *flags |= RV_NV;
    return RV_NAN;
}

/* Of normalised operands. When more than one bit cancels, the exponents differ by at most 1 and
 * nothing has fallen off: a product has 15 free bits below it. */
static struct rv_unpacked sum(struct rv_unpacked a, struct rv_unpacked b, unsigned rm)
{
    if (a.exponent < b.exponent || (a.exponent == b.exponent && a.significand < b.significand)) {
        struct rv_unpacked swap = a;
        a = b;
        b = swap;
    }
    b.significand = rv_shift_sticky(b.significand, a.exponent - b.exponent);
    if (a.sign == b.sign) {
        a.significand += b.significand;
        return a;
    }
    a.significand -= b.significand;
    if (a.significand == 0)
        a.sign = rm == RV_RDN; /* x − x */
    return a;
}

/* Exact: 24 × 24 bits. Bit 39 of a significand counts 2^(exponent − 23), so bit 0 of the product
 * counts 2^(sum of exponents − 46). */
static struct rv_unpacked product(struct rv_unpacked a, struct rv_unpacked b)
{
    struct rv_unpacked p = {
        .sign = a.sign != b.sign,
        .exponent = a.exponent + b.exponent + 62 - 46,
        .significand = (a.significand >> SPARE) * (b.significand >> SPARE),
    };
    return rv_normalise(p);
}

uint32_t rv_fadd(uint32_t a, uint32_t b, unsigned rm, uint32_t *flags)
{
    if (rv_is_nan(a) || rv_is_nan(b))
        return from_nan(rv_is_signalling(a) || rv_is_signalling(b), flags);
    if (rv_is_infinite(a))
        return b == (a ^ RV_SIGN) ? invalid(flags) : a;
    if (rv_is_infinite(b))
        return b;
    return rv_pack(sum(rv_unpack(a), rv_unpack(b), rm), rm, flags);
}

uint32_t rv_fsub(uint32_t a, uint32_t b, unsigned rm, uint32_t *flags)
{
    return rv_fadd(a, b ^ RV_SIGN, rm, flags);
}

uint32_t rv_fmul(uint32_t a, uint32_t b, unsigned rm, uint32_t *flags)
{
    if (rv_is_nan(a) || rv_is_nan(b))
        return from_nan(rv_is_signalling(a) || rv_is_signalling(b), flags);
    if (rv_is_infinite(a) || rv_is_infinite(b)) {
        if (rv_is_zero(a) || rv_is_zero(b))
            return invalid(flags);
        return ((a ^ b) & RV_SIGN) | RV_INFINITY;
    }
    return rv_pack(product(rv_unpack(a), rv_unpack(b)), rm, flags);
}

/* Infinity × zero is invalid whatever is added, a quiet NaN too: IEEE 754 leaves that open (7.2 c),
 * RISC-V does not. */
uint32_t rv_fmadd(uint32_t a, uint32_t b, uint32_t c, unsigned rm, uint32_t *flags)
{
    uint32_t sign = (a ^ b) & RV_SIGN;

    if ((rv_is_infinite(a) && rv_is_zero(b)) || (rv_is_zero(a) && rv_is_infinite(b)))
        return invalid(flags);
    if (rv_is_nan(a) || rv_is_nan(b) || rv_is_nan(c))
        return from_nan(rv_is_signalling(a) || rv_is_signalling(b) || rv_is_signalling(c), flags);
    if (rv_is_infinite(a) || rv_is_infinite(b)) {
        uint32_t infinity = sign | RV_INFINITY;
        return c == (infinity ^ RV_SIGN) ? invalid(flags) : infinity;
    }
    if (rv_is_infinite(c))
        return c;
    return rv_pack(sum(product(rv_unpack(a), rv_unpack(b)), rv_unpack(c), rm), rm, flags);
}

/* The quotient of two 24-bit integers, cut off after 40 or 41 bits. */
static struct rv_unpacked quotient(struct rv_unpacked a, struct rv_unpacked b)
{
    uint64_t dividend = a.significand >> SPARE << 40;
    uint64_t divisor = b.significand >> SPARE;
    struct rv_unpacked p = {
        .sign = a.sign != b.sign,
        .exponent = a.exponent - b.exponent + 62 - 40,
        .significand = dividend / divisor | (dividend % divisor != 0),
    };
    return p;
}

uint32_t rv_fdiv(uint32_t a, uint32_t b, unsigned rm, uint32_t *flags)
{
    uint32_t sign = (a ^ b) & RV_SIGN;

    if (rv_is_nan(a) || rv_is_nan(b))
        return from_nan(rv_is_signalling(a) || rv_is_signalling(b), flags);
    if (rv_is_infinite(a))
        return rv_is_infinite(b) ? invalid(flags) : sign | RV_INFINITY;
    if (rv_is_infinite(b))
        return sign;
    if (rv_is_zero(b)) {
        if (rv_is_zero(a))
            return invalid(flags);
        *flags |= RV_DZ;
        return sign | RV_INFINITY;
    }
    if (rv_is_zero(a))
        return sign;
    return rv_pack(quotient(rv_unpack(a), rv_unpack(b)), rm, flags);
}

/* The integer square root, one binary digit at a time; what remains is not zero unless n is a square. */
static uint64_t integer_root(uint64_t n, uint64_t *remainder)
{
    uint64_t root = 0;

    for (uint64_t bit = UINT64_C(1) << 31; bit != 0; bit >>= 1) {
        uint64_t trial = root + bit;
        if (trial * trial <= n)
            root = trial;
    }
    *remainder = n - root * root;
    return root;
}

/* Of a positive number: 32 bits of the root and whether there are more. */
static struct rv_unpacked square_root(struct rv_unpacked a)
{
    uint64_t remainder;
    uint64_t odd = (uint64_t)(a.exponent & 1);
    uint64_t root = integer_root(a.significand << odd, &remainder); /* root of [1, 4) × 2^62 */
    struct rv_unpacked p = {
        .exponent = (a.exponent - (int)odd) / 2,
        .significand = root << 31 | (remainder != 0),
    };
    return p;
}

uint32_t rv_fsqrt(uint32_t a, unsigned rm, uint32_t *flags)
{
    if (rv_is_nan(a))
        return from_nan(rv_is_signalling(a), flags);
    if (rv_is_zero(a))
        return a; /* −0 too */
    if (rv_is_negative(a))
        return invalid(flags);
    if (rv_is_infinite(a))
        return a;
    return rv_pack(square_root(rv_unpack(a)), rm, flags);
}
