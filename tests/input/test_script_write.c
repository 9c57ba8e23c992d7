/* Acts written as statements: how they look, and that they read back to the same acts. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <string.h>

#include "input/keyboard.h"
#include "input/script.h"

#define LATEST (UINT64_C(1) << 63)

static void written_as(struct inp_act act, const char *expected)
{
    char text[INP_STATEMENT_MOST];
    memset(text, 'x', sizeof text);
    size_t length = inp_script_write(&act, text);
    assert_string_equal(text, expected);
    assert_int_equal(length, strlen(expected));
}

/* As it is read, with its time, duration and place set. */
static struct inp_act act_of(unsigned device, unsigned verb)
{
    return (struct inp_act){
        .t = 1500000000, .device = (uint8_t)device, .verb = (uint8_t)verb, .screen = INP_RASTER};
}

static struct inp_act move_of(unsigned device, int32_t x, int32_t y, int32_t z, uint64_t duration)
{
    struct inp_act act = act_of(device, INP_MOVE);
    act.x = x;
    act.y = y;
    act.z = z;
    act.duration = duration;
    return act;
}

static struct inp_act with_code(unsigned device, unsigned verb, uint8_t code, uint8_t character)
{
    struct inp_act act = act_of(device, verb);
    act.code = code;
    act.character = character;
    act.screen = 0;
    return act;
}

static void acts_look_like_statements(void **state)
{
    (void)state;
    written_as(move_of(INP_PEN, 12500, -1, 0, 7),
               "at 1.5ms pen raster move 12.5 -0.001 mm in 7ps\n");
    struct inp_act units = move_of(INP_PEN, 0, 1000000, 0, 0);
    units.space = INP_UNITS;
    units.screen = INP_VECTOR;
    written_as(units, "at 1.5ms pen vector move 0 1000\n");
    written_as(act_of(INP_PEN, INP_PRESS), "at 1.5ms pen raster down\n");
    written_as(act_of(INP_PEN, INP_RELEASE), "at 1.5ms pen raster up\n");
    written_as(act_of(INP_PEN, INP_AWAY), "at 1.5ms pen raster away\n");
    written_as(move_of(INP_TABLET, 1, 10, 100, 2000000000),
               "at 1.5ms tablet move 0.001 0.01 0.1 in 2ms\n");
    written_as(with_code(INP_TABLET, INP_PRESS, 3, 0), "at 1.5ms tablet press 3\n");
    written_as(with_code(INP_TABLET, INP_RELEASE, 0, 0), "at 1.5ms tablet release 0\n");
    written_as(act_of(INP_TABLET, INP_AWAY), "at 1.5ms tablet away\n");
    written_as(move_of(INP_TOUCH, 1000, 2000, 250, 1000),
               "at 1.5ms touch raster 1 2 mm force 0.25 in 1ns\n");
    written_as(act_of(INP_TOUCH, INP_AWAY), "at 1.5ms touch raster up\n");
    written_as(move_of(INP_MOUSE, -5000, 0, 0, 0), "at 1.5ms mouse move -5 0\n");
    written_as(with_code(INP_MOUSE, INP_PRESS, 2, 0), "at 1.5ms mouse press right\n");
    written_as(with_code(INP_MOUSE, INP_RELEASE, 1, 0), "at 1.5ms mouse release middle\n");
    written_as(act_of(INP_MOUSE, INP_AWAY), "at 1.5ms mouse lift\n");
    written_as(act_of(INP_MOUSE, INP_BACK), "at 1.5ms mouse drop\n");
    struct inp_act knob = act_of(INP_KNOB, INP_TURN);
    knob.x = -125;
    written_as(knob, "at 1.5ms knob raster brightness -0.125\n");
    written_as(with_code(INP_KEYBOARD, INP_PRESS, 'Q', 'q'), "at 1.5ms key down Q as \"q\"\n");
    written_as(with_code(INP_KEYBOARD, INP_PRESS, 'Q', 0), "at 1.5ms key down Q as none\n");
    written_as(with_code(INP_KEYBOARD, INP_PRESS, '\'', '"'), "at 1.5ms key down ' as \"\\\"\"\n");
    written_as(with_code(INP_KEYBOARD, INP_PRESS, '\\', '\\'),
               "at 1.5ms key down \\ as \"\\\\\"\n");
    written_as(with_code(INP_KEYBOARD, INP_PRESS, 'C', 3), "at 1.5ms key down C as \"\\x03\"\n");
    written_as(with_code(INP_KEYBOARD, INP_PRESS, KEYCODE_ENTER, '\r'),
               "at 1.5ms key down ENTER\n");
    written_as(with_code(INP_KEYBOARD, INP_PRESS, KEYCODE_ENTER, 0),
               "at 1.5ms key down ENTER as none\n");
    written_as(with_code(INP_KEYBOARD, INP_PRESS, KEYCODE_SHIFT, 0), "at 1.5ms key down SHIFT\n");
    written_as(with_code(INP_KEYBOARD, INP_PRESS, KEYCODE_PAD_0, '0'), "at 1.5ms key down PAD_0\n");
    written_as(with_code(INP_KEYBOARD, INP_PRESS, 0, 'x'), "at 1.5ms key down UNKNOWN as \"x\"\n");
    written_as(with_code(INP_KEYBOARD, INP_RELEASE, KEYCODE_DOWN, 0), "at 1.5ms key up DOWN\n");
}

