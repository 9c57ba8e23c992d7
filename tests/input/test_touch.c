/* When a panel reports and what its registers say: times of scans, reports taken and lost, switched on and off,
 * absent, saved and loaded. */
#include <string.h>

#include "tests/input/touch_rig.h"

#define MS CRT_PS_PER_MS
#define S  CRT_PS_PER_S

static void take(struct touch_rig *r, uint64_t t)
{
    touch_rig_set(r, INPUT_TOUCH_STATUS, TOUCH_REPORT | TOUCH_LOST, t);
}

static uint32_t status(const struct touch_rig *r)
{
    return touch_rig_get(r, INPUT_TOUCH_STATUS);
}

/* A panel without noise, switched on at 0: scans of 25 ms. */
static void open_still(struct touch_rig *r, unsigned kind)
{
    touch_rig_open(r, kind, 280, 210);
    r->setup.noise.value = 0;
    touch_rig_set(r, INPUT_TOUCH_CONTROL, TOUCH_ON, 0);
}

/* ---- times ------------------------------------------------------------------------------------- */

/* Scan n ends n / rate after it was switched on, to the picosecond, however many there were. */
static void scans_are_exact_in_time(void **state)
{
    (void)state;
    uint64_t row = 0;
    for (unsigned i = 0; i < 300; i++) {
        struct touch_rig r;
        touch_rig_open(&r, 1 + i % 3, 280, 210);
        uint64_t millihertz = (uint64_t)touch_rig_roll(&row, 10000, 200000.999);
        r.setup.rate.value = (double)millihertz / 1000;
        assert_true(inp_touch_next(&r.touch) == UINT64_MAX);
        uint64_t on = (uint64_t)touch_rig_roll(&row, 0, 1e16);
        touch_rig_set(&r, INPUT_TOUCH_CONTROL, TOUCH_ON, on);
        for (uint64_t n = 1; n < 500; n++) {
            uint64_t end = on + n * UINT64_C(1000000000000000) / millihertz;
            assert_true(inp_touch_next(&r.touch) == end);
            inp_touch_event(&r.touch, end);
        }
        touch_rig_set(&r, INPUT_TOUCH_CONTROL, 0, on + 999 * S);
        assert_true(inp_touch_next(&r.touch) == UINT64_MAX);
    }
}

/* Put down it is reported when the scan ends, not before. */
static void a_finger_is_told_at_the_end_of_a_scan(void **state)
{
    (void)state;
    for (unsigned kind = TOUCH_OPTICAL; kind <= TOUCH_ELECTRICAL; kind++) {
        struct touch_rig r;
        open_still(&r, kind);
        touch_rig_run(&r, 50 * MS);
        touch_rig_put(&r, 50 * MS + 1, 0, 10, 20, 0);
        assert_false(inp_touch_event(&r.touch, 60 * MS)); /* called too early */
        assert_false(inp_touch_ready(&r.touch));
        assert_true(inp_touch_next(&r.touch) == 75 * MS);
        assert_true(inp_touch_event(&r.touch, 75 * MS));
        assert_true(inp_touch_ready(&r.touch));
        assert_int_equal(status(&r), TOUCH_REPORT | TOUCH_TOUCHED);
    }
}

/* An event far too late makes one scan of that time, not a thousand. */
static void late_scans_are_passed_over(void **state)
{
    (void)state;
    struct touch_rig r;
    open_still(&r, TOUCH_OPTICAL);
    touch_rig_put(&r, 10, 0, 10, 20, 0);
    assert_true(inp_touch_event(&r.touch, UINT64_C(1) << 62));
    uint64_t next = inp_touch_next(&r.touch);
    assert_true(next > UINT64_C(1) << 62 && next <= (UINT64_C(1) << 62) + 25 * MS);
    assert_true(next % (25 * MS) == 0);
    assert_int_equal(touch_rig_get(&r, INPUT_TOUCH_SERIAL), 1);
}

/* ---- reports ----------------------------------------------------------------------------------- */

