/* Single-precision results worked out by hand: the cases that define rounding, tininess, NaNs. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "emu/cpu/rv_float.h"

/* Numbers by value. A step is the distance to the next number. */
#define ONE       0x3f800000u
#define MINUS     0x80000000u /* ORed: with the other sign */
#define HALF      0x3f000000u
#define THREE     0x40400000u
#define INFINITE  0x7f800000u
#define GREATEST  0x7f7fffffu
#define NORMAL    0x00800000u /* the least normal number, 2^-126 */
#define LEAST     0x00000001u /* the least subnormal one, 2^-149 */
#define HALF_STEP 0x33800000u /* 2^-24, half a step at 1 */
#define QUIET     0x7fc12345u /* a quiet NaN with a payload */
#define LOUD      0x7f812345u /* a signalling one */

enum op { ADD, SUB, MUL, DIV, SQRT, FMADD, TO_W, TO_WU, FROM_W, FROM_WU, MIN, MAX, EQ, LT, LE };

struct known {
    enum op op;
    unsigned rm;
    uint32_t a, b, c;
    uint32_t bits, flags;
};

static uint32_t compute(const struct known *k, uint32_t *flags)
{
    switch (k->op) {
    case ADD:
        return rv_fadd(k->a, k->b, k->rm, flags);
    case SUB:
        return rv_fsub(k->a, k->b, k->rm, flags);
    case MUL:
        return rv_fmul(k->a, k->b, k->rm, flags);
    case DIV:
        return rv_fdiv(k->a, k->b, k->rm, flags);
    case SQRT:
        return rv_fsqrt(k->a, k->rm, flags);
    case FMADD:
        return rv_fmadd(k->a, k->b, k->c, k->rm, flags);
    case TO_W:
        return rv_fcvt_w(k->a, k->rm, flags);
    case TO_WU:
        return rv_fcvt_wu(k->a, k->rm, flags);
    case FROM_W:
        return rv_fcvt_from_w(k->a, k->rm, flags);
    case FROM_WU:
        return rv_fcvt_from_wu(k->a, k->rm, flags);
    case MIN:
        return rv_fmin(k->a, k->b, flags);
    case MAX:
        return rv_fmax(k->a, k->b, flags);
    case EQ:
        return rv_feq(k->a, k->b, flags);
    case LT:
        return rv_flt(k->a, k->b, flags);
    default:
        return rv_fle(k->a, k->b, flags);
    }
}

/* Flags that were up stay up, whatever the operation raises. */
static void check(const struct known *known, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const struct known *k = &known[i];
        uint32_t flags = 0, bits = compute(k, &flags);
        if (bits != k->bits || flags != k->flags)
            fail_msg("row %zu: %08x flags %02x, must be %08x flags %02x", i, (unsigned)bits,
                     (unsigned)flags, (unsigned)k->bits, (unsigned)k->flags);
        for (uint32_t up = 1; up <= 16; up <<= 1) {
            flags = up;
            assert_int_equal(compute(k, &flags), k->bits);
            assert_int_equal(flags, k->flags | up);
        }
    }
}
#define CHECK(table) check(table, sizeof table / sizeof table[0])

