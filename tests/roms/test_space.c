/* Space (roms/geometry, roms/clip/volume): transformations against their definitions in double
 * precision (rotation about a line against Rodrigues' formula), projections against intersections
 * of rays, and clipping against the six planes in world coordinates. The sources are compiled for
 * this machine. */
#include <math.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "roms/clip/volume.c"
#include "roms/geometry/matrix4.c"
#include "roms/geometry/projection_parallel.c"
#include "roms/geometry/projection_perspective.c"
#include "roms/geometry/rotate_axis.c"
#include "roms/geometry/scalar.c"
#include "roms/geometry/transform3.c"
#include "roms/geometry/view3.c"

#define EXACT_PI 3.14159265358979323846
enum { CASES = 20000 };

static struct {
    uint32_t state;
} rig;

struct real3 {
    double x, y, z;
};

/* Evenly from −size to size. */
static float any(float size)
{
    rig.state = rig.state * 1664525u + 1013904223u;
    return ((float)(rig.state >> 8) / 8388608.0f - 1) * size;
}

static struct vector3 any_vector(float size)
{
    float x = any(size), y = any(size), z = any(size);
    return (struct vector3){x, y, z};
}

static struct real3 real(struct vector3 v)
{
    return (struct real3){(double)v.x, (double)v.y, (double)v.z};
}

static double dot(struct real3 a, struct real3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static struct real3 cross(struct real3 a, struct real3 b)
{
    return (struct real3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static struct real3 mix(struct real3 a, double k, struct real3 b)
{
    return (struct real3){a.x + k * b.x, a.y + k * b.y, a.z + k * b.z};
}

static void near_to(double value, double expected, double within)
{
    if (!(fabs(value - expected) <= within))
        fail_msg("%.9g instead of %.9g", value, expected);
}

static void near_vector(struct vector3 v, struct real3 e, double within)
{
    near_to((double)v.x, e.x, within);
    near_to((double)v.y, e.y, within);
    near_to((double)v.z, e.z, within);
}

static void near_matrix(const struct matrix4 *m, const struct matrix4 *e, double within)
{
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 4; k++)
            near_to((double)m->at[i][k], (double)e->at[i][k], within);
}

static void orthonormal(const struct matrix4 *m)
{
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            double sum = 0;
            for (int j = 0; j < 3; j++)
                sum += (double)m->at[i][j] * (double)m->at[k][j];
            near_to(sum, i == k, 1e-6);
        }
    near_to((double)transform3_determinant(m), 1, 1e-6);
}

/* ---- transformations ------------------------------------------------------------------------- */

static void sines_are_those_of_the_angle(void **state)
{
    (void)state;
    static const float quarter[4][2] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}};
    for (int i = -8; i <= 8; i++) {
        struct sine_cosine of = scalar_sine_cosine((float)(90 * i));
        assert_true(of.sine == quarter[i & 3][0] && of.cosine == quarter[i & 3][1]);
    }
    for (int i = 0; i < CASES; i++) {
        float degrees = any(2000);
        struct sine_cosine of = scalar_sine_cosine(degrees);
        near_to((double)of.sine, sin((double)degrees * EXACT_PI / 180), 2e-7);
        near_to((double)of.cosine, cos((double)degrees * EXACT_PI / 180), 2e-7);
    }
}

static void rotations_are_right_handed(void **state)
{
    (void)state;
    static const struct vector3 unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int axis = 0; axis < 3; axis++) {
        struct matrix4 m = transform3_rotate((enum axis3)axis, 90);
        near_vector(matrix4_apply(&m, unit[(axis + 1) % 3]), real(unit[(axis + 2) % 3]), 0);
        near_vector(matrix4_apply(&m, unit[axis]), real(unit[axis]), 0);
        for (int i = 0; i < 1000; i++) {
            float degrees = any(720);
            m = transform3_rotate((enum axis3)axis, degrees);
            orthonormal(&m);
            struct matrix4 back = transform3_rotate((enum axis3)axis, -degrees);
            struct matrix4 both = matrix4_product(&back, &m), one = matrix4_identity();
            near_matrix(&both, &one, 2e-7);
        }
    }
}

static void lines_turn_about_y_both_ways(void **state)
{
    (void)state;
    struct vector3 a = {10, 10, 10}, b = {20, 20, 15};
    struct matrix4 m = transform3_rotate(AXIS3_Y, -90);
    near_vector(matrix4_apply(&m, a), (struct real3){-10, 10, 10}, 0);
    near_vector(matrix4_apply(&m, b), (struct real3){-15, 20, 20}, 0);
    struct transform3 t = transform3_rotate_parallel(AXIS3_Y, -90, a);
    assert_int_equal(t.steps, 3);
    near_vector(matrix4_apply(&t.matrix, a), (struct real3){10, 10, 10}, 0);
    near_vector(matrix4_apply(&t.matrix, b), (struct real3){5, 20, 20}, 0);
}

