/* Circles and ellipses (roms/raster/circle*, ellipse_midpoint): against the nearest pixel found by
 * trying all, and against tables worked by hand. The sources are compiled for this
 * machine. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "roms/raster/circle_midpoint.c"
#define draw draw_side
#include "roms/raster/circle_midpoint_side.c"
#undef draw
#define draw draw_ellipse
#include "roms/raster/ellipse_midpoint.c"
#undef draw
#include "roms/raster/fill.c"

enum { SIDE = 256, MIDDLE = 128 };

__extension__ typedef __int128 wide;

static uint32_t seed = 20261126;

static int random_within(int low, int high)
{
    seed = seed * 1664525u + 1013904223u;
    return low + (int)((uint64_t)seed * (uint64_t)(high - low + 1) >> 32);
}

/* ---- tables worked by hand ------------------------------------------------------------------- */

static void assert_circle(int r, const int (*want)[3], int rows)
{
    struct circle_midpoint c;
    struct circle_midpoint_side s;
    circle_midpoint_begin(&c, r);
    circle_midpoint_side_begin(&s, r);
    assert_true(circle_midpoint_next(&c) && circle_midpoint_side_next(&s));
    assert_true(c.x == 0 && c.y == r && s.x == r && s.y == 0);
    for (int k = 0; k < rows; k++) {
        assert_int_equal(c.p, want[k][0]);
        assert_int_equal(s.p, want[k][0]);
        assert_true(circle_midpoint_next(&c) && circle_midpoint_side_next(&s));
        assert_int_equal(c.k, k + 1);
        assert_int_equal(c.x, want[k][1]);
        assert_int_equal(c.y, want[k][2]);
        assert_int_equal(s.y, want[k][1]);
        assert_int_equal(s.x, want[k][2]);
    }
    assert_false(circle_midpoint_next(&c) || circle_midpoint_side_next(&s));
}

static void the_circle_examples(void **state)
{
    (void)state;
    static const int r8[][3] = {{-7, 1, 8}, {-4, 2, 8}, {1, 3, 7},
                                {-6, 4, 7}, {3, 5, 6},  {2, 6, 5}};
    static const int r10[][3] = {{-9, 1, 10}, {-6, 2, 10}, {-1, 3, 10}, {6, 4, 9},
                                 {-3, 5, 9},  {8, 6, 8},   {5, 7, 7}};
    static const int r30[][3] = {
        {-29, 1, 30},  {-26, 2, 30}, {-21, 3, 30}, {-14, 4, 30}, {-5, 5, 30},   {6, 6, 29},
        {-39, 7, 29},  {-24, 8, 29}, {-7, 9, 29},  {12, 10, 28}, {-23, 11, 28}, {0, 12, 27},
        {-29, 13, 27}, {-2, 14, 27}, {27, 15, 26}, {6, 16, 25},  {-11, 17, 25}, {24, 18, 24},
        {13, 19, 23},  {6, 20, 22},  {3, 21, 21}};
    assert_circle(8, r8, 6);
    assert_circle(10, r10, 7);
    assert_circle(30, r30, 21);
}

static void the_ellipse_example(void **state)
{
    (void)state;
    static const int rows[][6] = {{1, -332, 1, 6, 72, 768},  {1, -224, 2, 6, 144, 768},
                                  {1, -44, 3, 6, 216, 768},  {1, 208, 4, 5, 288, 640},
                                  {1, -108, 5, 5, 360, 640}, {1, 288, 6, 4, 432, 512},
                                  {1, 244, 7, 3, 504, 384},  {2, -23, 8, 2, 576, 256},
                                  {2, 361, 8, 1, 576, 128},  {2, 297, 8, 0, 576, 0}};
    struct ellipse_midpoint e;
    ellipse_midpoint_begin(&e, 8, 6);
    assert_true(ellipse_midpoint_next(&e));
    assert_true(e.x == 0 && e.y == 6);
    for (int k = 0; k < 10; k++) {
        assert_int_equal(e.region, rows[k][0]);
        assert_int_equal(e.p, rows[k][1]);
        assert_true(ellipse_midpoint_next(&e));
        assert_int_equal(e.k, k + 1);
        assert_int_equal(e.x, rows[k][2]);
        assert_int_equal(e.y, rows[k][3]);
        assert_int_equal(e.slope_x, rows[k][4]);
        assert_int_equal(e.slope_y, rows[k][5]);
    }
    assert_false(ellipse_midpoint_next(&e));
}

/* ---- the nearest pixel ----------------------------------------------------------------------- */

/* The whole number nearest to sqrt(r² − x²), by trying all; a half does not occur. */
static int nearest_on(int r, int x)
{
    int y = 0;
    while ((2 * y + 1) * (2 * y + 1) < 4 * (r * r - x * x))
        y++;
    return y;
}

