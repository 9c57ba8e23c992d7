/* clipping.c — the lesson on windows and clipping: its pages in order, and what they have in
 * common. */
#include "roms/lessons/clipping.h"

#include <math.h>
#include <stdio.h>

#include "roms/clip/edge.h"
#include "roms/lessons/large_text.h"
#include "roms/lessons/lesson.h"
#include "roms/lessons/pages.h"

enum { PICTURE = 840, TOP = CLIPPING_TOP }; /* of what is beside the panel */

void clipping_line(struct stage *s, struct point2 a, struct point2 b, enum ink ink)
{
    stage_ink(s, ink);
    stage_line(s, a.x, a.y, b.x, b.y);
}

void clipping_thick(struct stage *s, struct point2 a, struct point2 b, enum ink ink)
{
    const float apart = 2;
    bool steep = fabsf(b.y - a.y) > fabsf(b.x - a.x);
    struct point2 d = steep ? (struct point2){apart, 0} : (struct point2){0, apart};
    clipping_line(s, a, b, ink);
    stage_heads(s, STAGE_RASTER);
    stage_line(s, a.x + d.x, a.y + d.y, b.x + d.x, b.y + d.y);
    stage_line(s, a.x - d.x, a.y - d.y, b.x - d.x, b.y - d.y);
    stage_heads(s, STAGE_BOTH);
}

void clipping_cut_away(struct stage *s, struct point2 a, struct point2 b)
{
    stage_heads(s, STAGE_RASTER);
    clipping_line(s, a, b, INK_RED);
    stage_heads(s, STAGE_VECTOR);
    stage_ink(s, INK_BROWN);
    stage_line_type(s, STAGE_SHORT_DASH);
    stage_line(s, a.x, a.y, b.x, b.y);
    stage_line_type(s, STAGE_SOLID);
    stage_heads(s, STAGE_BOTH);
}

void clipping_window(struct stage *s, const struct clip_window *w, enum ink ink)
{
    stage_ink(s, ink);
    stage_rectangle(s, w->x_min, w->y_min, w->x_max - w->x_min, w->y_max - w->y_min);
}

void clipping_say(struct stage *s, int line, enum ink ink, const char *text)
{
    stage_ink(s, ink);
    large_text(s, CLIPPING_PANEL, 720 - (float)line * 64, text);
}

void clipping_code(unsigned code, char text[5])
{
    for (int i = 0; i < 4; i++)
        text[i] = code & 8u >> i ? '1' : '0';
    text[4] = '\0';
}

void clipping_codes(struct stage *s, const struct clip_window *w)
{
    const float x[] = {0, w->x_min, w->x_max, PICTURE}, y[] = {0, w->y_min, w->y_max, TOP};
    stage_ink(s, INK_GRID);
    for (int i = 1; i < 3; i++) {
        stage_line(s, x[i], 0, x[i], TOP);
        stage_line(s, 0, y[i], PICTURE, y[i]);
    }
    stage_ink(s, INK_BLUE);
    for (int i = 0; i < 9; i++) {
        char code[5];
        struct point2 middle = {(x[i % 3] + x[i % 3 + 1]) / 2, (y[i / 3] + y[i / 3 + 1]) / 2};
        clipping_code(clip_region(w, middle), code);
        large_text_middle(s, middle.x, y[i / 3 + 1] - 56, code);
    }
}

/* ---- a point and its code -------------------------------------------------------------------- */

static void lit_region(struct stage *s, const struct clip_window *w, struct point2 p)
{
    const float x0 = p.x < w->x_min ? 0 : p.x > w->x_max ? w->x_max : w->x_min;
    const float x1 = p.x < w->x_min ? w->x_min : p.x > w->x_max ? PICTURE : w->x_max;
    const float y0 = p.y < w->y_min ? 0 : p.y > w->y_max ? w->y_max : w->y_min;
    const float y1 = p.y < w->y_min ? w->y_min : p.y > w->y_max ? TOP : w->y_max;
    const struct point2 c[] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    stage_heads(s, STAGE_RASTER);
    stage_ink(s, (enum ink)ink_shade(clip_point(w, p) ? RAMP_GREEN : RAMP_BLUE, 0.12f));
    stage_area(s, c, 4);
    stage_heads(s, STAGE_BOTH);
}

static void comparison(struct stage *s, int line, const char *what, bool holds)
{
    char text[24];
    snprintf(text, sizeof text, "%s %d", what, holds);
    clipping_say(s, line, holds ? INK_YELLOW : INK_TEXT, text);
}

void clipping_regions(struct stage *s, float since)
{
    static const struct clip_window w = {250, 240, 590, 560};
    struct point2 p = {420 + 390 * sinf(since * 0.53f), 390 + 350 * sinf(since * 0.71f + 0.6f)};
    char code[5];
    unsigned region = clip_region(&w, p);
    lit_region(s, &w, p);
    clipping_codes(s, &w);
    clipping_window(s, &w, INK_CYAN);
    clipping_code(region, code);
    stage_ink(s, INK_BRIGHT);
    for (int i = -1; i < 2; i++) { /* thick enough to be seen */
        stage_marker(s, p.x + (float)i * 3, p.y);
        stage_marker(s, p.x, p.y + (float)i * 3);
    }
    large_text(s, p.x < 700 ? p.x + 16 : p.x - 140, p.y < 740 ? p.y + 14 : p.y - 50, code);
    comparison(s, 1, "y > ymax", region & REGION_ABOVE);
    comparison(s, 2, "y < ymin", region & REGION_BELOW);
    comparison(s, 3, "x > xmax", region & REGION_RIGHT);
    comparison(s, 4, "x < xmin", region & REGION_LEFT);
    clipping_say(s, 6, region == 0 ? INK_GREEN : INK_RED, region == 0 ? "inside" : "outside");
    clipping_say(s, 7, INK_BRIGHT, code);
}

/* ---- the lesson ------------------------------------------------------------------------------ */

static const struct page table[] = {
    {"Region codes: above, below, right, left",
     "Four comparisons make a code. 0000: the point is in the window.", 18, clipping_regions},
    {"Cohen-Sutherland: cut by cut", "Both 0000: accepted. A bit in both: rejected. Else: cut.", 50,
     clipping_cohen_sutherland},
    {"Liang-Barsky: last entry, first exit",
     "Green: p < 0, the line enters. Red: p > 0, it leaves.", 26, clipping_liang_barsky},
    {"Seventy-two lines, clipped every time",
     "White: inside. Green: what is left of those that are cut.", 16, clipping_fan},
    {"Sutherland-Hodgman: edge by edge",
     "A pass cuts at one edge. Parts of a concave polygon stay joined.", 30, clipping_polygon},
    {"Text clipped by three rules", "All of it or none; whole characters; dot by dot.", 20,
     clipping_text},
};

static struct pages pages = {
    .page = table, .count = sizeof table / sizeof table[0], .again = 0.03f};

extern const struct lesson lesson_clipping;
const struct lesson lesson_clipping = {
    "clipping", "Windows and clipping", PAGES_KEYS, &pages, pages_begin, pages_key, pages_draw};
