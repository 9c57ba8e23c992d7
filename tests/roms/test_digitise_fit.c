/* Where the paper lies (roms/digitise/fit.h): against exact transformations, and least squares in long
 * double. */
#include <math.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "roms/digitise/fit.c"

#include "tests/roms/curves_support.h"
#include "tests/roms/digitise_support.h"

/* x = m0·u + m1·v + m2, y = m3·u + m4·v + m5 */
static void random_affine(double m[6], bool similar)
{
    double a = (double)random_in(-3.1f, 3.1f), s = (double)random_in(0.05f, 0.2f);
    double t = (double)random_in(0.05f, 0.2f), skew = (double)random_in(-0.4f, 0.4f);
    m[0] = s * cos(a);
    m[3] = s * sin(a);
    m[1] = similar ? -m[3] : -t * sin(a + skew);
    m[4] = similar ? m[0] : t * cos(a + skew);
    m[2] = (double)random_in(-300, 300);
    m[5] = (double)random_in(-300, 300);
}

static struct point2 apply(const double m[6], struct point2 p)
{
    return (struct point2){(float)(m[0] * (double)p.x + m[1] * (double)p.y + m[2]),
                           (float)(m[3] * (double)p.x + m[4] * (double)p.y + m[5])};
}

/* On a wide ring, so that they never lie on a line. */
static void random_pairs(struct fit_pair *pair, int count, const double m[6], double noise)
{
    float turn = random_in(0, 6.3f);
    for (int i = 0; i < count; i++) {
        float angle = turn + 6.2831853f * (float)i / (float)count, r = random_in(700, 1300);
        pair[i].touched = (struct point2){1400 + r * cosf(angle), 1400 + r * sinf(angle)};
        pair[i].known = apply(m, pair[i].touched);
        pair[i].touched.x += (float)(noise * normal());
        pair[i].touched.y += (float)(noise * normal());
    }
}

static void exact_points_give_the_transformation(void **state)
{
    (void)state;
    for (int i = 0; i < 1000; i++) {
        struct fit_pair pair[FIT_POINTS_MOST];
        struct fit f;
        double m[6];
        bool affine = i % 2;
        int count = (affine ? 3 : 2) + (int)random_below(5);
        random_affine(m, !affine);
        random_pairs(pair, count, m, 0);
        assert_null(fit_points(pair, count, affine, &f));
        assert_true(f.residual < 2e-3f);
        assert_int_equal(f.checked, count > (affine ? 3 : 2));
        for (int k = 0; k < 10; k++) {
            struct point2 p = {random_in(-100, 2900), random_in(-100, 2900)}, q = apply(m, p);
            assert_near(fit_place(&f, p).x, q.x, 2e-3);
            assert_near(fit_place(&f, p).y, q.y, 2e-3);
        }
        if (!affine) {
            assert_near(fit_scale(&f), hypot(m[0], m[3]), 1e-6);
            assert_near(remainder((double)fit_turn(&f) + atan2(m[3], m[0]) * 180 / TEST_PI, 360), 0,
                        1e-3);
        }
    }
}

/* Elimination with pivots. */
static void solve(int n, long double a[4][5], long double *x)
{
    for (int c = 0; c < n; c++) {
        int pivot = c;
        for (int r = c + 1; r < n; r++)
            pivot = fabsl(a[r][c]) > fabsl(a[pivot][c]) ? r : pivot;
        for (int k = 0; k <= n; k++) {
            long double t = a[c][k];
            a[c][k] = a[pivot][k];
            a[pivot][k] = t;
        }
        for (int r = 0; r < n; r++) {
            long double factor = r == c ? 0 : a[r][c] / a[c][c];
            for (int k = 0; k <= n; k++)
                a[r][k] -= factor * a[c][k];
        }
    }
    for (int r = 0; r < n; r++)
        x[r] = a[r][n] / a[r][r];
}