/* 1 + half a step is a tie between 1 (even) and its neighbour. */
static void rounding(void **state)
{
    static const struct known table[] = {
        {ADD, RV_RNE, ONE, HALF_STEP, 0, ONE, RV_NX},
        {ADD, RV_RTZ, ONE, HALF_STEP, 0, ONE, RV_NX},
        {ADD, RV_RDN, ONE, HALF_STEP, 0, ONE, RV_NX},
        {ADD, RV_RUP, ONE, HALF_STEP, 0, ONE + 1, RV_NX},
        {ADD, RV_RMM, ONE, HALF_STEP, 0, ONE + 1, RV_NX},
        /* the neighbour is odd: the tie goes up */
        {ADD, RV_RNE, ONE + 1, HALF_STEP, 0, ONE + 2, RV_NX},
        {ADD, RV_RTZ, ONE + 1, HALF_STEP, 0, ONE + 1, RV_NX},
        /* down and up are directions, not away and toward */
        {SUB, RV_RNE, ONE | MINUS, HALF_STEP, 0, ONE | MINUS, RV_NX},
        {SUB, RV_RTZ, ONE | MINUS, HALF_STEP, 0, ONE | MINUS, RV_NX},
        {SUB, RV_RDN, ONE | MINUS, HALF_STEP, 0, (ONE + 1) | MINUS, RV_NX},
        {SUB, RV_RUP, ONE | MINUS, HALF_STEP, 0, ONE | MINUS, RV_NX},
        {SUB, RV_RMM, ONE | MINUS, HALF_STEP, 0, (ONE + 1) | MINUS, RV_NX},
        /* below 1 the step is half as long: HALF_STEP is a whole one */
        {SUB, RV_RNE, ONE, HALF_STEP, 0, ONE - 1, 0},
        /* what is far away still pushes a directed mode */
        {ADD, RV_RUP, ONE, LEAST, 0, ONE + 1, RV_NX},
        {SUB, RV_RTZ, ONE, LEAST, 0, ONE - 1, RV_NX},
        {SUB, RV_RNE, ONE, LEAST, 0, ONE, RV_NX},
        /* 1/3 = 0.0101…b; sqrt(2) = 1.41421356…, between 3fb504f3 and 3fb504f4 */
        {DIV, RV_RNE, ONE, THREE, 0, 0x3eaaaaab, RV_NX},
        {DIV, RV_RTZ, ONE, THREE, 0, 0x3eaaaaaa, RV_NX},
        {DIV, RV_RDN, ONE | MINUS, THREE, 0, 0xbeaaaaab, RV_NX},
        {DIV, RV_RUP, ONE | MINUS, THREE, 0, 0xbeaaaaaa, RV_NX},
        {SQRT, RV_RNE, 0x40000000, 0, 0, 0x3fb504f3, RV_NX},
        {SQRT, RV_RUP, 0x40000000, 0, 0, 0x3fb504f4, RV_NX},
        {SQRT, RV_RNE, 0x40800000, 0, 0, 0x40000000, 0},
        {SQRT, RV_RNE, LEAST, 0, 0, 0x1a3504f3, RV_NX}, /* 2^-75 · sqrt(2) */
    };
    (void)state;
    CHECK(table);
}

/* Beyond the greatest number: half a step above it is 2^103, and 2^102 is less. */
static void overflow(void **state)
{
    static const struct known table[] = {
        {ADD, RV_RNE, GREATEST, 0x73000000, 0, INFINITE, RV_OF | RV_NX},
        {ADD, RV_RMM, GREATEST, 0x73000000, 0, INFINITE, RV_OF | RV_NX},
        {ADD, RV_RUP, GREATEST, 0x73000000, 0, INFINITE, RV_OF | RV_NX},
        {ADD, RV_RTZ, GREATEST, 0x73000000, 0, GREATEST, RV_NX},
        {ADD, RV_RDN, GREATEST, 0x73000000, 0, GREATEST, RV_NX},
        {ADD, RV_RNE, GREATEST, 0x72800000, 0, GREATEST, RV_NX},
        {ADD, RV_RUP, GREATEST, LEAST, 0, INFINITE, RV_OF | RV_NX},
        {MUL, RV_RTZ, GREATEST, GREATEST, 0, GREATEST, RV_OF | RV_NX},
        {MUL, RV_RDN, GREATEST, GREATEST, 0, GREATEST, RV_OF | RV_NX},
        {MUL, RV_RDN, GREATEST, GREATEST | MINUS, 0, INFINITE | MINUS, RV_OF | RV_NX},
        {MUL, RV_RUP, GREATEST, GREATEST | MINUS, 0, GREATEST | MINUS, RV_OF | RV_NX},
        {MUL, RV_RMM, GREATEST, GREATEST | MINUS, 0, INFINITE | MINUS, RV_OF | RV_NX},
        {DIV, RV_RNE, GREATEST, HALF, 0, INFINITE, RV_OF | RV_NX},
        /* the product is too large, the sum is not */
        {FMADD, RV_RNE, GREATEST, 0x40000000, GREATEST | MINUS, GREATEST, 0},
    };
    (void)state;
    CHECK(table);
}

