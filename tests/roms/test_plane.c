/* Transformations of the plane and the viewing pipeline (roms/geometry, roms/clip) against their
 * definitions in double precision and examples worked by hand. The sources are compiled for this
 * machine. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h>

#include "roms/clip/liang_barsky.c"
#include "roms/clip/pipeline2.c"
#include "roms/clip/sutherland_hodgman.c"
#include "roms/clip/window_viewport.c"
#include "roms/geometry/matrix3.c"
#include "roms/geometry/scalar.c"
#include "roms/geometry/transform2.c"

static const double EXACT_PI = 3.14159265358979323846;
static uint32_t random_state = 1;

/* Anywhere within ±limit. */
static float random_float(float limit)
{
    random_state = random_state * 1664525u + 1013904223u;
    return ((float)(random_state >> 8) / (float)(1u << 23) - 1) * limit;
}

static struct point2 random_point(void)
{
    return (struct point2){random_float(10), random_float(10)};
}

static void assert_near(struct point2 p, double x, double y, double slack)
{
    assert_true(fabs(p.x - x) <= slack && fabs(p.y - y) <= slack);
}

/* The matrix takes the corners to these, to four decimals. */
static void assert_takes(struct matrix3 m, const struct point2 *from, const struct point2 *to,
                         int count)
{
    for (int i = 0; i < count; i++)
        assert_near(matrix3_apply(&m, from[i]), to[i].x, to[i].y, 5e-5);
}

static void assert_same(const struct matrix3 *a, const struct matrix3 *b, double slack)
{
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            assert_true(fabs((double)a->at[i][k] - (double)b->at[i][k]) <= slack);
}

/* ---- worked by hand -------------------------------------------------------------------------- */

static const struct point2 square[] = {{0, 0}, {2, 0}, {0, 2}, {2, 2}};

static void squares_of_the_course(void **state)
{
    (void)state;
    assert_takes(transform2_translate(2, 3), square,
                 (const struct point2[]){{2, 3}, {4, 3}, {2, 5}, {4, 5}}, 4);
    assert_takes(transform2_scale(2, 3), square,
                 (const struct point2[]){{0, 0}, {4, 0}, {0, 6}, {4, 6}}, 4);
    assert_takes(transform2_scale(0.5f, 0.5f), square,
                 (const struct point2[]){{0, 0}, {1, 0}, {0, 1}, {1, 1}}, 4);
    assert_takes(transform2_shear_x(2, 0), square,
                 (const struct point2[]){{0, 0}, {2, 0}, {4, 2}, {6, 2}}, 4);
}

static void triangles_of_the_course(void **state)
{
    (void)state;
    const struct point2 t[] = {{0, 0}, {1, 0}, {1, 1}};
    assert_takes(transform2_rotate(90), t, (const struct point2[]){{0, 0}, {0, 1}, {-1, 1}}, 3);
    assert_takes(transform2_rotate(-90), t, (const struct point2[]){{0, 0}, {0, -1}, {1, -1}}, 3);
    const struct point2 r[] = {{2, 2}, {4, 2}, {3, 4}};
    assert_takes(transform2_reflect(MIRROR_X_AXIS), r,
                 (const struct point2[]){{2, -2}, {4, -2}, {3, -4}}, 3);
    const struct point2 s[] = {{7, 15}, {5, 8}, {10, 10}};
    struct matrix3 turn = transform2_rotate(-45), grow = transform2_scale(2, 3);
    assert_takes(transform2_then(&turn, &grow), s,
                 (const struct point2[]){{31.1127f, 16.9706f}, {18.3848f, 6.3640f}, {28.2843f, 0}},
                 3);
}

static void mirrors_of_the_course(void **state)
{
    (void)state;
    struct matrix3 x = transform2_reflect(MIRROR_X_AXIS), turn = transform2_rotate(90);
    struct matrix3 both = transform2_then(&x, &turn), diagonal = transform2_reflect(MIRROR_Y_IS_X);
    assert_same(&both, &diagonal, 0);
    struct matrix3 line = transform2_reflect_line(1, 0);
    assert_same(&line, &diagonal, 0);
    line = transform2_reflect_line(0, 4);
    struct matrix3 level = transform2_reflect_y_is(4);
    assert_same(&line, &level, 0);
    line = transform2_reflect_line(-1, 0);
    diagonal = transform2_reflect(MIRROR_Y_IS_MINUS_X);
    assert_same(&line, &diagonal, 0);
}

