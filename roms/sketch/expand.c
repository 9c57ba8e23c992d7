#include "roms/sketch/expand.h"

#include "roms/geometry/scalar.h"

struct point2 place_in_units(struct place p)
{
    return (struct point2){(float)p.x / PLACE_UNIT, (float)p.y / PLACE_UNIT};
}

static int32_t hundredths(float v)
{
    return scalar_nearest(scalar_clamp(v * PLACE_UNIT, -2 * PLACE_MOST, 2 * PLACE_MOST));
}

struct place place_of_units(float x, float y)
{
    return (struct place){hundredths(x), hundredths(y)};
}

/* ---- poses ----------------------------------------------------------------------------------- */

struct point2 pose_apply(const struct pose *pose, struct point2 p)
{
    return (struct point2){pose->a * p.x - pose->b * p.y + pose->x,
                           pose->b * p.x + pose->a * p.y + pose->y};
}

struct pose pose_product(const struct pose *a, const struct pose *b)
{
    struct point2 moved = pose_apply(a, (struct point2){b->x, b->y});
    return (struct pose){a->a * b->a - a->b * b->b, a->b * b->a + a->a * b->b, moved.x, moved.y};
}

struct pose pose_of_copy(const struct drawing_state *s, const struct figure *copy)
{
    struct sine_cosine k = scalar_sine_cosine((float)copy->angle / ANGLE_DEGREE);
    float scale = (float)copy->scale / SCALE_ONE;
    struct point2 at = place_in_units(s->point[copy->end[0]].at);
    struct point2 origin = place_in_units(s->master[copy->master].origin);
    struct pose turned = {scale * k.cosine, scale * k.sine, 0, 0};
    struct point2 back = pose_apply(&turned, origin);
    return (struct pose){turned.a, turned.b, at.x - back.x, at.y - back.y};
}

/* ---- figures --------------------------------------------------------------------------------- */

struct walk {
    const struct drawing_state *s;
    stroke_taker take;
    void *ctx;
    struct stroke stroke;
};

static void take_figure(struct walk *w, const struct figure *f, const struct pose *pose)
{
    struct stroke *k = &w->stroke;
    k->kind = (enum figure_kind)f->kind;
    for (int i = 0; i < figure_ends(f->kind); i++) {
        struct point2 p = place_in_units(w->s->point[f->end[i]].at);
        k->at[i] = k->inner ? pose_apply(pose, p) : p;
        k->point[i] = k->inner ? -1 : f->end[i];
    }
    w->take(w->ctx, k);
}

static void walk_copy(struct walk *w, const struct figure *copy, const struct pose *outer)
{
    struct pose own = pose_of_copy(w->s, copy), pose = pose_product(outer, &own);
    for (int i = 0; i < DRAWING_FIGURES; i++) {
        const struct figure *f = &w->s->figure[i];
        if (f->kind == FIGURE_NONE || f->picture != copy->master)
            continue;
        w->stroke.inner = true;
        if (f->kind == FIGURE_COPY)
            walk_copy(w, f, &pose);
        else
            take_figure(w, f, &pose);
    }
}

void expand_figure(const struct drawing_state *s, int figure, stroke_taker take, void *ctx)
{
    static const struct pose still = {1, 0, 0, 0};
    const struct figure *f = &s->figure[figure];
    struct walk w = {.s = s, .take = take, .ctx = ctx, .stroke = {.figure = figure}};
    if (f->kind == FIGURE_NONE)
        return;
    take_figure(&w, f, &still);
    if (f->kind == FIGURE_COPY)
        walk_copy(&w, f, &still);
}

void expand_picture(const struct drawing_state *s, int picture, stroke_taker take, void *ctx)
{
    for (int i = 0; i < DRAWING_FIGURES; i++)
        if (s->figure[i].kind != FIGURE_NONE && s->figure[i].picture == picture)
            expand_figure(s, i, take, ctx);
}

/* ---- geometry -------------------------------------------------------------------------------- */

static float length(struct point2 a, struct point2 b)
{
    float x = b.x - a.x, y = b.y - a.y;
    return sqrtf(x * x + y * y);
}

float stroke_radius(const struct stroke *stroke)
{
    return length(stroke->at[0], stroke->at[1]);
}

static float direction(struct point2 from, struct point2 to)
{
    return atan2f(to.y - from.y, to.x - from.x);
}

void stroke_arc(const struct stroke *stroke, float *begin, float *sweep)
{
    *begin = direction(stroke->at[0], stroke->at[1]);
    *sweep = direction(stroke->at[0], stroke->at[2]) - *begin;
    if (*sweep <= 0.0001f)
        *sweep += TURN;
}

static struct point2 nearest_on_line(const struct stroke *k, struct point2 p)
{
    struct point2 a = k->at[0], b = k->at[1];
    float x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
    float t = square > 0 ? ((p.x - a.x) * x + (p.y - a.y) * y) / square : 0;
    t = scalar_clamp(t, 0, 1);
    return (struct point2){a.x + t * x, a.y + t * y};
}

static struct point2 nearest_on_circle(const struct stroke *k, struct point2 p)
{
    struct point2 middle = k->at[0];
    float away = length(middle, p), radius = stroke_radius(k);
    if (away == 0 || radius == 0)
        return k->at[1];
    return (struct point2){middle.x + (p.x - middle.x) * radius / away,
                           middle.y + (p.y - middle.y) * radius / away};
}

static struct point2 arc_end(const struct stroke *k)
{
    float away = length(k->at[0], k->at[2]), radius = stroke_radius(k);
    if (away == 0)
        return k->at[1];
    return (struct point2){k->at[0].x + (k->at[2].x - k->at[0].x) * radius / away,
                           k->at[0].y + (k->at[2].y - k->at[0].y) * radius / away};
}

static struct point2 nearest_on_arc(const struct stroke *k, struct point2 p)
{
    float begin, sweep, way = direction(k->at[0], p);
    stroke_arc(k, &begin, &sweep);
    way -= begin;
    way += way < 0 ? TURN : 0;
    if (way <= sweep)
        return nearest_on_circle(k, p);
    struct point2 end = arc_end(k);
    return length(p, k->at[1]) < length(p, end) ? k->at[1] : end;
}

float stroke_nearest(const struct stroke *stroke, struct point2 p, struct point2 *on)
{
    *on = stroke->kind == FIGURE_LINE     ? nearest_on_line(stroke, p)
          : stroke->kind == FIGURE_CIRCLE ? nearest_on_circle(stroke, p)
          : stroke->kind == FIGURE_ARC    ? nearest_on_arc(stroke, p)
                                          : stroke->at[0];
    return length(p, *on);
}
