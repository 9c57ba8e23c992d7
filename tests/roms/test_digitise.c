/* What roms/digitise computes of points: scatter against the definition, thinning against brute force,
 * measures against closed forms. */
#include <math.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "roms/digitise/drawing.c"
#include "roms/digitise/rest.c"
#include "roms/digitise/thin.c"

#include "tests/roms/curves_support.h"
#include "tests/roms/digitise_support.h"

/* ---- scatter ------------------------------------------------------------------------------------- */

static void scatter_is_that_of_the_definition(void **state)
{
    (void)state;
    for (int i = 0; i < 200; i++) {
        struct rest r;
        double value[400][3], mean[3] = {0};
        int count = 2 + (int)random_below(398);
        rest_begin(&r);
        for (int k = 0; k < count; k++) {
            float place[3];
            for (int axis = 0; axis < 3; axis++) {
                place[axis] = (float)floor(1500 + 2 * normal());
                value[k][axis] = (double)place[axis];
                mean[axis] += value[k][axis] / count;
            }
            rest_take(&r, place, 40);
        }
        assert_int_equal(r.count, count);
        for (int axis = 0; axis < 3; axis++) {
            double sum = 0;
            for (int k = 0; k < count; k++)
                sum += (value[k][axis] - mean[axis]) * (value[k][axis] - mean[axis]);
            assert_near(r.mean[axis], mean[axis], 5e-3);
            assert_near(rest_deviation(&r, axis), sqrt(sum / (count - 1)), 1e-2);
        }
    }
}

static void a_move_begins_anew_and_long_rests_forget(void **state)
{
    (void)state;
    struct rest r;
    float place[3] = {100, 100, 0}, far[3] = {100, 109, 0};
    rest_begin(&r);
    assert_true(rest_deviation(&r, 0) == 0);
    for (int i = 0; i < 50; i++)
        rest_take(&r, place, 8);
    rest_take(&r, far, 8);
    assert_int_equal(r.count, 1);
    assert_true(r.mean[1] == 109);
    rest_begin(&r);
    for (int i = 0; i < 40000; i++) {
        place[0] = 100 + (float)normal();
        rest_take(&r, place, 50);
    }
    assert_int_equal(r.count, REST_MOST);
    assert_near(rest_deviation(&r, 0), 1, 0.1);
    assert_near(r.mean[0], 100, 0.2);
}

/* ---- thinning ------------------------------------------------------------------------------------ */

static double to_segment(const struct drawing_point *a, const struct drawing_point *b,
                         const struct drawing_point *p)
{
    double dx = (double)b->x - a->x, dy = (double)b->y - a->y;
    double px = (double)p->x - a->x, py = (double)p->y - a->y, l = dx * dx + dy * dy;
    double t = l > 0 ? fmin(fmax((px * dx + py * dy) / l, 0), 1) : 0;
    return hypot(px - t * dx, py - t * dy);
}

enum { MANY = 600 };

/* Straight, round and noisy parts; some places twice. */
static int random_line(struct drawing_point *p, bool gaps)
{
    int count = 1 + (int)random_below(MANY - 1);
    double x = 100, y = 100, angle = 0, bend = 0;
    for (int i = 0; i < count; i++) {
        if (random_below(40) == 0)
            bend = (double)random_in(-0.3f, 0.3f);
        angle += bend;
        double step = random_below(20) == 0 ? 0 : 1;
        x += step * cos(angle);
        y += step * sin(angle);
        p[i] = (struct drawing_point){.x = (float)(x + 0.1 * normal()),
                                      .y = (float)(y + 0.1 * normal()),
                                      .gap = gaps && i > 0 && random_below(50) == 0};
    }
    return count;
}

static void what_is_left_out_lies_within_the_tolerance(void **state)
{
    (void)state;
    for (int i = 0; i < 400; i++) {
        static struct drawing_point p[MANY];
        bool keep[MANY];
        int count = random_line(p, i % 2), kept = 0, from = 0;
        float tolerance = i % 5 == 0 ? 0 : random_in(0.05f, 3);
        int told = thin_points(p, count, tolerance, keep);
        assert_true(keep[0] && keep[count - 1]);
        for (int k = 0; k < count; k++) {
            kept += keep[k];
            if (p[k].gap)
                assert_true(keep[k] && keep[k - 1]);
            if (!keep[k] || k == 0)
                continue;
            for (int n = from + 1; n < k; n++)
                assert_true(to_segment(&p[from], &p[k], &p[n]) <= (double)tolerance + 1e-4);
            from = k;
        }
        assert_int_equal(kept, told);
    }
}

static void straight_lines_keep_two_points_and_corners_stay(void **state)
{
    (void)state;
    struct drawing_point p[101] = {{0}};
    bool keep[101];
    for (int i = 0; i <= 100; i++) {
        p[i].x = (float)(i < 50 ? i : 50);
        p[i].y = (float)(i < 50 ? 0 : i - 50);
    }
    assert_int_equal(thin_points(p, 51, 0.1f, keep), 2);
    assert_int_equal(thin_points(p, 101, 0.1f, keep), 3);
    assert_true(keep[50]);
    assert_int_equal(thin_points(p, 1, 0.1f, keep), 1);
    assert_int_equal(thin_points(p, 0, 0.1f, keep), 0);
}

