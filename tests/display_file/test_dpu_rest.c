/* The beam at rest at the ends of a vector: within the set-up, so that no vector takes longer. */
#include "tests/support/dpu_rig.h"

static struct dpu_rig rig;
static struct dpu_rig *const r = &rig;

#define REST (200 * NS)

/* A vector of 100 units from (10, 20), of a line type, without rests. */
static struct crt_stroke plain;
static uint64_t plain_end;

static void draw(uint64_t rest, unsigned type)
{
    r->desc.timing.vector_rest_ps = rest;
    dpu_rig_restart(r);
    RUN(r, 0114000, 10, 20, (uint16_t)(0110004 | type), DF_BEAM_ON | 100, 0);
}

static int set_up(void **state)
{
    (void)state;
    dpu_rig_init(r);
    draw(0, 0);
    plain = r->strokes[0];
    plain_end = r->dpu.t;
    return 0;
}

static void rests_lie_within_the_set_up(void **state)
{
    (void)state;
    draw(REST, 0);
    assert_int_equal(r->count, 3);
    dpu_rig_expect_stroke(r, 0, 10, 20, 10, 20);
    dpu_rig_expect_stroke(r, 1, 10, 20, 110, 20);
    dpu_rig_expect_stroke(r, 2, 110, 20, 110, 20);
    const uint64_t turns[] = {plain.t0 - 2 * REST, plain.t0 - REST, plain.t1 - REST, plain.t1};
    for (size_t i = 0; i < 3; i++) {
        assert_int_equal(r->strokes[i].t0, turns[i]);
        assert_int_equal(r->strokes[i].t1, turns[i + 1]);
        assert_true(r->strokes[i].drive == plain.drive);
        assert_int_equal(r->strokes[i].source, plain.source);
    }
    assert_int_equal(r->dpu.t, plain_end);
}

static void a_dark_end_stays_dark(void **state)
{
    (void)state;
    draw(REST, DF_LINE_DOTDASH); /* dark at its first unit and at its hundredth */
    assert_true(r->count > 3);
    assert_true(rig_x0(&r->strokes[0]) > 10.5);
    assert_true(rig_x1(&r->strokes[r->count - 1]) < 109.6);
    assert_int_equal(r->dpu.t, plain_end);
}

static void no_more_than_the_set_up(void **state)
{
    (void)state;
    draw(5 * US, 0);
    assert_int_equal(r->strokes[0].t0, plain.t0 - 2 * US);
    assert_int_equal(r->strokes[0].t1, plain.t0 - 1 * US);
    assert_int_equal(r->dpu.t, plain_end);
}

/* The pen fires while the beam rests before it moves: the hit is at the start, RESUME draws it all. */
static void the_pen_can_hit_a_rest(void **state)
{
    (void)state;
    r->desc.timing.vector_rest_ps = REST;
    dpu_rig_restart(r);
    uint64_t hit = plain.t0 - 2 * REST + 50 * NS;
    r->pen_at = hit;
    RUN(r, 0114000, 10, 20, 0110144, DF_BEAM_ON | 100, 0);
    assert_int_equal(r->dpu.state, DF_WAITING_RESUME);
    assert_int_equal(dpu_rig_reg(r, DF_XPR), 10);
    assert_int_equal(r->strokes[0].t1, hit);
    size_t before = r->count;
    df_dpu_write(&r->dpu, DF_DPC, 1, 1000 * US);
    assert_int_equal(r->count, before + 3);
    dpu_rig_expect_stroke(r, before, 10, 20, 10, 20);
    assert_int_equal(r->strokes[before].t1 - r->strokes[before].t0, REST - 50 * NS);
    dpu_rig_expect_stroke(r, before + 1, 10, 20, 110, 20);
    assert_int_equal(r->strokes[before + 2].t1, 1000 * US + 10 * US + 2 * REST - 50 * NS);
}

static void average_time_scales_them(void **state)
{
    (void)state;
    r->desc.timing.vector_rest_ps = REST;
    r->desc.timing.average_ps = 2 * (1500 * NS + 2 * US + 10 * US); /* the vector twice as slow */
    dpu_rig_restart(r);
    RUN(r, 0110000, DF_BEAM_ON | 100, 0);
    assert_int_equal(r->count, 3);
    uint64_t first = r->strokes[0].t1 - r->strokes[0].t0;
    uint64_t moving = r->strokes[1].t1 - r->strokes[1].t0;
    uint64_t last = r->strokes[2].t1 - r->strokes[2].t0;
    assert_true(first <= last && last <= first + 1);
    /* 10 µs moving to 0.2 µs at rest, to a few picoseconds of rounding */
    assert_true(moving / 50 <= first + 1 && first <= moving / 50 + 1);
    r->desc.timing.average_ps = 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rests_lie_within_the_set_up), cmocka_unit_test(a_dark_end_stays_dark),
        cmocka_unit_test(no_more_than_the_set_up),     cmocka_unit_test(the_pen_can_hit_a_rest),
        cmocka_unit_test(average_time_scales_them),
    };
    return cmocka_run_group_tests(tests, set_up, NULL);
}