static void viewport_of_the_course(void **state)
{
    (void)state;
    struct matrix3 m;
    const struct clip_window w = {20, 40, 80, 80}, v = {30, 40, 60, 60};
    assert_true(window_to_viewport(&w, &v, &m));
    const struct point2 from[] = {{30, 80}, {80, 80}, {20, 40}};
    assert_takes(m, from, (const struct point2[]){{35, 60}, {60, 60}, {30, 40}}, 3);
}

/* ---- rotations ------------------------------------------------------------------------------- */

static void quarters_are_exact(void **state)
{
    (void)state;
    static const float cosines[] = {1, 0, -1, 0};
    for (int k = -400; k <= 400; k++) {
        struct sine_cosine d = scalar_sine_cosine(90.0f * (float)k);
        assert_true(d.cosine == cosines[k & 3] && d.sine == cosines[(k + 3) & 3]);
        assert_false(signbit(d.cosine) && d.cosine == 0);
        assert_false(signbit(d.sine) && d.sine == 0);
    }
}

static void directions_are_those_of_double_precision(void **state)
{
    (void)state;
    for (int i = 0; i < 100000; i++) {
        float degrees = random_float(i % 2 ? 360 : 100000);
        double angle = fmod(degrees, 360) * EXACT_PI / 180;
        struct sine_cosine d = scalar_sine_cosine(degrees);
        assert_near((struct point2){d.cosine, d.sine}, cos(angle), sin(angle), 1.5e-7);
    }
}

static double apart(struct point2 a, struct point2 b)
{
    return hypot((double)a.x - b.x, (double)a.y - b.y);
}

static void rotations_keep_lengths_and_the_pivot(void **state)
{
    (void)state;
    for (int i = 0; i < 100000; i++) {
        struct point2 a = random_point(), b = random_point(), pivot = random_point();
        float degrees = random_float(720);
        struct matrix3 m = transform2_rotate_about(degrees, pivot);
        struct point2 a2 = matrix3_apply(&m, a), b2 = matrix3_apply(&m, b);
        assert_true(fabs(apart(a, b) - apart(a2, b2)) < 1e-5);
        assert_near(matrix3_apply(&m, pivot), pivot.x, pivot.y, 1e-5);
        double t = degrees * EXACT_PI / 180, x = (double)a.x - pivot.x, y = (double)a.y - pivot.y;
        assert_near(a2, pivot.x + x * cos(t) - y * sin(t), pivot.y + x * sin(t) + y * cos(t), 1e-5);
    }
}

/* In three steps or at once. */
static void about_a_point_is_three_steps(void **state)
{
    (void)state;
    for (int i = 0; i < 20000; i++) {
        struct point2 p = random_point();
        struct matrix3 to = transform2_translate(-p.x, -p.y), back = transform2_translate(p.x, p.y);
        float degrees = random_float(360), sx = random_float(3), sy = random_float(3);
        struct matrix3 turn = transform2_rotate(degrees), grow = transform2_scale(sx, sy);
        struct matrix3 steps = transform2_then(&to, &turn);
        steps = transform2_then(&steps, &back);
        struct matrix3 once = transform2_rotate_about(degrees, p);
        assert_same(&steps, &once, 5e-6);
        steps = transform2_then(&to, &grow);
        steps = transform2_then(&steps, &back);
        once = transform2_scale_about(sx, sy, p);
        assert_same(&steps, &once, 1e-5);
    }
}

/* ---- mirrors, shears, inverses --------------------------------------------------------------- */

/* The closed form, and the mirror image by its definition: the middle lies on the line, and what
 * joins the two is square to it. */
static void mirror_images_are_opposite(void **state)
{
    (void)state;
    for (int i = 0; i < 100000; i++) {
        float m = i % 3 ? random_float(3) : random_float(1000), c = random_float(10);
        struct point2 p = random_point();
        struct matrix3 mirror = transform2_reflect_line(m, c);
        double w = 1 + (double)m * m;
        double closed[2][3] = {{(1 - (double)m * m) / w, 2 * (double)m / w, -2 * (double)m * c / w},
                               {2 * (double)m / w, ((double)m * m - 1) / w, 2 * (double)c / w}};
        for (int r = 0; r < 2; r++)
            for (int k = 0; k < 3; k++)
                assert_true(fabs(mirror.at[r][k] - closed[r][k]) <= 4e-6);
        struct point2 q = matrix3_apply(&mirror, p);
        double length = sqrt(w), x = ((double)p.x + q.x) / 2, y = ((double)p.y + q.y) / 2;
        assert_true(fabs(m * x - y + c) / length < 1e-5);
        assert_true(fabs((q.x - (double)p.x) + m * (q.y - (double)p.y)) / length < 1e-5);
    }
    struct matrix3 steep = transform2_reflect_line(1e30f, 5);
    assert_near(matrix3_apply(&steep, (struct point2){3, 4}), -3, 4, 1e-6);
    struct matrix3 upright = transform2_reflect_x_is(2);
    assert_near(matrix3_apply(&upright, (struct point2){5, 7}), -1, 7, 0);
}

