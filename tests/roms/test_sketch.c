/* The model of the drawing program (roms/sketch): what a drawing keeps whatever is done to it, its
 * history, constraints, subpictures and text, over random operations; snapping and copies against
 * double precision. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "roms/geometry/scalar.c"
#include "roms/sketch/constraint.c"
#include "roms/sketch/drawing.c"
#define length expand_length
#include "roms/sketch/expand.c"
#undef length
#define take snap_take
#include "roms/sketch/snap.c"
#undef take
#define count subpicture_count
#define uses  subpicture_uses
#include "roms/sketch/subpicture.c"
#undef count
#undef uses
#include "roms/sketch/undo.c"

static struct drawing drawing;
static struct undo history;
static struct constraint_move scratch;
static uint32_t seed;

static uint32_t below(uint32_t limit)
{
    seed = seed * 1664525u + 1013904223u;
    return (uint32_t)((uint64_t)seed * limit >> 32);
}

static struct place somewhere(void)
{
    return (struct place){(int32_t)below(120000), (int32_t)below(80000)};
}

static void fresh_start(uint32_t with)
{
    seed = with;
    drawing_begin(&drawing);
    undo_attach(&history, &drawing);
}

/* ---- random operations ----------------------------------------------------------------------- */

/* A figure that there is, of this kind or any; -1: none was found. */
static int some_figure(unsigned kind)
{
    for (int tries = 0; tries < 200; tries++) {
        int i = (int)below(DRAWING_FIGURES);
        unsigned is = drawing.now.figure[i].kind;
        if (is != FIGURE_NONE && (kind == FIGURE_NONE || is == kind))
            return i;
    }
    return -1;
}

static int some_point(unsigned picture)
{
    for (int tries = 0; tries < 60; tries++) {
        int i = (int)below(DRAWING_POINTS);
        if (drawing.now.point[i].users != 0 && drawing.now.point[i].picture == picture)
            return i;
    }
    return -1;
}

static unsigned some_picture(void)
{
    unsigned picture = below(4) == 0 ? 1 + below(DRAWING_MASTERS) : 0;
    return picture != 0 && drawing.now.master[picture].used ? picture : 0;
}

static enum drawing_status add_some(unsigned kinds)
{
    struct figure like = {.kind = (uint8_t)(1 + below(kinds)), .picture = (uint8_t)some_picture()};
    struct drawing_end ends[DRAWING_ENDS];
    int made;
    if (like.kind == FIGURE_COPY) {
        like.master = (uint8_t)subpicture_next(&drawing.now, (int)below(DRAWING_MASTERS));
        like.scale = SCALE_LEAST + (int32_t)below(3000);
        like.angle = (int32_t)below(ANGLE_TURN);
        if (like.master == 0)
            like.kind = FIGURE_LINE, like.scale = like.angle = 0;
    }
    for (int i = 0; i < DRAWING_ENDS; i++) {
        ends[i] = (struct drawing_end){below(3) == 0 ? some_point(like.picture) : -1, somewhere()};
        for (int k = 0; k < i; k++)
            if (ends[k].point == ends[i].point)
                ends[i].point = -1;
    }
    return drawing_add(&drawing, &like, ends, &made);
}

static void move_some(void)
{
    constraint_begin(&scratch);
    for (int i = 1 + (int)below(2); i > 0; i--) {
        int point = some_point(0);
        if (point < 0)
            return;
        struct place at = drawing.now.point[point].at;
        /* Together, as a dragged figure: all by the same way. */
        constraint_to(&scratch, point, (struct place){at.x + 700, at.y - 300});
    }
    constraint_apply(&drawing, &scratch);
}

static void define_some(void)
{
    bool selected[DRAWING_FIGURES] = {false};
    int master, copy, picture = (int)some_picture();
    for (int i = 0; i < 3; i++) {
        int figure = some_figure(FIGURE_NONE);
        if (figure >= 0)
            selected[figure] = true;
    }
    subpicture_define(&drawing, picture, selected, &master, &copy);
}