/* Underflow is: tiny after rounding, and inexact. */
static void underflow(void **state)
{
    static const struct known table[] = {
        {MUL, RV_RNE, NORMAL, HALF, 0, 0x00400000, 0},
        {MUL, RV_RNE, LEAST, HALF, 0, 0, RV_UF | RV_NX},
        {MUL, RV_RMM, LEAST, HALF, 0, LEAST, RV_UF | RV_NX},
        {MUL, RV_RUP, LEAST, HALF, 0, LEAST, RV_UF | RV_NX},
        {MUL, RV_RUP, LEAST | MINUS, HALF, 0, MINUS, RV_UF | RV_NX},
        {MUL, RV_RDN, LEAST | MINUS, HALF, 0, LEAST | MINUS, RV_UF | RV_NX},
        {MUL, RV_RUP, LEAST, LEAST, 0, LEAST, RV_UF | RV_NX},
        /* 2^-126 (1 − 2^-24) has 24 bits, so it is tiny; it is delivered as the tie 2^-126 */
        {MUL, RV_RNE, NORMAL, ONE - 1, 0, NORMAL, RV_UF | RV_NX},
        {MUL, RV_RTZ, NORMAL, ONE - 1, 0, NORMAL - 1, RV_UF | RV_NX},
        /* (1 − 2^-23) · 2^-126 (1 + 2^-23) = 2^-126 (1 − 2^-46): 24 bits make it 2^-126, not tiny … */
        {MUL, RV_RNE, ONE - 2, NORMAL + 1, 0, NORMAL, RV_NX},
        {MUL, RV_RMM, ONE - 2, NORMAL + 1, 0, NORMAL, RV_NX},
        {MUL, RV_RUP, ONE - 2, NORMAL + 1, 0, NORMAL, RV_NX},
        /* … unless it is cut off */
        {MUL, RV_RTZ, ONE - 2, NORMAL + 1, 0, NORMAL - 1, RV_UF | RV_NX},
        {MUL, RV_RDN, ONE - 2, NORMAL + 1, 0, NORMAL - 1, RV_UF | RV_NX},
        {DIV, RV_RNE, LEAST, 0x40000000, 0, 0, RV_UF | RV_NX},
        {DIV, RV_RNE, 3, 0x40000000, 0, 2, RV_UF | RV_NX},
        /* sums of subnormals are exact */
        {ADD, RV_RNE, 0x007fffff, LEAST, 0, NORMAL, 0},
        {SUB, RV_RNE, NORMAL, LEAST, 0, 0x007fffff, 0},
    };
    (void)state;
    CHECK(table);
}

static void zeros(void **state)
{
    static const struct known table[] = {
        {SUB, RV_RNE, ONE, ONE, 0, 0, 0},
        {SUB, RV_RUP, ONE, ONE, 0, 0, 0},
        {SUB, RV_RDN, ONE, ONE, 0, MINUS, 0},
        {ADD, RV_RNE, 0, MINUS, 0, 0, 0},
        {ADD, RV_RDN, 0, MINUS, 0, MINUS, 0},
        {ADD, RV_RNE, MINUS, MINUS, 0, MINUS, 0},
        {ADD, RV_RDN, 0, 0, 0, 0, 0},
        {MUL, RV_RNE, MINUS, ONE, 0, MINUS, 0},
        {DIV, RV_RNE, ONE | MINUS, INFINITE, 0, MINUS, 0},
        {SQRT, RV_RNE, MINUS, 0, 0, MINUS, 0},
        {FMADD, RV_RNE, 0, 0, MINUS, 0, 0},
        {FMADD, RV_RDN, 0, 0, MINUS, MINUS, 0},
        {FMADD, RV_RNE, ONE | MINUS, 0, MINUS, MINUS, 0},
        {FMADD, RV_RDN, ONE, ONE, ONE | MINUS, MINUS, 0},
    };
    (void)state;
    CHECK(table);
}

