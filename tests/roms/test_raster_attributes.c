/* Attributes of lines (roms/raster): antialiased lines against an integral of the cone in
 * double precision, dashes against distances along the polyline, thick lines against distances from
 * it. */
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
#include "roms/raster/line_bresenham.c"
#include "roms/raster/line_dashed.c"
#include "roms/raster/line_thick.c"
#include "roms/raster/polygon_fill.c"
#include "tests/roms/raster_rig.h"

static const double pi = 3.14159265358979323846;

/* ---- antialiased lines ----------------------------------------------------------------------- */

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

/* Each pixel of a column is as light as its distance from the line in double precision says, and
 * those beside the column's four are too far to be lit. */
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
        uint32_t coverage = random_below(256);
        uint32_t mixture = blend_32(old, new, coverage);
        for (int shift = 0; shift < 24; shift += 8) {
            double a = old >> shift & 255, b = new >> shift & 255;
            assert_true(fabs((mixture >> shift & 255) - (a + (b - a) * coverage / 255.0)) < 2);
        }
        old &= 0xFFFF, new &= 0xFFFF;
        mixture = blend_16(old, new, coverage);
        for (int n = 0; n < 3; n++) {
            static const int at[] = {0, 5, 11}, most[] = {31, 63, 31};
            double a = (int)(old >> at[n]) & most[n], b = (int)(new >> at[n]) & most[n];
            double is = (int)(mixture >> at[n]) & most[n];
            assert_true(fabs(is - (a + (b - a) * coverage / 255.0)) < 2.1);
        }
    }
}

/* Lines that leave the canvas, on one within a larger store: some of its pixels are lit, and what
 * lies about it stays; lines that are no lines light nothing. */
static void blended_lines_are_contained(void **state)
{
    (void)state;
    enum { INSET = 20 };
    for (unsigned bits = 16; bits <= 32; bits += 16) {
        struct canvas all = canvas_of(bits), c = all;
        c.pixels += (unsigned)INSET * c.pitch + INSET * bits / 8;
        c.width -= 2 * INSET;
        c.height -= 2 * INSET;
        for (int i = 0; i < 2000; i++)
            canvas_line_blended(&c, random_within(-500, 500), random_within(-500, 500),
                                random_within(-500, 500), random_within(-500, 500), 0xFFFF);
        int lit = 0;
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                bool within = x >= INSET && y >= INSET && x < WIDTH - INSET && y < HEIGHT - INSET;
                bool is_lit = canvas_pixel(&all, x, y) != 0;
                assert_true(within || !is_lit);
                lit += is_lit;
            }
        assert_true(lit > c.width * c.height / 2);
        canvas_clear(&all, 0);
        canvas_line_blended(&c, NAN, 0, 10, 10, 1);
        canvas_line_blended(&c, -INFINITY, 0, 10, 10, 1);
        canvas_line_blended(&c, 3e38f, 0, -3e38f, 10, 1);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++)
                assert_int_equal(canvas_pixel(&all, x, y), 0);
    }
}

/* ---- dashes ---------------------------------------------------------------------------------- */

/* Each pixel of a polyline is on as its distance along it says; corners do not disturb. */
static void dashes_go_on_around_corners(void **state)
{
    (void)state;
    long checked = 0;
    for (int i = 0; i < 3000; i++) {
        struct dash_pattern pattern = {.count = 2 + 2 * (int)random_below(4)};
        struct dash_phase phase = {0};
        int total = 0, x0 = (int)random_below(1000), y0 = (int)random_below(1000);
        for (int k = 0; k < pattern.count; k++)
            total += pattern.length[k] = (uint8_t)(1 + random_below(30));
        double along = 0;
        for (int n = 0; n < 6; n++) {
            int x1 = (int)random_below(1000), y1 = (int)random_below(1000), x = 0, y = 0;
            double length = hypot(x1 - x0, y1 - y0), longer = fmax(abs(x1 - x0), abs(y1 - y0));
            struct line_dashed line;
            bool on;
            int pixels = 0;
            line_dashed_begin(&line, x0, y0, x1, y1, &pattern, &phase);
            for (; line_dashed_next(&line, &x, &y, &on); pixels++) {
                double here = longer > 0 ? along + pixels * length / longer : along;
                double within = fmod(here, total);
                int k = 0;
                for (; within >= pattern.length[k]; k++)
                    within -= pattern.length[k];
                double edge = fmin(within, pattern.length[k] - within);
                if (edge < 0.05)
                    continue; /* where rounding decides */
                assert_int_equal(on, k % 2 == 0);
                checked++;
            }
            assert_int_equal(pixels, (int)longer + 1);
            assert_true(x == x1 && y == y1);
            along += length;
            x0 = x1;
            y0 = y1;
        }
    }
    assert_true(checked > 1000000);
}