static void operate(void)
{
    int figure = some_figure(FIGURE_NONE), line = some_figure(FIGURE_LINE);
    switch (below(9)) {
    case 0:
        if (figure >= 0)
            drawing_delete(&drawing, figure);
        break;
    case 1:
        move_some();
        break;
    case 2:
        if (line >= 0)
            constraint_set(&drawing, line, (enum constraint)below(3), &scratch);
        break;
    case 3:
        if (below(4) == 0)
            define_some();
        break;
    case 4: {
        int from = some_point(0), into = some_point(0);
        if (from < 0 || into < 0 || from == into)
            break;
        constraint_begin(&scratch);
        constraint_to(&scratch, from, drawing.now.point[into].at);
        constraint_apply(&drawing, &scratch);
        drawing_merge(&drawing, from, into);
        break;
    }
    case 5:
        if (below(60) == 0)
            drawing_clear(&drawing);
        break;
    default:
        add_some(4);
    }
}

/* ---- what always holds ----------------------------------------------------------------------- */

static void check_figure(const struct figure *f, uint16_t users[])
{
    for (int k = 0; k < figure_ends(f->kind); k++) {
        const struct drawing_point *p = &drawing.now.point[f->end[k]];
        assert_int_equal(p->picture, f->picture);
        for (int j = 0; j < k; j++)
            assert_int_not_equal(f->end[j], f->end[k]);
        users[f->end[k]]++;
    }
    struct place a = drawing.now.point[f->end[0]].at, b = drawing.now.point[f->end[1]].at;
    if (f->constraint == CONSTRAINT_HORIZONTAL)
        assert_int_equal(a.y, b.y);
    if (f->constraint == CONSTRAINT_VERTICAL)
        assert_int_equal(a.x, b.x);
    if (f->picture != 0)
        assert_true(drawing.now.master[f->picture].used);
    if (f->kind != FIGURE_COPY)
        return;
    assert_true(drawing.now.master[f->master].used);
    assert_false(drawing_reaches(&drawing.now, f->master, f->picture));
}

static void check_drawing(void)
{
    uint16_t users[DRAWING_POINTS] = {0};
    for (int i = 0; i < DRAWING_FIGURES; i++)
        if (drawing.now.figure[i].kind != FIGURE_NONE)
            check_figure(&drawing.now.figure[i], users);
    for (int i = 0; i < DRAWING_POINTS; i++) {
        assert_int_equal(users[i], drawing.now.point[i].users);
        assert_true(place_is_inside(drawing.now.point[i].at));
    }
    for (int i = 0; i <= DRAWING_MASTERS; i++)
        assert_true(drawing_strokes(&drawing.now, i) <= DRAWING_STROKES);
}

static void test_whatever_is_done(void **state)
{
    (void)state;
    for (uint32_t round = 1; round <= 12; round++) {
        fresh_start(round * 77u);
        for (int i = 0; i < 700; i++) {
            operate();
            if (i % 10 == 0)
                check_drawing();
        }
        check_drawing();
    }
}

/* ---- history --------------------------------------------------------------------------------- */

enum { STEPS = 150 };

static void test_history_gives_back_every_byte(void **state)
{
    (void)state;
    static struct drawing_state after[STEPS + 1];
    for (uint32_t round = 1; round <= 6; round++) {
        int steps = 0;
        fresh_start(round * 991u);
        after[0] = drawing.now;
        while (steps < STEPS) {
            undo_begin(&history);
            for (int i = 1 + (int)below(4); i > 0; i--)
                operate();
            if (below(5) == 0) {
                undo_cancel(&history);
                assert_memory_equal(&drawing.now, &after[steps], sizeof drawing.now);
            } else if (undo_commit(&history)) {
                after[++steps] = drawing.now;
            } else {
                assert_memory_equal(&drawing.now, &after[steps], sizeof drawing.now);
            }
        }
        int at = steps;
        for (int i = 0; i < 900; i++) {
            bool back = below(100) < (i < 300 ? 65u : 50u);
            bool turned = back ? undo_back(&history) : undo_again(&history);
            assert_int_equal(turned, back ? at > 0 : at < steps);
            at += turned ? (back ? -1 : 1) : 0;
            assert_memory_equal(&drawing.now, &after[at], sizeof drawing.now);
        }
    }
}

