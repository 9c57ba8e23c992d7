/* The character generator: cells, control characters, shift-out, italics, the screen's edge. */
#include "tests/support/dpu_rig.h"

#include <math.h>

#include "display_file/glyphs.h"

static struct dpu_rig rig;
static struct dpu_rig *const r = &rig;

#define PAIR(a, b) ((uint16_t)((a) | (b) << 8))

/* The strokes from `index` on are the dots of `glyph` at (x, y), column by column, bottom up.
 * Returns the index behind them. */
static size_t expect_glyph(size_t index, const struct df_glyph *glyph, int x, int y, double slant)
{
    assert_non_null(glyph);
    if (glyph->descends)
        y -= 4;
    for (int column = 0; column < 6; column++)
        for (int row = 0; row < 8; row++)
            if (glyph->column[column] & 1 << row) {
                /* A dot covers two units each way: its centre is half a unit up and right. */
                double ux = x + 2 * column + 0.5 + slant * 2 * row, uy = y + 2 * row + 0.5;
                dpu_rig_expect_stroke(r, index, ux, uy, ux, uy);
                index++;
            }
    return index;
}

static void low_byte_first(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0114000, 100, 200, 0100000, PAIR('A', 'b'));
    size_t n = expect_glyph(0, df_glyph_ascii('A'), 100, 200, 0);
    n = expect_glyph(n, df_glyph_ascii('b'), 114, 200, 0);
    assert_int_equal(n, r->count);
    assert_int_equal(r->dpu.x, 128);
    assert_int_equal(r->dpu.y, 200);
    assert_int_equal(r->strokes[0].source, 8);
    assert_int_equal(dpu_rig_reg(r, DF_YPR), ('b' & 077) << 10 | 200);
}

static void every_ascii_glyph(void **state)
{
    (void)state;
    for (unsigned c = 041; c <= 0177; c++) {
        dpu_rig_init(r);
        /* Bit 7 of the low byte means nothing. */
        RUN(r, 0114000, 100, 200, 0100000, PAIR(c | 0200, 0));
        assert_int_equal(expect_glyph(0, df_glyph_ascii(c), 100, 200, 0), r->count);
        assert_int_equal(r->dpu.x, 114);
    }
}

static void every_special_glyph(void **state)
{
    (void)state;
    for (unsigned c = 0; c < 040; c++) {
        if (c == 017)
            continue;
        dpu_rig_init(r);
        RUN(r, 0114000, 100, 200, 0100000, PAIR(016, c));
        assert_int_equal(expect_glyph(0, df_glyph_special(c), 100, 200, 0), r->count);
        assert_int_equal(r->dpu.x, 114);
        assert_true(r->dpu.shift_out);
        assert_int_equal(dpu_rig_reg(r, DF_YPR) >> 10, c);
    }
}

static void shift_in_ends_the_special_set(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0114000, 100, 200, 0100000, PAIR(016, 1), PAIR(017, 'x'));
    size_t n = expect_glyph(0, df_glyph_special(1), 100, 200, 0);
    assert_int_equal(expect_glyph(n, df_glyph_ascii('x'), 114, 200, 0), r->count);
    assert_int_equal(r->event_count, 0);
}

static void control_characters_move(void **state)
{
    (void)state;
    static const struct {
        unsigned code;
        int x, y;
    } cases[] = {{0, 500, 600},   {010, 486, 600}, {012, 500, 576}, {015, 0, 600},
                 {016, 500, 600}, {' ', 514, 600}, {021, 500, 600}, {022, 500, 600},
                 {023, 500, 600}, {024, 500, 600}, {07, 500, 600},  {011, 500, 600},
                 {033, 500, 600}, {037, 500, 600}, {017, 500, 600}};
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        dpu_rig_init(r);
        RUN(r, 0114000, 500, 600, 0100000, PAIR(0, cases[i].code));
        assert_int_equal(r->count, 0);
        assert_int_equal(r->dpu.x, cases[i].x);
        assert_int_equal(r->dpu.y, cases[i].y);
        assert_int_equal(dpu_rig_reg(r, DF_YPR) >> 10, cases[i].code & 077);
        assert_int_equal(r->dpu.shift_out, cases[i].code == 016);
    }
}

static void moves_wrap(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0114000, 0, 0, 0100000, PAIR(010, 012));
    assert_int_equal(r->dpu.x, -14);
    assert_int_equal(r->dpu.y, -24);
    dpu_rig_init(r);
    LOAD(r, 0, 0100000);
    for (uint16_t i = 0; i < 150; i++)
        LOAD(r, (uint16_t)(2 + 2 * i), PAIR(' ', ' '));
    dpu_rig_go(r, 0);
    assert_int_equal(r->dpu.x, 300 * 14 - 4096);
}

static void italics_slant(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0114000, 100, 200, 0170060, 0100000, PAIR('H', 'g'), 0170040, PAIR('H', 0));
    size_t n = expect_glyph(0, df_glyph_ascii('H'), 100, 200, 1 / 3.0);
    n = expect_glyph(n, df_glyph_ascii('g'), 114, 200, 1 / 3.0);
    assert_int_equal(expect_glyph(n, df_glyph_ascii('H'), 128, 200, 0), r->count);
}

