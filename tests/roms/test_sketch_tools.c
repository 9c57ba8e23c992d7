/* The drawing program's tools (roms/sketch/tools.h) as a hand uses them: pressing and dragging, pressing
 * twice, leaving off, commands in any order; and what the history makes of it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

#include "roms/geometry/scalar.c"
#include "roms/sketch/constraint.c"
#include "roms/sketch/drawing.c"
#define length expand_length
#include "roms/sketch/expand.c"
#undef length
#define take select_take
#include "roms/sketch/select.c"
#undef take
#define take snap_take
#include "roms/sketch/snap.c"
#undef take
#define count subpicture_count
#define uses  subpicture_uses
#include "roms/sketch/subpicture.c"
#undef count
#undef uses
#include "roms/sketch/tools.c"
#include "roms/sketch/tools_move.c"
#define begin place_begin
#include "roms/sketch/tools_place.c"
#undef begin
#include "roms/sketch/undo.c"

static struct tools t;
static uint32_t seed = 1;
static bool down;

static uint32_t below(uint32_t limit)
{
    seed = seed * 1664525u + 1013904223u;
    return (uint32_t)((uint64_t)seed * limit >> 32);
}

static void setup_tools(void)
{
    tools_begin(&t);
    down = false;
}

/* ---- a hand ---------------------------------------------------------------------------------- */

static void point(int x, int y, bool pressed, bool upright)
{
    struct pointing p = {.at = {x * PLACE_UNIT, y * PLACE_UNIT},
                         .inside = true,
                         .pressed = pressed,
                         .pressed_now = pressed && !down,
                         .released_now = !pressed && down,
                         .upright = upright};
    down = pressed;
    tools_point(&t, &p);
}

static void drag(int x0, int y0, int x1, int y1)
{
    point(x0, y0, false, false);
    point(x0, y0, true, false);
    for (int i = 1; i <= 4; i++)
        point(x0 + (x1 - x0) * i / 4, y0 + (y1 - y0) * i / 4, true, false);
    point(x1, y1, false, false);
}

static void tap(int x, int y)
{
    point(x, y, false, false);
    point(x, y, true, false);
    point(x, y, false, false);
}

static int figures(unsigned kind)
{
    int count = 0;
    for (int i = 0; i < DRAWING_FIGURES; i++)
        count += t.drawing.now.figure[i].kind == kind;
    return count;
}

static int points(void)
{
    int count = 0;
    for (int i = 0; i < DRAWING_POINTS; i++)
        count += t.drawing.now.point[i].users != 0;
    return count;
}

static void assert_end(int figure, int end, int x, int y)
{
    struct place at = drawing_end_place(&t.drawing.now, figure, end);
    assert_int_equal(at.x, x * PLACE_UNIT);
    assert_int_equal(at.y, y * PLACE_UNIT);
}

/* ---- figures --------------------------------------------------------------------------------- */

static void test_dragging_and_pressing_twice_are_the_same(void **state)
{
    (void)state;
    static const enum command tools[] = {COMMAND_LINE, COMMAND_CIRCLE};
    for (int i = 0; i < 2; i++) {
        setup_tools();
        tools_command(&t, tools[i]);
        drag(80, 120, 321, 282);
        const struct drawing_state dragged = t.drawing.now;
        assert_int_equal(undo_depth(&t.undo), 1);
        setup_tools();
        tools_command(&t, tools[i]);
        tap(80, 120);
        point(200, 150, false, false);
        tap(321, 282);
        assert_memory_equal(&dragged, &t.drawing.now, sizeof dragged);
        assert_int_equal(undo_depth(&t.undo), 1);
        assert_end(0, 0, 80, 120);
        assert_end(0, 1, 320, 280);
    }
}

static void test_escape_leaves_nothing(void **state)
{
    (void)state;
    setup_tools();
    drag(80, 120, 320, 280);
    const struct drawing_state before = t.drawing.now;
    for (int tool = COMMAND_LINE; tool <= COMMAND_MOVE; tool++) {
        tools_command(&t, (enum command)tool);
        point(80, 120, true, false);
        point(400, 400, true, false);
        assert_memory_not_equal(&before, &t.drawing.now, sizeof before);
        tools_command(&t, COMMAND_ESCAPE);
        assert_memory_equal(&before, &t.drawing.now, sizeof before);
        point(400, 400, false, false);
        assert_memory_equal(&before, &t.drawing.now, sizeof before);
        assert_int_equal(undo_depth(&t.undo), 1);
    }
}

