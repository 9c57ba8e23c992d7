#include "input/noise.h"

#include <math.h>

#include "crt/maths.h"

#define TWO_PI 6.28318530717958648

static uint64_t mix(uint64_t z)
{
    z = (z ^ z >> 30) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ z >> 27) * UINT64_C(0x94D049BB133111EB);
    return z ^ z >> 31;
}

uint64_t inp_noise_bits(uint64_t seed, uint64_t count)
{
    return mix(mix(seed + UINT64_C(0x9E3779B97F4A7C15)) + count * UINT64_C(0x9E3779B97F4A7C15));
}

double inp_noise_even(uint64_t seed, uint64_t count)
{
    return ((double)(inp_noise_bits(seed, count) >> 11) + 0.5) / 9007199254740992.0;
}

double inp_noise_normal(uint64_t seed, uint64_t count)
{
    double radius = sqrt(-2 * crt_log(inp_noise_even(seed, 2 * count)));
    return radius * crt_cos(TWO_PI * inp_noise_even(seed, 2 * count + 1));
}
