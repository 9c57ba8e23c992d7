#include "roms/curves/cubic.h"

struct vector3 cubic_point(const struct cubic *q, float u)
{
    struct vector3 p = vector3_sum(vector3_times(q->a, u), q->b);
    p = vector3_sum(vector3_times(p, u), q->c);
    return vector3_sum(vector3_times(p, u), q->d);
}

struct vector3 cubic_derivative(const struct cubic *q, int order, float u)
{
    if (order == 2)
        return vector3_sum(vector3_times(q->a, 6 * u), vector3_times(q->b, 2));
    struct vector3 p = vector3_sum(vector3_times(q->a, 3 * u), vector3_times(q->b, 2));
    return vector3_sum(vector3_times(p, u), q->c);
}

int cubic_steps(const struct cubic *q, float tolerance)
{
    float start = vector3_length(cubic_derivative(q, 2, 0));
    float end = vector3_length(cubic_derivative(q, 2, 1));
    float steps = ceilf(sqrtf((start > end ? start : end) / (8 * tolerance)));
    if (!(steps < CUBIC_STEPS_MOST))
        return CUBIC_STEPS_MOST;
    return steps > 1 ? (int)steps : 1;
}

void cubic_run_begin(struct cubic_run *run, const struct cubic *q, int steps)
{
    float h = 1.0f / (float)steps;
    struct vector3 a = vector3_times(q->a, h * h * h), b = vector3_times(q->b, h * h);
    run->at = q->d;
    run->d1 = vector3_sum(vector3_sum(a, b), vector3_times(q->c, h));
    run->d2 = vector3_sum(vector3_times(a, 6), vector3_times(b, 2));
    run->d3 = vector3_times(a, 6);
    run->left = steps + 1;
}