/* Undo takes back what is under way, and only then what was done before. */
static void test_undo_while_something_is_under_way(void **state)
{
    (void)state;
    setup_tools();
    drag(80, 120, 320, 280);
    tap(400, 400);
    point(480, 480, false, false);
    assert_int_equal(figures(FIGURE_LINE), 2);
    tools_command(&t, COMMAND_UNDO);
    assert_int_equal(figures(FIGURE_LINE), 1);
    tools_command(&t, COMMAND_UNDO);
    assert_int_equal(figures(FIGURE_LINE), 0);
}

/* Tools of one press alone: nothing comes of it. */
static void test_a_press_where_it_began_draws_nothing(void **state)
{
    (void)state;
    for (int tool = COMMAND_LINE; tool <= COMMAND_ARC; tool++) {
        setup_tools();
        tools_command(&t, (enum command)tool);
        tap(200, 200);
        tap(201, 199);
        assert_int_equal(points(), 0);
        assert_int_equal(undo_depth(&t.undo), 0);
    }
}

static void test_ends_are_shared(void **state)
{
    (void)state;
    setup_tools();
    drag(80, 120, 320, 280);
    drag(323, 283, 400, 400); /* a little off: it is drawn there */
    drag(400, 402, 81, 119);
    assert_int_equal(figures(FIGURE_LINE), 3);
    assert_int_equal(points(), 3);
    tools_command(&t, COMMAND_MOVE);
    drag(320, 280, 320, 480);
    assert_end(0, 1, 320, 480);
    assert_end(1, 0, 320, 480);
    /* Apart from each other, then dropped on each other. */
    tools_command(&t, COMMAND_LINE);
    drag(600, 600, 680, 680);
    assert_int_equal(points(), 5);
    tools_command(&t, COMMAND_MOVE);
    drag(600, 600, 320, 480);
    assert_int_equal(points(), 4);
    drag(320, 480, 200, 200);
    assert_end(3, 0, 200, 200);
    assert_end(1, 0, 200, 200);
}

static void test_a_chain_closes(void **state)
{
    (void)state;
    setup_tools();
    tools_command(&t, COMMAND_CHAIN);
    tap(80, 120);
    tap(320, 120);
    tap(320, 280);
    tap(80, 120);
    assert_int_equal(figures(FIGURE_LINE), 3);
    assert_int_equal(points(), 3);
    assert_int_equal(t.phase, PHASE_IDLE);
    tap(480, 480);
    tap(560, 480);
    tap(560, 481); /* there again: that is all */
    assert_int_equal(figures(FIGURE_LINE), 4);
    assert_int_equal(t.phase, PHASE_IDLE);
    /* Each line is a step. */
    tools_command(&t, COMMAND_UNDO);
    tools_command(&t, COMMAND_UNDO);
    assert_int_equal(figures(FIGURE_LINE), 2);
}

static void test_an_arc_takes_three_places(void **state)
{
    (void)state;
    setup_tools();
    tools_command(&t, COMMAND_ARC);
    drag(400, 400, 480, 400);
    point(420, 520, false, false);
    tap(400, 560);
    assert_int_equal(figures(FIGURE_ARC), 1);
    assert_end(0, 1, 480, 400);
    assert_end(0, 2, 400, 480); /* on its circle */
}

/* Figures smaller than gravity reaches can be made. */
static void test_small_figures(void **state)
{
    (void)state;
    setup_tools();
    tools_command(&t, COMMAND_NARROWER);
    tools_command(&t, COMMAND_NARROWER);
    drag(200, 200, 210, 200);
    tools_command(&t, COMMAND_CIRCLE);
    drag(200, 200, 200, 210);
    assert_int_equal(figures(FIGURE_LINE), 1);
    assert_int_equal(figures(FIGURE_CIRCLE), 1);
}

/* ---- constraints ----------------------------------------------------------------------------- */

