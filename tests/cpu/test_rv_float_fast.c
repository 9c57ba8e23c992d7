/* Floats from the host's float unit (rv_float_fast.h) against rv_float.h: whenever one is certain, it is
 * the same, and no flag but NX is raised; and ordinary operands are certain, or it would be of no use. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "emu/cpu/rv_float.h"
#include "emu/cpu/rv_float_fast.h"
#include "tests/cpu/float_operands.h"

#define SIGN 0x80000000u

struct operation {
    const char *name;
    bool (*fast)(const struct operands *o, uint32_t *r);
    uint32_t (*exact)(const struct operands *o, uint32_t *flags);
};

#define A rv_float_of(o->a)
#define B rv_float_of(o->b)
#define C rv_float_of(o->c)
#define OPERATION(name, fast_call, exact_call)                                                     \
    static bool fast_##name(const struct operands *o, uint32_t *bits)                              \
    {                                                                                              \
        float r;                                                                                   \
        bool certain = fast_call;                                                                  \
        *bits = rv_bits_of(r);                                                                     \
        return certain;                                                                            \
    }                                                                                              \
    static uint32_t exact_##name(const struct operands *o, uint32_t *flags)                        \
    {                                                                                              \
        return exact_call;                                                                         \
    }
OPERATION(add, rv_fast_add(A, B, &r), rv_fadd(o->a, o->b, RV_RNE, flags))
OPERATION(sub, rv_fast_sub(A, B, &r), rv_fsub(o->a, o->b, RV_RNE, flags))
OPERATION(mul, rv_fast_mul(A, B, &r), rv_fmul(o->a, o->b, RV_RNE, flags))
OPERATION(quotient, rv_fast_div(A, B, &r), rv_fdiv(o->a, o->b, RV_RNE, flags))
OPERATION(madd, rv_fast_fma((double)A *B, C, &r), rv_fmadd(o->a, o->b, o->c, RV_RNE, flags))
OPERATION(msub, rv_fast_fma((double)A *B, -C, &r), rv_fmadd(o->a, o->b, o->c ^ SIGN, RV_RNE, flags))
OPERATION(nmsub, rv_fast_fma(-((double)A *B), C, &r),
          rv_fmadd(o->a ^ SIGN, o->b, o->c, RV_RNE, flags))
OPERATION(nmadd, rv_fast_fma(-((double)A *B), -C, &r),
          rv_fmadd(o->a ^ SIGN, o->b, o->c ^ SIGN, RV_RNE, flags))

static bool fast_root(const struct operands *o, uint32_t *bits)
{
    float r = 0;
    bool certain = rv_fast_sqrt(A, &r);
    *bits = rv_bits_of(r);
    return certain;
}
static uint32_t exact_root(const struct operands *o, uint32_t *flags)
{
    return rv_fsqrt(o->a, RV_RNE, flags);
}
static bool fast_to_w(const struct operands *o, uint32_t *bits)
{
    return rv_fast_to_w(A, bits);
}
static uint32_t exact_to_w(const struct operands *o, uint32_t *flags)
{
    return rv_fcvt_w(o->a, RV_RTZ, flags);
}
static bool fast_to_wu(const struct operands *o, uint32_t *bits)
{
    return rv_fast_to_wu(A, bits);
}
static uint32_t exact_to_wu(const struct operands *o, uint32_t *flags)
{
    return rv_fcvt_wu(o->a, RV_RTZ, flags);
}

#define ROW(name)                                                                                  \
    {                                                                                              \
#name, fast_##name, exact_##name                                                           \
    }
static const struct operation operations[] = {
    ROW(add),  ROW(sub),   ROW(mul),   ROW(quotient), ROW(root),  ROW(madd),
    ROW(msub), ROW(nmsub), ROW(nmadd), ROW(to_w),     ROW(to_wu),
};
#define OPERATIONS (sizeof operations / sizeof operations[0])

static unsigned rounds(unsigned full)
{
    const char *mode = getenv("TEST_MODE");
    return mode && (strcmp(mode, "asan") == 0 || strcmp(mode, "tsan") == 0) ? full / 8 : full;
}

/* Whether the fast one was certain. */
static bool check(const struct operation *op, const struct operands *o)
{
    uint32_t fast = 0, flags = 0;
    if (!op->fast(o, &fast))
        return false;
    uint32_t exact = op->exact(o, &flags);
    if (fast != exact || (flags & ~(uint32_t)RV_NX) != 0)
        fail_msg("%s of %08x %08x %08x: %08x, must be %08x flags %02x", op->name, o->a, o->b, o->c,
                 fast, exact, flags);
    return true;
}

