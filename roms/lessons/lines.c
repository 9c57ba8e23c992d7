/* lines.c — a line goes round like a clock's hand: the DDA and Bresenham's algorithm pixel by
 * pixel. */
#include <stdio.h>
#include <stdlib.h>

#include "roms/lessons/lesson.h"
#include "roms/raster/line_bresenham.h"
#include "roms/raster/line_dda.h"
#include "roms/raster/line_dda_integer.h"
#include "roms/stage/grid.h"

enum {
    REACH = 6,        /* of the hand, pixels */
    ENDS = 8 * REACH, /* places of its end */
    HURRY = 5,        /* ends from one line to the next */
    GRID_WIDTH = 590,
    GRID_BOTTOM = 116,
    GRID_HEIGHT = 640,
    TEXT = 96,
};

static struct clock {
    int end;      /* which of the ENDS */
    float step;   /* pixels that are drawn, in fractions */
    float speed;  /* pixels a second */
    float before; /* seconds at the last picture */
    bool whole;   /* the DDA in whole numbers */
    bool stopped;
} the_clock;

/* Ends on a square about the origin, upward first, clockwise. */
static void end_of(int which, int *x, int *y)
{
    int side = which / (2 * REACH), along = which % (2 * REACH) - REACH;
    static const int turn[4][4] = {{1, 0, 0, 1}, {0, 1, -1, 0}, {-1, 0, 0, -1}, {0, -1, 1, 0}};
    *x = turn[side][0] * along + turn[side][1] * REACH;
    *y = turn[side][2] * along + turn[side][3] * REACH;
}

static int longer(int x, int y)
{
    return abs(x) > abs(y) ? abs(x) : abs(y);
}

static void begin(void *state)
{
    struct clock *c = state;
    *c = (struct clock){.end = REACH + 4, .speed = 3};
}

static void turn(struct clock *c, int by)
{
    c->end = (c->end + by + ENDS) % ENDS;
    c->step = 0;
}

static void key(void *state, int k)
{
    struct clock *c = state;
    if (k == ' ')
        turn(c, HURRY);
    else if (k == 'b')
        turn(c, -HURRY);
    else if (k == KEY_RIGHT)
        turn(c, 1);
    else if (k == KEY_LEFT)
        turn(c, -1);
    else if (k == 'p')
        c->stopped = !c->stopped;
    else if (k == 'n')
        c->step += 1;
    else if ((k == '+' || k == '=') && c->speed < 40)
        c->speed *= 1.5f;
    else if (k == '-' && c->speed > 0.5f)
        c->speed /= 1.5f;
    else if (k == 'd')
        c->whole = !c->whole;
}

static void pass(struct clock *c, float seconds)
{
    enum { REST = 5 }; /* pixels' time at the end of a line */
    int x, y;
    end_of(c->end, &x, &y);
    if (!c->stopped)
        c->step += (seconds - c->before) * c->speed;
    c->before = seconds;
    if (c->step >= (float)(longer(x, y) + REST))
        turn(c, HURRY);
}

/* ---- one algorithm on one grid --------------------------------------------------------------- */

struct panel {
    struct grid grid;
    const char *name;
    enum ink ink;
    int x, y;  /* the end */
    int drawn; /* the number of the last pixel */
    char text[TEXT];
};

static struct panel panel_at(struct stage *stage, float left, const char *name, enum ink ink)
{
    struct panel p = {.name = name, .ink = ink};
    p.grid =
        grid_fit(stage, left, GRID_BOTTOM, GRID_WIDTH, GRID_HEIGHT, -REACH, -REACH, REACH, REACH);
    grid_rules(&p.grid);
    return p;
}

static void pixel(const struct panel *p, int k, int x, int y)
{
    grid_pixel(&p->grid, x, y, k == p->drawn ? INK_YELLOW : p->ink);
}

static void draw_dda(struct panel *p)
{
    struct line_dda l;
    line_dda_begin(&l, 0, 0, p->x, p->y);
    while (l.k < p->drawn && line_dda_next(&l))
        pixel(p, l.k, l.plot_x, l.plot_y);
    snprintf(p->text, TEXT, "(%.2f, %.2f) rounds to (%d, %d)", (double)l.x, (double)l.y, l.plot_x,
             l.plot_y);
    struct point2 at = grid_place(&p->grid, l.x, l.y);
    stage_ink(p->grid.stage, INK_RED);
    stage_marker(p->grid.stage, at.x, at.y);
}