static void the_cube_turns_about_a_line(void **state)
{
    (void)state;
    static const struct matrix4 expected = {{{0.1667f, -0.0749f, 0.9832f, 1.7416f},
                                             {0.7416f, 0.6667f, -0.0749f, -1.1498f},
                                             {-0.6498f, 0.7416f, 0.1667f, 0.5581f},
                                             {0, 0, 0, 1}}};
    static const struct vector3 cube[8] = {{0, 1, 1}, {0, 1, 0}, {1, 1, 0}, {1, 1, 1},
                                           {0, 0, 1}, {0, 0, 0}, {1, 0, 0}, {1, 0, 1}};
    static const struct real3 turned[8] = {{2.6498, -0.5581, 1.4663},  {1.6667, -0.4832, 1.2997},
                                           {1.8333, 0.2584, 0.6498},   {2.8165, 0.1835, 0.8165},
                                           {2.7247, -1.2247, 0.7247},  {1.7416, -1.1498, 0.5581},
                                           {1.9082, -0.4082, -0.0918}, {2.8914, -0.4832, 0.0749}};
    struct rotate_axis r;
    assert_true(rotate_axis((struct vector3){2, 1, 0}, (struct vector3){3, 3, 1}, 90, &r));
    near_to((double)r.sine_alpha, 2 / sqrt(5), 1e-6);
    near_to((double)r.cosine_alpha, 1 / sqrt(5), 1e-6);
    near_to((double)r.sine_beta, 1 / sqrt(6), 1e-6);
    near_to((double)r.cosine_beta, sqrt(5) / sqrt(6), 1e-6);
    near_matrix(&r.transform.matrix, &expected, 5.1e-5);
    for (int i = 0; i < 8; i++)
        near_vector(matrix4_apply(&r.transform.matrix, cube[i]), turned[i], 5.1e-5);
}

/* v cos θ + (k × v) sin θ + k (k·v)(1 − cos θ), about the line through p. */
static struct real3 rodrigues(struct real3 p, struct real3 q, double degrees, struct real3 v)
{
    struct real3 k = mix(q, -1, p), zero = {0, 0, 0};
    k = mix(zero, 1 / sqrt(dot(k, k)), k);
    v = mix(v, -1, p);
    double c = cos(degrees * EXACT_PI / 180), s = sin(degrees * EXACT_PI / 180);
    struct real3 out = mix(mix(mix(p, c, v), s, cross(k, v)), dot(k, v) * (1 - c), k);
    return out;
}

static void lines_of_rotation_stay_and_the_rest_follows_rodrigues(void **state)
{
    (void)state;
    for (int i = 0; i < CASES; i++) {
        struct vector3 p = any_vector(10), q = any_vector(10), v = any_vector(10);
        if (i % 7 == 0) /* along an axis, x among them */
            q = vector3_sum(p, (struct vector3){i % 3 == 0 ? any(9) : 0, i % 3 == 1 ? any(9) : 0,
                                                i % 3 == 2 ? any(9) : 0});
        if (i % 13 == 0)
            q = vector3_sum(p, vector3_times(any_vector(1), 1e-3f));
        float degrees = i % 5 == 0 ? 90 * floorf(any(6)) : any(400);
        struct rotate_axis r;
        if (!rotate_axis(p, q, degrees, &r)) {
            assert_true(vector3_length(vector3_difference(p, q)) < ROTATE_AXIS_SHORTEST);
            continue;
        }
        const struct matrix4 *m = &r.transform.matrix;
        orthonormal(m);
        near_vector(matrix4_apply(m, p), real(p), 2e-5);
        near_vector(matrix4_apply(m, q), real(q), 2e-5);
        struct vector3 far = vector3_sum(p, vector3_times(r.direction, 10));
        near_vector(matrix4_apply(m, v), rodrigues(real(p), real(far), (double)degrees, real(v)),
                    4e-5);
    }
}

static void steps_bring_the_line_to_z(void **state)
{
    (void)state;
    struct rotate_axis r;
    for (int i = 0; i < 2000; i++) {
        struct vector3 p = any_vector(5), q = any_vector(5);
        if (i == 0)
            q = vector3_sum(p, (struct vector3){-3, 0, 0}); /* d = 0 */
        assert_true(rotate_axis(p, q, 30, &r));
        struct vector3 at = q;
        for (int k = 0; k < 3; k++)
            at = matrix4_apply(&r.transform.step[k].matrix, at);
        double length = sqrt(dot(real(vector3_difference(q, p)), real(vector3_difference(q, p))));
        near_vector(at, (struct real3){0, 0, length}, 1e-5);
    }
    assert_false(rotate_axis((struct vector3){1, 2, 3}, (struct vector3){1, 2, 3}, 30, &r));
}

