/* The converters between head units, millimetres, cells and window pixels: known points, inverses.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "crt/geometry.h"

#define NEAR(a, b, eps) assert_true(fabs((double)(a) - (double)(b)) <= (eps))

static const struct crt_screen screens[] = {
    {234.95, 234.95, 1024, 1024}, {228.6, 171.45, 1024, 768}, {100, 50, 3, 5}, {1, 1000, 65536, 2}};
#define SCREENS (sizeof screens / sizeof screens[0])

static void units_lie_where_the_header_says(void **state)
{
    (void)state;
    const struct crt_screen s = {100, 50, 10, 5}; /* pitches of 10 mm */
    const double known[][4] = {{0, 0, -45, -20},
                               {9, 4, 45, 20},
                               {4.5, 2, 0, 0},
                               {-0.5, -0.5, -50, -25},
                               {9.5, 4.5, 50, 25}};
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        float x, y;
        crt_screen_to_mm(&s, known[i][0], known[i][1], &x, &y);
        NEAR(x, known[i][2], 1e-5);
        NEAR(y, known[i][3], 1e-5);
    }
    for (size_t i = 0; i < SCREENS; i++) { /* first and last unit are alike about the centre */
        float x0, y0, x1, y1;
        crt_screen_to_mm(&screens[i], 0, 0, &x0, &y0);
        crt_screen_to_mm(&screens[i], screens[i].units_x - 1, screens[i].units_y - 1, &x1, &y1);
        NEAR(x0, -x1, 1e-5);
        NEAR(y0, -y1, 1e-5);
        assert_true(x1 > x0 && y1 > y0);
        double pitch = screens[i].width_mm / screens[i].units_x;
        NEAR(x0 + screens[i].width_mm / 2, pitch / 2, 1e-4);
    }
}

static void units_and_millimetres_are_inverse(void **state)
{
    (void)state;
    for (size_t i = 0; i < SCREENS; i++)
        for (double u = -2; u < screens[i].units_x + 2; u += screens[i].units_x / 37) {
            double v = u * screens[i].units_y / screens[i].units_x, bu, bv;
            float x, y;
            crt_screen_to_mm(&screens[i], u, v, &x, &y);
            crt_mm_to_units(&screens[i], (double)x, (double)y, &bu, &bv);
            NEAR(bu, u, screens[i].units_x * 1e-6); /* millimetres are floats */
            NEAR(bv, v, screens[i].units_y * 1e-6);
        }
}

static void cells_count_down_from_the_top_left(void **state)
{
    (void)state;
    const struct crt_grid g = {8, 4, 0.5, -2, 1};
    double x, y, col, row;
    crt_cell_to_mm(&g, 0, 0, &x, &y);
    NEAR(x, -1.75, 0);
    NEAR(y, 0.75, 0);
    crt_cell_to_mm(&g, 7, 3, &x, &y);
    NEAR(x, 1.75, 0);
    NEAR(y, -0.75, 0);
    crt_mm_to_cell(&g, -2, 1, &col, &row); /* the outer corner */
    NEAR(col, -0.5, 0);
    NEAR(row, -0.5, 0);
    for (double c = -3; c < 12; c += 0.37) {
        crt_cell_to_mm(&g, c, c / 2, &x, &y);
        crt_mm_to_cell(&g, x, y, &col, &row);
        NEAR(col, c, 1e-12);
        NEAR(row, c / 2, 1e-12);
    }
}

static void cover_covers_and_is_centred(void **state)
{
    (void)state;
    for (size_t i = 0; i < 3; i++)
        for (double border = 0; border < 20; border += 6.5)
            for (double cell = 0.1; cell < 3; cell *= 1.37) {
                struct crt_grid g = crt_grid_cover(&screens[i], border, cell);
                double w = screens[i].width_mm + 2 * border, h = screens[i].height_mm + 2 * border;
                assert_true(g.cell_mm <= cell);
                assert_int_equal(g.cols % 8, 0);
                assert_true(g.cols * g.cell_mm >= w - 1e-9 && g.rows * g.cell_mm >= h - 1e-9);
                assert_true(g.cols * g.cell_mm < w + 8 * cell + 1e-9);
                assert_true(g.rows * g.cell_mm < h + cell + 1e-9);
                double col, row;
                crt_mm_to_cell(&g, 0, 0, &col, &row);
                NEAR(col, (g.cols - 1) / 2.0, 1e-9);
                NEAR(row, (g.rows - 1) / 2.0, 1e-9);
            }
}

static void closeup_is_where_it_was_asked_for(void **state)
{
    (void)state;
    struct crt_grid g = crt_grid_closeup(12.5, -30, 4, 640, 480);
    double x0, y0, x1, y1;
    NEAR(g.cell_mm, 4.0 / 640, 1e-15);
    crt_cell_to_mm(&g, -0.5, -0.5, &x0, &y0);
    crt_cell_to_mm(&g, 639.5, 479.5, &x1, &y1);
    NEAR(x0, 10.5, 1e-12);
    NEAR(x1, 14.5, 1e-12);
    NEAR((y0 + y1) / 2, -30, 1e-12);
    NEAR(y0 - y1, 3, 1e-12);
}

static void letterbox_keeps_the_aspect(void **state)
{
    (void)state;
    const int sizes[][2] = {{800, 600}, {600, 800}, {1, 1}, {1920, 1080}, {333, 334}};
    const double shapes[][2] = {{4, 3}, {1, 1}, {1, 7}, {228.6, 171.45}};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++)
        for (size_t k = 0; k < sizeof shapes / sizeof shapes[0]; k++) {
            int w = sizes[i][0], h = sizes[i][1];
            struct crt_viewport v = crt_letterbox(shapes[k][0], shapes[k][1], w, h);
            NEAR(v.w / v.h, shapes[k][0] / shapes[k][1], 1e-9);
            NEAR(2 * v.x + v.w, w, 1e-9); /* centred */
            NEAR(2 * v.y + v.h, h, 1e-9);
            assert_true(v.x >= -1e-9 && v.y >= -1e-9);
            assert_true(v.x < 1e-9 || v.y < 1e-9); /* as large as it can be */
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(units_lie_where_the_header_says),
        cmocka_unit_test(units_and_millimetres_are_inverse),
        cmocka_unit_test(cells_count_down_from_the_top_left),
        cmocka_unit_test(cover_covers_and_is_centred),
        cmocka_unit_test(closeup_is_where_it_was_asked_for),
        cmocka_unit_test(letterbox_keeps_the_aspect),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
