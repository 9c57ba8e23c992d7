#include "crt/white.h"

/* X and Z of a light of luminance 1. */
static void tristimulus(struct crt_chromaticity c, double *x, double *z)
{
    *x = c.x / c.y;
    *z = (1 - c.x - c.y) / c.y;
}

bool crt_white_shares(const struct crt_phosphor *phosphor, double share[3])
{
    double x[3], z[3], wx, wz;
    if (phosphor->colours != 3)
        return false;
    tristimulus((struct crt_chromaticity){CRT_D65_X, CRT_D65_Y}, &wx, &wz);
    for (int c = 0; c < 3; c++) {
        tristimulus(phosphor->colour[c], &x[c], &z[c]);
        x[c] -= wx;
        z[c] -= wz;
    }
    /* The shares are as the cross products of the others' ways from white. */
    double sum = 0;
    for (int c = 0; c < 3; c++) {
        int a = (c + 1) % 3, b = (c + 2) % 3;
        share[c] = x[a] * z[b] - x[b] * z[a];
        sum += share[c];
    }
    for (int c = 0; c < 3; c++) {
        share[c] /= sum; /* 0/0 is no number and fails below */
        if (!(share[c] >= 0 && share[c] <= 1))
            return false;
    }
    return true;
}