static void infinities_and_nans(void **state)
{
    static const struct known table[] = {
        {ADD, RV_RNE, INFINITE, INFINITE | MINUS, 0, RV_NAN, RV_NV},
        {SUB, RV_RNE, INFINITE, INFINITE, 0, RV_NAN, RV_NV},
        {ADD, RV_RNE, INFINITE, GREATEST | MINUS, 0, INFINITE, 0},
        {MUL, RV_RNE, INFINITE | MINUS, 0, 0, RV_NAN, RV_NV},
        {DIV, RV_RNE, INFINITE, INFINITE, 0, RV_NAN, RV_NV},
        {DIV, RV_RNE, 0, MINUS, 0, RV_NAN, RV_NV},
        {DIV, RV_RNE, ONE, MINUS, 0, INFINITE | MINUS, RV_DZ},
        {DIV, RV_RTZ, LEAST, 0, 0, INFINITE, RV_DZ}, /* exact: no mode makes it finite */
        {DIV, RV_RNE, INFINITE, MINUS, 0, INFINITE | MINUS, 0},
        {DIV, RV_RNE, QUIET, 0, 0, RV_NAN, 0},
        {SQRT, RV_RNE, LEAST | MINUS, 0, 0, RV_NAN, RV_NV},
        {SQRT, RV_RNE, INFINITE | MINUS, 0, 0, RV_NAN, RV_NV},
        {SQRT, RV_RNE, INFINITE, 0, 0, INFINITE, 0},
        {SQRT, RV_RNE, QUIET | MINUS, 0, 0, RV_NAN, 0},
        /* no payload and no sign comes through */
        {ADD, RV_RNE, QUIET | MINUS, ONE, 0, RV_NAN, 0},
        {ADD, RV_RNE, ONE, LOUD, 0, RV_NAN, RV_NV},
        {MUL, RV_RNE, LOUD, QUIET, 0, RV_NAN, RV_NV},
        {FMADD, RV_RNE, ONE, ONE, QUIET, RV_NAN, 0},
        {FMADD, RV_RNE, ONE, ONE, LOUD, RV_NAN, RV_NV},
        {FMADD, RV_RNE, INFINITE, 0, ONE, RV_NAN, RV_NV},
        {FMADD, RV_RNE, INFINITE, 0, QUIET, RV_NAN, RV_NV}, /* RISC-V's choice */
        {FMADD, RV_RNE, MINUS, INFINITE, QUIET, RV_NAN, RV_NV},
        {FMADD, RV_RNE, INFINITE, ONE, INFINITE | MINUS, RV_NAN, RV_NV},
        {FMADD, RV_RNE, INFINITE, QUIET, INFINITE | MINUS, RV_NAN, 0},
        {FMADD, RV_RNE, GREATEST, GREATEST, INFINITE | MINUS, INFINITE | MINUS, 0},
    };
    (void)state;
    CHECK(table);
}

