/* Single-precision arithmetic against exact arithmetic (MPFR): every operation in every mode, on all
 * pairs and half the triples of a table of awkward numbers and on random operands, result and flags. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "emu/cpu/rv_float.h"
#include "tests/cpu/float_operands.h"
#include "tests/cpu/float_oracle.h"

enum { MODES = 5, ALL_FLAGS = RV_NX | RV_UF | RV_OF | RV_DZ | RV_NV };

static const char *const mode_names[MODES] = {"rne", "rtz", "rdn", "rup", "rmm"};

/* What was met: a test whose operands never reach a case has not tested it. */
struct tally {
    uint64_t checks, clean; /* all; without any flag */
    uint64_t flag[5];       /* from RV_NX up */
};

static struct oracle oracle;

static int set_up(void **state)
{
    (void)state;
    oracle_init(&oracle);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    oracle_clear(&oracle);
    return 0;
}

/* Less is tried where sanitizers make everything slow: an eighth. */
static bool slow(void)
{
    const char *mode = getenv("TEST_MODE");
    return mode && (strcmp(mode, "asan") == 0 || strcmp(mode, "tsan") == 0);
}

static unsigned rounds(unsigned full)
{
    return slow() ? full / 8 : full;
}

static void expect(const char *name, unsigned rm, const struct operands *o, uint32_t bits,
                   uint32_t flags, struct oracle_result want)
{
    if (bits == want.bits && flags == want.flags)
        return;
    fail_msg("%s %s of %08x %08x %08x: %08x flags %02x, must be %08x flags %02x", name,
             mode_names[rm], (unsigned)o->a, (unsigned)o->b, (unsigned)o->c, (unsigned)bits,
             (unsigned)flags, (unsigned)want.bits, (unsigned)want.flags);
}

static void count(struct tally *t, uint32_t flags)
{
    t->checks++;
    t->clean += flags == 0;
    for (int i = 0; i < 5; i++)
        t->flag[i] += flags >> i & 1;
}

/* Each of the flags that the operation can raise was raised often, and no other. */
static void assert_tally(const char *name, const struct tally *t, uint32_t possible)
{
    print_message("%-9s %9llu checks; NX %llu UF %llu OF %llu DZ %llu NV %llu none %llu\n", name,
                  (unsigned long long)t->checks, (unsigned long long)t->flag[0],
                  (unsigned long long)t->flag[1], (unsigned long long)t->flag[2],
                  (unsigned long long)t->flag[3], (unsigned long long)t->flag[4],
                  (unsigned long long)t->clean);
    assert_true(t->clean > 1000);
    for (int i = 0; i < 5; i++) {
        if (possible >> i & 1)
            assert_true(t->flag[i] > 200);
        else
            assert_int_equal(t->flag[i], 0);
    }
}

static uint32_t ours(enum oracle_op op, const struct operands *o, unsigned rm, uint32_t *flags)
{
    switch (op) {
    case ORACLE_ADD:
        return rv_fadd(o->a, o->b, rm, flags);
    case ORACLE_SUB:
        return rv_fsub(o->a, o->b, rm, flags);
    case ORACLE_MUL:
        return rv_fmul(o->a, o->b, rm, flags);
    case ORACLE_DIV:
        return rv_fdiv(o->a, o->b, rm, flags);
    case ORACLE_SQRT:
        return rv_fsqrt(o->a, rm, flags);
    default:
        return rv_fmadd(o->a, o->b, o->c, rm, flags);
    }
}

static const char *const op_names[] = {"fadd", "fsub", "fmul", "fdiv", "fsqrt", "fmadd"};

static void check_modes(enum oracle_op op, struct operands o, struct tally *t)
{
    if (op == ORACLE_SQRT)
        o.b = 0;
    if (op != ORACLE_FMADD)
        o.c = 0;
    oracle_compute(&oracle, op, o.a, o.b, o.c);
    for (unsigned rm = 0; rm < MODES; rm++) {
        uint32_t flags = 0, bits = ours(op, &o, rm, &flags);
        expect(op_names[op], rm, &o, bits, flags, oracle_round(&oracle, rm));
        count(t, flags);
    }
}

