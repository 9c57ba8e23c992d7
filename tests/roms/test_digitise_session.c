/* A session of roms/digitise with reports that the test makes: the paper, points, lines, streams,
 * lost reports, puck buttons, typing, and the table that it prints. */
#include <math.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "roms/digitise/drawing.c"
#include "roms/digitise/fit.c"
#include "roms/digitise/rest.c"
#include "roms/digitise/session.c"
#include "roms/digitise/session_keys.c"
#include "roms/digitise/session_points.c"
#include "roms/digitise/table.c"
#include "roms/digitise/thin.c"

#include "tests/roms/curves_support.h"

enum { PERIOD = 16667 /* us */, UNIT = 100000 /* nm */ };

static struct session s;
static uint32_t serial, us;

static void begin(void)
{
    const struct tablet_facts facts = {TABLET_ELECTRICAL, UNIT, 2800, 2800, 60000};
    serial = us = 0;
    session_begin(&s, &facts);
}

static void report(int32_t x, int32_t y, int32_t z, unsigned buttons)
{
    struct report r = {.tablet = {.x = x,
                                  .y = y,
                                  .z = z,
                                  .proximity = buttons & 1 ? TABLET_TOUCH : TABLET_NEAR,
                                  .buttons = buttons,
                                  .serial = serial++},
                       .us = us += PERIOD};
    session_report(&s, &r);
}

/* A touch of several reports at one place. */
static void touch(int32_t x, int32_t y, int32_t z)
{
    report(x, y, z, 0);
    for (int i = 0; i < 6; i++)
        report(x + i % 2, y - i % 2, z, 1);
    report(x + 3, y, z, 0);
}

static void place_paper(void)
{
    touch(100, 200, 0);   /* 0 0 */
    touch(100, 2200, 0);  /* 200 0: the paper is turned by 90 degrees */
    touch(-1400, 200, 0); /* 0 150 */
}

static void reference_points_place_the_paper(void **state)
{
    (void)state;
    begin();
    assert_false(s.placed);
    place_paper();
    assert_true(s.placed && s.fit.affine);
    assert_int_equal(s.touched, 3);
    assert_near(fit_turn(&s.fit), 90, 0.05);
    assert_near(fit_scale(&s.fit), 0.1, 1e-4);
    struct point2 at = fit_place(&s.fit, (struct point2){100, 1200});
    assert_near(at.x, 100, 0.1);
    assert_near(at.y, 0, 0.1);
    session_key(&s, 'a');
    assert_true(s.placed && !s.fit.affine && s.fit.checked);
    session_key(&s, 'x');
    session_key(&s, 'x');
    assert_false(s.placed);
    session_key(&s, 'r');
    assert_int_equal(s.touched, 0);
}

static void type(const char *text)
{
    for (; *text; text++)
        session_key(&s, *text);
}

/* The last reference point is touched, and puck buttons are pressed, while coordinates are typed. */
static void typing_goes_on_while_the_stylus_works(void **state)
{
    (void)state;
    begin();
    for (int i = 0; i < FIT_POINTS_MOST - 1; i++)
        touch(100 + 200 * i, 100 + 90 * (i % 3), 0);
    type("=30 40");
    touch(2000, 2000, 0);
    assert_int_equal(s.touched, FIT_POINTS_MOST);
    float scatter[FIT_POINTS_MOST];
    memcpy(scatter, s.scatter, sizeof scatter);
    type("\r");
    assert_non_null(s.message);
    assert_memory_equal(s.scatter, scatter, sizeof scatter);
    type("x=30 40");
    report(0, 0, 0, 4);
    report(0, 0, 0, 0);
    assert_int_equal(s.touched, FIT_POINTS_MOST - 2);
    type("\r");
    assert_null(s.message);
    assert_true(s.pair[s.touched].known.x == 30 && s.pair[s.touched].known.y == 40);
}

static void coordinates_are_typed(void **state)
{
    (void)state;
    begin();
    type("=10 -20.5\r");
    assert_null(s.message);
    assert_true(s.pair[0].known.x == 10 && s.pair[0].known.y == -20.5f);
    touch(100, 100, 0);
    static const char *const wrong[] = {"",      "1",     "1 2 3",  "a b",    "nan 1",
                                        "1 inf", "1e3 2", "9999 1", "0x10 1", "1,2"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct point2 was = s.pair[1].known;
        type("=");
        type(wrong[i]);
        type("\r");
        if (!s.message)
            fail_msg("taken: %s", wrong[i]);
        assert_memory_equal(&s.pair[1].known, &was, sizeof was);
        assert_false(s.typing);
    }
    type("=300\b\b\b30 4\033");
    assert_false(s.typing);
    type("=");
    for (int i = 0; i < 200; i++)
        type("1");
    assert_int_equal(s.typed_count, SESSION_TYPED);
}

