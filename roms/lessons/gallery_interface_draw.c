/* gallery_interface_draw.c — the desktop as it looks, from back to front. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "roms/clip/liang_barsky.h"
#include "roms/geometry/scalar.h"
#include "roms/lessons/gallery_interface.h"

enum { COVERS = DESK_WINDOWS + 1, CHARACTER = 17 /* of the vector head, stage units */ };

/* Draws what one thing shows: within `clip`, and on the vector head not where things in front
 * are. */
struct painter {
    struct stage *stage;
    struct clip_window clip, cover[COVERS];
    int covers;
};

static const struct clip_window everything = {0, 0, STAGE_WIDTH, STAGE_HEIGHT};

/* ---- lines, areas, text ---------------------------------------------------------------------- */

/* The parts of a line that covers from number k on leave. */
static void uncovered(const struct painter *p, struct point2 a, struct point2 b, int k)
{
    if (k == p->covers) {
        stage_line(p->stage, a.x, a.y, b.x, b.y);
        return;
    }
    struct point2 from = a, to = b;
    if (!clip_liang_barsky(&p->cover[k], &from, &to)) {
        uncovered(p, a, b, k + 1);
        return;
    }
    if (from.x != a.x || from.y != a.y)
        uncovered(p, a, from, k + 1);
    if (to.x != b.x || to.y != b.y)
        uncovered(p, to, b, k + 1);
}

static void line(const struct painter *p, struct point2 a, struct point2 b)
{
    if (!clip_liang_barsky(&p->clip, &a, &b))
        return;
    stage_heads(p->stage, STAGE_RASTER);
    stage_line(p->stage, a.x, a.y, b.x, b.y);
    stage_heads(p->stage, STAGE_VECTOR);
    uncovered(p, a, b, 0);
    stage_heads(p->stage, STAGE_BOTH);
}

static void polyline(const struct painter *p, const struct point2 *at, int count)
{
    for (int i = 1; i < count; i++)
        line(p, at[i - 1], at[i]);
}

/* Filled on the raster head only. */
static void ground(const struct painter *p, struct clip_window r, uint32_t colour)
{
    const struct canvas *c = &p->stage->canvas;
    int x0 = (int)floorf(stage_canvas_x(p->stage, r.x_min) + 0.5f);
    int x1 = (int)floorf(stage_canvas_x(p->stage, r.x_max) + 0.5f);
    int y0 = (int)floorf(stage_canvas_y(p->stage, r.y_max) + 0.5f);
    int y1 = (int)floorf(stage_canvas_y(p->stage, r.y_min) + 0.5f);
    canvas_fill(c, x0, y0, x1 - x0, y1 - y0, colour);
}

static void frame(const struct painter *p, struct clip_window r)
{
    const struct point2 at[5] = {{r.x_min, r.y_min},
                                 {r.x_max, r.y_min},
                                 {r.x_max, r.y_max},
                                 {r.x_min, r.y_max},
                                 {r.x_min, r.y_min}};
    polyline(p, at, 5);
}

static bool character_seen(const struct painter *p, float x, float y)
{
    struct clip_window box = {x, y - 4, x + CHARACTER, y + 18};
    if (box.x_max > p->clip.x_max || box.x_min < p->clip.x_min || box.y_min < p->clip.y_min)
        return false;
    for (int i = 0; i < p->covers; i++) {
        const struct clip_window *c = &p->cover[i];
        if (box.x_min < c->x_max && box.x_max > c->x_min && box.y_min < c->y_max &&
            box.y_max > c->y_min)
            return false;
    }
    return true;
}

/* On the vector head those characters that nothing covers, in as few stretches as there are. */
static void vector_text(const struct painter *p, float x, float y, const char *text)
{
    char part[64];
    size_t length = 0;
    for (int i = 0;; i++) {
        bool seen = text[i] != '\0' && character_seen(p, x + (float)(i * CHARACTER), y);
        if (seen && length + 1 < sizeof part) {
            part[length++] = text[i];
            continue;
        }
        part[length] = '\0';
        if (length > 0)
            stage_text(p->stage, x + (float)((i - (int)length) * CHARACTER), y, part);
        length = 0;
        if (text[i] == '\0')
            return;
    }
}