/* All pairs of the table; for the fused operation, every other triple. */
static void check_table(enum oracle_op op, struct tally *t)
{
    struct operands o = {0, 0, 0};
    unsigned seconds = op == ORACLE_SQRT ? 1 : OPERAND_TABLE;
    unsigned thirds = op == ORACLE_FMADD ? OPERAND_TABLE : 1;
    unsigned stride = slow() ? 8 : 2; /* of the triples, another half for each pair */

    for (unsigned i = 0; i < OPERAND_TABLE; i++) {
        for (unsigned j = 0; j < seconds; j++) {
            for (unsigned k = (i + j) % stride % thirds; k < thirds; k += stride) {
                o.a = operand_from_table(i);
                o.b = operand_from_table(j);
                o.c = operand_from_table(k);
                check_modes(op, o, t);
            }
        }
    }
}

static void check_op(enum oracle_op op, unsigned random, uint32_t possible)
{
    struct tally t = {0};
    uint64_t state = 0x9e3779b97f4a7c15 + op;

    check_table(op, &t);
    for (unsigned i = 0; i < rounds(random); i++)
        check_modes(op, operands_next(&state), &t);
    assert_tally(op_names[op], &t, possible);
}

/* A sum or difference is never inexact when subnormal: no underflow. */
static void sums(void **state)
{
    (void)state;
    check_op(ORACLE_ADD, 400000, RV_NX | RV_OF | RV_NV);
    check_op(ORACLE_SUB, 400000, RV_NX | RV_OF | RV_NV);
}

static void products(void **state)
{
    (void)state;
    check_op(ORACLE_MUL, 400000, RV_NX | RV_UF | RV_OF | RV_NV);
}

static void quotients(void **state)
{
    (void)state;
    check_op(ORACLE_DIV, 400000, ALL_FLAGS);
}

static void roots(void **state)
{
    (void)state;
    check_op(ORACLE_SQRT, 400000, RV_NX | RV_NV);
}

static void fused(void **state)
{
    (void)state;
    check_op(ORACLE_FMADD, 800000, RV_NX | RV_UF | RV_OF | RV_NV);
}

static void check_to_integer(uint32_t a, struct tally *t)
{
    struct operands o = {a, 0, 0};

    for (unsigned rm = 0; rm < MODES; rm++) {
        uint32_t flags = 0, bits = rv_fcvt_w(a, rm, &flags);
        expect("fcvt.w.s", rm, &o, bits, flags, oracle_to_integer(&oracle, a, true, rm));
        count(t, flags);
        flags = 0;
        bits = rv_fcvt_wu(a, rm, &flags);
        expect("fcvt.wu.s", rm, &o, bits, flags, oracle_to_integer(&oracle, a, false, rm));
        count(t, flags);
    }
}

/* The table; every exponent with every pattern of the highest bits and of the lowest; random ones. */
static void to_integers(void **state)
{
    static const uint32_t fractions[] = {0,        1,        0x7fffff, 0x400000,
                                         0x400001, 0x3fffff, 0x200000, 0x600000,
                                         0x100000, 0x700000, 0x7ffffe, 0x2aaaaa};
    struct tally t = {0};
    uint64_t seed = 0x12345678;

    (void)state;
    for (unsigned i = 0; i < OPERAND_TABLE; i++)
        check_to_integer(operand_from_table(i), &t);
    for (uint32_t top = 0; top < 512; top++) {
        for (size_t i = 0; i < sizeof fractions / sizeof fractions[0]; i++)
            check_to_integer(top << 23 | fractions[i], &t);
    }
    for (unsigned i = 0; i < rounds(300000); i++)
        check_to_integer(operands_next(&seed).a, &t);
    assert_tally("fcvt.w[u]", &t, RV_NX | RV_NV);
}

static void check_from_integer(uint32_t a, struct tally *t)
{
    struct operands o = {a, 0, 0};

    for (unsigned rm = 0; rm < MODES; rm++) {
        uint32_t flags = 0, bits = rv_fcvt_from_w(a, rm, &flags);
        expect("fcvt.s.w", rm, &o, bits, flags, oracle_from_integer(&oracle, a, true, rm));
        count(t, flags);
        flags = 0;
        bits = rv_fcvt_from_wu(a, rm, &flags);
        expect("fcvt.s.wu", rm, &o, bits, flags, oracle_from_integer(&oracle, a, false, rm));
        count(t, flags);
    }
}