/* Steps that change as many slots as there are: 64 of them can be taken back. */
static void test_history_is_deep_enough(void **state)
{
    (void)state;
    static struct drawing_state after[UNDO_LEAST + 11];
    fresh_start(5);
    for (int step = 0; step <= UNDO_LEAST + 10; step++) {
        undo_begin(&history);
        for (int i = 0; i < DRAWING_POINTS; i++)
            drawing_change_point(&drawing, i)->at.x = step + 1;
        for (int i = 0; i < DRAWING_FIGURES; i++)
            drawing_change_figure(&drawing, i)->scale = step + 1;
        for (int i = 0; i <= DRAWING_MASTERS; i++)
            drawing_change_master(&drawing, i)->origin.x = step + 1;
        assert_true(undo_commit(&history));
        after[step] = drawing.now;
    }
    assert_true(undo_depth(&history) >= UNDO_LEAST);
    int last = UNDO_LEAST + 10;
    while (undo_back(&history)) /* as far as it goes */
        assert_memory_equal(&drawing.now, &after[--last], sizeof drawing.now);
    assert_true(last <= 10);
    for (int step = last + 1; step <= UNDO_LEAST + 10; step++) {
        assert_true(undo_again(&history));
        assert_memory_equal(&drawing.now, &after[step], sizeof drawing.now);
    }
    assert_false(undo_again(&history));
}

static void test_a_new_step_forgets_what_was_taken_back(void **state)
{
    (void)state;
    fresh_start(9);
    for (int i = 0; i < 1000; i++) { /* more than there are places for steps */
        undo_begin(&history);
        drawing_change_point(&drawing, 3)->at.x = i + 1;
        undo_commit(&history);
    }
    for (int i = 999; i > 990; i--)
        assert_true(undo_back(&history));
    assert_int_equal(drawing.now.point[3].at.x, 991);
    undo_begin(&history);
    drawing_change_point(&drawing, 3)->at.x = 7;
    undo_cancel(&history); /* forgets nothing */
    assert_true(undo_again(&history));
    assert_int_equal(drawing.now.point[3].at.x, 992);
    undo_begin(&history);
    drawing_change_point(&drawing, 3)->at.x = 5;
    assert_true(undo_commit(&history));
    assert_false(undo_again(&history));
    assert_true(undo_back(&history));
    assert_int_equal(drawing.now.point[3].at.x, 992);
}

/* ---- constraints ----------------------------------------------------------------------------- */

/* Points of a net of horizontal and vertical lines: what a drag of one moves is what a walk over the
 * lines reaches, and no other coordinate changes. */
static void test_drags_move_what_hangs_on_and_nothing_else(void **state)
{
    (void)state;
    for (uint32_t round = 1; round <= 20; round++) {
        fresh_start(round * 31u);
        for (int i = 0; i < 60; i++)
            add_some(1);
        for (int i = 0; i < 40; i++)
            constraint_set(&drawing, some_figure(FIGURE_LINE), (enum constraint)(1 + below(2)),
                           &scratch);
        for (int drag = 0; drag < 20; drag++) {
            const struct drawing_state before = drawing.now;
            bool x[DRAWING_POINTS] = {false}, y[DRAWING_POINTS] = {false};
            int point = some_point(0);
            struct place to = somewhere();
            x[point] = y[point] = true;
            for (int pass_number = 0; pass_number < DRAWING_FIGURES; pass_number++)
                for (int i = 0; i < DRAWING_FIGURES; i++) {
                    const struct figure *f = &before.figure[i];
                    bool *axis = f->constraint == CONSTRAINT_HORIZONTAL ? y : x;
                    if (f->constraint != CONSTRAINT_NONE)
                        axis[f->end[0]] = axis[f->end[1]] = axis[f->end[0]] || axis[f->end[1]];
                }
            constraint_begin(&scratch);
            constraint_to(&scratch, point, to);
            assert_int_equal(constraint_apply(&drawing, &scratch), DRAWING_OK);
            for (int i = 0; i < DRAWING_POINTS; i++) {
                struct place at = drawing.now.point[i].at, was = before.point[i].at;
                assert_int_equal(at.x, x[i] ? to.x : was.x);
                assert_int_equal(at.y, y[i] ? to.y : was.y);
            }
            check_drawing();
        }
    }
}

static void test_a_line_keeps_its_length(void **state)
{
    (void)state;
    int line;
    fresh_start(1);
    struct figure like = {.kind = FIGURE_LINE};
    struct drawing_end ends[] = {{-1, {100, 100}}, {-1, {500, 100}}};
    drawing_add(&drawing, &like, ends, &line);
    assert_int_equal(constraint_set(&drawing, line, CONSTRAINT_VERTICAL, &scratch), DRAWING_FLAT);
    assert_int_equal(constraint_set(&drawing, line, CONSTRAINT_HORIZONTAL, &scratch), DRAWING_OK);
    assert_int_equal(drawing_end_place(&drawing.now, line, 1).x, 500);
    const struct drawing_state before = drawing.now;
    constraint_begin(&scratch);
    constraint_to(&scratch, 0, (struct place){0, PLACE_MOST + 1});
    assert_int_equal(constraint_apply(&drawing, &scratch), DRAWING_OUTSIDE);
    assert_memory_equal(&before, &drawing.now, sizeof before);
}

