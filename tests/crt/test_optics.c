/* Electron optics: the square law, the directions of the guns, what rows without a mask have. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "crt/optics.h"

static bool near(double a, double b)
{
    return fabs(a - b) < 1e-9;
}

static void errors_grow_with_the_square(void **state)
{
    (void)state;
    struct crt_tube_row row = *crt_tube_row_find("COLOR17");
    struct crt_optics o;
    crt_optics_init(&o, &row);
    double w = row.width.value / 2, h = row.height.value / 2;
    for (double part = 0; part <= 1.2; part += 0.1) {
        double r2 = part * part;
        struct crt_beam_place at = crt_optics_at(&o, 2, part * w, -part * h);
        assert_true(near(at.spread, 1 + (row.spot_edge.value - 1) * r2));
        assert_true(near(at.dy, row.converge.value + row.converge_edge.value * r2));
        assert_true(near(at.dx, 0));
        assert_true(near(crt_optics_landing(&o, -part * w, part * h),
                         row.landing.value + row.landing_edge.value * r2));
    }
    /* The distance alone counts. */
    double diagonal = hypot(w, h);
    assert_true(near(crt_optics_at(&o, 1, diagonal, 0).spread, row.spot_edge.value));
    assert_true(near(crt_optics_at(&o, 1, 0, -diagonal).spread, row.spot_edge.value));
}

static void delta_guns_stand_in_a_triangle(void **state)
{
    (void)state;
    struct crt_tube_row row = *crt_tube_row_find("COLOR17");
    struct crt_optics o;
    crt_optics_init(&o, &row);
    static const double degrees[3] = {210, 330, 90};
    for (int gun = 0; gun < 3; gun++) {
        struct crt_beam_place at = crt_optics_at(&o, gun, 0, 0);
        double a = degrees[gun] * 3.14159265358979324 / 180;
        assert_true(near(at.dx, row.converge.value * cos(a)));
        assert_true(near(at.dy, row.converge.value * sin(a)));
    }
}

static void inline_guns_miss_sideways(void **state)
{
    (void)state;
    static const char *const tubes[] = {"SLOT14", "GRILLE17"};
    for (int t = 0; t < 2; t++) {
        struct crt_tube_row row = *crt_tube_row_find(tubes[t]);
        struct crt_optics o;
        crt_optics_init(&o, &row);
        for (int gun = 0; gun < 3; gun++) {
            struct crt_beam_place at = crt_optics_at(&o, gun, 0, 0);
            assert_true(near(at.dx, (gun - 1) * row.converge.value) && at.dy == 0);
        }
    }
}

static void one_gun_lands_where_it_should(void **state)
{
    (void)state;
    struct crt_optics o;
    crt_optics_init(&o, crt_tube_row_find("TV12M"));
    struct crt_beam_place at = crt_optics_at(&o, 0, 100, 50);
    assert_true(at.dx == 0 && at.dy == 0 && at.spread > 1.2);
    assert_true(crt_optics_landing(&o, 100, 50) == 0);
    crt_optics_init(&o, crt_tube_row_find("VR17"));
    at = crt_optics_at(&o, 0, 100, 50);
    assert_true(at.dx == 0 && at.dy == 0 && at.spread == 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_grow_with_the_square),
        cmocka_unit_test(delta_guns_stand_in_a_triangle),
        cmocka_unit_test(inline_guns_miss_sideways),
        cmocka_unit_test(one_gun_lands_where_it_should),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
