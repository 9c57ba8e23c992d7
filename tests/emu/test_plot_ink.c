/* Ink against geometry: areas, symmetry, joints, clips, and the light of what is half covered. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "emu/plot/ink.h"

#define W 120
#define H 90

#define INK_W W
#define INK_H H
#include "tests/emu/ink_rig.h"

static uint32_t seed = 1;
static double between(double low, double high)
{
    seed = seed * 1664525u + 1013904223u;
    return low + (high - low) * (seed >> 8) / 16777216.0;
}

static double sum(void)
{
    double s = 0;
    for (int i = 0; i < W * H; i++)
        s += ink.coverage[i];
    return s;
}

static void a_line_covers_its_area(void **state)
{
    (void)state;
    const double pi = acos(-1.0);
    for (int i = 0; i < 400; i++) {
        double x0 = between(12, W - 12), y0 = between(12, H - 12), x1 = between(12, W - 12),
               y1 = between(12, H - 12);
        double width = between(1, 9), length = hypot(x1 - x0, y1 - y0);
        vm_ink_segment(&ink, x0, y0, x1, y1, width);
        double area = width * length + pi * width * width / 4;
        assert_true(fabs(sum() - area) < 0.002 * area + 0.3);
        vm_ink_forget(&ink);
        assert_true(sum() == 0);
    }
}

static void a_thin_line_is_fainter_not_narrower(void **state)
{
    (void)state;
    vm_ink_segment(&ink, 20.5, 30.5, 80.5, 30.5, 0.25);
    assert_true(fabs(sum() - 0.25 * 60) < 0.3);
    assert_true(fabs(ink.coverage[30 * W + 50] - 0.25) < 1e-6);
    vm_ink_forget(&ink);
}

static void lines_are_the_same_from_either_end_and_in_a_mirror(void **state)
{
    (void)state;
    static float there[W * H];
    for (int i = 0; i < 100; i++) {
        double x0 = between(-20, W + 20), y0 = between(-20, H + 20), x1 = between(-20, W + 20),
               y1 = between(-20, H + 20), width = between(0.5, 6);
        vm_ink_segment(&ink, x0, y0, x1, y1, width);
        memcpy(there, ink.coverage, sizeof there);
        vm_ink_forget(&ink);
        vm_ink_segment(&ink, x1, y1, x0, y0, width);
        for (int k = 0; k < W * H; k++)
            assert_true(fabsf(there[k] - ink.coverage[k]) < 1e-4f);
        vm_ink_forget(&ink);
        vm_ink_segment(&ink, W - x0, y0, W - x1, y1, width);
        for (int y = 0; y < H; y++)
            for (int x = 0; x < W; x++)
                assert_true(fabsf(there[y * W + x] - ink.coverage[y * W + W - 1 - x]) < 1e-4f);
        vm_ink_forget(&ink);
    }
}

static void joints_are_no_darker(void **state)
{
    (void)state;
    static float whole[W * H];
    vm_ink_segment(&ink, 10, 20, 100, 65, 3);
    memcpy(whole, ink.coverage, sizeof whole);
    vm_ink_forget(&ink);
    struct vm_ink_pen pen = {.width = 3};
    for (int i = 0; i <= 9; i++)
        vm_ink_to(&ink, &pen, 10 + 10 * i, 20 + 5 * i);
    for (int k = 0; k < W * H; k++)
        assert_true(fabsf(whole[k] - ink.coverage[k]) < 1e-5f);
    vm_ink_forget(&ink);
}

static void dashes_cover_their_share(void **state)
{
    (void)state;
    for (int parts = 1; parts <= 50; parts += 7) {
        struct vm_ink_pen pen = {.width = 3, .on = 12, .off = 8};
        for (int i = 0; i <= parts; i++)
            vm_ink_to(&ink, &pen, 10 + 100.0 * i / parts, 40.5);
        /* Five dashes and their round ends, however the line was handed over. */
        double area = 5 * (12 * 3 + acos(-1.0) * 9 / 4);
        assert_true(fabs(sum() - area) < 0.02 * area);
        vm_ink_forget(&ink);
    }
}

