/* tools.c — commands, and what the tools have in common. */
#include <stdio.h>
#include <string.h>

#include "roms/sketch/subpicture.h"
#include "roms/sketch/tools_parts.h"

enum {
    SPACING_LEAST = 10 * PLACE_UNIT,
    SPACING_MOST = 160 * PLACE_UNIT,
    ANGLE_STEP = 15 * ANGLE_DEGREE,
    SCALE_STEP = 100,
    COPY_SCALE_LEAST = 100,
    COPY_SCALE_MOST = 4000
};

void tools_begin(struct tools *t)
{
    memset(t, 0, sizeof *t);
    drawing_begin(&t->drawing);
    undo_attach(&t->undo, &t->drawing);
    t->tool = COMMAND_LINE;
    t->snap = (struct snap_settings){true, true, 40 * PLACE_UNIT, 14};
    t->grid_shown = true;
    t->scale = SCALE_ONE;
    t->cursor = (struct snapped){.point = -1, .figure = -1};
}

void tools_say(struct tools *t, const char *sentence)
{
    snprintf(t->message, sizeof t->message, "%s", sentence);
}

bool tools_worked(struct tools *t, enum drawing_status status)
{
    if (status != DRAWING_OK)
        tools_say(t, drawing_sentence(status));
    return status == DRAWING_OK;
}

/* ---- geometry -------------------------------------------------------------------------------- */

static int32_t size_of(int32_t v)
{
    return v < 0 ? -v : v;
}

bool tools_is_far(struct place a, struct place b, int32_t distance)
{
    return size_of(a.x - b.x) > distance || size_of(a.y - b.y) > distance;
}

struct place tools_aligned(struct place from, struct place at)
{
    bool level = size_of(at.x - from.x) >= size_of(at.y - from.y);
    return level ? (struct place){at.x, from.y} : (struct place){from.x, at.y};
}

struct snapped tools_snap(const struct tools *t, struct place at)
{
    return snap(&t->drawing.now, t->picture, &t->snap, at,
                t->phase == PHASE_IDLE ? NULL : &t->moving);
}

void tools_follow(struct tools *t, const int *points, int count)
{
    const struct drawing_state *s = &t->drawing.now;
    memset(&t->moving, 0, sizeof t->moving);
    memset(t->carried, 0, sizeof t->carried);
    constraint_begin(&t->scratch);
    for (int i = 0; i < count; i++) {
        t->carried[points[i]] = true;
        constraint_to(&t->scratch, points[i], s->point[points[i]].at);
    }
    constraint_apply(&t->drawing, &t->scratch); /* moves nothing, but tells what follows */
    for (int i = 0; i < DRAWING_POINTS; i++) {
        t->moving.point[i] = t->scratch.x_given[i] || t->scratch.y_given[i];
        t->start[i] = s->point[i].at;
    }
    for (int i = 0; i < DRAWING_FIGURES; i++)
        for (int k = 0; k < figure_ends(s->figure[i].kind); k++)
            t->moving.figure[i] |= t->moving.point[s->figure[i].end[k]];
}

/* ---- steps ----------------------------------------------------------------------------------- */

void tools_finish(struct tools *t)
{
    undo_commit(&t->undo);
    t->phase = PHASE_IDLE;
    select_check(&t->selection, &t->drawing.now, t->picture);
}

void tools_leave_off(struct tools *t)
{
    if (t->undo.open)
        undo_cancel(&t->undo);
    t->phase = PHASE_IDLE;
    select_check(&t->selection, &t->drawing.now, t->picture);
}

/* What is shown and chosen may be gone. */
static void check_pictures(struct tools *t)
{
    const struct master *master = t->drawing.now.master;
    if (t->picture != 0 && !master[t->picture].used)
        t->picture = 0;
    if (t->master == 0 || !master[t->master].used)
        t->master = subpicture_next(&t->drawing.now, 0);
    select_check(&t->selection, &t->drawing.now, t->picture);
}

void tools_replace(struct tools *t, const struct drawing_state *state)
{
    tools_leave_off(t);
    undo_begin(&t->undo);
    drawing_become(&t->drawing, state);
    t->picture = 0;
    tools_finish(t);
    check_pictures(t);
}

