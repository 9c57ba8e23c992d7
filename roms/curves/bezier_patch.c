#include "roms/curves/bezier_patch.h"

#include "roms/curves/bezier.h"

/* Σ points[k · apart] · value[k]. */
static struct vector3 blend_four(const struct vector3 *points, int apart, const float value[4])
{
    struct vector3 p = {0, 0, 0};
    for (int k = 0; k < 4; k++)
        p = vector3_sum(p, vector3_times(points[k * apart], value[k]));
    return p;
}

void bezier_patch_along_v(const struct bezier_patch *patch, float u, struct vector3 curve[4])
{
    float value[4];
    bezier_blending(3, u, value);
    for (int k = 0; k < 4; k++)
        curve[k] = blend_four(&patch->at[0][k], 4, value);
}

void bezier_patch_along_u(const struct bezier_patch *patch, float v, struct vector3 curve[4])
{
    float value[4];
    bezier_blending(3, v, value);
    for (int j = 0; j < 4; j++)
        curve[j] = blend_four(&patch->at[j][0], 1, value);
}

struct vector3 bezier_patch_point(const struct bezier_patch *patch, float u, float v)
{
    struct vector3 curve[4];
    bezier_patch_along_v(patch, u, curve);
    return bezier_point(curve, 4, v);
}

static struct vector3 patch_cross(const struct bezier_patch *patch, float u, float v)
{
    struct vector3 curve[4];
    bezier_patch_along_v(patch, u, curve);
    struct vector3 along_v = bezier_derivative(curve, 4, v);
    bezier_patch_along_u(patch, v, curve);
    return vector3_cross(along_v, bezier_derivative(curve, 4, u));
}

struct vector3 bezier_patch_normal(const struct bezier_patch *patch, float u, float v)
{
    enum { TRIES = 4 };
    float inward = 1 / 1024.0f, size = 0;
    for (int i = 0; i < 16; i++)
        size += vector3_length(vector3_difference(patch->at[i / 4][i % 4], patch->at[0][0]));
    struct vector3 n = patch_cross(patch, u, v);
    for (int i = 0; i < TRIES && vector3_length(n) <= 1e-6f * size * size; i++, inward *= 2)
        n = patch_cross(patch, u + (0.5f - u) * inward, v + (0.5f - v) * inward);
    return vector3_direction(n);
}
