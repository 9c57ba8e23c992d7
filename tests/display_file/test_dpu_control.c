/* One test per control word form of the VT11. */
#include "tests/support/dpu_rig.h"

static struct dpu_rig rig;
static struct dpu_rig *const r = &rig;

#define MPR_MODE_OF(op) ((op) << 11)

static void set_graphic_mode_selects_each_mode(void **state)
{
    (void)state;
    static const unsigned legal[] = {0, 1, 2, 3, 4, 5, 6};
    for (unsigned i = 0; i < sizeof legal / sizeof legal[0]; i++) {
        dpu_rig_init(r);
        LOAD(r, 0, (uint16_t)(0100000 | legal[i] << 11), DF_STOP);
        df_dpu_write(&r->dpu, DF_DPC, 0, 0);
        df_dpu_step(&r->dpu);
        assert_int_equal(r->dpu.mode, legal[i]);
        assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_MODE, MPR_MODE_OF(legal[i]));
        assert_int_equal(r->dpu.t, FETCH);
    }
}

static void set_graphic_mode_changes_only_what_its_enables_say(void **state)
{
    (void)state;
    dpu_rig_init(r);
    /* Everything on: intensity 7, pen, blink, dot-dash. */
    RUN(r, 0100000 | 02000 | 01600 | 0100 | 040 | 020 | 010 | 04 | 03);
    assert_int_equal(r->dpu.intensity, 7);
    assert_true(r->dpu.pen_interrupt);
    assert_true(r->dpu.blink);
    assert_int_equal(r->dpu.line_type, 3);
    /* Values without their enables change nothing. */
    RUN(r, 0100000 | 00400 | 010);
    RUN(r, 0104000);
    assert_int_equal(r->dpu.intensity, 7);
    assert_true(r->dpu.pen_interrupt && r->dpu.blink);
    assert_int_equal(r->dpu.line_type, 3);
    /* Enables without values clear. */
    RUN(r, 0100000 | 02000 | 0100 | 020 | 04);
    assert_int_equal(r->dpu.intensity, 0);
    assert_false(r->dpu.pen_interrupt || r->dpu.blink);
    assert_int_equal(r->dpu.line_type, 0);
}

static void set_graphic_mode_has_eight_intensities_and_four_lines(void **state)
{
    (void)state;
    dpu_rig_init(r);
    for (unsigned level = 0; level < 8; level++) {
        r->count = 0;
        RUN(r, (uint16_t)(0114000 | 02000 | level << 7), DF_BEAM_ON | 100, 100);
        assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_INTENSITY, level << 8);
        assert_int_equal(r->count, 1);
        assert_true(r->strokes[0].drive == (float)(0.3 + 0.1 * level));
    }
    for (unsigned type = 0; type < 4; type++) {
        RUN(r, (uint16_t)(0110000 | 04 | type));
        assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_LINE, type);
    }
}

static void set_graphic_mode_clears_shift_out(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0100000, 016);
    assert_true(r->dpu.shift_out);
    RUN(r, 0110000);
    assert_false(r->dpu.shift_out);
}

static void mode_140000_is_ignored(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0110000, 0100000, 016, 0140000 | 02000 | 0100 | 040 | 020 | 010 | 04 | 03);
    assert_int_equal(r->dpu.mode, DF_MODE_CHAR);
    assert_int_equal(r->dpu.intensity, 4);
    assert_true(r->dpu.shift_out);
    assert_false(r->dpu.blink || r->dpu.pen_interrupt || r->dpu.line_type);
    assert_int_equal(r->dpu.state, DF_STOPPED);
    assert_int_equal(dpu_rig_reg(r, DF_DPC), 10);
}

static void spare_words_hang(void **state)
{
    (void)state;
    static const uint16_t spare[] = {0134000, 0137777, 0144000, 0147777,
                                     0150000, 0153777, 0154000, 0157777};
    for (unsigned i = 0; i < sizeof spare / sizeof spare[0]; i++) {
        dpu_rig_init(r);
        LOAD(r, 0100, spare[i], DF_STOP);
        df_dpu_write(&r->dpu, DF_DPC, 0100, 0);
        for (uint64_t n = 1; n <= 1000; n++) {
            df_dpu_step(&r->dpu);
            assert_true(r->dpu.illegal);
            assert_int_equal(r->dpu.state, DF_RUNNING);
            assert_int_equal(dpu_rig_reg(r, DF_DPC), 0100);
            assert_int_equal(r->dpu.t, n * FETCH);
        }
        assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_MODE, spare[i] & DF_MPR_MODE);
        assert_int_equal(r->dpu.mode, DF_MODE_CHAR);
        assert_int_equal(r->event_count, 0);
        /* The CPU ends it, by START elsewhere … */
        LOAD(r, 0200, DF_STOP);
        df_dpu_write(&r->dpu, DF_DPC, 0200, r->dpu.t);
        assert_false(r->dpu.illegal);
        dpu_rig_continue(r);
        assert_int_equal(r->dpu.state, DF_STOPPED);
        assert_false(r->dpu.illegal);
        /* … or by changing the word. */
        df_dpu_write(&r->dpu, DF_DPC, 0100, r->dpu.t);
        df_dpu_step(&r->dpu);
        LOAD(r, 0100, 0164000);
        df_dpu_step(&r->dpu);
        assert_false(r->dpu.illegal);
        assert_int_equal(dpu_rig_reg(r, DF_DPC), 0102);
    }
}

