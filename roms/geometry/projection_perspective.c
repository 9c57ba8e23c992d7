#include "roms/geometry/projection_perspective.h"

#include <math.h>

bool projection_perspective(struct vector3 prp, float zvp, struct matrix4 *out)
{
    float dp = prp.z - zvp;
    if (!(fabsf(dp) >= PERSPECTIVE_NEAREST))
        return false;
    *out = (struct matrix4){{{1, 0, -prp.x / dp, prp.x * zvp / dp},
                             {0, 1, -prp.y / dp, prp.y * zvp / dp},
                             {0, 0, -zvp / dp, zvp * prp.z / dp},
                             {0, 0, -1 / dp, prp.z / dp}}};
    return true;
}

bool projection_place(const struct matrix4 *projection, struct vector3 p, struct point2 *out)
{
    const float least = 1e-6f; /* what rounding leaves of 0 */
    struct vector4 v = matrix4_homogeneous(projection, p);
    if (!(v.h > least))
        return false;
    *out = (struct point2){v.x / v.h, v.y / v.h};
    return true;
}

bool projection_vanishing(const struct matrix4 *projection, struct vector3 direction,
                          struct point2 *out)
{
    const float flattest = 1e-6f; /* of the direction's slope to the view plane */
    const float *row = projection->at[3];
    float length = vector3_length((struct vector3){row[0], row[1], row[2]});
    struct vector3 d = vector3_direction(direction);
    float h = row[0] * d.x + row[1] * d.y + row[2] * d.z;
    if (!(fabsf(h) > flattest * length))
        return false;
    struct vector3 v = matrix4_apply_direction(projection, d);
    *out = (struct point2){v.x / h, v.y / h};
    return true;
}

struct vanishing projection_vanishing_axes(const struct matrix4 *projection)
{
    static const struct vector3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    struct vanishing v = {.count = 0};
    for (int i = 0; i < 3; i++) {
        v.has[i] = projection_vanishing(projection, axes[i], &v.at[i]);
        v.count += v.has[i];
    }
    return v;
}
