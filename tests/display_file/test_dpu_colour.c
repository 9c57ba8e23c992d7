/* The VS60's colours: what sets them, how long a change takes, what strokes carry; and the VT11, on
 * which nothing of it happens. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/support/dpu_rig.h"

#define SWITCH (100 * US)
#define COLOUR 0175000 /* Load Status B, change colour */
#define GREEN  (COLOUR | 0000)
#define YELLOW (COLOUR | 0200)
#define ORANGE (COLOUR | 0400)
#define RED    (COLOUR | 0600)
#define POINT  0114000
#define DOT(n) DF_BEAM_ON | (n), (n)
#define DOT_PS (2 * FETCH + 1 * US) /* and its settling */

static struct dpu_rig *r;

static void start(enum df_personality personality)
{
    dpu_rig_init(r);
    r->desc.personality = personality;
    r->desc.timing.colour_switch_ps = SWITCH;
    dpu_rig_restart(r);
}

static unsigned scr(void)
{
    return dpu_rig_reg(r, DF_SCR);
}

static void words_set_the_colour_of_strokes(void **state)
{
    (void)state;
    start(DF_VS60);
    RUN(r, POINT, DOT(10), RED, DOT(10), YELLOW, DOT(10), ORANGE, DOT(10), GREEN, DOT(10));
    const enum crt_level expected[] = {CRT_LEVEL_GREEN, CRT_LEVEL_RED, CRT_LEVEL_YELLOW,
                                       CRT_LEVEL_ORANGE, CRT_LEVEL_GREEN};
    assert_int_equal(r->count, 5);
    for (int i = 0; i < 5; i++)
        assert_int_equal(r->strokes[i].level, expected[i]);
}

/* Points, vectors and their dashes, characters: all that is lit. */
static void every_kind_of_stroke_carries_it(void **state)
{
    (void)state;
    start(DF_VS60);
    RUN(r, ORANGE, POINT, DOT(100), 0110000 | DF_SGM_LINE | DF_LINE_DOTDASH, DF_BEAM_ON | 90, 5,
        0104000, DF_BEAM_ON | 010 << DF_SHORT_DX_SHIFT | 7, 0130000,
        DF_BEAM_ON | 010 << DF_SHORT_DX_SHIFT | 7, 0120000, 300, 0124000, 300, 0100000,
        'A' | 'B' << 8);
    assert_true(r->count > 40);
    for (size_t i = 0; i < r->count; i++)
        assert_int_equal(r->strokes[i].level, CRT_LEVEL_ORANGE);
}

/* changes × 100 µs, and nothing for what is set already. */
static void changes_take_their_time(void **state)
{
    (void)state;
    start(DF_VS60);
    RUN(r, POINT, GREEN, DOT(10), RED, RED, RED | DF_LSB_STEP | 5, DOT(10), YELLOW, DOT(10));
    assert_int_equal(r->dpu.t, 6 * FETCH + 3 * DOT_PS + 2 * SWITCH + FETCH /* stop */ + 1 * US +
                                   10 * 18 * NS + 2 * (1 * US));
    assert_int_equal(r->dpu.step, 5);
    assert_int_equal(r->dpu.words, 13);
    assert_int_equal(r->dpu.instructions, 10);
}

static void the_beam_is_off_meanwhile(void **state)
{
    (void)state;
    start(DF_VS60);
    RUN(r, POINT, DOT(10), RED, DOT(10));
    assert_int_equal(r->count, 2);
    assert_int_equal(r->strokes[1].t0 - r->strokes[0].t1, FETCH + SWITCH + 2 * FETCH + 1 * US);
    assert_int_equal(r->dpu.usage.lit_ps, 2 * US);
    assert_int_equal(r->dpu.usage.colours, 1);
}

static void without_a_switch_time_it_costs_nothing(void **state)
{
    (void)state;
    start(DF_VS60);
    r->desc.timing.colour_switch_ps = 0;
    dpu_rig_restart(r);
    RUN(r, RED, GREEN, RED, YELLOW);
    assert_int_equal(r->dpu.t, 5 * FETCH);
    assert_int_equal(r->dpu.colour, DF_COLOUR_YELLOW);
    assert_int_equal(r->dpu.usage.colours, 4);
}

/* Every instruction takes the average, also those that change the colour. */
static void average_mode_charges_no_more(void **state)
{
    (void)state;
    start(DF_VS60);
    r->desc.timing.average_ps = 33 * US;
    dpu_rig_restart(r);
    RUN(r, POINT, RED, DOT(10), GREEN, DOT(10));
    assert_int_equal(r->dpu.t, 6 * 33 * US);
    assert_int_equal(r->strokes[0].level, CRT_LEVEL_RED);
    assert_int_equal(r->strokes[1].level, CRT_LEVEL_GREEN);
}

/* The bits 600 count only beside the one that says so. */
static void only_the_change_bit_changes(void **state)
{
    (void)state;
    start(DF_VS60);
    RUN(r, RED, 0174200, 0174000, 0174100 | 7);
    assert_int_equal(r->dpu.colour, DF_COLOUR_RED);
    assert_int_equal(r->dpu.step, 7);
    assert_int_equal(r->dpu.t, 5 * FETCH + SWITCH);
}

