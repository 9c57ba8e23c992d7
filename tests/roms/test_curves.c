/* Bézier curves, cubics and patches (roms/curves): against the definitions in double precision,
 * numeric differentiation, and each against the others. */
#include <math.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "roms/curves/bezier.c"
#include "roms/curves/bezier_patch.c"
#include "roms/curves/bezier_run.c"
#include "roms/curves/casteljau.c"
#include "roms/curves/cubic.c"
#include "roms/curves/cubic_blending.c"
#include "roms/curves/cubic_conditions.c"
#include "roms/curves/cubic_matrix.c"

#include "tests/roms/curves_support.h"

/* ---- Bézier ---------------------------------------------------------------------------------- */

static struct vector3 casteljau_point(const struct vector3 *points, int count, float u)
{
    struct casteljau c;
    casteljau_begin(&c, points, count, u);
    while (casteljau_next(&c))
        continue;
    return casteljau_at(&c, count - 1, 0);
}

static void binomials_are_pascals(void **state)
{
    (void)state;
    uint32_t row[BEZIER_DEGREE_MOST + 2] = {1};
    for (int n = 0; n <= BEZIER_DEGREE_MOST; n++) {
        for (int k = 0; k <= n; k++)
            assert_true(bezier_binomial(n, k) == (float)row[k]);
        for (int k = n + 1; k > 0; k--)
            row[k] += row[k - 1];
    }
}

static void blending_functions_sum_to_one_and_are_not_negative(void **state)
{
    (void)state;
    for (int i = 0; i < CASES; i++) {
        float value[BEZIER_POINTS_MOST], u = random_in(0, 1);
        int n = (int)random_below(BEZIER_DEGREE_MOST + 1);
        bezier_blending(n, u, value);
        double sum = 0;
        for (int k = 0; k <= n; k++) {
            assert_true(value[k] >= 0);
            assert_near(value[k],
                        exp(lgamma(n + 1.0) - lgamma(k + 1.0) - lgamma(n - k + 1.0)) *
                            pow((double)u, k) * pow(1 - (double)u, n - k),
                        2e-6);
            sum += (double)value[k];
        }
        assert_near(sum, 1, 3e-6);
    }
}

static void points_are_those_of_the_definition_both_ways(void **state)
{
    (void)state;
    struct vector3 p[BEZIER_POINTS_MOST];
    for (int i = 0; i < CASES; i++) {
        int count = 1 + (int)random_below(BEZIER_POINTS_MOST);
        float u = random_in(0, 1);
        random_points(p, count, 100);
        struct vector3 blended = bezier_point(p, count, u), divided = casteljau_point(p, count, u);
        for (int axis = 0; axis < 3; axis++) {
            double exact = slow_bezier(p, count, axis, (double)u);
            assert_near(coordinate(blended, axis), exact, 2e-4);
            assert_near(coordinate(divided, axis), exact, 1e-4);
        }
    }
}

static void the_course_examples_come_out(void **state)
{
    (void)state;
    static const struct vector3 quadratic[] = {{4, 2, 0}, {8, 8, 0}, {16, 4, 0}};
    static const float shown[][2] = {{4, 2},         {5.76f, 4},     {7.84f, 5.2f},
                                     {10.24f, 5.6f}, {12.96f, 5.2f}, {16, 4}};
    static const struct vector3 cubic[] = {{2, 2, 0}, {2, 3, 0}, {3, 3, 0}, {3, 2, 0}};
    static const float cubic_shown[][2] = {
        {2, 2}, {2.15625f, 2.5625f}, {2.5f, 2.75f}, {2.84375f, 2.5625f}, {3, 2}};
    for (int i = 0; i <= 5; i++) {
        struct vector3 p = bezier_point(quadratic, 3, (float)i / 5);
        assert_near(p.x, shown[i][0], 2e-6);
        assert_near(p.y, shown[i][1], 2e-6);
    }
    for (int i = 0; i <= 4; i++) {
        struct vector3 p = bezier_point(cubic, 4, (float)i / 4);
        assert_true(p.x == cubic_shown[i][0] && p.y == cubic_shown[i][1] && p.z == 0);
    }
}

