/* Attributes of lines and text (roms/raster): antialiased lines against an integral of the cone in
 * double precision, dashes against distances along the polyline, thick lines against distances from
 * it, turned text against the font, dithered areas against their mean. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "roms/clip/liang_barsky.c"
#include "roms/raster/fill.c"
#include "roms/raster/line_antialiased.c"

enum { WIDTH = 128, HEIGHT = 96 };

static const double pi = 3.14159265358979323846;

static struct {
    uint32_t words[WIDTH * HEIGHT];
    uint32_t state;
} rig;

static uint32_t random_below(uint32_t limit)
{
    rig.state = rig.state * 1664525u + 1013904223u;
    return (rig.state >> 8) % limit;
}

static float random_within(float low, float high)
{
    return low + (high - low) * (float)random_below(65536) / 65536;
}

static struct canvas canvas_of(unsigned bits)
{
    memset(rig.words, 0, sizeof rig.words);
    struct canvas c = {.width = WIDTH, .height = HEIGHT, .bits = bits, .dots_a_row = 1};
    c.pitch = canvas_pitch(WIDTH, bits);
    c.pixels = (uint8_t *)rig.words;
    return c;
}

/* ---- antialiased lines ---------------------------------------------------------------------------- */

/* The cone's volume over the band |t - d| <= 1/2, summed over small squares. */
static double cone_over_band(double d)
{
    enum { PARTS = 400 };
    double sum = 0;
    for (int i = 0; i < PARTS; i++)
        for (int k = 0; k < PARTS; k++) {
            double t = (i + 0.5) * 2 / PARTS - 1, s = (k + 0.5) * 2 / PARTS - 1;
            double r = sqrt(t * t + s * s);
            if (r < 1 && fabs(t - d) <= 0.5)
                sum += 3 / pi * (1 - r) * 4 / PARTS / PARTS;
        }
    return sum;
}

static void coverage_is_the_cone_over_the_band(void **state)
{
    (void)state;
    for (int i = 0; i < ANTIALIASED_ENTRIES; i += 3)
        assert_true(fabs(antialiased_coverage[i] / 255.0 - cone_over_band(i / 64.0)) < 0.004);
}

/* Each pixel of a column is as light as its distance from the line in double precision says, and those
 * beside the column's four are too far to be lit. */
static void coverage_is_by_distance(void **state)
{
    (void)state;
    for (int i = 0; i < 5000; i++) {
        float x0 = random_within(0, 100), y0 = random_within(0, 90);
        float x1 = random_within(0, 100), y1 = random_within(0, 90);
        double length = hypot((double)x1 - x0, (double)y1 - y0);
        struct line_antialiased line;
        struct antialiased_column k;
        if (length < 2)
            continue;
        assert_true(line_antialiased_begin(&line, x0, y0, x1, y1));
        while (line_antialiased_next(&line, &k)) {
            double ends = k.steep ? fmin(k.along - fmin(y0, y1), fmax(y0, y1) - k.along)
                                  : fmin(k.along - fmin(x0, x1), fmax(x0, x1) - k.along);
            for (int n = -1; n <= ANTIALIASED_PIXELS; n++) {
                double x = k.steep ? k.across + n : k.along, y = k.steep ? k.along : k.across + n;
                double d =
                    fabs((x - x0) * ((double)y1 - y0) - (y - y0) * ((double)x1 - x0)) / length;
                if (n < 0 || n == ANTIALIASED_PIXELS) {
                    assert_true(d > 1.38); /* coverage below 1 % */
                    continue;
                }
                assert_true(fabs(k.distance[n] / 64.0 - d) < 0.03);
                if (ends >= 0)
                    assert_true(abs(k.coverage[n] - antialiased_coverage[(int)(d * 64)]) <= 8);
            }
        }
    }
}

/* The light of a line is its length, whatever its direction; an end moves without jumping. */
static void light_is_length(void **state)
{
    (void)state;
    for (int i = 0; i < 3000; i++) {
        float x0 = random_within(10, 110), y0 = random_within(10, 80);
        float x1 = random_within(10, 110), y1 = random_within(10, 80);
        struct line_antialiased line;
        struct antialiased_column k;
        double sum = 0, length = hypot(x1 - x0, y1 - y0);
        double longer = fmax(fabs(x1 - x0), fabs(y1 - y0));
        assert_true(line_antialiased_begin(&line, x0, y0, x1, y1));
        while (line_antialiased_next(&line, &k))
            for (int n = 0; n < ANTIALIASED_PIXELS; n++)
                sum += k.coverage[n] / 255.0;
        /* Half a column more at each end. */
        double expected = longer > 0 ? length * (longer + 1) / longer : 1;
        assert_true(fabs(sum - expected) < 0.02 * expected + 0.05);
    }
}

