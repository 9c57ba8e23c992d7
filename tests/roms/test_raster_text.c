/* Text in any size and dithering (roms/raster): turned text against the font dot by dot, small
 * text against covered parts of pixels, dithered areas against their mean and Bayer's and
 * Floyd's and Steinberg's rules. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "roms/raster/dither.c"
#include "roms/raster/fill.c"
#include "roms/raster/font.c"
#include "roms/raster/text_antialiased.c"
#include "roms/raster/pixel.h"
#include "roms/raster/text_turned.c"
#include "tests/roms/raster_rig.h"

/* ---- text ------------------------------------------------------------------------------------ */

/* The dot of the font that a pixel of the canvas shows, for every direction and odd sizes. */
static void turned_text_is_the_font(void **state)
{
    (void)state;
    for (int i = 0; i < 400; i++) {
        struct canvas c = canvas_of(1);
        struct text_cell cell = {8 + (int)random_below(30), 12 + (int)random_below(40),
                                 (enum text_direction)(i % 4)};
        char text[4] = {(char)(33 + random_below(94)), (char)(33 + random_below(94)), 'g', '\0'};
        int x0 = (int)random_below(WIDTH), y0 = (int)random_below(HEIGHT);
        canvas_text_turned(&c, x0, y0, &cell, 1, text);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                int right = x - x0, down = y - y0;
                int along[] = {right, -down - 1, -right - 1, down};
                int across[] = {down, right, -down - 1, -right - 1};
                int a = along[i % 4], d = across[i % 4], lit = 0;
                if (a >= 0 && d >= 0 && a < 3 * cell.width && d < cell.height) {
                    int column = 0, row = 0;
                    while ((column + 1) * cell.width / FONT_WIDTH <= a % cell.width)
                        column++;
                    while ((row + 1) * cell.height / FONT_HEIGHT <= d)
                        row++;
                    lit = font_row(text[a / cell.width], row) >> (7 - column) & 1;
                }
                assert_int_equal(canvas_pixel(&c, x, y), lit);
            }
    }
}

/* Each pixel is as dark as the dots of the font that fall upon it, counted in small squares. */
static void small_text_is_covered_pixels(void **state)
{
    (void)state;
    enum { PARTS = 24, LEVELS = 256 };
    static uint32_t ramp[LEVELS];
    for (int i = 0; i < LEVELS; i++)
        ramp[i] = (uint32_t)i;
    for (int round = 0; round < 60; round++) {
        struct canvas c = canvas_of(8);
        float width = random_within(2, 12), height = random_within(3, 16);
        float x0 = random_within(-6, 120), y0 = random_within(-6, 90);
        const char text[2] = {(char)(33 + random_below(94)), '\0'};
        canvas_text_antialiased(&c, x0, y0, width, height, ramp, LEVELS, text);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                int lit = 0;
                float px = (float)x, py = (float)y;
                bool far = px + 1 < x0 || px > x0 + width || py + 1 < y0 || py > y0 + height;
                for (int i = 0; !far && i < PARTS * PARTS; i++) {
                    double u = (x + (i % PARTS + 0.5) / PARTS - x0) * FONT_WIDTH / width;
                    double v = (y + (i / PARTS + 0.5) / PARTS - y0) * FONT_HEIGHT / height;
                    if (u >= 0 && v >= 0 && u < FONT_WIDTH && v < FONT_HEIGHT)
                        lit += font_row(text[0], (int)v) >> (7 - (int)u) & 1;
                }
                double covered = 255.0 * lit / PARTS / PARTS;
                assert_true(fabs(canvas_pixel(&c, x, y) - covered) < 255 * 0.06);
            }
    }
}

/* Kept characters are those that are drawn at whole pixels, cut off at the canvas's edges. */
static void kept_text_is_the_same(void **state)
{
    (void)state;
    static struct text_shades shades;
    static uint32_t ramp[20];
    static uint8_t model[HEIGHT][WIDTH];
    for (int i = 0; i < 20; i++)
        ramp[i] = 100 + (uint32_t)i;
    for (int round = 0; round < 400; round++) {
        struct canvas c = canvas_of(8);
        float width = random_within(2, 16), height = random_within(3, 24);
        int x = (int)random_below(140) - 10, y = (int)random_below(120) - 12;
        char text[2] = {(char)(33 + random_below(94)), '\0'};
        canvas_clear(&c, 100);
        canvas_text_antialiased(&c, (float)x, (float)y, width, height, ramp, 20, text);
        for (int py = 0; py < HEIGHT; py++)
            for (int px = 0; px < WIDTH; px++)
                model[py][px] = (uint8_t)canvas_pixel(&c, px, py);
        for (int again = 0; again < 2; again++) {
            canvas_clear(&c, 100);
            text_shades_begin(&shades, width, height, ramp, 20);
            canvas_text_shades(&c, &shades, (float)x, (float)y, text);
            for (int py = 0; py < HEIGHT; py++)
                for (int px = 0; px < WIDTH; px++)
                    assert_int_equal(canvas_pixel(&c, px, py), model[py][px]);
        }
    }
}