/* Central differences in double precision. */
static void derivatives_are_those_of_differences(void **state)
{
    (void)state;
    const double h1 = 1e-5, h2 = 1e-3;
    struct vector3 p[BEZIER_POINTS_MOST];
    for (int i = 0; i < CASES; i++) {
        int count = 1 + (int)random_below(8);
        float u = random_in(0, 1);
        random_points(p, count, 10);
        struct bezier_ends e = bezier_ends(p, count);
        struct vector3 d = bezier_derivative(p, count, u);
        for (int axis = 0; axis < 3; axis++) {
#define AT(u)     slow_bezier(p, count, axis, (u))
#define FIRST(u)  ((AT((u) + h1) - AT((u)-h1)) / (2 * h1))
#define SECOND(u) ((AT((u) + h2) - 2 * AT(u) + AT((u)-h2)) / (h2 * h2))
            assert_near(coordinate(d, axis), FIRST((double)u), 1e-3);
            assert_near(coordinate(e.first0, axis), FIRST(0.0), 1e-3);
            assert_near(coordinate(e.first1, axis), FIRST(1.0), 1e-3);
            assert_near(coordinate(e.second0, axis), SECOND(0.0), 0.2);
            assert_near(coordinate(e.second1, axis), SECOND(1.0), 0.2);
        }
    }
}

static void curves_stay_in_the_convex_hull(void **state)
{
    (void)state;
    struct vector3 p[BEZIER_POINTS_MOST];
    for (int i = 0; i < CASES; i++) {
        int count = 2 + (int)random_below(10);
        struct vector3 direction = vector3_direction(random_vector(1));
        random_points(p, count, 50);
        float low = INFINITY, high = -INFINITY;
        for (int k = 0; k < count; k++) {
            low = fminf(low, vector3_dot(direction, p[k]));
            high = fmaxf(high, vector3_dot(direction, p[k]));
        }
        for (float u = 0; u <= 1; u += 0.0625f) {
            float at = vector3_dot(direction, bezier_point(p, count, u));
            assert_true(at >= low - 1e-4f && at <= high + 1e-4f);
        }
    }
}

static void subdivision_gives_the_same_curve_in_halves_that_meet(void **state)
{
    (void)state;
    struct vector3 p[BEZIER_POINTS_MOST], left[BEZIER_POINTS_MOST], right[BEZIER_POINTS_MOST];
    for (int i = 0; i < CASES; i++) {
        int count = 1 + (int)random_below(BEZIER_POINTS_MOST);
        float cut = random_in(0.1f, 0.9f), u = random_in(0, 1);
        random_points(p, count, 100);
        struct casteljau c;
        int levels = 0;
        casteljau_begin(&c, p, count, cut);
        while (casteljau_next(&c))
            levels++;
        assert_int_equal(levels, count - 1);
        casteljau_halves(&c, left, right);
        assert_memory_equal(&left[count - 1], &right[0], sizeof left[0]);
        assert_memory_equal(&left[0], &p[0], sizeof left[0]);
        assert_memory_equal(&right[count - 1], &p[count - 1], sizeof left[0]);
        for (int axis = 0; axis < 3; axis++) {
            double a = (double)cut * (double)u, b = (double)cut + (1 - (double)cut) * (double)u;
            assert_near(coordinate(bezier_point(left, count, u), axis),
                        slow_bezier(p, count, axis, a), 4e-4);
            assert_near(coordinate(bezier_point(right, count, u), axis),
                        slow_bezier(p, count, axis, b), 4e-4);
        }
    }
}

static void lines_of_a_run_keep_the_tolerance(void **state)
{
    (void)state;
    static struct vector3 line[(1 << BEZIER_RUN_DEPTH) + 1];
    int lines = 0;
    for (int i = 0; i < 100; i++) {
        struct vector3 p[BEZIER_POINTS_MOST];
        int count = 1 + (int)random_below(7), points = 0;
        float tolerance = random_in(0.25f, 2);
        random_points(p, count, 500);
        struct bezier_run run;
        bezier_run_begin(&run, p, count, tolerance);
        while (points <= 1 << BEZIER_RUN_DEPTH && bezier_run_next(&run, &line[points]))
            points++;
        assert_true(points >= 2 && points < 400);
        assert_memory_equal(&line[0], &p[0], sizeof line[0]);
        assert_memory_equal(&line[points - 1], &p[count - 1], sizeof line[0]);
        lines += points - 1;
        for (int s = 0; s <= 500; s++) {
            double at[3], nearest = INFINITY;
            for (int axis = 0; axis < 3; axis++)
                at[axis] = slow_bezier(p, count, axis, s / 500.0);
            for (int k = 0; k + 1 < points; k++)
                nearest = fmin(nearest, from_line(at, line[k], line[k + 1]));
            assert_true(nearest <= (double)tolerance + 1e-3);
        }
    }
    assert_true(lines < 100 * 80);
}

