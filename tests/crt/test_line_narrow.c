/* Scan lines much narrower or wider than any screen, as only a forged snapshot can hold, cost neither time
 * nor memory. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <string.h>

#include "crt/tube.h"
#include "tests/support/line_model.h"
#include "tests/support/tube_model.h"

#define DOTS 4096

/* Light stored after one line of white. */
static double stored(double width_mm, int dots)
{
    static uint8_t white[DOTS];
    static const double w[] = {1}, tau[] = {65};
    struct crt_tube_row row = line_model_row(40, 30, 0.5);
    struct crt_phosphor phosphor = model_phosphor(1, w, tau);
    struct crt_error err;
    struct crt_tube_desc desc = {.row = &row,
                                 .phosphor = &phosphor,
                                 .grid = {64, 64, 0.25, -8, 8},
                                 .epoch = {60, 1},
                                 .knobs = {0, 1, 0},
                                 .threads = 1};
    struct crt_tube *tube = crt_tube_create(&desc, &err);
    assert_non_null(tube);
    memset(white, 255, sizeof white);
    struct crt_scan_line line = {
        .t0 = 1000, .t1 = 30000000, .dots = dots, .guns = 1, .drive = {white}};
    line.x0 = (float)(-width_mm / 2);
    line.x1 = (float)(width_mm / 2);
    crt_tube_scan_line(tube, &line);
    crt_tube_advance(tube, CRT_PS_PER_S / 50);
    double sum = crt_tube_totals(tube).stored;
    assert_true(crt_tube_intact(tube, &err));
    crt_tube_destroy(tube);
    return sum;
}

static void lines_of_no_screen_cost_nothing(void **state)
{
    (void)state;
    assert_true(stored(1, DOTS) > 0); /* the narrowest screen there is */
    assert_true(stored(1e-30, 1) == 0);
    assert_true(stored(1e-3, DOTS) == 0);
    assert_true(stored(1e30, DOTS) >= 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines_of_no_screen_cost_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
