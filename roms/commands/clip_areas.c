/* clip_areas.c — points, polygons and text clipped. */
#include <stdio.h>
#include <string.h>

#include "roms/clip/edge.h"
#include "roms/clip/sutherland_hodgman.h"
#include "roms/clip/text.h"
#include "roms/commands/clip_parts.h"
#include "roms/commands/clip_picture.h"
#include "roms/commands/flat_words.h"
#include "roms/monitor/print.h"
#include "roms/monitor/stepper.h"
#include "roms/raster/font.h"

/* ---- points ---------------------------------------------------------------------------------- */

static void show_points(struct monitor *m, const struct clip_window *window, const struct point2 *p,
                        int count)
{
    stage_begin(&m->stage);
    struct graph g = clip_picture_fit(&m->stage, 0, STAGE_WIDTH, window, p, count);
    clip_picture_regions(&g, window);
    clip_picture_window(&g, window);
    for (int i = 0; i < count; i++) {
        stage_ink(&m->stage, clip_point(window, p[i]) ? INK_BRIGHT : INK_RED);
        graph_marker(&g, p[i]);
    }
    stage_title(&m->stage, "Points clipped");
    stage_caption(&m->stage, "xmin <= x <= xmax and ymin <= y <= ymax");
    stage_end(&m->stage);
}

bool clip_point_command(struct monitor *m, struct words *w)
{
    struct clip_window window;
    struct point2 p[FLAT_POINTS];
    int count;
    if (!flat_window(w, &window) ||
        !words_points2(w, (struct words_wanted){1, FLAT_POINTS, WORDS_FARTHEST}, p, &count) ||
        !words_end(w))
        return false;
    for (int i = 0; i < count; i++) {
        char code[5];
        clip_code_text(clip_region(&window, p[i]), code);
        print_point2(p[i]);
        printf(" %s %s\n", code, clip_point(&window, p[i]) ? "inside" : "outside");
    }
    show_points(m, &window, p, count);
    return true;
}

/* ---- polygons -------------------------------------------------------------------------------- */

static void area(const struct graph *g, const struct point2 *p, int count, enum ink ink)
{
    struct point2 placed[CLIP_POLYGON_ROOM];
    for (int i = 0; i < count; i++)
        placed[i] = graph_place(g, p[i]);
    stage_ink(g->stage, ink);
    stage_hatch(g->stage, 45, 24);
    stage_area(g->stage, placed, count);
    stage_hatch(g->stage, 0, 0);
    stage_ink(g->stage, INK_BRIGHT);
    stage_polygon(g->stage, placed, count);
}

static void show_polygon(struct monitor *m, const struct sutherland_hodgman *s,
                         const struct point2 *p, int count, const char *caption)
{
    stage_begin(&m->stage);
    struct graph g = clip_picture_fit(&m->stage, 0, STAGE_WIDTH, &s->window, p, count);
    area(&g, s->corner, s->count, INK_GREEN);
    for (int i = 0; i < count; i++)
        clip_picture_cut_away(&g, p[i], p[(i + 1) % count]);
    stage_ink(&m->stage, INK_BRIGHT);
    graph_polygon(&g, s->corner, s->count);
    clip_picture_window(&g, &s->window);
    stage_title(&m->stage, "Sutherland-Hodgman: a polygon clipped edge by edge");
    stage_caption(&m->stage, caption);
    stage_end(&m->stage);
}

static void pass_words(const struct sutherland_hodgman *s, char *text, size_t size)
{
    snprintf(text, size, "pass %s: %d corners", clip_edge_name(s->edge), s->count);
}

static void verdict(const struct sutherland_hodgman *s)
{
    int doubled = clip_polygon_doubled(&s->window, s->corner, s->count);
    if (s->count == 0) {
        printf("rejected\n");
        return;
    }
    printf("%d corners: ", s->count);
    flat_print_points(s->corner, s->count);
    if (doubled > 0)
        printf("%d edges are degenerate: they cover each other on the window's edge and join "
               "parts of a concave polygon\n",
               doubled);
}