static void points_are_means_and_lines_join_them(void **state)
{
    (void)state;
    begin();
    place_paper();
    session_key(&s, 'p');
    touch(600, 700, 40);
    touch(800, 700, 40);
    assert_int_equal(s.drawing.count, 2);
    assert_true(s.drawing.point[1].start && s.drawing.point[1].alone);
    assert_int_equal(s.drawing.point[0].samples, 6);
    assert_near(s.drawing.point[0].x, 50, 0.1); /* (700 - 200) / 10 */
    assert_near(s.drawing.point[0].y, -50, 0.1);
    assert_near(s.drawing.point[0].z, 4, 1e-4);
    assert_near(s.drawing.point[0].deviation, 0.1 * sqrt(0.3 * 2), 2e-3);
    session_key(&s, 'l');
    for (int i = 0; i < 3; i++)
        touch(600 + 100 * i, 700 + 100 * (i == 1), 0);
    struct drawing_line line = drawing_last_line(&s.drawing);
    assert_int_equal(line.count, 3);
    assert_near(fabsf(drawing_measure(&s.drawing, &line).area), 100, 0.5);
    session_key(&s, 'n');
    touch(0, 0, 0);
    assert_int_equal(drawing_last_line(&s.drawing).count, 1);
    session_key(&s, 'x');
    session_key(&s, 'c');
    assert_true(drawing_last_line(&s.drawing).closed);
    touch(10, 10, 0);
    assert_int_equal(drawing_last_line(&s.drawing).count, 1); /* behind a closed line a new one */
}

/* The same with a puck's buttons: enter, new line, delete, close. */
static void buttons_of_a_puck_are_functions(void **state)
{
    (void)state;
    begin();
    session_key(&s, 'l');
    for (int i = 0; i < 4; i++)
        touch(600 + 100 * i, 700 + 100 * (i == 1), 0);
    report(0, 0, 0, 4);
    report(0, 0, 0, 4); /* held: once */
    report(0, 0, 0, 0);
    assert_int_equal(s.drawing.count, 3);
    report(0, 0, 0, 8);
    assert_true(drawing_last_line(&s.drawing).closed);
    touch(0, 0, 0);
    report(0, 0, 0, 2);
    touch(100, 0, 0);
    assert_int_equal(drawing_last_line(&s.drawing).count, 1);
}

/* ---- streams ------------------------------------------------------------------------------------- */

static void a_stream_keeps_its_spacing_and_is_thinned(void **state)
{
    (void)state;
    begin();
    session_key(&s, 's');
    report(500, 500, 0, 0);
    for (int i = 0; i <= 300; i++) /* 0.3 mm a report, round two sides */
        report(500 + 3 * (i < 150 ? i : 150), 500 + 3 * (i < 150 ? 0 : i - 150), 0, 1);
    assert_true(s.stream.count > 60 && s.stream.count <= 90);
    for (int i = 1; i < s.stream.count; i++) {
        const struct drawing_point *p = &s.stream.point[i];
        double d = hypot((double)p->x - p[-1].x, (double)p->y - p[-1].y);
        assert_true(d >= 0.999 && d < 1.4);
    }
    report(950, 950, 0, 0);
    assert_in_range(s.drawing.count, 3, 4); /* about the corner */
    assert_int_equal(s.stream.kept, s.drawing.count);
    session_key(&s, 't'); /* every 100 ms */
    for (int i = 0; i < 61; i++)
        report(500 + i, 500, 0, 1);
    assert_in_range(s.stream.count, 10, 12);
}

/* In a stream a loss is a gap; between points that are entered it is none. */
static void losses_are_gaps(void **state)
{
    (void)state;
    begin();
    session_key(&s, 's');
    for (int i = 0; i < 100; i++) {
        if (i == 40)
            serial += 5;
        report(500 + 20 * i, 500, 0, 1);
    }
    report(2500, 500, 0, 0);
    struct drawing_line line = drawing_last_line(&s.drawing);
    struct drawing_measure m = drawing_measure(&s.drawing, &line);
    assert_int_equal(s.reading.lost, 5);
    assert_int_equal(m.gaps, 1);
    assert_near(m.bridged, 2, 1e-3);
    assert_near(m.length, 98 * 2, 0.01);
    begin();
    session_key(&s, 'l');
    touch(0, 0, 0);
    serial += 9;
    touch(100, 100, 0);
    assert_int_equal(s.reading.lost, 9);
    assert_false(s.drawing.point[1].gap);
}

static void a_loss_while_the_stylus_leaves_is_told(void **state)
{
    (void)state;
    begin();
    session_key(&s, 's');
    for (int i = 0; i < 20; i++)
        report(500 + 20 * i, 500, 0, 1);
    serial += 3;
    report(1500, 500, 0, 0);
    assert_non_null(s.message);
    assert_int_equal(s.reading.lost, 3);
}

