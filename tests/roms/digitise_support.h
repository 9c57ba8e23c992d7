/* digitise_support.h — noise for the tests of roms/digitise; after curves_support.h. */
#ifndef TESTS_ROMS_DIGITISE_SUPPORT_H
#define TESTS_ROMS_DIGITISE_SUPPORT_H

#define TEST_PI 3.14159265358979323846

/* Irwin and Hall's: near enough to normal. */
static inline double normal(void)
{
    double sum = -6;
    for (int i = 0; i < 12; i++)
        sum += (double)random_in(0, 1);
    return sum;
}

#endif
