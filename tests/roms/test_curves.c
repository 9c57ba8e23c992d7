/* Curves (roms/curves): against the definitions in double precision, dense equations, numeric
 * differentiation, and each against the others. */
#include <math.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "roms/curves/b_spline.c"
#include "roms/curves/bezier.c"
#include "roms/curves/bezier_patch.c"
#include "roms/curves/bezier_run.c"
#include "roms/curves/casteljau.c"
#include "roms/curves/continuity.c"
#include "roms/curves/cubic.c"
#include "roms/curves/cubic_blending.c"
#include "roms/curves/cubic_conditions.c"
#include "roms/curves/cubic_matrix.c"
#include "roms/curves/key_frames.c"
#include "roms/curves/spline.c"
#include "roms/curves/tridiagonal.c"

enum { CASES = 3000, DENSE = 4 * SPLINE_PIECES_MOST };

static uint32_t random_state = 1;

static uint32_t random_below(uint32_t limit)
{
    random_state = random_state * 1664525u + 1013904223u;
    return (random_state >> 8) % limit;
}

static float random_in(float low, float high)
{
    return low + (high - low) * (float)random_below(1 << 20) / (1 << 20);
}

static struct vector3 random_vector(float size)
{
    return (struct vector3){random_in(-size, size), random_in(-size, size), random_in(-size, size)};
}

static void random_points(struct vector3 *points, int count, float size)
{
    for (int i = 0; i < count; i++)
        points[i] = random_vector(size);
}

static double coordinate(struct vector3 v, int axis)
{
    return axis == 0 ? (double)v.x : axis == 1 ? (double)v.y : (double)v.z;
}

static double farthest(struct vector3 a, struct vector3 b)
{
    double most = 0;
    for (int axis = 0; axis < 3; axis++)
        most = fmax(most, fabs(coordinate(a, axis) - coordinate(b, axis)));
    return most;
}

