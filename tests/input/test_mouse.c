/* What a mouse counts, against a decoder of its detectors' light, sums of the hand's way, and its crossings
 * looked for one by one. */
#include <math.h>
#include <stdlib.h>

#include "tests/input/mouse_rig.h"

#define MS CRT_PS_PER_MS
#define S  CRT_PS_PER_S

/* ---- light ------------------------------------------------------------------------------------- */

/* How far two detectors a quarter apart have gone between two looks: by which of them changed. Light at the
 * first, both, the second, none, in this order when counting up. */
static int decode(unsigned before, unsigned now)
{
    static const int order[4] = {3, 0, 2, 1}; /* by bits: none, first, second, both */
    int step = (order[now & 3] - order[before & 3] + 4) % 4;
    assert_int_not_equal(step, 2);
    return step == 3 ? -1 : step;
}

/* Looks every 20 µs, in which the hand goes less than a quarter. */
static void light_tells_what_is_counted(unsigned kind)
{
    struct mouse_rig r;
    mouse_rig_open(&r, kind);
    uint64_t row = 0, t = 0;
    long quarters[2] = {kind == MOUSE_OPTICAL ? 2 : 0, kind == MOUSE_OPTICAL ? 2 : 0};
    unsigned seen = mouse_rig_get(&r, INPUT_MOUSE_PHASES, 0);
    int per_count = kind == MOUSE_OPTICAL ? 4 : 1, changes = 0;
    for (int move = 0; move < 40; move++) {
        int32_t x = (int32_t)mouse_rig_roll(&row, -9000, 9000);
        int32_t y = (int32_t)mouse_rig_roll(&row, -9000, 9000);
        uint64_t duration = (uint64_t)mouse_rig_roll(&row, 20, 50) * MS;
        mouse_rig_move(&r, t, duration, x, y);
        uint64_t end = t + (uint64_t)mouse_rig_roll(&row, 10, 60) * MS; /* or before it is there */
        for (; t < end; t += 20 * CRT_PS_PER_US) {
            mouse_rig_run(&r, t);
            unsigned now = mouse_rig_get(&r, INPUT_MOUSE_PHASES, t);
            for (int a = 0; a < 2; a++) {
                int step = decode(seen >> 2 * a, now >> 2 * a);
                quarters[a] += step;
                changes += step != 0;
            }
            seen = now;
            assert_int_equal(mouse_rig_x(&r, t), (long)floor((double)quarters[0] / per_count));
            assert_int_equal(mouse_rig_y(&r, t), (long)floor((double)quarters[1] / per_count));
        }
    }
    assert_true(changes > 1000);
    assert_int_equal(mouse_rig_get(&r, INPUT_MOUSE_STATUS, t) & MOUSE_OVERRUN, 0);
}

static void slots_tell_what_is_counted(void **state)
{
    (void)state;
    light_tells_what_is_counted(MOUSE_MECHANICAL);
}

static void lines_tell_what_is_counted(void **state)
{
    (void)state;
    light_tells_what_is_counted(MOUSE_OPTICAL);
}

/* ---- sums -------------------------------------------------------------------------------------- */

/* Micrometres to a count. */
static double um_per_count(const struct mouse_rig *r)
{
    return (r->setup.kind == MOUSE_OPTICAL ? r->setup.line.value : r->setup.slot.value / 4) * 1000;
}

/* However the way is cut into moves, the counts are those of the whole; the hand began in the middle between
 * two. */
