/* hud_marks.c — marks on the glass, and a picture in a corner. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emu/hud_parts.h"

#define LINE          1.6 /* pixels */
#define RIM           1.2 /* pixels: dark on both sides of it, so that it is seen on what is bright, too */
#define MOST          400.0 /* pixels: a larger ring is drawn so large */
#define ARM           2.2   /* how far a cross reaches, in radii */
#define MARGIN        8     /* pixels between the picture and the edges of the window */
#define CAPTION_LINES 8
#define ALPHA         200
#define RIM_PART      0.6 /* of that */
#define SEE_THROUGH   235

/* ---- setting -------------------------------------------------------------------------------------
 */

void vm_hud_mark(struct vm_hud *hud, enum vm_hud_mark which, double x, double y, double radius)
{
    struct vm_hud_place *mark = &hud->mark[which];
    bool same = radius == mark->radius && (radius == 0 || (x == mark->x && y == mark->y));
    hud->stale |= !same;
    *mark = (struct vm_hud_place){x, y, radius};
}

void vm_hud_ring(struct vm_hud *hud, double x, double y, double radius)
{
    vm_hud_mark(hud, VM_MARK_PEN, x, y, radius);
}

void vm_hud_picture(struct vm_hud *hud, const struct crt_image *image, const char *caption)
{
    hud->stale |= image != NULL || hud->picture != NULL;
    free(hud->picture);
    hud->picture = NULL;
    hud->caption[0] = '\0';
    if (!image || image->depth != 8)
        return;
    size_t count = (size_t)image->width * (size_t)image->height * 3;
    hud->picture = malloc(count);
    if (!hud->picture)
        return;
    for (size_t i = 0; i < count; i++)
        hud->picture[i] = (uint8_t)image->samples[i];
    hud->picture_width = image->width;
    hud->picture_height = image->height;
    if (caption)
        snprintf(hud->caption, sizeof hud->caption, "%s", caption);
}

/* ---- drawing -------------------------------------------------------------------------------------
 */

static int within(double v, int most)
{
    return v < 0 ? 0 : v > most ? most : (int)v;
}

/* How far pixel (dx, dy) from the mark's middle lies from its lines. */
typedef double (*shape)(double dx, double dy, double radius);

static double ring(double dx, double dy, double radius)
{
    return fabs(hypot(dx, dy) - radius);
}

/* Four arms that leave the middle free. */
static double cross(double dx, double dy, double radius)
{
    double along = fmax(fabs(dx), fabs(dy)), across = fmin(fabs(dx), fabs(dy));
    double beyond = fmax(fmax(radius - along, along - ARM * radius), 0);
    return hypot(across, beyond);
}

static double ring_and_cross(double dx, double dy, double radius)
{
    return fmin(ring(dx, dy, radius), cross(dx, dy, radius));
}

/* Smooth edges: each pixel is covered as far as its centre is from the middle of the line. */
static double covered(double away, double half)
{
    return fmin(fmax(half + 0.5 - away, 0), 1);
}

/* The line over its dark rim. */
static struct vm_colour mixed(struct vm_colour ink, double away)
{
    double line = covered(away, LINE / 2), rim = RIM_PART * covered(away, LINE / 2 + RIM);
    double all = line + rim * (1 - line), part = all > 0 ? line / all : 0;
    return (struct vm_colour){(uint8_t)(ink.r * part), (uint8_t)(ink.g * part),
                              (uint8_t)(ink.b * part), (uint8_t)(ALPHA * all)};
}