static void scaling_keeps_its_fixed_point(void **state)
{
    (void)state;
    for (int i = 0; i < CASES; i++) {
        struct vector3 k = any_vector(4), f = any_vector(10), v = any_vector(10);
        struct transform3 t = transform3_scale_about(k, f);
        near_vector(matrix4_apply(&t.matrix, f), real(f), 2e-5);
        struct real3 e = {(double)f.x + (double)k.x * ((double)v.x - (double)f.x),
                          (double)f.y + (double)k.y * ((double)v.y - (double)f.y),
                          (double)f.z + (double)k.z * ((double)v.z - (double)f.z)};
        near_vector(matrix4_apply(&t.matrix, v), e, 4e-5);
    }
}

static void reflections_are_their_own_inverses(void **state)
{
    (void)state;
    struct vector3 p = {2, 3, 5};
    static const struct real3 axis[3] = {{2, -3, -5}, {-2, 3, -5}, {-2, -3, 5}};
    static const struct real3 plane[3] = {
        [PLANE3_XY] = {2, 3, -5}, [PLANE3_YZ] = {-2, 3, 5}, [PLANE3_XZ] = {2, -3, 5}};
    struct matrix4 one = matrix4_identity();
    for (int i = 0; i < 3; i++) {
        struct matrix4 a = transform3_reflect_axis((enum axis3)i);
        struct matrix4 half = transform3_rotate((enum axis3)i, 180);
        near_matrix(&a, &half, 0);
        near_vector(matrix4_apply(&a, p), axis[i], 0);
        struct matrix4 b = transform3_reflect_plane((enum plane3)i);
        near_vector(matrix4_apply(&b, p), plane[i], 0);
        assert_true(transform3_determinant(&b) == -1);
        struct matrix4 twice = matrix4_product(&b, &b);
        near_matrix(&twice, &one, 0);
        twice = matrix4_product(&a, &a);
        near_matrix(&twice, &one, 0);
    }
}

static void shears_keep_their_axis(void **state)
{
    (void)state;
    struct vector3 p = {2, 3, 5};
    struct matrix4 x = transform3_shear(AXIS3_X, 10, 100), y = transform3_shear(AXIS3_Y, 10, 100),
                   z = transform3_shear(AXIS3_Z, 10, 100);
    near_vector(matrix4_apply(&x, p), (struct real3){2, 3 + 20, 5 + 200}, 0);
    near_vector(matrix4_apply(&y, p), (struct real3){2 + 30, 3, 5 + 300}, 0);
    near_vector(matrix4_apply(&z, p), (struct real3){2 + 50, 3 + 500, 5}, 0);
}

static struct matrix4 any_transform(void)
{
    struct rotate_axis r;
    switch ((int)(any(3.5f) + 3.5f)) {
    case 0:
        return transform3_translate(any_vector(10));
    case 1:
        return transform3_scale((struct vector3){1.5f + any(1), -1.5f + any(1), 1.5f + any(1)});
    case 2:
        return transform3_rotate(AXIS3_X, any(360));
    case 3:
        return transform3_rotate(AXIS3_Y, any(360));
    case 4:
        return transform3_shear(AXIS3_Z, any(2), any(2));
    case 5:
        return transform3_reflect_plane(PLANE3_YZ);
    default:
        return rotate_axis(any_vector(5), any_vector(5), any(360), &r) ? r.transform.matrix
                                                                       : matrix4_identity();
    }
}

static void compositions_invert(void **state)
{
    (void)state;
    for (int i = 0; i < CASES; i++) {
        struct matrix4 m = any_transform(), inverse;
        for (int k = 0; k < 3; k++) {
            struct matrix4 next = any_transform();
            m = matrix4_product(&next, &m);
        }
        assert_true(matrix4_inverse(&m, &inverse));
        struct vector3 p = any_vector(10);
        near_vector(matrix4_apply(&inverse, matrix4_apply(&m, p)), real(p), 5e-3);
    }
}

/* ---- viewing and projections ----------------------------------------------------------------- */

