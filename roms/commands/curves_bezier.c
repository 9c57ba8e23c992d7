/* curves_bezier.c — Bézier curves: points, blending functions, de Casteljau's triangle, ends. */
#include "roms/commands/curves.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "roms/curves/casteljau.h"
#include "roms/monitor/print.h"

/* ---- the polynomial of small degrees ---- */

/* Coefficient of u^j: C(n,j) · Σ (−1)^(i+j) · C(j,i) · p_i, forward differences of the points. */
static struct vector3 power_coefficient(const struct curve_points *p, int j)
{
    struct vector3 sum = {0, 0, 0};
    for (int i = 0; i <= j; i++) {
        float sign = (i + j) % 2 == 0 ? 1 : -1;
        sum = vector3_sum(sum, vector3_times(p->at[i], sign * bezier_binomial(j, i)));
    }
    return vector3_times(sum, bezier_binomial(p->count - 1, j));
}

/* " + 8u", or "" for 0; the first term without blanks. */
static void print_term(float coefficient, int power, bool *first)
{
    static const char *const powers[] = {"", "u", "u^2", "u^3"};
    char text[CURVES_FIGURE];
    if (fabsf(coefficient) < 0.000005f)
        return;
    curves_figure(text, fabsf(coefficient));
    bool one = power > 0 && strcmp(text, "1") == 0;
    const char *sign = coefficient < 0 ? (*first ? "-" : " - ") : *first ? "" : " + ";
    printf("%s%s%s", sign, one ? "" : text, powers[power]);
    *first = false;
}

static void print_polynomial(const struct curve_points *p, int dimensions)
{
    for (int axis = 0; axis < dimensions; axis++) {
        bool first = true;
        printf("%c(u) = ", "xyz"[axis]);
        for (int j = p->count - 1; j >= 0; j--) {
            struct vector3 c = power_coefficient(p, j);
            print_term(axis == 0 ? c.x : axis == 1 ? c.y : c.z, j, &first);
        }
        printf("%s\n", first ? "0" : "");
    }
}

/* ---- tables ---- */

static void print_blending(int n, const float *u, int count)
{
    float value[BEZIER_POINTS_MOST];
    printf("      u");
    for (int k = 0; k <= n; k++)
        printf("  BEZ%d,%d%s", k, n, k < 10 && n < 10 ? " " : "");
    printf("      sum\n");
    for (int i = 0; i < count; i++) {
        float sum = 0;
        bezier_blending(n, u[i], value);
        printf("%7.4f", (double)u[i]);
        for (int k = 0; k <= n; k++, sum += value[k - 1])
            printf(" %8.4f", print_tidy(value[k]));
        printf(" %8.4f\n", (double)sum);
    }
}

/* Level after level in columns; point i of level j stands in line i + j, under the two it is
 * between. */
static void print_triangle(const struct casteljau *c, int dimensions)
{
    char text[3 * CURVES_FIGURE + 5];
    int width[BEZIER_POINTS_MOST] = {0};
    for (int j = 0; j < c->count; j++) {
        for (int i = 0; i < c->count - j; i++) {
            curves_text_of_point(text, sizeof text, casteljau_at(c, j, i), dimensions);
            int length = (int)strlen(text);
            width[j] = length > width[j] ? length : width[j];
        }
    }
    printf("de Casteljau, u = %s:\n", curves_figure(text, c->u));
    for (int line = 0; line < c->count; line++, printf("\n")) {
        for (int j = 0; j <= line; j++) {
            curves_text_of_point(text, sizeof text, casteljau_at(c, j, line - j), dimensions);
            printf("  %*s", width[j], text);
        }
    }
}

/* ---- picture ---- */

static void draw_construction(const struct graph *g, const struct casteljau *c)
{
    static const enum ink inks[] = {INK_GREEN, INK_ORANGE, INK_VIOLET, INK_BLUE};
    for (int j = 1; j < c->count; j++) {
        enum ink ink = inks[(j - 1) % 4];
        for (int i = 0; i < c->count - j; i++) {
            struct vector3 ends[] = {casteljau_at(c, j, i), casteljau_at(c, j, i + 1)};
            if (i + 1 < c->count - j)
                curves_draw_lines(g, ends, 2, ink);
            curves_draw_marker(g, ends[0], j + 1 < c->count ? ink : INK_RED);
        }
    }
}