static void jump_takes_the_next_word_as_address(void **state)
{
    (void)state;
    static const uint16_t forms[] = {0160000, 0161000, 0162777, 0163777};
    for (unsigned i = 0; i < sizeof forms / sizeof forms[0]; i++) {
        dpu_rig_init(r);
        LOAD(r, 0, forms[i], 0401); /* bit 0 is ignored */
        df_dpu_write(&r->dpu, DF_DPC, 0, 0);
        df_dpu_step(&r->dpu);
        assert_int_equal(dpu_rig_reg(r, DF_DPC), 2);
        df_dpu_step(&r->dpu);
        assert_int_equal(dpu_rig_reg(r, DF_DPC), 0400);
        assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_MODE, 060000);
        assert_int_equal(r->dpu.t, 2 * FETCH);
        assert_int_equal(r->dpu.words, 2);
        assert_int_equal(r->dpu.instructions, 1);
    }
}

static void jump_address_may_look_like_a_control_word(void **state)
{
    (void)state;
    dpu_rig_init(r);
    LOAD(r, 0, 0160000, DF_STOP); /* 172000 is even and in memory: an address, not a stop */
    LOAD(r, DF_STOP, 0164000, DF_STOP);
    dpu_rig_go(r, 0);
    assert_int_equal(r->dpu.state, DF_STOPPED);
    assert_int_equal(dpu_rig_reg(r, DF_DPC), DF_STOP + 4);
    assert_int_equal(r->dpu.words, 4);
}

static void nop_does_nothing(void **state)
{
    (void)state;
    static const uint16_t forms[] = {0164000, 0165000, 0166377, 0167777};
    for (unsigned i = 0; i < sizeof forms / sizeof forms[0]; i++) {
        dpu_rig_init(r);
        struct df_dpu before = r->dpu;
        LOAD(r, 0, forms[i]);
        df_dpu_write(&r->dpu, DF_DPC, 0, 0);
        df_dpu_step(&r->dpu);
        assert_int_equal(dpu_rig_reg(r, DF_DPC), 2);
        assert_int_equal(dpu_rig_reg(r, DF_MPR), (before.intensity << 8) | 064000);
        assert_int_equal(dpu_rig_reg(r, DF_XPR), 0);
        assert_int_equal(dpu_rig_reg(r, DF_YPR), 0);
        assert_int_equal(r->dpu.mode, before.mode);
    }
}

static void status_a_stops(void **state)
{
    (void)state;
    dpu_rig_init(r);
    LOAD(r, 0, 0172000);
    dpu_rig_go(r, 0);
    assert_int_equal(r->dpu.state, DF_STOPPED);
    assert_int_equal(dpu_rig_reg(r, DF_DPC), 2);
    assert_int_equal(dpu_rig_reg(r, DF_MPR), 0100000 | 070000 | 4 << 8);
    assert_int_equal(r->event_count, 0);
}

static void status_a_changes_only_what_its_enables_say(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0170000 | 01000 | 0400 | 0200 | 0100 | 040 | 020);
    assert_true(r->dpu.stop_interrupt && r->dpu.italics);
    assert_false(r->dpu.pen_intensify); /* 100 disables */
    assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_ITALICS, DF_MPR_ITALICS);
    RUN(r, 0170000);
    assert_true(r->dpu.stop_interrupt && r->dpu.italics && !r->dpu.pen_intensify);
    RUN(r, 0170000 | 01000 | 0200 | 040);
    assert_false(r->dpu.stop_interrupt || r->dpu.italics);
    assert_true(r->dpu.pen_intensify);
    RUN(r, 0170000 | 0400 | 0100 | 020);
    assert_false(r->dpu.stop_interrupt || r->dpu.italics);
    assert_true(r->dpu.pen_intensify);
}

static void status_a_without_stop_clears_the_stop_flag(void **state)
{
    (void)state;
    dpu_rig_init(r);
    LOAD(r, 0, DF_STOP, 0170000, 0170004);
    dpu_rig_go(r, 0);
    assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_STOP, DF_MPR_STOP);
    df_dpu_write(&r->dpu, DF_DPC, 1, r->dpu.t);
    assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_STOP, 0);
    dpu_rig_continue(r);
    assert_int_equal(r->dpu.state, DF_WAITING_SYNC);
}