static void views_have_their_normal_ahead_and_up_upward(void **state)
{
    (void)state;
    int seen = 0;
    for (int i = 0; i < CASES; i++) {
        struct vector3 vrp = any_vector(10), vpn = any_vector(3), vup = any_vector(3);
        struct view3 view;
        if (!view3(vrp, vpn, vup, &view))
            continue;
        seen++;
        orthonormal(&view.rotate);
        near_vector(matrix4_apply(&view.matrix, vrp), (struct real3){0, 0, 0}, 1e-5);
        struct vector3 n = matrix4_apply_direction(&view.matrix, vpn);
        near_vector(n, (struct real3){0, 0, sqrt(dot(real(vpn), real(vpn)))}, 1e-5);
        struct vector3 up = matrix4_apply_direction(&view.matrix, vup);
        near_to((double)up.x, 0, 1e-5);
        assert_true(up.y > 0);
    }
    assert_true(seen > CASES * 9 / 10);
    struct view3 view;
    struct vector3 o = {0, 0, 0}, z = {0, 0, 1}, down = {0, 0, -2}, y = {0, 1, 0};
    assert_false(view3(o, o, y, &view));
    assert_false(view3(o, z, o, &view));
    assert_false(view3(o, z, down, &view));
    assert_true(view3(o, z, y, &view));
    struct matrix4 one = matrix4_identity();
    near_matrix(&view.matrix, &one, 0);
}

static void elevations_turn_the_solid(void **state)
{
    (void)state;
    struct vector3 p = {2, 3, 5};
    static const struct real3 e[] = {
        [ELEVATION_FRONT] = {2, 3, 5}, [ELEVATION_REAR] = {-2, 3, -5},
        [ELEVATION_LEFT] = {5, 3, -2}, [ELEVATION_RIGHT] = {-5, 3, 2},
        [ELEVATION_PLAN] = {2, -5, 3},
    };
    for (int i = 0; i <= ELEVATION_PLAN; i++) {
        struct matrix4 m = projection_elevation((enum elevation)i);
        near_vector(matrix4_apply(&m, p), e[i], 0);
        orthonormal(&m);
    }
}

static void axonometric_factors_are_those_of_drawn_axes(void **state)
{
    (void)state;
    struct axonometric a = projection_isometric();
    static const double angles[3] = {330, 90, 210};
    for (int i = 0; i < 3; i++) {
        near_to((double)a.factor[i], sqrt(2.0 / 3), 1e-6);
        near_to((double)a.angle[i], angles[i], 1e-4);
    }
    for (int i = 0; i < CASES; i++) {
        float turn = any(180), tilt = any(90);
        a = projection_axonometric(turn, tilt);
        double st = sin((double)turn * EXACT_PI / 180), ct = cos((double)turn * EXACT_PI / 180);
        double sl = sin((double)tilt * EXACT_PI / 180), cl = cos((double)tilt * EXACT_PI / 180);
        near_to((double)a.factor[0], sqrt(ct * ct + st * st * sl * sl), 1e-5);
        near_to((double)a.factor[1], fabs(cl), 1e-5);
        near_to((double)a.factor[2], sqrt(st * st + ct * ct * sl * sl), 1e-5);
    }
    for (int i = 1; i <= 1000; i++) {
        float f = (float)i / 1000;
        assert_true(projection_dimetric(f, &a));
        near_to((double)a.factor[2], (double)f, 2e-5);
        near_to((double)a.factor[0], (double)a.factor[1], 1e-5);
    }
    assert_false(projection_dimetric(0, &a));
    assert_false(projection_dimetric(1.001f, &a));
    assert_false(projection_dimetric(NAN, &a));
}

static void oblique_keeps_the_front_and_slants_the_depth(void **state)
{
    (void)state;
    for (int i = 0; i < CASES; i++) {
        float degrees = any(360), factor = any(2);
        struct matrix4 m = projection_oblique(degrees, factor);
        struct vector3 p = any_vector(5), q = matrix4_apply(&m, p);
        double l = (double)p.z * (double)factor, angle = (double)degrees * EXACT_PI / 180;
        near_vector(
            q,
            (struct real3){(double)p.x + l * cos(angle), (double)p.y + l * sin(angle), (double)p.z},
            5e-6);
    }
}

/* Where the ray from prp through p meets z = zvp. */
static struct real3 seen_on_plane(struct real3 prp, struct real3 p, double zvp)
{
    struct real3 ray = mix(p, -1, prp);
    return mix(prp, (zvp - prp.z) / ray.z, ray);
}

static void perspective_is_the_ray_through_the_plane(void **state)
{
    (void)state;
    int behind = 0;
    for (int i = 0; i < CASES; i++) {
        struct vector3 prp = any_vector(10), p = any_vector(10);
        if (i % 2 == 0)
            prp.x = prp.y = 0; /* xp = x·dp/(zprp − z) */
        float zvp = any(10), dp = prp.z - zvp;
        struct matrix4 m;
        struct point2 at = {0, 0};
        if (fabsf(dp) < 0.1f || fabsf(prp.z - p.z) < 0.1f)
            continue;
        assert_true(projection_perspective(prp, zvp, &m));
        bool ahead = (prp.z - p.z) * dp > 0;
        assert_true(projection_place(&m, p, &at) == ahead);
        behind += !ahead;
        struct vector3 q = matrix4_apply(&m, p);
        struct real3 e = seen_on_plane(real(prp), real(p), (double)zvp);
        double within = 2e-5 * (1 + fabs(e.x) + fabs(e.y)) * (1 + fabs((double)(p.z / dp))) *
                        (1 + 10 / fabs((double)(prp.z - p.z)));
        near_vector(q, e, within);
        if (i % 2 == 0)
            near_to((double)q.x, (double)p.x * (double)dp / ((double)prp.z - (double)p.z), within);
        if (ahead)
            assert_true(at.x == q.x && at.y == q.y);
    }
    assert_true(behind > CASES / 10);
}

