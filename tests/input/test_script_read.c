/* Scripts: each statement's acts, written by hand; times; order. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "input/input_regs.h"
#include "input/script.h"

#define MS UINT64_C(1000000000) /* ps */

static void parse(struct inp_script *script, const char *text)
{
    struct crt_error err = {""};
    if (!inp_script_parse(script, "script", text, strlen(text), &err))
        fail_msg("%s\n%s", text, err.text);
}

/* What an act ought to be; what is not said is 0. Time and duration in ms. */
enum { AT, LASTS, DEVICE, VERB, SCREEN, SPACE, X, Y, Z, CODE, CHARACTER, FIELDS };
typedef double want_act[FIELDS];

static void check_act(const struct inp_act *act, const double *want)
{
    assert_int_equal(act->t, (uint64_t)(want[AT] * (double)MS + 0.5));
    assert_int_equal(act->duration, (uint64_t)(want[LASTS] * (double)MS + 0.5));
    assert_int_equal(act->device, (int)want[DEVICE]);
    assert_int_equal(act->verb, (int)want[VERB]);
    assert_int_equal(act->screen, (int)want[SCREEN]);
    assert_int_equal(act->space, (int)want[SPACE]);
    assert_int_equal(act->x, (int)want[X]);
    assert_int_equal(act->y, (int)want[Y]);
    assert_int_equal(act->z, (int)want[Z]);
    assert_int_equal(act->code, (int)want[CODE]);
    assert_int_equal(act->character, (int)want[CHARACTER]);
}

static void check(const char *text, const want_act *want, size_t count)
{
    struct inp_script script;
    parse(&script, text);
    if (script.count != count)
        fail_msg("%s: %zu acts instead of %zu", text, script.count, count);
    for (size_t i = 0; i < count; i++)
        check_act(&script.act[i], want[i]);
    inp_script_free(&script);
    assert_null(script.act);
}

#define CHECK(text, ...)                                                                           \
    check(text, (const want_act[]){__VA_ARGS__},                                                   \
          sizeof((const want_act[]){__VA_ARGS__}) / sizeof(want_act))

/* ---- statements -------------------------------------------------------------------------------- */

static void pens(void **state)
{
    (void)state;
    CHECK("at 0.5s pen move 512 300", {500, 0, INP_PEN, INP_MOVE, 0, INP_UNITS, 512000, 300000});
    CHECK("pen raster move -1.5 +2.25 mm in 20ms",
          {0, 20, INP_PEN, INP_MOVE, 1, INP_MM, -1500, 2250});
    CHECK("pen vector move .5 -.001", {0, 0, INP_PEN, INP_MOVE, 0, INP_UNITS, 500, -1});
    CHECK("pen down\npen up\npen away", {0, 0, INP_PEN, INP_PRESS}, {0, 0, INP_PEN, INP_RELEASE},
          {0, 0, INP_PEN, INP_AWAY});
    CHECK("pen tap", {0, 0, INP_PEN, INP_PRESS}, {80, 0, INP_PEN, INP_RELEASE});
    CHECK("pen raster tap in 0", {0, 0, INP_PEN, INP_PRESS, 1}, {0, 0, INP_PEN, INP_RELEASE, 1});
}

static void screens_that_were_named_stay(void **state)
{
    (void)state;
    CHECK("pen down\npen raster up\npen down\ntouch up\npen vector up\npen down\n"
          "touch vector up\ntouch up\npen up\n",
          {0, 0, INP_PEN, INP_PRESS, INP_VECTOR}, {0, 0, INP_PEN, INP_RELEASE, INP_RASTER},
          {0, 0, INP_PEN, INP_PRESS, INP_RASTER}, {0, 0, INP_TOUCH, INP_AWAY, INP_RASTER},
          {0, 0, INP_PEN, INP_RELEASE, INP_VECTOR}, {0, 0, INP_PEN, INP_PRESS, INP_VECTOR},
          {0, 0, INP_TOUCH, INP_AWAY, INP_VECTOR}, {0, 0, INP_TOUCH, INP_AWAY, INP_VECTOR},
          {0, 0, INP_PEN, INP_RELEASE, INP_VECTOR});
}

