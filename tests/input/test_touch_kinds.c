/* What each kind of panel measures, against models of its physics: the way of an echo, a circuit solved by its
 * nodes; and a program that finds the finger with the registers alone. */
#include <math.h>

#include "tests/input/touch_rig.h"

/* ---- geometry ---------------------------------------------------------------------------------- */

/* Positions cover the area, symmetrically, to a micrometre each. */
static void positions_are_spread_evenly(void **state)
{
    (void)state;
    uint64_t row = 0;
    for (int i = 0; i < 2000; i++) {
        struct touch_rig r;
        double width = touch_rig_roll(&row, 60, 700);
        touch_rig_open(&r, 1 + (unsigned)i % 3, width, touch_rig_roll(&row, 60, 700));
        r.setup.columns.value = floor(touch_rig_roll(&row, 10, 50.999));
        r.setup.steps.value = floor(touch_rig_roll(&row, 100, 1000.999));
        unsigned n = touch_rig_get(&r, INPUT_TOUCH_COLUMNS);
        assert_int_equal(n, (int)(i % 3 == 0 ? r.setup.columns.value : r.setup.steps.value));
        double pitch = touch_rig_get(&r, INPUT_TOUCH_PITCH_X) / 1000.0;
        assert_true(pitch >= width / n - 1e-9 && pitch < width / n + 0.0011);
        double left = touch_rig_mm(&r, 0, 0), right = touch_rig_mm(&r, 0, n - 1);
        assert_true(fabs(left + right) <= 0.0021);
        assert_true(left - pitch / 2 <= -width / 2 + 0.0011 &&
                    right + pitch / 2 >= width / 2 - 0.0011);
    }
}

/* ---- a program finds the finger ---------------------------------------------------------------- */

static void any_figures(struct touch_rig *r, uint64_t *row)
{
#define X(field, unit, value_, low_, high_, meaning, source_)                                      \
    r->setup.field.value = touch_rig_roll(row, 0, 1) < 0.1   ? r->setup.field.low                  \
                           : touch_rig_roll(row, 0, 1) < 0.1 ? r->setup.field.high                 \
                                                             : touch_rig_roll(row, low_, high_);
    INP_TOUCH_FIGURES(X)
#undef X
    r->setup.columns.value = floor(r->setup.columns.value);
    r->setup.rows.value = floor(r->setup.rows.value);
    r->setup.steps.value = floor(r->setup.steps.value);
}

/* What is not seen, and why, mm from the middle. */
static bool should_be_seen(const struct touch_rig *r, double x, double y, double newton)
{
    const struct inp_touch_setup *s = &r->setup;
    double u = x + r->touch.desc.width_mm / 2, v = y + r->touch.desc.height_mm / 2;
    if (s->kind == TOUCH_SONIC)
        return 2e-3 * s->loss.value * (u > v ? u : v) < s->hear.value + 6;
    if (s->kind == TOUCH_ELECTRICAL)
        return newton >= s->force.value;
    bool seen[2] = {false, false};
    for (int axis = 0; axis < 2; axis++)
        for (unsigned n = 0; n < (unsigned)(axis == 0 ? s->columns.value : s->rows.value); n++)
            seen[axis] |=
                fabs((axis == 0 ? x : y) - touch_rig_mm(r, axis, n)) <= s->finger.value / 2;
    return seen[0] && seen[1];
}

/* How far off a sure report can be, mm. */
static double tolerance(const struct touch_rig *r, double pitch, double newton)
{
    const struct inp_touch_setup *s = &r->setup;
    (void)newton;
    double noise = INP_NOISE_MOST * s->noise.value;
    if (s->kind == TOUCH_SONIC)
        return pitch / 2 + noise + s->velocity.value / (4000 * s->timer.value);
    if (s->kind == TOUCH_ELECTRICAL)
        return pitch + noise + r->touch.desc.width_mm / 65536;
    return pitch / 2;
}

