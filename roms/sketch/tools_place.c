/* tools_place.c — new figures: their ends are placed one after the other; and copies. */
#include <stdio.h>
#include <string.h>

#include "roms/sketch/tools_parts.h"

static bool is_line(const struct tools *t)
{
    return t->tool == COMMAND_LINE || t->tool == COMMAND_CHAIN;
}

static bool is_upright(const struct tools *t)
{
    return is_line(t) && (t->upright || t->pointing.upright);
}

static bool same(struct place a, struct place b)
{
    return a.x == b.x && a.y == b.y;
}

static const struct figure *live(const struct tools *t)
{
    return &t->drawing.now.figure[t->figure];
}

/* ---- the end that follows -------------------------------------------------------------------- */

/* This end and those after it are where the pointer is. */
static void follow_from(struct tools *t, int end)
{
    int points[DRAWING_ENDS], count = 0;
    t->end = end;
    for (int i = end; i < figure_ends(live(t)->kind); i++)
        points[count++] = live(t)->end[i];
    tools_follow(t, points, count);
    for (int i = 0; i < end;
         i++) /* nor does its beginning attract: small figures could not be made */
        t->moving.point[live(t)->end[i]] = true;
}

/* On the circle of the arc, where only the direction counts. */
static struct place on_arc(const struct tools *t, struct place at)
{
    struct stroke arc = {.kind = FIGURE_CIRCLE};
    struct point2 on;
    for (int i = 0; i < 2; i++)
        arc.at[i] = place_in_units(drawing_end_place(&t->drawing.now, t->figure, i));
    stroke_nearest(&arc, place_in_units(at), &on);
    return place_of_units(on.x, on.y);
}

static void follow_pointer(struct tools *t)
{
    t->cursor = tools_snap(t, t->pointing.at);
    struct place at = t->cursor.at;
    if (is_upright(t))
        at = tools_aligned(t->from, at);
    if (t->end == 2 && t->cursor.kind != SNAP_POINT)
        at = on_arc(t, at);
    if (!same(at, t->cursor.at))
        t->cursor = (struct snapped){.kind = SNAP_NONE, .at = at, .point = -1, .figure = -1};
    constraint_begin(&t->scratch);
    for (int i = 0; i < DRAWING_POINTS; i++)
        if (t->carried[i])
            constraint_to(&t->scratch, i, at);
    tools_worked(t, constraint_apply(&t->drawing, &t->scratch));
}

/* ---- beginning ------------------------------------------------------------------------------- */

static enum figure_kind kind_of(enum command tool)
{
    return tool == COMMAND_CIRCLE ? FIGURE_CIRCLE : tool == COMMAND_ARC ? FIGURE_ARC : FIGURE_LINE;
}

static void begin(struct tools *t, int point, struct place at)
{
    struct figure like = {.kind = (uint8_t)kind_of(t->tool), .picture = (uint8_t)t->picture};
    struct drawing_end ends[DRAWING_ENDS] = {{point, at}, {-1, at}, {-1, at}};
    undo_begin(&t->undo);
    if (!tools_worked(t, drawing_add(&t->drawing, &like, ends, &t->figure))) {
        tools_leave_off(t);
        return;
    }
    t->phase = PHASE_PLACING;
    t->from = at;
    follow_from(t, 1);
}

static void press_first(struct tools *t)
{
    t->cursor = tools_snap(t, t->pointing.at);
    begin(t, t->cursor.point, t->cursor.at);
    t->first_point = t->phase == PHASE_PLACING ? live(t)->end[0] : -1;
    t->dragging = true;
    t->pressed_at = t->pointing.at;
}

/* ---- ending ---------------------------------------------------------------------------------- */

/* The end becomes one with the point it is drawn to; false: that is an end of the figure already. */
static bool share(struct tools *t)
{
    int into = t->cursor.point;
    if (into < 0 || !same(t->drawing.now.point[into].at, t->cursor.at))
        return true;
    return drawing_merge(&t->drawing, live(t)->end[t->end], into) == DRAWING_OK;
}