static void tablets(void **state)
{
    (void)state;
    CHECK("tablet near 100 80 mm", {0, 0, INP_TABLET, INP_MOVE, 0, 0, 100000, 80000, 5000});
    CHECK("tablet near 1 2 30.5 in 1s", {0, 1000, INP_TABLET, INP_MOVE, 0, 0, 1000, 2000, 30500});
    CHECK("tablet move 1 2 -3 mm in 1ms", {0, 1, INP_TABLET, INP_MOVE, 0, 0, 1000, 2000, -3000});
    CHECK("tablet press 3\ntablet release 3\ntablet away",
          {0, 0, INP_TABLET, INP_PRESS, 0, 0, 0, 0, 0, 3},
          {0, 0, INP_TABLET, INP_RELEASE, 0, 0, 0, 0, 0, 3}, {0, 0, INP_TABLET, INP_AWAY});
    /* The tip is pressed when the stylus has come down, stays so, and is released when it rises. */
    CHECK(
        "tablet touch 1 2 in 300ms\ntablet touch 3 4 mm in 10ms\ntablet near 3 4\ntablet near 5 6\n"
        "tablet touch 5 6",
        {0, 300, INP_TABLET, INP_MOVE, 0, 0, 1000, 2000, 0}, {300, 0, INP_TABLET, INP_PRESS},
        {300, 10, INP_TABLET, INP_MOVE, 0, 0, 3000, 4000, 0}, {310, 0, INP_TABLET, INP_RELEASE},
        {310, 0, INP_TABLET, INP_MOVE, 0, 0, 3000, 4000, 5000},
        {310, 0, INP_TABLET, INP_MOVE, 0, 0, 5000, 6000, 5000},
        {310, 0, INP_TABLET, INP_MOVE, 0, 0, 5000, 6000, 0}, {310, 0, INP_TABLET, INP_PRESS});
    CHECK("tablet press 0\ntablet touch 1 1\ntablet release 0\ntablet near 1 1",
          {0, 0, INP_TABLET, INP_PRESS}, {0, 0, INP_TABLET, INP_MOVE, 0, 0, 1000, 1000, 0},
          {0, 0, INP_TABLET, INP_RELEASE}, {0, 0, INP_TABLET, INP_MOVE, 0, 0, 1000, 1000, 5000});
    CHECK("tablet tap in 5ms\ntablet tap", {0, 0, INP_TABLET, INP_PRESS},
          {5, 0, INP_TABLET, INP_RELEASE}, {5, 0, INP_TABLET, INP_PRESS},
          {85, 0, INP_TABLET, INP_RELEASE});
}

static void panels(void **state)
{
    (void)state;
    CHECK("touch 320 240", {0, 0, INP_TOUCH, INP_MOVE, 1, INP_UNITS, 320000, 240000});
    CHECK("touch vector 12.5 -30 mm in 5ms", {0, 5, INP_TOUCH, INP_MOVE, 0, INP_MM, 12500, -30000});
    CHECK("touch 1 2 force 0.25 in 5ms\ntouch 1 2 mm force 3\ntouch up",
          {0, 5, INP_TOUCH, INP_MOVE, 1, INP_UNITS, 1000, 2000, 250},
          {5, 0, INP_TOUCH, INP_MOVE, 1, INP_MM, 1000, 2000, 3000}, {5, 0, INP_TOUCH, INP_AWAY, 1});
    CHECK("touch tap 1 2\ntouch vector tap 3 4 mm force 2 in 10ms",
          {0, 0, INP_TOUCH, INP_MOVE, 1, INP_UNITS, 1000, 2000}, {80, 0, INP_TOUCH, INP_AWAY, 1},
          {80, 0, INP_TOUCH, INP_MOVE, 0, INP_MM, 3000, 4000, 2000},
          {90, 0, INP_TOUCH, INP_AWAY, 0});
}

