/* Film to picture: tone curve, gamut, sRGB encoding, and pictures of films built by hand. The slow
 * models here use libm and the four-digit matrices of IEC 61966-2-1, not the code under test. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "crt/develop.h"
#include "crt/srgb.h"

static double luminance(const double rgb[3])
{
    return 0.2126390058715104 * rgb[0] + 0.7151686787677559 * rgb[1] + 0.0721923153607337 * rgb[2];
}

/* Linear sRGB to xy with the standard's forward matrix. */
static struct crt_chromaticity chromaticity(const double rgb[3])
{
    double x = 0.4124 * rgb[0] + 0.3576 * rgb[1] + 0.1805 * rgb[2];
    double y = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
    double z = 0.0193 * rgb[0] + 0.1192 * rgb[1] + 0.9505 * rgb[2];
    return (struct crt_chromaticity){x / (x + y + z), y / (x + y + z)};
}

static double encode_libm(double v)
{
    return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1.0 / 2.4) - 0.055;
}

static const struct crt_chromaticity phosphor_colours[] = {
    {.218, .712}, {.279, .534}, {.523, .469}, {.270, .300}, {.151, .032}, {.357, .537},
    {.139, .148}, {.605, .394}, {.246, .439}, {.226, .528}, {.223, .698}, {.333, .556},
    {.640, .335}, {.166, .101}, {.640, .330}, {.300, .600}, {.150, .060}, {.3127, .3290},
};
#define COLOURS (sizeof phosphor_colours / sizeof phosphor_colours[0])

static void tone_is_straight_then_bends_smoothly_to_one(void **state)
{
    (void)state;
    struct crt_tone tone;
    crt_tone_init(&tone);
    assert_true(crt_tone_at(&tone, 0.0) == 0.0);
    assert_true(crt_tone_at(&tone, -1.0) == 0.0);
    assert_true(crt_tone_at(&tone, (double)NAN) == 0.0);
    assert_true(crt_tone_at(&tone, CRT_TONE_MAX) == 1.0);
    assert_true(crt_tone_at(&tone, 1e30) == 1.0);
    assert_true(crt_tone_at(&tone, (double)INFINITY) == 1.0);
    for (double v = 1e-9; v < 0.79; v *= 1.01)
        assert_true(fabs(crt_tone_at(&tone, v) / v - 1.0) < 1e-7);
    /* The slope, over steps of a table cell, never rises, never jumps and is never 0. */
    double last_slope = 1.0, last = crt_tone_at(&tone, 0.70);
    for (double v = 0.71; v < 60.0; v += 0.01) {
        double now = crt_tone_at(&tone, v), slope = (now - last) / 0.01;
        assert_true(now > last && now < 1.0);
        assert_true(slope < last_slope + 2e-5);
        assert_true(last_slope - slope < 0.12);
        last = now;
        last_slope = slope;
    }
    assert_true(fabs(crt_tone_at(&tone, 0.8) - 0.8) < 1e-7);
    /* White itself is the distance of the shoulder from white above it: half of the rest. */
    assert_true(crt_tone_at(&tone, 1.0) > 0.88 && crt_tone_at(&tone, 1.0) < 0.92);
    assert_true(crt_tone_at(&tone, 10.0) > 0.99);
}

static void tone_table_is_quadratic_and_interpolated_in_v(void **state)
{
    (void)state;
    struct crt_tone tone;
    crt_tone_init(&tone);
    for (int i = 0; i < CRT_TONE_SIZE - 1; i++) {
        double a = CRT_TONE_MAX * pow(i / 1023.0, 2), b = CRT_TONE_MAX * pow((i + 1) / 1023.0, 2);
        double half = ((double)tone.curve[i] + (double)tone.curve[i + 1]) / 2.0;
        assert_true(fabs(crt_tone_at(&tone, a) - (double)tone.curve[i]) < 4e-8);
        assert_true(fabs(crt_tone_at(&tone, (a + b) / 2.0) - half) < 4e-8);
    }
}