static void come_moved_gone_are_told_once(void **state)
{
    (void)state;
    for (unsigned kind = TOUCH_OPTICAL; kind <= TOUCH_ELECTRICAL; kind++) {
        struct touch_rig r;
        open_still(&r, kind);
        assert_int_equal(touch_rig_run(&r, 1 * S), 0);
        touch_rig_put(&r, 1 * S, 0, 10, 20, 0);
        assert_int_equal(touch_rig_run(&r, 2 * S), 1);
        take(&r, 2 * S);
        assert_int_equal(status(&r), TOUCH_TOUCHED);
        uint32_t x = touch_rig_get(&r, INPUT_TOUCH_X), y = touch_rig_get(&r, INPUT_TOUCH_Y);
        touch_rig_put(&r, 2 * S, 0, 10, 20, 0);
        assert_int_equal(touch_rig_run(&r, 3 * S), 0);
        touch_rig_put(&r, 3 * S, 0, 30, 20, 0);
        assert_int_equal(touch_rig_run(&r, 4 * S), 1);
        take(&r, 4 * S);
        assert_true(touch_rig_get(&r, INPUT_TOUCH_X) > x);
        assert_int_equal(touch_rig_get(&r, INPUT_TOUCH_Y), y);
        x = touch_rig_get(&r, INPUT_TOUCH_X);
        touch_rig_lift(&r, 4 * S);
        assert_int_equal(touch_rig_run(&r, 5 * S), 1);
        assert_int_equal(status(&r), TOUCH_REPORT);
        assert_int_equal(touch_rig_get(&r, INPUT_TOUCH_X), x); /* where it was last */
        assert_int_equal(touch_rig_get(&r, INPUT_TOUCH_Y), y);
        take(&r, 5 * S);
        assert_false(inp_touch_ready(&r.touch));
        assert_int_equal(touch_rig_get(&r, INPUT_TOUCH_SERIAL), 3);
    }
}

/* Each change is told, lost with LOST set, or replaced as asked for; serial numbers tell how many. */
static void reports_not_taken_are_lost(void **state)
{
    (void)state;
    for (int latest = 0; latest <= 1; latest++) {
        struct touch_rig r;
        open_still(&r, TOUCH_SONIC);
        if (latest)
            touch_rig_set(&r, INPUT_TOUCH_CONTROL, TOUCH_ON | TOUCH_LATEST, 0);
        uint32_t at[6];
        for (unsigned i = 0; i < 6; i++) {
            uint64_t t = i * S;
            touch_rig_put(&r, t, 0, -60 + 20.0 * i, 0, 0);
            assert_int_equal(touch_rig_run(&r, t + 500 * MS), 1);
            at[i] = touch_rig_get(&r, INPUT_TOUCH_X);
            assert_int_equal(touch_rig_get(&r, INPUT_TOUCH_SERIAL), latest ? i + 1 : i < 5 ? 1 : 6);
            assert_int_equal((status(&r) & TOUCH_LOST) != 0, !latest && i > 0 && i < 5);
            if (i == 4)
                take(&r, t + 600 * MS);
        }
        if (latest)
            assert_true(at[0] < at[1] && at[3] < at[4]);
        else
            assert_true(at[0] == at[1] && at[0] == at[4] && at[5] > at[0]);
    }
}

/* LOST is cleared by itself; REPORT too. */
static void bits_are_cleared_by_writing_them(void **state)
{
    (void)state;
    struct touch_rig r;
    open_still(&r, TOUCH_OPTICAL);
    touch_rig_put(&r, 0, 0, 0, 0, 0);
    touch_rig_run(&r, 25 * MS);
    touch_rig_lift(&r, 25 * MS);
    touch_rig_run(&r, 50 * MS);
    assert_int_equal(status(&r), TOUCH_REPORT | TOUCH_LOST | TOUCH_TOUCHED);
    touch_rig_set(&r, INPUT_TOUCH_STATUS, TOUCH_LOST | TOUCH_TOUCHED, 50 * MS);
    assert_int_equal(status(&r), TOUCH_REPORT | TOUCH_TOUCHED);
    touch_rig_set(&r, INPUT_TOUCH_STATUS, 0, 50 * MS);
    assert_int_equal(status(&r), TOUCH_REPORT | TOUCH_TOUCHED);
    touch_rig_set(&r, INPUT_TOUCH_STATUS, TOUCH_REPORT, 50 * MS);
    assert_int_equal(status(&r), TOUCH_TOUCHED);
}

