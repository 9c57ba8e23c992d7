/* clipping_lines.c — lines clipped: by region codes, by their parameter, many at once. */
#include <math.h>
#include <stdio.h>

#include "roms/clip/cohen_sutherland.h"
#include "roms/clip/liang_barsky.h"
#include "roms/geometry/scalar.h"
#include "roms/lessons/clipping.h"
#include "roms/lessons/large_text.h"

static const struct clip_window window = {250, 240, 590, 560};

static const char *edge_name(unsigned edge)
{
    return edge == REGION_LEFT    ? "left"
           : edge == REGION_RIGHT ? "right"
           : edge == REGION_BELOW ? "below"
                                  : "above";
}

static void end_mark(struct stage *s, struct point2 p, const char *name, enum ink ink)
{
    stage_ink(s, ink);
    stage_marker(s, p.x, p.y);
    large_text(s, p.x + 10, p.y + 8, name);
}

/* ---- Cohen-Sutherland ------------------------------------------------------------------------ */

static const struct point2 lines[][2] = {
    {{90, 120}, {560, 380}},  /* two cuts at one end */
    {{320, 300}, {520, 500}}, /* accepted */
    {{60, 300}, {200, 720}},  /* rejected at once */
    {{110, 330}, {790, 470}}, /* one cut at each end */
    {{60, 500}, {440, 760}},  /* cut, then rejected */
    {{120, 90}, {800, 760}},  /* four cuts */
    {{500, 60}, {790, 300}},  /* as before, from below */
};
enum { LINES = sizeof lines / sizeof lines[0] };
#define CUT_SECONDS 2.0f

/* The cuts that a line needs. */
static int cuts_of(const struct point2 *line)
{
    struct cohen_sutherland k;
    int n = 0;
    for (cohen_sutherland_begin(&k, &window, line[0], line[1]); cohen_sutherland_next(&k);)
        n++;
    return n;
}

/* Each line takes a while for every cut, and two for the verdict. */
static float line_seconds(int i)
{
    return CUT_SECONDS * (float)(cuts_of(lines[i]) + 2);
}

static void say_codes(struct stage *s, const struct cohen_sutherland *k, bool decided)
{
    char code[5], text[24];
    for (int e = 0; e < 2; e++) {
        clipping_code(k->code[e], code);
        snprintf(text, sizeof text, "%c   %s", 'A' + e, code);
        clipping_say(s, e, k->code[e] ? INK_ORANGE : INK_GREEN, text);
    }
    unsigned both = k->code[0] & k->code[1];
    clipping_code(both, code);
    snprintf(text, sizeof text, "AND %s", code);
    clipping_say(s, 2, both ? INK_RED : INK_TEXT, text);
    if (k->edge != 0) {
        snprintf(text, sizeof text, "cut %c", 'A' + k->cut);
        clipping_say(s, 4, INK_YELLOW, text);
        snprintf(text, sizeof text, "at %s", edge_name(k->edge));
        clipping_say(s, 5, INK_YELLOW, text);
    }
    if (decided && both)
        clipping_say(s, 7, INK_RED, "rejected");
    else if (decided)
        clipping_say(s, 7, INK_GREEN, "accepted");
    else
        clipping_say(s, 7, INK_TEXT, "cut!");
}

static void cut_edge(struct stage *s, unsigned edge)
{
    const struct clip_window *w = &window;
    float x = edge == REGION_LEFT ? w->x_min : w->x_max;
    float y = edge == REGION_BELOW ? w->y_min : w->y_max;
    stage_ink(s, INK_YELLOW);
    if (edge & (REGION_LEFT | REGION_RIGHT))
        stage_line(s, x, 0, x, CLIPPING_TOP);
    else
        stage_line(s, 0, y, 840, y);
}

void clipping_cohen_sutherland(struct stage *s, float since)
{
    float begun = 0;
    int i = 0;
    for (; i < LINES - 1 && since >= begun + line_seconds(i); i++)
        begun += line_seconds(i);
    struct cohen_sutherland k;
    int cuts = (int)((since - begun) / CUT_SECONDS);
    cohen_sutherland_begin(&k, &window, lines[i][0], lines[i][1]);
    while (cuts > 0 && cohen_sutherland_next(&k))
        cuts--;
    bool pending = (k.code[0] | k.code[1]) != 0 && (k.code[0] & k.code[1]) == 0;
    clipping_codes(s, &window);
    clipping_window(s, &window, INK_CYAN);
    if (k.edge != 0)
        cut_edge(s, k.edge);
    clipping_cut_away(s, lines[i][0], lines[i][1]);
    if (pending || (k.code[0] & k.code[1]) == 0)
        clipping_thick(s, k.end[0], k.end[1], pending ? INK_BRIGHT : INK_GREEN);
    end_mark(s, k.end[0], "A", INK_BRIGHT);
    end_mark(s, k.end[1], "B", INK_BRIGHT);
    say_codes(s, &k, !pending);
}

/* ---- Liang-Barsky ---------------------------------------------------------------------------- */

enum { AXIS_LEFT = 60, AXIS_RIGHT = 790, AXIS_Y = 70 };

/* Parameters from -0.25 to 1.25 on the axis at the bottom. */
static float axis_x(float t)
{
    t = t < -0.25f ? -0.25f : t > 1.25f ? 1.25f : t;
    return AXIS_LEFT + (t + 0.25f) / 1.5f * (AXIS_RIGHT - AXIS_LEFT);
}

