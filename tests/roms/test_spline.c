/* Curves of roms/spline: against de Casteljau, basis functions and numeric differences in double
 * precision; smooth joints over random drags; hulls; closed splines. */
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
#include "roms/curves/cubic_matrix.c"
#include "roms/curves/spline.c"
#include "roms/curves/tridiagonal.c"
#include "roms/spline/curve.c"
#include "roms/spline/curve_kinds.c"
#include "roms/spline/history.c"
#include "roms/spline/hull.c"
#include "roms/spline/model.c"
#include "roms/spline/periodic.c"

#include "tests/roms/curves_support.h"
#include "tests/roms/spline_support.h"

enum { MODELS = 300 };

static void make(struct model *m, struct curve *c, enum model_kind kind, bool closed)
{
    random_model(m, kind, closed, 30);
    m->parameter = (enum spline_parameter)random_below(3);
    assert_null(curve_of(m, c));
}

static int order_of(const struct curve *c)
{
    assert_true(c->order > 1);
    return c->order > 1 ? c->order : 1; /* so that a compiler sees it, too */
}

/* ---- points ------------------------------------------------------------------------------------ */

static void bezier_curves_and_pieces_are_de_casteljaus(void **state)
{
    (void)state;
    struct model m;
    struct curve c;
    for (int i = 0; i < MODELS; i++) {
        make(&m, &c, i % 2 ? MODEL_BEZIER : MODEL_PIECES, random_below(2));
        float part = random_in(0, 1);
        struct curve_place p = curve_at(&c, curve_t(&c, part));
        struct vector3 q[BEZIER_POINTS_MOST];
        int count = 4, next = (p.piece + 1) % m.count;
        if (m.kind == MODEL_PIECES) {
            q[0] = m.point[p.piece].at;
            q[1] = vector3_sum(q[0], m.point[p.piece].out);
            q[2] = vector3_sum(m.point[next].at, m.point[next].in);
            q[3] = m.point[next].at;
        } else {
            for (count = 0; count < m.count + m.closed; count++)
                q[count] = m.point[count % m.count].at;
        }
        for (int axis = 0; axis < 2; axis++)
            assert_near(coordinate(p.at, axis), slow_bezier(q, count, axis, (double)p.u), 0.01);
    }
}

/* The four polynomials of the uniform cubic basis. */
static void b_splines_are_weighted_means(void **state)
{
    (void)state;
    struct model m;
    struct curve c;
    for (int i = 0; i < MODELS; i++) {
        make(&m, &c, MODEL_B_SPLINE, random_below(2));
        assert_int_equal(c.pieces, m.closed ? m.count : m.count - 3);
        struct curve_place p = curve_at(&c, curve_t(&c, random_in(0, 1)));
        double u = (double)p.u, v = 1 - u;
        double b[4] = {v * v * v / 6, (3 * u * u * u - 6 * u * u + 4) / 6,
                       (-3 * u * u * u + 3 * u * u + 3 * u + 1) / 6, u * u * u / 6};
        for (int axis = 0; axis < 2; axis++) {
            double sum = 0;
            for (int k = 0; k < 4; k++)
                sum += b[k] * coordinate(m.point[(p.piece + k) % m.count].at, axis);
            assert_near(coordinate(p.at, axis), sum, 0.01);
        }
    }
}