static void mice_and_knobs(void **state)
{
    (void)state;
    CHECK("mouse move 20 -3 in 0.1s\nmouse move 1 1 mm",
          {0, 100, INP_MOUSE, INP_MOVE, 0, 0, 20000, -3000},
          {100, 0, INP_MOUSE, INP_MOVE, 0, 0, 1000, 1000});
    CHECK("mouse press left\nmouse press middle\nmouse release right\nmouse lift\nmouse drop",
          {0, 0, INP_MOUSE, INP_PRESS, 0, 0, 0, 0, 0, 0},
          {0, 0, INP_MOUSE, INP_PRESS, 0, 0, 0, 0, 0, 1},
          {0, 0, INP_MOUSE, INP_RELEASE, 0, 0, 0, 0, 0, 2}, {0, 0, INP_MOUSE, INP_AWAY},
          {0, 0, INP_MOUSE, INP_BACK});
    CHECK("mouse click right\nmouse click left in 1ms",
          {0, 0, INP_MOUSE, INP_PRESS, 0, 0, 0, 0, 0, 2},
          {80, 0, INP_MOUSE, INP_RELEASE, 0, 0, 0, 0, 0, 2},
          {80, 0, INP_MOUSE, INP_PRESS, 0, 0, 0, 0, 0, 0},
          {81, 0, INP_MOUSE, INP_RELEASE, 0, 0, 0, 0, 0, 0});
    CHECK("knob vector brightness -0.25\nknob raster contrast 4\nknob raster focus 0",
          {0, 0, INP_KNOB, INP_TURN, 0, 0, -250, 0, 0, INP_BRIGHTNESS},
          {0, 0, INP_KNOB, INP_TURN, 1, 0, 4000, 0, 0, INP_CONTRAST},
          {0, 0, INP_KNOB, INP_TURN, 1, 0, 0, 0, 0, INP_FOCUS});
}

#define DOWN(at, code, character)                                                                  \
    {                                                                                              \
        at, 0, INP_KEYBOARD, INP_PRESS, 0, 0, 0, 0, 0, code, character                             \
    }
#define UP(at, code)                                                                               \
    {                                                                                              \
        at, 0, INP_KEYBOARD, INP_RELEASE, 0, 0, 0, 0, 0, code                                      \
    }

static void keys(void **state)
{
    (void)state;
    CHECK("key A\nkey 1 in 1s\nkey enter", DOWN(0, 'A', 'a'), UP(50, 'A'), DOWN(50, '1', '1'),
          UP(1050, '1'), DOWN(1050, KEYCODE_ENTER, '\r'), UP(1100, KEYCODE_ENTER));
    CHECK("key CONTROL+C\nkey shift+control+F1 in 1ms", DOWN(0, KEYCODE_CONTROL, 0),
          DOWN(0, 'C', 3), UP(50, 'C'), UP(50, KEYCODE_CONTROL), DOWN(50, KEYCODE_SHIFT, 0),
          DOWN(50, KEYCODE_CONTROL, 0), DOWN(50, KEYCODE_F1, 0), UP(51, KEYCODE_F1),
          UP(51, KEYCODE_CONTROL), UP(51, KEYCODE_SHIFT));
    CHECK("key down SHIFT\nkey Q\nkey up SHIFT\nkey Q", DOWN(0, KEYCODE_SHIFT, 0),
          DOWN(0, 'Q', 'Q'), UP(50, 'Q'), UP(50, KEYCODE_SHIFT), DOWN(50, 'Q', 'q'), UP(100, 'Q'));
    CHECK("key CAPS_LOCK in 0\nkey Q in 0\nkey 1 in 0", DOWN(0, KEYCODE_CAPS_LOCK, 0),
          UP(0, KEYCODE_CAPS_LOCK), DOWN(0, 'Q', 'Q'), UP(0, 'Q'), DOWN(0, '1', '1'), UP(0, '1'));
    CHECK("key down Q as \"@\"\nkey up Q\nkey SHIFT+7 as \"/\"\nkey down Y as none",
          DOWN(0, 'Q', '@'), UP(0, 'Q'), DOWN(0, KEYCODE_SHIFT, 0), DOWN(0, '7', '/'), UP(50, '7'),
          UP(50, KEYCODE_SHIFT), DOWN(50, 'Y', 0));
    CHECK("key down UNKNOWN as \"\\\"\"\nkey up UNKNOWN\nkey down UNKNOWN as \"\\x01\"",
          DOWN(0, 0, '"'), UP(0, 0), DOWN(0, 0, 1));
    /* The cursor keys, and the verbs that are called as they are. */
    CHECK("key down\nkey up in 1ms\nkey DOWN\nkey down down\nkey up down\nkey down UP",
          DOWN(0, KEYCODE_DOWN, 0), UP(50, KEYCODE_DOWN), DOWN(50, KEYCODE_UP, 0),
          UP(51, KEYCODE_UP), DOWN(51, KEYCODE_DOWN, 0), UP(101, KEYCODE_DOWN),
          DOWN(101, KEYCODE_DOWN, 0), UP(101, KEYCODE_DOWN), DOWN(101, KEYCODE_UP, 0));
    CHECK("key ;\nkey '\nkey \\", DOWN(0, ';', ';'), UP(50, ';'), DOWN(50, '\'', '\''),
          UP(100, '\''), DOWN(100, '\\', '\\'), UP(150, '\\'));
}

