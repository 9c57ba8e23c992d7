/* Beam-penetration colour in closed forms: light of the layers, spot, place, colours; what is refused. */
#include <string.h>

#include "crt/penetration.h"
#include "crt/srgb.h"
#include "crt/tube.h"
#include "tests/support/penetration_model.h"
#include "tests/support/tube_model.h"

/* ---- closed forms ------------------------------------------------------------------------------ */

static void voltages_follow_their_law(void **state)
{
    (void)state;
    for (int n = 0; n < LEVELS; n++) {
        struct crt_voltage v = crt_voltage_at(row(), p49(), levels[n]);
        double y[2];
        layers(n, y);
        /* Terms bring the colour's share of the luminous energy with them. */
        assert_true(fabs(v.light[0] * 0.375 - y[0]) < 1e-14);
        assert_true(fabs(v.light[1] * 0.625 - y[1]) < 1e-14);
        assert_true(v.light[2] == 0);
        near(v.sigma, sqrt(12 / kv[n]), 1e-15);
        near(v.place, 1 + 0.005 * (sqrt(12 / kv[n]) - 1), 1e-15);
    }
    struct crt_voltage only = crt_voltage_at(row(), p49(), CRT_LEVEL_ONLY),
                       green = crt_voltage_at(row(), p49(), CRT_LEVEL_GREEN);
    assert_memory_equal(&only, &green, sizeof only);
    assert_true(green.sigma == 1 && green.place == 1);
}

static void a_voltage_below_the_dead_one_gives_no_light(void **state)
{
    (void)state;
    struct crt_tube_row dim = *row();
    dim.kv_dead.value = 7;
    for (int n = 0; n < LEVELS; n++) {
        struct crt_voltage v = crt_voltage_at(&dim, p49(), levels[n]);
        double energy = 0.625 * (v.light[0] + v.light[1]); /* of both layers */
        near(energy + 1, 1 + (n == 0 ? 0 : pow((kv[n] - 7) / 5, 1.7)), 1e-12);
    }
}

/* The same weights whatever the terms are: each layer has what its colour's share says. */
static void shares_of_many_terms_add_up(void **state)
{
    (void)state;
    static const double w[] = {0.1, 0.3, 0.2, 0.4}, tau[] = {0.1, 0.5, 2, 30};
    struct crt_phosphor p = model_phosphor(4, w, tau);
    p.colours = 2;
    p.term[1].colour = p.term[3].colour = 1;
    struct crt_voltage v = crt_voltage_at(row(), &p, CRT_LEVEL_ORANGE);
    double energy = pow(0.6, 1.7);
    near(v.light[0] * 0.3, energy * 20 / 27 * 0.3 / 0.7, 1e-13);
    near(v.light[1] * 0.7, energy * 7 / 27, 1e-13);
}

/* Chromaticities go from the red primary over orange and yellow to the green one; on a screen of
 * sRGB the ratio of green to red at least doubles each time. */
static void four_colours_are_distinct(void **state)
{
    (void)state;
    const struct crt_chromaticity *primary = p49()->colour;
    double last_x = 1, last_ratio = 0;
    for (int n = 0; n < LEVELS; n++) {
        struct crt_voltage v = crt_voltage_at(row(), p49(), levels[n]);
        double yr = v.light[0] * 0.375, yg = v.light[1] * 0.625;
        double sr = yr / primary[0].y, sg = yg / primary[1].y; /* X + Y + Z */
        double x = (sr * primary[0].x + sg * primary[1].x) / (sr + sg);
        double y = (yr + yg) / (sr + sg), rgb[3];
        struct crt_chromaticity c = {x, y};
        crt_srgb_of(c, rgb);
        double ratio = fmax(rgb[1], 0) / fmax(rgb[0], 1e-3);
        print_message("# %-6s %4g kV: %5.3f of green's luminance, x %.3f y %.3f\n",
                      crt_level_name(levels[n]), kv[n], yr + yg, x, y);
        /* On the straight line between the primaries, in order. */
        double along = (primary[0].x - x) / (primary[0].x - primary[1].x);
        near(y, primary[0].y + along * (primary[1].y - primary[0].y), 1e-12);
        assert_true(x < last_x - 0.05);
        if (n > 0)
            assert_true(ratio > 2 * last_ratio);
        last_x = x;
        last_ratio = ratio;
        if (n == 1) /* orange: near 595 nm; yellow: 570 nm, which sRGB's yellow is, too */
            assert_true(x > 0.55 && x < 0.62 && y > 0.37 && y < 0.43);
        if (n == 2)
            assert_true(x > 0.40 && x < 0.47 && y > 0.49 && y < 0.55);
        assert_true(yr + yg > 0.1); /* and none is too dark to be seen beside the others */
    }
}

