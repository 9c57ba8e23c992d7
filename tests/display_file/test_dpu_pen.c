/* The light pen: hit flag, latch, interrupt in mid-vector, RESUME, intensify spot. */
#include "tests/support/dpu_rig.h"

#include <stdlib.h>

#include "display_file/glyphs.h"

static struct dpu_rig rig;
static struct dpu_rig *const r = &rig;

#define PEN_ON  0140
#define PEN_OFF 0100

/* A horizontal vector of 100 units from (10, 20): 10 µs of beam from VECTOR_T0 on. */
static void load_vector(uint16_t enable)
{
    dpu_rig_init(r);
    LOAD(r, 0, 0114000, 10, 20, (uint16_t)(0110000 | enable), DF_BEAM_ON | 100, 0, 0164000,
         DF_STOP);
}

/* Point: 3 fetches, settle 1 + 20 · 0.018; vector: 3 fetches and set-up. */
#define VECTOR_T0 ((4500 + 1360 + 4500 + 2000) * NS)

static void no_pen_no_hit(void **state)
{
    (void)state;
    load_vector(PEN_ON);
    dpu_rig_go(r, 0);
    assert_int_equal(r->dpu.state, DF_STOPPED);
    assert_int_equal(r->count, 1);
    assert_int_equal(r->strokes[0].t0, VECTOR_T0);
    assert_int_equal(r->offered, 1);
    assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_HIT, 0);
}

static void hit_stops_in_mid_vector(void **state)
{
    (void)state;
    load_vector(PEN_ON);
    uint64_t hit = VECTOR_T0 + 3720 * NS; /* 37.2 units */
    r->pen_at = hit;
    dpu_rig_go(r, 0);
    assert_int_equal(r->dpu.state, DF_WAITING_RESUME);
    assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_HIT, DF_MPR_HIT);
    assert_int_equal(dpu_rig_reg(r, DF_DPC), 12); /* past the vector's words */
    assert_int_equal(dpu_rig_reg(r, DF_XPR), 47);
    assert_int_equal(dpu_rig_reg(r, DF_YPR), 20);
    assert_int_equal(r->event_count, 1);
    assert_int_equal(r->events[0].line, DF_INT_PEN);
    assert_true(r->events[0].level);
    assert_int_equal(r->events[0].t, hit);
    /* What was drawn, then the spot of 20 µs at level 7. */
    assert_int_equal(r->count, 2);
    dpu_rig_expect_stroke(r, 0, 10, 20, 47.2, 20);
    assert_int_equal(r->strokes[0].t1, hit);
    dpu_rig_expect_stroke(r, 1, 47.2, 20, 47.2, 20);
    assert_int_equal(r->strokes[1].t0, hit);
    assert_int_equal(r->strokes[1].t1, hit + 20 * US);
    assert_true(r->strokes[1].drive == 1.0f);
    assert_int_equal(r->dpu.t, hit + 20 * US);
}

static void resume_draws_the_rest_without_hits(void **state)
{
    (void)state;
    load_vector(PEN_ON);
    r->pen_at = VECTOR_T0 + 3720 * NS;
    dpu_rig_go(r, 0);
    r->pen_at = 1003 * US; /* would hit the rest */
    df_dpu_write(&r->dpu, DF_DPC, 1, 1000 * US);
    assert_int_equal(r->count, 3);
    dpu_rig_expect_stroke(r, 2, 47.2, 20, 110, 20);
    assert_int_equal(r->strokes[2].t0, 1000 * US);
    assert_int_equal(r->strokes[2].t1, 1000 * US + 6280 * NS);
    assert_int_equal(r->strokes[2].source, 8);
    assert_true(r->strokes[2].drive == r->strokes[0].drive);
    assert_int_equal(r->dpu.t, 1000 * US + 6280 * NS);
    assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_HIT, 0);
    assert_int_equal(dpu_rig_reg(r, DF_XPR), 110); /* no longer latched */
    assert_int_equal(r->event_count, 2);
    assert_false(r->events[1].level);
    dpu_rig_continue(r);
    assert_int_equal(r->dpu.state, DF_STOPPED);
    assert_int_equal(dpu_rig_reg(r, DF_DPC), 16);
}

static void resume_during_the_spot_waits_for_it(void **state)
{
    (void)state;
    load_vector(PEN_ON);
    uint64_t hit = VECTOR_T0 + 3720 * NS;
    r->pen_at = hit;
    dpu_rig_go(r, 0);
    df_dpu_write(&r->dpu, DF_DPC, 1, hit + 1 * US);
    assert_int_equal(r->strokes[2].t0, hit + 20 * US);
}

