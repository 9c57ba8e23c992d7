#include "roms/curves/key_frames.h"

#include "roms/curves/spline.h"
#include "roms/geometry/scalar.h"

/* From 0 to 1, slowly at both ends. */
static float slow_ends(float s)
{
    return s * s * (3 - 2 * s);
}

static int key_before(int keys, float t)
{
    return t >= (float)(keys - 2) ? keys - 2 : (int)t;
}

/* The spline through 0 … 0 1 0 … 0 says what a key counts at t; three keys are one spline in
 * space. */
static void spline_weights(int keys, float t, float weight[])
{
    struct vector3 unit[KEY_FRAMES_MOST];
    struct spline s;
    for (int k = 0; k < keys; k += 3) {
        for (int i = 0; i < keys; i++)
            unit[i] = (struct vector3){i == k, i == k + 1, i == k + 2};
        spline_natural(unit, keys, SPLINE_UNIFORM, &s);
        struct vector3 at = spline_point(&s, t);
        weight[k] = at.x;
        if (k + 1 < keys)
            weight[k + 1] = at.y;
        if (k + 2 < keys)
            weight[k + 2] = at.z;
    }
}

void key_weights(enum key_path path, int keys, float t, float weight[])
{
    t = scalar_clamp(t, 0, (float)(keys - 1));
    if (path == KEY_SPLINE) {
        spline_weights(keys, t, weight);
        return;
    }
    int before = key_before(keys, t);
    for (int k = 0; k < keys; k++)
        weight[k] = 0;
    weight[before + 1] = t - (float)before;
    weight[before] = 1 - weight[before + 1];
}

float key_time(enum key_timing timing, int keys, float time)
{
    float spans = (float)(keys - 1);
    time = scalar_clamp(time, 0, 1);
    if (timing == KEY_EASE)
        return slow_ends(time) * spans;
    float t = time * spans;
    if (timing == KEY_EVEN)
        return t;
    int before = key_before(keys, t);
    return (float)before + slow_ends(t - (float)before);
}
