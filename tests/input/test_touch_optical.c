/* Beams of an optical panel, against a finger as an interval, at rest and while it moves. */
#include <math.h>

#include "tests/input/touch_rig.h"

#define MS CRT_PS_PER_MS

static bool bit(const struct touch_rig *r, int axis, unsigned beam)
{
    uint32_t offset = INPUT_TOUCH_RAW + 8u * (unsigned)axis + 4 * (beam / 32);
    return touch_rig_get(r, offset) >> beam % 32 & 1;
}

/* A finger that rests: beams between its edges; on the beam, or between the outermost. */
static void a_finger_breaks_beams(void **state)
{
    (void)state;
    uint64_t row = 500;
    int ones = 0, none = 0;
    for (int i = 0; i < 3000; i++) {
        struct touch_rig r;
        touch_rig_open(&r, TOUCH_OPTICAL, touch_rig_roll(&row, 200, 400), 300);
        r.setup.columns.value = floor(touch_rig_roll(&row, 10, 50.999));
        r.setup.finger.value = touch_rig_roll(&row, 3, 30);
        double half = r.setup.finger.value / 2, w = r.touch.desc.width_mm / 2 + 20;
        double x = round(touch_rig_roll(&row, -w, w) * 1000) / 1000;
        touch_rig_put(&r, 0, 0, x, 0, 0);
        bool told = touch_rig_first(&r);
        unsigned columns = (unsigned)r.setup.columns.value, broken = 0;
        uint32_t sum = 0, last = 0;
        for (unsigned n = 0; n < columns; n++) {
            double line = touch_rig_mm(&r, 0, n);
            if (!(x - half <= line && line <= x + half))
                continue;
            sum = broken++ ? sum : n;
            last = n;
            if (told)
                assert_true(bit(&r, 0, n));
        }
        ones += broken == 1;
        none += broken == 0;
        if (broken == 0)
            assert_false(told);
        if (!told)
            continue;
        assert_int_equal(touch_rig_get(&r, INPUT_TOUCH_X), sum + last);
        assert_int_equal(__builtin_popcount(touch_rig_get(&r, INPUT_TOUCH_RAW)) +
                             __builtin_popcount(touch_rig_get(&r, INPUT_TOUCH_RAW + 4)),
                         broken);
        assert_false(touch_rig_unsure(&r));
    }
    assert_true(ones > 100 && none > 100);
}

/* Beam k of a scan is looked at when k + 1 parts of all have gone by. */
static void beams_are_scanned_one_after_the_other(void **state)
{
    (void)state;
    uint64_t row = 900;
    int apart = 0;
    for (int i = 0; i < 400; i++) {
        struct touch_rig r;
        touch_rig_open(&r, TOUCH_OPTICAL, 280, 210);
        touch_rig_set(&r, INPUT_TOUCH_CONTROL, TOUCH_ON, 0);
        /* Scans are 25 ms. In the fourth the finger starts and, perhaps, jumps. */
        double x0 = round(touch_rig_roll(&row, -130, 130)),
               x1 = round(touch_rig_roll(&row, -130, 130));
        double y0 = round(touch_rig_roll(&row, -90, 90)), y1 = round(touch_rig_roll(&row, -90, 90));
        uint64_t start = (uint64_t)touch_rig_roll(&row, 75, 100) * MS;
        uint64_t way = i % 2 ? 0 : (uint64_t)touch_rig_roll(&row, 1, 40) * MS;
        touch_rig_put(&r, 1 * MS, 0, x0, y0, 0);
        touch_rig_run(&r, 75 * MS);
        touch_rig_set(&r, INPUT_TOUCH_CONTROL, TOUCH_ON | TOUCH_LATEST, 75 * MS);
        touch_rig_put(&r, start, way, x1, y1, 0);
        bool told = inp_touch_event(&r.touch, 100 * MS);
        if (!told)
            continue;
        bool gap = false;
        for (unsigned k = 0; k < 100; k++) {
            int axis = k >= 50;
            unsigned beam = k % 50;
            double t = 75 + 25 * (k + 1) / 100.0 - (double)start / (double)MS;
            double part = t < 0 ? 0 : way == 0 ? 1 : t * (double)MS / (double)way;
            part = part > 1 ? 1 : part;
            double at = axis == 0 ? x0 + (x1 - x0) * part : y0 + (y1 - y0) * part;
            double off = fabs(at - touch_rig_mm(&r, axis, beam)) - 5.5;
            if (fabs(off) > 1e-6)
                assert_int_equal(bit(&r, axis, beam), off < 0);
            gap |= beam > 1 && bit(&r, axis, beam) && !bit(&r, axis, beam - 1) &&
                   bit(&r, axis, beam - 2);
        }
        if (gap)
            assert_true(touch_rig_unsure(&r));
        apart += touch_rig_unsure(&r);
    }
    assert_true(apart > 10);
}

/* Up in time for its column beams only: no finger. */
static void half_a_scan_is_no_finger(void **state)
{
    (void)state;
    struct touch_rig r;
    touch_rig_open(&r, TOUCH_OPTICAL, 280, 210);
    touch_rig_set(&r, INPUT_TOUCH_CONTROL, TOUCH_ON, 0);
    touch_rig_put(&r, 1, 0, 0, 0, 0);
    touch_rig_lift(&r, 13 * MS);
    assert_int_equal(touch_rig_run(&r, 100 * MS), 0);
    touch_rig_put(&r, 101 * MS, 0, 0, 0, 0);
    assert_int_equal(touch_rig_run(&r, 125 * MS), 1);
}

/* Beams end at the panel's edge: beside it a finger breaks none, though it is level with some. */
static void beside_the_panel_there_are_no_beams(void **state)
{
    (void)state;
    const double places[4][2] = {{-151, 0}, {151, 0}, {0, 121}, {0, -121}};
    for (int i = 0; i < 4; i++) {
        struct touch_rig r;
        touch_rig_open(&r, TOUCH_OPTICAL, 290, 230);
        touch_rig_put(&r, 0, 0, 0, 0, 0);
        assert_true(touch_rig_first(&r));
        touch_rig_set(&r, INPUT_TOUCH_STATUS, TOUCH_REPORT, 25 * MS);
        touch_rig_put(&r, 26 * MS, 0, places[i][0], places[i][1], 0);
        assert_int_equal(touch_rig_run(&r, 75 * MS), 1);
        assert_int_equal(touch_rig_get(&r, INPUT_TOUCH_STATUS), TOUCH_REPORT);
        touch_rig_set(&r, INPUT_TOUCH_CONTROL, TOUCH_ON | TOUCH_LATEST, 75 * MS);
        touch_rig_put(&r, 76 * MS, 0, 0, 0, 0);
        touch_rig_run(&r, 100 * MS);
        touch_rig_put(&r, 100 * MS + 1, 0, places[i][0], places[i][1], 0);
        touch_rig_run(&r, 125 * MS);
        for (uint32_t n = 0; n < TOUCH_RAW_WORDS; n++)
            assert_int_equal(touch_rig_get(&r, INPUT_TOUCH_RAW + 4 * n), 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_finger_breaks_beams),
        cmocka_unit_test(beams_are_scanned_one_after_the_other),
        cmocka_unit_test(half_a_scan_is_no_finger),
        cmocka_unit_test(beside_the_panel_there_are_no_beams),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