static void status_a_has_one_sync_bit(void **state)
{
    (void)state;
    /* The VS60's other refresh bit and its menu bits mean nothing; bit 4 waits in any case. */
    for (unsigned bits = 0; bits < 020; bits++) {
        dpu_rig_init(r);
        LOAD(r, 0, (uint16_t)(0170000 | bits), DF_STOP);
        unsigned mpr = dpu_rig_reg(r, DF_MPR);
        df_dpu_write(&r->dpu, DF_DPC, 0, 0);
        df_dpu_step(&r->dpu);
        assert_int_equal(r->dpu.state, bits & 4 ? DF_WAITING_SYNC : DF_RUNNING);
        assert_int_equal(dpu_rig_reg(r, DF_MPR), mpr | 070000);
    }
}

static void stop_words_with_spare_bits_are_stops(void **state)
{
    (void)state;
    /* What the handlers of RT-11 tell apart: DJSR or DRET, DSTAT, DHALT, DNAME. */
    static const uint16_t words[] = {0173400, 0173420, 0173500, 0173520};
    for (unsigned i = 0; i < sizeof words / sizeof words[0]; i++) {
        dpu_rig_init(r);
        LOAD(r, 0, words[i], 01234);
        dpu_rig_go(r, 0);
        assert_int_equal(r->dpu.state, DF_STOPPED);
        assert_int_equal(r->event_count, 1);
        assert_int_equal(r->events[0].line, DF_INT_STOP);
        assert_int_equal(dpu_rig_reg(r, DF_DPC), 2); /* where the handler finds its operand */
        assert_false(r->dpu.italics);
        assert_true(r->dpu.pen_intensify);
    }
}

static void status_b_sets_the_step(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0174000 | 0100 | 077);
    assert_int_equal(r->dpu.step, 077);
    assert_int_equal(dpu_rig_reg(r, DF_XPR), 0176000);
    RUN(r, 0174000 | 012); /* no enable */
    assert_int_equal(r->dpu.step, 077);
    RUN(r, 0174000 | 0100 | 025);
    assert_int_equal(dpu_rig_reg(r, DF_XPR), 025 << 10);
    RUN(r, 0174000 | 0100);
    assert_int_equal(dpu_rig_reg(r, DF_XPR), 0);
    /* The VS60's Load Status BB and colour are Load Status B here. */
    RUN(r, 0176000 | 0100 | 031);
    assert_int_equal(r->dpu.step, 031);
    RUN(r, 0177677);
    assert_int_equal(r->dpu.step, 031);
}

static void control_word_drops_half_a_datum(void **state)
{
    (void)state;
    static const uint16_t between[] = {0164000, 0140000, 0174000, 0110000, 0170000};
    for (unsigned i = 0; i < sizeof between / sizeof between[0]; i++) {
        dpu_rig_init(r);
        /* After the control word 30, 40 is a datum of its own; 20 was dropped. */
        RUN(r, 0110000, DF_BEAM_ON | 20, between[i], DF_BEAM_ON | 30, 40);
        assert_int_equal(r->count, 1);
        dpu_rig_expect_stroke(r, 0, 0, 0, 30, 40);
        assert_int_equal(r->strokes[0].source, 6);
    }
    /* A jump drops it as well. */
    dpu_rig_init(r);
    LOAD(r, 0, 0110000, DF_BEAM_ON | 20, 0160000, 0100);
    LOAD(r, 0100, DF_BEAM_ON | 5, 6, DF_STOP);
    dpu_rig_go(r, 0);
    assert_int_equal(r->count, 1);
    dpu_rig_expect_stroke(r, 0, 0, 0, 5, 6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(set_graphic_mode_selects_each_mode),
        cmocka_unit_test(set_graphic_mode_changes_only_what_its_enables_say),
        cmocka_unit_test(set_graphic_mode_has_eight_intensities_and_four_lines),
        cmocka_unit_test(set_graphic_mode_clears_shift_out),
        cmocka_unit_test(mode_140000_is_ignored),
        cmocka_unit_test(spare_words_hang),
        cmocka_unit_test(jump_takes_the_next_word_as_address),
        cmocka_unit_test(jump_address_may_look_like_a_control_word),
        cmocka_unit_test(nop_does_nothing),
        cmocka_unit_test(status_a_stops),
        cmocka_unit_test(status_a_changes_only_what_its_enables_say),
        cmocka_unit_test(status_a_without_stop_clears_the_stop_flag),
        cmocka_unit_test(status_a_has_one_sync_bit),
        cmocka_unit_test(stop_words_with_spare_bits_are_stops),
        cmocka_unit_test(status_b_sets_the_step),
        cmocka_unit_test(control_word_drops_half_a_datum),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
