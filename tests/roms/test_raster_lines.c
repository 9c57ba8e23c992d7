/* Lines (roms/raster/line*): against exact whole-number arithmetic by another way, and against the
 * tables worked by hand. The sources are compiled for this machine. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "roms/raster/fill.c"
#include "roms/raster/line.c"
#include "roms/raster/line_bresenham.c"
#include "roms/raster/line_dda.c"
#include "roms/raster/line_dda_integer.c"

enum { MOST = 8192, SIDE = 64 };

struct place {
    int x, y;
};

static struct place lit[MOST], other[MOST];
static uint32_t seed = 20261126;

static int random_within(int low, int high)
{
    seed = seed * 1664525u + 1013904223u;
    return low + (int)((uint64_t)seed * (uint64_t)(high - low + 1) >> 32);
}

static int bresenham(struct place *out, int x0, int y0, int x1, int y1)
{
    struct line_bresenham l;
    int count = 0;
    line_bresenham_begin(&l, x0, y0, x1, y1);
    while (line_bresenham_next(&l)) {
        assert_true(count < MOST);
        assert_int_equal(l.k, count);
        out[count++] = (struct place){l.x, l.y};
    }
    return count;
}

static int dda(struct place *out, int x0, int y0, int x1, int y1)
{
    struct line_dda l;
    int count = 0;
    line_dda_begin(&l, x0, y0, x1, y1);
    while (line_dda_next(&l))
        out[count++] = (struct place){l.plot_x, l.plot_y};
    return count;
}

static int dda_integer(struct place *out, int x0, int y0, int x1, int y1, int bits)
{
    struct line_dda_integer l;
    int count = 0;
    line_dda_integer_begin(&l, x0, y0, x1, y1, bits);
    while (line_dda_integer_next(&l))
        out[count++] = (struct place){l.plot_x, l.plot_y};
    return count;
}

/* Ends, number, steps of 1; the greatest distance along the shorter axis, times twice the longer
 * one. */
static int64_t check_line(const struct place *p, int count, int x0, int y0, int x1, int y1)
{
    int64_t dx = x1 - x0, dy = y1 - y0, longer = llabs(dx) > llabs(dy) ? llabs(dx) : llabs(dy);
    int64_t worst = 0;
    assert_int_equal(count, longer + 1);
    assert_int_equal(p[0].x, x0);
    assert_int_equal(p[0].y, y0);
    assert_int_equal(p[count - 1].x, x1);
    assert_int_equal(p[count - 1].y, y1);
    for (int i = 0; i < count; i++) {
        int64_t off = 2 * llabs(dx * (p[i].y - y0) - dy * (p[i].x - x0));
        worst = off > worst ? off : worst;
        if (i == 0)
            continue;
        int step_x = abs(p[i].x - p[i - 1].x), step_y = abs(p[i].y - p[i - 1].y);
        assert_true(step_x <= 1 && step_y <= 1);
        assert_int_equal(llabs(dx) >= llabs(dy) ? step_x : step_y, 1);
    }
    return worst;
}

/* ---- tables worked by hand ------------------------------------------------------------------- */

static void assert_places(const struct place *p, int count, const int (*want)[2], int wanted)
{
    assert_int_equal(count, wanted);
    for (int i = 0; i < count; i++) {
        assert_int_equal(p[i].x, want[i][0]);
        assert_int_equal(p[i].y, want[i][1]);
    }
}

static void the_dda_examples(void **state)
{
    (void)state;
    static const int steep[][2] = {{0, 0}, {1, 1}, {2, 2}, {2, 3}, {3, 4}, {4, 5}};
    static const int flat[][2] = {{0, 0}, {1, 1}, {2, 2}, {3, 2}, {4, 3}, {5, 4}};
    assert_places(lit, dda(lit, 0, 0, 4, 5), steep, 6);
    assert_places(lit, dda(lit, 0, 0, 5, 4), flat, 6);
    assert_places(lit, dda_integer(lit, 0, 0, 4, 5, 16), steep, 6);
    assert_places(lit, dda_integer(lit, 0, 0, 5, 4, 16), flat, 6);
}

static void the_bresenham_example(void **state)
{
    (void)state;
    static const int p[] = {6, 2, -2, 14, 10, 6, 2, -2, 14, 10};
    static const int places[][2] = {{20, 10}, {21, 11}, {22, 12}, {23, 12}, {24, 13}, {25, 14},
                                    {26, 15}, {27, 16}, {28, 16}, {29, 17}, {30, 18}};
    struct line_bresenham l;
    line_bresenham_begin(&l, 20, 10, 30, 18);
    for (int k = 0; line_bresenham_next(&l) && k < 10; k++)
        assert_int_equal(l.p, p[k]);
    assert_places(lit, bresenham(lit, 20, 10, 30, 18), places, 11);
}

