#include "roms/curves/bezier_run.h"

#include "roms/curves/casteljau.h"

float bezier_flatness(const struct vector3 *p, int count)
{
    float most = 0;
    for (int k = 0; k + 2 < count; k++) {
        struct vector3 bend =
            vector3_sum(vector3_difference(p[k + 2], vector3_times(p[k + 1], 2)), p[k]);
        float length = vector3_length(bend);
        most = length > most ? length : most;
    }
    return (float)((count - 1) * (count - 2)) / 8 * most;
}

void bezier_run_begin(struct bezier_run *run, const struct vector3 *points, int count,
                      float tolerance)
{
    run->pieces = 1;
    run->depth[0] = 0;
    run->count = count;
    run->tolerance = tolerance;
    run->started = false;
    for (int k = 0; k < count; k++)
        run->waiting[0][k] = points[k];
}

/* The last piece becomes two; the first half comes last. */
static void halve(struct bezier_run *run)
{
    struct casteljau c;
    int last = run->pieces - 1;
    casteljau_begin(&c, run->waiting[last], run->count, 0.5f);
    while (casteljau_next(&c))
        continue;
    casteljau_halves(&c, run->waiting[last + 1], run->waiting[last]);
    run->depth[last]++;
    run->depth[last + 1] = run->depth[last];
    run->pieces++;
}

bool bezier_run_next(struct bezier_run *run, struct vector3 *out)
{
    if (!run->started) {
        run->started = true;
        *out = run->waiting[0][0];
        return true;
    }
    if (run->pieces == 0)
        return false;
    while (run->depth[run->pieces - 1] < BEZIER_RUN_DEPTH &&
           bezier_flatness(run->waiting[run->pieces - 1], run->count) > run->tolerance)
        halve(run);
    run->pieces--;
    *out = run->waiting[run->pieces][run->count - 1];
    return true;
}