static void perspective_has_the_courses_matrix(void **state)
{
    (void)state;
    struct matrix4 m;
    assert_true(projection_perspective((struct vector3){0, 0, 5}, 2, &m)); /* dp = 3 */
    struct matrix4 e = {
        {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -2 / 3.f, 10 / 3.f}, {0, 0, -1 / 3.f, 5 / 3.f}}};
    near_matrix(&m, &e, 1e-6);
    assert_true(projection_perspective((struct vector3){0, 0, 5}, 0, &m)); /* x/(1 − z/zprp) */
    near_to((double)matrix4_apply(&m, (struct vector3){3, 4, -5}).x, 1.5, 1e-6);
    assert_true(projection_perspective((struct vector3){0, 0, 0}, -2, &m)); /* x·zvp/z */
    near_to((double)matrix4_apply(&m, (struct vector3){3, 4, -8}).y, 1, 1e-6);
    assert_false(projection_perspective((struct vector3){1, 2, 3}, 3, &m));
}

/* Points ever farther along lines of the direction come to the vanishing point. */
static void parallel_lines_meet_at_their_vanishing_point(void **state)
{
    (void)state;
    int met = 0;
    for (int i = 0; i < CASES; i++) {
        struct vector3 prp = {any(3), any(3), 4 + any(1)}, d = vector3_direction(any_vector(1));
        struct matrix4 projection, turn = transform3_rotate(AXIS3_Y, any(90));
        struct matrix4 tilt = transform3_rotate(AXIS3_X, any(90)), m;
        assert_true(projection_perspective(prp, any(1), &projection));
        m = matrix4_product(&tilt, &turn);
        struct vector3 seen = matrix4_apply_direction(&m, d);
        m = matrix4_product(&projection, &m);
        struct point2 v = {0, 0};
        if (fabsf(seen.z) < 0.05f)
            continue;
        assert_true(projection_vanishing(&m, d, &v));
        for (int line = 0; line < 2; line++) {
            struct vector3 far =
                vector3_sum(any_vector(2), vector3_times(d, seen.z > 0 ? -1e6f : 1e6f));
            struct point2 at = {0, 0};
            assert_true(projection_place(&m, far, &at));
            near_to((double)at.x, (double)v.x, 1e-3 * (1 + fabs((double)v.x)));
            near_to((double)at.y, (double)v.y, 1e-3 * (1 + fabs((double)v.y)));
        }
        met++;
    }
    assert_true(met > CASES / 2);
}

static void principal_vanishing_points_are_counted(void **state)
{
    (void)state;
    struct matrix4 projection, about_y = transform3_rotate(AXIS3_Y, -30);
    struct matrix4 about_x = transform3_rotate(AXIS3_X, 20);
    assert_true(projection_perspective((struct vector3){1, 2, 6}, 0, &projection));
    struct vanishing v = projection_vanishing_axes(&projection);
    assert_int_equal(v.count, 1);
    assert_true(v.has[2]);
    near_to((double)v.at[2].x, 1, 1e-6); /* z meets straight ahead of the eye */
    near_to((double)v.at[2].y, 2, 1e-6);
    struct matrix4 two = matrix4_product(&projection, &about_y);
    v = projection_vanishing_axes(&two);
    assert_int_equal(v.count, 2);
    assert_true(v.has[0] && v.has[2] && !v.has[1]);
    near_to((double)v.at[0].x, 1 - 6 / tan(EXACT_PI / 6), 1e-4); /* left of x to z */
    near_to((double)v.at[2].x, 1 + 6 * tan(EXACT_PI / 6), 1e-4);
    near_to((double)v.at[0].y, 2, 1e-4); /* both on the horizon */
    near_to((double)v.at[2].y, 2, 1e-4);
    struct matrix4 turned = matrix4_product(&about_x, &about_y);
    struct matrix4 three = matrix4_product(&projection, &turned);
    assert_int_equal(projection_vanishing_axes(&three).count, 3);
    struct matrix4 one = matrix4_identity();
    assert_int_equal(projection_vanishing_axes(&one).count, 0);
}

/* ---- the view volume ------------------------------------------------------------------------- */

