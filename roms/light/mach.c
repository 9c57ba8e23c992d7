#include "roms/light/mach.h"

#include <math.h>

#include "roms/geometry/scalar.h"
#include "roms/light/power.h"

/* Of a point of the cylinder, 0…1 from its left edge to its right one: normals turn by 2.4 radians,
 * the light comes from 0.48 left of the eye. */
static float light_at(float place)
{
    float normal = (place - 0.5f) * 2.4f, light = -0.48f;
    float diffuse = scalar_max(cosf(normal - light), 0),
          specular = scalar_max(cosf(2 * normal - light), 0);
    return MACH_AMBIENT + 0.5f * diffuse + 0.35f * power(specular, 12);
}

float mach_intensity(int facets, bool interpolated, float place)
{
    facets = scalar_clamp_int(facets, 2, MACH_FACETS);
    float at = scalar_clamp(place, 0, 1) * (float)facets;
    int facet = scalar_clamp_int((int)at, 0, facets - 1);
    float left = light_at((float)facet / (float)facets);
    float right = light_at((float)(facet + 1) / (float)facets);
    if (!interpolated)
        return light_at(((float)facet + 0.5f) / (float)facets);
    return left + (right - left) * (at - (float)facet);
}

void mach_profile(int facets, bool interpolated, float *intensity, int count)
{
    count = scalar_clamp_int(count, 2, MACH_SAMPLES);
    for (int i = 0; i < count; i++)
        intensity[i] = mach_intensity(facets, interpolated, (float)i / (float)(count - 1));
}

void mach_seen(const float *intensity, float *seen, int count)
{
    count = scalar_clamp_int(count, 2, MACH_SAMPLES);
    for (int i = 0; i < count; i++) {
        float sum = 0;
        for (int k = -MACH_REACH; k <= MACH_REACH; k++)
            sum += intensity[scalar_clamp_int(i + k, 0, count - 1)];
        float mean = sum / (2 * MACH_REACH + 1);
        seen[i] = intensity[i] + MACH_INHIBITION * (intensity[i] - mean);
    }
}