/* A quarter of a millimetre above position 300; the load draws it down by 0.6 positions, then by 0.1. */
static void becoming_sure_is_told(void **state)
{
    (void)state;
    struct touch_rig r;
    open_still(&r, TOUCH_ELECTRICAL);
    r.setup.contact.value = 1000;
    touch_rig_put(&r, 0, 0, 0.28 + 300 * 0.56 + 0.25 - 140, -104, 0.526);
    assert_int_equal(touch_rig_run(&r, S), 1);
    assert_int_equal(status(&r), TOUCH_REPORT | TOUCH_TOUCHED | TOUCH_UNSURE);
    assert_int_equal(touch_rig_get(&r, INPUT_TOUCH_X), 600);
    take(&r, S);
    touch_rig_put(&r, S, 0, 0.28 + 300 * 0.56 + 0.25 - 140, -104, 3);
    assert_int_equal(touch_rig_run(&r, 2 * S), 1);
    assert_int_equal(status(&r), TOUCH_REPORT | TOUCH_TOUCHED);
    assert_int_equal(touch_rig_get(&r, INPUT_TOUCH_X), 600);
    take(&r, 2 * S);
    touch_rig_put(&r, 2 * S, 0, 0.28 + 300 * 0.56 + 0.25 - 140, -104, 0.526);
    assert_int_equal(touch_rig_run(&r, 3 * S), 0); /* it is known already where */
}

/* Switched off it reports nothing; on again, a finger that is there has come. */
static void it_is_switched_on_and_off(void **state)
{
    (void)state;
    struct touch_rig r;
    open_still(&r, TOUCH_OPTICAL);
    touch_rig_put(&r, 0, 0, 0, 0, 0);
    touch_rig_run(&r, 100 * MS);
    take(&r, 100 * MS);
    touch_rig_set(&r, INPUT_TOUCH_CONTROL, TOUCH_ON, 101 * MS); /* it is on: goes on */
    assert_true(inp_touch_next(&r.touch) == 125 * MS);
    touch_rig_set(&r, INPUT_TOUCH_CONTROL, 0, 110 * MS);
    touch_rig_put(&r, 120 * MS, 0, 50, 50, 0);
    assert_int_equal(touch_rig_run(&r, S), 0);
    touch_rig_set(&r, INPUT_TOUCH_CONTROL, UINT32_MAX, S);
    assert_int_equal(touch_rig_get(&r, INPUT_TOUCH_CONTROL), TOUCH_ON | TOUCH_LATEST);
    assert_int_equal(touch_rig_run(&r, 2 * S), 1);
    inp_touch_reset(&r.touch, 2 * S);
    assert_int_equal(status(&r), 0);
    assert_int_equal(touch_rig_get(&r, INPUT_TOUCH_CONTROL), 0);
    assert_int_equal(touch_rig_get(&r, INPUT_TOUCH_SERIAL), 0);
    assert_true(inp_touch_next(&r.touch) == UINT64_MAX);
    touch_rig_set(&r, INPUT_TOUCH_CONTROL, TOUCH_ON, 2 * S);
    assert_int_equal(touch_rig_run(&r, 3 * S), 1); /* the finger is still there */
}

static void registers_that_are_there(void **state)
{
    (void)state;
    for (unsigned kind = TOUCH_NONE; kind <= TOUCH_ELECTRICAL; kind++) {
        struct touch_rig r;
        touch_rig_open(&r, kind, 280, 210);
        touch_rig_put(&r, 0, 0, 0, 0, 0);
        uint32_t value;
        for (uint32_t offset = 0x2F0; offset < 0x370; offset++) {
            bool there = offset % 4 == 0 && ((offset >= 0x300 && offset <= 0x330) ||
                                             (offset >= 0x340 && offset <= 0x34C));
            assert_int_equal(inp_touch_read(&r.touch, offset, &value), there);
            if (there && kind == TOUCH_NONE)
                assert_int_equal(value, 0);
            assert_int_equal(inp_touch_write(&r.touch, offset, UINT32_MAX, 0), there);
        }
        assert_int_equal(touch_rig_get(&r, INPUT_TOUCH_KIND), kind);
        assert_int_equal(touch_rig_get(&r, INPUT_TOUCH_HEAD), kind == TOUCH_NONE ? 0 : 1);
        assert_int_equal(inp_touch_next(&r.touch) == UINT64_MAX, kind == TOUCH_NONE);
    }
}

/* ---- snapshots --------------------------------------------------------------------------------- */

