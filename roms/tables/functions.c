/* The C library's functions of floats, and doubles, which are instructions for whole numbers here. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "roms/bsp/csr.h"
#include "roms/tables/tables.h"

static uint32_t bits_of(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

/* sqrtf itself becomes an instruction; the others are code. */
static float root(float x)
{
    return sqrtf(x);
}

static float power(float x)
{
    return powf(fabsf(x), 1.7f);
}

static float angle(float x)
{
    return atan2f(x, 0.75f);
}

static const struct {
    const char *name;
    float (*run)(float x);
} functions[] = {
    {"sqrtf", root},   {"sinf", sinf},     {"cosf", cosf},   {"tanf", tanf},
    {"atan2f", angle}, {"expf", expf},     {"logf", logf},   {"powf", power},
    {"cbrtf", cbrtf},  {"floorf", floorf}, {"rintf", rintf}, {"asinf", asinf},
};

static void check_sums(void)
{
    printf("functions: check sum, then of 0, 0.5, -2, 10, 1e10\n");
    for (unsigned i = 0; i < sizeof functions / sizeof *functions; i++) {
        static const float some[] = {0.0f, 0.5f, -2.0f, 10.0f, 1e10f};
        uint32_t sum = TABLES_SUM_START;
        csr_write_fcsr(0);
        for (int k = -400; k <= 400; k++)
            sum = tables_sum(sum, bits_of(functions[i].run((float)k * 0.0371f)));
        sum = tables_sum(sum, csr_read_fcsr());
        printf("%-7s %08lx", functions[i].name, (unsigned long)sum);
        for (unsigned k = 0; k < sizeof some / sizeof *some; k++)
            printf(" %08lx", (unsigned long)bits_of(functions[i].run(some[k])));
        printf("\n");
    }
    csr_write_fcsr(0);
}

/* Doubles are computed by the compiler's library in whole numbers. */
static void doubles(void)
{
    volatile double x = 1.0;
    printf("doubles\n");
    for (int i = 1; i <= 8; i++) {
        x = x * 1.75 + 1.0 / i - (double)(float)x * 0.125;
        printf("%d %.12g %.6e %.3f\n", i, x, 1e-3 / x, x * 1e4);
    }
}

void tables_functions(void)
{
    check_sums();
    doubles();
}