static void sums_do_not_drift(void **state)
{
    (void)state;
    const double pitches[] = {1, 0.05, 0.3336, 7.1236, 10};
    uint64_t row = 100;
    for (unsigned i = 0; i < 10; i++) {
        struct mouse_rig r;
        mouse_rig_setup(&r, 1 + i % 2);
        r.setup.slot.value = r.setup.line.value = pitches[i / 2];
        r.setup.fastest.value = 1e6;
        mouse_rig_power(&r);
        long sum[2] = {0, 0};
        uint64_t t = 0;
        for (int move = 0; move < 20000; move++) {
            int32_t x = (int32_t)mouse_rig_roll(&row, -999, 1010);
            int32_t y = (int32_t)mouse_rig_roll(&row, -1010, 999);
            uint64_t duration = move % 3 ? 0 : 2 * MS;
            mouse_rig_move(&r, t, duration, x, y);
            t += 3 * MS;
            sum[0] += x;
            sum[1] += y;
            double um = um_per_count(&r), eps = 1e-5;
            for (int a = 0; a < 2; a++) {
                double counts = (double)sum[a] / um + 0.5;
                int32_t got = a == 0 ? mouse_rig_x(&r, t) : mouse_rig_y(&r, t);
                assert_true(got >= floor(counts - eps) && got <= floor(counts + eps));
            }
        }
        assert_int_equal(mouse_rig_get(&r, INPUT_MOUSE_STATUS, t), MOUSE_MOVED);
        double nm = mouse_rig_get(&r, INPUT_MOUSE_UNIT, t);
        assert_true(fabs(nm - um_per_count(&r) * 1000) <= 0.51);
    }
}

/* ---- when -------------------------------------------------------------------------------------- */

/* The next count is not there a picosecond before its time, and there at it: the hand is at an edge then. */
static void counts_come_when_they_are_crossed(void **state)
{
    (void)state;
    uint64_t row = 200, t = 5;
    struct mouse_rig r;
    mouse_rig_open(&r, MOUSE_MECHANICAL);
    int counts = 0;
    double place = 0.125; /* mm, edges at multiples of 0.25 */
    for (int move = 0; move < 300; move++) {
        int32_t x = (int32_t)mouse_rig_roll(&row, -20000, 20000);
        uint64_t start = t, duration = (uint64_t)mouse_rig_roll(&row, 1e11, 3e11);
        mouse_rig_move(&r, t, duration, x, 0);
        for (uint64_t next; (next = inp_mouse_next(&r.mouse)) < start + duration; t = next) {
            assert_true(next > t || counts == 0);
            int32_t before = mouse_rig_x(&r, next - 1), at = mouse_rig_x(&r, next);
            assert_int_equal(before, mouse_rig_x(&r, t));
            assert_int_equal(at - before, x > 0 ? 1 : -1);
            assert_true(inp_mouse_event(&r.mouse, next));
            assert_true(inp_mouse_ready(&r.mouse));
            double mm = place + x / 1000.0 * ((double)(next - start) / (double)duration);
            assert_true(fabs(mm / 0.25 - round(mm / 0.25)) < 1e-6);
            mouse_rig_clear(&r, next);
            assert_false(inp_mouse_ready(&r.mouse));
            counts++;
        }
        t = start + duration;
        mouse_rig_run(&r, t);
        mouse_rig_clear(&r, t);
        place += x / 1000.0;
        assert_int_equal(mouse_rig_x(&r, t), (long)floor(place / 0.25));
        assert_true(inp_mouse_next(&r.mouse) == UINT64_MAX);
    }
    assert_true(counts > 5000);
}

/* While MOVED stands there is nothing to tell until the move ends; the counters can be read all the same. */
static void nothing_new_while_moved_stands(void **state)
{
    (void)state;
    struct mouse_rig r;
    mouse_rig_open(&r, MOUSE_OPTICAL);
    mouse_rig_move(&r, 0, 100 * MS, 10000, 0);
    uint64_t first = inp_mouse_next(&r.mouse);
    assert_true(first == 5 * MS / 2); /* a quarter of a millimetre at 0.1 m/s */
    inp_mouse_event(&r.mouse, first);
    assert_true(inp_mouse_next(&r.mouse) == 100 * MS);
    assert_int_equal(mouse_rig_x(&r, 50 * MS), 10);
    mouse_rig_clear(&r, 50 * MS);
    assert_true(inp_mouse_next(&r.mouse) == 50 * MS + 5 * MS / 2);
    assert_int_equal(mouse_rig_x(&r, 50 * MS), 10);
}