static void texts_are_typed(void **state)
{
    (void)state;
    CHECK("type \"a1\"\nkey Q in 0", DOWN(0, 'A', 'a'), UP(10, 'A'), DOWN(20, '1', '1'),
          UP(30, '1'), DOWN(40, 'Q', 'q'), UP(40, 'Q'));
    /* Shift is held over characters that need it. */
    CHECK("type \"aBC!d\" in 50ms", DOWN(0, 'A', 'a'), UP(5, 'A'), DOWN(10, KEYCODE_SHIFT, 0),
          DOWN(10, 'B', 'B'), UP(15, 'B'), DOWN(20, 'C', 'C'), UP(25, 'C'), DOWN(30, '1', '!'),
          UP(35, '1'), UP(40, KEYCODE_SHIFT), DOWN(40, 'D', 'd'), UP(45, 'D'));
    CHECK("type \"D\" in 50ms", DOWN(0, KEYCODE_SHIFT, 0), DOWN(0, 'D', 'D'), UP(25, 'D'),
          UP(25, KEYCODE_SHIFT));
    CHECK("type \"ab\" in 2s", DOWN(0, 'A', 'a'), UP(50, 'A'), DOWN(1000, 'B', 'b'),
          UP(1050, 'B')); /* no key long enough to repeat */
    CHECK("type \"\\n\\t\\b\\e\\r\" in 0", DOWN(0, KEYCODE_ENTER, '\r'), UP(0, KEYCODE_ENTER),
          DOWN(0, KEYCODE_TAB, '\t'), UP(0, KEYCODE_TAB), DOWN(0, KEYCODE_BACKSPACE, 0x7F),
          UP(0, KEYCODE_BACKSPACE), DOWN(0, KEYCODE_ESCAPE, 0x1B), UP(0, KEYCODE_ESCAPE),
          DOWN(0, KEYCODE_ENTER, '\r'), UP(0, KEYCODE_ENTER));
    CHECK("type \"\\x03\\x00\\x1F\" in 0", DOWN(0, KEYCODE_CONTROL, 0), DOWN(0, 'C', 3), UP(0, 'C'),
          DOWN(0, ' ', 0), UP(0, ' '), DOWN(0, '/', 0x1F), UP(0, '/'), UP(0, KEYCODE_CONTROL));
    CHECK("type \"\\\\ \\\"#\\x41\" in 0", DOWN(0, '\\', '\\'), UP(0, '\\'), DOWN(0, ' ', ' '),
          UP(0, ' '), DOWN(0, KEYCODE_SHIFT, 0), DOWN(0, '\'', '"'), UP(0, '\''), DOWN(0, '3', '#'),
          UP(0, '3'), DOWN(0, 'A', 'A'), UP(0, 'A'), UP(0, KEYCODE_SHIFT));
    /* With caps lock the typist holds shift for what is small. */
    CHECK("key CAPS_LOCK in 0\ntype \"aB\" in 0", DOWN(0, KEYCODE_CAPS_LOCK, 0),
          UP(0, KEYCODE_CAPS_LOCK), DOWN(0, KEYCODE_SHIFT, 0), DOWN(0, 'A', 'a'), UP(0, 'A'),
          UP(0, KEYCODE_SHIFT), DOWN(0, 'B', 'B'), UP(0, 'B'));
    /* A shift that is held is not touched. */
    CHECK("key down SHIFT\ntype \"aB\" in 0", DOWN(0, KEYCODE_SHIFT, 0), DOWN(0, 'A', 'a'),
          UP(0, 'A'), DOWN(0, 'B', 'B'), UP(0, 'B'));
    CHECK("key down SHIFT\nkey up SHIFT\ntype \"B\" in 0", DOWN(0, KEYCODE_SHIFT, 0),
          UP(0, KEYCODE_SHIFT), DOWN(0, KEYCODE_SHIFT, 0), DOWN(0, 'B', 'B'), UP(0, 'B'),
          UP(0, KEYCODE_SHIFT));
    CHECK("key down CONTROL\ntype \"\\x03\" in 0", DOWN(0, KEYCODE_CONTROL, 0), DOWN(0, 'C', 3),
          UP(0, 'C'));
    struct inp_script script;
    parse(&script, "type \"\"\nwait 1ms\ntype \"\" in 1ms");
    assert_int_equal(script.count, 0);
    assert_int_equal(script.end, 2 * MS);
    inp_script_free(&script);
}

