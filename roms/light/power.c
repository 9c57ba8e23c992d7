#include "roms/light/power.h"

#include <math.h>

#include "roms/geometry/scalar.h"

float power(float x, float n)
{
    x = scalar_clamp(x, 0, 1);
    unsigned digits =
        (unsigned)(scalar_clamp(n, POWER_LEAST, POWER_MOST) * (1 << POWER_DIGITS) + 0.5f);
    float result = 1, factor = x, root = x;
    for (unsigned whole = digits >> POWER_DIGITS; whole != 0; whole >>= 1) {
        if (whole & 1)
            result *= factor;
        factor *= factor;
    }
    for (unsigned part = digits << (32 - POWER_DIGITS); part != 0; part <<= 1) {
        root = sqrtf(root);
        if (part >> 31)
            result *= root;
    }
    return result;
}

void power_table(struct power_table *t, float n)
{
    n = scalar_clamp(n, POWER_LEAST, POWER_MOST);
    if (t->n == n)
        return;
    t->n = n;
    t->low = 0;
    for (int k = 0; k < POWER_STEPS + 2; k++) {
        float x = (float)k / POWER_STEPS;
        t->at[k] = power(x, n);
        if (t->at[k] < 1.0f / 512)
            t->low = x;
    }
}