/* A volume by its planes: inside where a·x + b·y + c·z + d >= 0, in double. */
struct slow {
    double plane[6][4];
    struct matrix4 matrix;
};

static void plane(struct slow *s, int i, struct real3 normal, struct real3 on)
{
    double length = sqrt(dot(normal, normal)), sign = 1;
    s->plane[i][0] = sign * normal.x / length;
    s->plane[i][1] = sign * normal.y / length;
    s->plane[i][2] = sign * normal.z / length;
    s->plane[i][3] = -dot(normal, on) / length;
}

static struct slow any_volume(bool perspective)
{
    struct clip_window w;
    struct slow s;
    w.x_min = -1 + any(2), w.y_min = -1 + any(2);
    w.x_max = w.x_min + 1.5f + any(1), w.y_max = w.y_min + 1.5f + any(1);
    float near = 1 + any(1), far = near - 5 + any(3), zvp = any(1);
    struct vector3 prp = {any(2), any(2), near + 2 + any(1)};
    struct real3 low = {(double)w.x_min, (double)w.y_min, (double)zvp};
    struct real3 high = {(double)w.x_max, (double)w.y_max, (double)zvp};
    if (prp.z < zvp + 0.5f)
        prp.z = zvp + 0.5f > near + 0.5f ? zvp + 0.5f : near + 0.5f;
    struct real3 eye = real(prp), a = {1, 0, 0}, b = {0, 1, 0};
    struct real3 l = {1, 0, 0}, r = {-1, 0, 0}, d = {0, 1, 0}, u = {0, -1, 0};
    if (perspective) {
        l = cross(b, mix(eye, -1, low)); /* across the left plane, to the right */
        r = cross(mix(eye, -1, high), b);
        d = cross(mix(eye, -1, low), a);
        u = cross(a, mix(eye, -1, high));
        assert_true(volume_perspective(prp, zvp, &w, near, far, &s.matrix));
    } else {
        assert_true(volume_parallel(&w, near, far, &s.matrix));
    }
    plane(&s, VOLUME_LEFT, l, low);
    plane(&s, VOLUME_RIGHT, r, high);
    plane(&s, VOLUME_BELOW, d, low);
    plane(&s, VOLUME_ABOVE, u, high);
    plane(&s, VOLUME_FAR, (struct real3){0, 0, 1}, (struct real3){0, 0, (double)far});
    plane(&s, VOLUME_NEAR, (struct real3){0, 0, -1}, (struct real3){0, 0, (double)near});
    return s;
}

static double distance(const struct slow *s, int i, struct real3 p)
{
    return s->plane[i][0] * p.x + s->plane[i][1] * p.y + s->plane[i][2] * p.z + s->plane[i][3];
}

/* How far inside of the volume; below 0: outside. */
static double depth_inside(const struct slow *s, struct real3 p)
{
    double least = distance(s, 0, p);
    for (int i = 1; i < 6; i++)
        least = fmin(least, distance(s, i, p));
    return least;
}

static void codes_are_the_planes_sides(void **state)
{
    (void)state;
    for (int i = 0; i < CASES; i++) {
        struct slow s = any_volume(i % 2 == 0);
        struct vector3 p = any_vector(6);
        struct vector4 v = matrix4_homogeneous(&s.matrix, p);
        unsigned code = volume_code(&v);
        for (int k = 0; k < 6; k++) {
            double d = distance(&s, k, real(p));
            if (fabs(d) > 1e-4) {
                assert_int_equal(code >> k & 1, d < 0);
                assert_int_equal(volume_boundary(&v, (enum volume_plane)k) < 0, d < 0);
            }
        }
    }
}

/* The parameters of the part inside, plane by plane. */
static bool slow_clip(const struct slow *s, struct real3 a, struct real3 b, double *t1, double *t2)
{
    *t1 = 0, *t2 = 1;
    for (int i = 0; i < 6; i++) {
        double da = distance(s, i, a), db = distance(s, i, b);
        if (da < 0 && db < 0)
            return false;
        if (da < 0)
            *t1 = fmax(*t1, da / (da - db));
        if (db < 0)
            *t2 = fmin(*t2, da / (da - db));
    }
    return *t1 <= *t2;
}

/* From the volume's coordinates back. */
static struct real3 place_of(const struct slow *s, struct vector4 v)
{
    struct matrix4 inverse;
    assert_true(matrix4_inverse(&s->matrix, &inverse));
    double p[4];
    for (int i = 0; i < 4; i++)
        p[i] = (double)inverse.at[i][0] * (double)v.x + (double)inverse.at[i][1] * (double)v.y +
               (double)inverse.at[i][2] * (double)v.z + (double)inverse.at[i][3] * (double)v.h;
    return (struct real3){p[0] / p[3], p[1] / p[3], p[2] / p[3]};
}

