/* float_operands.h — operands that make single-precision arithmetic go wrong, if anything does.
 *
 * Models:     a table of patterns, each with either sign; and an endless stream of random triples in
 *             kinds: anything at all, sums that cancel, products and quotients at the least normal and
 *             at the greatest number, fused sums that cancel or only just touch, halves of integers,
 *             subnormals, infinities and NaNs.
 * Ownership:  the caller keeps the state of the stream.
 * Errors:     none.
 * Freestanding: also compiled for RV32 without a library, where it must give the same stream.
 */
#ifndef TESTS_FLOAT_OPERANDS_H
#define TESTS_FLOAT_OPERANDS_H

#include <stdint.h>

static const uint32_t operand_magnitudes[] = {
    0x00000000, 0x00000001, 0x00000002, 0x00000003, 0x000fffff, /* 0 and subnormals */
    0x003fffff, 0x00400000, 0x00400001, 0x007ffffe, 0x007fffff,
    0x00800000, 0x00800001, 0x00ffffff, 0x01000000, 0x01000001, /* 2^-126 … */
    0x0b800000, 0x0c000000, 0x0c7fffff,                         /* 2^-104, 2^-103 */
    0x1f800000, 0x1fffffff, 0x20000000, 0x20000001,             /* 2^-64, 2^-63 */
    0x33000000, 0x33000001, 0x337fffff, 0x33800000, 0x33800001, /* 2^-25, 2^-24: half a step at 1 */
    0x34000000, 0x3e99999a, 0x3eaaaaab, 0x3effffff, 0x3f000000, /* 2^-23, 0.3, 1/3, 0.5 */
    0x3f000001, 0x3f7fffff, 0x3f800000, 0x3f800001, 0x3fbfffff, /* 1 */
    0x3fc00000, 0x3fc00001, 0x3fffffff, 0x40000000, 0x40200000, /* 1.5, 2, 2.5 */
    0x40490fdb, 0x40600000, 0x4affffff, 0x4b000000, 0x4b000001, /* 3.14…, 3.5, 2^23 - 0.5, 2^23 */
    0x4b7fffff, 0x4b800000, 0x4b800001,                         /* 2^24 */
    0x4effffff, 0x4f000000, 0x4f000001, 0x4f7fffff, 0x4f800000, /* 2^31, 2^32 */
    0x5f000000, 0x5f7fffff, 0x5f800000,                         /* 2^63, 2^64 */
    0x73800000, 0x7e800000, 0x7effffff, 0x7f000000, 0x7f7ffffe, /* 2^104, 2^126, 2^127 */
    0x7f7fffff, 0x7f800000, 0x7f800001, 0x7fbfffff, 0x7fc00000, /* greatest, infinity, NaNs */
    0x7fc00001, 0x7fffffff,
};

enum { OPERAND_TABLE = 2 * sizeof operand_magnitudes / sizeof operand_magnitudes[0] };

static inline uint32_t operand_from_table(unsigned index)
{
    return operand_magnitudes[index / 2] | (index & 1 ? 0x80000000u : 0);
}

struct operands {
    uint32_t a, b, c;
};

/* xorshift64*; the upper half is the good one. The state must not be 0. */
static inline uint32_t operand_random(uint64_t *state)
{
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return (uint32_t)(*state * UINT64_C(2685821657736338717) >> 32);
}

static inline uint32_t operand_any_of_table(uint64_t *state)
{
    uint32_t index = (uint32_t)((uint64_t)operand_random(state) * OPERAND_TABLE >> 32);
    return operand_from_table(index);
}

/* 23 bits: often long runs of zeros or ones, so that ties and carries are common. */
static inline uint32_t operand_fraction(uint64_t *state)
{
    uint32_t r = operand_random(state);
    uint32_t fraction = operand_random(state) & 0x7fffff;

    switch (r & 7) {
    case 0:
        return fraction & operand_random(state) & operand_random(state); /* few ones */
    case 1:
        return 1u << (r >> 8) % 23; /* one of them */
    case 2:
        return 0x7fffffu << (r >> 8) % 24 & 0x7fffff; /* ones above, zeros below */
    case 3:
        return 0x7fffff & ~(fraction & operand_random(state) & operand_random(state));
    default:
        return fraction;
    }
}

