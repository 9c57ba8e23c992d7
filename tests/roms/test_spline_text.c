/* What a person, and text, do to a drawing of roms/spline: points as text there and back, text of
 * any kind, drags, menu, keys. */
#include <math.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "roms/curves/b_spline.c"
#include "roms/curves/bezier.c"
#include "roms/curves/cubic.c"
#include "roms/curves/cubic_blending.c"
#include "roms/curves/cubic_matrix.c"
#include "roms/curves/spline.c"
#include "roms/curves/tridiagonal.c"
#include "roms/spline/curve.c"
#include "roms/spline/curve_kinds.c"
#include "roms/spline/editor.c"
#include "roms/spline/editor_touch.c"
#include "roms/spline/history.c"
#include "roms/spline/model.c"
#include "roms/spline/periodic.c"
#include "roms/spline/points_read.c"
#include "roms/spline/points_write.c"

#include "tests/roms/curves_support.h"
#include "tests/roms/spline_support.h"

/* A menu of two items above each other; the real one needs a stage. */
int menu_item_at(struct vector3 at)
{
    return at.x < 968 ? -1 : at.y > 400 ? 0 : 1;
}

int menu_key(int item)
{
    return item == 0 ? 'h' : 'u';
}

/* ---- text ---------------------------------------------------------------------------------------- */

struct text {
    char bytes[4096];
    size_t length;
};

static void put(void *ctx, const char *line)
{
    struct text *t = ctx;
    size_t length = strlen(line);
    assert_true(t->length + length < sizeof t->bytes);
    memcpy(t->bytes + t->length, line, length + 1);
    t->length += length;
}

static enum points_state read_all(struct points_reader *r, const char *bytes, size_t length)
{
    points_read_begin(r);
    for (size_t i = 0; i < length; i++)
        points_read(r, bytes[i]);
    return r->state;
}

static bool same_handles(const struct model_point *a, const struct model_point *b)
{
    return a->in.x == b->in.x && a->in.y == b->in.y && a->out.x == b->out.x && a->out.y == b->out.y;
}

static void models_come_back_from_their_text(void **state)
{
    (void)state;
    for (int i = 0; i < 500; i++) {
        struct model m;
        struct text t = {.length = 0};
        struct points_reader r;
        random_model(&m, (enum model_kind)(i % MODEL_KINDS), random_below(2), 40);
        m.parameter = (enum spline_parameter)random_below(3);
        model_follow(&m);
        points_write(&m, put, &t);
        assert_int_equal(read_all(&r, t.bytes, t.length), POINTS_DONE);
        assert_int_equal(r.model.kind, m.kind);
        assert_int_equal(r.model.parameter, m.parameter);
        assert_int_equal(r.model.closed, m.closed);
        assert_int_equal(r.model.count, m.count);
        for (int k = 0; k < m.count; k++) {
            assert_true(r.model.point[k].at.x == m.point[k].at.x);
            assert_true(r.model.point[k].at.y == m.point[k].at.y);
            assert_int_equal(r.model.point[k].joint, m.point[k].joint);
            assert_int_equal(r.model.point[k].own, m.point[k].own);
            assert_true(same_handles(&r.model.point[k], &m.point[k]));
        }
    }
}

static void lines_that_are_wrong_are_told(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        int line;
    } wrong[] = {
        {"spline 2\n", 1},
        {"point 100 100\n", 1},
        {"spline 1\nend 5\n", 2},
        {"spline 1\npoint 100\n", 2},
        {"spline 1\npoint 100 nan\n", 2},
        {"spline 1\npoint inf 100\n", 2},
        {"spline 1\npoint 1e99 100\n", 2},
        {"spline 1\npoint 0x40 100\n", 2},
        {"spline 1\npoint 100 100 c3\n", 2},
        {"spline 1\npoint 100 100 c1 1 2 3\n", 2},
        {"spline 1\npoint 100 100 c1 10 0 10 0\n", 2},
        {"spline 1\npoint 100 100 c1 10 0 -20 0\n", 2},
        {"spline 1\npoint 100 100 g1 10 0 -20 5\n", 2},
        {"spline 1\npoint 100 100 corner 9e9 0 0 0\n", 2},
        {"spline 1\n\n# remark\npoint 5 100\n", 4},
        {"spline 1\nkind bezier knots uniform ajar\n", 2},
        {"spline 1\nkind bezier knots uniform open\nkind natural knots uniform open\n", 3},
        {"spline 1\nkind bezier knots uniform open closed\n", 2},
        {"spline 1\npoints 100 100\n", 2},
    };
    static const char right[] = "\r\nspline 1 # points\r\n  kind   natural knots chordal closed\r\n"
                                "point 100 100 g1 -10 0 25 0\tend\n";
    struct points_reader r;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        if (read_all(&r, wrong[i].text, strlen(wrong[i].text)) != POINTS_WRONG)
            fail_msg("taken: %s", wrong[i].text);
        assert_int_equal(r.number, wrong[i].line);
        assert_non_null(r.trouble);
    }
    assert_int_equal(read_all(&r, right, sizeof right - 1),
                     POINTS_WRONG); /* end is on no line of its own */
    assert_int_equal(r.number, 4);
}

