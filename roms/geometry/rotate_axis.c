#include "roms/geometry/rotate_axis.h"

#include <math.h>

bool rotate_axis(struct vector3 p1, struct vector3 p2, float degrees, struct rotate_axis *out)
{
    struct vector3 along = vector3_difference(p2, p1);
    if (!(vector3_length(along) >= ROTATE_AXIS_SHORTEST))
        return false;
    struct rotate_axis r = {.direction = vector3_direction(along)};
    float a = r.direction.x, b = r.direction.y, c = r.direction.z;
    r.d = sqrtf(b * b + c * c);
    r.sine_alpha = r.d > 0 ? b / r.d : 0;
    r.cosine_alpha = r.d > 0 ? c / r.d : 1;
    r.sine_beta = a;
    r.cosine_beta = r.d;

    struct transform3 *t = &r.transform;
    transform3_step(t, "T", transform3_translate(vector3_times(p1, -1)));
    transform3_step(t, "Rx", transform3_turn(AXIS3_X, r.sine_alpha, r.cosine_alpha));
    transform3_step(t, "Ry", transform3_turn(AXIS3_Y, -r.sine_beta, r.cosine_beta));
    transform3_step(t, "Rz", transform3_rotate(AXIS3_Z, degrees));
    transform3_step(t, "Ry^-1", transform3_turn(AXIS3_Y, r.sine_beta, r.cosine_beta));
    transform3_step(t, "Rx^-1", transform3_turn(AXIS3_X, -r.sine_alpha, r.cosine_alpha));
    transform3_step(t, "T^-1", transform3_translate(p1));
    *out = r;
    return true;
}
