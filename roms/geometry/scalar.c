#include "roms/geometry/scalar.h"

#include <math.h>

struct sine_cosine scalar_sine_cosine(float degrees)
{
    float turn = fmodf(degrees, 360); /* exact */
    int quarter = scalar_nearest(turn / 90);
    float rest = (turn - (float)quarter * 90) * DEGREE;
    float s = sinf(rest), c = cosf(rest);
    switch (quarter & 3) {
    case 0:
        return (struct sine_cosine){0 + s, c};
    case 1:
        return (struct sine_cosine){c, 0 - s};
    case 2:
        return (struct sine_cosine){0 - s, -c};
    default:
        return (struct sine_cosine){-c, 0 + s};
    }
}