static void start_forgets_the_rest(void **state)
{
    (void)state;
    load_vector(PEN_ON);
    r->pen_at = VECTOR_T0 + 3720 * NS;
    dpu_rig_go(r, 0);
    dpu_rig_go(r, 12);
    assert_int_equal(r->count, 2);
    df_dpu_write(&r->dpu, DF_DPC, 1, r->dpu.t);
    dpu_rig_continue(r);
    assert_int_equal(r->count, 2);
    assert_int_equal(dpu_rig_reg(r, DF_XPR), 110);
}

static void hit_without_interrupt_only_sets_the_flag(void **state)
{
    (void)state;
    load_vector(PEN_OFF);
    uint64_t hit = VECTOR_T0 + 3720 * NS;
    r->pen_at = hit;
    dpu_rig_go(r, 0);
    assert_int_equal(r->dpu.state, DF_STOPPED);
    assert_int_equal(r->event_count, 0);
    assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_HIT, DF_MPR_HIT);
    assert_int_equal(dpu_rig_reg(r, DF_XPR), 110); /* nothing is latched for the program */
    assert_int_equal(r->count, 3);
    dpu_rig_expect_stroke(r, 2, 47.2, 20, 110, 20);
    assert_int_equal(r->strokes[2].t0, hit + 20 * US);
    assert_int_equal(r->strokes[2].t1, VECTOR_T0 + 30 * US);
    assert_int_equal(r->dpu.t, VECTOR_T0 + 30 * US + 2 * FETCH);
    /* START clears the flag. */
    df_dpu_write(&r->dpu, DF_DPC, 0, r->dpu.t);
    assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_HIT, 0);
}

static void intensify_can_be_turned_off(void **state)
{
    (void)state;
    load_vector(PEN_ON);
    LOAD(r, 020, 0170300, 0160000, 0);
    r->pen_at = VECTOR_T0 + 3 * FETCH + 3720 * NS;
    dpu_rig_go(r, 020);
    assert_int_equal(r->dpu.state, DF_WAITING_RESUME);
    assert_int_equal(r->count, 1);
    assert_int_equal(r->dpu.t, r->pen_at);
    df_dpu_write(&r->dpu, DF_DPC, 1, r->dpu.t);
    assert_int_equal(r->count, 2);
    assert_int_equal(r->strokes[1].t0, r->strokes[0].t1);
    assert_int_equal(r->strokes[1].t1 - r->strokes[0].t0, 10 * US);
}

static void latch_lies_on_the_line(void **state)
{
    (void)state;
    static const struct {
        int dx, dy;
        unsigned at; /* hundredths of a unit of the longer axis */
        int x, y;    /* by hand: major to nearest, minor of the line there to nearest */
    } cases[] = {
        {100, 30, 5049, 50, 15},   {100, 30, 5051, 51, 15}, /* 15.3 */
        {100, -30, 5500, 55, -17},                          /* −16.5: away from the start */
        {-100, 30, 5500, -55, 17}, {30, 100, 5500, 17, 55}, {-30, -100, 1000, -3, -10},
        {100, 99, 9999, 100, 99},  {100, 99, 0, 0, 0},      {3, 1, 200, 2, 1},
        {100, 0, 9949, 99, 0},
    };
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        int dx = cases[i].dx, dy = cases[i].dy;
        dpu_rig_init(r);
        LOAD(r, 0, 0114000, 500, 600, 0110000 | PEN_ON,
             (uint16_t)(DF_BEAM_ON | (dx < 0 ? 020000 - dx : dx)),
             (uint16_t)(dy < 0 ? 020000 - dy : dy), DF_STOP);
        /* Point: 600 units, 1 + 10.8 µs. */
        r->pen_at = (4500 + 11800 + 4500 + 2000) * NS + cases[i].at * NS;
        dpu_rig_go(r, 0);
        assert_int_equal(r->dpu.state, DF_WAITING_RESUME);
        assert_int_equal(dpu_rig_reg(r, DF_XPR), 500 + cases[i].x);
        assert_int_equal(dpu_rig_reg(r, DF_YPR), 600 + cases[i].y);
        /* The light ends where the beam is, not at a unit; the spot is there, too. */
        double part = cases[i].at / 100.0 / (abs(dx) > abs(dy) ? abs(dx) : abs(dy));
        double x = 500 + dx * part, y = 600 + dy * part;
        if (cases[i].at > 0)
            dpu_rig_expect_stroke(r, 0, 500, 600, x, y);
        dpu_rig_expect_stroke(r, cases[i].at > 0, x, y, x, y);
        df_dpu_write(&r->dpu, DF_DPC, 1, r->dpu.t);
        assert_int_equal(dpu_rig_reg(r, DF_XPR), 500 + dx);
    }
}