/* A text that does not divide evenly: no character is more than a picosecond off, none is late. */
static void steps_are_even(void **state)
{
    (void)state;
    struct inp_script script;
    parse(&script, "type \"aaaaaaa\" in 1000003ps");
    assert_int_equal(script.count, 14);
    for (uint64_t i = 0; i < 7; i++) {
        uint64_t begin = i * 1000003 / 7, next = (i + 1) * 1000003 / 7;
        assert_int_equal(script.act[2 * i].t, begin);
        assert_int_equal(script.act[2 * i + 1].t, begin + (next - begin) / 2);
    }
    assert_int_equal(script.end, 1000003);
    inp_script_free(&script);
}

/* ---- times ------------------------------------------------------------------------------------- */

static void statements_begin_when_they_say(void **state)
{
    (void)state;
    CHECK(
        "at 1s pen move 1 1 in 200ms\n+20ms pen down\npen tap\nwait 1s\nat 2.5s pen up\n+0 pen up\n"
        "at 2500000us pen away",
        {1000, 200, INP_PEN, INP_MOVE, 0, INP_UNITS, 1000, 1000}, {1220, 0, INP_PEN, INP_PRESS},
        {1220, 0, INP_PEN, INP_PRESS}, {1300, 0, INP_PEN, INP_RELEASE},
        {2500, 0, INP_PEN, INP_RELEASE}, {2500, 0, INP_PEN, INP_RELEASE},
        {2500, 0, INP_PEN, INP_AWAY});
    CHECK("+1s wait 1s\n+1s pen up", {3000, 0, INP_PEN, INP_RELEASE});
}

/* What takes long goes on while later statements begin. */
static void statements_overlap(void **state)
{
    (void)state;
    CHECK("at 1s type \"ab\" in 2s\nat 1s pen move 5 5 in 1s\nat 1.5s pen down\npen up",
          DOWN(1000, 'A', 'a'), {1000, 1000, INP_PEN, INP_MOVE, 0, INP_UNITS, 5000, 5000},
          UP(1050, 'A'), {1500, 0, INP_PEN, INP_PRESS}, {1500, 0, INP_PEN, INP_RELEASE},
          DOWN(2000, 'B', 'b'), UP(2050, 'B'));
    /* What a key makes is decided by what is held then, wherever the script says it. */
    CHECK("at 0 key SHIFT in 1s\nat 500ms key A in 0\nat 2s key A in 0", DOWN(0, KEYCODE_SHIFT, 0),
          DOWN(500, 'A', 'A'), UP(500, 'A'), UP(1000, KEYCODE_SHIFT), DOWN(2000, 'A', 'a'),
          UP(2000, 'A'));
}

static void exact_time(const char *text, uint64_t ps)
{
    char line[128];
    struct inp_script script;
    snprintf(line, sizeof line, "at %s pen up", text);
    parse(&script, line);
    assert_int_equal(script.count, 1);
    assert_int_equal(script.act[0].t, ps);
    inp_script_free(&script);
}

static void times_are_exact(void **state)
{
    (void)state;
    exact_time("0", 0);
    exact_time("0.0", 0);
    exact_time("0s", 0);
    exact_time("1ps", 1);
    exact_time("1.9ps", 1);
    exact_time("0.001ns", 1);
    exact_time("0.0019ns", 1);
    exact_time("5ns", 5000);
    exact_time("3us", 3000000);
    exact_time("3.000001us", 3000001);
    exact_time("20ms", 20 * MS);
    exact_time("0.1s", 100 * MS);
    exact_time("0.000000000001s", 1);
    exact_time("0.0000000000019999999999999999999999999s", 1);
    exact_time("000000000000000000000000000000000001s", 1000 * MS);
    exact_time("1.s", 1000 * MS);
    exact_time(".5s", 500 * MS);
    exact_time("9223372.036854775807s", (UINT64_C(1) << 63) - 1);
    exact_time("9223372036854775807ps", (UINT64_C(1) << 63) - 1);
}