/* Through the points, C2 at every joint, and straight or closed at the ends: only one curve is. */
static void natural_and_periodic_splines(void **state)
{
    (void)state;
    struct model m;
    struct curve c;
    for (int i = 0; i < MODELS; i++) {
        make(&m, &c, MODEL_NATURAL, i % 2);
        assert_int_equal(c.pieces, m.count - !m.closed);
        for (int k = 0; k <= c.pieces; k++)
            assert_true(farthest(curve_at(&c, c.knot[k]).at, m.point[k % m.count].at) < 0.01);
        for (int k = 0; k < curve_joints(&c); k++) {
            struct join j = curve_join(&c, k);
            double slope = 1 + vector3_length(j.p[1]) + vector3_length(j.q[1]);
            double bend = 1 + vector3_length(j.p[2]) + vector3_length(j.q[2]);
            for (int n = 0; n < c.pieces; n++) /* the roundings of short pieces are the worst */
                bend += 1e-2 * vector3_length(curve_at(&c, c.knot[n]).second);
            assert_true(farthest(j.p[0], j.q[0]) < 0.01);
            assert_true(farthest(j.p[1], j.q[1]) < 2e-4 * slope);
            assert_true(farthest(j.p[2], j.q[2]) < 1e-2 * bend);
        }
        if (m.closed)
            continue;
        double most = 1;
        for (int k = 0; k <= c.pieces; k++)
            most = fmax(most, (double)vector3_length(curve_at(&c, c.knot[k]).second));
        assert_true((double)vector3_length(curve_at(&c, c.knot[0]).second) < 1e-2 * most);
        assert_true((double)vector3_length(curve_at(&c, c.knot[c.pieces]).second) < 1e-2 * most);
    }
}

static void points_that_coincide_have_no_spline_by_distance(void **state)
{
    (void)state;
    struct curve c;
    for (int closed = 0; closed < 2; closed++) {
        struct model m = {.kind = MODEL_NATURAL, .parameter = SPLINE_CHORDAL, .closed = closed};
        for (int i = 0; i < 4; i++)
            model_add(&m, i, (struct vector3){i < 2 ? 100 : 300, (float)(100 * i / 2), 0});
        model_move(&m, 1, m.point[0].at);
        assert_non_null(curve_of(&m, &c));
        m.parameter = SPLINE_UNIFORM;
        assert_null(curve_of(&m, &c));
    }
}

/* ---- derivatives, curvature, measures ---------------------------------------------------------- */

static void derivatives_are_those_of_differences(void **state)
{
    (void)state;
    struct model m;
    struct curve c;
    for (int i = 0; i < MODELS; i++) {
        make(&m, &c, MODEL_BEZIER, false);
        double u = (double)random_in(0.1f, 0.9f), h = 1e-4, x[3], y[3];
        struct curve_place p = curve_at(&c, (float)u);
        u = (double)(float)u;
        for (int k = 0; k < 3; k++) {
            x[k] = slow_bezier(c.control, order_of(&c), 0, u + (k - 1) * h);
            y[k] = slow_bezier(c.control, order_of(&c), 1, u + (k - 1) * h);
        }
        double x1 = (x[2] - x[0]) / (2 * h), y1 = (y[2] - y[0]) / (2 * h);
        double x2 = (x[2] - 2 * x[1] + x[0]) / (h * h), y2 = (y[2] - 2 * y[1] + y[0]) / (h * h);
        double length = hypot(x1, y1), bent = (x1 * y2 - y1 * x2) / (length * length * length);
        assert_near(p.first.x, x1, 1e-2 + 1e-3 * fabs(x1));
        assert_near(p.first.y, y1, 1e-2 + 1e-3 * fabs(y1));
        if (length > 50)
            assert_near(p.curvature, bent,
                        1e-5 + 2e-3 * (fabs(bent) + hypot(x2, y2) / length / length));
    }
}

/* y = h·2t(1−t), x = 2at: at the top y″ is −h/a². */
static void curvature_of_a_parabola(void **state)
{
    (void)state;
    struct model m = {.kind = MODEL_BEZIER};
    struct curve c;
    const float a = 160, h = 240;
    model_add(&m, 0, (struct vector3){100, 100, 0});
    model_add(&m, 1, (struct vector3){100 + a, 100 + h, 0});
    model_add(&m, 2, (struct vector3){100 + 2 * a, 100, 0});
    assert_null(curve_of(&m, &c));
    struct curve_place p = curve_at(&c, 0.5f);
    assert_near(p.at.y, 100 + h / 2, 1e-3);
    assert_near(p.curvature, -h / (a * a), 1e-7);
    assert_near(p.first.y, 0, 1e-3);
}

