/* construction.c — how a point of the curve comes about: lines divided again and again. */
#include "roms/curves/casteljau.h"
#include "roms/stage/brush.h"
#include "roms/spline/view.h"

enum { MARK = 12, STEP = 5, MANY = 10 /* points: their lines are enough */ };

static const enum ink levels[] = {INK_GREEN, INK_VIOLET, INK_CYAN, INK_BLUE};

static enum ink ink_of(int level)
{
    return levels[(level - 1) % (int)(sizeof levels / sizeof *levels)];
}

/* Points and lines of one level; the last one is the point itself. */
static void draw_level(struct stage *s, const struct vector3 *p, int count, int level)
{
    brush_path(s, p, count, ink_of(level));
    for (int i = 0; i < count && count > 1 && count + level <= MANY; i++)
        brush_point(s, p[i], STEP, ink_of(level));
}

static struct vector3 casteljau_draw(const struct curve *c, int piece, float u, struct stage *s)
{
    struct casteljau steps;
    struct vector3 p[BEZIER_POINTS_MOST];
    casteljau_begin(&steps, curve_piece(c, piece), c->order, u);
    while (casteljau_next(&steps)) {
        int count = c->order - steps.level;
        for (int i = 0; i < count; i++)
            p[i] = casteljau_at(&steps, steps.level, i);
        draw_level(s, p, count, steps.level);
    }
    return casteljau_at(&steps, c->order - 1, 0);
}

/* The B-spline's own parameter begins at its knot 3. */
static struct vector3 de_boor_draw(const struct b_spline *b, float t, struct stage *s)
{
    struct de_boor steps;
    de_boor_begin(&steps, b, b_spline_start(b) + t);
    while (de_boor_next(&steps))
        draw_level(s, steps.at, b->degree + 1 - steps.level, steps.level);
    return steps.at[0];
}

/* The tangent through the point, a fixed length to each side. */
static void draw_tangent(struct stage *s, const struct curve_place *at)
{
    struct vector3 along = vector3_times(vector3_direction(at->first), 110);
    brush_line(s, vector3_difference(at->at, along), vector3_sum(at->at, along), INK_RED);
}

void construction_draw(const struct editor *e, const struct curve *c, struct stage *s)
{
    struct b_spline b;
    float t = curve_t(c, e->part);
    struct curve_place at = curve_at(c, t);
    draw_tangent(s, &at);
    struct vector3 point = curve_b_spline(&e->model, &b) ? de_boor_draw(&b, t, s)
                                                         : casteljau_draw(c, at.piece, at.u, s);
    brush_point(s, point, MARK, INK_RED);
}
