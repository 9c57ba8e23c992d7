#include "roms/curves/tridiagonal.h"

void tridiagonal_solve(const float *a, float *b, const float *c, struct vector3 *r, int count)
{
    for (int i = 1; i < count; i++) {
        float factor = a[i] / b[i - 1];
        b[i] -= factor * c[i - 1];
        r[i] = vector3_difference(r[i], vector3_times(r[i - 1], factor));
    }
    for (int i = count - 1; i >= 0; i--) {
        if (i + 1 < count)
            r[i] = vector3_difference(r[i], vector3_times(r[i + 1], c[i]));
        r[i] = vector3_times(r[i], 1 / b[i]);
    }
}
