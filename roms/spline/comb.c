/* comb.c — curvature as teeth across the curve, and how joints join. */
#include "roms/clip/liang_barsky.h"
#include "roms/geometry/scalar.h"

#include "roms/spline/view.h"

/* A tooth is LONG times the curvature: a circle of 100 units has teeth of 90. */
enum { LONG = 9000, MOST = 110 };

static struct vector3 tip_of(const struct curve_place *p)
{
    float length = vector3_length(p->first);
    float tooth = scalar_min(scalar_max(-p->curvature * LONG, -MOST), MOST);
    if (!(length > 1e-3f))
        return p->at;
    return (struct vector3){p->at.x - p->first.y / length * tooth,
                            p->at.y + p->first.x / length * tooth, 0};
}

/* Within the drawing area. */
static void draw_tooth(struct stage *s, struct vector3 from, struct vector3 to, enum ink ink)
{
    static const struct clip_window area = {0, MODEL_BOTTOM, MODEL_RIGHT + 10, STAGE_HEIGHT};
    struct point2 a = {from.x, from.y}, b = {to.x, to.y};
    stage_ink(s, ink);
    if (clip_liang_barsky(&area, &a, &b))
        stage_line(s, a.x, a.y, b.x, b.y);
}

/* Each piece by itself, so that a jump of curvature at a joint is seen. */
static void draw_piece(const struct curve *c, int piece, struct stage *s)
{
    int teeth = c->pieces > 8 ? 7 : c->pieces > 1 ? 14 : c->order > 10 ? 32 : 64;
    struct vector3 before = {0, 0, 0};
    for (int i = 0; i <= teeth; i++) {
        float inside = scalar_min(scalar_max((float)i / (float)teeth, 1e-4f), 0.9999f);
        float t = c->knot[piece] + inside * (c->knot[piece + 1] - c->knot[piece]);
        struct curve_place p = curve_at(c, t);
        struct vector3 tip = tip_of(&p);
        draw_tooth(s, p.at, tip, INK_BLUE);
        if (i > 0)
            draw_tooth(s, before, tip, INK_VIOLET);
        before = tip;
    }
}

void comb_draw(const struct curve *c, struct stage *s)
{
    for (int i = 0; i < c->pieces; i++)
        draw_piece(c, i, s);
}

/* ---- joints -------------------------------------------------------------------------------------- */

static const char *name_of(const struct continuity *c)
{
    return c->c2            ? "C2"
           : c->g2 && c->c1 ? "C1 G2"
           : c->c1          ? "C1"
           : c->g2          ? "G2"
           : c->g1          ? "G1"
                            : "C0";
}

/* Of many joints, those that are not smooth. */
void joints_draw(const struct curve *c, struct stage *s)
{
    enum { MANY = 10 };
    for (int i = 0; i < curve_joints(c); i++) {
        struct join join = curve_join(c, i);
        struct continuity how = continuity_of(&join);
        if (curve_joints(c) > MANY && how.c2)
            continue;
        stage_ink(s, how.g1 ? INK_GREEN : INK_RED);
        if (how.g1)
            stage_text_middle(s, join.p[0].x, join.p[0].y - 36, name_of(&how));
        else
            stage_text_middle(s, join.p[0].x, join.p[0].y - 36, "C0 kink");
    }
}
