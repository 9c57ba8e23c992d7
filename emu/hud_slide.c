/* hud_slide.c — a caption in large letters under the picture, or a page of text or a picture in place of it. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emu/hud_parts.h"
#include "emu/plain.h"

#define LINES     24
#define PAD_DOTS  3
#define GAP       3 /* letters between title and hint */
#define SHARE_NUM 2 /* of the window's height that a caption may have */
#define SHARE_DEN 5
#define AIR       2 /* dots more from line to line than in small text */

static const struct vm_colour black = {0, 0, 0, 255}, white = {238, 240, 242, 255};

/* A slide as it is set into a window. */
struct set {
    int dot, height; /* pixels; height of title and text with their edges */
    struct vm_line line[LINES];
    size_t lines;
};

static void keep(struct vm_hud *hud, char *to, size_t size, const char *text)
{
    char plain[VM_HUD_SLIDE];
    vm_plain(text ? text : "", plain, size);
    hud->stale |= strcmp(to, plain) != 0;
    snprintf(to, size, "%s", plain);
}

static void keep_picture(struct vm_hud_kept *kept, const struct crt_image *image)
{
    free(kept->picture);
    kept->picture = NULL;
    if (!image || image->depth != 8)
        return;
    size_t count = (size_t)image->width * (size_t)image->height * 3;
    kept->picture = malloc(count);
    for (size_t i = 0; kept->picture && i < count; i++)
        kept->picture[i] = (uint8_t)image->samples[i];
    kept->width = image->width;
    kept->height = image->height;
}

void vm_hud_slide(struct vm_hud *hud, const struct vm_hud_slide *slide)
{
    static const struct vm_hud_slide none = {.text = NULL};
    struct vm_hud_kept *kept = &hud->slide;
    const struct vm_hud_slide *s = slide ? slide : &none;
    hud->stale |= kept->shown != (slide != NULL) || kept->whole != s->whole ||
                  kept->large != s->large || s->picture || kept->picture;
    kept->shown = slide != NULL;
    kept->whole = s->whole;
    kept->large = s->large;
    keep(hud, kept->title, sizeof kept->title, s->title);
    keep(hud, kept->hint, sizeof kept->hint, s->hint);
    keep(hud, kept->text, sizeof kept->text, s->text);
    keep_picture(kept, s->picture);
}

/* ---- layout ------------------------------------------------------------------------------------ */

/* Pixels from line to line. */
static int leading(int dot)
{
    return (VM_LINE_DOTS + AIR) * dot;
}

static int columns(int width, int dot)
{
    int count = (width - 4 * PAD_DOTS * dot) / (VM_LETTER_DOTS * dot);
    return count < 1 ? 1 : count;
}

static void set_with(const struct vm_hud_kept *kept, int width, int dot, struct set *set)
{
    set->dot = dot;
    set->lines = vm_wrap(kept->text, (size_t)columns(width, dot), set->line, LINES);
    set->height = (1 + (int)set->lines) * leading(dot) + 2 * PAD_DOTS * dot;
}

/* The largest letters, not above those wanted, with which it fits. */
static void set_slide(const struct vm_hud_kept *kept, int width, int height, struct set *set)
{
    int dot = vm_hud_dot(width, height) * (kept->large ? 3 : 2);
    bool alone = kept->whole && !kept->picture;
    int room = alone ? height : height * SHARE_NUM / SHARE_DEN;
    set_with(kept, width, dot, set);
    while (dot > 1 && (set->height > room || strlen(kept->title) > (size_t)columns(width, dot)))
        set_with(kept, width, --dot, set);
    if (set->height > room)
        set->height = room;
}

int vm_hud_slide_height(const struct vm_hud *hud, int width, int height)
{
    struct set set;
    if (!hud->slide.shown || width <= 0 || height <= 0)
        return 0;
    if (hud->slide.whole)
        return height;
    set_slide(&hud->slide, width, height, &set);
    return set.height;
}

/* ---- drawing ----------------------------------------------------------------------------------- */

/* The mean of the picture over one pixel of a copy `scale` times as large. */
static struct vm_colour mean(const struct vm_hud_kept *p, double x, double y, double scale)
{
    int x0 = (int)(x / scale), y0 = (int)(y / scale);
    int x1 = (int)((x + 1) / scale), y1 = (int)((y + 1) / scale);
    x1 = x1 > p->width ? p->width : x1 > x0 ? x1 : x0 + 1;
    y1 = y1 > p->height ? p->height : y1 > y0 ? y1 : y0 + 1;
    unsigned long sum[3] = {0, 0, 0}, count = 0;
    for (int v = y0; v < y1 && v < p->height; v++)
        for (int u = x0; u < x1 && u < p->width; u++, count++)
            for (int c = 0; c < 3; c++)
                sum[c] += p->picture[((size_t)v * (size_t)p->width + (size_t)u) * 3 + (size_t)c];
    if (count == 0)
        return black;
    return (struct vm_colour){(uint8_t)(sum[0] / count), (uint8_t)(sum[1] / count),
                              (uint8_t)(sum[2] / count), 255};
}

/* In the middle of what is left above the text, as large as fits. */
static void draw_still(struct vm_hud *hud, int room)
{
    const struct vm_hud_kept *p = &hud->slide;
    double across = (double)hud->canvas.width / p->width, down = (double)room / p->height;
    double scale = across < down ? across : down;
    int w = (int)(p->width * scale), h = (int)(p->height * scale);
    int left = (hud->canvas.width - w) / 2, top = (room - h) / 2;
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++)
            vm_canvas_fill(&hud->canvas, (struct vm_box){left + x, top + y, 1, 1},
                           mean(p, x, y, scale));
}

/* On the right of the title in smaller letters, where there is room. */
static void draw_hint(struct vm_hud *hud, int y, int dot)
{
    const struct vm_hud_kept *s = &hud->slide;
    int small = dot > 1 ? (dot + 1) / 2 : 1, edge = 2 * PAD_DOTS * dot;
    int title = ((int)strlen(s->title) + GAP) * VM_LETTER_DOTS * dot;
    int wide = (int)strlen(s->hint) * VM_LETTER_DOTS * small;
    const struct vm_colour grey = {150, 154, 158, 255};
    if (edge + title + wide + edge <= hud->canvas.width)
        vm_canvas_text(&hud->canvas, hud->canvas.width - edge - wide,
                       y + VM_TALL_DOTS * (dot - small), small, grey, s->hint, strlen(s->hint));
}

void vm_hud_draw_slide(struct vm_hud *hud)
{
    const struct vm_hud_kept *s = &hud->slide;
    int width = hud->canvas.width, height = hud->canvas.height;
    struct set set;
    if (!s->shown)
        return;
    set_slide(s, width, height, &set);
    int top = height - set.height, edge = 2 * PAD_DOTS * set.dot;
    struct vm_box box = {0, s->whole ? 0 : top, width, s->whole ? height : set.height};
    vm_canvas_fill(&hud->canvas, box, black);
    hud->drawn[VM_PANEL_SLIDE] = box;
    if (s->whole && s->picture)
        draw_still(hud, top);
    else if (s->whole)
        top /= 2;
    int y = top + PAD_DOTS * set.dot;
    vm_canvas_text(&hud->canvas, edge, y, set.dot, hud->ink, s->title, strlen(s->title));
    draw_hint(hud, y, set.dot);
    for (size_t i = 0; i < set.lines; i++) {
        y += leading(set.dot);
        if (y + VM_TALL_DOTS * set.dot > height)
            break;
        vm_canvas_text(&hud->canvas, edge, y, set.dot, white, set.line[i].text, set.line[i].length);
    }
}