static void colours_fit_and_keep_their_luminance(void **state)
{
    (void)state;
    for (size_t c = 0; c < COLOURS; c++) {
        double last[3] = {0, 0, 0};
        for (int i = 0; i <= 5000; i++) {
            double y = i / 5000.0, rgb[3];
            crt_fit_srgb(y, phosphor_colours[c], rgb);
            assert_true(fabs(luminance(rgb) - y) < 1e-9);
            for (int k = 0; k < 3; k++) {
                assert_true(rgb[k] >= 0.0 && rgb[k] <= 1.0);
                /* Continuous and never falling: one step of y moves a channel by a few at most. */
                assert_true(rgb[k] >= last[k] - 1e-12 && rgb[k] - last[k] < 20.0 / 5000.0);
                last[k] = rgb[k];
            }
        }
    }
}

/* How much of its chroma a colour could keep and still fit, by bisection. */
static double greatest_share(double y, const double own[3])
{
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 60; i++) {
        double share = (low + high) / 2.0;
        bool fits = true;
        for (int k = 0; k < 3; k++) {
            double v = y + share * y * (own[k] - 1.0);
            fits = fits && v >= 0.0 && v <= 1.0;
        }
        *(fits ? &low : &high) = share;
    }
    return low;
}

static void colours_move_straight_toward_white(void **state)
{
    (void)state;
    for (size_t c = 0; c < COLOURS - 1; c++)
        for (int i = 1; i < 100; i++) {
            double y = i / 100.0, rgb[3], own[3];
            crt_fit_srgb(y, phosphor_colours[c], rgb);
            /* In xy, with the standard's own matrix. */
            double dx = phosphor_colours[c].x - 0.3127, dy = phosphor_colours[c].y - 0.3290;
            struct crt_chromaticity got = chromaticity(rgb);
            double gx = got.x - 0.3127, gy = got.y - 0.3290;
            assert_true(fabs(gx * dy - gy * dx) < 2e-4 * hypot(dx, dy)); /* parallel */
            /* In linear light: one share of the chroma for all channels, no more than fits and
             * no less than 0.707 of that. */
            crt_srgb_of(phosphor_colours[c], own);
            int widest = 0;
            for (int k = 1; k < 3; k++)
                if (fabs(own[k] - 1.0) > fabs(own[widest] - 1.0))
                    widest = k;
            double share = (rgb[widest] - y) / (y * (own[widest] - 1.0));
            double most = greatest_share(y, own);
            for (int k = 0; k < 3; k++)
                assert_true(fabs(y + share * y * (own[k] - 1.0) - rgb[k]) < 1e-12);
            assert_true(share <= most + 1e-12 && share >= 0.7071 * most);
        }
}

static void dim_colours_inside_are_as_good_as_untouched(void **state)
{
    (void)state;
    /* The primaries come back as themselves: to 1 % at a tenth, to 0.01 % at a hundredth. */
    const struct crt_chromaticity primary[3] = {{.64, .33}, {.30, .60}, {.15, .06}};
    const double y[3] = {0.2126390058715104, 0.7151686787677559, 0.0721923153607337};
    for (int p = 0; p < 3; p++)
        for (int i = 0; i < 2; i++) {
            double rgb[3], level = i == 0 ? 0.1 : 0.01, within = i == 0 ? 0.01 : 0.0001;
            crt_fit_srgb(y[p] * level, primary[p], rgb);
            for (int k = 0; k < 3; k++)
                assert_true(fabs(rgb[k] - (k == p ? level : 0.0)) < within * level);
        }
    /* White is white at any level. */
    for (int i = 0; i <= 100; i++) {
        double rgb[3];
        crt_fit_srgb(i / 100.0, (struct crt_chromaticity){.3127, .3290}, rgb);
        for (int k = 0; k < 3; k++)
            assert_true(fabs(rgb[k] - i / 100.0) < 1e-12);
    }
}

/* No edge where desaturation sets in: the slope of every channel changes little by little. */
static void desaturation_is_smooth(void **state)
{
    (void)state;
    for (size_t c = 0; c < COLOURS; c++) {
        double before[3], now[3], after[3];
        crt_fit_srgb(0.0000, phosphor_colours[c], before);
        crt_fit_srgb(0.0001, phosphor_colours[c], now);
        for (int i = 2; i <= 10000; i++) {
            crt_fit_srgb(i / 10000.0, phosphor_colours[c], after);
            for (int k = 0; k < 3; k++) {
                double change_of_slope = (after[k] - 2.0 * now[k] + before[k]) * 10000.0;
                assert_true(fabs(change_of_slope) < 0.1);
                before[k] = now[k];
                now[k] = after[k];
            }
        }
    }
}