/* Pixels of a line in every format are those of its columns; crossing lines do not darken. */
static void ramps_are_drawn_in_every_format(void **state)
{
    (void)state;
    static const unsigned formats[] = {2, 4, 8, 16, 32};
    static const uint32_t ramp[] = {0, 1, 2, 3};
    for (size_t f = 0; f < sizeof formats / sizeof *formats; f++)
        for (int i = 0; i < 300; i++) {
            struct canvas c = canvas_of(formats[f]);
            static uint8_t model[HEIGHT][WIDTH];
            memset(model, 0, sizeof model);
            for (int n = 0; n < 3; n++) {
                float x0 = random_within(-40, 160), y0 = random_within(-40, 130);
                float x1 = random_within(-40, 160), y1 = random_within(-40, 130);
                struct line_antialiased line;
                struct antialiased_column k;
                canvas_line_antialiased(&c, x0, y0, x1, y1, ramp, 4);
                if (!begin_on(&c, &line, x0, y0, x1, y1))
                    continue;
                while (line_antialiased_next(&line, &k))
                    for (int p = 0; p < ANTIALIASED_PIXELS; p++) {
                        int x = k.steep ? k.across + p : k.along;
                        int y = k.steep ? k.along : k.across + p;
                        int level = (k.coverage[p] * 3 + 127) / 255;
                        if (x >= 0 && y >= 0 && x < WIDTH && y < HEIGHT && level > model[y][x])
                            model[y][x] = (uint8_t)level;
                    }
            }
            for (int y = 0; y < HEIGHT; y++)
                for (int x = 0; x < WIDTH; x++)
                    assert_int_equal(canvas_pixel(&c, x, y), model[y][x]);
        }
}

/* Each part of the colour lies between old and new as the coverage says. */
static void blending_mixes_each_primary(void **state)
{
    (void)state;
    for (int i = 0; i < 20000; i++) {
        uint32_t old = random_below(0x1000000), new = random_below(0x1000000);
        int coverage = (int)random_below(256);
        uint32_t mixture = blend(32, old, new, coverage);
        for (int shift = 0; shift < 24; shift += 8) {
            double a = old >> shift & 255, b = new >> shift & 255;
            assert_true(fabs((mixture >> shift & 255) - (a + (b - a) * coverage / 255.0)) < 2);
        }
        old &= 0xFFFF, new &= 0xFFFF;
        mixture = blend(16, old, new, coverage);
        for (int n = 0; n < 3; n++) {
            static const int at[] = {0, 5, 11}, most[] = {31, 63, 31};
            double a = (int)(old >> at[n]) & most[n], b = (int)(new >> at[n]) & most[n];
            double is = (int)(mixture >> at[n]) & most[n];
            assert_true(fabs(is - (a + (b - a) * coverage / 255.0)) < 2.1);
        }
    }
}

static void blended_lines_are_contained(void **state)
{
    (void)state;
    for (unsigned bits = 16; bits <= 32; bits += 16) {
        struct canvas c = canvas_of(bits);
        for (int i = 0; i < 2000; i++)
            canvas_line_blended(&c, random_within(-500, 500), random_within(-500, 500),
                                random_within(-500, 500), random_within(-500, 500), 0xFFFF);
        canvas_line_blended(&c, NAN, 0, 10, 10, 1);
        canvas_line_blended(&c, -INFINITY, 0, 10, 10, 1);
        canvas_line_blended(&c, 3e38f, 0, -3e38f, 10, 1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(coverage_is_the_cone_over_the_band),
        cmocka_unit_test(coverage_is_by_distance),
        cmocka_unit_test(light_is_length),
        cmocka_unit_test(ramps_are_drawn_in_every_format),
        cmocka_unit_test(blending_mixes_each_primary),
        cmocka_unit_test(blended_lines_are_contained),
    };
    rig.state = 12345;
    return cmocka_run_group_tests(tests, NULL, NULL);
}