static void a_program_finds_the_finger(void **state)
{
    (void)state;
    uint64_t row = 0;
    int touched = 0, sure = 0;
    for (int i = 0; i < 6000; i++) {
        struct touch_rig r;
        touch_rig_open(&r, 1 + (unsigned)i % 3, touch_rig_roll(&row, 100, 500), 240);
        if (i >= 3000)
            any_figures(&r, &row);
        if (i % 2)
            r.setup.noise.value = 0;
        r.touch.desc.seed = (uint64_t)i;
        double margin = r.setup.kind == TOUCH_OPTICAL ? r.setup.finger.value / 2 : 0;
        double w = r.touch.desc.width_mm / 2 - margin, h = 120 - margin;
        double x = round(touch_rig_roll(&row, -w, w) * 1000) / 1000;
        double y = round(touch_rig_roll(&row, -h, h) * 1000) / 1000;
        double newton = round(touch_rig_roll(&row, 0.2, 6) * 1000) / 1000;
        touch_rig_put(&r, 0, 0, x, y, newton);
        bool seen = touch_rig_first(&r);
        assert_int_equal(seen, should_be_seen(&r, x, y, newton));
        touched += seen;
        if (!seen || touch_rig_unsure(&r))
            continue;
        sure++;
        double pitch_x = touch_rig_get(&r, INPUT_TOUCH_PITCH_X) / 1000.0;
        double pitch_y = touch_rig_get(&r, INPUT_TOUCH_PITCH_Y) / 1000.0;
        assert_true(fabs(touch_rig_x(&r) - x) <= tolerance(&r, pitch_x, newton) + 0.002);
        assert_true(fabs(touch_rig_y(&r) - y) <= tolerance(&r, pitch_y, newton) + 0.002);
    }
    assert_true(touched > 4000 && sure > 3500);
}

/* ---- sonic ------------------------------------------------------------------------------------- */

static void echoes_take_their_time(void **state)
{
    (void)state;
    uint64_t row = 0;
    for (int i = 0; i < 2000; i++) {
        struct touch_rig r;
        touch_rig_open(&r, TOUCH_SONIC, 300, 200);
        r.setup.noise.value = 0;
        r.setup.loss.value = 0;
        r.setup.velocity.value = touch_rig_roll(&row, 2000, 6000);
        r.setup.timer.value = touch_rig_roll(&row, 1, 100);
        double x = round(touch_rig_roll(&row, -150, 150)),
               y = round(touch_rig_roll(&row, -100, 100));
        touch_rig_put(&r, 0, 0, x, y, 0);
        assert_true(touch_rig_first(&r));
        double tick = 1000 / r.setup.timer.value; /* ns */
        double across = 2 * (x + 150) * 1e-3 / r.setup.velocity.value * 1e9;
        double up = 2 * (y + 100) * 1e-3 / r.setup.velocity.value * 1e9;
        assert_true(fabs(touch_rig_get(&r, INPUT_TOUCH_RAW) - across) <= tick / 2 + 0.51);
        assert_true(fabs(touch_rig_get(&r, INPUT_TOUCH_RAW + 4) - up) <= tick / 2 + 0.51);
        double ticks = touch_rig_get(&r, INPUT_TOUCH_RAW) / tick;
        assert_true(fabs(ticks - round(ticks)) <= 0.51 / tick);
        assert_false(touch_rig_unsure(&r));
    }
}

/* 30 dB/m there and back: 18 dB at 300 mm. */
static void far_echoes_are_weak(void **state)
{
    (void)state;
    const struct {
        double hear;
        bool touched, sure;
    } cases[] = {{19, true, true}, {17, true, false}, {13, true, false}, {11, false, false}};
    for (int i = 0; i < 4; i++) {
        struct touch_rig r;
        touch_rig_open(&r, TOUCH_SONIC, 300, 200);
        r.setup.hear.value = cases[i].hear;
        touch_rig_put(&r, 0, 0, 149.9, 0, 0);
        assert_int_equal(touch_rig_first(&r), cases[i].touched);
        assert_int_equal(cases[i].touched && !touch_rig_unsure(&r), cases[i].sure);
    }
}

/* 15 dB down where 10 are told surely: 5 dB more noise. */
static void weak_echoes_are_noisy(void **state)
{
    (void)state;
    for (int weak = 0; weak <= 1; weak++) {
        struct touch_rig r;
        touch_rig_open(&r, TOUCH_SONIC, 300, 200);
        r.setup.noise.value = 1;
        r.setup.hear.value = weak ? 10 : 15.1;
        touch_rig_put(&r, 0, 0, 100, 0, 0);
        touch_rig_set(&r, INPUT_TOUCH_CONTROL, TOUCH_ON | TOUCH_LATEST, 0);
        double squares = 0;
        int n = 10000;
        for (int i = 0; i < n; i++) {
            inp_touch_event(&r.touch, inp_touch_next(&r.touch));
            squares += pow(touch_rig_x(&r) - 100, 2);
        }
        assert_true(fabs(sqrt(squares / n) - (weak ? pow(10, 0.25) : 1)) < 0.05);
    }
}