static void draw(struct vm_hud *hud, int which, shape form, struct vm_colour ink)
{
    const struct vm_hud_place *mark = &hud->mark[which];
    double r = fmin(mark->radius, MOST), reach = (form == ring ? 1 : ARM) * r + LINE + RIM + 1;
    int left = within(floor(mark->x - reach), hud->canvas.width);
    int top = within(floor(mark->y - reach), hud->canvas.height);
    int right = within(ceil(mark->x + reach), hud->canvas.width);
    int bottom = within(ceil(mark->y + reach), hud->canvas.height);
    if (right <= left || bottom <= top)
        return;
    for (int y = top; y < bottom; y++)
        for (int x = left; x < right; x++) {
            struct vm_colour dot = mixed(ink, form(x + 0.5 - mark->x, y + 0.5 - mark->y, r));
            if (dot.a > 0)
                vm_canvas_fill(&hud->canvas, (struct vm_box){x, y, 1, 1}, dot);
        }
    hud->drawn[VM_PANEL_MARKS + which] = (struct vm_box){left, top, right - left, bottom - top};
}

/* As wide as the picture above it. */
static void draw_caption(struct vm_hud *hud, struct vm_box above)
{
    int dot = vm_hud_dot(hud->canvas.width, hud->canvas.height), pad = VM_HUD_PAD_DOTS * dot;
    int columns = (above.w - 2 * pad) / (VM_LETTER_DOTS * dot);
    struct vm_line lines[CAPTION_LINES];
    size_t count = vm_wrap(hud->caption, (size_t)(columns < 1 ? 1 : columns), lines, CAPTION_LINES);
    struct vm_box box = {above.x, above.y + above.h, above.w,
                         (int)count * VM_LINE_DOTS * dot - 2 * dot + 2 * pad};
    if (count == 0 || box.y + box.h > hud->canvas.height)
        return;
    vm_hud_draw_panel(hud, VM_PANEL_CAPTION, box, dot, VM_HUD_LEVELS);
    for (size_t i = 0; i < count; i++)
        vm_canvas_text(&hud->canvas, box.x + pad, box.y + pad + (int)i * VM_LINE_DOTS * dot, dot,
                       hud->ink, lines[i].text, lines[i].length);
}

/* In the upper right corner; of two halves where they meet, which hides least of either. */
static void draw_picture(struct vm_hud *hud)
{
    int w = hud->picture_width, h = hud->picture_height;
    int left = hud->canvas.width - w - MARGIN, top = MARGIN;
    if (hud->side[1][0]) {
        left = (hud->canvas.width - w) / 2;
        top = vm_hud_strip(hud->canvas.width, hud->canvas.height); /* under what they are called */
    }
    if (left < 0 || top + h > hud->canvas.height)
        return;
    for (int y = 0; y < h; y++) {
        const uint8_t *from = hud->picture + (size_t)y * (size_t)w * 3;
        uint8_t *to =
            hud->canvas.rgba + ((size_t)(top + y) * (size_t)hud->canvas.width + (size_t)left) * 4;
        for (int x = 0; x < w; x++, from += 3, to += 4) {
            memcpy(to, from, 3);
            to[3] = SEE_THROUGH;
        }
    }
    hud->drawn[VM_PANEL_PICTURE] = (struct vm_box){left, top, w, h};
    draw_caption(hud, hud->drawn[VM_PANEL_PICTURE]);
}

void vm_hud_draw_marks(struct vm_hud *hud)
{
    static const struct vm_colour amber = {255, 176, 64, 255}, yellow = {255, 236, 90, 255};
    static const struct vm_colour white = {255, 255, 255, 255};
    if (hud->mark[VM_MARK_PEN].radius > 0)
        draw(hud, VM_MARK_PEN, ring, hud->ink);
    for (int which = VM_MARK_BEAM; which <= VM_MARK_BEAM_RASTER_RIGHT; which++)
        if (hud->mark[which].radius > 0)
            draw(hud, which, cross, amber);
    if (hud->mark[VM_MARK_DIODE].radius > 0)
        draw(hud, VM_MARK_DIODE, ring_and_cross, yellow);
    if (hud->mark[VM_MARK_ASKED].radius > 0)
        draw(hud, VM_MARK_ASKED, ring_and_cross, white);
    if (hud->picture)
        draw_picture(hud);
}