static void a_stream_that_is_full_says_so(void **state)
{
    (void)state;
    begin();
    session_key(&s, 's');
    session_key(&s, '-');
    for (int i = 0; i < SESSION_STREAM_MOST + 100; i++)
        report(i % 2 * 1000, 500 + i % 7, 0, 1);
    assert_non_null(s.message);
    assert_int_equal(s.stream.count, SESSION_STREAM_MOST);
    report(0, 0, 0, 0);
    assert_int_equal(s.drawing.count, s.stream.kept);
    report(0, 0, 0, 1);
    report(0, 0, 0, 0);
    report(1000, 0, 0, 1);
    report(1000, 0, 0, 0);
    assert_true(s.drawing.count <= DRAWING_POINTS_MOST);
}

static void rate_and_noise_are_measured(void **state)
{
    (void)state;
    begin();
    assert_true(session_rate(&s) == 0);
    for (int i = 0; i < 100; i++)
        report(1000 + i % 3 - 1, 1000, 0, 0);
    assert_near(session_rate(&s), 1e6 / PERIOD, 0.01);
    assert_near(rest_deviation(&s.reading.rest, 0), sqrt(66.0 / 99), 0.01);
}

/* ---- the table ----------------------------------------------------------------------------------- */

static char table[400000];

static void put(void *ctx, const char *line)
{
    size_t *length = ctx, more = strlen(line);
    assert_true(more > 0 && line[more - 1] == '\n' && more < TABLE_LINE);
    assert_true(*length + more < sizeof table);
    memcpy(table + *length, line, more + 1);
    *length += more;
}

static void the_table_has_every_point(void **state)
{
    (void)state;
    size_t length = 0;
    int rows = 0;
    begin();
    place_paper();
    session_key(&s, 'l');
    for (int i = 0; i < 30; i++) {
        touch((int)random_below(2000), (int)random_below(2000), (int)random_below(100));
        if (random_below(6) == 0)
            session_key(&s, 'n');
    }
    table_write(&s, put, &length);
    assert_non_null(strstr(table, "\nline,point,x_mm,y_mm,z_mm,samples,s_mm,gap\n"));
    assert_non_null(strstr(table, "# paper affine, 3 points"));
    for (const char *at = table; *at; at = strchr(at, '\n') + 1) {
        int line, point, gap;
        unsigned samples;
        float x, y, z, deviation;
        if (sscanf(at, "%d,%d,%f,%f,%f,%u,%f,%d\n", &line, &point, &x, &y, &z, &samples, &deviation,
                   &gap) != 8)
            continue;
        const struct drawing_point *p = &s.drawing.point[rows++];
        assert_near(x, p->x, 6e-4);
        assert_near(y, p->y, 6e-4);
        assert_near(z, p->z, 6e-4);
        assert_int_equal(samples, p->samples);
    }
    assert_int_equal(rows, s.drawing.count);
}

/* Whatever comes, nothing leaves its bounds. */
static void any_reports_and_keys(void **state)
{
    (void)state;
    static const char keys[] = "rapls=nxceth<>+-w 0123456789.\r\b\033zQ";
    begin();
    for (int i = 0; i < 100000; i++) {
        if (random_below(8) == 0)
            session_key(&s, keys[random_below(sizeof keys - 1)]);
        serial += random_below(50) == 0 ? random_below(1u << 31) : 0;
        int32_t far = random_below(100) == 0 ? INT32_MAX / 2 : 2800;
        report((int32_t)random_below((uint32_t)far), (int32_t)random_below(2800), 0,
               random_below(10) < 7 ? s.buttons : random_below(16));
        assert_in_range(s.drawing.count, 0, DRAWING_POINTS_MOST);
        assert_in_range(s.touched, 0, FIT_POINTS_MOST);
        assert_in_range(s.stream.count, 0, SESSION_STREAM_MOST);
        assert_in_range(s.typed_count, 0, SESSION_TYPED);
        assert_true(isfinite(s.fit.a) && isfinite(s.fit.c) && isfinite(s.fit.residual));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reference_points_place_the_paper),
        cmocka_unit_test(coordinates_are_typed),
        cmocka_unit_test(typing_goes_on_while_the_stylus_works),
        cmocka_unit_test(points_are_means_and_lines_join_them),
        cmocka_unit_test(buttons_of_a_puck_are_functions),
        cmocka_unit_test(a_stream_keeps_its_spacing_and_is_thinned),
        cmocka_unit_test(losses_are_gaps),
        cmocka_unit_test(a_loss_while_the_stylus_leaves_is_told),
        cmocka_unit_test(a_stream_that_is_full_says_so),
        cmocka_unit_test(rate_and_noise_are_measured),
        cmocka_unit_test(the_table_has_every_point),
        cmocka_unit_test(any_reports_and_keys),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
