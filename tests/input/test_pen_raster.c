/* A light pen before a colour tube: which fields it sees, where it says the beam is, and what it leaves
 * alone. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <string.h>

#include "tests/input/pen_slow.h"

#define US    UINT64_C(1000000)
#define DOTS  1024
#define LINES 768
#define CLOCK 65.0                 /* MHz */
#define LINE  (1344 / CLOCK * 1e6) /* ps */

static struct inp_pen_setup setup;
static struct inp_pen pen;
static uint8_t dots[3][DOTS];

static void make(void)
{
    const struct crt_tube_row *row = crt_tube_row_find("COLOR17");
    struct inp_pen_desc desc = {&setup, row, crt_phosphor_find(row->phosphor), {0, 1, 0}, 1};
    inp_pen_init(&pen, &desc);
    inp_hand_move(&pen.hand, (struct inp_place){0, 0, 0}, 0, 0);
}

static void fill(uint8_t red, uint8_t green, uint8_t blue)
{
    memset(dots[0], red, DOTS);
    memset(dots[1], green, DOTS);
    memset(dots[2], blue, DOTS);
}

static struct crt_scan_line line_of(int row)
{
    double h = pen.desc.row->height.value;
    struct crt_scan_line line = {.t0 = US + (uint64_t)(row * LINE), .dots = DOTS, .guns = 3};
    line.t1 = line.t0 + (uint64_t)(DOTS / CLOCK * 1e6);
    line.x1 = (float)(pen.desc.row->width.value / 2);
    line.x0 = -line.x1;
    line.y0 = line.y1 = (float)(h / 2 - h * (row + 0.5) / LINES);
    for (int gun = 0; gun < 3; gun++)
        line.drive[gun] = dots[gun];
    return line;
}

/* Firings of a field; the dots and rows at which the pulses come. */
static int field(double dot[64], int row[64])
{
    int count = 0;
    inp_pen_reset(&pen, 0);
    for (int i = 0; i < LINES; i++) {
        struct crt_scan_line line = line_of(i);
        inp_pen_line(&pen, &line);
        for (uint64_t t = inp_pen_next(&pen); t < line.t0 + (uint64_t)LINE;
             t = inp_pen_next(&pen)) {
            if (!inp_pen_event(&pen, t) || count >= 64)
                continue;
            dot[count] = (double)(t - line.t0) * 1e-6 * CLOCK;
            row[count++] = i;
        }
    }
    return count;
}

/* White, each primary, dark blue; the beam is late by the delay, 19.5 dots, and some. */
static void sees_all_fields_but_black(void **state)
{
    static const uint8_t fields[][3] = {
        {255, 255, 255}, {255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {0, 0, 64}};
    double dot[64];
    int row[64];
    (void)state;
    setup = slow_setup();
    make();
    for (unsigned i = 0; i < sizeof fields / sizeof fields[0]; i++) {
        fill(fields[i][0], fields[i][1], fields[i][2]);
        int count = field(dot, row);
        assert_true(count > 0 && count < 20);
        for (int n = 0; n < count; n++) {
            assert_true(fabs((row[n] + 0.5 - LINES / 2) * 240 / LINES) < 1.5 + 5 * 0.25);
            assert_true(n == 0 || row[n] > row[n - 1]); /* once a line */
            assert_true(fabs(dot[n] - DOTS / 2 - 0.3 * CLOCK) < 12);
        }
    }
    fill(0, 0, 0);
    assert_int_equal(field(dot, row), 0);
    inp_pen_set_knobs(&pen, (struct crt_knobs){0.3, 1, 0}); /* black glows */
    assert_true(field(dot, row) > 0);
}

/* Of a picture with one bright spot only the spot counts. */
static void sees_what_is_under_it_only(void **state)
{
    double dot[64];
    int row[64];
    (void)state;
    setup = slow_setup();
    make();
    for (int at = -40; at <= 40; at++) {
        fill(0, 0, 0);
        memset(dots[1] + DOTS / 2 + at, 255, 2);
        int count = field(dot, row);
        double mm = (at + 1) * 320.0 / DOTS;
        if (fabs(mm) < 1.3)
            assert_true(count > 0);
        if (fabs(mm) > 1.5 + 5 * 0.23 + 0.3)
            assert_int_equal(count, 0);
    }
}

static void lines_elsewhere_change_nothing(void **state)
{
    static struct inp_pen before;
    int left = 0;
    (void)state;
    setup = slow_setup();
    make();
    fill(255, 255, 255);
    memcpy(&before, &pen, sizeof pen);
    for (int i = 0; i < LINES; i++) {
        struct crt_scan_line line = line_of(i);
        if (fabs((double)line.y0) < 1.5 + 5 * 0.25 + 0.4)
            continue;
        inp_pen_line(&pen, &line);
        left++;
    }
    assert_memory_equal(&before, &pen, sizeof pen);
    assert_true(left > 740);
}

/* Where the pen is at the left or right edge of the picture, lines begin or end within the aperture. */
static void works_at_the_edges(void **state)
{
    double dot[64];
    int row[64];
    (void)state;
    setup = slow_setup();
    make();
    fill(255, 255, 255);
    for (int side = -1; side <= 1; side += 2) {
        pen.hand.there = false;
        inp_hand_move(&pen.hand, (struct inp_place){side * 160, 0, 0}, 0, 0);
        assert_true(inp_pen_looks(&pen));
        int count = field(dot, row);
        double expected = (side < 0 ? 0 : DOTS) + 0.3 * CLOCK;
        assert_true(count > 5);
        for (int n = 1; n < count; n++) /* the first line hardly touches it */
            assert_true(fabs(dot[n] - expected) < 12);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sees_all_fields_but_black),
        cmocka_unit_test(sees_what_is_under_it_only),
        cmocka_unit_test(lines_elsewhere_change_nothing),
        cmocka_unit_test(works_at_the_edges),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