/* ---- pointing -------------------------------------------------------------------------------- */

void tools_point(struct tools *t, const struct pointing *pointing)
{
    t->pointing = *pointing;
    if (pointing->pressed_now && pointing->inside)
        t->message[0] = '\0';
    switch (t->tool) {
    case COMMAND_LINE:
    case COMMAND_CHAIN:
    case COMMAND_CIRCLE:
    case COMMAND_ARC:
        place_point(t);
        break;
    case COMMAND_COPY:
        copy_point(t);
        break;
    case COMMAND_MOVE:
        move_point(t);
        break;
    case COMMAND_SELECT:
        select_point(t);
        break;
    default:
        apply_point(t);
    }
}

bool tools_band(const struct tools *t, struct place *to)
{
    *to = t->phase == PHASE_PLACING ? drawing_end_place(&t->drawing.now, t->figure, t->end)
          : t->phase == PHASE_BOX   ? t->pointing.at
                                    : t->cursor.at;
    return (t->phase == PHASE_PLACING && t->tool != COMMAND_COPY) || t->phase == PHASE_BOX ||
           (t->phase == PHASE_MOVING && t->moved);
}

/* ---- commands -------------------------------------------------------------------------------- */

static void choose(struct tools *t, enum command tool)
{
    if (tool >= COMMAND_HORIZONTAL && t->selection.count > 0) {
        apply_selection(t, tool);
        return;
    }
    /* Chosen again: copies of the next subpicture. */
    if (tool == COMMAND_COPY)
        t->master = subpicture_next(&t->drawing.now,
                                    t->tool == tool || t->master == 0 ? t->master : t->master - 1);
    if (tool == COMMAND_COPY && t->master == 0) {
        tools_worked(t, DRAWING_NO_MASTER);
        return;
    }
    t->tool = tool;
    if (tool == COMMAND_COPY)
        snprintf(t->message, sizeof t->message,
                 "Copies of subpicture %c. Copy again: the next subpicture.", 'A' + t->master - 1);
}

static void define(struct tools *t)
{
    int master, copy;
    undo_begin(&t->undo);
    enum drawing_status status =
        subpicture_define(&t->drawing, t->picture, t->selection.figure, &master, &copy);
    if (!tools_worked(t, status)) {
        tools_leave_off(t);
        return;
    }
    tools_finish(t);
    t->master = master;
    snprintf(t->message, sizeof t->message,
             "That is subpicture %c now: Copy places it again, Open changes it.", 'A' + master - 1);
}

static void open(struct tools *t)
{
    int master = t->picture != 0 ? 0 : t->master;
    for (int i = 0; i < DRAWING_FIGURES; i++)
        if (t->selection.figure[i] && t->drawing.now.figure[i].kind == FIGURE_COPY)
            master = t->drawing.now.figure[i].master;
    if (master == 0 && t->picture == 0) {
        tools_worked(t, DRAWING_NO_MASTER);
        return;
    }
    t->picture = master;
    select_none(&t->selection);
    if (master == 0)
        tools_say(t, "This is the drawing.");
    else
        snprintf(t->message, sizeof t->message,
                 "Subpicture %c: its copies change with it. Open goes back.", 'A' + master - 1);
}

static int32_t stepped(int32_t v, int32_t step, int32_t least, int32_t most)
{
    v += step;
    return v < least ? least : v > most ? most : v;
}

static void turned(int32_t *scale, int32_t *angle, enum command command)
{
    if (command == COMMAND_TURN_LEFT || command == COMMAND_TURN_RIGHT)
        *angle = (*angle + ANGLE_TURN + (command == COMMAND_TURN_LEFT ? ANGLE_STEP : -ANGLE_STEP)) %
                 ANGLE_TURN;
    else if (command == COMMAND_LARGER)
        *scale = stepped(*scale, SCALE_STEP, COPY_SCALE_LEAST, COPY_SCALE_MOST);
    else
        *scale = stepped(*scale, -SCALE_STEP, COPY_SCALE_LEAST, COPY_SCALE_MOST);
}

