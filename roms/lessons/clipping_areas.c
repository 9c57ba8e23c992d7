/* clipping_areas.c — a polygon clipped edge by edge; text clipped by three rules. */
#include <math.h>
#include <stdio.h>

#include "roms/clip/edge.h"
#include "roms/clip/sutherland_hodgman.h"
#include "roms/clip/text.h"
#include "roms/geometry/scalar.h"
#include "roms/lessons/clipping.h"
#include "roms/lessons/large_text.h"
#include "roms/raster/font.h"

/* ---- polygons -------------------------------------------------------------------------------- */

enum { POINTS = 7, CORNERS = 2 * POINTS, PASSES = 4 };
#define PASS_SECONDS 2.4f

/* A star, concave at every second corner. */
static void star(struct point2 *p, float angle)
{
    for (int i = 0; i < CORNERS; i++) {
        float a = angle + (float)i * (TURN / CORNERS), r = i % 2 ? 150 : 370;
        p[i] = (struct point2){420 + r * cosf(a), 400 + r * sinf(a)};
    }
}

static void outline_cut_away(struct stage *s, const struct point2 *p, int count)
{
    for (int i = 0; i < count; i++)
        clipping_cut_away(s, p[i], p[(i + 1) % count]);
}

static void pass_edge(struct stage *s, const struct clip_window *w, unsigned edge)
{
    float x = edge == REGION_LEFT ? w->x_min : w->x_max;
    float y = edge == REGION_BELOW ? w->y_min : w->y_max;
    stage_ink(s, INK_YELLOW);
    for (float k = -1; k <= 1; k++) {
        if (edge & (REGION_LEFT | REGION_RIGHT))
            stage_line(s, x + k * 2, 0, x + k * 2, STAGE_HEIGHT);
        else
            stage_line(s, 0, y + k * 2, 840, y + k * 2);
    }
}

static void say_passes(struct stage *s, const struct sutherland_hodgman *work, int pass)
{
    static const char *const names[] = {"left", "right", "below", "above"};
    char text[24];
    for (int i = 0; i < PASSES; i++) {
        snprintf(text, sizeof text, "%d %s", i + 1, names[i]);
        clipping_say(s, i + 1, i + 1 == pass ? INK_YELLOW : i < pass ? INK_GREEN : INK_GRID, text);
    }
    snprintf(text, sizeof text, "%d corners", work->count);
    clipping_say(s, 6, INK_BRIGHT, text);
    int doubled = clip_polygon_doubled(&work->window, work->corner, work->count);
    if (pass >= PASSES && doubled > 0) {
        clipping_say(s, 8, INK_RED, "degenerate");
        snprintf(text, sizeof text, "edges: %d", doubled);
        clipping_say(s, 9, INK_RED, text);
    }
}

/* Edges that run along the window and cover each other. */
static void doubled_edges(struct stage *s, const struct sutherland_hodgman *work)
{
    const struct clip_window *w = &work->window;
    for (int i = 0; i < work->count; i++) {
        struct point2 a = work->corner[i], b = work->corner[(i + 1) % work->count];
        bool on_x = a.x == b.x && (a.x == w->x_min || a.x == w->x_max);
        bool on_y = a.y == b.y && (a.y == w->y_min || a.y == w->y_max);
        if (on_x || on_y)
            clipping_thick(s, a, b, INK_BRIGHT);
    }
}

/* Pass by pass first; then the star turns, and the window moves to where only points of it are. */
void clipping_polygon(struct stage *s, float since)
{
    static struct sutherland_hodgman work;
    struct point2 p[CORNERS];
    int pass = (int)(since / PASS_SECONDS);
    float turning = fmaxf(0, since - PASS_SECONDS * (PASSES + 1));
    float aside = 350 * fminf(1, fmaxf(0, (turning - 5) / 4));
    const struct clip_window w = {240 + aside, 190, 640 + aside / 2, 560 + aside / 5};
    star(p, 0.3f + turning * 0.35f);
    sutherland_hodgman_begin(&work, &w, p, CORNERS);
    for (int i = 0; i < pass; i++)
        sutherland_hodgman_next(&work);
    stage_ink(s, INK_GREEN);
    stage_hatch(s, 45, 24);
    stage_area(s, work.corner, work.count);
    stage_hatch(s, 0, 0);
    outline_cut_away(s, p, CORNERS);
    clipping_window(s, &w, INK_CYAN);
    if (pass >= 1 && pass <= PASSES)
        pass_edge(s, &w, work.edge);
    doubled_edges(s, &work);
    say_passes(s, &work, pass);
}

/* ---- text ------------------------------------------------------------------------------------ */

static const struct clip_font font = {FONT_WIDTH, FONT_HEIGHT, font_row};

/* Runs of dots are filled, or lines where a head cannot. */
static void dots(struct stage *s, const struct clip_text *t, const struct clip_window *w,
                 enum clip_text_rule rule)
{
    struct clip_text_parts p;
    for (clip_text_begin(&p, t, w, rule); clip_text_next(&p);) {
        const struct clip_window *r = &p.part;
        const struct point2 c[] = {
            {r->x_min, r->y_min}, {r->x_max, r->y_min}, {r->x_max, r->y_max}, {r->x_min, r->y_max}};
        stage_heads(s, STAGE_RASTER);
        stage_area(s, c, 4);
        stage_heads(s, STAGE_VECTOR);
        stage_line(s, r->x_min, (r->y_min + r->y_max) / 2, r->x_max, (r->y_min + r->y_max) / 2);
    }
    stage_heads(s, STAGE_BOTH);
}

void clipping_text(struct stage *s, float since)
{
    static const char *const names[] = {"string", "character", "component"};
    static const enum ink inks[] = {INK_ORANGE, INK_GREEN, INK_BRIGHT};
    for (int rule = 0; rule < 3; rule++) {
        float bottom = 560 - (float)rule * 265;
        const struct clip_window w = {330, bottom, 1130, bottom + 190};
        const struct clip_text t = {
            "SCAN",
            &font,
            {540 + 245 * sinf(since * 0.45f), bottom + 17 + 18 * sinf(since * 0.8f)},
            13};
        struct clip_window box = clip_text_box(&t);
        clipping_window(s, &w, INK_CYAN);
        clipping_window(s, &box, INK_GRID);
        stage_ink(s, inks[rule]);
        dots(s, &t, &w, (enum clip_text_rule)rule);
        large_text(s, 0, bottom + 80, names[rule]);
    }
}