/* ---- cubics ---------------------------------------------------------------------------------- */

/* The geometry's curve from its definition, in double precision. */
static double slow_cubic(const struct cubic_geometry *geometry, int axis, double u)
{
    double g[4], v = 1 - u, s = (1 - (double)geometry->tension) / 2;
    for (int k = 0; k < 4; k++)
        g[k] = coordinate(geometry->g[k], axis);
    double start = g[0], end = g[1], d0 = g[2], d1 = g[3];
    if (geometry->kind == CUBIC_BEZIER)
        end = g[3], d0 = 3 * (g[1] - g[0]), d1 = 3 * (g[3] - g[2]);
    if (geometry->kind == CUBIC_CARDINAL)
        start = g[1], end = g[2], d0 = s * (g[2] - g[0]), d1 = s * (g[3] - g[1]);
    if (geometry->kind == CUBIC_B_SPLINE) {
        start = (g[0] + 4 * g[1] + g[2]) / 6, end = (g[1] + 4 * g[2] + g[3]) / 6;
        d0 = (g[2] - g[0]) / 2, d1 = (g[3] - g[1]) / 2;
    }
    /* As a Bézier curve of the same ends and slopes. */
    double b1 = start + d0 / 3, b2 = end - d1 / 3;
    return v * v * v * start + 3 * u * v * v * b1 + 3 * u * u * v * b2 + u * u * u * end;
}

static struct cubic_geometry random_geometry(float size)
{
    struct cubic_geometry geometry = {.kind = (enum cubic_kind)random_below(CUBIC_KINDS),
                                      .tension = random_in(-1, 1)};
    random_points(geometry.g, 4, size);
    return geometry;
}

static void three_ways_agree(void **state)
{
    (void)state;
    for (int i = 0; i < 4 * CASES; i++) {
        struct cubic_geometry geometry = random_geometry(1000);
        double tolerance =
            (double)CUBIC_WAYS_TOLERANCE * 1000 * (1 + fabs((double)geometry.tension));
        float u = random_in(0, 1);
        struct cubic solved = cubic_by_conditions(&geometry), product = cubic_by_matrix(&geometry);
        struct vector3 way[] = {cubic_point(&solved, u), cubic_point(&product, u),
                                cubic_by_blending(&geometry, u)};
        assert_true(farthest(way[0], way[1]) <= tolerance);
        assert_true(farthest(way[1], way[2]) <= tolerance);
        assert_true(farthest(way[0], way[2]) <= tolerance);
        for (int w = 0; w < 3; w++)
            for (int axis = 0; axis < 3; axis++)
                assert_near(coordinate(way[w], axis), slow_cubic(&geometry, axis, (double)u),
                            tolerance);
    }
}

static void blending_functions_belong_to_affine_sums(void **state)
{
    (void)state;
    for (int i = 0; i < CASES; i++) {
        float value[4], u = random_in(0, 1), tension = random_in(-1, 1);
        for (int kind = 0; kind < CUBIC_KINDS; kind++) {
            cubic_blending((enum cubic_kind)kind, tension, u, value);
            float sum = kind == CUBIC_HERMITE ? value[0] + value[1]
                                              : value[0] + value[1] + value[2] + value[3];
            assert_near(sum, 1, 1e-6);
        }
    }
}