static void encoder_follows_the_standard(void **state)
{
    (void)state;
    struct crt_srgb_encoder encoder;
    crt_srgb_encoder_init(&encoder);
    int last = 0;
    for (int i = 0; i <= 1000000; i++) {
        double v = i / 1e6;
        int got = crt_srgb_sample(&encoder, v, 65535.0);
        assert_true(fabs(got - encode_libm(v) * 65535.0) <= 0.6);
        assert_true(got >= last);
        last = got;
        if (i % 100 == 0) {
            int eight = crt_srgb_sample(&encoder, v, 255.0);
            assert_true(fabs(eight - encode_libm(v) * 255.0) <= 0.501);
        }
    }
    assert_int_equal(crt_srgb_sample(&encoder, 1.0, 65535.0), 65535);
    assert_int_equal(crt_srgb_sample(&encoder, 7.0, 255.0), 255);
    assert_int_equal(crt_srgb_sample(&encoder, -1.0, 255.0), 0);
    assert_int_equal(crt_srgb_sample(&encoder, (double)NAN, 255.0), 0);
    /* Every 16-bit sample can be reached: no banding from the table. */
    for (int s = 0; s <= 65535; s++) {
        double e = s / 65535.0, v = e <= 0.04045 ? e / 12.92 : pow((e + 0.055) / 1.055, 2.4);
        assert_true(abs((int)crt_srgb_sample(&encoder, v, 65535.0) - s) <= (s > 0 ? 1 : 0));
    }
}

static void auto_gain_puts_a_line_at_eight_tenths(void **state)
{
    (void)state;
    struct crt_tube_row row = {.line_luminance = {.value = 137.0}};
    struct crt_tone tone;
    crt_tone_init(&tone);
    double v = crt_auto_gain(&row) * 137.0;
    assert_true(fabs(v - 0.8) < 1e-15);
    assert_true(fabs(crt_tone_at(&tone, v) - 0.8) < 1e-7);
}

#define W 64
#define H 48

static void film_of(struct crt_film *film, float *light0, float *light1)
{
    *film = (struct crt_film){
        .grid = {.cols = W, .rows = H, .cell_mm = 1.0, .left_mm = -W / 2.0, .top_mm = H / 2.0},
        .colours = light1 ? 2 : 1,
        .light = {light0, light1},
        .t0 = 1000,
        .t1 = 1000 + CRT_PS_PER_S / 60,
        .complete = true,
    };
}

static const struct crt_phosphor white = {.colours = 1, .colour = {{.3127, .3290}}};
static const struct crt_phosphor p39 = {.colours = 1, .colour = {{.223, .698}}};
static const struct crt_phosphor p7 = {.colours = 2, .colour = {{.151, .032}, {.357, .537}}};

static void a_grey_ramp_is_grey_monotone_and_right(void **state)
{
    (void)state;
    static float light[W * H];
    const double seconds = (double)(CRT_PS_PER_S / 60) * 1e-12;
    for (int i = 0; i < W * H; i++) /* 0 … 100 cd/m², white at gain 1/100 */
        light[i] = (float)(100.0 * i / (W * H - 1) * seconds);
    struct crt_film film;
    film_of(&film, light, NULL);
    for (int depth = 8; depth <= 16; depth += 8) {
        struct crt_image image;
        struct crt_error err;
        double max = depth == 8 ? 255.0 : 65535.0;
        assert_true(crt_develop(&film, &white, 0.01, depth, 1, &image, &err));
        assert_int_equal(image.width, W);
        assert_int_equal(image.height, H);
        assert_int_equal(image.depth, depth);
        for (int i = 0; i < W * H; i++) {
            const uint16_t *s = image.samples + 3 * i;
            double v = i / (double)(W * H - 1);
            assert_int_equal(s[0], s[1]);
            assert_int_equal(s[1], s[2]);
            if (i > 0)
                assert_true(s[0] >= s[-3] + (depth == 16));
            if (v < 0.79)
                assert_true(fabs(s[0] - encode_libm(v) * max) < 0.65);
        }
        crt_image_free(&image);
    }
}

