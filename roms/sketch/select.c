#include "roms/sketch/select.h"

#include <string.h>

#include "roms/geometry/scalar.h"
#include "roms/sketch/expand.h"

void select_none(struct selection *s)
{
    memset(s, 0, sizeof *s);
}

void select_turn(struct selection *s, int figure)
{
    s->figure[figure] = !s->figure[figure];
    s->count += s->figure[figure] ? 1 : -1;
}

void select_check(struct selection *s, const struct drawing_state *state, int picture)
{
    s->count = 0;
    for (int i = 0; i < DRAWING_FIGURES; i++) {
        const struct figure *f = &state->figure[i];
        s->figure[i] = s->figure[i] && f->kind != FIGURE_NONE && f->picture == picture;
        s->count += s->figure[i];
    }
}

/* ---- boxes ----------------------------------------------------------------------------------- */

struct box {
    float x0, y0, x1, y1;
    bool holds; /* all so far */
};

static void hold(struct box *b, float x, float y)
{
    if (!(x >= b->x0 && x <= b->x1 && y >= b->y0 && y <= b->y1))
        b->holds = false;
}

/* A circle as if it were whole; an arc at its ends and a few places between. */
static void take(void *ctx, const struct stroke *stroke)
{
    enum { PLACES = 16 };
    struct box *b = ctx;
    float begin = 0, sweep = TURN, radius;
    if (stroke->kind == FIGURE_LINE || stroke->kind == FIGURE_COPY) {
        for (int i = 0; i < figure_ends(stroke->kind); i++)
            hold(b, stroke->at[i].x, stroke->at[i].y);
        return;
    }
    radius = stroke_radius(stroke);
    if (stroke->kind == FIGURE_ARC)
        stroke_arc(stroke, &begin, &sweep);
    for (int i = 0; i <= PLACES; i++) {
        float angle = begin + sweep * (float)i / PLACES;
        hold(b, stroke->at[0].x + radius * cosf(angle), stroke->at[0].y + radius * sinf(angle));
    }
}

int select_box(struct selection *s, const struct drawing_state *state, int picture, struct place a,
               struct place b)
{
    const float slack = 0.5f;
    struct point2 p = place_in_units(a), q = place_in_units(b);
    int added = 0;
    for (int i = 0; i < DRAWING_FIGURES; i++) {
        struct box box = {scalar_min(p.x, q.x) - slack, scalar_min(p.y, q.y) - slack,
                          scalar_max(p.x, q.x) + slack, scalar_max(p.y, q.y) + slack, true};
        if (state->figure[i].kind == FIGURE_NONE || state->figure[i].picture != picture)
            continue;
        expand_figure(state, i, take, &box);
        if (!box.holds || s->figure[i])
            continue;
        select_turn(s, i);
        added++;
    }
    return added;
}