static void length_and_nearest_are_those_of_many_samples(void **state)
{
    (void)state;
    enum { STEPS = 4000 };
    struct model m;
    struct curve c;
    for (int i = 0; i < 60; i++) {
        make(&m, &c, (enum model_kind)(i % MODEL_KINDS), i % 3 == 0);
        struct vector3 place = random_place(), before = curve_at(&c, c.knot[0]).at;
        double length = 0, least = 1e9, longest = 0;
        float distance;
        for (int k = 0; k <= STEPS; k++) {
            struct vector3 p = curve_at(&c, curve_t(&c, (float)k / STEPS)).at;
            length += hypot((double)p.x - before.x, (double)p.y - before.y);
            longest = fmax(longest, hypot((double)p.x - before.x, (double)p.y - before.y));
            least = fmin(least, hypot((double)p.x - place.x, (double)p.y - place.y));
            before = p;
        }
        assert_near(curve_length(&c), length, 0.02 * length + 1);
        float part = curve_nearest(&c, place, &distance);
        struct vector3 at = curve_at(&c, curve_t(&c, part)).at;
        assert_near(distance, hypot((double)at.x - place.x, (double)at.y - place.y), 0.05);
        assert_true(part >= 0 && part <= 1);
        assert_true(distance < least + 12 + longest); /* it may be in the next valley but one */
    }
}

/* The marked point is dragged along: from near the curve the place found is there. */
static void places_on_the_curve_are_found(void **state)
{
    (void)state;
    struct model m;
    struct curve c;
    for (int i = 0; i < MODELS; i++) {
        make(&m, &c, (enum model_kind)(i % MODEL_KINDS), i % 3 == 0);
        struct vector3 p = curve_at(&c, curve_t(&c, random_in(0, 1))).at;
        float distance;
        curve_nearest(&c, p, &distance);
        assert_true(distance < 13); /* half of what a stylus reaches */
    }
}

/* ---- smooth joints ------------------------------------------------------------------------------- */

static double cross(struct vector3 a, struct vector3 b)
{
    return (double)a.x * b.y - (double)a.y * b.x;
}

static void joints_stay_smooth_over_random_drags(void **state)
{
    (void)state;
    struct model m;
    struct curve c;
    int seen[JOINTS] = {0};
    for (int i = 0; i < 100; i++) {
        random_model(&m, MODEL_PIECES, i % 2, 0);
        for (int step = 0; step < 60; step++) {
            random_operation(&m);
            assert_null(curve_of(&m, &c));
            for (int k = 0; k < curve_joints(&c); k++) {
                const struct model_point *p = &m.point[(k + 1) % m.count];
                struct join j = curve_join(&c, k);
                double a = vector3_length(p->in), b = vector3_length(p->out);
                double rounding = 3e-4 * 3; /* of places up to 1000, times the degree */
                seen[p->joint]++;
                assert_true(farthest(j.p[0], j.q[0]) < 1e-3);
                if (p->joint == JOINT_C1)
                    assert_true(farthest(j.p[1], j.q[1]) < rounding * 2);
                if (p->joint == JOINT_G1 && a > 0 && b > 0) {
                    assert_true(fabs(cross(p->in, p->out)) <= 1e-6 * a * b);
                    assert_true(vector3_dot(p->in, p->out) < 0);
                }
            }
        }
    }
    for (int k = 0; k < JOINTS; k++)
        assert_true(seen[k] > 1000);
}

/* The other handle of a G1 joint keeps its length; of a corner, its place. */
static void the_other_handle_follows(void **state)
{
    (void)state;
    struct model m;
    for (int i = 0; i < MODELS; i++) {
        random_model(&m, MODEL_PIECES, true, 30);
        int k = (int)random_below((uint32_t)m.count);
        bool out = random_below(2);
        struct model_point before = m.point[k];
        assert_true(model_move_handle(&m, k, out, random_place()));
        struct vector3 was = out ? before.in : before.out,
                       is = out ? m.point[k].in : m.point[k].out;
        if (before.joint == JOINT_CORNER)
            assert_memory_equal(&was, &is, sizeof was);
        if (before.joint == JOINT_G1)
            assert_near(vector3_length(is), vector3_length(was), 1e-3);
    }
}

/* ---- hulls --------------------------------------------------------------------------------------- */