static void hit_at_the_very_start_draws_nothing_before_it(void **state)
{
    (void)state;
    load_vector(PEN_ON);
    r->pen_at = VECTOR_T0;
    dpu_rig_go(r, 0);
    assert_int_equal(r->count, 1); /* the spot alone */
    dpu_rig_expect_stroke(r, 0, 10, 20, 10, 20);
    df_dpu_write(&r->dpu, DF_DPC, 1, r->dpu.t);
    dpu_rig_expect_stroke(r, 1, 10, 20, 110, 20);
}

static uint64_t fires_at_the_end(void *ctx, const struct crt_stroke *s)
{
    (void)ctx;
    return s->t1;
}

static uint64_t fires_too_late(void *ctx, const struct crt_stroke *s)
{
    (void)ctx;
    return s->t1 + 1;
}

static void hit_at_the_very_end_leaves_nothing_to_draw(void **state)
{
    (void)state;
    load_vector(PEN_ON);
    r->desc.beam.offer = fires_at_the_end;
    dpu_rig_restart(r);
    dpu_rig_go(r, 0);
    assert_int_equal(r->dpu.state, DF_WAITING_RESUME);
    assert_int_equal(dpu_rig_reg(r, DF_XPR), 110);
    assert_int_equal(r->count, 2); /* all of it, the spot */
    dpu_rig_expect_stroke(r, 0, 10, 20, 110, 20);
    df_dpu_write(&r->dpu, DF_DPC, 1, 1000 * US);
    assert_int_equal(r->count, 2);
    assert_int_equal(r->dpu.t, 1000 * US);
    load_vector(PEN_ON);
    r->desc.beam.offer = fires_too_late;
    dpu_rig_restart(r);
    dpu_rig_go(r, 0);
    assert_int_equal(r->dpu.state, DF_STOPPED);
    assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_HIT, 0);
}

static void dashed_vector_goes_on_in_its_pattern(void **state)
{
    (void)state;
    load_vector(PEN_ON);
    LOAD(r, 6, 0110000 | PEN_ON | 04 | DF_LINE_LONG);
    r->pen_at = VECTOR_T0 + 4000 * NS; /* unit 40, in the second dash: 31.5 … 47.5 */
    dpu_rig_go(r, 0);
    assert_int_equal(r->count, 3);
    dpu_rig_expect_stroke(r, 0, 10, 20, 25.5, 20);
    dpu_rig_expect_stroke(r, 1, 41.5, 20, 50, 20);
    df_dpu_write(&r->dpu, DF_DPC, 1, 1000 * US);
    assert_int_equal(r->count, 6);
    dpu_rig_expect_stroke(r, 3, 50, 20, 57.5, 20);
    assert_int_equal(r->strokes[3].t0, 1000 * US);
    dpu_rig_expect_stroke(r, 4, 73.5, 20, 89.5, 20);
    assert_int_equal(r->strokes[4].t0, 1000 * US + 2350 * NS);
    dpu_rig_expect_stroke(r, 5, 105.5, 20, 110, 20);
    assert_int_equal(r->dpu.t, 1000 * US + 6000 * NS);
}

static void point_is_finished_before_the_stop(void **state)
{
    (void)state;
    dpu_rig_init(r);
    LOAD(r, 0, 0114000 | PEN_ON, DF_BEAM_ON, 0, DF_BEAM_ON | 5, 5, DF_STOP);
    uint64_t lit = (4500 + 1000) * NS;
    r->pen_at = lit + 400 * NS;
    dpu_rig_go(r, 0);
    assert_int_equal(r->dpu.state, DF_WAITING_RESUME);
    assert_int_equal(r->count, 3); /* 0.4 µs, spot, 0.6 µs */
    assert_int_equal(r->strokes[0].t1, r->pen_at);
    assert_int_equal(r->strokes[1].t1, r->pen_at + 20 * US);
    assert_int_equal(r->strokes[2].t1, lit + 21 * US);
    assert_int_equal(r->dpu.t, lit + 21 * US);
    assert_int_equal(dpu_rig_reg(r, DF_DPC), 6);
    assert_int_equal(r->events[0].t, r->dpu.t);
    df_dpu_write(&r->dpu, DF_DPC, 1, r->dpu.t);
    dpu_rig_continue(r);
    assert_int_equal(r->count, 4);
}