/* ---- stores ---------------------------------------------------------------------------------- */

static void test_full_stores_refuse_and_keep(void **state)
{
    (void)state;
    enum drawing_status status = DRAWING_OK;
    fresh_start(3);
    while (status == DRAWING_OK) {
        const struct drawing_state before = drawing.now;
        status = add_some(1);
        if (status != DRAWING_OK)
            assert_memory_equal(&before, &drawing.now, sizeof before);
    }
    assert_true(status == DRAWING_FIGURES_FULL || status == DRAWING_POINTS_FULL);
    assert_int_equal(drawing_fullness(&drawing.now), 100);
    check_drawing();
}

/* Subpictures of copies of subpictures: the count grows fast and stays within its limit. */
static void test_copies_of_copies_end(void **state)
{
    (void)state;
    int line, master = 0, copy;
    fresh_start(4);
    struct figure like = {.kind = FIGURE_LINE};
    struct drawing_end ends[] = {{-1, {0, 0}}, {-1, {100, 0}}};
    drawing_add(&drawing, &like, ends, &line);
    for (int level = 0; level < DRAWING_MASTERS; level++) {
        bool selected[DRAWING_FIGURES];
        for (int i = 0; i < DRAWING_FIGURES; i++)
            selected[i] = drawing.now.figure[i].picture == 0;
        assert_int_equal(subpicture_define(&drawing, 0, selected, &master, &copy), DRAWING_OK);
        struct figure again = {.kind = FIGURE_COPY, .master = (uint8_t)master, .scale = SCALE_ONE};
        enum drawing_status status = drawing_add(&drawing, &again, ends, &copy);
        assert_int_equal(status, level < 10 ? DRAWING_OK : DRAWING_STROKES_FULL); /* 2^11 > 1200 */
        struct figure inside = again;
        inside.picture = (uint8_t)master;
        assert_int_equal(drawing_add(&drawing, &inside, ends, &copy), DRAWING_IN_ITSELF);
        check_drawing();
    }
    bool all[DRAWING_FIGURES];
    memset(all, true, sizeof all);
    assert_int_equal(subpicture_define(&drawing, 0, all, &master, &copy), DRAWING_MASTERS_FULL);
    /* A line more in the innermost would be a thousand more outside. */
    like.picture = 1;
    const struct drawing_state before = drawing.now;
    assert_int_equal(drawing_add(&drawing, &like, ends, &line), DRAWING_STROKES_FULL);
    assert_memory_equal(&before, &drawing.now, sizeof before);
}

/* ---- copies ---------------------------------------------------------------------------------- */

struct taken {
    struct stroke stroke[64];
    int count;
};

static void collect(void *ctx, const struct stroke *stroke)
{
    struct taken *t = ctx;
    if (stroke->kind != FIGURE_COPY)
        t->stroke[t->count++] = *stroke;
}

/* By complex numbers, in double precision: where the copies put a place of the subpicture. */
static void slow_place(const int copy[2], const int master[2], double *x, double *y)
{
    for (int level = 0; level < 2; level++) {
        const struct figure *f = &drawing.now.figure[copy[level]];
        struct place at = drawing.now.point[f->end[0]].at;
        struct place origin = drawing.now.master[master[level]].origin;
        double s = f->scale / 1000.0, a = f->angle / 18000.0 * acos(-1);
        double dx = *x - origin.x / 100.0, dy = *y - origin.y / 100.0;
        *x = at.x / 100.0 + s * (cos(a) * dx - sin(a) * dy);
        *y = at.y / 100.0 + s * (sin(a) * dx + cos(a) * dy);
    }
}

static void turn_and_scale(int copy)
{
    drawing.now.figure[copy].scale = 200 + (int32_t)below(2000);
    drawing.now.figure[copy].angle = (int32_t)below(ANGLE_TURN);
}

static void assert_places(const struct taken *got, const struct taken *expected, float within)
{
    assert_int_equal(got->count, expected->count);
    for (int i = 0; i < got->count; i++)
        for (int k = 0; k < figure_ends(expected->stroke[i].kind); k++) {
            assert_float_equal(got->stroke[i].at[k].x, expected->stroke[i].at[k].x, within);
            assert_float_equal(got->stroke[i].at[k].y, expected->stroke[i].at[k].y, within);
        }
}