/* (1 + 2^-12)² = 1 + 2^-11 + 2^-24: the last bit is half a step. */
static void fused_rounds_once(void **state)
{
    static const struct known table[] = {
        {FMADD, RV_RNE, 0x3f800800, 0x3f800800, 0, 0x3f801000, RV_NX},
        {FMADD, RV_RNE, 0x3f800800, 0x3f800800, LEAST, 0x3f801001, RV_NX},
        {FMADD, RV_RNE, 0x3f800800, 0x3f800800, LEAST | MINUS, 0x3f801000, RV_NX},
        {FMADD, RV_RMM, 0x3f800800, 0x3f800800, 0, 0x3f801001, RV_NX},
        {FMADD, RV_RMM, 0x3f800800, 0x3f800800, LEAST | MINUS, 0x3f801000, RV_NX},
        {FMADD, RV_RNE, 0x3f800800, 0x3f800800, 0xbf801000, HALF_STEP, 0},
        /* a product far below the least number moves a directed sum by one step */
        {FMADD, RV_RUP, LEAST, LEAST, ONE, ONE + 1, RV_NX},
        {FMADD, RV_RDN, LEAST, LEAST | MINUS, ONE, ONE - 1, RV_NX},
        {FMADD, RV_RUP, LEAST, LEAST, LEAST, LEAST + 1, RV_UF | RV_NX},
        {FMADD, RV_RTZ, LEAST, LEAST | MINUS, NORMAL, NORMAL - 1, RV_UF | RV_NX},
        {FMADD, RV_RNE, LEAST, LEAST | MINUS, NORMAL, NORMAL, RV_NX},
    };
    (void)state;
    CHECK(table);
}

static void to_integers(void **state)
{
    static const struct known table[] = {
        {TO_W, RV_RNE, 0x40200000, 0, 0, 2, RV_NX}, /* 2.5 */
        {TO_W, RV_RMM, 0x40200000, 0, 0, 3, RV_NX},
        {TO_W, RV_RNE, 0x40600000, 0, 0, 4, RV_NX}, /* 3.5 */
        {TO_W, RV_RMM, 0xc0200000, 0, 0, 0xfffffffd, RV_NX},
        {TO_W, RV_RDN, 0xc0200000, 0, 0, 0xfffffffd, RV_NX},
        {TO_W, RV_RUP, 0xc0200000, 0, 0, 0xfffffffe, RV_NX},
        {TO_W, RV_RUP, LEAST, 0, 0, 1, RV_NX},
        {TO_W, RV_RDN, LEAST | MINUS, 0, 0, 0xffffffff, RV_NX},
        {TO_W, RV_RNE, MINUS, 0, 0, 0, 0},
        {TO_W, RV_RNE, 0x4effffff, 0, 0, 0x7fffff80, 0},
        {TO_W, RV_RNE, 0x4f000000, 0, 0, 0x7fffffff, RV_NV}, /* 2^31 */
        {TO_W, RV_RNE, 0xcf000000, 0, 0, 0x80000000, 0},
        {TO_W, RV_RNE, 0xcf000001, 0, 0, 0x80000000, RV_NV},
        {TO_W, RV_RNE, INFINITE | MINUS, 0, 0, 0x80000000, RV_NV},
        {TO_W, RV_RNE, QUIET | MINUS, 0, 0, 0x7fffffff, RV_NV},
        {TO_WU, RV_RNE, 0x4f7fffff, 0, 0, 0xffffff00, 0},
        {TO_WU, RV_RNE, 0x4f800000, 0, 0, 0xffffffff, RV_NV}, /* 2^32 */
        {TO_WU, RV_RTZ, 0x5f800000, 0, 0, 0xffffffff, RV_NV}, /* 2^64 */
        {TO_WU, RV_RNE, 0xbf000000, 0, 0, 0, RV_NX},          /* -0.5 */
        {TO_WU, RV_RMM, 0xbf000000, 0, 0, 0, RV_NV},          /* would be -1 */
        {TO_WU, RV_RDN, 0xbf000000, 0, 0, 0, RV_NV},
        {TO_WU, RV_RTZ, 0xbf7fffff, 0, 0, 0, RV_NX},
        {TO_WU, RV_RTZ, 0xbf800000, 0, 0, 0, RV_NV},
        {TO_WU, RV_RNE, INFINITE | MINUS, 0, 0, 0, RV_NV},
        {TO_WU, RV_RNE, LOUD, 0, 0, 0xffffffff, RV_NV},
    };
    (void)state;
    CHECK(table);
}

