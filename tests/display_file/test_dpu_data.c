/* One test per data word form: vectors, points, graphplot; wrapping and the screen's edge. */
#include "tests/support/dpu_rig.h"

#include <math.h>

static struct dpu_rig rig;
static struct dpu_rig *const r = &rig;

static void expect_position(int x, int y)
{
    assert_int_equal(r->dpu.x, x);
    assert_int_equal(r->dpu.y, y);
    assert_int_equal(dpu_rig_reg(r, DF_XPR) & DF_XPR_X, x & 1023);
    assert_int_equal(dpu_rig_reg(r, DF_YPR) & DF_YPR_Y, y & 1023);
}

static void point_loads_both_coordinates(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0114000, 0 | 01777, 01776);
    expect_position(1023, 1022);
    assert_int_equal(r->count, 0);
    /* Unsigned: neither the sign bit nor the bits above ten count. */
    RUN(r, 0114000, DF_BEAM_ON | 020000 | 010000 | 06000 | 5, 077770 & ~DF_BEAM_ON);
    expect_position(5, 01770);
    assert_int_equal(r->count, 1);
    dpu_rig_expect_stroke(r, 0, 5, 01770, 5, 01770);
    assert_int_equal(r->strokes[0].source, 2);
}

static void point_takes_the_beam_bit_of_the_first_word(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0114000, 100, DF_BEAM_ON | 100);
    assert_int_equal(r->count, 0);
    RUN(r, 0114000, DF_BEAM_ON | 100, 100);
    assert_int_equal(r->count, 1);
}

static void short_vector_has_signs_and_magnitudes(void **state)
{
    (void)state;
    static const struct {
        uint16_t word;
        int dx, dy;
    } cases[] = {
        {DF_BEAM_ON | 63 << 7 | 63, 63, 63},
        {DF_BEAM_ON | 020000 | 63 << 7 | 63, -63, 63},
        {DF_BEAM_ON | 63 << 7 | 0100 | 63, 63, -63},
        {DF_BEAM_ON | 020000 | 1 << 7 | 0100 | 2, -1, -2},
        {DF_BEAM_ON | 5 << 7, 5, 0},
        {DF_BEAM_ON | 7, 0, 7},
        {DF_BEAM_ON | 5 << 7 | 0100, 5, 0}, /* minus zero */
    };
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        dpu_rig_init(r);
        RUN(r, 0114000, 500, 400, 0104000, cases[i].word);
        assert_int_equal(r->count, 1);
        dpu_rig_expect_stroke(r, 0, 500, 400, 500 + cases[i].dx, 400 + cases[i].dy);
        expect_position(500 + cases[i].dx, 400 + cases[i].dy);
        assert_int_equal(r->strokes[0].source, 8);
    }
}

static void long_vector_has_signs_and_magnitudes(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0110000, DF_BEAM_ON | 01777, 01777);
    dpu_rig_expect_stroke(r, 0, 0, 0, 1023, 1023);
    RUN(r, 0110000, DF_BEAM_ON | 020000 | 01777, 020000 | 01000);
    dpu_rig_expect_stroke(r, 1, 1023, 1023, 0, 1023 - 01000);
    expect_position(0, 511);
    assert_int_equal(r->strokes[1].source, 2);
    /* Bits without meaning on a VT11: 14 of the second word, 12:10 of both. */
    RUN(r, 0110000, DF_BEAM_ON | 016000 | 3, DF_BEAM_ON | 016000 | 4);
    dpu_rig_expect_stroke(r, 2, 0, 511, 3, 515);
}

static void vector_with_beam_off_moves(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0110000, 100, 200, 0104000, 10 << 7 | 20);
    assert_int_equal(r->count, 0);
    expect_position(110, 220);
}

static void null_vector_is_skipped(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0104000, DF_BEAM_ON, DF_BEAM_ON | 020000 | 0100, 0);
    assert_int_equal(r->count, 0);
    assert_int_equal(r->dpu.t, 5 * FETCH);
    RUN(r, 0110000, DF_BEAM_ON, 0);
    assert_int_equal(r->count, 0);
    assert_int_equal(r->dpu.t, 9 * FETCH);
}