static void shears_leave_their_line(void **state)
{
    (void)state;
    for (int i = 0; i < 20000; i++) {
        float k = random_float(4), at = random_float(10);
        struct point2 p = random_point();
        struct matrix3 x = transform2_shear_x(k, at), y = transform2_shear_y(k, at);
        assert_near(matrix3_apply(&x, p), p.x + (double)k * ((double)p.y - at), p.y, 2e-5);
        assert_near(matrix3_apply(&y, p), p.x, p.y + (double)k * ((double)p.x - at), 2e-5);
    }
}

static struct matrix3 any_transformation(int kind)
{
    switch (kind % 6) {
    case 0:
        return transform2_translate(random_float(5), random_float(5));
    case 1:
        return transform2_rotate_about(random_float(360), random_point());
    case 2:
        return transform2_scale_about(0.5f + fabsf(random_float(2)), -0.5f - fabsf(random_float(2)),
                                      random_point());
    case 3:
        return transform2_reflect_line(random_float(3), random_float(5));
    case 4:
        return transform2_shear_x(random_float(1), random_float(5));
    default:
        return transform2_reflect((enum mirror2)(kind / 6 % 5));
    }
}

/* Composition is one after the other; the inverse undoes both. */
static void compositions_come_apart(void **state)
{
    (void)state;
    for (int i = 0; i < 60000; i++) {
        struct matrix3 a = any_transformation(i), b = any_transformation(i / 6);
        struct matrix3 both = transform2_then(&a, &b), back;
        struct point2 p = random_point();
        struct point2 q = matrix3_apply(&a, p);
        q = matrix3_apply(&b, q);
        assert_near(matrix3_apply(&both, p), q.x, q.y, 1e-4);
        assert_true(matrix3_inverse(&both, &back));
        assert_near(matrix3_apply(&back, q), p.x, p.y, 5e-4);
    }
    struct matrix3 flat = transform2_scale(0, 1), none;
    assert_false(matrix3_inverse(&flat, &none));
}

/* ---- viewing --------------------------------------------------------------------------------- */

static void windows_zoom_and_pan(void **state)
{
    (void)state;
    const struct clip_window w = {10, 20, 30, 60};
    struct clip_window z = window_zoom(&w, 2), p = window_pan(&w, 5, -1);
    assert_true(z.x_min == 15 && z.x_max == 25 && z.y_min == 30 && z.y_max == 50);
    assert_true(p.x_min == 15 && p.x_max == 35 && p.y_min == 19 && p.y_max == 59);
}

static void empty_windows_are_refused(void **state)
{
    (void)state;
    struct matrix3 m;
    const struct clip_window good = {0, 0, 1, 1};
    const struct clip_window bad[] = {{0, 0, 0, 1}, {0, 0, 1, 0}, {1, 0, 0, 1}, {0, 1, 1, 0}};
    for (int i = 0; i < 4; i++)
        assert_false(window_to_viewport(&bad[i], &good, &m));
    assert_false(view_frame((struct point2){1, 2}, (struct point2){0, 0}, &m));
}

/* Coordinates in the frame are the shares of its axes, whose y points up. */
static void frames_measure_along_their_axes(void **state)
{
    (void)state;
    for (int i = 0; i < 50000; i++) {
        struct point2 o = random_point(), up = random_point(), p = random_point();
        double length = hypot(up.x, up.y), ux = up.x / length, uy = up.y / length;
        struct matrix3 m;
        assert_true(view_frame(o, up, &m));
        double x = (double)p.x - o.x, y = (double)p.y - o.y;
        assert_near(matrix3_apply(&m, p), x * uy - y * ux, x * ux + y * uy, 1e-5);
    }
}

static struct view2 random_view(void)
{
    struct view2 v = {
        random_point(), random_point(), {-9, -7, 9, 7}, {0.1f, 0.2f, 0.9f, 1}, {0, 480, 640, 0}};
    v.window.x_min += random_float(5);
    v.window.y_max += random_float(5);
    return v;
}