/* A hand that rests on an edge does not count; to and fro over it counts up and down. */
static void resting_on_a_line_is_quiet(void **state)
{
    (void)state;
    for (unsigned kind = MOUSE_MECHANICAL; kind <= MOUSE_OPTICAL; kind++) {
        struct mouse_rig r;
        mouse_rig_open(&r, kind);
        int32_t half = kind == MOUSE_OPTICAL ? 250 : 125;
        mouse_rig_move(&r, 0, MS, half, -half);
        mouse_rig_run(&r, 2 * MS);
        mouse_rig_clear(&r, 2 * MS);
        int32_t x = mouse_rig_x(&r, 2 * MS), y = mouse_rig_y(&r, 2 * MS);
        for (uint64_t t = 2 * MS; t < 9 * MS; t += 12345678)
            assert_true(mouse_rig_x(&r, t) == x && mouse_rig_y(&r, t) == y);
        assert_true(inp_mouse_next(&r.mouse) == UINT64_MAX);
        for (uint64_t t = 10; t < 1000; t += 10) {
            mouse_rig_move(&r, t * MS, MS, -1, 1);
            assert_true(abs(mouse_rig_x(&r, (t + 2) * MS) - x) <= 1);
            mouse_rig_move(&r, (t + 5) * MS, MS, 1, -1);
        }
        assert_true(mouse_rig_x(&r, S) == x && mouse_rig_y(&r, S) == y);
    }
}

/* ---- lifted ------------------------------------------------------------------------------------ */

/* Picked up, moved in space and put down: no count, during a move neither. */
static void lifted_it_does_not_count(void **state)
{
    (void)state;
    uint64_t row = 300;
    for (unsigned kind = MOUSE_MECHANICAL; kind <= MOUSE_OPTICAL; kind++) {
        struct mouse_rig r;
        mouse_rig_open(&r, kind);
        uint64_t t = 0;
        for (int i = 0; i < 1000; i++) {
            mouse_rig_move(&r, t, 20 * MS, (int32_t)mouse_rig_roll(&row, -15000, 15000), 333);
            t += (uint64_t)mouse_rig_roll(&row, 0, 30) * MS;
            mouse_rig_act(&r, INP_AWAY, 0, t);
            mouse_rig_clear(&r, t);
            int32_t x = mouse_rig_x(&r, t), y = mouse_rig_y(&r, t);
            unsigned phases = mouse_rig_get(&r, INPUT_MOUSE_PHASES, t);
            if (i % 2)
                mouse_rig_move(&r, t, 7 * MS, (int32_t)mouse_rig_roll(&row, -90000, 90000), -7777);
            t += 25 * MS;
            mouse_rig_run(&r, t);
            assert_int_equal(mouse_rig_get(&r, INPUT_MOUSE_PHASES, t), phases);
            mouse_rig_act(&r, INP_BACK, 0, t);
            assert_true(mouse_rig_x(&r, t) == x && mouse_rig_y(&r, t) == y);
            assert_false(inp_mouse_ready(&r.mouse));
            if (kind == MOUSE_MECHANICAL)
                assert_int_equal(mouse_rig_get(&r, INPUT_MOUSE_PHASES, t), phases);
            else
                assert_int_equal(phases, 0);
        }
    }
}

/* Lifted in the middle of a move and put down again: what it went in the air is missing, the rest counts. */
static void lifted_within_a_move(void **state)
{
    (void)state;
    for (unsigned kind = MOUSE_MECHANICAL; kind <= MOUSE_OPTICAL; kind++) {
        struct mouse_rig r;
        mouse_rig_open(&r, kind);
        int per_mm = kind == MOUSE_OPTICAL ? 2 : 4;
        mouse_rig_move(&r, 0, 100 * MS, 50000, -50000);
        mouse_rig_run(&r, 20 * MS);
        mouse_rig_act(&r, INP_AWAY, 0, 20 * MS);
        mouse_rig_act(&r, INP_AWAY, 0, 30 * MS);
        mouse_rig_run(&r, 60 * MS);
        assert_int_equal(mouse_rig_x(&r, 60 * MS), 10 * per_mm);
        mouse_rig_act(&r, INP_BACK, 0, 60 * MS);
        mouse_rig_act(&r, INP_BACK, 0, 61 * MS);
        mouse_rig_run(&r, S);
        assert_int_equal(mouse_rig_x(&r, S), 30 * per_mm);
        assert_int_equal(mouse_rig_y(&r, S), -30 * per_mm);
        assert_int_equal(mouse_rig_get(&r, INPUT_MOUSE_STATUS, S), MOUSE_MOVED);
    }
}