static void register_reset_and_start(void **state)
{
    (void)state;
    start(DF_VS60);
    assert_int_equal(scr(), 0);
    const uint16_t words[] = {YELLOW, ORANGE, RED, GREEN};
    const unsigned codes[] = {04, 010, 014, 0};
    for (int i = 0; i < 4; i++) {
        RUN(r, words[i]);
        assert_int_equal(scr(), codes[i]);
    }
    RUN(r, RED);
    dpu_rig_go(r, 0); /* START leaves it: no time for red again */
    uint64_t before = r->dpu.t;
    dpu_rig_go(r, 0);
    assert_int_equal(r->dpu.t - before, 2 * FETCH);
    assert_int_equal(scr(), 014);
    df_dpu_reset(&r->dpu, r->dpu.t);
    assert_int_equal(scr(), 0);
    assert_int_equal(r->dpu.colour, DF_COLOUR_GREEN);
    df_dpu_write(&r->dpu, DF_SCR, 0177777, r->dpu.t); /* nothing of it is written */
    assert_int_equal(scr(), 0);
}

static void a_vt11_knows_no_colours(void **state)
{
    (void)state;
    start(DF_VT11);
    RUN(r, POINT, RED, DOT(10), YELLOW | DF_LSB_STEP | 9, DOT(10), GREEN, DOT(10));
    assert_int_equal(r->dpu.t,
                     4 * FETCH + 3 * DOT_PS + FETCH + 1 * US + 10 * 18 * NS + 2 * (1 * US));
    for (size_t i = 0; i < 3; i++)
        assert_int_equal(r->strokes[i].level, CRT_LEVEL_ONLY);
    assert_int_equal(r->dpu.colour, DF_COLOUR_GREEN);
    assert_int_equal(r->dpu.usage.colours, 0);
    assert_int_equal(r->dpu.step, 9);
    assert_int_equal(scr(), 0);
}

/* Whatever the VS60 has besides is the VT11's. */
static void other_words_are_the_vt11s(void **state)
{
    (void)state;
    const uint16_t words[] = {0134000, 0144000, 0150000, 0154000};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        start(DF_VS60);
        LOAD(r, 0, words[i]);
        df_dpu_write(&r->dpu, DF_DPC, 0, 0);
        df_dpu_step(&r->dpu);
        assert_true(r->dpu.illegal && r->dpu.dpc == 0);
    }
}

/* A vector interrupted by the pen is finished in the colour that is set, and the spot has it. */
static void the_intensify_spot_has_the_colour(void **state)
{
    (void)state;
    start(DF_VS60);
    r->pen_at = FETCH + SWITCH + 4 * FETCH + 3 * US + 5 * US;
    RUN(r, RED, 0110000 | DF_SGM_PEN | DF_SGM_PEN_ON, DF_BEAM_ON | 200, 0);
    assert_int_equal(r->dpu.state, DF_WAITING_RESUME);
    df_dpu_write(&r->dpu, DF_DPC, 1, r->dpu.t);
    dpu_rig_continue(r);
    assert_int_equal(r->count, 3);
    for (size_t i = 0; i < r->count; i++)
        assert_int_equal(r->strokes[i].level, CRT_LEVEL_RED);
}

/* ---- snapshots --------------------------------------------------------------------------------- */

static struct crt_state saved(void)
{
    struct crt_state s;
    crt_state_save(&s);
    df_dpu_state(&r->dpu, &s);
    assert_false(s.failed);
    return s;
}

static bool loaded(const struct crt_state *from)
{
    struct crt_state s;
    crt_state_load(&s, from->out, from->size);
    df_dpu_state(&r->dpu, &s);
    return !s.failed;
}

static void a_snapshot_keeps_the_colour(void **state)
{
    (void)state;
    start(DF_VS60);
    RUN(r, ORANGE);
    struct crt_state s = saved(), back;
    RUN(r, RED);
    assert_true(loaded(&s));
    assert_int_equal(r->dpu.colour, DF_COLOUR_ORANGE);
    assert_int_equal(r->dpu.usage.colours, 1);
    uint64_t before = r->dpu.t;
    RUN(r, ORANGE);
    assert_int_equal(r->dpu.t - before, 2 * FETCH);
    /* A VT11 has no such state, but it has that of a green VS60. */
    start(DF_VT11);
    assert_false(loaded(&s));
    crt_state_free(&s);
    start(DF_VS60);
    RUN(r, RED, GREEN);
    back = saved();
    start(DF_VT11);
    assert_true(loaded(&back));
    crt_state_free(&back);
}

static int set_up(void **state)
{
    (void)state;
    r = calloc(1, sizeof *r);
    return r == NULL;
}

static int tear_down(void **state)
{
    (void)state;
    free(r);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(words_set_the_colour_of_strokes),
        cmocka_unit_test(every_kind_of_stroke_carries_it),
        cmocka_unit_test(changes_take_their_time),
        cmocka_unit_test(the_beam_is_off_meanwhile),
        cmocka_unit_test(without_a_switch_time_it_costs_nothing),
        cmocka_unit_test(average_mode_charges_no_more),
        cmocka_unit_test(only_the_change_bit_changes),
        cmocka_unit_test(register_reset_and_start),
        cmocka_unit_test(a_vt11_knows_no_colours),
        cmocka_unit_test(other_words_are_the_vt11s),
        cmocka_unit_test(the_intensify_spot_has_the_colour),
        cmocka_unit_test(a_snapshot_keeps_the_colour),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