/* The time at which dot (column, row) of a block at the origin is lit, in the word at 8. */
static uint64_t block_dot(unsigned column, unsigned row)
{
    return (5 * 1500 + 1000 + 1800) * NS + 15 * US * (column * 8 + row) / 48;
}

static void load_blocks(void)
{
    dpu_rig_init(r);
    LOAD(r, 0, 0114000, 100, 100, 0100000 | PEN_ON, 0177 | 'H' << 8, DF_STOP);
}

static void first_and_last_columns_give_no_hits(void **state)
{
    (void)state;
    for (unsigned column = 0; column < 6; column++)
        for (unsigned row = 0; row < 8; row++) {
            const struct df_glyph *block = df_glyph_ascii(0177);
            if (!(block->column[column] >> row & 1))
                continue;
            load_blocks();
            r->pen_at = block_dot(column, row) + 100 * NS;
            dpu_rig_go(r, 0);
            bool inner = column >= 1 && column <= 4;
            assert_int_equal(r->dpu.state, inner ? DF_WAITING_RESUME : DF_STOPPED);
            assert_int_equal(r->event_count, inner);
            if (inner) {
                assert_int_equal(dpu_rig_reg(r, DF_XPR), 100 + 2 * column);
                assert_int_equal(dpu_rig_reg(r, DF_YPR) & DF_YPR_Y,
                                 100 + 2 * row - (block->descends ? 4 : 0));
                assert_int_equal(dpu_rig_reg(r, DF_YPR) >> 10, 077);
            }
        }
}

static void character_is_finished_and_resume_draws_the_second(void **state)
{
    (void)state;
    load_blocks();
    dpu_rig_go(r, 0);
    size_t all = r->count;
    uint64_t took = r->dpu.t;
    load_blocks();
    r->pen_at = block_dot(2, 3) + 100 * NS;
    dpu_rig_go(r, 0);
    assert_int_equal(r->dpu.state, DF_WAITING_RESUME);
    assert_int_equal(r->dpu.x, 114);
    assert_int_equal(dpu_rig_reg(r, DF_DPC), 10);
    df_dpu_write(&r->dpu, DF_DPC, 1, r->dpu.t);
    dpu_rig_continue(r);
    assert_int_equal(r->count, all + 2); /* the spot, and a dot in two parts */
    assert_int_equal(r->dpu.t, took + 20 * US);
    assert_int_equal(r->dpu.x, 128);
    for (size_t i = 1; i < r->count; i++)
        assert_true(r->strokes[i].t0 >= r->strokes[i - 1].t1);
}

static void pen_sees_every_piece_once(void **state)
{
    (void)state;
    load_blocks();
    dpu_rig_go(r, 0);
    assert_int_equal(r->offered, r->count);
    load_vector(PEN_OFF);
    r->pen_at = VECTOR_T0 + 50 * NS;
    dpu_rig_go(r, 0);
    /* The whole, the spot, the rest. */
    assert_int_equal(r->offered, 3);
}

static void without_a_pen_nothing_is_offered(void **state)
{
    (void)state;
    dpu_rig_init(r);
    r->desc.beam.offer = NULL;
    dpu_rig_restart(r);
    RUN(r, 0110000 | PEN_ON, DF_BEAM_ON | 100, 0, 0100000, 'A');
    assert_int_equal(r->offered, 0);
    assert_true(r->count > 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_pen_no_hit),
        cmocka_unit_test(hit_stops_in_mid_vector),
        cmocka_unit_test(resume_draws_the_rest_without_hits),
        cmocka_unit_test(resume_during_the_spot_waits_for_it),
        cmocka_unit_test(start_forgets_the_rest),
        cmocka_unit_test(hit_without_interrupt_only_sets_the_flag),
        cmocka_unit_test(intensify_can_be_turned_off),
        cmocka_unit_test(latch_lies_on_the_line),
        cmocka_unit_test(hit_at_the_very_start_draws_nothing_before_it),
        cmocka_unit_test(hit_at_the_very_end_leaves_nothing_to_draw),
        cmocka_unit_test(dashed_vector_goes_on_in_its_pattern),
        cmocka_unit_test(point_is_finished_before_the_stop),
        cmocka_unit_test(first_and_last_columns_give_no_hits),
        cmocka_unit_test(character_is_finished_and_resume_draws_the_second),
        cmocka_unit_test(pen_sees_every_piece_once),
        cmocka_unit_test(without_a_pen_nothing_is_offered),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
