/* interlace — what a row that is only one row high does: it flickers at half the field rate.
 *
 *      kinescope run roms/interlace.elf --tube TV12M [--console]
 *
 * Four seconds each by turns: interlaced, and then not. An interlaced field has every second row, so
 * that each row comes at half the rate of the fields. What is two rows high has a row in each field
 * and stands still; what is one row high does not: thin lines, serifs, the edges of slanted lines.
 * Worst is the patch where every second row is lit: one field has all of it, the other nothing.
 *
 * A television set (15.7 kHz) is shown 525 lines interlaced, then 262 lines, as home computers did
 * it: the same line rate, half the rows, each in every field. A computer monitor is shown the
 * 8514/A's 1024x768 interlaced, then the same size, or what it can, without.
 *
 * Keys: i changes over, and then it stays; q ends the program.
 * Marks: n when the n-th turn's picture is complete; odd ones are interlaced.
 */
#include <stdbool.h>
#include <stdio.h>

#include "roms/bsp/board.h"
#include "roms/bsp/console.h"
#include "roms/bsp/timer.h"
#include "roms/bsp/video.h"
#include "roms/raster/font.h"

#define TURN (4 * TIMER_HZ)

enum { BLACK, WHITE };

#define LACED (VIDEO_SYNC_INTERLACED)
#define PLUS  (VIDEO_SYNC_H_PLUS | VIDEO_SYNC_V_PLUS)

/* 525/60i: SMPTE 170M with the dots of ITU-R BT.601; 262 lines: its line rate. 8514/A, XGA, VGA:
 * VESA DMT 0Fh, 10h, 04h. */
static const struct video_timing tv_laced = {13500000, 720, 736, 799, 858,
                                             480,      488, 494, 525, LACED};
static const struct video_timing tv_plain = {13500000, 720, 736, 799, 858, 240, 244, 247, 262, 0};
static const struct video_timing xga_laced = {44900000, 1024, 1032, 1208, 1264,
                                              768,      768,  776,  817,  PLUS | LACED};
static const struct video_timing xga_plain = {65000000, 1024, 1048, 1184, 1344,
                                              768,      771,  777,  806,  0};
static const struct video_timing vga_plain = {25175000, 640, 656, 752, 800, 480, 490, 492, 525, 0};

/* The first of these that the monitor follows; NULL: none. */
static const struct video_timing *first_of(const struct video_timing *const *list, unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        if (video_set_timing(list[i]))
            return list[i];
    return NULL;
}

/* ---- the picture ------------------------------------------------------------------------------- */

/* A picture is laid out for 480 rows; `tall` is how many of the screen's rows are as high as one of
 * those: 1, or less where there are fewer. */
struct picture {
    struct canvas canvas;
    bool laced;
    int scale; /* of writing: dots a pixel of the font */
    int tall;  /* and rows */
};

static int at_y(const struct picture *p, int y)
{
    return y * p->canvas.height / 480;
}

static int at_x(const struct picture *p, int x)
{
    return x * p->canvas.width / 640;
}

static void text(const struct picture *p, int x, int y, int rows, const char *words)
{
    canvas_text(&p->canvas, at_x(p, x), at_y(p, y), p->scale, rows, WHITE, words);
}

/* Rows lit one of `step`, `thick` rows high; beneath it, what it is. */
static void stripes(const struct picture *p, int x, int step, int thick, const char *words)
{
    int left = at_x(p, x), width = at_x(p, 130), bottom = at_y(p, 230);
    for (int y = at_y(p, 120); y + thick <= bottom; y += step)
        canvas_fill(&p->canvas, left, y, width, thick, WHITE);
    text(p, x, 238, p->tall, words);
}

