/* curves_continuity.c — reports on the joins of curves. */
#include "roms/commands/curves.h"

#include <stdio.h>

static void print_pair(const char *p, struct vector3 a, const char *q, struct vector3 b)
{
    printf("    %s = ", p);
    curves_print_point(a, 2);
    printf(", %s = ", q);
    curves_print_point(b, 2);
    printf("\n");
}

static void print_verdict(const char *name, bool holds, const char *what, float off, float allowed)
{
    printf("%s  %-3s  %-28s %.6f (at most %.6f)\n", name, holds ? "yes" : "no", what, (double)off,
           (double)allowed);
}

static void print_report(const struct join *j)
{
    struct continuity c = continuity_of(j);
    print_pair("p(1)", j->p[0], "q(0)", j->q[0]);
    print_pair("p'(1)", j->p[1], "q'(0)", j->q[1]);
    print_pair("p\"(1)", j->p[2], "q\"(0)", j->q[2]);
    print_verdict("C0", c.c0, "|q - p|", c.apart[0], c.allowed[0]);
    print_verdict("C1", c.c1, "C0 and |q' - p'|", c.apart[1], c.allowed[1]);
    print_verdict("C2", c.c2, "C1 and |q\" - p\"|", c.apart[2], c.allowed[2]);
    print_verdict("G0", c.g0, "|q - p|", c.apart[0], c.allowed[0]);
    if (c.off_allowed[1] <= 0) {
        printf("G1  no   a tangent is 0: no direction\nG2  no\n");
    } else {
        char k[CURVES_FIGURE], m[CURVES_FIGURE];
        print_verdict("G1", c.g1, c.k > 0 ? "G0 and |q' - k p'|" : "G0 and k > 0 and |q' - k p'|",
                      c.off[1], c.off_allowed[1]);
        print_verdict("G2", c.g2, "G1 and |q\" - k^2 p\" - m p'|", c.off[2], c.off_allowed[2]);
        printf("    k = %s, m = %s\n", curves_figure(k, c.k), curves_figure(m, c.m));
    }
    printf("so: %s, %s\n",
           c.c2   ? "C2"
           : c.c1 ? "C1"
           : c.c0 ? "C0"
                  : "not joined",
           c.g2   ? "G2"
           : c.g1 ? "G1"
           : c.g0 ? "G0"
                  : "not joined");
}

/* p, and q if it begins another curve. */
static bool take_curves(struct words *w, struct named_spline *p, struct named_spline *q, bool *two)
{
    *two = words_next_is_number(w);
    if (*two) {
        if (!words_points(w, 2, (struct words_wanted){8, 8, WORDS_FARTHEST}, p->points.at,
                          &p->points.count))
            return false;
        for (int k = 0; k < 4; k++)
            q->points.at[k] = p->points.at[4 + k];
        p->points.count = q->points.count = 4;
        return spline_bezier(p->points.at, 4, &p->spline) &&
               spline_bezier(q->points.at, 4, &q->spline);
    }
    if (!curves_take_spline(w, p))
        return false;
    *two = words_take(w, "and");
    if (*two)
        return curves_take_spline(w, q);
    return p->spline.pieces > 1 ||
           words_refuse(w, "one piece has no join: \"and\" another curve is missing");
}

/* The last piece of p, then the first of q, as if they were one curve. */
static struct join join_between(const struct named_spline *p, const struct named_spline *q)
{
    const struct spline *a = &p->spline, *b = &q->spline;
    float h = a->knot[a->pieces] - a->knot[a->pieces - 1];
    struct spline both = {.pieces = 2,
                          .knot = {0, h, h + b->knot[1] - b->knot[0]},
                          .piece = {a->piece[a->pieces - 1], b->piece[0]}};
    return spline_join(&both, 0);
}

static void draw(struct monitor *m, const struct named_spline *p, const struct named_spline *q)
{
    struct curves_bounds bounds = {0};
    curves_include_spline(&bounds, &p->spline);
    curves_include(&bounds, p->points.at, p->points.count);
    if (q != NULL) {
        curves_include_spline(&bounds, &q->spline);
        curves_include(&bounds, q->points.at, q->points.count);
    }
    struct graph g = curves_frame(m, "Continuity", &bounds);
    for (const struct named_spline *n = p; n != NULL; n = n == p ? q : NULL) {
        if (!n->through)
            curves_draw_lines(&g, n->points.at, n->points.count, INK_GRID);
        curves_draw_points(&g, n == p ? 'p' : 'q', n->points.at, n->points.count, INK_CYAN);
        curves_draw_spline(&g, &n->spline, n == p ? INK_YELLOW : INK_GREEN);
    }
    int joins = q != NULL ? 1 : p->spline.pieces - 1;
    for (int i = 0; i < joins; i++) {
        struct join j = q != NULL ? join_between(p, q) : spline_join(&p->spline, i);
        curves_draw_arrow(&g, j.p[0], vector3_times(j.p[1], -1 / 3.0f), INK_ORANGE);
        curves_draw_arrow(&g, j.q[0], vector3_times(j.q[1], 1 / 3.0f), INK_RED);
    }
    stage_caption(&m->stage, "arrows: a third of p' (backward) and of q'");
    stage_end(&m->stage);
}

bool curves_continuity(struct monitor *m, struct words *w)
{
    struct named_spline p = {.through = false}, q = {.through = false};
    bool two;
    if (!take_curves(w, &p, &q, &two) || !words_end(w))
        return false;
    if (two) {
        struct join j = join_between(&p, &q);
        print_report(&j);
    }
    for (int i = 0; !two && i + 1 < p.spline.pieces; i++) {
        struct join j = spline_join(&p.spline, i);
        printf("join %d, t = %.4f\n", i + 1, (double)p.spline.knot[i + 1]);
        print_report(&j);
    }
    draw(m, &p, two ? &q : NULL);
    return true;
}