static void times_are_as_short_as_can_be(void **state)
{
    (void)state;
    static const struct {
        uint64_t ps;
        const char *text;
    } times[] = {{0, "at 0s pen vector up\n"},
                 {1, "at 1ps pen vector up\n"},
                 {1000, "at 1ns pen vector up\n"},
                 {1001, "at 1001ps pen vector up\n"},
                 {1100, "at 1.1ns pen vector up\n"},
                 {UINT64_C(100000000000), "at 0.1s pen vector up\n"},
                 {UINT64_C(10000000000), "at 10ms pen vector up\n"},
                 {UINT64_C(1234567000000), "at 1.234567s pen vector up\n"},
                 {UINT64_C(16683333333), "at 16683333333ps pen vector up\n"},
                 {UINT64_C(3600000000000000), "at 3600s pen vector up\n"},
                 {LATEST - 1, "at 9223372.036854775807s pen vector up\n"}};
    for (size_t i = 0; i < sizeof times / sizeof *times; i++) {
        struct inp_act act = {.t = times[i].ps, .device = INP_PEN, .verb = INP_RELEASE};
        written_as(act, times[i].text);
    }
}

static void what_no_script_can_say_is_not_written(void **state)
{
    (void)state;
    written_as(act_of(INP_DEVICES, INP_MOVE), "");
    written_as(act_of(255, INP_MOVE), "");
    struct inp_act act = act_of(INP_PEN, INP_PRESS);
    act.screen = INP_SCREENS;
    written_as(act, "");
    act = move_of(INP_PEN, 0, 0, 0, 0);
    act.space = 2;
    written_as(act, "");
    written_as(move_of(INP_PEN, INP_FURTHEST + 1, 0, 0, 0), "");
    written_as(move_of(INP_PEN, 0, INT32_MIN, 0, 0), "");
    written_as(move_of(INP_TABLET, 0, 0, -INP_FURTHEST - 1, 0), "");
    written_as(move_of(INP_TOUCH, 0, 0, -1, 0), "");
    written_as(move_of(INP_TOUCH, 0, 0, INT32_MAX, 0), "");
    written_as(move_of(INP_PEN, 0, 0, 0, LATEST - 1500000000), "");
    act = act_of(INP_PEN, INP_PRESS);
    act.t = LATEST;
    written_as(act, "");
    written_as(with_code(INP_TABLET, INP_PRESS, 4, 0), "");
    written_as(with_code(INP_MOUSE, INP_PRESS, 3, 0), "");
    written_as(with_code(INP_MOUSE, INP_RELEASE, 255, 0), "");
    written_as(with_code(INP_KNOB, INP_TURN, INP_KNOBS, 0), "");
    written_as(with_code(INP_KEYBOARD, INP_PRESS, 1, 0), "");
    written_as(with_code(INP_KEYBOARD, INP_PRESS, 'A', 0x80), "");
    act = act_of(INP_KNOB, INP_TURN);
    act.x = 1001;
    written_as(act, "");
    /* Verbs that a device has not. */
    static const unsigned verbs[INP_DEVICES] = {
        [INP_PEN] = 0x1B,      [INP_TABLET] = 0x1B, [INP_TOUCH] = 0x03,
        [INP_KEYBOARD] = 0x18, [INP_MOUSE] = 0x1F,  [INP_KNOB] = 0x20};
    for (unsigned device = 0; device < INP_DEVICES; device++)
        for (unsigned verb = 0; verb < INP_VERBS + 2; verb++) {
            char text[INP_STATEMENT_MOST];
            struct inp_act one = with_code(device, verb, 0, 0);
            assert_int_equal(inp_script_write(&one, text) > 0, verbs[device] >> verb & 1);
        }
}

