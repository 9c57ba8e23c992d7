/* picture.c — targets, and where the pen's firings lie before and after. */
#include <stdio.h>

#include "roms/calibrate/calibrate.h"
#include "roms/geometry/scalar.h"
#include "roms/raster/font.h"
#include "roms/stage/ink.h"
#include "roms/stage/tenths.h"

enum { BARS = 3 /* height of a bar of progress, lines of a target's half */ };

static struct canvas *hidden(struct calibration *c)
{
    return &c->page[1 - c->shown];
}

static void show(struct calibration *c)
{
    c->shown = 1 - c->shown;
    video_show(&c->page[c->shown]);
    video_wait_retrace();
}

static void text(const struct calibration *c, const struct canvas *page, int line, enum ink ink,
                 const char *words)
{
    int y = 6 + line * (FONT_HEIGHT + 4) * c->scale;
    canvas_text_middle(page, page->width / 2, y, c->scale, c->scale, ink, words);
}

/* Targets 1 to 9, checks A to D. */
static char name(int i)
{
    return (char)(i < TARGETS ? '1' + i : 'A' + i - TARGETS);
}

/* Above a target, clear of its arms. */
static void name_it(const struct calibration *c, const struct canvas *page, int i, enum ink ink)
{
    const char words[] = {name(i), '\0'};
    const struct place *p = &c->place[i];
    canvas_text_middle(page, p->x, p->y - c->half_y * 3 / 2 - (FONT_HEIGHT + 3) * c->scale - 4,
                       c->scale, c->scale, ink, words);
}

/* ---- targets ------------------------------------------------------------------------------------- */

static void mark(const struct canvas *page, int x, int y, int arm, enum ink ink)
{
    canvas_line(page, x - arm, y, x + arm, y, ink);
    canvas_line(page, x, y - arm, x, y + arm, ink);
}

/* Bright all over, so that the first row that the pen sees is lit, whichever it is; arms beside it lead
 * the eye to the middle, which is a dot. */
static void box(const struct calibration *c, const struct canvas *page, const struct place *p)
{
    int hx = c->half_x, hy = c->half_y;
    for (int k = -1; k <= 1; k += 2) {
        canvas_line(page, p->x + k * (hx + 4), p->y, p->x + k * (hx + 4 + hx / 2), p->y,
                    INK_ORANGE);
        canvas_line(page, p->x, p->y + k * (hy + 4), p->x, p->y + k * (hy + 4 + hy / 2),
                    INK_ORANGE);
    }
    canvas_fill(page, p->x - hx, p->y - hy, 2 * hx + 1, 2 * hy + 1, INK_BRIGHT);
    canvas_fill(page, p->x - 1, p->y - 1, 3, 3, INK_ORANGE);
}

static void others(const struct calibration *c, const struct canvas *page, int number)
{
    int first = number < TARGETS ? 0 : TARGETS, end = number < TARGETS ? TARGETS : PLACES;
    for (int i = first; i < end; i++) {
        const struct place *p = &c->place[i];
        enum ink ink = p->measured ? INK_GREEN : INK_GRID;
        if (i == number)
            continue;
        mark(page, p->x, p->y, c->half_y, ink);
        canvas_frame(page, p->x - c->half_x, p->y - c->half_y, 2 * c->half_x + 1, 2 * c->half_y + 1,
                     1, ink);
        name_it(c, page, i, ink);
    }
}

void picture_target(struct calibration *c, int number)
{
    char words[96];
    struct canvas *page = hidden(c);
    canvas_clear(page, INK_BLACK);
    text(c, page, 0, INK_BRIGHT,
         number < TARGETS ? "LIGHT PEN: CALIBRATION" : "LIGHT PEN: CHECK OF THE CALIBRATION");
    snprintf(words, sizeof words, "Press the pen on the middle of box %c, hold it still, let go.",
             name(number));
    text(c, page, 1, INK_TEXT, words);
    others(c, page, number);
    box(c, page, &c->place[number]);
    name_it(c, page, number, INK_ORANGE);
    show(c);
}

void picture_progress(const struct calibration *c, int number, int done)
{
    const struct place *p = &c->place[number];
    const struct canvas *page = &c->page[c->shown];
    int width = 2 * c->half_x + 1, y = p->y + c->half_y + c->half_y / 2 + 10;
    int reached = width * done / HITS;
    canvas_fill(page, p->x - c->half_x, y, reached, BARS * c->scale, INK_GREEN);
    canvas_fill(page, p->x - c->half_x + reached, y, width - reached, BARS * c->scale, INK_GRID);
}

/* ---- results ------------------------------------------------------------------------------------- */

