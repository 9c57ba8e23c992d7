#include "roms/light/fresnel.h"

#include <math.h>

#include "roms/geometry/scalar.h"

float fresnel(float index, float cosine)
{
    float in = scalar_clamp(cosine, 0, 1);
    float sine2 = (1 - in * in) / (index * index); /* of the angle beyond the surface */
    if (sine2 >= 1)
        return 1; /* total reflection */
    float out = sqrtf(1 - sine2);
    float across = (in - index * out) / (in + index * out);
    float along = (index * in - out) / (index * in + out);
    return (across * across + along * along) / 2;
}

float fresnel_schlick(float index, float cosine)
{
    float r = (index - 1) / (index + 1), straight = r * r;
    float c = 1 - scalar_clamp(cosine, 0, 1), c2 = c * c;
    return straight + (1 - straight) * c2 * c2 * c;
}