/* ---- there and back ---------------------------------------------------------------------------- */

/* xorshift64*: the same numbers everywhere. */
static uint64_t random_bits(uint64_t *seed)
{
    *seed ^= *seed >> 12;
    *seed ^= *seed << 25;
    *seed ^= *seed >> 27;
    return *seed * UINT64_C(2685821657736338717);
}

static uint64_t below(uint64_t *seed, uint64_t most)
{
    return random_bits(seed) % most;
}

/* Of all sizes, often round. */
static uint64_t random_time(uint64_t *seed, uint64_t most)
{
    uint64_t t = random_bits(seed) >> (1 + below(seed, 63)), round = 1;
    for (uint64_t zeros = below(seed, 16); zeros > 0; zeros--)
        round *= 10;
    t -= t % round;
    return t % most;
}

static int32_t random_place(uint64_t *seed)
{
    int32_t place = (int32_t)below(seed, 2 * INP_FURTHEST + 1) - INP_FURTHEST;
    static const int32_t steps[] = {1, 10, 100, 1000, 1000000};
    int32_t step = steps[below(seed, 5)];
    return below(seed, 20) == 0 ? (int32_t)(below(seed, 3) - 1) * INP_FURTHEST
                                : place / step * step;
}

/* Every key that has a name, and the one that is not known. */
static uint8_t random_key(uint64_t *seed)
{
    for (;;) {
        uint8_t code = (uint8_t)random_bits(seed);
        if (code == 0 || inp_key_name(code))
            return code;
    }
}

static void random_key_act(struct inp_act *act, uint64_t *seed)
{
    act->verb = below(seed, 3) ? INP_PRESS : INP_RELEASE;
    act->code = random_key(seed);
    if (act->verb == INP_PRESS)
        act->character = below(seed, 2) ? (uint8_t)below(seed, 0x80)
                                        : inp_key_us(act->code, (unsigned)below(seed, 16));
}

static void random_place_of(struct inp_act *act, uint64_t *seed)
{
    bool on_screen = act->device == INP_PEN || act->device == INP_TOUCH;
    act->x = random_place(seed);
    act->y = random_place(seed);
    act->duration = below(seed, 2) ? random_time(seed, LATEST - act->t) : 0;
    if (on_screen)
        act->space = (uint8_t)below(seed, 2);
    if (act->device == INP_TABLET)
        act->z = random_place(seed);
    if (act->device == INP_TOUCH)
        act->z = (int32_t)below(seed, below(seed, 2) ? 1 : 10000001);
}