static void areas_add_up(void **state)
{
    (void)state;
    for (int i = 0; i < 200; i++) {
        double x = between(5, 20), y = between(10, 60), base = between(60, 80), area = 0;
        for (int k = 0; k < 40; k++) {
            double to_x = x + between(0, 2.2), to_y = between(10, 60);
            vm_ink_area(&ink, x, y, to_x, to_y, base);
            area += (to_x - x) * (base - (y + to_y) / 2);
            x = to_x;
            y = to_y;
        }
        assert_true(fabs(sum() - area) < 0.01);
        for (int k = 0; k < W * H; k++)
            assert_true(ink.coverage[k] < 1.0001f);
        vm_ink_forget(&ink);
    }
}

static void nothing_is_drawn_outside_the_clip(void **state)
{
    (void)state;
    const double hostile[] = {0,    -1,     1e300,       -1e300,           1e9,
                              -1e9, 1e-300, (double)NAN, (double)INFINITY, -(double)INFINITY};
    vm_ink_clip(&ink, (struct vm_rect){30, 20, 70, 50});
    for (int i = 0; i < 3000; i++) {
        double v[6];
        for (int k = 0; k < 6; k++)
            v[k] = between(0, 1) < 0.3 ? hostile[(int)between(0, 10)] : between(-200, 300);
        vm_ink_segment(&ink, v[0], v[1], v[2], v[3], v[4] > 200 ? 3 : v[4]);
        vm_ink_area(&ink, v[0], v[1], v[2], v[3], v[5]);
        struct vm_ink_pen pen = {.width = 2, .on = fabs(v[4]), .off = 3};
        vm_ink_to(&ink, &pen, v[0], v[1]);
        vm_ink_to(&ink, &pen, v[2], v[3]);
        vm_ink_box(&ink, (struct vm_rect){v[0], v[1], v[2], v[3]}, (struct vm_rgb){200, 100, 50},
                   0.5);
        vm_ink_spread(&ink, (struct vm_rgb){255, 255, 255}, 1);
    }
    vm_ink_unclip(&ink);
    int inside = 0;
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            bool in = x >= 30 && x < 70 && y >= 20 && y < 50;
            const uint16_t *s = image.samples + 3 * (y * W + x);
            assert_true(s[0] <= 255 && s[1] <= 255 && s[2] <= 255);
            assert_true(in || (s[0] | s[1] | s[2]) == 0);
            inside += in && s[0] > 0;
        }
    assert_true(inside > 1000);
    memset(image.samples, 0, sizeof(uint16_t) * 3 * W * H);
}

/* Half the light of white is sample 188 (IEC 61966-2-1), not 128. */
static void half_covered_is_half_the_light(void **state)
{
    (void)state;
    vm_ink_box(&ink, (struct vm_rect){0, 0, W, H}, (struct vm_rgb){255, 255, 255}, 1);
    vm_ink_box(&ink, (struct vm_rect){10, 10, 20.5, 20}, (struct vm_rgb){0, 0, 0}, 1);
    assert_int_equal(image.samples[3 * (15 * W + 15)], 0);
    assert_int_equal(image.samples[3 * (15 * W + 20)], 188);
    assert_int_equal(image.samples[3 * (15 * W + 21)], 255);
    vm_ink_segment(&ink, 40, 30, 80, 30, 1); /* half in each of two rows */
    vm_ink_spread(&ink, (struct vm_rgb){0, 0, 0}, 1);
    assert_int_equal(image.samples[3 * (29 * W + 60)], 188);
    assert_int_equal(image.samples[3 * (30 * W + 60)], 188);
    assert_int_equal(image.samples[3 * (31 * W + 60)], 255);
    assert_true(sum() == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_line_covers_its_area),
        cmocka_unit_test(a_thin_line_is_fainter_not_narrower),
        cmocka_unit_test(lines_are_the_same_from_either_end_and_in_a_mirror),
        cmocka_unit_test(joints_are_no_darker),
        cmocka_unit_test(dashes_cover_their_share),
        cmocka_unit_test(areas_add_up),
        cmocka_unit_test(nothing_is_drawn_outside_the_clip),
        cmocka_unit_test(half_covered_is_half_the_light),
    };
    return cmocka_run_group_tests(tests, open_sheet, close_sheet);
}
