/* exp, log, pow, erf, erfcx, sin, cos against the long double C library and against series. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <float.h>
#include <math.h>
#include <stdio.h>

#include "crt/maths.h"

#define BOUND 4e-15

/* Fails naming the argument; below the smallest normal number only an absolute error has a meaning.
 */
static void near(const char *what, double x, double got, long double want)
{
    long double error = fabsl(got - want);
    if (isnan(got) || error > BOUND * fabsl(want) + 5e-324L)
        fail_msg("%s(%.17g) = %.17g, expected %.17Lg, relative error %.2Lg", what, x, got, want,
                 error / fabsl(want));
}

/* A reproducible sequence in [0, 1). */
static double next(uint64_t *s)
{
    *s = *s * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (double)(*s >> 11) * 0x1p-53;
}

static void exponentials(void **state)
{
    (void)state;
    uint64_t s = 1;
    for (int i = 0; i < 200000; i++) {
        double x = -745 + 1454.7 * next(&s);
        near("exp", x, crt_exp(x), expl(x));
        near("expm1", x, crt_expm1(x), expm1l(x));
        x = (next(&s) - 0.5) * pow(10, 3 - 20 * next(&s));
        near("exp", x, crt_exp(x), expl(x));
        near("expm1", x, crt_expm1(x), expm1l(x));
    }
}

static void logarithms(void **state)
{
    (void)state;
    uint64_t s = 2;
    for (int i = 0; i < 200000; i++) {
        double x = pow(2, -1073 + 2096 * next(&s));
        near("log", x, crt_log(x), logl(x));
        x = 1 + (next(&s) - 0.5) * pow(10, -15 * next(&s));
        near("log", x, crt_log(x), logl(x));
    }
    near("log", 5e-324, crt_log(5e-324), logl(5e-324));
    near("log", DBL_MAX, crt_log(DBL_MAX), logl(DBL_MAX));
}

static void powers(void **state)
{
    (void)state;
    uint64_t s = 3;
    for (int i = 0; i < 200000; i++) {
        double x = pow(2, -1070 + 2090 * next(&s)), y = (next(&s) - 0.5) * 3;
        long double want = powl(x, y);
        if (want < DBL_MAX)
            near("pow", x, crt_pow(x, y), want);
        x = next(&s);
        y = 20 * next(&s);
        near("pow", x, crt_pow(x, y), powl(x, y));
        x = 1 + (next(&s) - 0.5) * 1e-6;
        y = (next(&s) - 0.5) * 2e9;
        want = powl(x, y);
        if (want < DBL_MAX)
            near("pow", x, crt_pow(x, y), want);
    }
}

static void error_function(void **state)
{
    (void)state;
    uint64_t s = 4;
    for (int i = 0; i < 200000; i++) {
        double x = (next(&s) - 0.5) * 14;
        near("erf", x, crt_erf(x), erfl(x));
        x = (next(&s) - 0.5) * pow(10, -300 * next(&s));
        near("erf", x, crt_erf(x), erfl(x));
    }
    /* 2^-10 either side of where one formula takes over from the other. */
    for (double x = 1 - 0x1p-10; x < 1 + 0x1p-10; x += 0x1p-16)
        near("erf", x, crt_erf(x), erfl(x));
}

/* e^(x²)·erfc(x) by backward evaluation of Laplace's continued fraction, x >= 2:
 * 1/√π · 1/(x + (1/2)/(x + 1/(x + (3/2)/(x + …)))). */
static long double erfcx_fraction(long double x)
{
    long double tail = x;
    for (int n = 400; n >= 1; n--)
        tail = x + n / 2.0L / tail;
    return 1 / (sqrtl(acosl(-1)) * tail);
}

static void scaled_complementary_error_function(void **state)
{
    (void)state;
    uint64_t s = 5;
    for (int i = 0; i < 20000; i++) {
        double x = 2 + 30 * next(&s);
        near("erfcx", x, crt_erfcx(x), erfcx_fraction(x));
        x = pow(10, 1 + 290 * next(&s));
        near("erfcx", x, crt_erfcx(x), erfcx_fraction(x));
    }
    /* Below 2 the product of the two long double functions keeps enough digits. */
    for (int i = 0; i < 200000; i++) {
        double x = -5 + 7 * next(&s);
        near("erfcx", x, crt_erfcx(x), expl((long double)x * x) * erfcl(x));
    }
    near("erfcx", 0, crt_erfcx(0), 1);
}

