#include "roms/geometry/view3.h"

#include "roms/geometry/transform3.h"

bool view3(struct vector3 reference, struct vector3 normal, struct vector3 up, struct view3 *out)
{
    const float shortest = 1e-6f, flattest = 1e-3f;
    if (!(vector3_length(normal) >= shortest) || !(vector3_length(up) >= shortest))
        return false;
    struct view3 view = {.n = vector3_direction(normal)};
    struct vector3 right = vector3_cross(vector3_direction(up), view.n);
    if (!(vector3_length(right) >= flattest))
        return false;
    view.u = vector3_direction(right);
    view.v = vector3_cross(view.n, view.u);
    view.translate = transform3_translate(vector3_times(reference, -1));
    view.rotate = (struct matrix4){{{view.u.x, view.u.y, view.u.z, 0},
                                    {view.v.x, view.v.y, view.v.z, 0},
                                    {view.n.x, view.n.y, view.n.z, 0},
                                    {0, 0, 0, 1}}};
    view.matrix = matrix4_product(&view.rotate, &view.translate);
    *out = view;
    return true;
}
