#include "roms/curves/bezier.h"

float bezier_binomial(int n, int k)
{
    float c = 1;
    for (int i = 1; i <= k; i++)
        c = c * (float)(n - k + i) / (float)i;
    return c;
}

void bezier_blending(int n, float u, float value[])
{
    float power = 1;
    for (int k = 0; k <= n; k++, power *= u)
        value[k] = bezier_binomial(n, k) * power;
    power = 1;
    for (int k = n; k >= 0; k--, power *= 1 - u)
        value[k] *= power;
}

struct vector3 bezier_point(const struct vector3 *points, int count, float u)
{
    float value[BEZIER_POINTS_MOST];
    struct vector3 p = {0, 0, 0};
    bezier_blending(count - 1, u, value);
    for (int k = 0; k < count; k++)
        p = vector3_sum(p, vector3_times(points[k], value[k]));
    return p;
}

struct vector3 bezier_derivative(const struct vector3 *points, int count, float u)
{
    struct vector3 leg[BEZIER_POINTS_MOST];
    if (count < 2)
        return (struct vector3){0, 0, 0};
    for (int k = 0; k + 1 < count; k++)
        leg[k] = vector3_times(vector3_difference(points[k + 1], points[k]), (float)(count - 1));
    return bezier_point(leg, count - 1, u);
}

/* n(n−1)[(c − b) − (b − a)]. */
static struct vector3 bezier_bend(struct vector3 a, struct vector3 b, struct vector3 c,
                                  float factor)
{
    struct vector3 turn = vector3_difference(vector3_difference(c, b), vector3_difference(b, a));
    return vector3_times(turn, factor);
}

struct bezier_ends bezier_ends(const struct vector3 *p, int count)
{
    struct bezier_ends e = {0};
    int n = count - 1;
    float degree = (float)n;
    if (n >= 1) {
        e.first0 = vector3_times(vector3_difference(p[1], p[0]), degree);
        e.first1 = vector3_times(vector3_difference(p[n], p[n - 1]), degree);
    }
    if (n >= 2) {
        e.second0 = bezier_bend(p[0], p[1], p[2], degree * (degree - 1));
        e.second1 = bezier_bend(p[n], p[n - 1], p[n - 2], degree * (degree - 1));
    }
    return e;
}