/* Firings as they came, and what they are with the offset. */
static void errors(const struct calibration *c, const struct canvas *page)
{
    for (int i = 0; i < PLACES; i++) {
        const struct place *p = &c->place[i];
        int x = scalar_nearest((float)p->x + p->left_x),
            y = scalar_nearest((float)p->y + p->left_y);
        mark(page, p->x, p->y, 3 * c->half_y / 2, INK_GRID);
        int dot = scalar_nearest(p->dot), line = scalar_nearest(p->line);
        canvas_line(page, p->x, p->y, dot, line, INK_RED);
        canvas_frame(page, dot - 2 * c->scale, line - 2 * c->scale, 4 * c->scale + 1,
                     4 * c->scale + 1, c->scale, INK_RED);
        canvas_frame(page, x - 4 * c->scale, y - 4 * c->scale, 8 * c->scale + 1, 8 * c->scale + 1,
                     1, i < TARGETS ? INK_GREEN : INK_CYAN);
        name_it(c, page, i, INK_TEXT);
    }
}

/* All errors on one target, enlarged: a square is a pixel. */
struct lens {
    const struct canvas *page;
    int cell, columns, rows, left, top; /* of a square; how many; dots and lines of the corner */
    int x, y;                           /* middle of the target */
};

static struct lens lens_of(const struct calibration *c, const struct canvas *page)
{
    enum { ROWS = 5, BEFORE = 8 /* squares left of the target */ };
    struct lens l = {.page = page, .cell = page->height * 9 / 480, .rows = ROWS};
    l.columns = page->width * 9 / 10 / l.cell;
    l.left = (page->width - l.columns * l.cell) / 2;
    l.top = page->height - ROWS * l.cell - 4 * c->scale;
    l.x = l.left + BEFORE * l.cell + l.cell / 2;
    l.y = l.top + ROWS / 2 * l.cell + l.cell / 2;
    return l;
}

static void in_lens(const struct lens *l, float dx, float dy, int arm, enum ink ink)
{
    int x = l->x + scalar_nearest(dx * (float)l->cell),
        y = l->y + scalar_nearest(dy * (float)l->cell);
    if (x > l->left && x < l->left + l->columns * l->cell && y > l->top &&
        y < l->top + l->rows * l->cell)
        mark(l->page, x, y, arm, ink);
}

static void enlarged(const struct calibration *c, const struct canvas *page)
{
    struct lens l = lens_of(c, page);
    for (int k = 0; k <= l.columns; k++)
        canvas_line(page, l.left + k * l.cell, l.top, l.left + k * l.cell, l.top + l.rows * l.cell,
                    INK_GRID);
    for (int k = 0; k <= l.rows; k++)
        canvas_line(page, l.left, l.top + k * l.cell, l.left + l.columns * l.cell,
                    l.top + k * l.cell, INK_GRID);
    canvas_frame(page, l.x - l.cell / 2, l.y - l.cell / 2, l.cell + 1, l.cell + 1, c->scale,
                 INK_BRIGHT);
    for (int i = 0; i < PLACES; i++) {
        const struct place *p = &c->place[i];
        in_lens(&l, p->dx, p->dy, 3 * c->scale, INK_RED);
        in_lens(&l, p->left_x, p->left_y, 3 * c->scale, i < TARGETS ? INK_GREEN : INK_CYAN);
    }
    canvas_text_middle(page, page->width / 2, l.top - (FONT_HEIGHT + 1) * c->scale, c->scale,
                       c->scale, INK_TEXT, "all on one target: a square is a pixel");
}

void picture_results(struct calibration *c)
{
    char words[96], dots[12], lines[12], sees[12];
    struct canvas *page = hidden(c);
    canvas_clear(page, INK_BLACK);
    text(c, page, 0, INK_BRIGHT, "LIGHT PEN: HOW LATE IT IS");
    tenths_text(dots, sizeof dots, c->dots, 0, true);
    tenths_text(lines, sizeof lines, c->lines, 0, true);
    tenths_text(sees, sizeof sees, (float)c->sees_um / 1000, 0, false);
    snprintf(words, sizeof words, "%s dots, %s lines: %d ns late, sees %s mm", dots, lines,
             c->late_ns, sees);
    text(c, page, 1, INK_TEXT, words);
    text(c, page, 2, INK_TEXT, "red: where it fired   green, blue: corrected   q: ends");
    errors(c, page);
    enlarged(c, page);
    show(c);
}

void picture_pen(const struct calibration *c, float dot, float line, bool pressed)
{
    int x = scalar_nearest(dot - c->dots), y = scalar_nearest(line - c->lines);
    const struct canvas *page = &c->page[c->shown];
    canvas_fill(page, x - c->scale, y - c->scale, 2 * c->scale + 1, 2 * c->scale + 1,
                pressed ? INK_YELLOW : INK_ORANGE);
}