static void forward_differences_and_steps(void **state)
{
    (void)state;
    for (int i = 0; i < CASES; i++) {
        struct cubic_geometry geometry = random_geometry(300);
        struct cubic q = cubic_by_matrix(&geometry);
        int steps = cubic_steps(&q, 0.5f), n = 0;
        assert_in_range(steps, 1, CUBIC_STEPS_MOST);
        struct cubic_run run;
        struct vector3 p, before = q.d;
        cubic_run_begin(&run, &q, steps);
        for (; cubic_run_next(&run, &p); before = p, n++) {
            assert_true(farthest(p, cubic_point(&q, (float)n / (float)steps)) <= 2e-2);
            double middle[3];
            for (int axis = 0; axis < 3; axis++)
                middle[axis] = slow_cubic(&geometry, axis, (n - 0.5) / steps);
            assert_true(n == 0 || from_line(middle, before, p) <= 0.52);
        }
        assert_int_equal(n, steps + 1);
    }
    struct cubic huge = {.a = {1e30f, 0, 0}};
    assert_int_equal(cubic_steps(&huge, 0.5f), CUBIC_STEPS_MOST);
    struct cubic line = {.c = {5, 5, 0}};
    assert_int_equal(cubic_steps(&line, 0.5f), 1);
}

/* ---- patches --------------------------------------------------------------------------------- */

static void patches_are_sums_over_both_parameters(void **state)
{
    (void)state;
    for (int i = 0; i < CASES; i++) {
        struct bezier_patch patch;
        float u = random_in(0, 1), v = random_in(0, 1);
        random_points(&patch.at[0][0], 16, 20);
        struct vector3 p = bezier_patch_point(&patch, u, v), curve[4];
        for (int axis = 0; axis < 3; axis++) {
            struct vector3 row[4] = {{0, 0, 0}};
            for (int j = 0; j < 4; j++)
                row[j].x = (float)slow_bezier(patch.at[j], 4, axis, (double)v);
            assert_near(coordinate(p, axis), slow_bezier(row, 4, 0, (double)u), 3e-5);
        }
        bezier_patch_along_u(&patch, v, curve);
        assert_true(farthest(bezier_point(curve, 4, u), p) <= 3e-5);
    }
}

static void normals_are_perpendicular_to_the_surface(void **state)
{
    (void)state;
    struct bezier_patch patch;
    for (int i = 0; i < CASES; i++) {
        float u = random_in(0, 0.99f), v = random_in(0, 0.99f), h = 0.01f;
        for (int k = 0; k < 16; k++)
            patch.at[k / 4][k % 4] =
                (struct vector3){(float)(k % 4), (float)(k / 4), random_in(0, 2)};
        struct vector3 n = bezier_patch_normal(&patch, u, v), p = bezier_patch_point(&patch, u, v);
        struct vector3 du = vector3_difference(bezier_patch_point(&patch, u + h, v), p);
        struct vector3 dv = vector3_difference(bezier_patch_point(&patch, u, v + h), p);
        assert_near(vector3_length(n), 1, 1e-5);
        assert_true(n.z > 0);
        assert_true(fabsf(vector3_dot(n, vector3_direction(du))) < 0.05f);
        assert_true(fabsf(vector3_dot(n, vector3_direction(dv))) < 0.05f);
    }
    /* A row that is one point, as at the top of a teapot: the tangent along it is 0. */
    for (int k = 0; k < 4; k++)
        patch.at[0][k] = (struct vector3){1.5f, 0, 1};
    assert_near(vector3_length(bezier_patch_normal(&patch, 0, 0.5f)), 1, 1e-5);
    memset(&patch, 0, sizeof patch);
    assert_true(vector3_length(bezier_patch_normal(&patch, 0.5f, 0.5f)) == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(binomials_are_pascals),
        cmocka_unit_test(blending_functions_sum_to_one_and_are_not_negative),
        cmocka_unit_test(points_are_those_of_the_definition_both_ways),
        cmocka_unit_test(the_course_examples_come_out),
        cmocka_unit_test(derivatives_are_those_of_differences),
        cmocka_unit_test(curves_stay_in_the_convex_hull),
        cmocka_unit_test(subdivision_gives_the_same_curve_in_halves_that_meet),
        cmocka_unit_test(lines_of_a_run_keep_the_tolerance),
        cmocka_unit_test(three_ways_agree),
        cmocka_unit_test(blending_functions_belong_to_affine_sums),
        cmocka_unit_test(forward_differences_and_steps),
        cmocka_unit_test(patches_are_sums_over_both_parameters),
        cmocka_unit_test(normals_are_perpendicular_to_the_surface),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