static void ties_step_the_shorter_axis(void **state)
{
    (void)state;
    static const int along[][2] = {{0, 0}, {1, 1}, {2, 1}}, down[][2] = {{0, 0}, {1, -1}, {2, -1}};
    static const int back[][2] = {{2, 1}, {1, 1}, {0, 0}};
    assert_places(lit, bresenham(lit, 0, 0, 2, 1), along, 3);
    assert_places(lit, bresenham(lit, 0, 0, 2, -1), down, 3);
    assert_places(lit, bresenham(lit, 2, 1, 0, 0), back, 3);
}

/* ---- properties ------------------------------------------------------------------------------ */

/* Small lines all, then random ones. */
static void each_line(void (*check)(int x0, int y0, int x1, int y1))
{
    for (int dx = -20; dx <= 20; dx++)
        for (int dy = -20; dy <= 20; dy++)
            check(3, -5, 3 + dx, -5 + dy);
    for (int i = 0; i < 20000; i++)
        check(random_within(-2000, 2000), random_within(-2000, 2000), random_within(-2000, 2000),
              random_within(-2000, 2000));
}

static void bresenham_is_right(int x0, int y0, int x1, int y1)
{
    int count = bresenham(lit, x0, y0, x1, y1);
    assert_true(check_line(lit, count, x0, y0, x1, y1) <= count - 1);
    assert_int_equal(bresenham(other, x1, y1, x0, y0), count);
    for (int i = 0; i < count; i++) {
        assert_int_equal(lit[i].x, other[count - 1 - i].x);
        assert_int_equal(lit[i].y, other[count - 1 - i].y);
    }
}

static void bresenham_is_nearest_and_symmetric(void **state)
{
    (void)state;
    each_line(bresenham_is_right);
}

/* Sums of floats lose at most half a place of the last binary digit a step. */
static void dda_is_right(int x0, int y0, int x1, int y1)
{
    int count = dda(lit, x0, y0, x1, y1);
    int64_t worst = check_line(lit, count, x0, y0, x1, y1);
    double lost = (count - 1) * (ldexp(1, -14) + ldexp(1, -24));
    assert_true((double)worst <= (count - 1) * (1 + 2 * lost));
}

static void the_dda_drifts_no_more_than_it_must(void **state)
{
    (void)state;
    each_line(dda_is_right);
}

static void dda_integer_is_right(int x0, int y0, int x1, int y1)
{
    int count = dda_integer(lit, x0, y0, x1, y1, LINE_FRACTION_BITS);
    int64_t worst = check_line(lit, count, x0, y0, x1, y1);
    double lost = (count - 1) * ldexp(1, -LINE_FRACTION_BITS - 1);
    assert_true((double)worst <= (count - 1) * (1 + 2 * lost));
}

static void fractions_lose_no_more_than_their_last_place(void **state)
{
    (void)state;
    each_line(dda_integer_is_right);
    for (int i = 0; i < 5000; i++) {
        int bits = random_within(1, 16), dx = random_within(-800, 800),
            dy = random_within(-800, 800);
        int count = dda_integer(lit, 0, 0, dx, dy, bits);
        double longer = count - 1;
        for (int k = 0; k < count && longer > 0; k++) {
            double most = 0.5 + k * ldexp(1, -bits - 1) + 1e-9;
            assert_true(fabs(lit[k].x - k * dx / longer) <= most);
            assert_true(fabs(lit[k].y - k * dy / longer) <= most);
        }
    }
}

/* The step that the case names, done in double. */
static void the_cases_step_as_they_say(void **state)
{
    (void)state;
    static const char letters[] = "ABCDEFGHIJKLMNOP";
    char seen[17] = "";
    for (int dx = -9; dx <= 9; dx++)
        for (int dy = -9; dy <= 9; dy++) {
            if (dx == 0 && dy == 0)
                continue;
            struct line_case c = line_case_of(5, 5, 5 + dx, 5 + dy);
            struct line_dda l;
            line_dda_begin(&l, 5, 5, 5 + dx, 5 + dy);
            double m = (double)dy / dx, by = c.steep ? 1 / m : m;
            double along = c.along[2] == '+' ? 1 : -1, across = c.across[2] == '+' ? by : -by;
            assert_true(fabs((c.along[0] == 'x' ? l.dx : l.dy) - along) < 1e-6);
            assert_true(fabs((c.across[0] == 'x' ? l.dx : l.dy) - across) < 1e-6);
            assert_int_equal(c.steep, abs(dy) > abs(dx));
            seen[c.along_letter - 'A'] = c.along_letter;
            seen[c.across_letter - 'A'] = c.across_letter;
        }
    assert_string_equal(seen, letters);
}

/* ---- cut to a window ------------------------------------------------------------------------- */