/* Dashed or solid, a line from the same end has the same pixels. */
static void dashes_are_on_the_solid_lines_pixels(void **state)
{
    (void)state;
    static const struct dash_pattern pattern = {{3, 2}, 2};
    for (int y1 = -40; y1 <= 40; y1++)
        for (int x1 = -40; x1 <= 40; x1++) {
            struct dash_phase phase = {0};
            struct line_dashed dashed;
            struct line_bresenham solid;
            int x = 0, y = 0;
            bool on;
            line_dashed_begin(&dashed, 0, 0, x1, y1, &pattern, &phase);
            line_bresenham_begin(&solid, 0, 0, x1, y1);
            while (line_bresenham_next(&solid)) {
                assert_true(line_dashed_next(&dashed, &x, &y, &on));
                assert_true(x == solid.x && y == solid.y);
            }
            assert_false(line_dashed_next(&dashed, &x, &y, &on));
        }
}

static void dashes_outside_are_left_out(void **state)
{
    (void)state;
    static const struct dash_pattern solid = {{0}, 0}, dots = {{1, 1}, 2};
    struct dash_phase phase = {0};
    struct canvas c = canvas_of(8);
    canvas_line_dashed(&c, -30000, -20000, 30000, 20000, &dots, &phase, 1);
    canvas_line_dashed(&c, -30001, 0, 10, 10, &dots, &phase, 1);
    canvas_line_dashed(&c, 0, 50, WIDTH - 1, 50, &solid, &phase, 2);
    for (int x = 0; x < WIDTH; x++)
        assert_int_equal(canvas_pixel(&c, x, 50), 2);
}

/* ---- wide lines ------------------------------------------------------------------------------ */

static double from_segment(struct point2 a, struct point2 b, double x, double y)
{
    double dx = (double)b.x - a.x, dy = (double)b.y - a.y, square = dx * dx + dy * dy;
    double t = square > 0 ? ((x - a.x) * dx + (y - a.y) * dy) / square : 0;
    t = fmin(fmax(t, 0), 1);
    return hypot(x - a.x - t * dx, y - a.y - t * dy);
}

/* With round caps and joins: what is within half the width of the polyline, and nothing else. */
static void round_lines_are_what_is_near(void **state)
{
    (void)state;
    long edge = 0, all = 0;
    for (int i = 0; i < 400; i++) {
        struct canvas c = canvas_of(8);
        struct line_style style = {random_within(1, i % 9 == 0 ? 60 : 12), CAP_ROUND, JOIN_ROUND};
        struct point2 p[5];
        int count = 1 + (int)random_below(5);
        bool closed = i % 3 == 0 && count > 1;
        for (int k = 0; k < count; k++)
            p[k] = (struct point2){random_within(-10, 140), random_within(-10, 100)};
        if (count > 3 && i % 4 == 0)
            p[2] = p[1];
        canvas_line_thick(&c, p, count, closed, &style, 1);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                double d = from_segment(p[0], p[0], x, y);
                for (int k = 0; k + 1 < count + closed; k++)
                    d = fmin(d, from_segment(p[k], p[(k + 1) % count], x, y));
                all++;
                if (fabs(d - (double)style.width / 2) < 0.09)
                    edge++;
                else
                    assert_int_equal(canvas_pixel(&c, x, y), d < (double)style.width / 2);
            }
    }
    assert_true(edge < all / 50);
}

