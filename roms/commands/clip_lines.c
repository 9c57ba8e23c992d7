/* clip_lines.c — lines clipped by region codes and by their parameter. */
#include <math.h>
#include <stdio.h>

#include "roms/clip/cohen_sutherland.h"
#include "roms/clip/liang_barsky.h"
#include "roms/commands/clip_parts.h"
#include "roms/commands/clip_picture.h"
#include "roms/commands/flat_words.h"
#include "roms/monitor/print.h"
#include "roms/monitor/stepper.h"

/* A line that is being clipped. */
struct job {
    struct clip_window window;
    struct point2 a, b;
};

static bool take(struct words *w, struct job *j)
{
    return flat_window(w, &j->window) && words_point(w, WORDS_FARTHEST, &j->a) &&
           words_point(w, WORDS_FARTHEST, &j->b) && words_end(w);
}

static void answer(bool accepted, struct point2 a, struct point2 b)
{
    if (!accepted) {
        printf("rejected\n");
        return;
    }
    printf("accepted: ");
    print_point2(a);
    printf(" to ");
    print_point2(b);
    printf("\n");
}

/* The line, of it what is left (or nothing), and its ends so far. */
static void show(struct monitor *m, const struct job *j, bool left, struct point2 a,
                 struct point2 b, const char *title, const char *caption)
{
    const struct point2 ends[] = {j->a, j->b};
    stage_begin(&m->stage);
    struct graph g = clip_picture_fit(&m->stage, 0, STAGE_WIDTH, &j->window, ends, 2);
    clip_picture_regions(&g, &j->window);
    clip_picture_window(&g, &j->window);
    clip_picture_cut_away(&g, j->a, j->b);
    stage_ink(&m->stage, INK_BRIGHT);
    if (left) {
        graph_line(&g, a, b);
        graph_marker(&g, a);
        graph_marker(&g, b);
    }
    stage_ink(&m->stage, INK_YELLOW);
    graph_text(&g, j->a, "A");
    graph_text(&g, j->b, "B");
    stage_title(&m->stage, title);
    stage_caption(&m->stage, caption);
    stage_end(&m->stage);
}

/* ---- Cohen-Sutherland ------------------------------------------------------------------------ */

static void cut_row(const struct cohen_sutherland *k, int number)
{
    printf("%4d %-6s", number, clip_edge_name(k->edge));
    for (int e = 0; e < 2; e++) {
        char code[5];
        clip_code_text(k->code[e], code);
        printf(" %10.4f %10.4f  %s", print_tidy(k->end[e].x), print_tidy(k->end[e].y), code);
    }
    printf("\n");
}

static void cut_words(const struct cohen_sutherland *k, char *text, size_t size)
{
    char a[5], b[5], both[5];
    clip_code_text(k->code[0], a);
    clip_code_text(k->code[1], b);
    clip_code_text(k->code[0] & k->code[1], both);
    const char *next = k->code[0] & k->code[1]     ? "rejected"
                       : (k->code[0] | k->code[1]) ? "cut again"
                                                   : "accepted";
    snprintf(text, size, "%s: codes A %s, B %s; A AND B = %s: %s",
             k->edge == 0 ? "The line" : clip_edge_name(k->edge), a, b, both, next);
}

bool clip_cohen_sutherland_command(struct monitor *m, struct words *w)
{
    static const char title[] = "Cohen-Sutherland: codes above, below, right, left";
    struct job j;
    if (!take(w, &j))
        return false;
    struct cohen_sutherland k;
    char caption[96], a[5], b[5];
    cohen_sutherland_begin(&k, &j.window, j.a, j.b);
    clip_code_text(k.code[0], a);
    clip_code_text(k.code[1], b);
    printf("codes %s %s\n", a, b);
    if (m->table)
        printf(" cut edge           x0         y0  code         x1         y1  code\n");
    bool stepping = m->steps;
    int cuts = 0;
    do {
        if (m->table)
            cut_row(&k, cuts);
        cuts++;
        if (stepping) {
            cut_words(&k, caption, sizeof caption);
            show(m, &j, true, k.end[0], k.end[1], title, caption);
            stepping = step_ask(m, (unsigned)cuts);
        }
    } while (cohen_sutherland_next(&k));
    cut_words(&k, caption, sizeof caption);
    show(m, &j, k.accepted, k.end[0], k.end[1], title, caption);
    answer(k.accepted, k.end[0], k.end[1]);
    return true;
}

/* ---- Liang-Barsky ---------------------------------------------------------------------------- */

/* Rounded once, when it is written: four decimals of a float of 78.00885 would be 78.0089. */
static void print_at(const struct job *j, const struct liang_barsky *k, float t)
{
    double x = (double)j->a.x + (double)t * (double)k->p[1] + 0.0;
    double y = (double)j->a.y + (double)t * (double)k->p[3] + 0.0;
    /* Far ends make steps of t coarse. */
    x = fmin(fmax(x, (double)j->window.x_min), (double)j->window.x_max);
    y = fmin(fmax(y, (double)j->window.y_min), (double)j->window.y_max);
    printf("(%.4f,%.4f)", x, y);
}

static void edge_row(const struct liang_barsky *k)
{
    int i = k->edges - 1;
    printf("%-6s", clip_edge_name(1u << i));
    flat_print(11, k->p[i] + 0.0f);
    flat_print(11, k->q[i] + 0.0f);
    if (k->p[i] == 0)
        printf("%10s", "-");
    else
        printf("%10.4f", print_tidy(k->q[i] / k->p[i]));
    printf("%9.4f%9.4f\n", print_tidy(k->t1), print_tidy(k->t2));
}

bool clip_liang_barsky_command(struct monitor *m, struct words *w)
{
    struct job j;
    if (!take(w, &j))
        return false;
    struct liang_barsky k;
    struct point2 a = j.a, b = j.b;
    char caption[96];
    if (m->table)
        printf("edge            p          q       q/p       t1       t2\n");
    for (liang_barsky_begin(&k, &j.window, a, b); m->table && liang_barsky_next(&k);)
        edge_row(&k);
    bool left = clip_liang_barsky_shown(&j.window, &a, &b, &k);
    snprintf(caption, sizeof caption, "t1 = %.4f, t2 = %.4f%s", print_tidy(k.t1), print_tidy(k.t2),
             left ? "" : ": nothing is left");
    show(m, &j, left, a, b, "Liang-Barsky: where the line enters and leaves", caption);
    printf("t1 %.4f t2 %.4f\n", print_tidy(k.t1), print_tidy(k.t2));
    if (!left) {
        printf("rejected\n");
        return true;
    }
    printf("accepted: ");
    print_at(&j, &k, k.t1);
    printf(" to ");
    print_at(&j, &k, k.t2);
    printf("\n");
    return true;
}