bool clip_polygon_command(struct monitor *m, struct words *w)
{
    static struct sutherland_hodgman s;
    struct clip_window window;
    struct point2 p[FLAT_POINTS];
    char caption[64];
    int count;
    if (!flat_window(w, &window) ||
        !words_points2(w, (struct words_wanted){3, FLAT_POINTS, WORDS_FARTHEST}, p, &count) ||
        !words_end(w))
        return false;
    bool stepping = m->steps;
    unsigned number = 0;
    for (sutherland_hodgman_begin(&s, &window, p, count); sutherland_hodgman_next(&s);) {
        number++;
        pass_words(&s, caption, sizeof caption);
        if (m->table) {
            printf("%s: ", caption);
            flat_print_points(s.corner, s.count);
        }
        if (stepping) {
            show_polygon(m, &s, p, count, caption);
            stepping = step_ask(m, number);
        }
    }
    snprintf(caption, sizeof caption, "%d corners, of which %d are left", count, s.count);
    show_polygon(m, &s, p, count, "What is cut away is red; what is left is one polygon");
    verdict(&s);
    return true;
}

/* ---- text ------------------------------------------------------------------------------------ */

enum { TEXT_MOST = 24, RULES = 3 };

static const char *const rules[RULES] = {"string", "character", "component"};
static const struct clip_font font = {FONT_WIDTH, FONT_HEIGHT, font_row};

/* What the rule leaves; dots by their runs, which are lines where a head cannot fill. */
static void panel(struct monitor *m, const struct clip_text *t, const struct clip_window *window,
                  int rule)
{
    struct clip_window box = clip_text_box(t);
    const struct point2 all[] = {{box.x_min, box.y_min},
                                 {box.x_max, box.y_max},
                                 {window->x_min, window->y_min},
                                 {window->x_max, window->y_max}};
    float bottom = (float)(RULES - 1 - rule) * 262;
    struct graph g = graph_fit(&m->stage, 190, bottom - 50, STAGE_WIDTH - 190, 362, all, 4);
    clip_picture_window(&g, window);
    stage_ink(&m->stage, INK_BRIGHT);
    struct clip_text_parts p;
    for (clip_text_begin(&p, t, window, (enum clip_text_rule)rule); clip_text_next(&p);) {
        struct point2 low = graph_place(&g, (struct point2){p.part.x_min, p.part.y_min});
        struct point2 high = graph_place(&g, (struct point2){p.part.x_max, p.part.y_max});
        const struct point2 corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
        stage_heads(&m->stage, STAGE_RASTER);
        stage_area(&m->stage, corners, 4);
        stage_heads(&m->stage, STAGE_VECTOR);
        stage_line(&m->stage, low.x, (low.y + high.y) / 2, high.x, (low.y + high.y) / 2);
    }
    stage_heads(&m->stage, STAGE_BOTH);
    stage_text(&m->stage, 0, bottom + 122, rules[rule]);
}

/* The characters that are left; "." for those that are not. */
static void text_row(const struct clip_text *t, const struct clip_window *window, int rule)
{
    struct clip_text_parts p;
    double lit = 0;
    printf("%-9s \"", rules[rule]);
    for (int i = 0; t->text[i] != '\0'; i++)
        printf("%c", clip_text_shows(t, window, (enum clip_text_rule)rule, i) ? t->text[i] : '.');
    for (clip_text_begin(&p, t, window, (enum clip_text_rule)rule); clip_text_next(&p);)
        lit += (double)((p.part.x_max - p.part.x_min) * (p.part.y_max - p.part.y_min));
    printf("\" %.4f dots\n", lit / (double)(t->dot * t->dot));
}

bool clip_text_command(struct monitor *m, struct words *w)
{
    struct clip_window window;
    char text[TEXT_MOST + 1];
    struct clip_text t = {text, &font, {0, 0}, 0};
    float height;
    if (!flat_window(w, &window) || !words_point(w, WORDS_FARTHEST, &t.at) ||
        !words_bounded(w, 0.001f, WORDS_FARTHEST, &height) || !words_rest(w, text, sizeof text))
        return false;
    t.dot = height / FONT_HEIGHT;
    stage_begin(&m->stage);
    for (int rule = 0; rule < RULES; rule++)
        panel(m, &t, &window, rule);
    stage_title(&m->stage, "Text clipped by three rules");
    stage_caption(&m->stage, "All or none of the string; whole characters; components, dot by dot");
    stage_end(&m->stage);
    for (int rule = 0; rule < RULES; rule++)
        text_row(&t, &window, rule);
    return true;
}
