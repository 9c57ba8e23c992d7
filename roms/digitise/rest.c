#include "roms/digitise/rest.h"

#include <math.h>

void rest_begin(struct rest *r)
{
    *r = (struct rest){0};
}

static int moved(const struct rest *r, const float place[3], float limit)
{
    return fabsf(place[0] - r->mean[0]) > limit || fabsf(place[1] - r->mean[1]) > limit;
}

void rest_take(struct rest *r, const float place[3], float limit)
{
    if (r->count > 0 && moved(r, place, limit))
        rest_begin(r);
    if (r->count == REST_MOST) /* as if it had been taken back: a window that forgets slowly */
        for (int i = 0; i < 3; i++)
            r->square[i] *= (float)(REST_MOST - 2) / (REST_MOST - 1);
    r->count += r->count < REST_MOST;
    for (int i = 0; i < 3; i++) {
        float off = place[i] - r->mean[i];
        r->mean[i] += off / (float)r->count;
        r->square[i] += off * (place[i] - r->mean[i]);
    }
}

float rest_deviation(const struct rest *r, int axis)
{
    return r->count > 1 ? sqrtf(r->square[axis] / (float)(r->count - 1)) : 0;
}