/* Defining shows what was there before; then, a copy within a copy, both turned and scaled. */
static void test_copies_show_what_they_are_copies_of(void **state)
{
    (void)state;
    static struct taken before, after;
    for (uint32_t round = 1; round <= 200; round++) {
        bool selected[DRAWING_FIGURES] = {true, true, true, true};
        int master[2], copy[2];
        fresh_start(round * 13u);
        for (int i = 0; i < 6; i++)
            add_some(3);
        before.count = after.count = 0;
        for (int i = 0; i < 4; i++)
            expand_figure(&drawing.now, i, collect, &before);
        assert_int_equal(subpicture_define(&drawing, 0, selected, &master[0], &copy[0]),
                         DRAWING_OK);
        expand_figure(&drawing.now, copy[0], collect, &after);
        assert_places(&after, &before, 0.001f);

        memset(selected, 0, sizeof selected);
        selected[copy[0]] = true;
        turn_and_scale(copy[0]);
        assert_int_equal(subpicture_define(&drawing, 0, selected, &master[1], &copy[1]),
                         DRAWING_OK);
        turn_and_scale(copy[1]);
        drawing.now.point[drawing.now.figure[copy[1]].end[0]].at = somewhere();
        for (int i = 0; i < 4; i++)
            for (int k = 0; k < figure_ends(before.stroke[i].kind); k++) {
                double x = (double)before.stroke[i].at[k].x, y = (double)before.stroke[i].at[k].y;
                slow_place(copy, master, &x, &y);
                before.stroke[i].at[k] = (struct point2){(float)x, (float)y};
            }
        after.count = 0;
        expand_figure(&drawing.now, copy[1], collect, &after);
        assert_places(&after, &before, 0.01f);
        for (int i = 0; i < after.count; i++)
            assert_true(after.stroke[i].inner && after.stroke[i].figure == copy[1]);
    }
}

/* ---- snapping -------------------------------------------------------------------------------- */

static double away(double x0, double y0, double x1, double y1)
{
    return hypot(x1 - x0, y1 - y0);
}

/* By many small steps along the figure. */
static double slow_distance(const struct stroke *k, double x, double y)
{
    enum { PIECES = 40000 };
    double least = INFINITY;
    double mx = (double)k->at[0].x, my = (double)k->at[0].y;
    double r = away(mx, my, (double)k->at[1].x, (double)k->at[1].y);
    double begin = atan2((double)k->at[1].y - my, (double)k->at[1].x - mx), sweep = 2 * acos(-1);
    if (k->kind == FIGURE_ARC) {
        sweep = atan2((double)k->at[2].y - my, (double)k->at[2].x - mx) - begin;
        sweep += sweep <= 0 ? 2 * acos(-1) : 0;
    }
    for (int i = 0; i <= PIECES; i++) {
        double t = (double)i / PIECES, px, py;
        if (k->kind == FIGURE_LINE) {
            px = mx + t * ((double)k->at[1].x - mx);
            py = my + t * ((double)k->at[1].y - my);
        } else {
            px = mx + r * cos(begin + t * sweep);
            py = my + r * sin(begin + t * sweep);
        }
        double d = away(px, py, x, y);
        least = d < least ? d : least;
    }
    return least;
}

static void test_the_nearest_place_of_a_figure(void **state)
{
    (void)state;
    fresh_start(21);
    for (int i = 0; i < 300; i++) {
        struct stroke k = {.kind = (enum figure_kind)(1 + below(3))};
        for (int end = 0; end < DRAWING_ENDS; end++)
            k.at[end] = place_in_units(somewhere());
        struct point2 p = place_in_units(somewhere()), on;
        float d = stroke_nearest(&k, p, &on);
        assert_float_equal(d, slow_distance(&k, (double)p.x, (double)p.y), 0.1);
        assert_float_equal(d, away((double)p.x, (double)p.y, (double)on.x, (double)on.y), 0.01);
        if (i < 40)
            assert_float_equal(slow_distance(&k, (double)on.x, (double)on.y), 0, 0.1);
    }
}

struct nearest {
    double point, line;
};

