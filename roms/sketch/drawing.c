/* drawing.c — the store: points and figures are made, changed and deleted. */
#include "roms/sketch/drawing.h"

#include <stddef.h>
#include <string.h>

void drawing_begin(struct drawing *d)
{
    memset(d, 0, sizeof *d);
}

const char *drawing_sentence(enum drawing_status status)
{
    static const char *const sentences[] = {
        [DRAWING_OK] = "done",
        [DRAWING_POINTS_FULL] = "There is no room for more points: 768 are there.",
        [DRAWING_FIGURES_FULL] = "There is no room for more figures: 480 are there.",
        [DRAWING_MASTERS_FULL] = "There are 16 subpictures already.",
        [DRAWING_STROKES_FULL] = "That would show more than 1200 figures, those of copies counted.",
        [DRAWING_OUTSIDE] = "That would be too far outside.",
        [DRAWING_FLAT] = "That would leave a line without length.",
        [DRAWING_IN_ITSELF] = "A subpicture cannot hold a copy of itself.",
        [DRAWING_NOTHING] = "Nothing is selected.",
        [DRAWING_NO_MASTER] = "There is no subpicture yet: select something, then define.",
        [DRAWING_SAME_FIGURE] = "Both are ends of one figure.",
        [DRAWING_NO_LINE] = "Only lines can be kept horizontal or vertical.",
    };
    return sentences[status];
}

int figure_ends(unsigned kind)
{
    static const int ends[] = {[FIGURE_NONE] = 0,
                               [FIGURE_LINE] = 2,
                               [FIGURE_CIRCLE] = 2,
                               [FIGURE_ARC] = 3,
                               [FIGURE_COPY] = 1};
    return ends[kind];
}

bool place_is_inside(struct place p)
{
    return p.x >= -PLACE_MOST && p.x <= PLACE_MOST && p.y >= -PLACE_MOST && p.y <= PLACE_MOST;
}

/* ---- changes --------------------------------------------------------------------------------- */

static void tell(struct drawing *d, enum drawing_table table, int index)
{
    if (d->changing != NULL)
        d->changing(d->ctx, table, index);
}

struct drawing_point *drawing_change_point(struct drawing *d, int index)
{
    tell(d, TABLE_POINT, index);
    d->fresh_point[index] = true;
    d->fresh_masters |= d->now.point[index].picture != 0;
    return &d->now.point[index];
}

struct figure *drawing_change_figure(struct drawing *d, int index)
{
    tell(d, TABLE_FIGURE, index);
    d->fresh_figure[index] = true;
    d->fresh_masters |= d->now.figure[index].picture != 0;
    return &d->now.figure[index];
}

struct master *drawing_change_master(struct drawing *d, int index)
{
    tell(d, TABLE_MASTER, index);
    d->fresh_masters = true;
    return &d->now.master[index];
}

/* ---- points ---------------------------------------------------------------------------------- */

static int free_points(const struct drawing_state *s)
{
    int count = 0;
    for (int i = 0; i < DRAWING_POINTS; i++)
        count += s->point[i].users == 0;
    return count;
}

static int free_figure(const struct drawing_state *s)
{
    for (int i = 0; i < DRAWING_FIGURES; i++)
        if (s->figure[i].kind == FIGURE_NONE)
            return i;
    return -1;
}

/* There is room for it. */
static int new_point(struct drawing *d, unsigned picture, struct place at)
{
    int i = 0;
    while (d->now.point[i].users != 0)
        i++;
    *drawing_change_point(d, i) = (struct drawing_point){at, 1, (uint16_t)picture};
    d->fresh_masters |= picture != 0;
    return i;
}

static int use_point(struct drawing *d, unsigned picture, struct drawing_end end)
{
    if (end.point < 0)
        return new_point(d, picture, end.at);
    drawing_change_point(d, end.point)->users++;
    return end.point;
}

static void leave_point(struct drawing *d, int index)
{
    struct drawing_point *p = drawing_change_point(d, index);
    if (--p->users == 0)
        memset(p, 0, sizeof *p);
}

/* ---- figures --------------------------------------------------------------------------------- */

static enum drawing_status may_add(const struct drawing_state *s, const struct figure *like,
                                   const struct drawing_end *ends)
{
    int fresh = 0, more = like->kind == FIGURE_COPY ? drawing_strokes(s, like->master) : 1;
    for (int i = 0; i < figure_ends(like->kind); i++) {
        fresh += ends[i].point < 0;
        if (ends[i].point < 0 && !place_is_inside(ends[i].at))
            return DRAWING_OUTSIDE;
    }
    if (like->kind == FIGURE_COPY && drawing_reaches(s, like->master, like->picture))
        return DRAWING_IN_ITSELF;
    if (fresh > free_points(s))
        return DRAWING_POINTS_FULL;
    /* Each picture that shows this one grows by `more` for each copy of it: the drawing is the
     * largest of those that matter, but a subpicture may be shown nowhere. */
    if (drawing_strokes(s, like->picture) + more > DRAWING_STROKES)
        return DRAWING_STROKES_FULL;
    return free_figure(s) < 0 ? DRAWING_FIGURES_FULL : DRAWING_OK;
}

static bool any_picture_overflows(const struct drawing_state *s)
{
    for (int picture = 0; picture <= DRAWING_MASTERS; picture++)
        if (drawing_strokes(s, picture) > DRAWING_STROKES)
            return true;
    return false;
}