/* Noise is normal with the listed deviation. */
static void noise_is_as_listed(void **state)
{
    (void)state;
    for (unsigned kind = TOUCH_SONIC; kind <= TOUCH_ELECTRICAL; kind++) {
        struct touch_rig r;
        touch_rig_open(&r, kind, 300, 200);
        r.setup.noise.value = 3;
        r.setup.steps.value = 1000;
        r.setup.input.value = 1e9;
        touch_rig_put(&r, 0, 0, 0, 0, 0);
        touch_rig_set(&r, INPUT_TOUCH_CONTROL, TOUCH_ON | TOUCH_LATEST, 0);
        double sum[2] = {0, 0}, squares[2] = {0, 0}, product = 0;
        int n = 10000;
        for (int i = 0; i < n; i++) {
            inp_touch_event(&r.touch, inp_touch_next(&r.touch));
            double at[2] = {touch_rig_x(&r), touch_rig_y(&r)};
            for (int a = 0; a < 2; a++) {
                sum[a] += at[a];
                squares[a] += at[a] * at[a];
            }
            product += at[0] * at[1];
        }
        for (int a = 0; a < 2; a++) {
            assert_true(fabs(sum[a] / n) < 4 * 3 / sqrt(n) + 0.05);
            assert_true(fabs(sqrt(squares[a] / n) - 3) < 0.1);
        }
        assert_true(fabs(product / n) < 4 * 9 / sqrt(n));
    }
}

/* ---- electrical -------------------------------------------------------------------------------- */

/* The node where the plates touch: what flows in from the driven edge leaves by the other and the load. */
static double voltage(const struct inp_touch_setup *s, double part, double newton)
{
    double above = 1 / (s->sheet.value * (1 - part)), below = 1 / (s->sheet.value * part);
    double contact = s->contact.value / newton, load = 1 / (contact + s->input.value);
    double node = above / (above + below + load);
    return node * s->input.value * load;
}

static void plates_divide_the_voltage(void **state)
{
    (void)state;
    uint64_t row = 0;
    for (int i = 0; i < 3000; i++) {
        struct touch_rig r;
        touch_rig_open(&r, TOUCH_ELECTRICAL, 300, 200);
        any_figures(&r, &row);
        r.setup.noise.value = 0;
        double x = round(touch_rig_roll(&row, -149, 149)), y = round(touch_rig_roll(&row, -99, 99));
        double newton = round(touch_rig_roll(&row, r.setup.force.value + 0.001, 8) * 1000) / 1000;
        touch_rig_put(&r, 0, 0, x, y, newton);
        assert_true(touch_rig_first(&r));
        double vx = voltage(&r.setup, (x + 150) / 300, newton) * 65536;
        double vy = voltage(&r.setup, (y + 100) / 200, newton) * 65536;
        assert_true(fabs(touch_rig_get(&r, INPUT_TOUCH_RAW) + 0.5 - vx) <= 0.5001);
        assert_true(fabs(touch_rig_get(&r, INPUT_TOUCH_RAW + 4) + 0.5 - vy) <= 0.5001);
        double contact = r.setup.contact.value / newton;
        assert_true(fabs(touch_rig_get(&r, INPUT_TOUCH_RAW + 8) - contact) <= 0.5001);
        /* Surely told: the load draws it by less than half a position. */
        double off_x = ((x + 150) / 300 - vx / 65536) * 300e3;
        double off_y = ((y + 100) / 200 - vy / 65536) * 200e3;
        bool off = off_x > touch_rig_get(&r, INPUT_TOUCH_PITCH_X) / 2.0 ||
                   off_y > touch_rig_get(&r, INPUT_TOUCH_PITCH_Y) / 2.0;
        assert_int_equal(touch_rig_unsure(&r), off);
    }
}

static void a_light_press_is_unsure_a_lighter_none(void **state)
{
    (void)state;
    const struct {
        double newton;
        bool touched, sure;
    } cases[] = {{0, true, true},
                 {1, true, true},
                 {0.31, true, false},
                 {0.29, false, false},
                 {-0.5, false, false}};
    for (int i = 0; i < 5; i++) {
        struct touch_rig r;
        touch_rig_open(&r, TOUCH_ELECTRICAL, 300, 200);
        touch_rig_put(&r, 0, 0, 100, 50, cases[i].newton);
        assert_int_equal(touch_rig_first(&r), cases[i].touched);
        assert_int_equal(cases[i].touched && !touch_rig_unsure(&r), cases[i].sure);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(positions_are_spread_evenly),
        cmocka_unit_test(a_program_finds_the_finger),
        cmocka_unit_test(echoes_take_their_time),
        cmocka_unit_test(far_echoes_are_weak),
        cmocka_unit_test(weak_echoes_are_noisy),
        cmocka_unit_test(noise_is_as_listed),
        cmocka_unit_test(plates_divide_the_voltage),
        cmocka_unit_test(a_light_press_is_unsure_a_lighter_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