static void lines_are_cut_at_the_planes(void **state)
{
    (void)state;
    int kept = 0, cut = 0, behind = 0;
    for (int i = 0; i < CASES; i++) {
        struct slow s = any_volume(i % 2 == 0);
        struct vector3 a = any_vector(6), b = any_vector(6);
        struct vector4 from = matrix4_homogeneous(&s.matrix, a),
                       to = matrix4_homogeneous(&s.matrix, b), f = from, t = to;
        struct volume_line k;
        double t1, t2;
        bool left = volume_clip_line(&f, &t, &k);
        bool expected = slow_clip(&s, real(a), real(b), &t1, &t2);
        if (expected != left) { /* by a hair only */
            assert_true(fabs(t2 - t1) < 1e-4 || fabs((double)(k.t2 - k.t1)) < 1e-4);
            continue;
        }
        struct vector4 plain_a = from, plain_b = to;
        assert_int_equal(volume_clip_line(&plain_a, &plain_b, NULL), left);
        assert_memory_equal(&plain_a, &f, sizeof f);
        assert_memory_equal(&plain_b, &t, sizeof t);
        if (!left) {
            assert_memory_equal(&from, &f, sizeof f);
            continue;
        }
        kept++;
        cut += k.code_a != 0 || k.code_b != 0;
        behind += from.h < 0 || to.h < 0;
        assert_true(f.h > 0 && t.h > 0);
        struct real3 ea = mix(real(a), t1, mix(real(b), -1, real(a)));
        struct real3 eb = mix(real(a), t2, mix(real(b), -1, real(a)));
        struct real3 pa = place_of(&s, f), pb = place_of(&s, t);
        near_to(sqrt(dot(mix(pa, -1, ea), mix(pa, -1, ea))), 0, 2e-3);
        near_to(sqrt(dot(mix(pb, -1, eb), mix(pb, -1, eb))), 0, 2e-3);
    }
    assert_true(kept > CASES / 20 && cut > CASES / 30 && behind > CASES / 200);
}

/* A place of the polygon's plane is inside of the clipped polygon when it is in the polygon and in
 * the volume: even-odd along x of the two others in the polygon's own coordinates. */
static bool holds(const double (*corner)[2], int count, double x, double y)
{
    bool inside = false;
    for (int i = 0, j = count - 1; i < count; j = i++)
        if ((corner[i][1] > y) != (corner[j][1] > y) &&
            x < corner[i][0] + (y - corner[i][1]) * (corner[j][0] - corner[i][0]) /
                                   (corner[j][1] - corner[i][1]))
            inside = !inside;
    return inside;
}

struct flat {
    struct real3 origin, u, v; /* u, v: perpendicular, of length 1 */
};

static void on_flat(const struct flat *f, struct real3 p, double out[2])
{
    struct real3 d = mix(p, -1, f->origin);
    out[0] = dot(d, f->u);
    out[1] = dot(d, f->v);
}

/* How far from the nearest edge. */
static double from_edges(const double (*corner)[2], int count, double x, double y)
{
    double least = 1e9;
    for (int i = 0, j = count - 1; i < count; j = i++) {
        double dx = corner[j][0] - corner[i][0], dy = corner[j][1] - corner[i][1];
        double t =
            ((x - corner[i][0]) * dx + (y - corner[i][1]) * dy) / (dx * dx + dy * dy + 1e-12);
        t = fmin(fmax(t, 0), 1);
        least = fmin(least, hypot(x - corner[i][0] - t * dx, y - corner[i][1] - t * dy));
    }
    return least;
}

static struct flat any_flat(void)
{
    struct flat f = {.origin = real(any_vector(2))};
    struct real3 zero = {0, 0, 0}, a = real(any_vector(1)), b = real(any_vector(1));
    f.u = mix(zero, 1 / sqrt(dot(a, a)), a);
    b = mix(b, -dot(b, f.u), f.u);
    f.v = mix(zero, 1 / sqrt(dot(b, b)), b);
    return f;
}