static void relative_point_moves_then_plots(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0114000, 100, 100, 0130000, DF_BEAM_ON | 3 << 7 | 4, 020000 | 10 << 7 | 0100 | 20,
        DF_BEAM_ON | 020000 | 1 << 7 | 1, DF_BEAM_ON);
    assert_int_equal(r->count, 3);
    dpu_rig_expect_stroke(r, 0, 103, 104, 103, 104);
    dpu_rig_expect_stroke(r, 1, 92, 85, 92, 85);
    dpu_rig_expect_stroke(r, 2, 92, 85, 92, 85); /* a null move is still a point */
    assert_int_equal(r->strokes[1].source, 12);
}

static void graphplot_x_steps_y_first(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0114000, 7, 100, 0174100 | 5, 0120000, 50, DF_BEAM_ON | 60, 037777);
    assert_int_equal(r->count, 3); /* the beam bit is ignored */
    dpu_rig_expect_stroke(r, 0, 50, 105, 50, 105);
    dpu_rig_expect_stroke(r, 1, 60, 110, 60, 110);
    dpu_rig_expect_stroke(r, 2, 1023, 115, 1023, 115);
    expect_position(1023, 115);
}

static void graphplot_y_steps_x_first(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0114000, 100, 7, 0174100 | 077, 0124000, 50, DF_BEAM_ON | 60, 02003);
    assert_int_equal(r->count, 3);
    dpu_rig_expect_stroke(r, 0, 163, 50, 163, 50);
    dpu_rig_expect_stroke(r, 1, 226, 60, 226, 60);
    dpu_rig_expect_stroke(r, 2, 289, 3, 289, 3); /* 2000 is not a long vector here */
}

static void position_wraps_at_twelve_bits(void **state)
{
    (void)state;
    dpu_rig_init(r);
    /* 1023 four times, then 4 more: 4096 is 0 again. */
    RUN(r, 0110000, 01777, 0, 01777, 0, 01777, 0, 01777, 0, 4, 0);
    expect_position(0, 0);
    RUN(r, 0110000, 020000 | 1, 020000 | 2);
    expect_position(-1, -2);
    assert_int_equal(dpu_rig_reg(r, DF_XPR), 01777);
    assert_int_equal(dpu_rig_reg(r, DF_YPR), 01776);
    RUN(r, 0110000, 020000 | 01777, 0, 020000 | 01777, 0, 020000 | 1, 0);
    expect_position(-2048, -2);
    RUN(r, 0110000, 020000 | 1, 0);
    expect_position(2047, -2);
    /* Graphplot's step wraps as well: 2047 + 1. */
    RUN(r, 0174101, 0124000, 0);
    expect_position(-2048, 0);
}

static void vector_across_the_edge_draws_nothing(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0114000, 1000, 500, 0110000, DF_BEAM_ON | 24, 0); /* to 1024: out */
    assert_int_equal(r->count, 0);
    expect_position(1024, 500);
    RUN(r, 0110000, DF_BEAM_ON | 020000 | 24, 0); /* back in */
    assert_int_equal(r->count, 0);
    RUN(r, 0110000, DF_BEAM_ON | 23, 0); /* to 1023: on screen */
    assert_int_equal(r->count, 1);
    /* Wholly outside, in through the wrap and on to 1023: the wrap is not an edge to come in by. */
    dpu_rig_init(r);
    RUN(r, 0110000, 020000 | 01777, 0, 020000 | 01777, 0, DF_BEAM_ON | 020000 | 01777, 0);
    expect_position(1027, 0);
    RUN(r, 0110000, DF_BEAM_ON | 020000 | 4, 0);
    assert_int_equal(r->count, 0);
    expect_position(1023, 0);
}

static void edge_indicator(void **state)
{
    (void)state;
    dpu_rig_init(r);
    /* In from the left sets it; START clears it. */
    RUN(r, 0114000, 0, 500, 0110000, 020000 | 10, 0, DF_BEAM_ON | 20, 0);
    assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_EDGE, DF_MPR_EDGE);
    dpu_rig_go(r, 01000);
    assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_EDGE, 0);
    /* Past the lower left corner along x + y = −5, and through it along x + y = 0. */
    RUN(r, 0114000, 0, 5, 0110000, 020000 | 10, 0, 10, 020000 | 10);
    assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_EDGE, 0);
    RUN(r, 0114000, 0, 10, 0110000, 020000 | 10, 0, 20, 020000 | 20);
    assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_EDGE, DF_MPR_EDGE);
    /* Out of the screen does not set it for vectors, but does for relative points. */
    RUN(r, 0114000, 1020, 5, 0110000, DF_BEAM_ON | 10, 0);
    assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_EDGE, 0);
    RUN(r, 0114000, 1020, 5, 0130000, DF_BEAM_ON | 10 << 7);
    assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_EDGE, DF_MPR_EDGE);
    RUN(r, 0114000, 1020, 5, 0130000, 10 << 7, 0114000, 5, 5);
    assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_EDGE, 0);
}

