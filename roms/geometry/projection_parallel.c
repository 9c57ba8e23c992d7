#include "roms/geometry/projection_parallel.h"

#include <math.h>

#include "roms/geometry/scalar.h"
#include "roms/geometry/transform3.h"

struct matrix4 projection_elevation(enum elevation from)
{
    static const float rows[][3][3] = {
        [ELEVATION_FRONT] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
        [ELEVATION_REAR] = {{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}},
        [ELEVATION_LEFT] = {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}},
        [ELEVATION_RIGHT] = {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}},
        [ELEVATION_PLAN] = {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
    };
    struct matrix4 m = matrix4_identity();
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            m.at[i][k] = rows[from][i][k];
    return m;
}

struct axonometric projection_axonometric(float turn, float tilt)
{
    struct matrix4 about_y = transform3_rotate(AXIS3_Y, turn);
    struct matrix4 about_x = transform3_rotate(AXIS3_X, tilt);
    struct axonometric a = {.turn = turn, .tilt = tilt};
    a.matrix = matrix4_product(&about_x, &about_y);
    for (int i = 0; i < 3; i++) {
        float x = a.matrix.at[0][i], y = a.matrix.at[1][i];
        float angle = x == 0 && y == 0 ? 0 : atan2f(y, x) / DEGREE;
        a.factor[i] = sqrtf(x * x + y * y);
        a.angle[i] = angle < 0 ? angle + 360 : angle;
    }
    return a;
}

struct axonometric projection_isometric(void)
{
    return projection_axonometric(-45, 35.26438968f); /* sin tilt = 1/√3 */
}

bool projection_dimetric(float f, struct axonometric *out)
{
    if (!(f > 0 && f <= 1))
        return false;
    float sine_tilt = f * 0.70710678f, sine_turn = f / sqrtf(2 - f * f);
    *out = projection_axonometric(-asinf(scalar_min(sine_turn, 1)) / DEGREE,
                                  asinf(sine_tilt) / DEGREE);
    return true;
}

struct matrix4 projection_oblique(float degrees, float factor)
{
    struct sine_cosine of = scalar_sine_cosine(degrees);
    struct matrix4 m = matrix4_identity();
    m.at[0][2] = factor * of.cosine;
    m.at[1][2] = factor * of.sine;
    return m;
}