static void from_integers(void **state)
{
    static const struct known table[] = {
        {FROM_W, RV_RNE, 0, 0, 0, 0, 0},
        {FROM_W, RV_RDN, 0, 0, 0, 0, 0},
        {FROM_W, RV_RNE, 0xffffffff, 0, 0, ONE | MINUS, 0},
        {FROM_W, RV_RNE, 0x80000000, 0, 0, 0xcf000000, 0},
        {FROM_W, RV_RNE, 0x01000001, 0, 0, 0x4b800000, RV_NX}, /* 2^24 + 1: a tie */
        {FROM_W, RV_RMM, 0x01000001, 0, 0, 0x4b800001, RV_NX},
        {FROM_W, RV_RNE, 0x01000003, 0, 0, 0x4b800002, RV_NX},
        {FROM_W, RV_RDN, 0xfeffffff, 0, 0, 0xcb800001, RV_NX},
        {FROM_WU, RV_RNE, 0xffffffff, 0, 0, 0x4f800000, RV_NX},
        {FROM_WU, RV_RTZ, 0xffffffff, 0, 0, 0x4f7fffff, RV_NX},
        {FROM_WU, RV_RNE, 0x80000000, 0, 0, 0x4f000000, 0},
    };
    (void)state;
    CHECK(table);
}

static void order(void **state)
{
    static const struct known table[] = {
        {MIN, 0, 0, MINUS, 0, MINUS, 0},
        {MIN, 0, MINUS, 0, 0, MINUS, 0},
        {MAX, 0, 0, MINUS, 0, 0, 0},
        {MAX, 0, MINUS, 0, 0, 0, 0},
        {MIN, 0, ONE, ONE | MINUS, 0, ONE | MINUS, 0},
        {MAX, 0, INFINITE | MINUS, ONE | MINUS, 0, ONE | MINUS, 0},
        {MIN, 0, ONE, QUIET, 0, ONE, 0},
        {MAX, 0, QUIET, ONE, 0, ONE, 0},
        {MIN, 0, LOUD, ONE, 0, ONE, RV_NV},
        {MAX, 0, ONE, LOUD, 0, ONE, RV_NV},
        {MIN, 0, QUIET, QUIET | MINUS, 0, RV_NAN, 0},
        {MAX, 0, QUIET, LOUD, 0, RV_NAN, RV_NV},
        {EQ, 0, 0, MINUS, 0, 1, 0},
        {EQ, 0, QUIET, QUIET, 0, 0, 0},
        {EQ, 0, LOUD, ONE, 0, 0, RV_NV},
        {LT, 0, MINUS, 0, 0, 0, 0},
        {LT, 0, LEAST | MINUS, 0, 0, 1, 0},
        {LT, 0, QUIET, ONE, 0, 0, RV_NV},
        {LE, 0, 0, MINUS, 0, 1, 0},
        {LE, 0, ONE, QUIET, 0, 0, RV_NV},
        {LE, 0, INFINITE, INFINITE, 0, 1, 0},
    };
    (void)state;
    CHECK(table);
}

static void classes(void **state)
{
    (void)state;
    assert_int_equal(rv_fclass(INFINITE | MINUS), 1 << 0);
    assert_int_equal(rv_fclass(ONE | MINUS), 1 << 1);
    assert_int_equal(rv_fclass(LEAST | MINUS), 1 << 2);
    assert_int_equal(rv_fclass(MINUS), 1 << 3);
    assert_int_equal(rv_fclass(0), 1 << 4);
    assert_int_equal(rv_fclass(NORMAL - 1), 1 << 5);
    assert_int_equal(rv_fclass(NORMAL), 1 << 6);
    assert_int_equal(rv_fclass(INFINITE), 1 << 7);
    assert_int_equal(rv_fclass(LOUD | MINUS), 1 << 8);
    assert_int_equal(rv_fclass(QUIET), 1 << 9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rounding),
        cmocka_unit_test(overflow),
        cmocka_unit_test(underflow),
        cmocka_unit_test(zeros),
        cmocka_unit_test(infinities_and_nans),
        cmocka_unit_test(fused_rounds_once),
        cmocka_unit_test(to_integers),
        cmocka_unit_test(from_integers),
        cmocka_unit_test(order),
        cmocka_unit_test(classes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