static void test_upright_lines_stay_so(void **state)
{
    (void)state;
    setup_tools();
    point(80, 120, true, true);
    point(320, 150, true, true);
    point(320, 150, false, true);
    assert_int_equal(t.drawing.now.figure[0].constraint, CONSTRAINT_HORIZONTAL);
    tools_command(&t, COMMAND_UPRIGHT);
    drag(320, 120, 340, 400);
    assert_int_equal(t.drawing.now.figure[1].constraint, CONSTRAINT_VERTICAL);
    tools_command(&t, COMMAND_MOVE);
    for (int i = 0; i < 60; i++) {
        int figure = (int)below(2), end = (int)below(2);
        struct place at = drawing_end_place(&t.drawing.now, figure, end);
        drag(at.x / PLACE_UNIT, at.y / PLACE_UNIT, 40 + (int)below(800), 100 + (int)below(600));
        assert_int_equal(drawing_end_place(&t.drawing.now, 0, 0).y,
                         drawing_end_place(&t.drawing.now, 0, 1).y);
        assert_int_equal(drawing_end_place(&t.drawing.now, 1, 0).x,
                         drawing_end_place(&t.drawing.now, 1, 1).x);
        assert_int_equal(points(), 3);
    }
}

static void test_constraints_come_and_go(void **state)
{
    (void)state;
    setup_tools();
    drag(80, 120, 320, 200);
    tools_command(&t, COMMAND_HORIZONTAL);
    tap(200, 160);
    assert_end(0, 1, 320, 120);
    tools_command(&t, COMMAND_FREE);
    tap(200, 120);
    assert_int_equal(t.drawing.now.figure[0].constraint, CONSTRAINT_NONE);
    tools_command(&t, COMMAND_SELECT);
    tap(200, 120);
    assert_int_equal(t.selection.count, 1);
    tools_command(&t, COMMAND_VERTICAL); /* it would have no length */
    assert_true(t.message[0] != '\0');
    assert_end(0, 1, 320, 120);
    assert_int_equal(undo_depth(&t.undo), 3);
}

/* ---- selections, subpictures ----------------------------------------------------------------- */

static void test_a_box_takes_what_lies_in_it(void **state)
{
    (void)state;
    setup_tools();
    drag(80, 120, 320, 280);
    drag(400, 120, 640, 280);
    tools_command(&t, COMMAND_CIRCLE);
    drag(200, 520, 280, 520);
    tools_command(&t, COMMAND_SELECT);
    drag(60, 100, 500, 300); /* the first line, not the second */
    assert_int_equal(t.selection.count, 1);
    drag(130, 430, 300, 700); /* the circle reaches to 120 */
    assert_int_equal(t.selection.count, 1);
    drag(110, 430, 300, 700);
    assert_int_equal(t.selection.count, 2);
    tools_command(&t, COMMAND_MOVE);
    drag(80, 120, 120, 160); /* what is selected goes together */
    assert_end(0, 1, 360, 320);
    assert_end(2, 0, 240, 560);
    tools_command(&t, COMMAND_DELETE);
    assert_int_equal(figures(FIGURE_LINE), 1);
    assert_int_equal(figures(FIGURE_CIRCLE), 0);
    tools_command(&t, COMMAND_UNDO);
    assert_int_equal(figures(FIGURE_CIRCLE), 1);
}

struct counted {
    int lines;
    float last_x;
};

static void count_line(void *ctx, const struct stroke *stroke)
{
    struct counted *c = ctx;
    c->lines += stroke->kind == FIGURE_LINE;
    if (stroke->kind == FIGURE_LINE)
        c->last_x = stroke->at[1].x;
}

static void test_all_copies_change_with_their_subpicture(void **state)
{
    (void)state;
    struct counted c = {0};
    setup_tools();
    drag(80, 120, 160, 120);
    tools_command(&t, COMMAND_SELECT);
    tap(120, 120);
    tools_command(&t, COMMAND_DEFINE);
    assert_int_equal(t.master, 1);
    tools_command(&t, COMMAND_COPY);
    tools_command(&t, COMMAND_LARGER);
    tap(400, 400);
    point(600, 600, false, false); /* the next one is on its way */
    assert_int_equal(figures(FIGURE_COPY), 3);
    tools_command(&t, COMMAND_ESCAPE);
    assert_int_equal(figures(FIGURE_COPY), 2);
    expand_picture(&t.drawing.now, 0, count_line, &c);
    assert_int_equal(c.lines, 2);
    assert_float_equal(c.last_x, 400 + 1.1 * 80, 0.01);
    tools_command(&t, COMMAND_OPEN);
    assert_int_equal(t.picture, 1);
    tools_command(&t, COMMAND_LINE);
    drag(80, 120, 80, 200);
    tools_command(&t, COMMAND_MOVE);
    drag(160, 120, 200, 120);
    tools_command(&t, COMMAND_OPEN);
    assert_int_equal(t.picture, 0);
    c = (struct counted){0};
    expand_picture(&t.drawing.now, 0, count_line, &c);
    assert_int_equal(c.lines, 4);
    for (unsigned i = undo_depth(&t.undo); i > 0; i--)
        tools_command(&t, COMMAND_UNDO);
    assert_int_equal(points(), 0);
    assert_int_equal(t.picture, 0);
    assert_int_equal(t.master, 0);
}

