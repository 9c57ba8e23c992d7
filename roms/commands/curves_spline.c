/* curves_spline.c — splines, and their pieces by each of the three equivalent ways. */
#include "roms/commands/curves.h"

#include <stdio.h>

#include "roms/monitor/print.h"

enum { STEPS = 4 }; /* points a piece: u = 0, 1/4 … 1 */
enum { BY_CONDITIONS, BY_MATRIX, BY_BLENDING, BY_NOTHING };

static void print_coefficients(const struct cubic *q)
{
    const struct vector3 all[] = {q->a, q->b, q->c, q->d};
    for (int k = 0; k < 4; k++)
        printf("  %c = %9.4f %9.4f\n", "abcd"[k], print_tidy(all[k].x), print_tidy(all[k].y));
}

static void print_conditions(const struct cubic_geometry *g)
{
    static const char *const names[] = {"p(0)", "p(1)", "p'(0)", "p'(1)"};
    struct cubic_conditions c = cubic_conditions(g);
    struct cubic q = cubic_by_conditions(g);
    printf("            a  b  c  d           x         y\n");
    for (int i = 0; i < 4; i++) {
        printf("  %-7s", names[i]);
        for (int k = 0; k < 4; k++)
            printf(" %2d", (int)c.row[i][k]);
        printf("  =  %9.4f %9.4f\n", print_tidy(c.value[i].x), print_tidy(c.value[i].y));
    }
    print_coefficients(&q);
}

static void print_matrix(const struct cubic_geometry *g, bool first)
{
    struct matrix4 m = cubic_matrix(g->kind, g->tension);
    struct cubic q = cubic_by_matrix(g);
    if (first)
        print_matrix4("M =", &m);
    for (int k = 0; k < 4; k++)
        printf("%s %9.4f %9.4f\n", k == 0 ? "G =" : "   ", print_tidy(g->g[k].x),
               print_tidy(g->g[k].y));
    print_coefficients(&q);
}

static void print_blending(const struct cubic_geometry *g)
{
    printf("      u      BF0      BF1      BF2      BF3\n");
    for (int i = 0; i <= STEPS; i++) {
        float value[4], u = (float)i / STEPS;
        cubic_blending(g->kind, g->tension, u, value);
        printf("%7.4f", (double)u);
        for (int k = 0; k < 4; k++)
            printf(" %8.4f", print_tidy(value[k]));
        printf("\n");
    }
}

static void print_way(const struct spline *s, int way)
{
    for (int i = 0; i < s->pieces && way != BY_NOTHING; i++) {
        if (way != BY_BLENDING)
            printf("piece %d\n", i);
        if (way == BY_CONDITIONS)
            print_conditions(&s->piece[i]);
        else if (way == BY_MATRIX)
            print_matrix(&s->piece[i], i == 0);
        else if (i == 0)
            print_blending(&s->piece[0]);
    }
}

static struct vector3 point_by(int way, const struct cubic_geometry *g, float u)
{
    if (way == BY_BLENDING)
        return cubic_by_blending(g, u);
    struct cubic q = way == BY_CONDITIONS ? cubic_by_conditions(g) : cubic_by_matrix(g);
    return cubic_point(&q, u);
}

static void print_points(const struct spline *s, int way)
{
    printf("piece       u         t         x         y\n");
    for (int i = 0; i < s->pieces; i++) {
        for (int k = 0; k <= STEPS; k++) {
            float u = (float)k / STEPS, h = s->knot[i + 1] - s->knot[i];
            struct vector3 p = point_by(way, &s->piece[i], u);
            printf("%5d %7.4f %9.4f %9.4f %9.4f\n", i, (double)u, (double)(s->knot[i] + u * h),
                   print_tidy(p.x), print_tidy(p.y));
        }
    }
}