static bool keep_upright(struct tools *t)
{
    struct place a = drawing_end_place(&t->drawing.now, t->figure, 0);
    struct place b = drawing_end_place(&t->drawing.now, t->figure, 1);
    return !is_upright(t) ||
           tools_worked(t, constraint_set(&t->drawing, t->figure,
                                          a.y == b.y ? CONSTRAINT_HORIZONTAL : CONSTRAINT_VERTICAL,
                                          &t->scratch));
}

/* The next line of a chain begins where this one ended, unless that is where the chain began. */
static void go_on(struct tools *t)
{
    int point = live(t)->end[1];
    struct place at = t->drawing.now.point[point].at;
    tools_finish(t);
    if (point == t->first_point)
        return;
    begin(t, point, at);
    t->dragging = true;
    t->pressed_at = t->pointing.at;
}

static void place_end(struct tools *t)
{
    struct place begin_at = drawing_end_place(&t->drawing.now, t->figure, 0);
    struct place at = drawing_end_place(&t->drawing.now, t->figure, t->end);
    if ((t->end == 1 && !tools_is_far(begin_at, at, TOOLS_STEADY)) || !share(t) ||
        !keep_upright(t)) {
        tools_leave_off(t);
        return;
    }
    if (t->end + 1 < figure_ends(live(t)->kind)) {
        follow_from(t, t->end + 1);
        t->dragging = false;
    } else if (t->tool == COMMAND_CHAIN) {
        go_on(t);
    } else {
        tools_finish(t);
    }
}

void place_point(struct tools *t)
{
    const struct pointing *p = &t->pointing;
    if (t->phase != PHASE_PLACING) {
        t->cursor = tools_snap(t, p->at);
        if (p->pressed_now && p->inside)
            press_first(t);
        t->dragging &= !p->released_now; /* a tap */
        return;
    }
    follow_pointer(t);
    if (p->pressed_now && !t->dragging) {
        place_end(t);
        t->dragging &= !p->released_now; /* a tap */
        return;
    }
    if (!p->released_now || !t->dragging)
        return;
    t->dragging = false;
    if (tools_is_far(p->at, t->pressed_at, TOOLS_FAR))
        place_end(t);
}

/* ---- copies ---------------------------------------------------------------------------------- */

static void begin_copy(struct tools *t)
{
    struct figure like = {.kind = FIGURE_COPY,
                          .picture = (uint8_t)t->picture,
                          .master = (uint8_t)t->master,
                          .scale = t->scale,
                          .angle = t->angle};
    struct drawing_end end = {-1, t->cursor.at};
    undo_begin(&t->undo);
    if (!tools_worked(t, drawing_add(&t->drawing, &like, &end, &t->figure))) {
        tools_leave_off(t);
        return;
    }
    t->phase = PHASE_PLACING;
    t->from = t->cursor.at;
    follow_from(t, 0);
}

void copy_renew(struct tools *t)
{
    if (t->phase != PHASE_PLACING || t->tool != COMMAND_COPY)
        return;
    struct figure *f = drawing_change_figure(&t->drawing, t->figure);
    f->scale = t->scale;
    f->angle = t->angle;
}

/* One follows the pointer all the time; a release leaves it there. */
void copy_point(struct tools *t)
{
    const struct pointing *p = &t->pointing;
    bool carries = p->pressed && t->phase == PHASE_PLACING;
    if (!p->inside && !carries) {
        tools_leave_off(t);
        return;
    }
    if (t->phase != PHASE_PLACING) {
        t->cursor = tools_snap(t, p->at);
        if (p->pressed_now || tools_is_far(p->at, t->pressed_at, TOOLS_FAR))
            begin_copy(t);
    }
    if (t->phase != PHASE_PLACING)
        return;
    follow_pointer(t);
    if (!p->released_now)
        return;
    share(t);
    tools_finish(t);
    t->pressed_at = p->at;
}
