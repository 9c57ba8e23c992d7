#include "roms/geometry/transform2.h"

#include <math.h>

#include "roms/geometry/scalar.h"

struct matrix3 transform2_translate(float tx, float ty)
{
    return (struct matrix3){{{1, 0, tx}, {0, 1, ty}, {0, 0, 1}}};
}

struct matrix3 transform2_rotate(float degrees)
{
    struct sine_cosine d = scalar_sine_cosine(degrees);
    return (struct matrix3){{{d.cosine, 0 - d.sine, 0}, {d.sine, d.cosine, 0}, {0, 0, 1}}};
}

struct matrix3 transform2_scale(float sx, float sy)
{
    return (struct matrix3){{{sx, 0, 0}, {0, sy, 0}, {0, 0, 1}}};
}

struct matrix3 transform2_reflect(enum mirror2 mirror)
{
    static const struct matrix3 mirrors[] = {
        [MIRROR_X_AXIS] = {{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}}},
        [MIRROR_Y_AXIS] = {{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
        [MIRROR_ORIGIN] = {{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}},
        [MIRROR_Y_IS_X] = {{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}},
        [MIRROR_Y_IS_MINUS_X] = {{{0, -1, 0}, {-1, 0, 0}, {0, 0, 1}}},
    };
    return mirrors[mirror];
}

struct matrix3 transform2_shear_x(float k, float y0)
{
    return (struct matrix3){{{1, k, 0 - k * y0}, {0, 1, 0}, {0, 0, 1}}};
}

struct matrix3 transform2_shear_y(float k, float x0)
{
    return (struct matrix3){{{1, 0, 0}, {k, 1, 0 - k * x0}, {0, 0, 1}}};
}

struct matrix3 transform2_rotate_about(float degrees, struct point2 p)
{
    struct sine_cosine d = scalar_sine_cosine(degrees);
    return (struct matrix3){{{d.cosine, 0 - d.sine, p.x * (1 - d.cosine) + p.y * d.sine},
                             {d.sine, d.cosine, p.y * (1 - d.cosine) - p.x * d.sine},
                             {0, 0, 1}}};
}

struct matrix3 transform2_scale_about(float sx, float sy, struct point2 f)
{
    return (struct matrix3){{{sx, 0, f.x * (1 - sx)}, {0, sy, f.y * (1 - sy)}, {0, 0, 1}}};
}

/*                   | 1−m²   2m   −2mc |
 *      1/(1+m²)  ·  |  2m   m²−1   2c  |      steep lines by u = 1/m, so that no square overflows
 *                   |  0     0    1+m² |
 */
struct matrix3 transform2_reflect_line(float m, float c)
{
    bool steep = fabsf(m) > 1;
    float u = steep ? 1 / m : m, whole = 1 + u * u;
    float cosine = (steep ? u * u - 1 : 1 - u * u) / whole; /* of twice the line's angle */
    float sine = 2 * u / whole;
    float lift = (steep ? u * u : 1) / whole * 2 * c;
    return (struct matrix3){{{cosine, sine, 0 - sine * c}, {sine, 0 - cosine, lift}, {0, 0, 1}}};
}

struct matrix3 transform2_reflect_x_is(float k)
{
    return (struct matrix3){{{-1, 0, 2 * k}, {0, 1, 0}, {0, 0, 1}}};
}

struct matrix3 transform2_reflect_y_is(float k)
{
    return (struct matrix3){{{1, 0, 0}, {0, -1, 2 * k}, {0, 0, 1}}};
}

struct matrix3 transform2_then(const struct matrix3 *first, const struct matrix3 *second)
{
    return matrix3_product(second, first);
}
