#include "roms/sketch/subpicture.h"

#include <string.h>

/* Ends of selected figures at each point. */
struct census {
    uint16_t ends[DRAWING_POINTS];
    int figures, shared;
    struct place origin;
};

static bool is_before(struct place a, struct place b)
{
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

static void count(const struct drawing_state *s, int picture, const bool *selected,
                  struct census *c)
{
    memset(c, 0, sizeof *c);
    for (int i = 0; i < DRAWING_FIGURES; i++) {
        const struct figure *f = &s->figure[i];
        if (!selected[i] || f->kind == FIGURE_NONE || f->picture != picture)
            continue;
        for (int k = 0; k < figure_ends(f->kind); k++) {
            struct place at = s->point[f->end[k]].at;
            if ((c->figures == 0 && k == 0) || is_before(at, c->origin))
                c->origin = at;
            c->ends[f->end[k]]++;
        }
        c->figures++;
    }
    for (int i = 0; i < DRAWING_POINTS; i++)
        c->shared += c->ends[i] != 0 && c->ends[i] != s->point[i].users;
}

/* Exchanges the point of all these figures' ends for one of the subpicture's own. */
static void separate(struct drawing *d, int picture, const bool *selected, int point, int ends,
                     int master)
{
    int own = 0;
    while (d->now.point[own].users != 0)
        own++;
    *drawing_change_point(d, own) =
        (struct drawing_point){d->now.point[point].at, (uint16_t)ends, (uint16_t)master};
    struct drawing_point *p = drawing_change_point(d, point);
    p->users = (uint16_t)(p->users - ends);
    for (int i = 0; i < DRAWING_FIGURES; i++) {
        const struct figure *f = &d->now.figure[i];
        if (!selected[i] || f->kind == FIGURE_NONE || f->picture != picture)
            continue;
        for (int k = 0; k < figure_ends(f->kind); k++)
            if (f->end[k] == point)
                drawing_change_figure(d, i)->end[k] = (uint16_t)own;
    }
}

static void move_into(struct drawing *d, int picture, const bool *selected, int master,
                      const struct census *c)
{
    for (int i = 0; i < DRAWING_POINTS; i++) {
        if (c->ends[i] == 0)
            continue;
        if (c->ends[i] == d->now.point[i].users)
            drawing_change_point(d, i)->picture = (uint16_t)master;
        else
            separate(d, picture, selected, i, c->ends[i], master);
    }
    for (int i = 0; i < DRAWING_FIGURES; i++)
        if (selected[i] && d->now.figure[i].kind != FIGURE_NONE &&
            d->now.figure[i].picture == picture)
            drawing_change_figure(d, i)->picture = (uint8_t)master;
}

static int unused_master(const struct drawing_state *s)
{
    for (int i = 1; i <= DRAWING_MASTERS; i++)
        if (!s->master[i].used)
            return i;
    return 0;
}

static enum drawing_status may_define(const struct drawing_state *s, const struct census *c,
                                      int master)
{
    int points = 0, figures = 0;
    for (int i = 0; i < DRAWING_POINTS; i++)
        points += s->point[i].users == 0;
    for (int i = 0; i < DRAWING_FIGURES; i++)
        figures += s->figure[i].kind == FIGURE_NONE;
    return c->figures == 0          ? DRAWING_NOTHING
           : master == 0            ? DRAWING_MASTERS_FULL
           : points < c->shared + 1 ? DRAWING_POINTS_FULL
           : figures < 1            ? DRAWING_FIGURES_FULL
                                    : DRAWING_OK;
}

/* The picture's own point there stays in use: what was joined there stays joined to the copy. */
static int point_there(const struct drawing_state *s, int picture, struct place at)
{
    for (int i = 0; i < DRAWING_POINTS; i++)
        if (s->point[i].users != 0 && s->point[i].picture == picture && s->point[i].at.x == at.x &&
            s->point[i].at.y == at.y)
            return i;
    return -1;
}

enum drawing_status subpicture_define(struct drawing *d, int picture,
                                      const bool selected[DRAWING_FIGURES], int *master, int *copy)
{
    struct census c;
    count(&d->now, picture, selected, &c);
    int made = unused_master(&d->now);
    enum drawing_status status = may_define(&d->now, &c, made);
    if (status != DRAWING_OK)
        return status;
    *drawing_change_master(d, made) = (struct master){c.origin, 1};
    move_into(d, picture, selected, made, &c);
    struct figure like = {.kind = FIGURE_COPY,
                          .picture = (uint8_t)picture,
                          .master = (uint8_t)made,
                          .scale = SCALE_ONE};
    struct drawing_end end = {point_there(&d->now, picture, c.origin), c.origin};
    *master = made;
    return drawing_add(d, &like, &end, copy); /* there is room */
}

int subpicture_next(const struct drawing_state *s, int master)
{
    for (int i = 1; i <= DRAWING_MASTERS; i++) {
        int next = (master + i - 1) % DRAWING_MASTERS + 1;
        if (s->master[next].used)
            return next;
    }
    return 0;
}

int subpicture_copies(const struct drawing_state *s, int master)
{
    int copies = 0;
    for (int i = 0; i < DRAWING_FIGURES; i++)
        copies += s->figure[i].kind == FIGURE_COPY && s->figure[i].master == master;
    return copies;
}