static void text(const struct painter *p, float x, float y, enum ink raster, enum ink vector,
                 const char *what)
{
    stage_heads(p->stage, STAGE_RASTER);
    stage_ink(p->stage, raster);
    stage_text(p->stage, x, y, what);
    stage_heads(p->stage, STAGE_VECTOR);
    stage_ink(p->stage, vector);
    vector_text(p, x, y, what);
    stage_heads(p->stage, STAGE_BOTH);
}

/* ---- what the windows show ------------------------------------------------------------------- */

static void hand(const struct painter *p, struct point2 middle, float part, float length,
                 enum ink ink)
{
    float angle = PI / 2 - TURN * part;
    stage_ink(p->stage, ink);
    line(p, middle,
         (struct point2){middle.x + length * cosf(angle), middle.y + length * sinf(angle)});
}

static void draw_clock(const struct painter *p, struct clip_window r, float now)
{
    enum { SIDES = 36 };
    struct point2 middle = {(r.x_min + r.x_max) / 2, (r.y_min + r.y_max) / 2}, rim[SIDES + 1];
    float radius = fminf(r.x_max - r.x_min, r.y_max - r.y_min) / 2 - 16;
    float time = 10 * 3600 + 8 * 60 + now;
    for (int i = 0; i <= SIDES; i++) {
        float angle = TURN * (float)i / SIDES;
        rim[i] = (struct point2){middle.x + radius * cosf(angle), middle.y + radius * sinf(angle)};
    }
    stage_ink(p->stage, INK_CYAN);
    polyline(p, rim, SIDES + 1);
    for (int i = 0; i < SIDES; i += 3)
        line(p, rim[i],
             (struct point2){middle.x + (rim[i].x - middle.x) * 0.9f,
                             middle.y + (rim[i].y - middle.y) * 0.9f});
    hand(p, middle, time / 43200, radius * 0.5f, INK_BRIGHT);
    hand(p, middle, time / 3600, radius * 0.8f, INK_BRIGHT);
    hand(p, middle, floorf(time) / 60, radius * 0.85f, INK_RED);
}

static void draw_graph(const struct painter *p, struct clip_window r, float now)
{
    enum { POINTS = 64 };
    struct point2 at[POINTS];
    float middle = (r.y_min + r.y_max) / 2, half = (r.y_max - r.y_min) / 2;
    stage_ink(p->stage, INK_GRID);
    for (int i = -2; i <= 2; i++)
        line(p, (struct point2){r.x_min, middle + half * 0.4f * (float)i},
             (struct point2){r.x_max, middle + half * 0.4f * (float)i});
    for (int i = 0; i < POINTS; i++) {
        float x = (float)i / (POINTS - 1), t = 14 * x + 2 * now;
        at[i] = (struct point2){r.x_min + x * (r.x_max - r.x_min),
                                middle + half * 0.4f * (sinf(t) + sinf(1.7f * t) * 0.8f)};
    }
    stage_ink(p->stage, INK_GREEN);
    polyline(p, at, POINTS);
}

static void draw_notes(const struct painter *p, struct clip_window r, float now)
{
    static const char *const lines[] = {"Dear class,",          "",
                                        "every window here is", "drawn anew, from the",
                                        "back to the front,",   "25 times a second."};
    enum { LINES = sizeof lines / sizeof lines[0], APART = 46 };
    int left = (int)fmodf(now * 9, 150); /* characters typed so far */
    for (int i = 0; i < LINES && left >= 0; i++) {
        char part[32];
        int length = (int)strlen(lines[i]);
        snprintf(part, sizeof part, "%.*s%s", left, lines[i], left < length ? "_" : "");
        text(p, r.x_min + 24, r.y_max - 52 - (float)i * APART, INK_TEXT, INK_TEXT, part);
        left -= length + 1;
    }
}

