/* curves_de_boor.c — B-splines of any degree over any knots. */
#include "roms/commands/curves.h"

#include <stdio.h>

#include "roms/curves/b_spline.h"
#include "roms/monitor/print.h"

static bool take_knots(struct words *w, struct b_spline *s, int *knots)
{
    *knots = 0;
    while (words_next_is_number(w)) {
        if (*knots == B_SPLINE_KNOTS_MOST)
            return words_refuse(w, "at most %d knots", B_SPLINE_KNOTS_MOST);
        if (!words_amount(w, &s->knot[(*knots)++]))
            return false;
    }
    return words_next_is(w, "points") || words_refuse(w, "the word \"points\" is missing");
}

static bool take(struct words *w, struct b_spline *s)
{
    static const char *const names[] = {"uniform", "open", "knots", NULL};
    enum { UNIFORM, OPEN, KNOTS };
    struct curve_points p;
    int how, knots = 0;
    if (!words_whole(w, 1, B_SPLINE_DEGREE_MOST, &s->degree) || !words_choice(w, names, &how))
        return false;
    if (how == KNOTS && !take_knots(w, s, &knots))
        return false;
    words_take(w, "points");
    if (!words_points(w, 2,
                      (struct words_wanted){s->degree + 1, B_SPLINE_POINTS_MOST, WORDS_FARTHEST},
                      p.at, &p.count))
        return false;
    s->count = p.count;
    for (int i = 0; i < p.count; i++)
        s->point[i] = p.at[i];
    if (how == KNOTS && knots != p.count + s->degree + 1)
        return words_refuse(w, "%d points of degree %d take %d knots, not %d", p.count, s->degree,
                            p.count + s->degree + 1, knots);
    if (how == UNIFORM)
        b_spline_uniform(s);
    else if (how == OPEN)
        b_spline_open(s);
    const char *trouble = b_spline_trouble(s);
    return trouble == NULL || words_refuse(w, "%s", trouble);
}

static void print_basis(const struct b_spline *s, const float *t, int count)
{
    float value[B_SPLINE_POINTS_MOST];
    printf("        t");
    for (int k = 0; k < s->count; k++)
        printf("  %sB%d,%d", k < 10 ? " " : "", k, s->degree);
    printf("     sum\n");
    for (int i = 0; i < count; i++) {
        float sum = 0;
        b_spline_basis(s, t[i], value);
        printf("%9.4f", (double)t[i]);
        for (int k = 0; k < s->count; k++, sum += value[k - 1])
            printf(" %6.4f", print_tidy(value[k]));
        printf("  %6.4f\n", (double)sum);
    }
}

static void print_triangle(const struct b_spline *s, float t)
{
    char text[CURVES_FIGURE];
    struct de_boor d;
    de_boor_begin(&d, s, t);
    printf("de Boor, t = %s, within knot %d and %d:\n", curves_figure(text, t), d.span, d.span + 1);
    do {
        printf("  level %d:", d.level);
        for (int i = 0; i <= s->degree - d.level; i++) {
            printf(" ");
            curves_print_point(d.at[i], 2);
        }
        printf("\n");
    } while (de_boor_next(&d));
}

static void draw(struct monitor *m, const struct b_spline *s, const float *t, int count)
{
    enum { STEPS = 96 };
    struct curves_bounds bounds = {0};
    char title[48];
    snprintf(title, sizeof title, "B-spline of degree %d", s->degree);
    curves_include(&bounds, s->point, s->count);
    struct graph g = curves_frame(m, title, &bounds);
    curves_draw_lines(&g, s->point, s->count, INK_GRID);
    float start = b_spline_start(s), end = b_spline_end(s);
    struct vector3 ends[2] = {b_spline_point(s, start)};
    for (int i = 1; i <= STEPS; i++, ends[0] = ends[1]) {
        ends[1] = b_spline_point(s, i == STEPS ? end : start + (end - start) * (float)i / STEPS);
        curves_draw_lines(&g, ends, 2, INK_YELLOW);
    }
    for (int k = s->degree; k <= s->count; k++)
        curves_draw_marker(&g, b_spline_point(s, s->knot[k]), INK_RED);
    for (int i = 0; i < count; i++)
        curves_draw_marker(&g, b_spline_point(s, t[i]), INK_BRIGHT);
    curves_draw_points(&g, 'p', s->point, s->count, INK_CYAN);
    stage_caption(&m->stage, "red: the knots, where pieces meet");
    stage_end(&m->stage);
}

bool curves_de_boor(struct monitor *m, struct words *w)
{
    struct b_spline s;
    float t[CURVES_PLACES];
    int count;
    char text[CURVES_FIGURE];
    if (!take(w, &s) || !curves_take_places(w, b_spline_start(&s), b_spline_end(&s), t, &count))
        return false;
    printf("knots:");
    for (int i = 0; i < s.count + s.degree + 1; i++)
        printf(" %s", curves_figure(text, s.knot[i]));
    printf("\n");
    if (m->table) {
        print_basis(&s, t, count);
        for (int i = 0; i < count; i++)
            print_triangle(&s, t[i]);
    }
    for (int i = 0; i < count; i++) {
        printf("t = %-8s ", curves_figure(text, t[i]));
        curves_print_point(b_spline_point(&s, t[i]), 2);
        printf("\n");
    }
    draw(m, &s, t, count);
    return true;
}