static void limits_of_lines_and_points(void **state)
{
    (void)state;
    char text[4000] = "spline 1\n";
    struct points_reader r;
    for (int i = 0; i <= MODEL_POINTS_MOST; i++)
        strcat(text, "point 100 100\n");
    assert_int_equal(read_all(&r, text, strlen(text)), POINTS_WRONG);
    assert_int_equal(r.number, MODEL_POINTS_MOST + 2);
    memset(text, ' ', POINTS_TEXT_LINE);
    strcpy(text + POINTS_TEXT_LINE, "\nspline 1\nend\n");
    assert_int_equal(read_all(&r, text, strlen(text)), POINTS_DONE);
    memset(text, ' ', POINTS_TEXT_LINE + 1);
    strcpy(text + POINTS_TEXT_LINE + 1, "\nspline 1\nend\n");
    assert_int_equal(read_all(&r, text, strlen(text)), POINTS_WRONG);
    assert_int_equal(read_all(&r, "spl\0", 4), POINTS_WRONG);
}

static void assert_valid(const struct model *m)
{
    assert_true(m->kind < MODEL_KINDS && m->parameter <= SPLINE_CENTRIPETAL);
    assert_in_range(m->count, 0, MODEL_POINTS_MOST);
    for (int i = 0; i < m->count; i++) {
        const struct model_point *p = &m->point[i];
        assert_true(p->at.x >= MODEL_LEFT && p->at.x <= MODEL_RIGHT);
        assert_true(p->at.y >= MODEL_BOTTOM && p->at.y <= MODEL_TOP);
        assert_true(p->joint < JOINTS);
        assert_true(vector3_length(p->in) <= MODEL_HANDLE_MOST * 1.001f);
        assert_true(vector3_length(p->out) <= MODEL_HANDLE_MOST * 1.001f);
    }
}

/* Text that was right, with bytes changed, doubled, left out. */
static void any_text_makes_a_valid_model_or_none(void **state)
{
    (void)state;
    static const char bytes[] = "0123456789.-+eE \n\r\t#apointsplinekd\0\xFF";
    int taken = 0, refused = 0;
    for (int i = 0; i < 4000; i++) {
        struct model m;
        struct text t = {.length = 0};
        struct points_reader r;
        random_model(&m, (enum model_kind)(i % MODEL_KINDS), false, 20);
        points_write(&m, put, &t);
        for (uint32_t k = random_below(4); k > 0; k--) {
            uint32_t at = random_below((uint32_t)t.length);
            if (random_below(3) == 0)
                memmove(t.bytes + at, t.bytes + at + 1, t.length-- - at);
            else
                t.bytes[at] = bytes[random_below(sizeof bytes)];
        }
        if (read_all(&r, t.bytes, t.length) == POINTS_DONE) {
            taken++;
            assert_valid(&r.model);
        } else {
            refused++;
        }
    }
    assert_true(taken > 800 && refused > 800);
}

/* ---- stylus and keys ----------------------------------------------------------------------------- */

static void press_at(struct editor *e, float x, float y)
{
    editor_touch(e, &(struct editor_touch){{x, y, 0}, true, true, true, false, false});
}

static void move_to(struct editor *e, float x, float y)
{
    editor_touch(e, &(struct editor_touch){{x, y, 0}, true, true, false, false, false});
}

static void lift_at(struct editor *e, float x, float y)
{
    editor_touch(e, &(struct editor_touch){{x, y, 0}, true, false, false, true, false});
}

static void a_drag_moves_a_point_and_is_one_step(void **state)
{
    (void)state;
    static struct editor e;
    editor_begin(&e);
    struct model before = e.model;
    struct vector3 at = e.model.point[2].at;
    press_at(&e, at.x + 5, at.y - 3); /* a little beside: it does not jump */
    for (int i = 1; i <= 10; i++)
        move_to(&e, at.x + 5 + 4 * (float)i, at.y - 3 - 7 * (float)i);
    lift_at(&e, at.x + 45, at.y - 73);
    move_to(&e, 300, 300); /* nothing is held any more */
    assert_true(e.model.point[2].at.x == at.x + 40 && e.model.point[2].at.y == at.y - 70);
    assert_int_equal(e.chosen, 2);
    editor_key(&e, 'u');
    assert_memory_equal(&e.model, &before, sizeof before);
    editor_key(&e, 'r');
    assert_true(e.model.point[2].at.x == at.x + 40);
}