static uint16_t delta(int d)
{
    return (uint16_t)(d < 0 ? 020000 - d : d);
}

/* Past each corner at 45°, both ways: through it, one unit nearer and one farther. */
static void edge_indicator_at_the_corners(void **state)
{
    (void)state;
    static const struct {
        int x, y;   /* the corner */
        int dx, dy; /* along the line */
    } corners[] = {{0, 0, 10, -10},       {0, 0, -10, 10},      {1023, 0, 10, 10},
                   {1023, 0, -10, -10},   {0, 1023, 10, 10},    {0, 1023, -10, -10},
                   {1023, 1023, 10, -10}, {1023, 1023, -10, 10}};
    for (unsigned i = 0; i < sizeof corners / sizeof corners[0]; i++)
        for (int out = -1; out <= 1; out++) {
            int x = corners[i].x, y = corners[i].y, dx = corners[i].dx, dy = corners[i].dy;
            int away = x == 0 ? -out : out;
            dpu_rig_init(r);
            RUN(r, 0114000, (uint16_t)x, (uint16_t)y, 0110000, delta(away - dx), delta(-dy),
                delta(2 * dx), delta(2 * dy));
            expect_position(x + away + dx, y + dy);
            assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_EDGE, out > 0 ? 0 : DF_MPR_EDGE);
        }
}

static void points_off_screen_stay_dark(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0114000, 1020, 5, 0130000, DF_BEAM_ON | 4 << 7, DF_BEAM_ON | 020000 | 1 << 7);
    assert_int_equal(r->count, 1);
    dpu_rig_expect_stroke(r, 0, 1023, 5, 1023, 5);
    /* A lower screen ends at 767. */
    dpu_rig_init(r);
    r->desc.screen = (struct crt_screen){1024, 768, 1024, 768};
    dpu_rig_restart(r);
    RUN(r, 0114000, DF_BEAM_ON | 10, 767, DF_BEAM_ON | 10, 768, 0110000, DF_BEAM_ON | 1, 0);
    assert_int_equal(r->count, 1);
}

static void line_goes_straight_between_its_ends(void **state)
{
    (void)state;
    dpu_rig_init(r);
    r->desc.screen = (struct crt_screen){210, 157.5, 1024, 768};
    dpu_rig_restart(r);
    RUN(r, 0114000, 11, 22, 0110000, DF_BEAM_ON | 700, 500);
    assert_int_equal(r->count, 1);
    /* Unit u is centred at (u + ½) pitches from the edge. */
    assert_true(fabs((double)r->strokes[0].x0 - (11.5 * 210 / 1024 - 105)) < 1e-5);
    assert_true(fabs((double)r->strokes[0].y0 - (22.5 * 157.5 / 768 - 78.75)) < 1e-5);
    assert_true(fabs((double)r->strokes[0].x1 - (711.5 * 210 / 1024 - 105)) < 1e-5);
    assert_true(fabs((double)r->strokes[0].y1 - (522.5 * 157.5 / 768 - 78.75)) < 1e-5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(point_loads_both_coordinates),
        cmocka_unit_test(point_takes_the_beam_bit_of_the_first_word),
        cmocka_unit_test(short_vector_has_signs_and_magnitudes),
        cmocka_unit_test(long_vector_has_signs_and_magnitudes),
        cmocka_unit_test(vector_with_beam_off_moves),
        cmocka_unit_test(null_vector_is_skipped),
        cmocka_unit_test(relative_point_moves_then_plots),
        cmocka_unit_test(graphplot_x_steps_y_first),
        cmocka_unit_test(graphplot_y_steps_x_first),
        cmocka_unit_test(position_wraps_at_twelve_bits),
        cmocka_unit_test(vector_across_the_edge_draws_nothing),
        cmocka_unit_test(edge_indicator),
        cmocka_unit_test(edge_indicator_at_the_corners),
        cmocka_unit_test(points_off_screen_stay_dark),
        cmocka_unit_test(line_goes_straight_between_its_ends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
