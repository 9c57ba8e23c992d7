/* check_space — space in the machine: properties of transformations, projections and the view
 * volume on random cases, one line a property. Exit status 0: all hold. */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "roms/clip/volume.h"
#include "roms/geometry/projection_parallel.h"
#include "roms/geometry/projection_perspective.h"
#include "roms/geometry/rotate_axis.h"
#include "roms/geometry/scalar.h"
#include "roms/geometry/view3.h"

enum { CASES = 2000 };

static float any(uint32_t *state, float size)
{
    *state = *state * 1664525u + 1013904223u;
    return ((float)(*state >> 8) / 8388608.0f - 1) * size;
}

static struct vector3 any_vector(uint32_t *state, float size)
{
    float x = any(state, size), y = any(state, size), z = any(state, size);
    return (struct vector3){x, y, z};
}

static bool same(struct vector3 a, struct vector3 b, float within)
{
    return vector3_length(vector3_difference(a, b)) <= within;
}

static bool orthonormal(const struct matrix4 *m)
{
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            float sum =
                m->at[i][0] * m->at[k][0] + m->at[i][1] * m->at[k][1] + m->at[i][2] * m->at[k][2];
            if (!(fabsf(sum - (i == k ? 1 : 0)) < 2e-6f))
                return false;
        }
    return fabsf(transform3_determinant(m) - 1) < 2e-6f;
}

/* v cos θ + (k × v) sin θ + k (k·v)(1 − cos θ), about the line through p. */
static struct vector3 rodrigues(struct vector3 p, struct vector3 k, float degrees, struct vector3 v)
{
    float s = scalar_sine_cosine(degrees).sine, c = scalar_sine_cosine(degrees).cosine;
    v = vector3_difference(v, p);
    struct vector3 turned = vector3_sum(vector3_times(v, c), vector3_times(vector3_cross(k, v), s));
    turned = vector3_sum(turned, vector3_times(k, vector3_dot(k, v) * (1 - c)));
    return vector3_sum(p, turned);
}

static bool rotations(uint32_t *state)
{
    struct matrix4 m = transform3_rotate(AXIS3_X, any(state, 400));
    struct matrix4 y = transform3_rotate(AXIS3_Y, any(state, 400));
    struct matrix4 z = transform3_rotate(AXIS3_Z, any(state, 400));
    m = matrix4_product(&y, &m);
    m = matrix4_product(&z, &m);
    return orthonormal(&m);
}

static bool lines(uint32_t *state)
{
    struct vector3 p = any_vector(state, 10), q = any_vector(state, 10), v = any_vector(state, 10);
    float degrees = any(state, 400);
    struct rotate_axis r;
    if (any(state, 1) > 0.8f)
        q = vector3_sum(p, (struct vector3){any(state, 5), 0, 0}); /* along x */
    if (!rotate_axis(p, q, degrees, &r))
        return vector3_length(vector3_difference(p, q)) < ROTATE_AXIS_SHORTEST;
    const struct matrix4 *m = &r.transform.matrix;
    return orthonormal(m) && same(matrix4_apply(m, p), p, 5e-5f) &&
           same(matrix4_apply(m, q), q, 5e-5f) &&
           same(matrix4_apply(m, v), rodrigues(p, r.direction, degrees, v), 1e-4f);
}

static bool inverses(uint32_t *state)
{
    struct rotate_axis r;
    if (!rotate_axis(any_vector(state, 5), any_vector(state, 5), any(state, 360), &r))
        return true;
    struct matrix4 scale = transform3_scale(
        (struct vector3){1.5f + any(state, 1), 1.5f + any(state, 1), -1.5f + any(state, 1)});
    struct matrix4 shear = transform3_shear(AXIS3_Y, any(state, 2), any(state, 2)), inverse;
    struct matrix4 m = matrix4_product(&scale, &r.transform.matrix);
    m = matrix4_product(&shear, &m);
    struct vector3 p = any_vector(state, 10);
    return matrix4_inverse(&m, &inverse) &&
           same(matrix4_apply(&inverse, matrix4_apply(&m, p)), p, 5e-4f);
}

static bool views(uint32_t *state)
{
    struct view3 view;
    struct vector3 at = any_vector(state, 10), n = any_vector(state, 2), up = any_vector(state, 2);
    if (!view3(at, n, up, &view))
        return true;
    struct vector3 v = matrix4_apply_direction(&view.matrix, up);
    return orthonormal(&view.rotate) && vector3_length(matrix4_apply(&view.matrix, at)) < 5e-5f &&
           fabsf(v.x) < 1e-5f && v.y > 0;
}