/* A stylus that rests is measured here and there. */
static void a_tap_chooses_and_moves_nothing(void **state)
{
    (void)state;
    static struct editor e;
    editor_begin(&e);
    struct model before = e.model;
    struct vector3 at = e.model.point[4].at;
    press_at(&e, at.x, at.y);
    for (int i = 0; i < 50; i++)
        move_to(&e, at.x + random_in(-4, 4), at.y + random_in(-4, 4));
    lift_at(&e, at.x, at.y);
    assert_int_equal(e.chosen, 4);
    assert_memory_equal(&e.model, &before, sizeof before);
    assert_int_equal(e.history.back, 0);
}

static void touching_adds_where_the_polygon_is_near(void **state)
{
    (void)state;
    static struct editor e;
    editor_begin(&e);
    int count = e.model.count;
    struct vector3 a = e.model.point[1].at, b = e.model.point[2].at;
    press_at(&e, (a.x + b.x) / 2, (a.y + b.y) / 2);
    lift_at(&e, (a.x + b.x) / 2, (a.y + b.y) / 2);
    assert_int_equal(e.model.count, count + 1);
    assert_true(e.model.point[2].at.x == (a.x + b.x) / 2 && e.model.point[3].at.x == b.x);
    press_at(&e, 640, 700); /* far from all */
    lift_at(&e, 640, 700);
    assert_true(e.model.point[count + 1].at.x == 640);
    editor_touch(&e, &(struct editor_touch){{640, 700, 0}, true, false, false, false, true});
    assert_int_equal(e.model.count, count + 1); /* the second button deletes */
    press_at(&e, 1000, 500);                    /* the menu */
    assert_true(e.hull && e.model.count == count + 1);
}

static void handles_t_and_the_mark_are_dragged(void **state)
{
    (void)state;
    static struct editor e;
    struct curve c;
    editor_begin(&e);
    editor_key(&e, 'p');
    struct vector3 end = model_handle(&e.model, 2, true);
    press_at(&e, end.x, end.y);
    move_to(&e, end.x + 30, end.y + 40);
    lift_at(&e, end.x + 30, end.y + 40);
    struct model_point *p = &e.model.point[2];
    assert_true(p->own);
    assert_near(p->at.x + p->out.x, end.x + 30, 1e-3);
    assert_near(p->in.x, -p->out.x, 1e-3);
    press_at(&e, SLIDER_LEFT, SLIDER_Y);
    move_to(&e, (SLIDER_LEFT + SLIDER_RIGHT) / 2.0f, SLIDER_Y);
    lift_at(&e, (SLIDER_LEFT + SLIDER_RIGHT) / 2.0f, SLIDER_Y);
    assert_near(e.part, 0.5, 1e-3);
    assert_null(curve_of(&e.model, &c));
    struct vector3 from = curve_at(&c, curve_t(&c, 0.5f)).at,
                   to = curve_at(&c, curve_t(&c, 0.6f)).at;
    press_at(&e, from.x, from.y + 1);
    move_to(&e, to.x, to.y);
    assert_near(e.part, 0.6, 0.005);
}

static void nothing_a_person_does_breaks_the_model(void **state)
{
    (void)state;
    static struct editor e;
    static const char keys[] = "bpnsckjfaxeurghtmo,.<>\t";
    editor_begin(&e);
    for (int i = 0; i < 60000; i++) {
        struct vector3 at = {random_in(0, 1200), random_in(0, 800), 0};
        uint32_t what = random_below(12);
        if (what < 3)
            press_at(&e, at.x, at.y);
        else if (what < 7)
            move_to(&e, at.x, at.y);
        else if (what < 9)
            lift_at(&e, at.x, at.y);
        else if (what < 11 && random_below(30) != 0)
            editor_key(&e, EDITOR_UP + (int)random_below(4));
        else
            editor_key(&e, keys[random_below(sizeof keys - 1)]);
        assert_valid(&e.model);
        assert_true(e.chosen >= -1 && e.chosen < e.model.count);
        assert_true(e.part >= 0 && e.part <= 1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(models_come_back_from_their_text),
        cmocka_unit_test(lines_that_are_wrong_are_told),
        cmocka_unit_test(limits_of_lines_and_points),
        cmocka_unit_test(any_text_makes_a_valid_model_or_none),
        cmocka_unit_test(a_drag_moves_a_point_and_is_one_step),
        cmocka_unit_test(a_tap_chooses_and_moves_nothing),
        cmocka_unit_test(touching_adds_where_the_polygon_is_near),
        cmocka_unit_test(handles_t_and_the_mark_are_dragged),
        cmocka_unit_test(nothing_a_person_does_breaks_the_model),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