static void all_pairs_of_the_table(void **state)
{
    (void)state;
    for (unsigned i = 0; i < OPERAND_TABLE; i++)
        for (unsigned k = 0; k < OPERAND_TABLE; k++)
            for (size_t n = 0; n < OPERATIONS; n++) {
                struct operands o = {operand_from_table(i), operand_from_table(k), 0};
                for (unsigned c = 0; c < OPERAND_TABLE; c += n >= 5 && n < 9 ? 1 : OPERAND_TABLE) {
                    o.c = operand_from_table(c);
                    check(&operations[n], &o);
                }
            }
}

static void random_operands(void **state)
{
    uint64_t seed = 77;
    (void)state;
    for (unsigned i = 0; i < rounds(2000000); i++) {
        struct operands o = operands_next(&seed);
        for (size_t n = 0; n < OPERATIONS; n++)
            check(&operations[n], &o);
    }
}

/* Numbers of few bits: fused sums land on the middle between two floats, exactly or nearly. */
static void middles(void **state)
{
    uint64_t seed = 78;
    unsigned certain = 0, count = rounds(2000000);
    (void)state;
    for (unsigned i = 0; i < count; i++) {
        struct operands o;
        uint32_t r = operand_random(&seed), odd = operand_random(&seed);
        /* c about 1, the product about half a step of it, of one bit or a little off it */
        o.c = 0x3F800000u + (r & 0x7FFFFF);
        o.a = (0x33800000u + ((odd & 7) << 23)) | (odd & 0x100 ? 1u << (odd >> 9) % 23 : 0);
        o.b = 0x3F800000u | (r >> 23 & 3) << 21 | (odd & 0x200 ? odd >> 31 : 0);
        for (size_t n = 5; n < 9; n++)
            certain += check(&operations[n], &o);
    }
    assert_true(certain > 4 * count / 4);
}

/* Operands as programs have them. */
static void ordinary_operands_are_certain(void **state)
{
    uint64_t seed = 79;
    unsigned certain[OPERATIONS] = {0}, count = 100000;
    (void)state;
    for (unsigned i = 0; i < count; i++) {
        struct operands o = {operand_random(&seed), operand_random(&seed), operand_random(&seed)};
        o.a = (o.a & 0x807FFFFF) | (uint32_t)operand_within(&seed, 110, 150) << 23;
        o.b = (o.b & 0x807FFFFF) | (uint32_t)operand_within(&seed, 110, 150) << 23;
        o.c = (o.c & 0x807FFFFF) | (uint32_t)operand_within(&seed, 110, 150) << 23;
        for (size_t n = 0; n < OPERATIONS; n++) {
            if (n == 4 || n == 10) /* a root, and an integer without sign */
                o.a &= ~SIGN;
            certain[n] += check(&operations[n], &o);
        }
    }
    for (size_t n = 0; n < OPERATIONS; n++)
        assert_true(certain[n] > count / 1000 * 999);
    /* Zeroes are everywhere. */
    static const uint32_t zeroes[] = {0, SIGN};
    for (size_t i = 0; i < 2; i++) {
        struct operands o = {zeroes[i], 0x40000000, 0x3F800000},
                        p = {0x40000000, zeroes[i], zeroes[i]};
        for (size_t n = 0; n < OPERATIONS; n++)
            if (n != 4 && n != 10)
                assert_true(check(&operations[n], &o));
        for (size_t n = 0; n < OPERATIONS; n++)
            if (n != 3)
                assert_true(check(&operations[n], &p));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_pairs_of_the_table),
        cmocka_unit_test(random_operands),
        cmocka_unit_test(middles),
        cmocka_unit_test(ordinary_operands_are_certain),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