/* A comb takes the most ranges that wait. */
static void the_longest_zigzag_is_thinned(void **state)
{
    (void)state;
    static struct drawing_point p[DRAWING_POINTS_MOST];
    static bool keep[DRAWING_POINTS_MOST];
    for (int shape = 0; shape < 3; shape++) {
        for (int i = 0; i < DRAWING_POINTS_MOST; i++) {
            p[i].x = (float)i;
            p[i].y = shape == 0   ? (float)(i % 2 * 50)
                     : shape == 1 ? (float)(i % 2) * (float)i / 4
                                  : (float)(i * (i & -i) % 977);
        }
        assert_in_range(thin_points(p, DRAWING_POINTS_MOST, 0.01f, keep), 3900,
                        DRAWING_POINTS_MOST);
    }
}

/* ---- measures ------------------------------------------------------------------------------------ */

static struct drawing drawing;

static void add_at(double x, double y, double z, bool start)
{
    struct drawing_point p = {.x = (float)x, .y = (float)y, .z = (float)z, .start = start};
    assert_true(drawing_add(&drawing, &p));
}

/* Polygon and ellipse: chords of known length, area n/2 · ab · sin(2π/n). */
static void measures_of_figures_with_formulas(void **state)
{
    (void)state;
    for (int n = 3; n < 400; n += 13) {
        double a = 80, b = 35, length = 0;
        drawing.count = 0;
        add_at(7, 7, 0, true); /* another line before it */
        for (int i = 0; i < n; i++) {
            double t = 2 * TEST_PI * i / n, u = 2 * TEST_PI * (i + 1) / n;
            add_at(100 + a * cos(t), 60 + b * sin(t), 3.0 * i, i == 0);
            length += hypot(a * (cos(u) - cos(t)), b * (sin(u) - sin(t)));
        }
        struct drawing_line line = drawing_last_line(&drawing);
        assert_int_equal(line.count, n);
        struct drawing_measure m = drawing_measure(&drawing, &line);
        assert_near(m.area, n / 2.0 * a * b * sin(2 * TEST_PI / n), 0.05);
        assert_near(m.perimeter, length, 0.01);
        assert_near(m.length,
                    length - hypot(a * (1 - cos(2 * TEST_PI / n)), b * sin(2 * TEST_PI / n)), 0.01);
        assert_true(drawing_close(&drawing));
        line = drawing_last_line(&drawing);
        m = drawing_measure(&drawing, &line);
        assert_near(m.length, length, 0.01);
        assert_true(m.space > m.length);
    }
}

static void heights_lengthen_a_stair(void **state)
{
    (void)state;
    drawing.count = 0;
    for (int i = 0; i < 5; i++)
        add_at(3 * i, 0, 4 * i, i == 0);
    struct drawing_line line = drawing_last_line(&drawing);
    struct drawing_measure m = drawing_measure(&drawing, &line);
    assert_near(m.length, 12, 1e-5);
    assert_near(m.space, 20, 1e-5);
    assert_near(m.area, 0, 1e-5);
}

static void gaps_are_not_in_the_length(void **state)
{
    (void)state;
    drawing.count = 0;
    for (int i = 0; i < 6; i++)
        add_at(10 * i, 0, 0, i == 0);
    drawing.point[3].gap = true;
    struct drawing_line line = drawing_last_line(&drawing);
    struct drawing_measure m = drawing_measure(&drawing, &line);
    assert_int_equal(m.gaps, 1);
    assert_near(m.length, 40, 1e-5);
    assert_near(m.bridged, 10, 1e-5);
}

static void lines_are_those_between_starts(void **state)
{
    (void)state;
    for (int i = 0; i < 300; i++) {
        int lines = 0, points = 0, first[64] = {0};
        drawing.count = 0;
        for (int k = 0; k < 60; k++) {
            bool start = random_below(4) == 0;
            if (start || k == 0)
                first[lines++] = k;
            add_at(k, 0, 0, start);
        }
        struct drawing_line line = {0};
        for (int k = 0; drawing_next_line(&drawing, &line); k++) {
            assert_int_equal(line.first, first[k]);
            points += line.count;
            lines--;
        }
        assert_int_equal(lines, 0);
        assert_int_equal(points, 60);
        int last = drawing_last_line(&drawing).first;
        assert_true(drawing_delete_line(&drawing));
        assert_int_equal(drawing.count, last);
    }
    drawing.count = 0;
    assert_false(drawing_delete_point(&drawing));
    assert_false(drawing_delete_line(&drawing));
    assert_false(drawing_close(&drawing));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scatter_is_that_of_the_definition),
        cmocka_unit_test(a_move_begins_anew_and_long_rests_forget),
        cmocka_unit_test(what_is_left_out_lies_within_the_tolerance),
        cmocka_unit_test(straight_lines_keep_two_points_and_corners_stay),
        cmocka_unit_test(the_longest_zigzag_is_thinned),
        cmocka_unit_test(measures_of_figures_with_formulas),
        cmocka_unit_test(heights_lengthen_a_stair),
        cmocka_unit_test(gaps_are_not_in_the_length),
        cmocka_unit_test(lines_are_those_between_starts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