/* p′ and p″ with respect to t at all knots. */
static void print_knots(const struct spline *s)
{
    printf("        t         x         y       p'x       p'y       p\"x       p\"y\n");
    for (int i = 0; i <= s->pieces; i++) {
        int piece = i < s->pieces ? i : i - 1;
        float u = i < s->pieces ? 0 : 1, h = s->knot[piece + 1] - s->knot[piece];
        struct cubic q = cubic_by_matrix(&s->piece[piece]);
        struct vector3 p = cubic_point(&q, u);
        struct vector3 d1 = vector3_times(cubic_derivative(&q, 1, u), 1 / h);
        struct vector3 d2 = vector3_times(cubic_derivative(&q, 2, u), 1 / (h * h));
        printf("%9.4f %9.4f %9.4f %9.4f %9.4f %9.4f %9.4f\n", (double)s->knot[i], print_tidy(p.x),
               print_tidy(p.y), print_tidy(d1.x), print_tidy(d1.y), print_tidy(d2.x),
               print_tidy(d2.y));
    }
}

static void draw(struct monitor *m, const struct named_spline *n)
{
    struct curves_bounds bounds = {0};
    char title[40];
    snprintf(title, sizeof title, "Spline: %s", n->name);
    curves_include(&bounds, n->points.at, n->points.count);
    curves_include_spline(&bounds, &n->spline);
    struct graph g = curves_frame(m, title, &bounds);
    if (!n->through)
        curves_draw_lines(&g, n->points.at, n->points.count, INK_GRID);
    for (int i = 0; i < n->spline.pieces; i++) {
        struct spline piece = {.pieces = 1, .piece = {n->spline.piece[i]}};
        curves_draw_spline(&g, &piece, i % 2 == 0 ? INK_YELLOW : INK_ORANGE);
    }
    for (int i = 0; i <= n->spline.pieces; i++)
        curves_draw_marker(&g, spline_point(&n->spline, n->spline.knot[i]), INK_RED);
    curves_draw_points(&g, 'p', n->points.at, n->points.count, INK_CYAN);
    stage_caption(&m->stage, n->through ? "the curve goes through all points"
                                        : "red: where pieces meet; grey: the control polygon");
    stage_end(&m->stage);
}

bool curves_spline(struct monitor *m, struct words *w)
{
    static const char *const ways[] = {"conditions", "matrix", "blending", NULL};
    struct named_spline n;
    int way = BY_NOTHING;
    if (!curves_take_spline(w, &n))
        return false;
    if (words_take(w, "by") && !words_choice(w, ways, &way))
        return false;
    if (!words_end(w))
        return false;
    print_way(&n.spline, way);
    if (m->table)
        print_knots(&n.spline);
    print_points(&n.spline, way == BY_NOTHING ? BY_MATRIX : way);
    draw(m, &n);
    return true;
}

/* ---- side by side ---- */

/* The largest coordinate of a geometry, as the ways' tolerance is a part of it. */
static float size_of(const struct cubic_geometry *g)
{
    float most = 0;
    for (int k = 0; k < 4; k++)
        most = fmaxf(most, fmaxf(fabsf(g->g[k].x), fabsf(g->g[k].y)));
    return most * (1 + (g->kind == CUBIC_CARDINAL ? fabsf(g->tension) : 0));
}

static float difference_of(struct vector3 a, struct vector3 b)
{
    return fmaxf(fabsf(a.x - b.x), fabsf(a.y - b.y));
}

bool curves_three_ways(struct monitor *m, struct words *w)
{
    struct named_spline n;
    if (!curves_take_spline(w, &n) || !words_end(w))
        return false;
    float most = 0, allowed = 0;
    printf("piece       u          conditions              matrix            blending\n");
    for (int i = 0; i < n.spline.pieces; i++) {
        const struct cubic_geometry *g = &n.spline.piece[i];
        allowed = fmaxf(allowed, CUBIC_WAYS_TOLERANCE * size_of(g));
        for (int k = 0; k <= STEPS; k++) {
            struct vector3 p[3];
            float u = (float)k / STEPS;
            printf("%5d %7.4f", i, (double)u);
            for (int way = 0; way < 3; way++) {
                p[way] = point_by(way, g, u);
                most = fmaxf(most, difference_of(p[way], p[0]));
                printf(" %9.4f %9.4f", print_tidy(p[way].x), print_tidy(p[way].y));
            }
            most = fmaxf(most, difference_of(p[1], p[2]));
            printf("\n");
        }
    }
    printf("largest difference %.9f, rounding may make %.9f: %s\n", (double)most, (double)allowed,
           most <= allowed ? "the same curve" : "NOT the same");
    draw(m, &n);
    return true;
}