/* A pixel's colour through the functions of the header one by one. */
static void expect_pixel(const uint16_t *got, double v, struct crt_chromaticity c)
{
    struct crt_tone tone;
    crt_tone_init(&tone);
    double rgb[3];
    crt_fit_srgb(crt_tone_at(&tone, v), c, rgb);
    for (int k = 0; k < 3; k++)
        assert_true(fabs(got[k] - encode_libm(rgb[k]) * 65535.0) < 0.7);
}

static void two_colours_add_as_light(void **state)
{
    (void)state;
    static float blue[W * H], yellow[W * H];
    srand(2);
    for (int i = 0; i < W * H; i++) {
        blue[i] = i % 3 == 0 ? 0.0f : (float)(pow(rand() / (double)RAND_MAX, 4) * 3.0);
        yellow[i] = i % 5 == 0 ? 0.0f : (float)(pow(rand() / (double)RAND_MAX, 4) * 3.0);
    }
    blue[7] = -1.0f; /* counts as 0 */
    yellow[8] = NAN;
    struct crt_film film;
    struct crt_image image;
    struct crt_error err;
    film_of(&film, blue, yellow);
    const double seconds = (double)(film.t1 - film.t0) * 1e-12;
    assert_true(crt_develop(&film, &p7, 0.008, 16, 2, &image, &err));
    for (int i = 0; i < W * H; i++) {
        double b = blue[i] > 0 ? (double)blue[i] : 0.0, y = yellow[i] > 0 ? (double)yellow[i] : 0.0;
        const uint16_t *s = image.samples + 3 * i;
        if (b + y == 0.0) {
            assert_int_equal(s[0] | s[1] | s[2], 0);
            continue;
        }
        /* XYZ of each colour, added. */
        double sx = b * .151 / .032 + y * .357 / .537;
        double sz = b * (1 - .151 - .032) / .032 + y * (1 - .357 - .537) / .537;
        double sum = sx + b + y + sz;
        expect_pixel(s, (b + y) / seconds * 0.008,
                     (struct crt_chromaticity){sx / sum, (b + y) / sum});
    }
    crt_image_free(&image);
}

static void three_colours_add_as_light(void **state)
{
    (void)state;
    static float light[3][W * H];
    srand(4);
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < W * H; i++)
            light[c][i] = (i + c) % 5 == 0 ? 0.0f : (float)(pow(rand() / (double)RAND_MAX, 3) * 2);
    light[2][7] = -1.0f; /* counts as 0 */
    light[0][8] = NAN;
    for (int c = 0; c < 3; c++)
        light[c][9] = 0;
    struct crt_film film;
    struct crt_image image;
    struct crt_error err;
    film_of(&film, light[0], light[1]);
    film.colours = 3;
    film.light[2] = light[2];
    const double seconds = (double)(film.t1 - film.t0) * 1e-12;
    const struct crt_phosphor *p22 = crt_phosphor_find("P22");
    assert_true(crt_develop(&film, p22, 0.008, 16, 2, &image, &err));
    for (int i = 0; i < W * H; i++) {
        double X = 0, Y = 0, Z = 0;
        for (int c = 0; c < 3; c++) {
            double l = light[c][i] > 0 ? (double)light[c][i] : 0.0;
            const struct crt_chromaticity *p = &p22->colour[c];
            X += l * p->x / p->y;
            Y += l;
            Z += l * (1 - p->x - p->y) / p->y;
        }
        const uint16_t *s = image.samples + 3 * i;
        if (Y == 0)
            assert_int_equal(s[0] | s[1] | s[2], 0);
        else
            expect_pixel(s, Y / seconds * 0.008,
                         (struct crt_chromaticity){X / (X + Y + Z), Y / (X + Y + Z)});
    }
    crt_image_free(&image);
}