/* Stage after stage in double precision. */
static void pipelines_are_their_stages(void **state)
{
    (void)state;
    int seen = 0;
    for (int i = 0; i < 50000; i++) {
        struct view2 v = random_view();
        struct pipeline2 p;
        struct matrix3 model = any_transformation(i);
        struct point2 mc = random_point(), at = mc;
        assert_true(pipeline2_begin(&p, &v));
        pipeline2_model(&p, &model);
        double l = hypot(v.up.x, v.up.y), ux = v.up.x / l, uy = v.up.y / l;
        struct point2 wc = matrix3_apply(&model, mc);
        double x = (double)wc.x - v.origin.x, y = (double)wc.y - v.origin.y;
        double vx = x * uy - y * ux, vy = x * ux + y * uy;
        double nx = 0.1 + 0.8 * (vx - v.window.x_min) / ((double)v.window.x_max - v.window.x_min);
        double ny = 0.2 + 0.8 * (vy - v.window.y_min) / ((double)v.window.y_max - v.window.y_min);
        bool in = nx > 0.1 && nx < 0.9 && ny > 0.2 && ny < 1;
        assert_near(matrix3_apply(&p.whole, mc), 640 * nx, 480 - 480 * ny, 5e-3);
        if (fmin(fmin(fabs(nx - 0.1), fabs(nx - 0.9)), fmin(fabs(ny - 0.2), fabs(ny - 1))) < 1e-5)
            continue;
        assert_int_equal(pipeline2_point(&p, &at), in);
        if (in)
            assert_near(at, 640 * nx, 480 - 480 * ny, 5e-3);
        seen += in;
    }
    assert_true(seen > 5000);
}

/* Lines and polygons leave the pipeline within the viewport on the device. */
static void pipelines_clip(void **state)
{
    (void)state;
    static struct sutherland_hodgman work;
    for (int i = 0; i < 20000; i++) {
        struct view2 v = random_view();
        struct pipeline2 p;
        assert_true(pipeline2_begin(&p, &v));
        struct point2 c[] = {random_point(), random_point(), random_point()};
        int count = pipeline2_polygon(&p, c, 3, &work);
        for (int k = 0; k < count; k++)
            assert_true(work.corner[k].x > 63.99f && work.corner[k].x < 576.01f &&
                        work.corner[k].y > -0.01f && work.corner[k].y < 384.01f);
        if (pipeline2_line(&p, &c[0], &c[1]))
            assert_true(c[0].x > 63.99f && c[1].x < 576.01f && c[0].y > -0.01f && c[1].y < 384.01f);
    }
    struct view2 flat = random_view();
    struct pipeline2 p;
    flat.up = (struct point2){0, 0};
    assert_false(pipeline2_begin(&p, &flat));
    struct point2 many[CLIP_POLYGON_MOST + 1] = {{0, 0}};
    flat.up.y = 1;
    assert_true(pipeline2_begin(&p, &flat));
    assert_int_equal(pipeline2_polygon(&p, many, CLIP_POLYGON_MOST + 1, &work), 0);
}

struct seen {
    struct point2 from, to;
    int count;
};

static void see(void *ctx, struct point2 a, struct point2 b)
{
    struct seen *s = ctx;
    s->from = a;
    s->to = b;
    s->count++;
}

static void polylines_are_their_lines(void **state)
{
    (void)state;
    int lines = 0;
    for (int i = 0; i < 20000; i++) {
        struct view2 v = random_view();
        struct pipeline2 p;
        assert_true(pipeline2_begin(&p, &v));
        struct point2 c[] = {random_point(), random_point()};
        struct seen seen = {.count = 0};
        pipeline2_polyline(&p, c, 2, see, &seen);
        bool left = pipeline2_line(&p, &c[0], &c[1]);
        assert_int_equal(seen.count, left);
        if (left) {
            assert_near(seen.from, c[0].x, c[0].y, 0);
            assert_near(seen.to, c[1].x, c[1].y, 0);
        }
        lines += left;
    }
    assert_true(lines > 2000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(squares_of_the_course),
        cmocka_unit_test(triangles_of_the_course),
        cmocka_unit_test(mirrors_of_the_course),
        cmocka_unit_test(viewport_of_the_course),
        cmocka_unit_test(quarters_are_exact),
        cmocka_unit_test(directions_are_those_of_double_precision),
        cmocka_unit_test(rotations_keep_lengths_and_the_pivot),
        cmocka_unit_test(about_a_point_is_three_steps),
        cmocka_unit_test(mirror_images_are_opposite),
        cmocka_unit_test(shears_leave_their_line),
        cmocka_unit_test(compositions_come_apart),
        cmocka_unit_test(windows_zoom_and_pan),
        cmocka_unit_test(empty_windows_are_refused),
        cmocka_unit_test(frames_measure_along_their_axes),
        cmocka_unit_test(pipelines_are_their_stages),
        cmocka_unit_test(pipelines_clip),
        cmocka_unit_test(polylines_are_their_lines),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