static void draw_curve(struct monitor *m, const struct curve_points *p, const float *u, int count,
                       const struct casteljau *c)
{
    struct curves_bounds bounds = {0};
    char title[48];
    snprintf(title, sizeof title, "Bezier curve of degree %d", p->count - 1);
    curves_include(&bounds, p->at, p->count);
    struct graph g = curves_frame(m, title, &bounds);
    curves_draw_lines(&g, p->at, p->count, INK_TEXT);
    draw_construction(&g, c);
    curves_draw_bezier(&g, p->at, p->count, INK_YELLOW);
    for (int i = 0; i < count; i++)
        curves_draw_marker(&g, bezier_point(p->at, p->count, u[i]), INK_BRIGHT);
    curves_draw_points(&g, 'p', p->at, p->count, INK_CYAN);
    char text[80], figure[CURVES_FIGURE];
    snprintf(text, sizeof text, "de Casteljau's construction of the point at u = %.12s",
             curves_figure(figure, c->u));
    stage_caption(&m->stage, text);
    stage_end(&m->stage);
}

/* ---- commands ---- */

static void triangle_of(struct casteljau *c, const struct curve_points *p, float u)
{
    casteljau_begin(c, p->at, p->count, u);
    while (casteljau_next(c))
        continue;
}

static bool bezier(struct monitor *m, struct words *w, int dimensions)
{
    struct curve_points p;
    struct casteljau c;
    float u[CURVES_PLACES];
    int count;
    char text[CURVES_FIGURE];
    if (!words_points(w, dimensions, (struct words_wanted){2, BEZIER_POINTS_MOST, WORDS_FARTHEST},
                      p.at, &p.count) ||
        !curves_take_places(w, 0, 1, u, &count))
        return false;
    if (p.count <= 4)
        print_polynomial(&p, dimensions);
    if (m->table) {
        print_blending(p.count - 1, u, count);
        for (int i = 0; i < count; i++) {
            triangle_of(&c, &p, u[i]);
            print_triangle(&c, dimensions);
        }
    }
    for (int i = 0; i < count; i++) {
        printf("u = %-8s ", curves_figure(text, u[i]));
        curves_print_point(bezier_point(p.at, p.count, u[i]), dimensions);
        printf("\n");
    }
    triangle_of(&c, &p, u[count / 2]);
    draw_curve(m, &p, u, count, &c);
    return true;
}

bool curves_bezier(struct monitor *m, struct words *w)
{
    return bezier(m, w, 2);
}

bool curves_bezier3(struct monitor *m, struct words *w)
{
    return bezier(m, w, 3);
}

static void print_end(const char *name, struct vector3 v, int dimensions)
{
    printf("%s = ", name);
    curves_print_point(v, dimensions);
    printf("\n");
}

static bool ends(struct monitor *m, struct words *w, int dimensions)
{
    struct curve_points p;
    struct curves_bounds bounds = {0};
    if (!words_points(w, dimensions, (struct words_wanted){2, BEZIER_POINTS_MOST, WORDS_FARTHEST},
                      p.at, &p.count) ||
        !words_end(w))
        return false;
    struct bezier_ends e = bezier_ends(p.at, p.count);
    print_end("p'(0)", e.first0, dimensions);
    print_end("p'(1)", e.first1, dimensions);
    print_end("p\"(0)", e.second0, dimensions);
    print_end("p\"(1)", e.second1, dimensions);

    /* A third of p' and a sixth of p" are as long as what they are made of. */
    struct vector3 last = p.at[p.count - 1];
    struct vector3 tips[] = {vector3_sum(p.at[0], vector3_times(e.first0, 1 / 3.0f)),
                             vector3_sum(last, vector3_times(e.first1, 1 / 3.0f)),
                             vector3_sum(p.at[0], vector3_times(e.second0, 1 / 6.0f)),
                             vector3_sum(last, vector3_times(e.second1, 1 / 6.0f))};
    curves_include(&bounds, p.at, p.count);
    curves_include(&bounds, tips, 4);
    struct graph g = curves_frame(m, "Derivatives at the ends of a Bezier curve", &bounds);
    curves_draw_lines(&g, p.at, p.count, INK_TEXT);
    curves_draw_bezier(&g, p.at, p.count, INK_YELLOW);
    for (int i = 0; i < 4; i++) {
        struct vector3 from = i % 2 == 0 ? p.at[0] : last;
        curves_draw_arrow(&g, from, vector3_difference(tips[i], from), i < 2 ? INK_RED : INK_GREEN);
    }
    curves_draw_points(&g, 'p', p.at, p.count, INK_CYAN);
    stage_caption(&m->stage, "along the legs: p'/3; toward the bend: p\"/6");
    stage_end(&m->stage);
    return true;
}

bool curves_bezier_ends(struct monitor *m, struct words *w)
{
    return ends(m, w, 2);
}

bool curves_bezier_ends3(struct monitor *m, struct words *w)
{
    return ends(m, w, 3);
}