static void sines(void **state)
{
    (void)state;
    uint64_t s = 6;
    for (int i = 0; i < 200000; i++) {
        double x = (next(&s) - 0.5) * 2 * pow(10, 5 - 12 * next(&s));
        assert_true(fabsl(crt_sin(x) - sinl(x)) < BOUND);
        assert_true(fabsl(crt_cos(x) - cosl(x)) < BOUND);
    }
    for (int n = -1000; n <= 1000; n++) { /* next to the zeros */
        double x = n * acos(0);
        assert_true(fabsl(crt_sin(x) - sinl(x)) < BOUND);
        assert_true(fabsl(crt_cos(x) - cosl(x)) < BOUND);
    }
    near("sin", 1e-200, crt_sin(1e-200), 1e-200L);
    assert_true(fabs(crt_sin(1e300)) <= 1.0000000001);
    assert_true(fabs(crt_cos(-1e22)) <= 1.0000000001);
}

static void edges(void **state)
{
    (void)state;
    const double inf = INFINITY, not = NAN;
    assert_true(crt_exp(0) == 1 && crt_exp(inf) == inf && crt_exp(-inf) == 0);
    assert_true(crt_exp(710) == inf && crt_exp(-746) == 0 && crt_exp(709.78) < inf);
    assert_true(crt_exp(-745) > 0 && isnan(crt_exp(not )));
    assert_true(crt_expm1(0) == 0 && crt_expm1(inf) == inf && crt_expm1(-inf) == -1);
    assert_true(crt_expm1(5e-324) == 5e-324 && crt_expm1(800) == inf && isnan(crt_expm1(not )));
    assert_true(crt_log(1) == 0 && crt_log(0) == -inf && crt_log(inf) == inf);
    assert_true(isnan(crt_log(-1)) && isnan(crt_log(-inf)) && isnan(crt_log(not )));
    assert_true(crt_pow(0, 0) == 1 && crt_pow(not, 0) == 1 && crt_pow(1, not ) == 1);
    assert_true(crt_pow(0, 2) == 0 && crt_pow(0, -2) == inf && crt_pow(0, 0.5) == 0);
    assert_true(crt_pow(inf, 1) == inf && crt_pow(inf, -1) == 0 && crt_pow(1, inf) == 1);
    assert_true(crt_pow(2, inf) == inf && crt_pow(2, -inf) == 0);
    assert_true(crt_pow(0.5, inf) == 0 && crt_pow(0.5, -inf) == inf);
    assert_true(crt_pow(2, 1024) == inf && crt_pow(2, -1080) == 0 && crt_pow(2, 10) == 1024);
    assert_true(crt_pow(1 + 0x1p-52, 1e300) == inf && crt_pow(1 - 0x1p-53, 1e300) == 0);
    assert_true(isnan(crt_pow(-2, 2)) && isnan(crt_pow(not, 2)) && isnan(crt_pow(2, not )));
    assert_true(crt_erf(0) == 0 && crt_erf(inf) == 1 && crt_erf(-inf) == -1);
    assert_true(crt_erf(40) == 1 && crt_erf(-1e300) == -1 && isnan(crt_erf(not )));
    assert_true(crt_erfcx(inf) == 0 && crt_erfcx(-inf) == inf && isnan(crt_erfcx(not )));
    assert_true(crt_erfcx(-30) == inf && crt_erfcx(DBL_MAX) > 0);
    assert_true(crt_sin(0) == 0 && crt_cos(0) == 1);
    assert_true(isnan(crt_sin(inf)) && isnan(crt_cos(-inf)) && isnan(crt_sin(not )));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exponentials), cmocka_unit_test(logarithms),
        cmocka_unit_test(powers),       cmocka_unit_test(error_function),
        cmocka_unit_test(sines),        cmocka_unit_test(scaled_complementary_error_function),
        cmocka_unit_test(edges),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
