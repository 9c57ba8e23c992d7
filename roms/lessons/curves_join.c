/* curves_join.c — page about joins: what C0, C1, C2 and G1, G2 look like. */
#include "roms/curves/bezier.h"
#include "roms/curves/continuity.h"
#include "roms/lessons/curves.h"

/* q1 and q2 from p1 … p3 so that q′ = k·p′ and q″ = k²·p″ + m·p′ at the join. */
static void continue_curve(const struct vector3 *p, float k, float m, struct vector3 q[4])
{
    struct bezier_ends e = bezier_ends(p, 4);
    struct vector3 first = vector3_times(e.first1, k);
    struct vector3 second =
        vector3_sum(vector3_times(e.second1, k * k), vector3_times(e.first1, m));
    q[0] = p[3];
    q[1] = vector3_sum(q[0], vector3_times(first, 1 / 3.0f));
    q[2] = vector3_sum(vector3_difference(vector3_times(q[1], 2), q[0]),
                       vector3_times(second, 1 / 6.0f));
}

/* Stages of the page: from a kink to C2. `bend` turns q1 away, `lift` moves q2 off. */
static const struct join_stage {
    const char *what;
    float k, m, bend, lift;
} stages[] = {
    {"C0 G0: a kink", 0.8f, 0, 0.9f, 40},   {"G1: same direction", 0.55f, 0, 0, 60},
    {"G2: same curvature", 0.55f, 0, 0, 0}, {"C1: same p'", 1, 0, 0, 90},
    {"C2: same p' and p\"", 1, 0, 0, 0},
};
enum { STAGES = sizeof stages / sizeof stages[0] };

static struct vector3 turned(struct vector3 v, float angle)
{
    float c = cosf(angle), s = sinf(angle);
    return (struct vector3){c * v.x - s * v.y, s * v.x + c * v.y, 0};
}

/* Lines across the curve, as long as it is bent: curvature |p′ × p″| / |p′|³. */
static void draw_comb(struct stage *s, const struct vector3 *curve, enum ink ink)
{
    enum { TEETH = 16, LONG = 26000, MOST = 170 };
    struct cubic_geometry g = {.kind = CUBIC_BEZIER, .g = {curve[0], curve[1], curve[2], curve[3]}};
    struct cubic q = cubic_by_matrix(&g);
    struct vector3 before = {0, 0, 0};
    for (int i = 0; i <= TEETH; i++) {
        float u = (float)i / TEETH;
        struct vector3 p = cubic_point(&q, u), d = cubic_derivative(&q, 1, u);
        float length = vector3_length(d);
        if (length < 1)
            continue;
        float bent = vector3_cross(d, cubic_derivative(&q, 2, u)).z / (length * length * length);
        float tooth = fminf(fmaxf(-bent * LONG, -MOST), MOST) / length;
        struct vector3 tip = {p.x - d.y * tooth, p.y + d.x * tooth, 0};
        brush_thin(s, p, tip, ink);
        if (i > 0)
            brush_thin(s, before, tip, ink);
        before = tip;
    }
}

static void draw_verdicts(struct stage *s, const struct continuity *c)
{
    static const char *const names[] = {"C0", "C1", "C2", "G0", "G1", "G2"};
    const bool holds[] = {c->c0, c->c1, c->c2, c->g0, c->g1, c->g2};
    for (int i = 0; i < 6; i++) {
        float x = 130 + 90 * (float)(i % 3) + (i < 3 ? 0.0f : 670);
        pen_words(s, x, 30, holds[i] ? INK_GREEN : INK_GRID, names[i]);
        if (!holds[i])
            brush_thin(s, (struct vector3){x - 24, 26, 0}, (struct vector3){x + 24, 62, 0},
                       INK_RED);
    }
}

static void join(const struct curves_view *v, struct stage *s)
{
    int stage = (int)(v->value * 4.999f);
    const struct join_stage *at = &stages[stage];
    const struct vector3 *p = v->point;
    struct vector3 q[4];
    continue_curve(p, at->k, at->m, q);
    q[1] = vector3_sum(q[0], turned(vector3_difference(q[1], q[0]), at->bend));
    q[2] = vector3_sum(q[2], (struct vector3){0, at->lift, 0});
    q[3] = v->point[4];
    struct cubic_geometry a = {.kind = CUBIC_BEZIER, .g = {p[0], p[1], p[2], p[3]}};
    struct cubic_geometry b = {.kind = CUBIC_BEZIER, .g = {q[0], q[1], q[2], q[3]}};
    struct spline both = {.pieces = 2, .knot = {0, 1, 2}, .piece = {a, b}};
    struct join j = spline_join(&both, 0);
    struct continuity c = continuity_of(&j);
    draw_comb(s, p, INK_BLUE);
    draw_comb(s, q, INK_VIOLET);
    brush_path(s, p, 4, INK_GRID);
    brush_path(s, q, 4, INK_GRID);
    brush_bezier(s, p, 4, INK_CYAN);
    brush_bezier(s, q, 4, INK_YELLOW);
    pen_arrow(s, p[3], vector3_times(j.p[1], -1 / 3.0f), INK_CYAN);
    pen_arrow(s, p[3], vector3_times(j.q[1], 1 / 3.0f), INK_YELLOW);
    curves_draw_controls(v, s, INK_CYAN);
    brush_point(s, p[3], 12, INK_RED);
    draw_verdicts(s, &c);
    pen_words(s, 600, 740, INK_BRIGHT, at->what);
}

const struct curves_page curves_page_join = {
    .title = "How smoothly two curves join",
    .caption = "The comb shows curvature: with G2 it does not jump at the join.",
    .period = 32,
    .drift = 0.3f,
    .count = 5,
    .start = {{90, 330}, {200, 580}, {400, 620}, {590, 500}, {1090, 560}},
    .draw = join};
