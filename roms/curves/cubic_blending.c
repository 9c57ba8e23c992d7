/* cubic_blending.c — points as sums of geometry times blending functions. */
#include "roms/curves/cubic_kind.h"

/* v = 1 − u throughout. */
static void blend_hermite(float u, float v, float value[4])
{
    value[0] = (1 + 2 * u) * v * v;
    value[1] = u * u * (3 - 2 * u);
    value[2] = u * v * v;
    value[3] = -u * u * v;
}

static void blend_bezier(float u, float v, float value[4])
{
    value[0] = v * v * v;
    value[1] = 3 * u * v * v;
    value[2] = 3 * u * u * v;
    value[3] = u * u * u;
}

static void blend_cardinal(float u, float v, float s, float value[4])
{
    float in = s * u * v * v, out = s * u * u * v;
    value[0] = -in;
    value[1] = (1 + 2 * u) * v * v + out;
    value[2] = u * u * (3 - 2 * u) + in;
    value[3] = -out;
}

static void blend_b_spline(float u, float v, float value[4])
{
    value[0] = v * v * v / 6;
    value[1] = (4 - 3 * u * u * (1 + v)) / 6;
    value[2] = (4 - 3 * v * v * (1 + u)) / 6;
    value[3] = u * u * u / 6;
}

void cubic_blending(enum cubic_kind kind, float tension, float u, float value[4])
{
    switch (kind) {
    case CUBIC_BEZIER:
        blend_bezier(u, 1 - u, value);
        break;
    case CUBIC_CARDINAL:
        blend_cardinal(u, 1 - u, (1 - tension) / 2, value);
        break;
    case CUBIC_B_SPLINE:
        blend_b_spline(u, 1 - u, value);
        break;
    default:
        blend_hermite(u, 1 - u, value);
        break;
    }
}

struct vector3 cubic_by_blending(const struct cubic_geometry *geometry, float u)
{
    float value[4];
    struct vector3 p = {0, 0, 0};
    cubic_blending(geometry->kind, geometry->tension, u, value);
    for (int k = 0; k < 4; k++)
        p = vector3_sum(p, vector3_times(geometry->g[k], value[k]));
    return p;
}