static void levels_have_names(void **state)
{
    (void)state;
    static const char *const names[LEVELS] = {"red", "orange", "yellow", "green"};
    for (int n = 0; n < LEVELS; n++) {
        assert_string_equal(crt_level_name(levels[n]), names[n]);
        assert_int_equal(crt_level_named(names[n]), levels[n]);
    }
    assert_int_equal(crt_level_named("only"), CRT_LEVEL_ONLY);
    assert_int_equal(crt_level_named("blue"), CRT_LEVEL_ONLY);
    assert_int_equal(crt_level_named(""), CRT_LEVEL_ONLY);
}

/* ---- what cannot be ---------------------------------------------------------------------------- */

static void voltages_must_rise(void **state)
{
    (void)state;
    struct crt_error err;
    struct crt_tube_row good = *row();
    assert_true(crt_tube_check(&good, &err));
    const struct {
        size_t figure;
        double value;
    } cases[] = {{offsetof(struct crt_tube_row, kv_red), 8.5},
                 {offsetof(struct crt_tube_row, kv_orange), 10.5},
                 {offsetof(struct crt_tube_row, kv_yellow), 7},
                 {offsetof(struct crt_tube_row, kv_yellow), 13},
                 {offsetof(struct crt_tube_row, kv_green), 9},
                 {offsetof(struct crt_tube_row, kv_dead), 12}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct crt_tube_row bad = good;
        struct crt_figure *f = (struct crt_figure *)(void *)((char *)&bad + cases[i].figure);
        *f = (struct crt_figure){cases[i].value, cases[i].value, cases[i].value, "test"};
        assert_false(crt_tube_check(&bad, &err));
        assert_non_null(strstr(err.text, "they must rise"));
    }
    good.kv_red = good.kv_orange = good.kv_yellow =
        (struct crt_figure){6, 6, 6, "equal ones may be"};
    assert_true(crt_tube_check(&good, &err));
}

static void a_phosphor_of_one_layer_is_refused(void **state)
{
    (void)state;
    struct crt_error err;
    struct crt_tube_desc desc = {.row = row(),
                                 .phosphor = crt_phosphor_find("P31"),
                                 .grid = crt_tube_grid(row()),
                                 .epoch = {60, 1},
                                 .knobs = {0, 1, 0},
                                 .threads = 1};
    assert_null(crt_tube_create(&desc, &err));
    assert_string_equal(err.text, "tube PENET17 needs a phosphor of two layers, such as P49; P31 "
                                  "has 1 colour");
    assert_true(crt_penetration_fits(row(), p49(), &err));
    assert_true(crt_penetration_fits(crt_tube_row_find("VR17"), crt_phosphor_find("P31"), &err));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(voltages_follow_their_law),
        cmocka_unit_test(a_voltage_below_the_dead_one_gives_no_light),
        cmocka_unit_test(shares_of_many_terms_add_up),
        cmocka_unit_test(four_colours_are_distinct),
        cmocka_unit_test(levels_have_names),
        cmocka_unit_test(voltages_must_rise),
        cmocka_unit_test(a_phosphor_of_one_layer_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