static void circles_are_nearest(void **state)
{
    (void)state;
    for (int r = 0; r <= 1000; r++) {
        struct circle_midpoint c;
        int last = -1, y = r;
        circle_midpoint_begin(&c, r);
        while (circle_midpoint_next(&c)) {
            assert_int_equal(c.x, last + 1);
            last = c.x;
            /* From the row before on: the nearest one is there or one below. */
            double true_y = sqrt((double)r * r - (double)c.x * c.x);
            assert_true(fabs(c.y - true_y) <= 0.5 || c.x == c.y + 1);
            assert_true(c.y == y || c.y == y - 1);
            y = c.y;
            if (r <= 200 && c.x <= c.y)
                assert_int_equal(c.y, nearest_on(r, c.x));
        }
        assert_true(last == y || last == y + 1);
    }
}

static void large_circles_do_not_overflow(void **state)
{
    (void)state;
    static const int radii[] = {CIRCLE_LARGEST - 1, CIRCLE_LARGEST};
    for (int i = 0; i < 2; i++) {
        struct circle_midpoint c;
        int64_t r = radii[i];
        circle_midpoint_begin(&c, radii[i]);
        while (circle_midpoint_next(&c)) {
            int64_t x = c.x + 1, y = c.y;
            /* p is the circle's equation at the middle that the next step looks at, without its
             * quarter. */
            if (c.k % 1021 == 0 || c.x >= c.y)
                assert_int_equal(c.p, x * x + y * y - y - r * r);
        }
    }
}

/* How far a pixel is from the ellipse along the axis on which that is less. */
static double off(int rx, int ry, int x, int y)
{
    double true_y = ry * sqrt(1 - (double)x * x / rx / rx);
    double true_x = rx * sqrt(1 - (double)y * y / ry / ry);
    return fmin(fabs(y - true_y), fabs(x - true_x));
}

/* Four times the ellipse's equation at a middle that is given in halves: above 0 outside. */
static wide equation(int rx, int ry, int x_halves, int y_halves)
{
    wide a = (wide)rx * rx, b = (wide)ry * ry;
    return b * x_halves * x_halves + a * y_halves * y_halves - 4 * a * b;
}

/* The step that the equation wants, straight from it. */
static void step_by_equation(int rx, int ry, int region, int *x, int *y)
{
    int stepped_x = region != 2 || equation(rx, ry, 2 * *x + 1, 2 * *y - 2) < 0;
    int stepped_y = region == 2 || (region == 1 && equation(rx, ry, 2 * *x + 2, 2 * *y - 1) >= 0);
    *x += stepped_x;
    *y -= stepped_y;
}

static void ellipses_are_near(void **state)
{
    (void)state;
    int pixels = 0, beyond_half = 0;
    for (int i = 0; i < 6000; i++) {
        bool all = i < 1600;
        int rx = all ? i % 40 : random_within(0, 400), ry = all ? i / 40 : random_within(0, 400);
        struct ellipse_midpoint e;
        int x = 0, y = ry, region = 1;
        ellipse_midpoint_begin(&e, rx, ry);
        assert_true(ellipse_midpoint_next(&e));
        for (;;) {
            assert_true(e.x == x && e.y == y);
            assert_int_equal(e.slope_x, 2LL * ry * ry * x);
            assert_int_equal(e.slope_y, 2LL * rx * rx * y);
            region = y == 0 ? 3 : region == 2 || e.slope_x >= e.slope_y ? 2 : 1;
            assert_int_equal(e.region, region);
            if (rx > 0 && ry > 0) {
                double distance = off(rx, ry, x, y);
                assert_true(distance < 1);
                pixels++;
                beyond_half += distance > 0.5 + 1e-9;
            }
            if (!ellipse_midpoint_next(&e))
                break;
            step_by_equation(rx, ry, region, &x, &y);
        }
        assert_true(x == rx && y == 0);
    }
    /* Only the last step of region 1 and what follows a sharp tip. */
    assert_true(beyond_half * 500 < pixels);
}

static void the_largest_ellipses_do_not_overflow(void **state)
{
    (void)state;
    static const int radii[][2] = {{ELLIPSE_LARGEST, ELLIPSE_LARGEST},
                                   {ELLIPSE_LARGEST, 1},
                                   {1, ELLIPSE_LARGEST},
                                   {ELLIPSE_LARGEST, 29999},
                                   {7, 29999}};
    for (int i = 0; i < 5; i++) {
        struct ellipse_midpoint e;
        ellipse_midpoint_begin(&e, radii[i][0], radii[i][1]);
        while (ellipse_midpoint_next(&e)) {
            wide four_p = e.region == 1
                              ? equation(radii[i][0], radii[i][1], 2 * e.x + 2, 2 * e.y - 1)
                              : equation(radii[i][0], radii[i][1], 2 * e.x + 1, 2 * e.y - 2);
            if (e.region < 3)
                assert_true(e.p == (four_p - ((four_p % 4) + 4) % 4) / 4);
        }
        assert_true(e.x == radii[i][0] && e.y == 0);
    }
}

/* ---- into pixels ----------------------------------------------------------------------------- */

static uint32_t memory[SIDE * SIDE], model[SIDE * SIDE];

static struct canvas canvas_of(uint32_t *pixels, unsigned bits, int width, int height)
{
    memset(pixels, 0, sizeof memory);
    return (struct canvas){.pixels = (uint8_t *)pixels,
                           .pitch = canvas_pitch(width, bits),
                           .width = width,
                           .height = height,
                           .bits = bits,
                           .dots_a_row = 1};
}