static void parameter_axis(struct stage *s, const struct liang_barsky *k)
{
    stage_ink(s, INK_TEXT);
    stage_line(s, AXIS_LEFT, AXIS_Y, AXIS_RIGHT, AXIS_Y);
    for (int t = 0; t <= 1; t++) {
        stage_line(s, axis_x((float)t), AXIS_Y - 16, axis_x((float)t), AXIS_Y + 16);
        large_text_middle(s, axis_x((float)t), 8, t ? "1" : "0");
    }
    for (int i = 0; i < 4; i++) {
        if (k->p[i] == 0)
            continue;
        float x = axis_x(k->q[i] / k->p[i]);
        stage_ink(s, k->p[i] < 0 ? INK_GREEN : INK_RED);
        stage_line(s, x, AXIS_Y - 12, x, AXIS_Y + 40);
        stage_text(s, x + 4, AXIS_Y + 26, k->p[i] < 0 ? "in" : "out");
    }
    stage_ink(s, INK_BRIGHT);
    for (int i = -2; i <= 2 && k->left; i++)
        stage_line(s, axis_x(k->t1), AXIS_Y + (float)i, axis_x(k->t2), AXIS_Y + (float)i);
}

/* Where the line, drawn on, meets the four edges, drawn on. */
static void meetings(struct stage *s, const struct liang_barsky *k, struct point2 a)
{
    for (int i = 0; i < 4; i++) {
        if (k->p[i] == 0)
            continue;
        float t = k->q[i] / k->p[i];
        struct point2 p = {a.x + t * k->p[1], a.y + t * k->p[3]};
        if (p.x < 0 || p.x > 840 || p.y < 130 || p.y > STAGE_HEIGHT)
            continue;
        stage_ink(s, k->p[i] < 0 ? INK_GREEN : INK_RED);
        for (int n = -1; n < 2; n++) {
            stage_marker(s, p.x + (float)n * 2, p.y);
            stage_marker(s, p.x, p.y + (float)n * 2);
        }
    }
}

static void say_parameters(struct stage *s, const struct liang_barsky *k)
{
    static const char *const names[] = {"left", "right", "below", "above"};
    char text[24];
    for (int i = 0; i < 4; i++) {
        if (k->p[i] == 0)
            snprintf(text, sizeof text, "%-5s    -", names[i]);
        else
            snprintf(text, sizeof text, "%-5s %5.2f", names[i], (double)(k->q[i] / k->p[i]));
        clipping_say(s, i, k->p[i] < 0 ? INK_GREEN : INK_RED, text);
    }
    snprintf(text, sizeof text, "t1    %5.2f", (double)k->t1);
    clipping_say(s, 5, INK_GREEN, text);
    snprintf(text, sizeof text, "t2    %5.2f", (double)k->t2);
    clipping_say(s, 6, INK_RED, text);
    clipping_say(s, 8, k->left ? INK_BRIGHT : INK_RED, k->left ? "t1 <= t2" : "rejected");
}

void clipping_liang_barsky(struct stage *s, float since)
{
    static const struct clip_window w = {230, 270, 610, 600};
    float turn = since * 0.21f, aside = 190 * sinf(since * 0.37f);
    float c = cosf(turn), n = sinf(turn);
    struct point2 middle = {420 - n * aside, 450 + c * aside};
    struct point2 a = {middle.x - 330 * c, middle.y - 300 * n};
    struct point2 b = {middle.x + 330 * c, middle.y + 300 * n}, from = a, to = b;
    struct liang_barsky k, all;
    bool left = clip_liang_barsky_shown(&w, &from, &to, &k);
    liang_barsky_begin(&all, &w, a, b);
    clipping_window(s, &w, INK_CYAN);
    clipping_cut_away(s, a, b);
    if (left)
        clipping_thick(s, from, to, INK_BRIGHT);
    end_mark(s, a, "0", INK_TEXT);
    end_mark(s, b, "1", INK_TEXT);
    meetings(s, &all, a);
    parameter_axis(s, &k);
    say_parameters(s, &k);
}

/* ---- many lines ------------------------------------------------------------------------------ */

void clipping_fan(struct stage *s, float since)
{
    enum { RAYS = 72 };
    static const struct clip_window w = {230, 220, 610, 580};
    struct point2 from = {420 + 330 * sinf(since * 0.4f), 400 + 300 * sinf(since * 0.63f)};
    int accepted = 0, clipped = 0, rejected = 0;
    char text[24];
    for (int i = 0; i < RAYS; i++) {
        float angle = ((float)i + since) * (TURN / RAYS);
        struct point2 a = {from.x + 60 * cosf(angle), from.y + 60 * sinf(angle)};
        struct point2 b = {from.x + 380 * cosf(angle), from.y + 380 * sinf(angle)};
        const struct point2 whole[2] = {a, b};
        struct clip_window picture = {0, 0, 840, STAGE_HEIGHT};
        struct point2 c = a, d = b;
        if (clip_liang_barsky(&picture, &c, &d))
            clipping_line(s, c, d, INK_BROWN);
        if (!clip_cohen_sutherland(&w, &a, &b)) {
            rejected++;
            continue;
        }
        bool all = a.x == whole[0].x && a.y == whole[0].y && b.x == whole[1].x && b.y == whole[1].y;
        accepted += all;
        clipped += !all;
        clipping_line(s, a, b, all ? INK_BRIGHT : INK_GREEN);
    }
    clipping_window(s, &w, INK_CYAN);
    snprintf(text, sizeof text, "whole   %2d", accepted);
    clipping_say(s, 2, INK_BRIGHT, text);
    snprintf(text, sizeof text, "clipped %2d", clipped);
    clipping_say(s, 3, INK_GREEN, text);
    snprintf(text, sizeof text, "none    %2d", rejected);
    clipping_say(s, 4, INK_BROWN, text);
}