/* The pixels of the whole line that lie within, one after the other; it may enter only once. */
static void cut_is_right(int x0, int y0, int x1, int y1, int x_min, int y_min, int x_max, int y_max)
{
    struct line_bresenham whole, part;
    line_bresenham_begin(&whole, x0, y0, x1, y1);
    line_bresenham_begin(&part, x0, y0, x1, y1);
    bool some = line_bresenham_cut(&part, x_min, y_min, x_max, y_max), found = false;
    while (line_bresenham_next(&whole)) {
        if (whole.x < x_min || whole.y < y_min || whole.x > x_max || whole.y > y_max)
            continue;
        found = true;
        assert_true(some);
        assert_true(line_bresenham_next(&part));
        assert_int_equal(part.k, whole.k);
        assert_int_equal(part.x, whole.x);
        assert_int_equal(part.y, whole.y);
        assert_int_equal(part.p, whole.p);
    }
    assert_int_equal(some, found);
    assert_true(!some || !line_bresenham_next(&part));
}

static void cut_lines_keep_their_pixels(void **state)
{
    (void)state;
    for (int x0 = -4; x0 <= 8; x0++)
        for (int y0 = -4; y0 <= 8; y0++)
            for (int x1 = -4; x1 <= 8; x1++)
                for (int y1 = -4; y1 <= 8; y1++)
                    cut_is_right(x0, y0, x1, y1, 0, 0, 4, 3);
    for (int i = 0; i < 20000; i++) {
        int far = i % 2 ? 200 : 3000, x = random_within(-90, 90), y = random_within(-90, 90);
        cut_is_right(random_within(-far, far), random_within(-far, far), random_within(-far, far),
                     random_within(-far, far), x, y, x + random_within(0, 90),
                     y + random_within(0, 90));
    }
}

/* At the far end of the domain, where the whole line has too many pixels to be gone through: the
 * pixel from its definition, in 64 bits. */
static void cut_lines_from_far_away(void **state)
{
    (void)state;
    for (int i = 0; i < 20000; i++) {
        int x0 = random_within(-LINE_FARTHEST, LINE_FARTHEST);
        int y0 = random_within(-LINE_FARTHEST, LINE_FARTHEST);
        int x1 = -x0 + random_within(-300, 300), y1 = -y0 + random_within(-300, 300);
        struct line_bresenham l;
        if (abs(x1) > LINE_FARTHEST || abs(y1) > LINE_FARTHEST)
            continue;
        line_bresenham_begin(&l, x0, y0, x1, y1);
        if (!line_bresenham_cut(&l, 0, 0, 200, 100))
            continue;
        int64_t dx = (int64_t)x1 - x0, dy = (int64_t)y1 - y0;
        int64_t longer = llabs(dx) > llabs(dy) ? llabs(dx) : llabs(dy);
        while (line_bresenham_next(&l)) {
            assert_true(l.x >= 0 && l.y >= 0 && l.x <= 200 && l.y <= 100);
            assert_true(2 * llabs(dx * (l.y - y0) - dy * (l.x - x0)) <= longer);
            assert_int_equal(llabs(dx) >= llabs(dy) ? llabs(l.x - x0) : llabs(l.y - y0), l.k);
        }
    }
}

/* ---- into pixels ----------------------------------------------------------------------------- */

static uint32_t memory[SIDE * SIDE + 64];

static struct canvas canvas_of(unsigned bits, int width, int height)
{
    memset(memory, 0, sizeof memory);
    return (struct canvas){.pixels = (uint8_t *)memory,
                           .pitch = canvas_pitch(width, bits),
                           .width = width,
                           .height = height,
                           .bits = bits,
                           .dots_a_row = 1};
}

static void canvas_lines_are_the_iterators(void **state)
{
    (void)state;
    static const unsigned formats[] = {1, 2, 4, 8, 16, 32};
    static uint8_t drawn[sizeof memory];
    for (int i = 0; i < 12000; i++) {
        unsigned bits = formats[i % 6];
        uint32_t colour = seed;
        int far = i % 3 ? 100 : 40, width = random_within(1, SIDE), height = random_within(1, SIDE);
        int x0 = random_within(-far, far), y0 = random_within(-far, far);
        int x1 = random_within(-far, far), y1 = i % 7 ? random_within(-far, far) : y0;
        struct canvas c = canvas_of(bits, width, height);
        canvas_line(&c, x0, y0, x1, y1, colour);
        memcpy(drawn, memory, sizeof memory);
        c = canvas_of(bits, width, height);
        int count = bresenham(lit, x0, y0, x1, y1);
        for (int k = 0; k < count; k++)
            canvas_dot(&c, lit[k].x, lit[k].y, colour);
        assert_memory_equal(drawn, memory, sizeof memory);
    }
}