static void both_circles_light_the_same_pixels(void **state)
{
    (void)state;
    for (int r = 0; r <= 140; r++) {
        struct canvas a = canvas_of(memory, 8, SIDE, SIDE), b = canvas_of(model, 8, SIDE, SIDE);
        canvas_circle(&a, MIDDLE, MIDDLE, r, 1);
        canvas_circle_side(&b, MIDDLE, MIDDLE, r, 1);
        assert_memory_equal(memory, model, sizeof memory);
        canvas_of(model, 8, SIDE, SIDE);
        canvas_ellipse_midpoint(&b, MIDDLE, MIDDLE, r, r, 1);
        assert_memory_equal(memory, model, sizeof memory);
    }
}

/* Each row and column of the box is met, and each pixel has a neighbour: the outline is closed. */
static void outlines_are_closed_and_symmetric(void **state)
{
    (void)state;
    for (int i = 0; i < 2000; i++) {
        int rx = random_within(1, 40), ry = random_within(1, 40), lit = 0;
        struct canvas c = canvas_of(memory, 8, SIDE, SIDE);
        canvas_ellipse_midpoint(&c, MIDDLE, MIDDLE, rx, ry, 1);
        for (int y = -ry; y <= ry; y++)
            for (int x = -rx; x <= rx; x++) {
                const uint8_t *at = c.pixels + (MIDDLE + y) * SIDE + MIDDLE + x;
                const uint8_t *image = c.pixels + (MIDDLE - y) * SIDE + MIDDLE - x;
                assert_int_equal(*at, *image);
                lit += *at;
                int neighbours = at[1] + at[-1] + at[SIDE] + at[-SIDE] + at[SIDE + 1] +
                                 at[SIDE - 1] + at[-SIDE + 1] + at[-SIDE - 1];
                assert_true(!*at || neighbours >= (abs(x) == rx && ry * ry < rx ? 1 : 2));
            }
        for (int x = -rx; x <= rx; x++) {
            int found = 0;
            for (int y = -ry; y <= ry; y++)
                found += c.pixels[(MIDDLE + y) * SIDE + MIDDLE + x];
            assert_true(found >= 1);
        }
        int all = 0;
        for (int k = 0; k < SIDE * SIDE; k++)
            all += c.pixels[k];
        assert_int_equal(all, lit);
    }
}

static void canvases_cut_and_formats_agree(void **state)
{
    (void)state;
    static const unsigned formats[] = {1, 2, 4, 8, 16, 32};
    for (int i = 0; i < 6000; i++) {
        unsigned bits = formats[i % 6];
        int width = random_within(1, SIDE), height = random_within(1, SIDE / 4);
        int x = random_within(-60, SIDE), y = random_within(-60, 100);
        int rx = random_within(0, 60), ry = i % 2 ? rx : random_within(0, 60);
        uint32_t colour = seed;
        struct canvas c = canvas_of(memory, bits, width, height);
        struct canvas m = canvas_of(model, bits, width, height);
        struct ellipse_midpoint e;
        if (rx == ry && i % 4 == 1)
            canvas_circle(&c, x, y, rx, colour);
        else if (rx == ry)
            canvas_circle_side(&c, x, y, rx, colour);
        else
            canvas_ellipse_midpoint(&c, x, y, rx, ry, colour);
        ellipse_midpoint_begin(&e, rx, ry);
        while (ellipse_midpoint_next(&e))
            for (int k = 0; k < 4; k++)
                canvas_dot(&m, x + (k & 1 ? e.x : -e.x), y + (k & 2 ? e.y : -e.y), colour);
        assert_memory_equal(memory, model, sizeof memory);
    }
}

static void impossible_radii_draw_nothing(void **state)
{
    (void)state;
    struct canvas c = canvas_of(memory, 8, SIDE, SIDE);
    canvas_circle(&c, 50, 50, -1, 1);
    canvas_circle_side(&c, 50, 50, -7, 1);
    canvas_circle(&c, 50, 50, INT32_MAX, 1);
    canvas_ellipse_midpoint(&c, 50, 50, -1, 5, 1);
    canvas_ellipse_midpoint(&c, 50, 50, 5, -1, 1);
    canvas_ellipse_midpoint(&c, 50, 50, 5, ELLIPSE_LARGEST + 1, 1);
    for (size_t i = 0; i < sizeof memory / sizeof *memory; i++)
        assert_int_equal(memory[i], 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_circle_examples),
        cmocka_unit_test(the_ellipse_example),
        cmocka_unit_test(circles_are_nearest),
        cmocka_unit_test(large_circles_do_not_overflow),
        cmocka_unit_test(ellipses_are_near),
        cmocka_unit_test(the_largest_ellipses_do_not_overflow),
        cmocka_unit_test(both_circles_light_the_same_pixels),
        cmocka_unit_test(outlines_are_closed_and_symmetric),
        cmocka_unit_test(canvases_cut_and_formats_agree),
        cmocka_unit_test(impossible_radii_draw_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