/* ---- the rest ---------------------------------------------------------------------------------- */

static void buttons_are_told(void **state)
{
    (void)state;
    struct mouse_rig r;
    mouse_rig_open(&r, MOUSE_MECHANICAL);
    for (unsigned code = 0; code < 3; code++) {
        mouse_rig_act(&r, INP_PRESS, code, 1);
        assert_int_equal(mouse_rig_get(&r, INPUT_MOUSE_BUTTONS, 1), 1u << code);
        assert_true(inp_mouse_ready(&r.mouse));
        mouse_rig_clear(&r, 1);
        mouse_rig_act(&r, INP_PRESS, code, 1);
        assert_false(inp_mouse_ready(&r.mouse));
        mouse_rig_act(&r, INP_RELEASE, code, 2);
        assert_int_equal(mouse_rig_get(&r, INPUT_MOUSE_BUTTONS, 2), 0);
        assert_true(inp_mouse_ready(&r.mouse));
        mouse_rig_clear(&r, 2);
    }
    mouse_rig_act(&r, INP_PRESS, 3, 3);
    mouse_rig_act(&r, INP_PRESS, 255, 3);
    assert_false(inp_mouse_ready(&r.mouse));
    mouse_rig_act(&r, INP_PRESS, 2, 4);
    inp_mouse_reset(&r.mouse, 5);
    assert_int_equal(mouse_rig_get(&r, INPUT_MOUSE_BUTTONS, 5), 4); /* the person still holds it */
    assert_false(inp_mouse_ready(&r.mouse));
}

/* Power-on in the middle of a move: from 0, with the rest of the way. */
static void counts_begin_at_power_on(void **state)
{
    (void)state;
    struct mouse_rig r;
    mouse_rig_open(&r, MOUSE_MECHANICAL);
    mouse_rig_move(&r, 0, 100 * MS, 20000, 0);
    mouse_rig_run(&r, 50 * MS);
    assert_int_equal(mouse_rig_x(&r, 50 * MS), 40);
    inp_mouse_reset(&r.mouse, 50 * MS);
    assert_int_equal(mouse_rig_x(&r, 50 * MS), 0);
    assert_int_equal(mouse_rig_get(&r, INPUT_MOUSE_STATUS, 50 * MS), 0);
    mouse_rig_run(&r, S);
    assert_int_equal(mouse_rig_x(&r, S), 40);
}

static void registers_that_are_there(void **state)
{
    (void)state;
    struct mouse_rig r;
    mouse_rig_open(&r, MOUSE_NONE);
    mouse_rig_move(&r, 0, 0, 20000, 20000);
    mouse_rig_act(&r, INP_PRESS, 0, 0);
    assert_false(inp_mouse_ready(&r.mouse));
    assert_true(inp_mouse_next(&r.mouse) == UINT64_MAX);
    uint32_t value;
    for (uint32_t offset = 0x4F0; offset < 0x540; offset++) {
        bool there = offset >= 0x500 && offset <= 0x518 && offset % 4 == 0;
        assert_int_equal(inp_mouse_read(&r.mouse, offset, 1, &value), there);
        assert_int_equal(inp_mouse_write(&r.mouse, offset, UINT32_MAX, 1), there);
        if (there)
            assert_int_equal(value, 0);
    }
    mouse_rig_open(&r, MOUSE_OPTICAL);
    assert_int_equal(mouse_rig_get(&r, INPUT_MOUSE_KIND, 0), MOUSE_OPTICAL);
    assert_int_equal(mouse_rig_get(&r, INPUT_MOUSE_UNIT, 0), 500000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slots_tell_what_is_counted),
        cmocka_unit_test(lines_tell_what_is_counted),
        cmocka_unit_test(sums_do_not_drift),
        cmocka_unit_test(counts_come_when_they_are_crossed),
        cmocka_unit_test(nothing_new_while_moved_stands),
        cmocka_unit_test(resting_on_a_line_is_quiet),
        cmocka_unit_test(lifted_it_does_not_count),
        cmocka_unit_test(lifted_within_a_move),
        cmocka_unit_test(buttons_are_told),
        cmocka_unit_test(counts_begin_at_power_on),
        cmocka_unit_test(registers_that_are_there),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