static void look_at(struct nearest *n, const struct stroke *s, struct point2 p)
{
    struct point2 on;
    for (int end = 0; end < figure_ends(s->kind); end++)
        n->point = fmin(n->point,
                        away((double)p.x, (double)p.y, (double)s->at[end].x, (double)s->at[end].y));
    n->line = fmin(n->line, (double)stroke_nearest(s, p, &on)); /* tested above */
}

/* Every figure, one after the other. */
static struct nearest slow_nearest(struct point2 p)
{
    static struct taken all;
    struct nearest n = {INFINITY, INFINITY};
    for (int k = 0; k < DRAWING_FIGURES; k++) {
        const struct figure *f = &drawing.now.figure[k];
        if (f->kind == FIGURE_NONE || f->picture != 0)
            continue;
        struct place at = drawing_end_place(&drawing.now, k, 0);
        n.point = fmin(n.point, away((double)p.x, (double)p.y, at.x / 100.0, at.y / 100.0));
        all.count = 0;
        expand_figure(&drawing.now, k, collect, &all);
        for (int i = 0; i < all.count; i++)
            look_at(&n, &all.stroke[i], p);
    }
    return n;
}

static void check_snapped(const struct snap_settings *settings, struct place at, struct snapped got,
                          struct nearest n)
{
    double reach = settings->grid ? fmin(12, settings->spacing * 0.006) : 12;
    double moved = away(at.x / 100.0, at.y / 100.0, got.at.x / 100.0, got.at.y / 100.0);
    bool on_grid = got.at.x % settings->spacing == 0 && got.at.y % settings->spacing == 0;
    if (fabs(n.point - reach) < 0.01 || (n.point > reach && fabs(n.line - reach) < 0.01))
        return; /* too close to call */
    if (n.point < reach) {
        assert_int_equal(got.kind, SNAP_POINT);
        assert_float_equal(moved, n.point, 0.02);
    } else if (n.line < reach) {
        assert_true(got.kind == SNAP_LINE || got.kind == SNAP_CIRCLE);
        assert_true(fabs(moved - n.line) < 0.02 || (settings->grid && on_grid));
    } else if (settings->grid) {
        assert_int_equal(got.kind, SNAP_GRID);
        assert_true(on_grid);
        assert_true(abs(got.at.x - at.x) <= settings->spacing / 2);
        assert_true(abs(got.at.y - at.y) <= settings->spacing / 2);
    } else {
        assert_int_equal(got.kind, SNAP_NONE);
        assert_int_equal(got.at.x, at.x);
        assert_int_equal(got.at.y, at.y);
    }
}

/* Points before figures before the grid, and the nearest of each. */
static void test_snapping_takes_the_nearest(void **state)
{
    (void)state;
    int kinds[5] = {0};
    fresh_start(22);
    for (int i = 0; i < 60; i++)
        add_some(4);
    define_some();
    for (int i = 0; i < 20; i++)
        add_some(4);
    for (int i = 0; i < 4000; i++) {
        struct snap_settings settings = {below(2), true, 1000 * (int32_t)(1 + below(6)), 12};
        struct place at = somewhere();
        struct snapped got = snap(&drawing.now, 0, &settings, at, NULL);
        check_snapped(&settings, at, got, slow_nearest(place_in_units(at)));
        kinds[got.kind]++;
    }
    for (int i = 0; i < 5; i++)
        assert_true(kinds[i] > 20);
}

static void test_negative_places_have_a_grid(void **state)
{
    (void)state;
    for (int32_t v = -5000; v <= 5000; v += 7) {
        struct place at = snap_to_grid((struct place){v, -v}, 1000);
        assert_int_equal(at.x, 1000 * (int32_t)floor(v / 1000.0 + 0.5));
        assert_int_equal(at.y, 1000 * (int32_t)floor(-v / 1000.0 + 0.5));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_whatever_is_done),
        cmocka_unit_test(test_history_gives_back_every_byte),
        cmocka_unit_test(test_history_is_deep_enough),
        cmocka_unit_test(test_a_new_step_forgets_what_was_taken_back),
        cmocka_unit_test(test_drags_move_what_hangs_on_and_nothing_else),
        cmocka_unit_test(test_a_line_keeps_its_length),
        cmocka_unit_test(test_full_stores_refuse_and_keep),
        cmocka_unit_test(test_copies_of_copies_end),
        cmocka_unit_test(test_copies_show_what_they_are_copies_of),
        cmocka_unit_test(test_the_nearest_place_of_a_figure),
        cmocka_unit_test(test_snapping_takes_the_nearest),
        cmocka_unit_test(test_negative_places_have_a_grid),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