/* Butt and square ends: a rectangle, measured along the line and across it. */
static void ends_are_butt_or_square(void **state)
{
    (void)state;
    for (int i = 0; i < 600; i++) {
        struct canvas c = canvas_of(8);
        struct line_style style = {random_within(1, 30), i % 2 ? CAP_BUTT : CAP_SQUARE, JOIN_BEVEL};
        struct point2 p[2];
        for (int k = 0; k < 2; k++)
            p[k] = (struct point2){random_within(0, 128), random_within(0, 96)};
        double dx = (double)p[1].x - p[0].x, dy = (double)p[1].y - p[0].y, length = hypot(dx, dy);
        double more = style.cap == CAP_SQUARE ? style.width / 2 : 0;
        canvas_line_thick(&c, p, 2, false, &style, 1);
        for (int y = 0; y < HEIGHT && length > 1; y++)
            for (int x = 0; x < WIDTH; x++) {
                double along = ((x - (double)p[0].x) * dx + (y - (double)p[0].y) * dy) / length;
                double across = ((x - (double)p[0].x) * dy - (y - (double)p[0].y) * dx) / length;
                double outside = fmax(fmax(-more - along, along - length - more),
                                      fabs(across) - (double)style.width / 2);
                if (fabs(outside) > 0.05)
                    assert_int_equal(canvas_pixel(&c, x, y), outside < 0);
            }
    }
}

/* A right angle: the corner's square is there with a miter, half of it with a bevel. */
static void joins_are_mitered_or_bevelled(void **state)
{
    (void)state;
    static const struct point2 p[] = {{20, 70}, {60, 70}, {60, 20}};
    for (int mitered = 0; mitered <= 1; mitered++)
        for (int turned = 0; turned <= 1; turned++) {
            struct canvas c = canvas_of(8);
            struct line_style style = {20, CAP_BUTT, mitered ? JOIN_MITER : JOIN_BEVEL};
            struct point2 q[3] = {p[turned ? 2 : 0], p[1], p[turned ? 0 : 2]};
            canvas_line_thick(&c, q, 3, false, &style, 1);
            assert_int_equal(canvas_pixel(&c, 68, 78), mitered);
            assert_int_equal(canvas_pixel(&c, 64, 74), 1);
            assert_int_equal(canvas_pixel(&c, 66, 73), 1);
            assert_int_equal(canvas_pixel(&c, 71, 78), 0);
            assert_int_equal(canvas_pixel(&c, 52, 62), 1);
            assert_int_equal(canvas_pixel(&c, 49, 58), 0);
        }
    /* A corner too sharp for a miter is bevelled. */
    static const struct point2 sharp[] = {{10, 50}, {80, 50}, {10, 52}};
    struct canvas c = canvas_of(8);
    struct line_style style = {8, CAP_BUTT, JOIN_MITER};
    canvas_line_thick(&c, sharp, 3, false, &style, 1);
    assert_int_equal(canvas_pixel(&c, 86, 50), 0);
}

static void lines_of_no_length_are_their_caps(void **state)
{
    (void)state;
    static const struct point2 p[] = {{50, 50}, {50, 50}};
    for (int cap = CAP_BUTT; cap <= CAP_ROUND; cap++) {
        struct canvas c = canvas_of(8);
        struct line_style style = {21, (enum line_cap)cap, JOIN_MITER};
        canvas_line_thick(&c, p, 2, cap == CAP_SQUARE, &style, 1);
        assert_int_equal(canvas_pixel(&c, 50, 50), cap != CAP_BUTT);
        assert_int_equal(canvas_pixel(&c, 58, 58), cap == CAP_SQUARE);
        style.width = THICK_WIDEST + 1;
        canvas_line_thick(&c, p, 2, false, &style, 2);
        style.width = NAN;
        canvas_line_thick(&c, p, 2, false, &style, 2);
        canvas_line_thick(&c, p, 0, false, &style, 2);
        assert_int_equal(canvas_pixel(&c, 0, 0), 0);
    }
    struct thick_piece piece;
    struct line_thick line;
    struct line_style widest = {THICK_WIDEST, CAP_ROUND, JOIN_ROUND};
    line_thick_begin(&line, p, 1, false, &widest);
    while (line_thick_next(&line, &piece))
        assert_in_range(piece.count, 100, POLYGON_CORNERS);
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
        cmocka_unit_test(dashes_go_on_around_corners),
        cmocka_unit_test(dashes_are_on_the_solid_lines_pixels),
        cmocka_unit_test(dashes_outside_are_left_out),
        cmocka_unit_test(round_lines_are_what_is_near),
        cmocka_unit_test(ends_are_butt_or_square),
        cmocka_unit_test(joins_are_mitered_or_bevelled),
        cmocka_unit_test(lines_of_no_length_are_their_caps),
    };
    rig.state = 12345;
    return cmocka_run_group_tests(tests, NULL, NULL);
}
