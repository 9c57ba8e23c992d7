#include "crt/line_spot.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crt/maths.h"

#define TWO_PI 6.28318530717958648

/* The cut spot: e^(−z²/2) − c·(z/CUT)^8 with c = e^(−CUT²/2); divided by its area. */
static double edge_value(void)
{
    return crt_exp(-CRT_LINE_CUT * CRT_LINE_CUT / 2);
}

double crt_line_area(void)
{
    return sqrt(TWO_PI) * crt_erf(CRT_LINE_CUT / sqrt(2)) - 2 * edge_value() * CRT_LINE_CUT / 9;
}

/* ∫ z^k·spot from 0 to z, k = 0…2. */
static void integrals(double z, double sum[3])
{
    z = fmin(fmax(z, -CRT_LINE_CUT), CRT_LINE_CUT);
    double c = edge_value(), area = crt_line_area(), q = z / CRT_LINE_CUT, q2 = q * q;
    double q8 = q2 * q2 * q2 * q2, e = crt_exp(-z * z / 2);
    double half = sqrt(TWO_PI) / 2 * crt_erf(z / sqrt(2));
    sum[0] = (half - c * q8 * z / 9) / area;
    sum[1] = (1 - e - c * q8 * z * z / 10) / area;
    sum[2] = (half - z * e - c * q8 * z * z * z / 11) / area;
}

/* A dot whose centre is `off` dots before the column: what a0, 2·a1 and 4·a2 give, from the integrals at its two
 * ends. */
static void kernel_of(double off, double sigma, const double low[3], const double high[3],
                      double k[3])
{
    double a0 = high[0] - low[0], a1 = high[1] - low[1], a2 = high[2] - low[2];
    double b1 = 2 * off * a0 - 2 * sigma * a1;
    double b2 = 4 * off * off * a0 - 8 * off * sigma * a1 + 4 * sigma * sigma * a2;
    k[0] = a0;
    k[1] = 2 * b1;
    k[2] = 2 * (3 * b2 - a0);
}

/* One phase: rounded so that sums over neighbouring dots are rounded once. */
static void fill_phase(const struct crt_line_level *level, double sigma, double phase, int16_t *to)
{
    double low[3], high[3], k[3], sum[3] = {0};
    integrals((phase + level->reach + 0.5) / sigma, high);
    for (int t = 0; t < 2 * level->pairs; t++) {
        double off = phase + level->reach - t;
        integrals((off - 0.5) / sigma, low);
        kernel_of(off, sigma, low, high, k);
        for (int m = 0; m < 3; m++) {
            double before = floor(sum[m] * (1 << CRT_KERNEL_BITS) + 0.5);
            sum[m] += k[m];
            to[(t / 2 * 3 + m) * 2 + t % 2] =
                (int16_t)(floor(sum[m] * (1 << CRT_KERNEL_BITS) + 0.5) - before);
        }
        memcpy(high, low, sizeof high);
    }
}

bool crt_line_spot_level(struct crt_line_spot *spot, int index)
{
    struct crt_line_level *level = &spot->level[index];
    if (level->kernel)
        return true;
    double sigma = spot->sigma_dots * crt_exp((index - CRT_LEVEL_BASE) / CRT_LEVEL_STEPS);
    level->reach = (int)floor(CRT_LINE_CUT * sigma + 0.5);
    level->pairs = level->reach + 1;
    if (level->pairs < 4) { /* what kernels are made for */
        level->reach = 3;
        level->pairs = 4;
    }
    level->stride = (level->pairs * 6 + 15) / 16 * 16;
    int phases = (1 << spot->phase_bits) + 1;
    level->kernel = calloc((size_t)phases * (size_t)level->stride, sizeof level->kernel[0]);
    if (!level->kernel)
        return false;
    for (int i = 0; i < phases; i++)
        fill_phase(level, sigma, (double)i / (phases - 1), level->kernel + i * level->stride);
    return true;
}

struct crt_line_spot *crt_line_spot_new(double sigma_mm, double pitch_mm)
{
    struct crt_line_spot *spot = calloc(1, sizeof *spot);
    if (!spot)
        return NULL;
    spot->sigma_mm = sigma_mm;
    spot->sigma_dots = sigma_mm / pitch_mm;
    /* Between phases kernels are straight lines: 0.045 sigma apart that is good to 1e-4. */
    while (spot->phase_bits < 12 && 0.045 * spot->sigma_dots * (1 << spot->phase_bits) < 0.98)
        spot->phase_bits++;
    return spot;
}

void crt_line_spot_free(struct crt_line_spot *spot)
{
    for (int i = 0; spot && i < CRT_SIGMA_LEVELS; i++)
        free(spot->level[i].kernel);
    free(spot);
}