static void threads_and_exposure_do_not_change_the_picture(void **state)
{
    (void)state;
    static float light[W * H], twice[W * H];
    srand(3);
    for (int i = 0; i < W * H; i++) {
        light[i] = (float)(rand() / (double)RAND_MAX * 2.0);
        twice[i] = 2.0f * light[i];
    }
    struct crt_film film, longer;
    film_of(&film, light, NULL);
    film_of(&longer, twice, NULL);
    longer.t1 = longer.t0 + 2 * (film.t1 - film.t0);
    char one[65], more[65];
    struct crt_image image;
    struct crt_error err;
    assert_true(crt_develop(&film, &p39, 0.01, 16, 1, &image, &err));
    crt_image_hash(&image, one);
    crt_image_free(&image);
    const int threads[] = {0, 2, 3, 4, 47, 1000};
    for (size_t t = 0; t < sizeof threads / sizeof threads[0]; t++) {
        assert_true(crt_develop(&film, &p39, 0.01, 16, threads[t], &image, &err));
        crt_image_hash(&image, more);
        crt_image_free(&image);
        assert_string_equal(more, one);
    }
    assert_true(crt_develop(&longer, &p39, 0.01, 16, 1, &image, &err));
    crt_image_hash(&image, more);
    crt_image_free(&image);
    assert_string_equal(more, one);
}

/* The same samples from every compiler and processor. The light comes from integers alone. */
static void the_samples_are_these(void **state)
{
    (void)state;
    static float light[3][W * H];
    uint32_t seed = 12345;
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < W * H; i++) {
            seed = seed * 1664525u + 1013904223u;
            float f = (float)(seed >> 8) / 16777216.0f;
            light[c][i] = f * f * f * f * 40.0f;
        }
    struct crt_film film;
    struct crt_image image;
    struct crt_error err;
    char hex[65];
    film_of(&film, light[0], NULL);
    assert_true(crt_develop(&film, &p39, 0.01, 16, 1, &image, &err));
    crt_image_hash(&image, hex);
    crt_image_free(&image);
    assert_string_equal(hex, "81272cbd133e6ab40fd852b9270ed092b5e70c1a6ceaeb2239502f7049604263");
    film_of(&film, light[0], light[1]);
    assert_true(crt_develop(&film, &p7, 0.01, 16, 1, &image, &err));
    crt_image_hash(&image, hex);
    crt_image_free(&image);
    assert_string_equal(hex, "c077633c08bfde57c9e917ee3ef92ae104e0bb540ee0da11cf047e13eeafcdce");
    film.colours = 3;
    film.light[2] = light[2];
    assert_true(crt_develop(&film, crt_phosphor_find("P22"), 0.01, 16, 1, &image, &err));
    crt_image_hash(&image, hex);
    crt_image_free(&image);
    assert_string_equal(hex, "fd3005dcce2d59f74d820bf9dbd2d34d141f2ffc6d0d4e97274d14ed0bdee44c");
}

static void an_impossible_film_is_refused(void **state)
{
    (void)state;
    float light[8] = {0};
    struct crt_film film;
    film_of(&film, light, NULL);
    film.grid.cols = CRT_IMAGE_MAX_SIDE + 8;
    struct crt_image image;
    struct crt_error err = {""};
    assert_false(crt_develop(&film, &p39, 0.01, 16, 1, &image, &err));
    assert_non_null(strstr(err.text, "16392 by 48"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tone_is_straight_then_bends_smoothly_to_one),
        cmocka_unit_test(tone_table_is_quadratic_and_interpolated_in_v),
        cmocka_unit_test(colours_fit_and_keep_their_luminance),
        cmocka_unit_test(colours_move_straight_toward_white),
        cmocka_unit_test(dim_colours_inside_are_as_good_as_untouched),
        cmocka_unit_test(desaturation_is_smooth),
        cmocka_unit_test(encoder_follows_the_standard),
        cmocka_unit_test(auto_gain_puts_a_line_at_eight_tenths),
        cmocka_unit_test(a_grey_ramp_is_grey_monotone_and_right),
        cmocka_unit_test(two_colours_add_as_light),
        cmocka_unit_test(three_colours_add_as_light),
        cmocka_unit_test(threads_and_exposure_do_not_change_the_picture),
        cmocka_unit_test(the_samples_are_these),
        cmocka_unit_test(an_impossible_film_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
