#include "roms/sketch/constraint.h"

#include <string.h>

void constraint_begin(struct constraint_move *move)
{
    memset(move->moved, 0, sizeof move->moved);
}

void constraint_to(struct constraint_move *move, int point, struct place to)
{
    move->moved[point] = true;
    move->to[point] = to;
}

static void start(const struct drawing_state *s, struct constraint_move *move)
{
    for (int i = 0; i < DRAWING_POINTS; i++) {
        move->x_given[i] = move->y_given[i] = move->moved[i];
        if (!move->moved[i])
            move->to[i] = s->point[i].at;
    }
}

/* One coordinate goes from the end that has it to the other one. True: it did. */
static bool pass(const struct figure *f, struct constraint_move *m)
{
    bool level = f->constraint == CONSTRAINT_HORIZONTAL;
    bool *given = level ? m->y_given : m->x_given;
    int from = f->end[0], to = f->end[1];
    if (given[from] == given[to])
        return false;
    if (given[to]) {
        from = f->end[1];
        to = f->end[0];
    }
    given[to] = true;
    if (level)
        m->to[to].y = m->to[from].y;
    else
        m->to[to].x = m->to[from].x;
    return true;
}

static void propagate(const struct drawing_state *s, struct constraint_move *move)
{
    for (bool more = true; more;) {
        more = false;
        for (int i = 0; i < DRAWING_FIGURES; i++)
            if (s->figure[i].constraint != CONSTRAINT_NONE && pass(&s->figure[i], move))
                more = true;
    }
}

static bool is_given(const struct constraint_move *move, int point)
{
    return move->x_given[point] || move->y_given[point];
}

static bool all_inside(const struct constraint_move *move)
{
    for (int i = 0; i < DRAWING_POINTS; i++)
        if (is_given(move, i) && !place_is_inside(move->to[i]))
            return false;
    return true;
}

static void write_places(struct drawing *d, const struct constraint_move *move)
{
    for (int i = 0; i < DRAWING_POINTS; i++) {
        struct place old = d->now.point[i].at;
        if (is_given(move, i) && (old.x != move->to[i].x || old.y != move->to[i].y))
            drawing_change_point(d, i)->at = move->to[i];
    }
}

enum drawing_status constraint_apply(struct drawing *d, struct constraint_move *move)
{
    start(&d->now, move);
    propagate(&d->now, move);
    if (!all_inside(move))
        return DRAWING_OUTSIDE;
    write_places(d, move);
    return DRAWING_OK;
}

/* A line that has length now and would have none. */
static bool flattens(const struct drawing_state *s, const struct constraint_move *move)
{
    for (int i = 0; i < DRAWING_FIGURES; i++) {
        const struct figure *f = &s->figure[i];
        if (f->kind != FIGURE_LINE)
            continue;
        struct place a = s->point[f->end[0]].at, b = s->point[f->end[1]].at;
        struct place c = move->to[f->end[0]], e = move->to[f->end[1]];
        if ((a.x != b.x || a.y != b.y) && c.x == e.x && c.y == e.y)
            return true;
    }
    return false;
}

enum drawing_status constraint_set(struct drawing *d, int line, enum constraint constraint,
                                   struct constraint_move *scratch)
{
    const struct figure *f = &d->now.figure[line];
    if (f->kind != FIGURE_LINE)
        return DRAWING_NO_LINE;
    struct place a = d->now.point[f->end[0]].at, to = d->now.point[f->end[1]].at;
    if (constraint == CONSTRAINT_HORIZONTAL)
        to.y = a.y;
    if (constraint == CONSTRAINT_VERTICAL)
        to.x = a.x;
    constraint_begin(scratch);
    constraint_to(scratch, f->end[1], to);
    start(&d->now, scratch);
    propagate(&d->now, scratch);
    /* Other lines may lead back to the first end, which then has moved, too. */
    if (flattens(&d->now, scratch))
        return DRAWING_FLAT;
    write_places(d, scratch);
    drawing_change_figure(d, line)->constraint = (uint8_t)constraint;
    return DRAWING_OK;
}