/* ---- lines ------------------------------------------------------------------------------------- */

static void lines_may_end_in_any_way(void **state)
{
    (void)state;
    CHECK("pen up\r\npen down\r\n", {0, 0, INP_PEN, INP_RELEASE}, {0, 0, INP_PEN, INP_PRESS});
    CHECK("\n\r\n \t \n#\n# \xC3\xA9 comment \x01\n\tpen\tup\t # pen down\npen down#x\r",
          {0, 0, INP_PEN, INP_RELEASE}, {0, 0, INP_PEN, INP_PRESS});
    CHECK("type\"a\"in 0", DOWN(0, 'A', 'a'), UP(0, 'A'));
    CHECK("type \"\t\" in 0", DOWN(0, KEYCODE_TAB, '\t'), UP(0, KEYCODE_TAB));
    struct inp_script script;
    struct crt_error err;
    assert_true(inp_script_parse(&script, "script", NULL, 0, &err));
    assert_int_equal(script.count, 0);
    assert_int_equal(script.end, 0);
    inp_script_free(&script);
    /* Only so many bytes as were given are read. */
    assert_true(inp_script_parse(&script, "script", "pen up in", 6, &err));
    assert_int_equal(script.count, 1);
    inp_script_free(&script);
}

/* Many overlapping statements: sorted, and equal times in the order of the script. */
static void many_overlapping_statements_are_in_order(void **state)
{
    (void)state;
    enum { STATEMENTS = 3000 };
    char *text = malloc(STATEMENTS * 80);
    size_t length = 0;
    assert_non_null(text);
    for (int i = 0; i < STATEMENTS; i++)
        length +=
            (size_t)sprintf(text + length, "at %dus tablet tap in %dus\nat %dus mouse move %d 0\n",
                            i, (i * 7919) % 1000, i, i);
    struct inp_script script;
    struct crt_error err;
    assert_true(inp_script_parse(&script, "script", text, length, &err));
    assert_int_equal(script.count, 3 * STATEMENTS);
    int moves = 0;
    for (size_t i = 0; i < script.count; i++) {
        assert_true(i == 0 || script.act[i - 1].t <= script.act[i].t);
        if (script.act[i].device == INP_MOUSE) {
            assert_int_equal(script.act[i].x, 1000 * moves);
            assert_int_equal(script.act[i].t, (uint64_t)moves * 1000000);
            moves++;
        }
    }
    assert_int_equal(moves, STATEMENTS);
    inp_script_free(&script);
    free(text);
}

/* The sketch at the top of script.h. */
static void the_example_reads(void **state)
{
    (void)state;
    struct inp_script script;
    parse(&script, "at 0.5s pen move 512 300              # head units of the vector head\n"
                   "pen down                              # right after what comes before it\n"
                   "pen raster move 320 240 in 200ms      # within 200 ms\n"
                   "+20ms pen away\n"
                   "tablet near 100 80                    # stylus 5 mm above the surface\n"
                   "tablet touch 120 80 in 0.3s           # moved down to the surface\n"
                   "touch raster 12.5 -30 mm\n"
                   "touch up\n"
                   "mouse move 20 -3 in 0.1s\n"
                   "mouse click left\n"
                   "key CONTROL+C\n"
                   "type \"line dda 0 0 4 5\\n\" in 0.5s\n"
                   "knob vector brightness 0.2\n");
    assert_int_equal(script.count, 4 + 3 + 2 + 3 + 4 + 2 * 17 + 1);
    assert_int_equal(script.end, (500 + 200 + 20 + 300 + 100 + 80 + 50 + 500) * MS);
    inp_script_free(&script);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pens),
        cmocka_unit_test(screens_that_were_named_stay),
        cmocka_unit_test(tablets),
        cmocka_unit_test(panels),
        cmocka_unit_test(mice_and_knobs),
        cmocka_unit_test(keys),
        cmocka_unit_test(texts_are_typed),
        cmocka_unit_test(steps_are_even),
        cmocka_unit_test(statements_begin_when_they_say),
        cmocka_unit_test(statements_overlap),
        cmocka_unit_test(times_are_exact),
        cmocka_unit_test(lines_may_end_in_any_way),
        cmocka_unit_test(many_overlapping_statements_are_in_order),
        cmocka_unit_test(the_example_reads),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