/* About every power of two and every halfway case of it, and random integers of all lengths. */
static void from_integers(void **state)
{
    struct tally t = {0};
    uint64_t seed = 0x87654321;

    (void)state;
    for (unsigned bit = 0; bit < 32; bit++) {
        for (unsigned half = 0; half < 32; half++) {
            for (uint32_t near = 0; near < 7; near++) {
                uint32_t a = (1u << bit | 1u << half) + near - 3;
                check_from_integer(a, &t);
                check_from_integer(0 - a, &t);
                check_from_integer(~(0xffffffffu << bit) << half, &t);
            }
        }
    }
    for (unsigned i = 0; i < rounds(200000); i++) {
        uint32_t a = operand_random(&seed);
        check_from_integer(a >> (a & 31), &t);
    }
    assert_tally("fcvt.s", &t, RV_NX);
}

/* By the host's comparison of doubles, which hold every single. */
static void check_order(uint32_t a, uint32_t b)
{
    float fa = oracle_float(a), fb = oracle_float(b);
    struct operands o = {a, b, 0};
    bool nan = isnan(fa) || isnan(fb);
    uint32_t loud = nan ? RV_NV : 0;
    uint32_t quiet = oracle_signalling(a) || oracle_signalling(b) ? RV_NV : 0;
    bool below = !nan && isless((double)fa, (double)fb);
    bool same = !nan && !isless((double)fa, (double)fb) && !isgreater((double)fa, (double)fb);
    bool a_first = below || (same && signbit(fa)); /* −0 before +0 */
    uint32_t low = a_first ? a : b, high = a_first ? b : a, flags;

    if (nan) {
        low = !isnan(fa) ? a : !isnan(fb) ? b : 0x7fc00000;
        high = low;
    }
#define ORDER(function, result, wanted_flags)                                                      \
    flags = 0;                                                                                     \
    {                                                                                              \
        uint32_t bits = function(a, b, &flags);                                                    \
        expect(#function, 0, &o, bits, flags, (struct oracle_result){result, wanted_flags});       \
    }
    ORDER(rv_fmin, low, quiet)
    ORDER(rv_fmax, high, quiet)
    ORDER(rv_feq, same, quiet)
    ORDER(rv_flt, below, loud)
    ORDER(rv_fle, below || same, loud)
#undef ORDER
}

static void order(void **state)
{
    uint64_t seed = 0xabcdef;

    (void)state;
    for (unsigned i = 0; i < OPERAND_TABLE; i++) {
        for (unsigned j = 0; j < OPERAND_TABLE; j++)
            check_order(operand_from_table(i), operand_from_table(j));
    }
    for (unsigned i = 0; i < rounds(1000000); i++) {
        struct operands o = operands_next(&seed);
        check_order(o.a, o.b);
        check_order(o.a, o.a + (o.c & 7) - 3);
    }
}

/* The manual's table of classes. */
static uint32_t class_of(uint32_t a)
{
    float f = oracle_float(a);
    bool sign = signbit(f) != 0;

    switch (fpclassify(f)) {
    case FP_INFINITE:
        return sign ? 0x001 : 0x080;
    case FP_NORMAL:
        return sign ? 0x002 : 0x040;
    case FP_SUBNORMAL:
        return sign ? 0x004 : 0x020;
    case FP_ZERO:
        return sign ? 0x008 : 0x010;
    default:
        return oracle_signalling(a) ? 0x100 : 0x200;
    }
}

static void classes(void **state)
{
    uint64_t seed = 99;

    (void)state;
    for (unsigned i = 0; i < OPERAND_TABLE; i++)
        assert_int_equal(rv_fclass(operand_from_table(i)), class_of(operand_from_table(i)));
    for (unsigned i = 0; i < rounds(1000000); i++) {
        uint32_t a = operands_next(&seed).a;
        assert_int_equal(rv_fclass(a), class_of(a));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sums),          cmocka_unit_test(products), cmocka_unit_test(quotients),
        cmocka_unit_test(roots),         cmocka_unit_test(fused),    cmocka_unit_test(to_integers),
        cmocka_unit_test(from_integers), cmocka_unit_test(order),    cmocka_unit_test(classes),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