/* Any that can be. */
static struct inp_act random_act(uint64_t *seed)
{
    static const uint8_t pen[] = {INP_MOVE, INP_MOVE, INP_AWAY, INP_PRESS, INP_RELEASE};
    static const uint8_t touch[] = {INP_MOVE, INP_AWAY};
    static const uint8_t mouse[] = {INP_MOVE, INP_AWAY, INP_BACK, INP_PRESS, INP_RELEASE};
    static const int32_t low[] = {-1000, 0, 0}, high[] = {1000, 4000, 4000};
    struct inp_act act = {.t = random_time(seed, LATEST)};
    act.device = (uint8_t)below(seed, INP_DEVICES);
    if (act.device == INP_PEN || act.device == INP_TOUCH || act.device == INP_KNOB)
        act.screen = (uint8_t)below(seed, 2);
    if (act.device == INP_PEN || act.device == INP_TABLET)
        act.verb = pen[below(seed, 5)];
    if (act.device == INP_TOUCH)
        act.verb = touch[below(seed, 2)];
    if (act.device == INP_MOUSE)
        act.verb = mouse[below(seed, 5)];
    if (act.device == INP_KEYBOARD)
        random_key_act(&act, seed);
    else if (act.verb == INP_MOVE)
        random_place_of(&act, seed);
    else if (act.verb == INP_PRESS || act.verb == INP_RELEASE)
        act.code = (uint8_t)below(seed, act.device == INP_TABLET  ? 4
                                        : act.device == INP_MOUSE ? 3
                                                                  : 1);
    if (act.device == INP_KNOB) {
        act = (struct inp_act){.t = act.t, .device = INP_KNOB, .screen = act.screen};
        act.verb = INP_TURN;
        act.code = (uint8_t)below(seed, INP_KNOBS);
        act.x =
            low[act.code] + (int32_t)below(seed, (uint64_t)(high[act.code] - low[act.code] + 1));
    }
    return act;
}

static void assert_same(const struct inp_act *a, const struct inp_act *b)
{
    assert_true(a->t == b->t && a->duration == b->duration);
    assert_true(a->device == b->device && a->verb == b->verb);
    assert_true(a->screen == b->screen && a->space == b->space);
    assert_true(a->x == b->x && a->y == b->y && a->z == b->z);
    assert_true(a->code == b->code && a->character == b->character);
}

static void every_act_reads_back(void **state)
{
    (void)state;
    uint64_t seed = 4711;
    for (int run = 0; run < 60000; run++) {
        struct inp_act act = random_act(&seed);
        char text[INP_STATEMENT_MOST];
        size_t length = inp_script_write(&act, text);
        assert_in_range(length, 10, INP_STATEMENT_MOST - 1);
        assert_int_equal(strlen(text), length);
        assert_ptr_equal(strchr(text, '\n'), text + length - 1);
        struct inp_script script;
        struct crt_error err;
        if (!inp_script_parse(&script, "s", text, length, &err))
            fail_msg("%s%s", text, err.text);
        assert_int_equal(script.count, 1);
        assert_same(&script.act[0], &act);
        assert_true(script.end == act.t + act.duration);
        inp_script_free(&script);
    }
}

static int by_time(const void *a, const void *b)
{
    const struct inp_act *x = a, *y = b;
    return (x->t > y->t) - (x->t < y->t);
}

/* A whole recording, whose acts depend on nothing that comes before them. */
static void recordings_read_back(void **state)
{
    (void)state;
    enum { ACTS = 2000 };
    static struct inp_act act[ACTS];
    static char text[ACTS * INP_STATEMENT_MOST];
    uint64_t seed = 31;
    size_t length = 0;
    for (int i = 0; i < ACTS; i++) {
        act[i] = random_act(&seed);
        act[i].t %= UINT64_C(1000000000000000);
        act[i].duration %= UINT64_C(1000000000000000);
    }
    qsort(act, ACTS, sizeof *act, by_time);
    for (int i = 0; i < ACTS; i++)
        length += inp_script_write(&act[i], text + length);
    struct inp_script script;
    struct crt_error err;
    if (!inp_script_parse(&script, "s", text, length, &err))
        fail_msg("%s", err.text);
    assert_int_equal(script.count, ACTS);
    for (int i = 0; i < ACTS; i++)
        assert_same(&script.act[i], &act[i]);
    inp_script_free(&script);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(acts_look_like_statements),
        cmocka_unit_test(times_are_as_short_as_can_be),
        cmocka_unit_test(what_no_script_can_say_is_not_written),
        cmocka_unit_test(every_act_reads_back),
        cmocka_unit_test(recordings_read_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