static double left_of(struct point2 a, struct point2 b, double x, double y)
{
    return ((double)b.x - a.x) * (y - a.y) - ((double)b.y - a.y) * (x - a.x);
}

static void hulls_are_convex_and_contain_points_and_curve(void **state)
{
    (void)state;
    struct model m;
    struct curve c;
    for (int i = 0; i < MODELS; i++) {
        struct point2 hull[BEZIER_POINTS_MOST];
        make(&m, &c, (enum model_kind)(i % MODEL_KINDS), i % 3 == 0);
        int piece = (int)random_below((uint32_t)c.pieces), corners;
        const struct vector3 *p = curve_piece(&c, piece);
        corners = convex_hull(p, c.order, hull);
        assert_true(corners >= 1 && corners <= c.order);
        for (int k = 0; k < corners && corners > 2; k++) {
            struct point2 a = hull[k], b = hull[(k + 1) % corners], d = hull[(k + 2) % corners];
            double size = hypot((double)b.x - a.x, (double)b.y - a.y);
            assert_true(left_of(a, b, d.x, d.y) > 0);
            for (int n = 0; n < c.order; n++)
                assert_true(left_of(a, b, p[n].x, p[n].y) >= -1e-2 * size);
            for (int n = 0; n <= 20; n++) {
                double x = slow_bezier(p, order_of(&c), 0, n / 20.0);
                double y = slow_bezier(p, order_of(&c), 1, n / 20.0);
                assert_true(left_of(a, b, x, y) >= -1e-2 * size);
            }
        }
    }
}

static void hulls_of_few_places(void **state)
{
    (void)state;
    struct point2 hull[8];
    struct vector3 same[4] = {{5, 5, 0}, {5, 5, 0}, {5, 5, 0}, {5, 5, 0}};
    struct vector3 row[4] = {{1, 1, 0}, {4, 4, 0}, {2, 2, 0}, {3, 3, 0}};
    struct vector3 square[5] = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {2, 2, 0}, {0, 2, 0}};
    assert_int_equal(convex_hull(same, 0, hull), 0);
    assert_int_equal(convex_hull(same, 4, hull), 1);
    assert_int_equal(convex_hull(row, 4, hull), 2);
    assert_int_equal(convex_hull(square, 5, hull), 4);
}

/* ---- undo ---------------------------------------------------------------------------------------- */

static void undo_and_redo_walk_over_the_same_models(void **state)
{
    (void)state;
    enum { STATES = 400 };
    static struct model was[STATES];
    static struct history h;
    struct model m = {.kind = MODEL_PIECES};
    int at = 0, last = 0, first = 0;
    was[0] = m;
    for (int i = 0; i < 3000 && last < STATES - 1; i++) {
        uint32_t what = random_below(5);
        if (what < 2) {
            history_keep(&h, &m);
            model_add(&m, 0, random_place());
            random_operation(&m);
            was[last = ++at] = m;
            first = at - first > HISTORY_MOST ? at - HISTORY_MOST : first;
        } else if (what < 4) {
            assert_int_equal(history_undo(&h, &m), at > first);
            at -= at > first;
        } else {
            assert_int_equal(history_redo(&h, &m), at < last);
            at += at < last;
        }
        assert_memory_equal(&m, &was[at], sizeof m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bezier_curves_and_pieces_are_de_casteljaus),
        cmocka_unit_test(b_splines_are_weighted_means),
        cmocka_unit_test(natural_and_periodic_splines),
        cmocka_unit_test(points_that_coincide_have_no_spline_by_distance),
        cmocka_unit_test(derivatives_are_those_of_differences),
        cmocka_unit_test(curvature_of_a_parabola),
        cmocka_unit_test(length_and_nearest_are_those_of_many_samples),
        cmocka_unit_test(places_on_the_curve_are_found),
        cmocka_unit_test(joints_stay_smooth_over_random_drags),
        cmocka_unit_test(the_other_handle_follows),
        cmocka_unit_test(hulls_are_convex_and_contain_points_and_curve),
        cmocka_unit_test(hulls_of_few_places),
        cmocka_unit_test(undo_and_redo_walk_over_the_same_models),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
