/* Splines, B-splines, key frames and joins (roms/curves): against dense equations and truncated
 * powers in double precision, and each against the others. */
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
#include "roms/curves/continuity.c"
#include "roms/curves/cubic.c"
#include "roms/curves/cubic_blending.c"
#include "roms/curves/cubic_conditions.c"
#include "roms/curves/cubic_matrix.c"
#include "roms/curves/key_frames.c"
#include "roms/curves/spline.c"
#include "roms/curves/tridiagonal.c"

#include "tests/roms/curves_support.h"

enum { DENSE = 4 * SPLINE_PIECES_MOST };

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

/* ---- splines --------------------------------------------------------------------------------- */

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

/* Condition `row`: derivative `order` of piece `piece` at u, times `sign`, into the dense
 * matrix. */
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

/* ---- B-splines over knots -------------------------------------------------------------------- */

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

/* ---- joins ----------------------------------------------------------------------------------- */

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
        j.q[1] = vector3_times(d, 1e-20f);
        assert_int_equal(flags(&j), 044); /* as good as none */
        assert_true(continuity_of(&j).k == 0);
        j = (struct join){{p, d, b}, {vector3_sum(p, vector3_times(d, 0.01f)), d, b}};
        assert_int_equal(flags(&j), 0); /* a gap */
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
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
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
