#include "roms/geometry/transform3.h"

#include <math.h>

#include "roms/geometry/scalar.h"

void transform3_step(struct transform3 *t, const char *name, struct matrix4 matrix)
{
    t->step[t->steps].name = name;
    t->step[t->steps].matrix = matrix;
    t->matrix = t->steps == 0 ? matrix : matrix4_product(&matrix, &t->matrix);
    t->steps++;
}

struct matrix4 transform3_translate(struct vector3 by)
{
    return (struct matrix4){{{1, 0, 0, by.x}, {0, 1, 0, by.y}, {0, 0, 1, by.z}, {0, 0, 0, 1}}};
}

struct matrix4 transform3_scale(struct vector3 k)
{
    return (struct matrix4){{{k.x, 0, 0, 0}, {0, k.y, 0, 0}, {0, 0, k.z, 0}, {0, 0, 0, 1}}};
}

struct matrix4 transform3_turn(enum axis3 axis, float sine, float cosine)
{
    struct matrix4 m = matrix4_identity();
    int from = ((int)axis + 1) % 3, to = ((int)axis + 2) % 3; /* y to z, z to x, x to y */
    m.at[from][from] = m.at[to][to] = cosine;
    m.at[from][to] = -sine;
    m.at[to][from] = sine;
    return m;
}

struct matrix4 transform3_rotate(enum axis3 axis, float degrees)
{
    struct sine_cosine of = scalar_sine_cosine(degrees);
    return transform3_turn(axis, of.sine, of.cosine);
}

struct matrix4 transform3_reflect_axis(enum axis3 axis)
{
    return transform3_turn(axis, 0, -1);
}

struct matrix4 transform3_reflect_plane(enum plane3 plane)
{
    static const struct vector3 signs[] = {
        [PLANE3_XY] = {1, 1, -1}, [PLANE3_YZ] = {-1, 1, 1}, [PLANE3_XZ] = {1, -1, 1}};
    return transform3_scale(signs[plane]);
}

struct matrix4 transform3_shear(enum axis3 axis, float a, float b)
{
    struct matrix4 m = matrix4_identity();
    m.at[axis == AXIS3_X ? 1 : 0][axis] = a;
    m.at[axis == AXIS3_Z ? 1 : 2][axis] = b;
    return m;
}

/* `middle` done where `fixed` is the origin. */
static struct transform3 about(struct vector3 fixed, const char *name, struct matrix4 middle)
{
    struct transform3 t = {.steps = 0};
    transform3_step(&t, "T", transform3_translate(vector3_times(fixed, -1)));
    transform3_step(&t, name, middle);
    transform3_step(&t, "T^-1", transform3_translate(fixed));
    return t;
}

struct transform3 transform3_scale_about(struct vector3 factors, struct vector3 fixed)
{
    return about(fixed, "S", transform3_scale(factors));
}

struct transform3 transform3_rotate_parallel(enum axis3 axis, float degrees, struct vector3 through)
{
    static const char *const names[] = {"Rx", "Ry", "Rz"};
    return about(through, names[axis], transform3_rotate(axis, degrees));
}

float transform3_determinant(const struct matrix4 *m)
{
    struct vector3 row[3];
    for (int i = 0; i < 3; i++)
        row[i] = (struct vector3){m->at[i][0], m->at[i][1], m->at[i][2]};
    return vector3_dot(row[0], vector3_cross(row[1], row[2]));
}