/* xp = x·dp/(zprp − z), and the way back along the ray. */
static bool perspectives(uint32_t *state)
{
    struct vector3 p = any_vector(state, 5);
    float zprp = 6 + any(state, 0.5f), zvp = any(state, 3);
    struct matrix4 m;
    struct point2 at;
    if (!projection_perspective((struct vector3){0, 0, zprp}, zvp, &m) ||
        !projection_place(&m, p, &at))
        return false;
    float h = (zprp - p.z) / (zprp - zvp);
    return fabsf(at.x * h - p.x) < 1e-4f && fabsf(at.y * h - p.y) < 1e-4f;
}

static bool vanishing(uint32_t *state)
{
    struct matrix4 m, turn = transform3_rotate(AXIS3_Y, 45 + any(state, 20));
    struct vector3 start = any_vector(state, 2), far = {start.x, start.y, start.z - 1e6f};
    struct point2 at, v;
    if (!projection_perspective((struct vector3){1, 2, 6}, 0, &m))
        return false;
    m = matrix4_product(&m, &turn);
    return projection_vanishing_axes(&m).count == 2 &&
           projection_vanishing(&m, (struct vector3){0, 0, 1}, &v) &&
           projection_place(&m, far, &at) && fabsf(at.x - v.x) < 0.01f && fabsf(at.y - v.y) < 0.01f;
}

static bool axonometrics(uint32_t *state)
{
    struct axonometric a = projection_axonometric(any(state, 180), any(state, 90));
    float sum = 0;
    for (int i = 0; i < 3; i++)
        sum += a.factor[i] * a.factor[i];
    return fabsf(sum - 2) < 1e-5f && orthonormal(&a.matrix);
}

static struct matrix4 any_volume(uint32_t *state)
{
    struct clip_window w = {-1 + any(state, 0.9f), -1, 1, 1 + any(state, 0.9f)};
    struct matrix4 m;
    if (any(state, 1) > 0)
        volume_parallel(&w, 3, -3 + any(state, 2), &m);
    else
        volume_perspective((struct vector3){any(state, 1), any(state, 1), 4}, 1, &w, 3,
                           -6 + any(state, 4), &m);
    return m;
}

/* 200 points of the line: those between the cuts are inside, the others are not. */
static bool clipped(uint32_t *state)
{
    struct matrix4 m = any_volume(state);
    struct vector3 a = any_vector(state, 6), b = any_vector(state, 6);
    struct vector4 from = matrix4_homogeneous(&m, a), to = matrix4_homogeneous(&m, b);
    struct volume_line k;
    if (!volume_clip_line(&from, &to, &k))
        k.t1 = 2;
    for (int i = 0; i <= 200; i++) {
        float t = (float)i / 200;
        struct vector3 p = vector3_sum(a, vector3_times(vector3_difference(b, a), t));
        struct vector4 v = matrix4_homogeneous(&m, p);
        bool inside = volume_code(&v) == 0;
        if (fabsf(t - k.t1) > 1e-3f && fabsf(t - k.t2) > 1e-3f && inside != (t > k.t1 && t < k.t2))
            return false;
    }
    return true;
}

/* Corners that are left are inside; a triangle wholly inside stays as it is. */
static bool polygons(uint32_t *state)
{
    struct matrix4 m = any_volume(state);
    struct vector4 in[8], out[VOLUME_ROOM];
    unsigned any_code = 0;
    int corners = 3 + (int)(2.5f + any(state, 2.4f));
    for (int i = 0; i < corners; i++) {
        in[i] = matrix4_homogeneous(&m, any_vector(state, 3));
        any_code |= volume_code(&in[i]);
    }
    int count = volume_clip_polygon(in, corners, out);
    if (any_code == 0 && count != corners)
        return false;
    for (int i = 0; i < count; i++)
        for (int plane = 0; plane < VOLUME_PLANES; plane++)
            if (out[i].h <= 0 ||
                volume_boundary(&out[i], (enum volume_plane)plane) < -1e-4f * (1 + out[i].h))
                return false;
    return true;
}

int main(void)
{
    static const struct {
        const char *what;
        bool (*holds)(uint32_t *state);
    } properties[] = {
        {"rotations: orthonormal, determinant 1", rotations},
        {"rotations about a line: it stays, the rest as Rodrigues says", lines},
        {"compositions: inverted", inverses},
        {"viewing: u, v, n orthonormal, the reference point at the origin", views},
        {"perspective: on the ray through the view plane", perspectives},
        {"vanishing points: where lines go", vanishing},
        {"axonometric: squares of the factors add up to 2", axonometrics},
        {"lines: 201 points each, inside between the cuts only", clipped},
        {"polygons: what is left lies inside", polygons},
    };
    uint32_t state = 20260;
    int failed = 0;
    for (unsigned i = 0; i < sizeof properties / sizeof properties[0]; i++) {
        int wrong = 0, cases = properties[i].holds == clipped ? CASES / 4 : CASES;
        for (int k = 0; k < cases; k++)
            wrong += !properties[i].holds(&state);
        printf("%d cases, %d wrong: %s\n", cases, wrong, properties[i].what);
        failed += wrong > 0;
    }
    return failed > 0;
}