/* Of copies that are selected, else of those to come. */
static void turn_or_scale(struct tools *t, enum command command)
{
    bool any = false;
    if (t->selection.count > 0 && t->phase == PHASE_IDLE && t->tool != COMMAND_COPY) {
        undo_begin(&t->undo);
        for (int i = 0; i < DRAWING_FIGURES; i++) {
            if (!t->selection.figure[i] || t->drawing.now.figure[i].kind != FIGURE_COPY)
                continue;
            struct figure *f = drawing_change_figure(&t->drawing, i);
            turned(&f->scale, &f->angle, command);
            any = true;
        }
        tools_finish(t);
    }
    if (any)
        return;
    turned(&t->scale, &t->angle, command);
    copy_renew(t);
    snprintf(t->message, sizeof t->message, "Copies to come: scale %ld.%ld, turned by %ld degrees.",
             (long)(t->scale / SCALE_ONE), (long)(t->scale % SCALE_ONE / SCALE_STEP),
             (long)(t->angle / ANGLE_DEGREE));
}

static void history(struct tools *t, bool back)
{
    tools_leave_off(t);
    if (!(back ? undo_back(&t->undo) : undo_again(&t->undo)))
        tools_say(t, back ? "There is nothing to take back." : "There is nothing to do again.");
    check_pictures(t);
}

static void clear(struct tools *t)
{
    undo_begin(&t->undo);
    drawing_clear(&t->drawing);
    tools_finish(t);
    check_pictures(t);
    tools_say(t, "All is gone; Undo brings it back.");
}

static void say_whether(struct tools *t, const char *what, bool on)
{
    snprintf(t->message, sizeof t->message, "%s %s.", what, on ? "on" : "off");
}

static void space(struct tools *t, bool wider)
{
    int32_t *spacing = &t->snap.spacing;
    if (wider && *spacing < SPACING_MOST)
        *spacing *= 2;
    else if (!wider && *spacing > SPACING_LEAST)
        *spacing /= 2;
    snprintf(t->message, sizeof t->message, "The grid's places are %ld apart.",
             (long)(*spacing / PLACE_UNIT));
}

static void set(struct tools *t, enum command command)
{
    struct snap_settings *s = &t->snap;
    if (command == COMMAND_GRID)
        say_whether(t, "Grid shown:", t->grid_shown = !t->grid_shown);
    else if (command == COMMAND_SNAP)
        say_whether(t, "The grid attracts:", s->grid = !s->grid);
    else if (command == COMMAND_GRAVITY)
        say_whether(t, "Points and lines attract:", s->gravity = !s->gravity);
    else if (command == COMMAND_UPRIGHT)
        say_whether(t, "New lines horizontal or vertical, and kept so:", t->upright = !t->upright);
    else
        space(t, command == COMMAND_WIDER);
}

static void escape(struct tools *t)
{
    if (t->phase == PHASE_IDLE || t->tool == COMMAND_COPY)
        select_none(&t->selection);
    if (t->tool == COMMAND_COPY)
        t->tool = COMMAND_MOVE;
}

void tools_command(struct tools *t, enum command command)
{
    bool keeps = command >= COMMAND_GRID && command < COMMAND_ESCAPE;
    keeps |= command >= COMMAND_TURN_LEFT && command <= COMMAND_SMALLER;
    bool under_way = t->phase != PHASE_IDLE && t->tool != COMMAND_COPY;
    t->message[0] = '\0';
    if (command == COMMAND_ESCAPE)
        escape(t);
    if (!keeps)
        tools_leave_off(t);
    if (command == COMMAND_UNDO && under_way)
        return; /* that is what was taken back */
    if (command < COMMAND_TOOLS)
        choose(t, command);
    else if (command == COMMAND_DEFINE)
        define(t);
    else if (command == COMMAND_OPEN)
        open(t);
    else if (command >= COMMAND_TURN_LEFT && command <= COMMAND_SMALLER)
        turn_or_scale(t, command);
    else if (command == COMMAND_UNDO || command == COMMAND_REDO)
        history(t, command == COMMAND_UNDO);
    else if (command == COMMAND_CLEAR)
        clear(t);
    else if (command >= COMMAND_GRID && command <= COMMAND_UPRIGHT)
        set(t, command);
}