static void canvas_lines_of_the_ddas(void **state)
{
    (void)state;
    static const unsigned formats[] = {1, 2, 4, 8, 16, 32};
    static uint8_t drawn[sizeof memory];
    for (int i = 0; i < 12000; i++) {
        unsigned bits = formats[i % 6];
        int low = i % 4 ? 0 : -90, high = i % 4 ? SIDE - 1 : 90;
        int x0 = random_within(low, high), y0 = random_within(low, high);
        int x1 = random_within(low, high), y1 = random_within(low, high);
        uint32_t colour = seed;
        bool whole = i / 6 % 2;
        struct canvas c = canvas_of(bits, SIDE, SIDE);
        if (whole)
            canvas_line_dda_integer(&c, x0, y0, x1, y1, colour);
        else
            canvas_line_dda(&c, x0, y0, x1, y1, colour);
        memcpy(drawn, memory, sizeof memory);
        c = canvas_of(bits, SIDE, SIDE);
        int count =
            whole ? dda_integer(lit, x0, y0, x1, y1, LINE_FRACTION_BITS) : dda(lit, x0, y0, x1, y1);
        for (int k = 0; k < count; k++)
            canvas_dot(&c, lit[k].x, lit[k].y, colour);
        assert_memory_equal(drawn, memory, sizeof memory);
    }
}

static void lines_beyond_the_domain_are_left_out(void **state)
{
    (void)state;
    struct canvas c = canvas_of(8, SIDE, SIDE);
    static const int far[] = {INT32_MIN, INT32_MAX, LINE_FARTHEST + 1, -LINE_FARTHEST - 1};
    for (int i = 0; i < 4; i++) {
        canvas_line(&c, far[i], 5, 20, 9, 1);
        canvas_line(&c, 20, 9, 5, far[i], 1);
        canvas_line(&c, far[i], 5, far[3 - i], 5, 1);
        canvas_line(&c, 5, far[i], 5, far[3 - i], 1);
    }
    for (size_t i = 0; i < sizeof memory / sizeof *memory; i++)
        assert_int_equal(memory[i], 0);
    canvas_line(&c, -LINE_FARTHEST, -LINE_FARTHEST, LINE_FARTHEST, LINE_FARTHEST, 1);
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++)
            assert_int_equal(c.pixels[y * SIDE + x], x == y);
}

/* The DDAs' domains are smaller, and each reaches its own end. */
static void dda_lines_beyond_the_domain_are_left_out(void **state)
{
    (void)state;
    struct canvas c = canvas_of(8, SIDE, SIDE);
    static const int far[] = {INT32_MIN, INT32_MAX, LINE_DDA_INTEGER_FARTHEST + 1,
                              -LINE_DDA_INTEGER_FARTHEST - 1};
    for (int i = 0; i < 4; i++) {
        int more = i < 2 ? far[i] : far[i] * (LINE_DDA_FARTHEST / LINE_DDA_INTEGER_FARTHEST);
        canvas_line_dda_integer(&c, far[i], 5, 20, 9, 1);
        canvas_line_dda_integer(&c, 20, far[i], 5, 9, 1);
        canvas_line_dda_integer(&c, 20, 9, far[i], 5, 1);
        canvas_line_dda(&c, more, 5, 20, 9, 1);
        canvas_line_dda(&c, 20, 9, 5, more, 1);
    }
    for (size_t i = 0; i < sizeof memory / sizeof *memory; i++)
        assert_int_equal(memory[i], 0);
    const int end = LINE_DDA_INTEGER_FARTHEST;
    canvas_line_dda_integer(&c, -end, -end, end, end, 1);
    canvas_line_dda_integer(&c, end, 0, -end, 0, 1);
    canvas_line_dda(&c, -LINE_DDA_FARTHEST, 9, LINE_DDA_FARTHEST, 9, 1);
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++)
            assert_int_equal(c.pixels[y * SIDE + x], x == y || y == 0 || y == 9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_dda_examples),
        cmocka_unit_test(the_bresenham_example),
        cmocka_unit_test(ties_step_the_shorter_axis),
        cmocka_unit_test(bresenham_is_nearest_and_symmetric),
        cmocka_unit_test(the_dda_drifts_no_more_than_it_must),
        cmocka_unit_test(fractions_lose_no_more_than_their_last_place),
        cmocka_unit_test(the_cases_step_as_they_say),
        cmocka_unit_test(cut_lines_keep_their_pixels),
        cmocka_unit_test(cut_lines_from_far_away),
        cmocka_unit_test(canvas_lines_are_the_iterators),
        cmocka_unit_test(canvas_lines_of_the_ddas),
        cmocka_unit_test(lines_beyond_the_domain_are_left_out),
        cmocka_unit_test(dda_lines_beyond_the_domain_are_left_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