enum drawing_status drawing_add(struct drawing *d, const struct figure *like,
                                const struct drawing_end *ends, int *figure)
{
    enum drawing_status status = may_add(&d->now, like, ends);
    if (status != DRAWING_OK)
        return status;
    int i = free_figure(&d->now);
    struct figure made = *like;
    made.spare = 0;
    memset(made.end, 0, sizeof made.end);
    for (int k = 0; k < figure_ends(like->kind); k++)
        made.end[k] = (uint16_t)use_point(d, like->picture, ends[k]);
    *drawing_change_figure(d, i) = made;
    d->fresh_masters |= like->picture != 0;
    *figure = i;
    if (like->picture == 0 || !any_picture_overflows(&d->now))
        return DRAWING_OK;
    drawing_delete(d, i);
    return DRAWING_STROKES_FULL;
}

void drawing_delete(struct drawing *d, int figure)
{
    struct figure old = d->now.figure[figure];
    memset(drawing_change_figure(d, figure), 0, sizeof old);
    for (int i = 0; i < figure_ends(old.kind); i++)
        leave_point(d, old.end[i]);
}

void drawing_clear(struct drawing *d)
{
    for (int i = 0; i < DRAWING_FIGURES; i++)
        if (d->now.figure[i].kind != FIGURE_NONE)
            drawing_delete(d, i);
    for (int i = 1; i <= DRAWING_MASTERS; i++)
        if (d->now.master[i].used)
            memset(drawing_change_master(d, i), 0, sizeof(struct master));
}

static bool uses(const struct figure *f, int point)
{
    for (int i = 0; i < figure_ends(f->kind); i++)
        if (f->end[i] == point)
            return true;
    return false;
}

enum drawing_status drawing_merge(struct drawing *d, int from, int into)
{
    for (int i = 0; i < DRAWING_FIGURES; i++)
        if (uses(&d->now.figure[i], from) && uses(&d->now.figure[i], into))
            return DRAWING_SAME_FIGURE;
    for (int i = 0; i < DRAWING_FIGURES; i++) {
        if (!uses(&d->now.figure[i], from))
            continue;
        struct figure *f = drawing_change_figure(d, i);
        for (int k = 0; k < figure_ends(f->kind); k++) {
            if (f->end[k] != from)
                continue;
            f->end[k] = (uint16_t)into;
            drawing_change_point(d, into)->users++;
            leave_point(d, from);
        }
    }
    return DRAWING_OK;
}

/* ---- whole states ---------------------------------------------------------------------------- */

void drawing_become(struct drawing *d, const struct drawing_state *state)
{
    for (int i = 0; i < DRAWING_POINTS; i++)
        if (memcmp(&d->now.point[i], &state->point[i], sizeof state->point[i]) != 0)
            *drawing_change_point(d, i) = state->point[i];
    for (int i = 0; i < DRAWING_FIGURES; i++)
        if (memcmp(&d->now.figure[i], &state->figure[i], sizeof state->figure[i]) != 0)
            *drawing_change_figure(d, i) = state->figure[i];
    for (int i = 1; i <= DRAWING_MASTERS; i++)
        if (memcmp(&d->now.master[i], &state->master[i], sizeof state->master[i]) != 0)
            *drawing_change_master(d, i) = state->master[i];
    d->fresh_masters = true;
}

struct place drawing_end_place(const struct drawing_state *s, int figure, int end)
{
    return s->point[s->figure[figure].end[end]].at;
}

/* ---- what copies show ------------------------------------------------------------------------ */

/* Known counts are kept: each subpicture is looked through once. */
static int count_strokes(const struct drawing_state *s, int picture, int known[])
{
    if (known[picture] >= 0)
        return known[picture];
    int count = 0;
    for (int i = 0; i < DRAWING_FIGURES && count <= DRAWING_STROKES; i++) {
        const struct figure *f = &s->figure[i];
        if (f->kind == FIGURE_NONE || f->picture != picture)
            continue;
        count += f->kind == FIGURE_COPY ? count_strokes(s, f->master, known) : 1;
    }
    return known[picture] = count <= DRAWING_STROKES ? count : DRAWING_STROKES + 1;
}

int drawing_strokes(const struct drawing_state *s, int picture)
{
    int known[DRAWING_MASTERS + 1];
    for (int i = 0; i <= DRAWING_MASTERS; i++)
        known[i] = -1;
    return count_strokes(s, picture, known);
}

bool drawing_reaches(const struct drawing_state *s, int picture, int other)
{
    bool reached[DRAWING_MASTERS + 1] = {false};
    reached[picture] = true;
    for (bool more = true; more && !reached[other];) {
        more = false;
        for (int i = 0; i < DRAWING_FIGURES; i++) {
            const struct figure *f = &s->figure[i];
            if (f->kind != FIGURE_COPY || !reached[f->picture] || reached[f->master])
                continue;
            reached[f->master] = more = true;
        }
    }
    return reached[other];
}

int drawing_fullness(const struct drawing_state *s)
{
    int points = DRAWING_POINTS - free_points(s), figures = 0;
    for (int i = 0; i < DRAWING_FIGURES; i++)
        figures += s->figure[i].kind != FIGURE_NONE;
    points = (100 * points + DRAWING_POINTS - 1) / DRAWING_POINTS;
    figures = (100 * figures + DRAWING_FIGURES - 1) / DRAWING_FIGURES;
    int strokes = 100 * drawing_strokes(s, 0) / DRAWING_STROKES;
    points = points > figures ? points : figures;
    return points > strokes ? points : strokes;
}