/* ---- dithering ------------------------------------------------------------------------------- */

/* D(2n) from D(n), as Bayer builds it. */
static void matrices_are_bayers(void **state)
{
    (void)state;
    static const int two[2][2] = {{0, 2}, {3, 1}};
    for (int y = 0; y < 4; y++)
        for (int x = 0; x < 4; x++)
            assert_int_equal(dither_bayer_4[y][x], 4 * two[y % 2][x % 2] + two[y / 2][x / 2]);
    for (int y = 0; y < 8; y++)
        for (int x = 0; x < 8; x++)
            assert_int_equal(dither_bayer_8[y][x],
                             4 * dither_bayer_4[y % 4][x % 4] + two[y / 4][x / 4]);
}

static void ordered_dithering_keeps_the_mean(void **state)
{
    (void)state;
    for (int levels = 2; levels <= 256; levels = levels * 3 / 2 + 1)
        for (int v = 0; v <= 1000; v++)
            for (int order = DITHER_ORDERED_4; order <= DITHER_ORDERED_8; order++) {
                int side = order == DITHER_ORDERED_4 ? 4 : 8, sum = 0;
                for (int y = 0; y < side; y++)
                    for (int x = 0; x < side; x++) {
                        int level = dither_ordered((enum dither_method)order, levels, x + 16, y,
                                                   (float)v / 1000);
                        assert_in_range(level, 0, levels - 1);
                        sum += level;
                    }
                double mean = (double)sum / side / side / (levels - 1);
                /* As near as so many thresholds can be. */
                assert_true(fabs(mean - v / 1000.0) <= 0.5001 / side / side / (levels - 1) + 1e-5);
            }
    assert_int_equal(dither_ordered(DITHER_ORDERED_8, 4, 0, 0, NAN), 0);
    assert_int_equal(dither_ordered(DITHER_ORDERED_8, 4, 7, 7, 9), 3);
    assert_int_equal(dither_ordered(DITHER_NONE, 4, 7, 7, 0.51f), 2);
}

/* No light is lost but at the edges; a ramp keeps its mean in each part of it. */
static void diffusion_keeps_the_mean(void **state)
{
    (void)state;
    static float error[WIDTH + 2];
    for (int levels = 2; levels < 40; levels = levels * 2 - 1) {
        struct dither_diffusion d;
        double wanted[8] = {0}, got[8] = {0};
        dither_diffusion_begin(&d, error, WIDTH, levels);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                float v = 0.5f + 0.45f * sinf((float)x * 0.1f) * cosf((float)y * 0.07f);
                int level = dither_diffusion_next(&d, v);
                assert_in_range(level, 0, levels - 1);
                wanted[x / 16] += v;
                got[x / 16] += (double)level / (levels - 1);
            }
        for (int i = 0; i < 8; i++)
            assert_true(fabs(wanted[i] - got[i]) < 0.02 * wanted[i]);
    }
}

/* The weights themselves, against a picture whose errors are kept whole. */
static void diffusion_is_floyds_and_steinbergs(void **state)
{
    (void)state;
    static double picture[HEIGHT + 1][WIDTH + 2];
    static float error[WIDTH + 2];
    struct dither_diffusion d;
    int different = 0;
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            picture[y][x + 1] = random_within(0, 1);
    static double plain[HEIGHT + 1][WIDTH + 2];
    memcpy(plain, picture, sizeof plain);
    dither_diffusion_begin(&d, error, WIDTH, 2);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 1; x <= WIDTH; x++) {
            double value = picture[y][x];
            int level = value >= 0.5;
            different += level != dither_diffusion_next(&d, (float)plain[y][x]);
            double e = value - level;
            picture[y][x + 1] += e * 7 / 16;
            picture[y + 1][x - 1] += e * 3 / 16;
            picture[y + 1][x] += e * 5 / 16;
            picture[y + 1][x + 1] += e * 1 / 16;
        }
    assert_true(different < WIDTH * HEIGHT / 1000); /* where rounding decides */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(turned_text_is_the_font),
        cmocka_unit_test(small_text_is_covered_pixels),
        cmocka_unit_test(kept_text_is_the_same),
        cmocka_unit_test(matrices_are_bayers),
        cmocka_unit_test(ordered_dithering_keeps_the_mean),
        cmocka_unit_test(diffusion_keeps_the_mean),
        cmocka_unit_test(diffusion_is_floyds_and_steinbergs),
    };
    rig.state = 12345;
    return cmocka_run_group_tests(tests, NULL, NULL);
}