/* Stars: concave, and mostly larger than the volume. */
static void check_polygon(const struct slow *s, int corners, int *inside_seen)
{
    struct flat f = any_flat();
    struct vector4 in[VOLUME_CORNERS], out[VOLUME_ROOM];
    double whole[VOLUME_CORNERS][2], part[VOLUME_ROOM][2];
    for (int i = 0; i < corners; i++) {
        double r = 1 + 5 * fabs((double)any(1)), angle = 2 * EXACT_PI * i / corners;
        struct real3 p = mix(mix(f.origin, r * cos(angle), f.u), r * sin(angle), f.v);
        struct vector3 q = {(float)p.x, (float)p.y, (float)p.z};
        in[i] = matrix4_homogeneous(&s->matrix, q);
        on_flat(&f, real(q), whole[i]);
    }
    int count = volume_clip_polygon(in, corners, out);
    assert_in_range(count, 0, VOLUME_ROOM);
    for (int i = 0; i < count; i++) {
        assert_true(out[i].h > 0);
        struct real3 p = place_of(s, out[i]);
        assert_true(depth_inside(s, p) > -2e-3);
        on_flat(&f, p, part[i]);
    }
    for (int i = 0; i < 50; i++) {
        double x = (double)any(2), y = (double)any(2);
        struct real3 p = mix(mix(f.origin, x, f.u), y, f.v);
        double depth = depth_inside(s, p);
        if (fabs(depth) < 5e-3 || from_edges((const double(*)[2])whole, corners, x, y) < 5e-3 ||
            (count > 0 && from_edges((const double(*)[2])part, count, x, y) < 5e-3))
            continue;
        bool expected = depth > 0 && holds((const double(*)[2])whole, corners, x, y);
        assert_int_equal(holds((const double(*)[2])part, count, x, y), expected);
        *inside_seen += expected;
    }
}

static void polygons_keep_what_is_inside(void **state)
{
    (void)state;
    int inside = 0;
    for (int i = 0; i < 4000; i++) {
        struct slow s = any_volume(i % 2 == 0);
        check_polygon(&s, 3 + i % (VOLUME_CORNERS - 2), &inside);
    }
    assert_true(inside > 5000);
    struct vector4 corner[VOLUME_CORNERS + 1] = {{0, 0, 0, 1}}, out[VOLUME_ROOM];
    assert_int_equal(volume_clip_polygon(corner, 2, out), 0);
    assert_int_equal(volume_clip_polygon(corner, VOLUME_CORNERS + 1, out), 0);
}

/* In front and behind at once: what a division first would put upside down. */
static void what_is_behind_the_eye_stays_away(void **state)
{
    (void)state;
    struct clip_window w = {-1, -1, 1, 1};
    struct matrix4 m;
    assert_true(volume_perspective((struct vector3){0, 0, 0}, -1, &w, -0.1f, -100, &m));
    struct vector4 a = matrix4_homogeneous(&m, (struct vector3){0, -1, -10});
    struct vector4 b = matrix4_homogeneous(&m, (struct vector3){0, -1, 10});
    assert_true(b.h < 0);
    assert_true(volume_clip_line(&a, &b, NULL));
    near_to((double)(a.y / a.h), -0.1, 1e-6);
    near_to((double)(b.y / b.h), -1, 1e-6); /* the floor leaves at the lower edge */
    a = matrix4_homogeneous(&m, (struct vector3){0, 0.5f, 2});
    b = matrix4_homogeneous(&m, (struct vector3){0.5f, 0, 3});
    assert_false(volume_clip_line(&a, &b, NULL));
    assert_false(volume_perspective((struct vector3){0, 0, 0}, -1, &w, 0, -100, &m));
    assert_false(volume_perspective((struct vector3){0, 0, 0}, 1, &w, -1, -100, &m));
    assert_false(volume_parallel(&w, 1, 1, &m));
    w.x_max = w.x_min;
    assert_false(volume_parallel(&w, 2, 1, &m));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sines_are_those_of_the_angle),
        cmocka_unit_test(rotations_are_right_handed),
        cmocka_unit_test(lines_turn_about_y_both_ways),
        cmocka_unit_test(the_cube_turns_about_a_line),
        cmocka_unit_test(lines_of_rotation_stay_and_the_rest_follows_rodrigues),
        cmocka_unit_test(steps_bring_the_line_to_z),
        cmocka_unit_test(scaling_keeps_its_fixed_point),
        cmocka_unit_test(reflections_are_their_own_inverses),
        cmocka_unit_test(shears_keep_their_axis),
        cmocka_unit_test(compositions_invert),
        cmocka_unit_test(views_have_their_normal_ahead_and_up_upward),
        cmocka_unit_test(elevations_turn_the_solid),
        cmocka_unit_test(axonometric_factors_are_those_of_drawn_axes),
        cmocka_unit_test(oblique_keeps_the_front_and_slants_the_depth),
        cmocka_unit_test(perspective_is_the_ray_through_the_plane),
        cmocka_unit_test(perspective_has_the_courses_matrix),
        cmocka_unit_test(parallel_lines_meet_at_their_vanishing_point),
        cmocka_unit_test(principal_vanishing_points_are_counted),
        cmocka_unit_test(codes_are_the_planes_sides),
        cmocka_unit_test(lines_are_cut_at_the_planes),
        cmocka_unit_test(polygons_keep_what_is_inside),
        cmocka_unit_test(what_is_behind_the_eye_stays_away),
    };
    rig.state = 12345;
    return cmocka_run_group_tests(tests, NULL, NULL);
}