static void draw_whole(struct panel *p)
{
    struct line_dda_integer l;
    line_dda_integer_begin(&l, 0, 0, p->x, p->y, LINE_FRACTION_BITS);
    while (l.k < p->drawn && line_dda_integer_next(&l))
        pixel(p, l.k, l.plot_x, l.plot_y);
    bool steep = abs(p->y) > abs(p->x);
    struct line_parts v = steep ? l.x : l.y;
    snprintf(p->text, TEXT, "%c = %d + %d/65536 rounds to %d", steep ? 'x' : 'y', v.whole,
             v.fraction, steep ? l.plot_x : l.plot_y);
}

static void draw_bresenham(struct panel *p)
{
    struct line_bresenham l;
    struct stage *stage = p->grid.stage;
    line_bresenham_begin(&l, 0, 0, p->x, p->y);
    while (l.k < p->drawn && line_bresenham_next(&l))
        pixel(p, l.k, l.x, l.y);
    if (l.k == l.last) {
        snprintf(p->text, TEXT, "the end: (%d, %d)", l.x, l.y);
        return;
    }
    int x = l.x + l.along_x, y = l.y + l.along_y;
    grid_candidate(&p->grid, x, y, INK_BRIGHT);
    grid_candidate(&p->grid, x + l.across_x, y + l.across_y, INK_BRIGHT);
    struct point2 at = grid_place(&p->grid, (float)x + 0.5f * (float)l.across_x,
                                  (float)y + 0.5f * (float)l.across_y);
    stage_ink(stage, INK_RED);
    stage_marker(stage, at.x, at.y);
    bool steps = l.p >= l.tie;
    snprintf(p->text, TEXT, "p = %d %s 0: %c %s", l.p,
             steps   ? l.tie ? ">" : ">="
             : l.tie ? "<="
                     : "<",
             l.along_x != 0 ? 'y' : 'x', steps ? "steps" : "stays");
}

static void finish(const struct panel *p)
{
    struct stage *stage = p->grid.stage;
    float middle = p->grid.left + 0.5f * p->grid.cell * (float)(p->grid.x1 - p->grid.x0 + 1);
    grid_line(&p->grid, 0, 0, (float)p->x, (float)p->y, INK_BRIGHT);
    stage_ink(stage, p->ink);
    stage_text_middle(stage, middle, GRID_BOTTOM + GRID_HEIGHT - 8, p->name);
    stage_ink(stage, INK_BRIGHT);
    stage_text_middle(stage, middle, GRID_BOTTOM - 22, p->text);
}

static void write_case(struct stage *stage, int x, int y)
{
    struct line_case c = line_case_of(0, 0, x, y);
    char text[TEXT];
    snprintf(text, sizeof text, "%s slope, %s, |m| %s 1:   %s (%c)   %s (%c)",
             c.negative ? "negative" : "positive", c.leftward ? "right to left" : "left to right",
             c.steep ? ">" : "<=", c.along, c.along_letter, c.across, c.across_letter);
    stage_ink(stage, INK_TEXT);
    stage_text_middle(stage, STAGE_WIDTH / 2, 40, text);
}

static float draw(void *state, struct stage *stage, float seconds)
{
    struct clock *c = state;
    pass(c, seconds);
    struct panel left = panel_at(stage, 0, c->whole ? "DDA in whole numbers" : "DDA", INK_ORANGE);
    struct panel right = panel_at(stage, STAGE_WIDTH - GRID_WIDTH, "Bresenham", INK_CYAN);
    int x, y;
    end_of(c->end, &x, &y);
    int drawn = (int)c->step < longer(x, y) ? (int)c->step : longer(x, y);
    left.x = right.x = x;
    left.y = right.y = y;
    left.drawn = right.drawn = drawn;
    if (c->whole)
        draw_whole(&left);
    else
        draw_dda(&left);
    draw_bresenham(&right);
    finish(&left);
    finish(&right);
    write_case(stage, x, y);
    stage_title(stage, "Lines: from the ideal to pixels");
    stage_caption(stage, "Both light the pixel nearest to the line. The DDA adds and rounds; "
                         "Bresenham only looks at the sign of p.");
    return 0.03f;
}

extern const struct lesson lesson_lines;
const struct lesson lesson_lines = {"lines",
                                    "Lines: DDA and Bresenham",
                                    "space b line  arrows turn  p pause  n step  + - pace  d DDA",
                                    &the_clock,
                                    begin,
                                    key,
                                    draw};
