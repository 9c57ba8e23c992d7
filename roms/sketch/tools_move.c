/* tools_move.c — moving and selecting; and what is done to figures that are pointed at. */
#include <string.h>

#include "roms/sketch/tools_parts.h"

static struct snapped pick(const struct tools *t)
{
    return snap_pick(&t->drawing.now, t->picture, t->snap.reach, t->pointing.at);
}

/* ---- what is carried ------------------------------------------------------------------------- */

struct load {
    bool taken[DRAWING_POINTS];
    int point[DRAWING_POINTS], count;
};

static void load_point(struct load *load, int point)
{
    if (load->taken[point])
        return;
    load->taken[point] = true;
    load->point[load->count++] = point;
}

static void load_figure(struct load *load, const struct figure *f)
{
    for (int i = 0; i < figure_ends(f->kind); i++)
        load_point(load, f->end[i]);
}

/* A point; with it the circles and arcs that it is the middle of. */
static bool load_middle(struct load *load, const struct drawing_state *s, int point)
{
    load_point(load, point);
    for (int i = 0; i < DRAWING_FIGURES; i++) {
        const struct figure *f = &s->figure[i];
        if ((f->kind == FIGURE_CIRCLE || f->kind == FIGURE_ARC) && f->end[0] == point)
            load_figure(load, f);
    }
    return load->count > 1;
}

/* The point of those carried that is nearest to where it was grasped decides what attracts. */
static int nearest(const struct tools *t, const struct load *load)
{
    struct point2 p = place_in_units(t->pressed_at);
    float least = INFINITY;
    int found = load->point[0];
    for (int i = 0; i < load->count; i++) {
        struct point2 q = place_in_units(t->drawing.now.point[load->point[i]].at);
        float away = (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y);
        if (!(away < least))
            continue;
        least = away;
        found = load->point[i];
    }
    return found;
}

static void grasp(struct tools *t, const struct snapped *what)
{
    static struct load load;
    const struct drawing_state *s = &t->drawing.now;
    memset(&load, 0, sizeof load);
    t->single = false;
    if (t->selection.figure[what->figure]) {
        for (int i = 0; i < DRAWING_FIGURES; i++)
            if (t->selection.figure[i])
                load_figure(&load, &s->figure[i]);
    } else if (what->kind == SNAP_POINT && what->point >= 0) {
        t->single = !load_middle(&load, s, what->point);
    } else {
        load_figure(&load, &s->figure[what->figure]);
    }
    undo_begin(&t->undo);
    t->phase = PHASE_MOVING;
    tools_follow(t, load.point, load.count);
    t->first_point = nearest(t, &load);
    t->from = t->start[t->first_point];
}

/* ---- boxes ----------------------------------------------------------------------------------- */

static void begin_box(struct tools *t)
{
    t->phase = PHASE_BOX;
    t->from = t->pointing.at;
}

static void box_point(struct tools *t)
{
    t->cursor = (struct snapped){.at = t->pointing.at, .point = -1, .figure = -1};
    if (!t->pointing.released_now)
        return;
    t->phase = PHASE_IDLE;
    if (!tools_is_far(t->from, t->pointing.at, TOOLS_FAR))
        select_none(&t->selection);
    else if (select_box(&t->selection, &t->drawing.now, t->picture, t->from, t->pointing.at) == 0)
        tools_say(t, "Nothing lies in the box as a whole.");
}

/* ---- moving ---------------------------------------------------------------------------------- */

static void carry(struct tools *t)
{
    const struct pointing *p = &t->pointing;
    struct place at = {t->from.x + p->at.x - t->pressed_at.x,
                       t->from.y + p->at.y - t->pressed_at.y};
    t->cursor = tools_snap(t, at);
    if (p->upright && t->cursor.kind != SNAP_POINT) {
        t->cursor.at = tools_aligned(t->from, t->cursor.at);
        t->cursor.kind = SNAP_NONE;
    }
    int32_t x = t->cursor.at.x - t->from.x, y = t->cursor.at.y - t->from.y;
    constraint_begin(&t->scratch);
    for (int i = 0; i < DRAWING_POINTS; i++)
        if (t->carried[i])
            constraint_to(&t->scratch, i, (struct place){t->start[i].x + x, t->start[i].y + y});
    tools_worked(t, constraint_apply(&t->drawing, &t->scratch));
}

static void drop(struct tools *t)
{
    if (!t->moved) { /* a click: it is selected, and nothing else */
        bool was = t->selection.figure[t->picked];
        tools_leave_off(t);
        select_none(&t->selection);
        if (!was)
            select_turn(&t->selection, t->picked);
        return;
    }
    if (t->single && t->cursor.point >= 0)
        tools_worked(t, drawing_merge(&t->drawing, t->first_point, t->cursor.point));
    tools_finish(t);
}

void move_point(struct tools *t)
{
    const struct pointing *p = &t->pointing;
    if (t->phase == PHASE_IDLE) {
        t->cursor = pick(t);
        if (!p->pressed_now || !p->inside)
            return;
        t->pressed_at = p->at;
        t->moved = false;
        t->picked = t->cursor.figure;
        if (t->picked < 0)
            begin_box(t);
        else
            grasp(t, &t->cursor);
    }
    if (t->phase == PHASE_BOX) {
        box_point(t);
        return;
    }
    t->moved |= tools_is_far(p->at, t->pressed_at, TOOLS_STEADY);
    if (t->moved)
        carry(t);
    if (p->released_now)
        drop(t);
}

void select_point(struct tools *t)
{
    const struct pointing *p = &t->pointing;
    if (t->phase == PHASE_BOX) {
        box_point(t);
        return;
    }
    t->cursor = pick(t);
    if (!p->pressed_now || !p->inside)
        return;
    if (t->cursor.figure >= 0)
        select_turn(&t->selection, t->cursor.figure);
    else
        begin_box(t);
    if (t->phase == PHASE_BOX && p->released_now)
        box_point(t);
}

/* ---- doing something to figures -------------------------------------------------------------- */

static enum drawing_status apply(struct tools *t, enum command command, int figure)
{
    if (command == COMMAND_DELETE) {
        drawing_delete(&t->drawing, figure);
        return DRAWING_OK;
    }
    return constraint_set(&t->drawing, figure,
                          command == COMMAND_HORIZONTAL ? CONSTRAINT_HORIZONTAL
                          : command == COMMAND_VERTICAL ? CONSTRAINT_VERTICAL
                                                        : CONSTRAINT_NONE,
                          &t->scratch);
}

void apply_point(struct tools *t)
{
    t->cursor = pick(t);
    if (!t->pointing.pressed_now || !t->pointing.inside || t->cursor.figure < 0)
        return;
    undo_begin(&t->undo);
    tools_worked(t, apply(t, t->tool, t->cursor.figure));
    tools_finish(t);
}

void apply_selection(struct tools *t, enum command command)
{
    undo_begin(&t->undo);
    for (int i = 0; i < DRAWING_FIGURES; i++)
        if (t->selection.figure[i])
            tools_worked(t, apply(t, command, i));
    tools_finish(t);
}
