/* penetration_model.h — the PENET17's colours worked out by hand, for tests.
 *
 * Units:      kV; luminance in parts of a green stroke's.
 */
#ifndef TESTS_PENETRATION_MODEL_H
#define TESTS_PENETRATION_MODEL_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>

#include "crt/penetration.h"

#define LEVELS 4

static const enum crt_level levels[LEVELS] = {CRT_LEVEL_RED, CRT_LEVEL_ORANGE, CRT_LEVEL_YELLOW,
                                              CRT_LEVEL_GREEN};
static const double kv[LEVELS] = {6, 8, 10, 12};
static const double deep[LEVELS] = {0, 7.0 / 27, 20.0 / 27, 1}; /* smoothstep at 0, 1/3, 2/3, 1 */

static inline const struct crt_tube_row *row(void)
{
    return crt_tube_row_find("PENET17");
}

static inline const struct crt_phosphor *p49(void)
{
    return crt_phosphor_find("P49");
}

static inline void near(double got, double expected, double part)
{
    if (!(fabs(got - expected) <= part * fabs(expected)))
        fail_msg("%.12g, expected %.12g", got, expected);
}

/* Luminance of each layer at a level, of a green stroke's 1. */
static inline void layers(int n, double y[2])
{
    double energy = pow((kv[n] - 2) / 10, 1.7);
    y[0] = energy * (1 - deep[n]) * 0.375 / 0.625;
    y[1] = energy * deep[n];
}

#endif