static void draw_picture(const struct painter *p, struct clip_window r, float now)
{
    enum { SQUARES = 12 };
    struct point2 middle = {(r.x_min + r.x_max) / 2, (r.y_min + r.y_max) / 2}, at[5];
    float radius = fminf(r.x_max - r.x_min, r.y_max - r.y_min) / 2 - 10;
    static const enum ink inks[] = {INK_ORANGE, INK_YELLOW, INK_VIOLET};
    for (int k = 0; k < SQUARES; k++, radius *= 0.82f) {
        for (int i = 0; i < 5; i++) {
            float angle = PI / 4 + PI / 2 * (float)i + (float)k * 0.35f * sinf(now * 0.7f);
            at[i] =
                (struct point2){middle.x + radius * cosf(angle), middle.y + radius * sinf(angle)};
        }
        stage_ink(p->stage, inks[k % 3]);
        polyline(p, at, 5);
    }
}

static void draw_content(const struct painter *p, int which, struct clip_window r, float now)
{
    static void (*const contents[DESK_WINDOWS])(const struct painter *, struct clip_window,
                                                float) = {[DESK_CLOCK] = draw_clock,
                                                          [DESK_GRAPH] = draw_graph,
                                                          [DESK_NOTES] = draw_notes,
                                                          [DESK_PICTURE] = draw_picture};
    contents[which](p, r, now);
}

/* ---- windows, icons, menus, pointer ---------------------------------------------------------- */

static void draw_window(const struct desk *d, struct painter *p, int which, bool focus)
{
    struct clip_window r = desk_window_area(d, which), bar = r, box, inner = r;
    bar.y_min = r.y_max - DESK_BAR;
    inner.y_max = bar.y_min;
    box = (struct clip_window){bar.x_min + 12, bar.y_min + 12, bar.x_min + 32, bar.y_max - 12};
    ground(p, r, ink_shade(RAMP_GREY, 0.02f));
    ground(p, bar, focus ? (uint32_t)INK_BLUE : ink_shade(RAMP_GREY, 0.1f));
    stage_ink(p->stage, focus ? INK_BRIGHT : INK_TEXT);
    frame(p, r);
    line(p, (struct point2){r.x_min, bar.y_min}, (struct point2){r.x_max, bar.y_min});
    frame(p, box);
    text(p, (r.x_min + r.x_max) / 2 - (float)strlen(desk_titles[which]) * 8, bar.y_min + 15,
         focus ? INK_BRIGHT : INK_TEXT, focus ? INK_BRIGHT : INK_TEXT, desk_titles[which]);
    p->clip = inner;
    draw_content(p, which, inner, d->now);
    p->clip = everything;
}

static void draw_icon(const struct desk *d, struct painter *p, int which)
{
    struct clip_window r = desk_icon_area(which);
    ground(p, r, ink_shade(RAMP_GREY, 0.03f));
    stage_ink(p->stage, d->window[which].open ? INK_BRIGHT : INK_GRID);
    frame(p, r);
    text(p, (r.x_min + r.x_max) / 2 - (float)strlen(desk_titles[which]) * 8, r.y_min - 28, INK_TEXT,
         INK_TEXT, desk_titles[which]);
    p->clip = r;
    if (which == DESK_NOTES) {
        stage_ink(p->stage, INK_TEXT);
        for (int i = 0; i < 5; i++)
            line(p, (struct point2){r.x_min + 16, r.y_max - 18 - (float)i * 16},
                 (struct point2){r.x_max - 16 - (float)(i % 3) * 12, r.y_max - 18 - (float)i * 16});
    } else {
        draw_content(p, which, r, 0);
    }
    p->clip = everything;
}