/* ---- anything -------------------------------------------------------------------------------- */

static void check_drawing(void)
{
    const struct drawing_state *s = &t.drawing.now;
    uint16_t users[DRAWING_POINTS] = {0};
    for (int i = 0; i < DRAWING_FIGURES; i++) {
        const struct figure *f = &s->figure[i];
        for (int k = 0; k < figure_ends(f->kind); k++) {
            assert_int_equal(s->point[f->end[k]].picture, f->picture);
            users[f->end[k]]++;
        }
        struct place a = s->point[f->end[0]].at, b = s->point[f->end[1]].at;
        assert_true(f->constraint != CONSTRAINT_HORIZONTAL || a.y == b.y);
        assert_true(f->constraint != CONSTRAINT_VERTICAL || a.x == b.x);
    }
    for (int i = 0; i < DRAWING_POINTS; i++)
        assert_int_equal(users[i], s->point[i].users);
    assert_int_equal(t.undo.open, t.phase == PHASE_PLACING || t.phase == PHASE_MOVING);
    assert_true(t.picture == 0 || s->master[t.picture].used);
}

static void test_anything_can_be_taken_back(void **state)
{
    (void)state;
    for (uint32_t round = 1; round <= 12; round++) {
        seed = round * 101u;
        setup_tools();
        for (int i = 0; i < 600; i++) {
            uint32_t what = below(10);
            int x = (int)below(30) * 30, y = 80 + (int)below(24) * 30;
            if (what < 4)
                drag(x, y, (int)below(900), 80 + (int)below(700));
            else if (what < 6)
                tap(x, y);
            else if (what < 7)
                point(x, y, below(2) != 0, below(2) != 0);
            else if (what < 9)
                tools_command(&t, (enum command)below(COMMAND_TOOLS));
            else if (below(30) != 0)
                tools_command(&t,
                              (enum command)(COMMAND_TOOLS + below(COMMAND_CLEAR - COMMAND_TOOLS)));
            else
                tools_command(&t,
                              (enum command)(COMMAND_CLEAR + below(COMMAND_SAVE - COMMAND_CLEAR)));
            if (i % 7 == 0)
                check_drawing();
        }
        tools_command(&t, COMMAND_ESCAPE);
        while (undo_again(&t.undo))
            continue;
        const struct drawing_state latest = t.drawing.now;
        unsigned depth = undo_depth(&t.undo);
        for (unsigned i = 0; i < depth; i++) {
            tools_command(&t, COMMAND_UNDO);
            check_drawing();
        }
        if (depth < UNDO_STEPS - 2)
            assert_int_equal(points(), 0);
        for (unsigned i = 0; i < depth; i++)
            tools_command(&t, COMMAND_REDO);
        assert_memory_equal(&latest, &t.drawing.now, sizeof latest);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_dragging_and_pressing_twice_are_the_same),
        cmocka_unit_test(test_escape_leaves_nothing),
        cmocka_unit_test(test_undo_while_something_is_under_way),
        cmocka_unit_test(test_a_press_where_it_began_draws_nothing),
        cmocka_unit_test(test_ends_are_shared),
        cmocka_unit_test(test_a_chain_closes),
        cmocka_unit_test(test_an_arc_takes_three_places),
        cmocka_unit_test(test_small_figures),
        cmocka_unit_test(test_upright_lines_stay_so),
        cmocka_unit_test(test_constraints_come_and_go),
        cmocka_unit_test(test_a_box_takes_what_lies_in_it),
        cmocka_unit_test(test_all_copies_change_with_their_subpicture),
        cmocka_unit_test(test_anything_can_be_taken_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
