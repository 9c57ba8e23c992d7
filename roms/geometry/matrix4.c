#include "roms/geometry/matrix4.h"

#include <math.h>

struct matrix4 matrix4_identity(void)
{
    return (struct matrix4){{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
}

struct matrix4 matrix4_product(const struct matrix4 *a, const struct matrix4 *b)
{
    struct matrix4 p;
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 4; k++)
            p.at[i][k] = a->at[i][0] * b->at[0][k] + a->at[i][1] * b->at[1][k] +
                         a->at[i][2] * b->at[2][k] + a->at[i][3] * b->at[3][k];
    return p;
}

static float row_times(const float row[4], struct vector3 p)
{
    return row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3];
}

struct vector4 matrix4_homogeneous(const struct matrix4 *m, struct vector3 p)
{
    return (struct vector4){row_times(m->at[0], p), row_times(m->at[1], p), row_times(m->at[2], p),
                            row_times(m->at[3], p)};
}

struct vector3 matrix4_apply(const struct matrix4 *m, struct vector3 p)
{
    struct vector4 v = matrix4_homogeneous(m, p);
    if (v.h == 1)
        return (struct vector3){v.x, v.y, v.z};
    return (struct vector3){v.x / v.h, v.y / v.h, v.z / v.h};
}

struct vector3 matrix4_apply_direction(const struct matrix4 *m, struct vector3 v)
{
    struct vector3 row[3];
    for (int i = 0; i < 3; i++)
        row[i] = (struct vector3){m->at[i][0], m->at[i][1], m->at[i][2]};
    return (struct vector3){vector3_dot(row[0], v), vector3_dot(row[1], v), vector3_dot(row[2], v)};
}

static void exchange(float a[4], float b[4])
{
    for (int k = 0; k < 4; k++) {
        float t = a[k];
        a[k] = b[k];
        b[k] = t;
    }
}

static void subtract(float from[4], const float row[4], float factor)
{
    for (int k = 0; k < 4; k++)
        from[k] -= row[k] * factor;
}

bool matrix4_inverse(const struct matrix4 *m, struct matrix4 *out)
{
    struct matrix4 left = *m, right = matrix4_identity();
    for (int c = 0; c < 4; c++) {
        int pivot = c;
        for (int r = c + 1; r < 4; r++)
            if (fabsf(left.at[r][c]) > fabsf(left.at[pivot][c]))
                pivot = r;
        if (left.at[pivot][c] == 0)
            return false;
        exchange(left.at[c], left.at[pivot]);
        exchange(right.at[c], right.at[pivot]);
        for (int r = 0; r < 4; r++) {
            if (r == c)
                continue;
            float factor = left.at[r][c] / left.at[c][c];
            subtract(left.at[r], left.at[c], factor);
            subtract(right.at[r], right.at[c], factor);
        }
    }
    for (int r = 0; r < 4; r++)
        for (int k = 0; k < 4; k++)
            out->at[r][k] = right.at[r][k] / left.at[r][r];
    return true;
}
