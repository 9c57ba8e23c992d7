/* Dashes and blink. */
#include "tests/support/dpu_rig.h"

#include <math.h>
#include <string.h>

#include "display_file/vecgen.h"

static struct dpu_rig rig;
static struct dpu_rig *const r = &rig;

/* Is a unit lit, by the line counter as the manual has it: 37 at the start, one down per unit. */
static bool counter_lights(unsigned type, unsigned unit)
{
    unsigned counter = (037u - unit) & 037u;
    bool b1 = counter & 2, b2 = counter & 4, b3 = counter & 010, b4 = counter & 020;
    switch (type) {
    case 1:
        return b4;
    case 2:
        return b3;
    case 3:
        return (b1 && b2 && !b3) || !b4;
    default:
        return true;
    }
}

static void patterns_follow_the_counter(void **state)
{
    (void)state;
    for (unsigned type = 0; type < 4; type++)
        for (unsigned unit = 0; unit < 32; unit++)
            assert_int_equal(df_line_patterns[type] >> unit & 1, counter_lights(type, unit));
}

/* Draws a horizontal vector of that length and type from x = 10 and tells which units are lit. */
static void lit_units(unsigned type, unsigned length, char *picture)
{
    dpu_rig_init(r);
    RUN(r, 0114000, 10, 10, (uint16_t)(0110004 | type), (uint16_t)(DF_BEAM_ON | length), 0);
    memset(picture, '.', length + 1);
    picture[length + 1] = 0;
    for (size_t i = 0; i < r->count; i++) {
        const struct crt_stroke *s = &r->strokes[i];
        for (unsigned u = 0; u <= length; u++)
            if (rig_x0(s) - 10 <= u + 0.01 && rig_x1(s) - 10 >= u - 0.01)
                picture[u] = '#';
    }
}

static void dashes_look_as_drawn(void **state)
{
    (void)state;
    char picture[1100];
    lit_units(0, 40, picture);
    assert_string_equal(picture, "#########################################");
    lit_units(1, 40, picture);
    assert_string_equal(picture, "################................#########");
    lit_units(2, 40, picture);
    assert_string_equal(picture, "########........########........########.");
    lit_units(3, 40, picture);
    assert_string_equal(picture, "........##......################........#");
}

static void dashes_of_every_length(void **state)
{
    (void)state;
    char picture[1100];
    for (unsigned type = 0; type < 4; type++)
        for (unsigned length = 1; length <= 1000; length += length < 70 ? 1 : 37) {
            lit_units(type, length, picture);
            for (unsigned u = 0; u <= length; u++)
                assert_int_equal(picture[u] == '#', counter_lights(type, u));
        }
}

static void dashes_begin_again_with_every_vector(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0110005, DF_BEAM_ON | 10, 0, DF_BEAM_ON | 0, 10);
    assert_int_equal(r->count, 2);
    dpu_rig_expect_stroke(r, 0, 0, 0, 10, 0);
    dpu_rig_expect_stroke(r, 1, 10, 0, 10, 10);
}

static void runs_end_half_way_between_units(void **state)
{
    (void)state;
    dpu_rig_init(r);
    /* From (10, 20), 40 units in x and −20 in y, long dash: units 0…15 and 32…40. */
    RUN(r, 0114000, 10, 20, 0110005, DF_BEAM_ON | 40, DF_SIGN_X | 20);
    assert_int_equal(r->count, 2);
    dpu_rig_expect_stroke(r, 0, 10, 20, 25.5, 20 - 7.75);
    dpu_rig_expect_stroke(r, 1, 41.5, 20 - 15.75, 50, 0);
    /* Time goes on through the gap: 0.1 µs a unit. */
    uint64_t t0 = r->strokes[0].t0;
    assert_int_equal(r->strokes[0].t1, t0 + 1550 * NS);
    assert_int_equal(r->strokes[1].t0, t0 + 3150 * NS);
    assert_int_equal(r->strokes[1].t1, t0 + 4000 * NS);
    assert_int_equal(r->dpu.t, r->strokes[1].t1 + FETCH);
}

static void dashes_count_along_the_longer_axis(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0114000, 10, 20, 0110006, DF_BEAM_ON | 10, 20);
    assert_int_equal(r->count, 2);
    dpu_rig_expect_stroke(r, 0, 10, 20, 13.75, 27.5);
    dpu_rig_expect_stroke(r, 1, 17.75, 35.5, 20, 40);
}

static void blinking_items_are_dark_every_other_266_ms(void **state)
{
    (void)state;
    static const struct {
        uint64_t ms;
        bool lit;
    } cases[] = {{0, true},   {265, true},   {267, false}, {531, false},
                 {533, true}, {1063, false}, {1065, true}};
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        dpu_rig_init(r);
        df_dpu_reset(&r->dpu, cases[i].ms * 1000 * US);
        RUN(r, 0110030, DF_BEAM_ON | 10, 10, 0114000, DF_BEAM_ON | 99, 99, 0100000, 'A', 0110020,
            DF_BEAM_ON | 10, 10);
        if (cases[i].lit) {
            assert_true(r->count > 8);
        } else {
            assert_int_equal(r->count, 1); /* the last vector does not blink */
            assert_int_equal(r->strokes[0].source, 022);
        }
        uint64_t took = r->dpu.t - cases[i].ms * 1000 * US;
        assert_int_equal(took, (12 * 1500 + 3000 + 1000 + 18 * 89 + 1000 + 15000 + 3000) * NS);
    }
}

static void level_zero_is_still_visible(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0112000, DF_BEAM_ON | 10, 10);
    assert_int_equal(r->count, 1);
    assert_true(r->strokes[0].drive == 0.30f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(patterns_follow_the_counter),
        cmocka_unit_test(dashes_look_as_drawn),
        cmocka_unit_test(dashes_of_every_length),
        cmocka_unit_test(dashes_begin_again_with_every_vector),
        cmocka_unit_test(runs_end_half_way_between_units),
        cmocka_unit_test(dashes_count_along_the_longer_axis),
        cmocka_unit_test(blinking_items_are_dark_every_other_266_ms),
        cmocka_unit_test(level_zero_is_still_visible),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
