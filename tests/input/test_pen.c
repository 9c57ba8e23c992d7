/* A light pen sees strokes, says when, and changes nothing when it is only asked. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <string.h>

#include "input/pen.h"

static const struct inp_pen_setup figures = {
#define X(field, unit, value, low, high, meaning, source) .field = {value, low, high, source},
    INP_PEN_FIGURES(X)
#undef X
};

static void make(struct inp_pen *pen, const char *tube, const char *phosphor)
{
    struct inp_pen_desc desc = {
        &figures, crt_tube_row_find(tube), crt_phosphor_find(phosphor), {0, 1, 0}, 1};
    inp_pen_init(pen, &desc);
    inp_hand_move(&pen->hand, (struct inp_place){0, 0, 0}, 0, 0);
}

static void sees_a_line_under_it(void **state)
{
    struct inp_pen pen, before;
    struct crt_stroke line = {1000000, 9000000, -10, 0, 10, 0, 1, 0, 0};
    struct crt_stroke aside = {1000000, 9000000, -10, 6, 10, 6, 1, 0, 0};
    uint64_t when = 0;
    (void)state;
    make(&pen, "VR17", "P31");
    memcpy(&before, &pen, sizeof pen);
    assert_true(inp_pen_looks(&pen));
    assert_true(inp_pen_offer(&pen, &aside) == INP_NEVER);
    uint64_t offered = inp_pen_offer(&pen, &line);
    assert_true(offered > line.t0 && offered < line.t1);
    assert_memory_equal(&before, &pen, sizeof pen);
    assert_true(inp_pen_stroke(&pen, &line, &when));
    assert_true(when == offered);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sees_a_line_under_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