#define assert_near(a, b, tolerance)                                                               \
    do {                                                                                           \
        double near_a = (a), near_b = (b), near_t = (tolerance);                                   \
        if (!(fabs(near_a - near_b) <= near_t))                                                    \
            fail_msg("%s = %.9g, not %.9g within %.3g", #a, near_a, near_b, near_t);               \
    } while (0)

/* De Casteljau in double precision, a coordinate. */
static double slow_bezier(const struct vector3 *points, int count, int axis, double u)
{
    double at[BEZIER_POINTS_MOST];
    for (int i = 0; i < count; i++)
        at[i] = coordinate(points[i], axis);
    for (int n = count - 1; n > 0; n--)
        for (int i = 0; i < n; i++)
            at[i] += u * (at[i + 1] - at[i]);
    return at[0];
}

/* Elimination with pivots, in double precision; the matrix is used up. */
static double dense[DENSE][DENSE + 1];

static void dense_solve(int count, double *x)
{
    for (int c = 0; c < count; c++) {
        int pivot = c;
        for (int r = c + 1; r < count; r++)
            pivot = fabs(dense[r][c]) > fabs(dense[pivot][c]) ? r : pivot;
        for (int k = 0; k <= count; k++) {
            double t = dense[c][k];
            dense[c][k] = dense[pivot][k];
            dense[pivot][k] = t;
        }
        assert_true(dense[c][c] != 0);
        for (int r = c + 1; r < count; r++) {
            double factor = dense[r][c] / dense[c][c];
            for (int k = c; factor != 0 && k <= count; k++)
                dense[r][k] -= factor * dense[c][k];
        }
    }
    for (int r = count - 1; r >= 0; r--) {
        x[r] = dense[r][count];
        for (int k = r + 1; k < count; k++)
            x[r] -= dense[r][k] * x[k];
        x[r] /= dense[r][r];
    }
}

/* ---- Bézier -------------------------------------------------------------------------------------- */

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

/* Distance of a place from a line. */
static double from_line(const double at[3], struct vector3 a, struct vector3 b)
{
    double along[3], to[3], square = 0, dot = 0, rest = 0;
    for (int k = 0; k < 3; k++) {
        along[k] = coordinate(b, k) - coordinate(a, k);
        to[k] = at[k] - coordinate(a, k);
        square += along[k] * along[k];
        dot += along[k] * to[k];
    }
    double t = square > 0 ? fmin(fmax(dot / square, 0), 1) : 0;
    for (int k = 0; k < 3; k++)
        rest += (to[k] - t * along[k]) * (to[k] - t * along[k]);
    return sqrt(rest);
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

/* ---- cubics --------------------------------------------------------------------------------------- */

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

/* ---- splines -------------------------------------------------------------------------------------- */

static void three_right_sides_of_neighbours(void **state)
{
    (void)state;
    for (int i = 0; i < 500; i++) {
        float a[32], b[32], c[32];
        struct vector3 r[32];
        double exact[3][32];
        int count = 1 + (int)random_below(32);
        for (int k = 0; k < count; k++) {
            a[k] = random_in(-1, 1);
            c[k] = random_in(-1, 1);
            b[k] = (fabsf(a[k]) + fabsf(c[k]) + 0.5f) * (random_below(2) ? 1 : -1);
        }
        random_points(r, count, 10);
        for (int axis = 0; axis < 3; axis++) {
            memset(dense, 0, sizeof dense);
            for (int k = 0; k < count; k++) {
                if (k > 0)
                    dense[k][k - 1] = (double)a[k];
                dense[k][k] = (double)b[k];
                if (k + 1 < count)
                    dense[k][k + 1] = (double)c[k];
                dense[k][count] = coordinate(r[k], axis);
            }
            dense_solve(count, exact[axis]);
        }
        tridiagonal_solve(a, b, c, r, count);
        for (int k = 0; k < count; k++)
            for (int axis = 0; axis < 3; axis++)
                assert_near(coordinate(r[k], axis), exact[axis][k], 1e-4);
    }
}

/* Condition `row`: derivative `order` of piece `piece` at u, times `sign`, into the dense matrix. */
static void condition(int row, int piece, int order, double h, double u, double sign)
{
    double *at = &dense[row][4 * piece], t = u * h;
    const double of[3][4] = {{t * t * t, t * t, t, 1}, {3 * t * t, 2 * t, 1, 0}, {6 * t, 2, 0, 0}};
    for (int k = 0; k < 4; k++)
        at[k] += sign * of[order][k];
}

/* All 4n conditions of an interpolating spline at once: coefficients a b c d of each piece in t. */
static void dense_spline(const struct vector3 *p, const float *knot, int pieces, int axis,
                         bool clamped, double slope0, double slope1, double *x)
{
    int row = 0, columns = 4 * pieces;
    memset(dense, 0, sizeof dense);
    for (int i = 0; i < pieces; i++) {
        double h = (double)knot[i + 1] - (double)knot[i];
        condition(row, i, 0, h, 0, 1);
        dense[row++][columns] = coordinate(p[i], axis);
        condition(row, i, 0, h, 1, 1);
        dense[row++][columns] = coordinate(p[i + 1], axis);
        for (int order = 1; order <= 2 && i + 1 < pieces; order++, row++) {
            condition(row, i, order, h, 1, 1);
            condition(row, i + 1, order, 1, 0, -1);
        }
    }
    double last = (double)knot[pieces] - (double)knot[pieces - 1];
    condition(row, 0, clamped ? 1 : 2, 1, 0, 1);
    dense[row++][columns] = clamped ? slope0 : 0;
    condition(row, pieces - 1, clamped ? 1 : 2, last, 1, 1);
    dense[row++][columns] = clamped ? slope1 : 0;
    dense_solve(columns, x);
}

static void natural_and_clamped_are_those_of_dense_equations(void **state)
{
    (void)state;
    double x[DENSE];
    for (int i = 0; i < 150; i++) {
        struct vector3 p[SPLINE_POINTS_MOST], s0 = random_vector(30), s1 = random_vector(30);
        struct spline s;
        int count = i == 0 ? SPLINE_POINTS_MOST : 2 + (int)random_below(12);
        bool clamped = i % 2;
        enum spline_parameter parameter = (enum spline_parameter)random_below(3);
        random_points(p, count, 50);
        assert_true(clamped ? spline_clamped(p, count, parameter, s0, s1, &s)
                            : spline_natural(p, count, parameter, &s));
        assert_int_equal(s.pieces, count - 1);
        for (int axis = 0; axis < 3; axis++) {
            dense_spline(p, s.knot, s.pieces, axis, clamped, coordinate(s0, axis),
                         coordinate(s1, axis), x);
            for (int k = 0; k < 4 * s.pieces; k++) {
                int piece = k / 4;
                float h = s.knot[piece + 1] - s.knot[piece], t = h * (float)(k % 4 + 1) / 5;
                const double *c = &x[4 * piece];
                double exact = ((c[0] * (double)t + c[1]) * (double)t + c[2]) * (double)t + c[3];
                struct vector3 at = spline_point(&s, s.knot[piece] + t);
                assert_near(coordinate(at, axis), exact, 5e-3);
            }
        }
    }
}

/* The differences at all inner joins, relative to what they compare; of places to the length of the
 * tangents over a piece, too, which is what its coefficients cancel from. */
static void joins(const struct spline *s, float worst[3])
{
    worst[0] = worst[1] = worst[2] = 0;
    for (int i = 0; i + 1 < s->pieces; i++) {
        struct join j = spline_join(s, i);
        for (int n = 0; n < 3; n++) {
            float size = 1 + vector3_length(j.p[n]) + vector3_length(j.q[n]);
            if (n == 0)
                size += vector3_length(j.p[1]) * (s->knot[i + 2] - s->knot[i]);
            worst[n] = fmaxf(worst[n], vector3_length(vector3_difference(j.q[n], j.p[n])) / size);
        }
    }
}

static void splines_have_the_continuity_they_claim(void **state)
{
    (void)state;
    float worst[3];
    int broken = 0;
    for (int i = 0; i < 500; i++) {
        struct vector3 p[SPLINE_POINTS_MOST], slope[SPLINE_POINTS_MOST];
        struct spline s;
        int count = 5 + (int)random_below(12);
        random_points(p, count, 50);
        random_points(slope, count, 50);
        enum spline_parameter parameter = (enum spline_parameter)random_below(3);
        assert_true(spline_natural(p, count, parameter, &s));
        joins(&s, worst);
        assert_true(worst[0] < 1e-5f && worst[1] < 1e-4f && worst[2] < 1e-3f);
        struct cubic first = cubic_by_matrix(&s.piece[0]);
        struct cubic last = cubic_by_matrix(&s.piece[s.pieces - 1]);
        assert_true(vector3_length(cubic_derivative(&first, 2, 0)) < 2e-2f);
        assert_true(vector3_length(cubic_derivative(&last, 2, 1)) < 2e-2f);
        for (int k = 0; k < count; k++)
            assert_true(farthest(spline_point(&s, s.knot[k]), p[k]) <= 1e-4);
        assert_true(spline_clamped(p, count, parameter, slope[0], slope[1], &s));
        joins(&s, worst);
        assert_true(worst[0] < 1e-5f && worst[1] < 1e-4f && worst[2] < 1e-3f);
        first = cubic_by_matrix(&s.piece[0]);
        last = cubic_by_matrix(&s.piece[s.pieces - 1]);
        float h1 = s.knot[s.pieces] - s.knot[s.pieces - 1];
        assert_true(farthest(vector3_times(cubic_derivative(&first, 1, 0), 1 / s.knot[1]),
                             slope[0]) < 1e-3);
        assert_true(farthest(vector3_times(cubic_derivative(&last, 1, 1), 1 / h1), slope[1]) <
                    1e-3);
        assert_true(spline_b_spline(p, count, &s));
        joins(&s, worst);
        assert_true(worst[0] < 1e-5f && worst[1] < 1e-5f && worst[2] < 1e-4f);
        assert_true(spline_cardinal(p, count, random_in(-1, 0.9f), &s));
        joins(&s, worst);
        assert_true(worst[0] < 1e-5f && worst[1] < 1e-4f);
        broken += worst[2] > 0.01f;
        for (int k = 0; k <= s.pieces; k++)
            assert_true(farthest(spline_point(&s, s.knot[k]), p[k + 1]) <= 1e-4);
        assert_true(spline_hermite(p, slope, count, &s));
        joins(&s, worst);
        assert_true(worst[0] < 1e-5f && worst[1] < 1e-5f);
        broken += worst[2] > 0.01f;
    }
    /* Cardinal and Hermite splines of points that were not chosen for it are not C2. */
    assert_true(broken >= 990);
}

static void wrong_counts_are_refused(void **state)
{
    (void)state;
    struct vector3 p[SPLINE_POINTS_MOST + 1] = {{0, 0, 0}};
    struct spline s;
    assert_false(spline_natural(p, 1, SPLINE_UNIFORM, &s));
    assert_false(spline_natural(p, SPLINE_POINTS_MOST + 1, SPLINE_UNIFORM, &s));
    assert_false(spline_natural(p, 3, SPLINE_CHORDAL, &s));
    assert_true(spline_natural(p, 3, SPLINE_UNIFORM, &s));
    assert_false(spline_cardinal(p, 3, 0, &s));
    assert_false(spline_b_spline(p, SPLINE_POINTS_MOST + 1, &s));
    assert_false(spline_bezier(p, 5, &s));
    assert_true(spline_bezier(p, 7, &s));
    assert_int_equal(s.pieces, 2);
}

/* A point of a drawing by weights and by a spline of its own. */
static void key_weights_are_those_of_a_spline_a_point(void **state)
{
    (void)state;
    for (int i = 0; i < CASES; i++) {
        struct vector3 key[KEY_FRAMES_MOST], sum = {0, 0, 0}, line = {0, 0, 0};
        struct spline s;
        float weight[KEY_FRAMES_MOST];
        int keys = 2 + (int)random_below(KEY_FRAMES_MOST - 1);
        float t = i % 4 == 0 ? (float)random_below((uint32_t)keys) : random_in(0, (float)keys - 1);
        random_points(key, keys, 100);
        assert_true(spline_natural(key, keys, SPLINE_UNIFORM, &s));
        key_weights(KEY_SPLINE, keys, t, weight);
        for (int k = 0; k < keys; k++)
            sum = vector3_sum(sum, vector3_times(key[k], weight[k]));
        assert_true(farthest(sum, spline_point(&s, t)) < 1e-3);
        key_weights(KEY_LINEAR, keys, t, weight);
        for (int k = 0; k < keys; k++)
            line = vector3_sum(line, vector3_times(key[k], weight[k]));
        int before = (int)fminf(t, (float)keys - 2);
        double at[3] = {(double)line.x, (double)line.y, (double)line.z};
        assert_true(from_line(at, key[before], key[before + 1]) < 1e-3);
        if (i % 4 == 0) {
            assert_true(farthest(line, key[(int)t]) < 1e-4);
            assert_true(farthest(sum, key[(int)t]) < 1e-3);
        }
    }
}

static void timings_run_from_the_first_key_to_the_last(void **state)
{
    (void)state;
    for (int timing = 0; timing < KEY_TIMINGS; timing++) {
        float before = 0;
        for (int i = 0; i <= 100; i++) {
            float t = key_time((enum key_timing)timing, 5, (float)i / 100);
            assert_true(t >= before && t - before < 0.1f);
            if (i % 25 == 0 && timing != KEY_EASE)
                assert_near(t, i / 25, 1e-5);
            before = t;
        }
        assert_near(key_time((enum key_timing)timing, 5, 0), 0, 0);
        assert_near(key_time((enum key_timing)timing, 5, 7), 4, 0);
    }
    /* Slowly: over the first twentieth of the whole, or of a span, less than half the even way. */
    assert_true(key_time(KEY_EASE, 5, 0.05f) < 0.1f);
    assert_true(key_time(KEY_HOLD, 5, 0.2625f) - 1 < 0.025f);
}

/* ---- B-splines over knots ------------------------------------------------------------------------- */

/* 1/d! · Σ (−1)^i · C(d+1,i) · max(0, t − i)^d: the uniform basis function that begins at 0. */
static double truncated_powers(int d, double t)
{
    double sum = 0, binomial = 1, factorial = 1;
    for (int i = 0; i <= d + 1; i++) {
        if (t > i)
            sum += binomial * pow(t - i, d);
        binomial *= -(double)(d + 1 - i) / (i + 1);
    }
    for (int i = 2; i <= d; i++)
        factorial *= i;
    return sum / factorial;
}

static void bases_are_those_of_truncated_powers(void **state)
{
    (void)state;
    for (int i = 0; i < CASES; i++) {
        struct b_spline s = {.degree = 1 + (int)random_below(B_SPLINE_DEGREE_MOST)};
        s.count = s.degree + 1 + (int)random_below(8);
        b_spline_uniform(&s);
        assert_null(b_spline_trouble(&s));
        float value[B_SPLINE_POINTS_MOST], t = random_in(b_spline_start(&s), b_spline_end(&s));
        b_spline_basis(&s, t, value);
        for (int k = 0; k < s.count; k++)
            assert_near(value[k], truncated_powers(s.degree, (double)t - k), 2e-5);
    }
}

static void de_boor_is_the_sum_over_the_basis(void **state)
{
    (void)state;
    for (int i = 0; i < CASES; i++) {
        struct b_spline s = {.degree = 1 + (int)random_below(B_SPLINE_DEGREE_MOST)};
        s.count = s.degree + 1 + (int)random_below((uint32_t)(B_SPLINE_POINTS_MOST - s.degree));
        random_points(s.point, s.count, 100);
        b_spline_open(&s);
        if (i % 3 == 0) /* any knots, some of them repeated */
            for (int k = 1; k < s.count + s.degree + 1; k++)
                s.knot[k] = s.knot[k - 1] + (random_below(3) ? random_in(0.1f, 1) : 0);
        if (b_spline_trouble(&s) != NULL)
            continue;
        float value[B_SPLINE_POINTS_MOST];
        float t = i % 5 == 0 ? b_spline_end(&s) : random_in(b_spline_start(&s), b_spline_end(&s));
        double sum = 0, at[3] = {0, 0, 0};
        b_spline_basis(&s, t, value);
        for (int k = 0; k < s.count; k++) {
            assert_true(value[k] >= -1e-6f);
            sum += (double)value[k];
            for (int axis = 0; axis < 3; axis++)
                at[axis] += (double)value[k] * coordinate(s.point[k], axis);
        }
        assert_near(sum, 1, 1e-5);
        for (int axis = 0; axis < 3; axis++)
            assert_near(coordinate(b_spline_point(&s, t), axis), at[axis], 2e-3);
    }
}

static void b_splines_hold_bezier_curves_and_uniform_pieces(void **state)
{
    (void)state;
    for (int i = 0; i < CASES; i++) {
        struct b_spline s = {.degree = 1 + (int)random_below(B_SPLINE_DEGREE_MOST)};
        s.count = s.degree + 1;
        random_points(s.point, s.count, 100);
        b_spline_open(&s);
        float u = random_in(0, 1);
        assert_true(farthest(b_spline_point(&s, u), bezier_point(s.point, s.count, u)) <= 1e-3);
        struct spline pieces;
        s.degree = 3;
        s.count = 9;
        random_points(s.point, s.count, 100);
        b_spline_uniform(&s);
        assert_true(spline_b_spline(s.point, s.count, &pieces));
        float t = random_in(0, (float)pieces.pieces);
        assert_true(farthest(b_spline_point(&s, t + 3), spline_point(&pieces, t)) <= 1e-3);
    }
}

static void impossible_knots_are_named(void **state)
{
    (void)state;
    struct b_spline s = {.degree = 8, .count = 9};
    assert_non_null(b_spline_trouble(&s));
    s = (struct b_spline){.degree = 3, .count = 3};
    assert_non_null(b_spline_trouble(&s));
    s.count = 5;
    assert_non_null(b_spline_trouble(&s)); /* all knots 0 */
    b_spline_open(&s);
    assert_null(b_spline_trouble(&s));
    s.knot[5] = -1;
    assert_non_null(b_spline_trouble(&s));
}

/* ---- joins ---------------------------------------------------------------------------------------- */

/* Continuity flags as c0 c1 c2 g0 g1 g2. */
static int flags(const struct join *j)
{
    struct continuity c = continuity_of(j);
    return c.c0 << 5 | c.c1 << 4 | c.c2 << 3 | c.g0 << 2 | c.g1 << 1 | c.g2;
}

static void joins_made_to_be_smooth_are(void **state)
{
    (void)state;
    for (int i = 0; i < CASES; i++) {
        struct vector3 p = random_vector(100), d = random_vector(50), b = random_vector(80);
        if (vector3_length(d) < 5 || vector3_length(b) < 5 ||
            vector3_length(vector3_cross(vector3_direction(d), vector3_direction(b))) < 0.1f)
            continue;
        float k = random_in(0.2f, 0.8f) * (float)(1 + 2 * random_below(2)), m = random_in(-3, 3);
        k = fabsf(k - 1) < 0.05f ? 2 : k;
        struct vector3 bent = vector3_sum(vector3_times(b, k * k), vector3_times(d, m));
        struct vector3 off = vector3_times(vector3_cross(vector3_direction(d), b), 0.1f);
        struct join j = {{p, d, b}, {p, d, b}};
        assert_int_equal(flags(&j), 077); /* C2, so G2 */
        j.q[2] = vector3_sum(b, off);
        assert_int_equal(flags(&j), 066); /* C1 */
        j.q[2] = vector3_sum(b, vector3_times(d, 0.5f));
        assert_int_equal(flags(&j), 067); /* C1, and G2 */
        j.q[1] = vector3_times(d, k);
        j.q[2] = bent;
        assert_int_equal(flags(&j), 047); /* G2, but C0 only */
        struct continuity c = continuity_of(&j);
        assert_near(c.k, k, 1e-4);
        assert_near(c.m, m, 1e-2);
        j.q[2] = vector3_sum(bent, off);
        assert_int_equal(flags(&j), 046); /* G1 */
        j.q[1] = vector3_times(d, -k);
        assert_int_equal(flags(&j), 044); /* back: not even G1 */
        j.q[1] = vector3_sum(vector3_times(d, k), off);
        assert_int_equal(flags(&j), 044);
        j.q[1] = (struct vector3){0, 0, 0};
        assert_int_equal(flags(&j), 044); /* no direction */
        j = (struct join){{p, d, b}, {vector3_sum(p, vector3_times(d, 0.01f)), d, b}};
        assert_int_equal(flags(&j), 0); /* a gap */
    }
}

/* ---- patches -------------------------------------------------------------------------------------- */

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
        cmocka_unit_test(three_right_sides_of_neighbours),
        cmocka_unit_test(natural_and_clamped_are_those_of_dense_equations),
        cmocka_unit_test(splines_have_the_continuity_they_claim),
        cmocka_unit_test(wrong_counts_are_refused),
        cmocka_unit_test(key_weights_are_those_of_a_spline_a_point),
        cmocka_unit_test(timings_run_from_the_first_key_to_the_last),
        cmocka_unit_test(bases_are_those_of_truncated_powers),
        cmocka_unit_test(de_boor_is_the_sum_over_the_basis),
        cmocka_unit_test(b_splines_hold_bezier_curves_and_uniform_pieces),
        cmocka_unit_test(impossible_knots_are_named),
        cmocka_unit_test(joins_made_to_be_smooth_are),
        cmocka_unit_test(patches_are_sums_over_both_parameters),
        cmocka_unit_test(normals_are_perpendicular_to_the_surface),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