/* Lines that are nearly level, and a ring: each step of theirs is one row. */
static void slanted(const struct picture *p, int x, int y, int width, int height)
{
    const struct canvas *c = &p->canvas;
    int x0 = at_x(p, x), y0 = at_y(p, y), x1 = at_x(p, x + width), y1 = at_y(p, y + height);
    for (int i = 0; i <= 6; i++)
        canvas_line(c, x0, y1, x1, y1 + (y0 - y1) * i / 6, WHITE);
    canvas_frame(c, x0, y0, x1 - x0 + 1, y1 - y0 + 1, 1, WHITE);
}

static void writing(const struct picture *p, int x, int y)
{
    static const char *const words[] = {"ONE ROW HIGH:", "these feet flicker"};
    static const char *const double_words[] = {"TWO ROWS HIGH:", "these stand still"};
    int line = (480 * (FONT_HEIGHT + 2) + p->canvas.height - 1) / p->canvas.height;
    for (int i = 0; i < 2; i++) {
        text(p, x, y + i * line, 1, words[i]);
        text(p, x, y + (2 + 2 * i) * line + line / 2, 2, double_words[i]);
    }
}

static void heading(const struct picture *p)
{
    struct video_timing t = video_timing();
    char words[96];
    uint32_t field = video_field_millihertz(&t);
    uint32_t row = (p->laced ? field / 2 : field) / 10; /* hundredths */
    canvas_text(&p->canvas, at_x(p, 24), at_y(p, 26), p->scale + 1, 2 * p->tall, WHITE,
                p->laced ? "INTERLACED" : "NOT INTERLACED");
    snprintf(words, sizeof words, "%d rows: each one %lu.%02lu times a second", p->canvas.height,
             (unsigned long)row / 100, (unsigned long)row % 100);
    text(p, 24, 76, p->tall, words);
}

static void draw(struct picture *p)
{
    const struct canvas *c = &p->canvas;
    p->scale = c->width >= 700 ? 2 : 1; /* a set does not resolve single dots */
    p->tall = c->height >= 400 ? 2 : 1;
    canvas_clear(c, BLACK);
    canvas_frame(c, 0, 0, c->width, c->height, 2, WHITE);
    heading(p);
    stripes(p, 24, 2, 1, "1 of 2");
    stripes(p, 178, 8, 1, "1 of 8");
    stripes(p, 332, 4, 2, "2 of 4");
    stripes(p, 486, 8, 2, "2 of 8");
    slanted(p, 24, 290, 284, 150);
    writing(p, 332, 290);
}

/* ---- turns ------------------------------------------------------------------------------------- */

struct show {
    const struct video_timing *timing[2]; /* interlaced, and not */
    unsigned turns;
    uint64_t began;
    bool stays;
};

static void turn(struct show *show)
{
    struct picture p = {.laced = show->turns % 2 == 0};
    video_off();
    video_set_timing(show->timing[show->turns % 2]);
    p.canvas = video_open(1);
    draw(&p);
    video_on();
    show->began = timer_now();
    board_mark(++show->turns);
}

int main(void)
{
    static const struct video_timing *const laced[] = {&tv_laced, &xga_laced};
    static const struct video_timing *const tv[] = {&tv_plain};
    static const struct video_timing *const computer[] = {&xga_plain, &vga_plain};
    static struct show show;
    if (!video_present()) {
        console_write("interlace: this board has no raster head.\n");
        return 1;
    }
    show.timing[0] = first_of(laced, 2);
    show.timing[1] = show.timing[0] == &tv_laced ? first_of(tv, 1) : first_of(computer, 2);
    if (show.timing[0] == NULL || show.timing[1] == NULL) {
        console_write("interlace: this monitor follows no interlaced mode; try --tube TV12M.\n");
        return 1;
    }
    video_set_colour(BLACK, 0x000000);
    video_set_colour(WHITE, 0xFFFFFF);
    turn(&show);
    for (;;) {
        video_wait_retrace();
        int c = console_poll();
        if (c == 'q')
            return 0;
        show.stays = show.stays || c == 'i';
        if (c == 'i' || (!show.stays && timer_now() - show.began >= TURN))
            turn(&show);
    }
}