static uint64_t walk(struct touch_rig *r, uint64_t *row, uint64_t *t, int steps)
{
    uint64_t hash = 0;
    for (int i = 0; i < steps; i++) {
        *t += (uint64_t)touch_rig_roll(row, 0, 4e10);
        for (int n = 0; n < 50 && inp_touch_next(&r->touch) <= *t; n++)
            hash = hash * 31 + inp_touch_event(&r->touch, inp_touch_next(&r->touch));
        double what = touch_rig_roll(row, 0, 10);
        if (what < 1)
            touch_rig_lift(r, *t);
        else if (what < 2)
            take(r, *t);
        else if (what < 3)
            touch_rig_set(r, INPUT_TOUCH_CONTROL, (uint32_t)touch_rig_roll(row, 0, 4), *t);
        else
            touch_rig_put(r, *t, (uint64_t)touch_rig_roll(row, 0, 6e10),
                          touch_rig_roll(row, -160, 160), touch_rig_roll(row, -120, 120),
                          touch_rig_roll(row, 0, 2));
        hash = hash * 31 + inp_touch_next(&r->touch);
        for (uint32_t offset = INPUT_TOUCH_KIND; offset <= INPUT_TOUCH_SERIAL; offset += 4)
            hash = hash * 31 + touch_rig_get(r, offset);
        for (uint32_t n = 0; n < TOUCH_RAW_WORDS; n++)
            hash = hash * 31 + touch_rig_get(r, INPUT_TOUCH_RAW + 4 * n);
    }
    return hash;
}

static void saved_it_goes_on_alike(void **state)
{
    (void)state;
    int within = 0;
    for (unsigned i = 0; i < 200; i++) {
        struct touch_rig a, b;
        touch_rig_open(&a, i % 4, 280, 210);
        touch_rig_open(&b, i % 4, 280, 210);
        touch_rig_set(&a, INPUT_TOUCH_CONTROL, TOUCH_ON, 0);
        uint64_t row = 1000 * i, t = 0;
        walk(&a, &row, &t, (int)i);
        within += a.touch.scan.sampled > 0;
        struct crt_state s;
        crt_state_save(&s);
        inp_touch_state(&a.touch, &s);
        assert_false(s.failed);
        struct crt_state l;
        crt_state_load(&l, s.out, s.size);
        inp_touch_state(&b.touch, &l);
        assert_false(l.failed);
        uint64_t row_b = row, t_b = t;
        assert_true(walk(&a, &row, &t, 100) == walk(&b, &row_b, &t_b, 100));
        crt_state_free(&s);
    }
    assert_true(within > 50);
}

static void spoilt_bytes_do_no_harm(void **state)
{
    (void)state;
    int refused = 0, taken = 0;
    uint64_t row = 7000000;
    for (unsigned i = 0; i < 10000; i++) {
        struct touch_rig r;
        touch_rig_open(&r, i % 4, 280, 210);
        uint64_t t = 0;
        touch_rig_set(&r, INPUT_TOUCH_CONTROL, TOUCH_ON, 0);
        walk(&r, &row, &t, 4);
        struct crt_state s;
        crt_state_save(&s);
        inp_touch_state(&r.touch, &s);
        size_t at = 12 + (size_t)touch_rig_roll(&row, 0, (double)(s.size - 12));
        for (size_t k = at; k < s.size && k < at + 1 + i % 8; k++)
            s.out[k] = (uint8_t)((int)touch_rig_roll(&row, 0, 456) % 256);
        struct crt_state l;
        crt_state_load(&l, s.out, s.size);
        inp_touch_state(&r.touch, &l);
        refused += l.failed;
        taken += !l.failed;
        if (!l.failed) {
            walk(&r, &row, &t, 6);
            unsigned columns = touch_rig_get(&r, INPUT_TOUCH_COLUMNS);
            assert_true(touch_rig_get(&r, INPUT_TOUCH_X) <= 2 * columns);
        }
        crt_state_free(&s);
    }
    assert_true(refused > 1000 && taken > 1000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scans_are_exact_in_time),
        cmocka_unit_test(a_finger_is_told_at_the_end_of_a_scan),
        cmocka_unit_test(late_scans_are_passed_over),
        cmocka_unit_test(come_moved_gone_are_told_once),
        cmocka_unit_test(reports_not_taken_are_lost),
        cmocka_unit_test(bits_are_cleared_by_writing_them),
        cmocka_unit_test(becoming_sure_is_told),
        cmocka_unit_test(it_is_switched_on_and_off),
        cmocka_unit_test(registers_that_are_there),
        cmocka_unit_test(saved_it_goes_on_alike),
        cmocka_unit_test(spoilt_bytes_do_no_harm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