static void draw_bar(const struct desk *d, struct painter *p)
{
    struct clip_window bar = {0, STAGE_HEIGHT - DESK_BAR, STAGE_WIDTH, STAGE_HEIGHT};
    char time[16];
    ground(p, bar, ink_shade(RAMP_GREY, 0.55f));
    stage_ink(p->stage, INK_TEXT);
    frame(p, bar);
    for (int i = 0; i < DESK_MENUS; i++) {
        struct clip_window r = desk_menu_area(i);
        if (d->menu == i)
            ground(p, r, INK_YELLOW);
        text(p, r.x_min + 14, r.y_min + 14, INK_BLACK, d->menu == i ? INK_BRIGHT : INK_TEXT,
             desk_menus[i]);
    }
    int now = (int)d->now;
    snprintf(time, sizeof time, "10:%02d:%02d", (8 + now / 60) % 60, now % 60);
    text(p, STAGE_WIDTH - 160, bar.y_min + 14, INK_BLACK, INK_TEXT, time);
}

static struct clip_window menu_down(const struct desk *d)
{
    struct clip_window r = desk_item_area(d->menu, DESK_ITEMS - 1);
    r.y_max = desk_item_area(d->menu, 0).y_max;
    return r;
}

static void draw_menu(const struct desk *d, struct painter *p)
{
    struct clip_window all = menu_down(d);
    ground(p, all, ink_shade(RAMP_GREY, 0.55f));
    stage_ink(p->stage, INK_BRIGHT);
    frame(p, all);
    for (int i = 0; i < DESK_ITEMS; i++) {
        struct clip_window r = desk_item_area(d->menu, i);
        bool here = clip_point(&r, d->pointer);
        if (here)
            ground(p, r, INK_YELLOW);
        text(p, r.x_min + 20, r.y_min + 14, INK_BLACK, here ? INK_BRIGHT : INK_TEXT,
             desk_items[d->menu][i]);
        stage_ink(p->stage, INK_BRIGHT);
        if (here)
            frame(p, (struct clip_window){r.x_min + 5, r.y_min + 5, r.x_max - 5, r.y_max - 5});
    }
}

static void draw_pointer(const struct desk *d, struct stage *s)
{
    static const struct point2 arrow[] = {{0, 0},    {0, -42},  {10, -33}, {18, -52},
                                          {25, -49}, {17, -30}, {30, -30}};
    enum { CORNERS = sizeof arrow / sizeof arrow[0] };
    struct point2 at[CORNERS];
    for (int i = 0; i < CORNERS; i++)
        at[i] = (struct point2){d->pointer.x + arrow[i].x, d->pointer.y + arrow[i].y};
    stage_ink(s, d->dragged != DESK_NONE ? INK_YELLOW : INK_BRIGHT);
    stage_area(s, at, CORNERS);
    stage_heads(s, STAGE_RASTER);
    stage_ink(s, INK_BLACK);
    stage_polygon(s, at, CORNERS);
    stage_heads(s, STAGE_BOTH);
}

/* The windows in front of number `from` of the order, and a menu that is down. */
static void cover(const struct desk *d, struct painter *p, int from)
{
    p->covers = 0;
    for (int i = from; i < DESK_WINDOWS; i++)
        if (d->window[d->order[i]].open)
            p->cover[p->covers++] = desk_window_area(d, d->order[i]);
    if (d->menu != DESK_NONE)
        p->cover[p->covers++] = menu_down(d);
}

void desk_draw(const struct desk *d, struct stage *s)
{
    struct painter p = {.stage = s, .clip = everything};
    ground(&p, everything, ink_shade(RAMP_BLUE, 0.06f));
    cover(d, &p, 0);
    for (int i = 0; i < DESK_WINDOWS; i++)
        draw_icon(d, &p, i);
    for (int i = 0; i < DESK_WINDOWS; i++) {
        cover(d, &p, i + 1);
        if (d->window[d->order[i]].open)
            draw_window(d, &p, d->order[i], d->order[i] == desk_focus(d));
    }
    p.covers = 0;
    draw_bar(d, &p);
    if (d->menu != DESK_NONE)
        draw_menu(d, &p);
    draw_pointer(d, s);
}