/* Normal equations of rows · unknowns = values, without any centroid. */
static void least_squares(int n, long double (*row)[4], const long double *value, int rows,
                          long double *x)
{
    long double a[4][5] = {{0}};
    for (int i = 0; i < rows; i++)
        for (int r = 0; r < n; r++) {
            for (int c = 0; c < n; c++)
                a[r][c] += row[i][r] * row[i][c];
            a[r][n] += row[i][r] * value[i];
        }
    solve(n, a, x);
}

/* The six numbers by the definition of each model. */
static void slow_fit(const struct fit_pair *p, int count, bool affine, long double m[6])
{
    long double row[2 * FIT_POINTS_MOST][4], value[2 * FIT_POINTS_MOST], x[4];
    for (int axis = 0; affine && axis < 2; axis++) {
        for (int i = 0; i < count; i++) {
            const long double r[4] = {p[i].touched.x, p[i].touched.y, 1, 0};
            memcpy(row[i], r, sizeof r);
            value[i] = axis ? p[i].known.y : p[i].known.x;
        }
        least_squares(3, row, value, count, m + 3 * axis);
    }
    for (int i = 0; !affine && i < count; i++) {
        const long double u = p[i].touched.x, v = p[i].touched.y;
        const long double r0[4] = {u, -v, 1, 0}, r1[4] = {v, u, 0, 1};
        memcpy(row[2 * i], r0, sizeof r0);
        memcpy(row[2 * i + 1], r1, sizeof r1);
        value[2 * i] = p[i].known.x;
        value[2 * i + 1] = p[i].known.y;
    }
    if (affine)
        return;
    least_squares(4, row, value, 2 * count, x);
    const long double out[6] = {x[0], -x[1], x[2], x[1], x[0], x[3]};
    memcpy(m, out, sizeof out);
}

static void noisy_points_give_the_least_squares(void **state)
{
    (void)state;
    for (int i = 0; i < 1000; i++) {
        struct fit_pair pair[FIT_POINTS_MOST];
        struct fit f;
        double m[6];
        long double slow[6], sum = 0;
        bool affine = i % 2;
        int count = 4 + (int)random_below(5);
        random_affine(m, random_below(2));
        random_pairs(pair, count, m, 5);
        assert_null(fit_points(pair, count, affine, &f));
        slow_fit(pair, count, affine, slow);
        for (int k = 0; k < count; k++) {
            struct point2 p = pair[k].touched, at = fit_place(&f, p);
            long double x = slow[0] * p.x + slow[1] * p.y + slow[2];
            long double y = slow[3] * p.x + slow[4] * p.y + slow[5];
            assert_near(at.x, (double)x, 3e-3);
            assert_near(at.y, (double)y, 3e-3);
            sum += (x - pair[k].known.x) * (x - pair[k].known.x) +
                   (y - pair[k].known.y) * (y - pair[k].known.y);
        }
        assert_near(f.residual, (double)sqrtl(sum / count), 3e-3);
    }
}

static void points_that_fix_nothing_are_refused(void **state)
{
    (void)state;
    struct fit was = fit_tablet(0.1f), f = was;
    struct fit_pair same[3] = {{{5, 5}, {0, 0}}, {{5, 5}, {200, 0}}, {{5, 5}, {0, 150}}};
    struct fit_pair line[3] = {
        {{100, 100}, {0, 0}}, {{1100, 600}, {200, 0}}, {{2100, 1100}, {0, 150}}};
    assert_non_null(fit_points(same, 1, false, &f));
    assert_non_null(fit_points(same, 2, false, &f));
    assert_non_null(fit_points(same, 3, true, &f));
    assert_non_null(fit_points(line, 2, true, &f));
    assert_non_null(fit_points(line, 3, true, &f));
    assert_memory_equal(&f, &was, sizeof f);
    assert_null(fit_points(line, 3, false, &f));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exact_points_give_the_transformation),
        cmocka_unit_test(noisy_points_give_the_least_squares),
        cmocka_unit_test(points_that_fix_nothing_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