static void base_line_off_screen_is_not_drawn(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0114000, 1012, 200, 0100000, PAIR('H', 0)); /* 1012 … 1023 */
    assert_true(r->count > 0);
    assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_EDGE, 0);
    dpu_rig_init(r);
    RUN(r, 0114000, 1013, 200, 0100000, PAIR('H', 0));
    assert_int_equal(r->count, 0);
    assert_int_equal(r->dpu.x, 1027); /* but it advances */
    assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_EDGE, DF_MPR_EDGE);
    dpu_rig_init(r);
    RUN(r, 0114000, 5, 0, 0130000, 0100 | 1, 0100000, PAIR('H', 0)); /* y = −1 */
    assert_int_equal(r->count, 0);
    assert_int_equal(r->dpu.x, 19);
    dpu_rig_init(r);
    RUN(r, 0114000, 5, 5, 0130000, 020000 | 6 << 7, 0100000, PAIR('H', 0)); /* x = −1 */
    assert_int_equal(r->count, 0);
}

static void dots_off_screen_stay_dark(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0114000, 100, 1018, 0100000, PAIR('H', 0)); /* rows up to 1023: three of eight */
    assert_true(r->count > 0);
    for (size_t i = 0; i < r->count; i++)
        assert_true(rig_y0(&r->strokes[i]) < 1023);
    dpu_rig_init(r);
    RUN(r, 0114000, 100, 0, 0100000, PAIR('g', 0)); /* the descender is below 0 */
    assert_true(r->count > 0);
    for (size_t i = 0; i < r->count; i++)
        assert_true(rig_y0(&r->strokes[i]) > 0);
}

static void dots_that_lean_off_screen_stay_dark(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0114000, 1012, 200, 0170060, 0100000, PAIR('H', 0)); /* 1012 … 1023 and 4⅔ more on top */
    size_t whole = 0;
    for (int column = 0; column < 6; column++)
        for (int row = 0; row < 8; row++)
            whole += df_glyph_ascii('H')->column[column] >> row & 1;
    assert_true(r->count > 0 && r->count < whole);
    for (size_t i = 0; i < r->count; i++)
        assert_true(rig_x0(&r->strokes[i]) < 1023.01);
}

static void bad_shifted_out_code_interrupts(void **state)
{
    (void)state;
    for (unsigned c = 040; c <= 0177; c += 037) {
        dpu_rig_init(r);
        LOAD(r, 0, 0114000, 100, 200, 0100000, PAIR(016, c), DF_STOP);
        dpu_rig_go(r, 0);
        assert_int_equal(r->dpu.state, DF_WAITING_RESUME);
        assert_int_equal(r->count, 0);
        assert_int_equal(r->event_count, 1);
        assert_int_equal(r->events[0].line, DF_INT_CHARACTER);
        assert_true(r->events[0].level);
        assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_SO, DF_MPR_SO);
        assert_int_equal(dpu_rig_reg(r, DF_DPC), 10);
        assert_int_equal(dpu_rig_reg(r, DF_YPR), (c & 077) << 10 | 200);
        assert_int_equal(r->dpu.x, 100);
        assert_false(r->dpu.timeout);
        /* RESUME goes on with the next word, still shifted out. */
        df_dpu_write(&r->dpu, DF_DPC, 1, r->dpu.t);
        assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_SO, 0);
        assert_false(r->events[1].level);
        dpu_rig_continue(r);
        assert_int_equal(r->dpu.state, DF_STOPPED);
        assert_true(r->dpu.shift_out);
    }
}

static void resume_draws_the_second_character(void **state)
{
    (void)state;
    dpu_rig_init(r);
    LOAD(r, 0, 0114000, 100, 200, 0100000, PAIR(0, 016), PAIR('A', 1), DF_STOP);
    dpu_rig_go(r, 0);
    assert_int_equal(r->dpu.state, DF_WAITING_RESUME);
    assert_int_equal(r->count, 0);
    df_dpu_write(&r->dpu, DF_DPC, 1, 500 * US);
    assert_int_equal(expect_glyph(0, df_glyph_special(1), 100, 200, 0), r->count);
    assert_true(r->strokes[0].t0 >= 500 * US);
    assert_int_equal(r->dpu.t, 515 * US);
    assert_int_equal(dpu_rig_reg(r, DF_DPC), 12);
    /* Both bad: two interrupts. START forgets the second character. */
    dpu_rig_init(r);
    LOAD(r, 0, 0100000, PAIR(0, 016), PAIR('A', 'B'), DF_STOP);
    dpu_rig_go(r, 0);
    df_dpu_write(&r->dpu, DF_DPC, 1, r->dpu.t);
    assert_int_equal(r->dpu.state, DF_WAITING_RESUME);
    assert_int_equal(r->event_count, 3);
    dpu_rig_go(r, 0);
    dpu_rig_go(r, 6);
    assert_int_equal(r->dpu.state, DF_STOPPED);
    df_dpu_write(&r->dpu, DF_DPC, 1, r->dpu.t);
    assert_int_equal(r->dpu.state, DF_RUNNING);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(low_byte_first),
        cmocka_unit_test(every_ascii_glyph),
        cmocka_unit_test(every_special_glyph),
        cmocka_unit_test(shift_in_ends_the_special_set),
        cmocka_unit_test(control_characters_move),
        cmocka_unit_test(moves_wrap),
        cmocka_unit_test(italics_slant),
        cmocka_unit_test(base_line_off_screen_is_not_drawn),
        cmocka_unit_test(dots_off_screen_stay_dark),
        cmocka_unit_test(dots_that_lean_off_screen_stay_dark),
        cmocka_unit_test(bad_shifted_out_code_interrupts),
        cmocka_unit_test(resume_draws_the_second_character),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