/* A number with this exponent field, brought into 0 … 254. */
static inline uint32_t operand_number(uint64_t *state, int field)
{
    uint32_t sign = operand_random(state) & 0x80000000u;

    if (field < 0)
        field = 0;
    if (field > 254)
        field = 254;
    return sign | (uint32_t)field << 23 | operand_fraction(state);
}

static inline int operand_within(uint64_t *state, int low, int high)
{
    uint32_t range = (uint32_t)(high - low + 1);
    return low + (int)((uint64_t)operand_random(state) * range >> 32);
}

static inline int operand_field(uint32_t a)
{
    return (int)(a >> 23 & 0xff);
}

/* Makes c about -(a · b): their first 24 bits, or a few off, or some places higher or lower. */
static inline uint32_t operand_against(uint64_t *state, uint32_t a, uint32_t b)
{
    uint64_t product = (uint64_t)(0x800000 | (a & 0x7fffff)) * (0x800000 | (b & 0x7fffff));
    int field = operand_field(a) + operand_field(b) - 127;
    int shift = 23;

    if (product >> 47) {
        shift = 24;
        field++;
    }
    uint32_t significand = (uint32_t)(product >> shift);
    uint32_t r = operand_random(state);
    if (r & 1) /* low bits off by a little, in either direction */
        significand += (r >> 8 & 3) - 1;
    if (r & 2)
        field += operand_within(state, -2, 2);
    if ((r & 12) == 12)
        field += operand_within(state, -52, 52);
    if (field < 1 || field > 254)
        return operand_number(state, field);
    uint32_t sign = (a ^ b ^ 0x80000000u) & 0x80000000u;
    if ((r & 0x70) == 0)
        sign ^= 0x80000000u;
    return sign | (uint32_t)field << 23 | (significand & 0x7fffff);
}

static inline struct operands operands_next(uint64_t *state)
{
    struct operands o;
    uint32_t kind = operand_random(state) >> 28;

    o.a = operand_number(state, operand_within(state, 0, 254));
    o.b = operand_number(state, operand_within(state, 0, 254));
    o.c = operand_number(state, operand_within(state, 0, 254));
    int field = operand_field(o.a);
    switch (kind) {
    case 0: /* any bits */
    case 1:
        o.a = operand_random(state);
        o.b = operand_random(state);
        o.c = operand_random(state);
        break;
    case 2: /* sums: exponents close enough to meet */
    case 3:
        o.b = operand_number(state, field + operand_within(state, -26, 26));
        o.c = operand_number(state, field + operand_within(state, -26, 26));
        break;
    case 4: /* differences that cancel */
        o.b = (o.a ^ 0x80000000u) + (uint32_t)operand_within(state, -4, 4);
        break;
    case 5: /* products about the least normal and the least subnormal number */
        o.b = operand_number(state, 127 - field + operand_within(state, -26, 2));
        o.c = operand_number(state, operand_within(state, 0, 3));
        break;
    case 6: /* products about the greatest number */
        o.b = operand_number(state, 127 - field + 254 + operand_within(state, -2, 2));
        o.c = operand_number(state, operand_within(state, 228, 254));
        break;
    case 7: /* quotients about the least normal number */
        o.b = operand_number(state, field + 127 + operand_within(state, -2, 26));
        break;
    case 8: /* quotients about the greatest */
        o.b = operand_number(state, field - 127 + operand_within(state, -2, 2));
        break;
    case 9: /* fused: a product of middle size, and its counterpart */
    case 10:
        o.a = operand_number(state, operand_within(state, 90, 160));
        o.b = operand_number(state, operand_within(state, 90, 160));
        o.c = operand_against(state, o.a, o.b);
        break;
    case 11: /* fused, near the least numbers */
        o.b = operand_number(state, 127 - field + operand_within(state, -2, 24));
        o.c = operand_against(state, o.a, o.b);
        break;
    case 12: /* numbers about the range of integers, halves among them */
        o.a = operand_number(state, operand_within(state, 124, 160));
        o.b = operand_number(state, operand_within(state, 124, 160));
        break;
    case 13: /* subnormals */
        o.a = operand_number(state, 0);
        o.b = operand_number(state, operand_within(state, 0, 26));
        break;
    case 14: /* one from the table */
        if (o.c & 1)
            o.a = operand_any_of_table(state);
        else
            o.b = operand_any_of_table(state);
        break;
    default:
        o.a = operand_any_of_table(state);
        o.b = operand_any_of_table(state);
        o.c = operand_any_of_table(state);
        break;
    }
    return o;
}

#endif
