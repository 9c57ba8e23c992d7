/* lines.c — the commands of lines; those of circles and ellipses are in circles.c. */
#include <stdio.h>
#include <stdlib.h>

#include "roms/commands/circles.h"
#include "roms/geometry/scalar.h"
#include "roms/monitor/command.h"
#include "roms/monitor/print.h"
#include "roms/monitor/stepper.h"
#include "roms/raster/line_bresenham.h"
#include "roms/raster/line_dda.h"
#include "roms/raster/line_dda_integer.h"

enum { FARTHEST = 2000 };

struct line {
    int x0, y0, x1, y1;
    int pixels;
    bool told; /* somebody reads rows or decisions */
    bool tied; /* a tie against the axis: see line_bresenham.h */
    struct line_dda dda;
    struct line_dda_integer integer;
    struct line_bresenham bresenham;
};

static void light(struct line *line, struct step *step, int x, int y)
{
    step->lit[step->lit_count++] = (struct step_run){y, x, x, INK_GREEN};
    line->pixels++;
}

/* The pixels on both sides of a place that is not rounded. */
static void candidates(struct step *step, float x, float y, bool steep)
{
    struct point2 low = {floorf(x), floorf(y)}, high = low;
    if (steep)
        high.x += 1;
    else
        high.y += 1;
    step->candidate[0] = low;
    step->candidate[1] = high;
    step->candidate_count = 2;
    step->midpoint = (struct point2){x, y};
    step->has_midpoint = true;
}

static bool steep(const struct line *line)
{
    return line_case_of(line->x0, line->y0, line->x1, line->y1).steep;
}

static bool next_dda(void *state, struct step *step)
{
    struct line *line = state;
    struct line_dda *l = &line->dda;
    if (!line_dda_next(l))
        return false;
    light(line, step, l->plot_x, l->plot_y);
    if (!line->told)
        return true;
    candidates(step, l->x, l->y, steep(line));
    snprintf(step->row, STEP_TEXT, "%4d %10.4f %10.4f %7d %7d", l->k, print_tidy(l->x),
             print_tidy(l->y), l->plot_x, l->plot_y);
    snprintf(step->decision, STEP_TEXT, "(%.4f, %.4f): the nearest pixel is (%d, %d)",
             print_tidy(l->x), print_tidy(l->y), l->plot_x, l->plot_y);
    return true;
}

static float value(struct line_parts v, int bits)
{
    return (float)v.whole + (float)v.fraction / (float)(1 << bits);
}

static bool next_integer(void *state, struct step *step)
{
    struct line *line = state;
    struct line_dda_integer *l = &line->integer;
    if (!line_dda_integer_next(l))
        return false;
    light(line, step, l->plot_x, l->plot_y);
    if (!line->told)
        return true;
    candidates(step, value(l->x, l->bits), value(l->y, l->bits), steep(line));
    snprintf(step->row, STEP_TEXT, "%4d %6d %6d %6d %6d %7d %7d", l->k, l->x.whole, l->x.fraction,
             l->y.whole, l->y.fraction, l->plot_x, l->plot_y);
    snprintf(step->decision, STEP_TEXT, "(%d + %d/65536, %d + %d/65536): pixel (%d, %d)",
             l->x.whole, l->x.fraction, l->y.whole, l->y.fraction, l->plot_x, l->plot_y);
    return true;
}

/* What the next decision chooses from. */
static void choices(const struct line_bresenham *l, struct step *step)
{
    struct point2 along = {(float)(l->x + l->along_x), (float)(l->y + l->along_y)};
    struct point2 diagonal = {along.x + (float)l->across_x, along.y + (float)l->across_y};
    step->candidate[0] = along;
    step->candidate[1] = diagonal;
    step->candidate_count = 2;
    step->midpoint = (struct point2){(along.x + diagonal.x) * 0.5f, (along.y + diagonal.y) * 0.5f};
    step->has_midpoint = true;
}

static void explain(const struct line_bresenham *l, char *text)
{
    static const char *const relations[2][2] = {{"< 0", ">= 0"}, {"<= 0", "> 0"}};
    bool steps = l->p >= l->tie;
    float ratio = (float)l->p / (float)l->last; /* d1 - d2 */
    snprintf(text, STEP_TEXT, "p = %d %s: %c %s (d1 = %.4f, d2 = %.4f)", l->p,
             relations[l->tie][steps], l->along_x != 0 ? 'y' : 'x', steps ? "steps" : "stays",
             print_tidy((1 + ratio) / 2), print_tidy((1 - ratio) / 2));
}

static bool next_bresenham(void *state, struct step *step)
{
    struct line *line = state;
    struct line_bresenham *l = &line->bresenham;
    int p = l->p;
    if (line->told && l->k >= 0 && l->k < l->last) {
        choices(l, step);
        explain(l, step->decision);
    }
    if (!line_bresenham_next(l))
        return false;
    light(line, step, l->x, l->y);
    line->tied |= l->k > 0 && p == 0 && l->tie == 1;
    if (!line->told)
        return true;
    if (l->k > 0) {
        snprintf(step->row, STEP_TEXT, "%4d %7d %6d %6d", l->k - 1, p, l->x, l->y);
    } else {
        snprintf(step->row, STEP_TEXT, "%4s %7s %6d %6d", "", "", l->x, l->y);
        snprintf(step->decision, STEP_TEXT, "The first end: (%d, %d)", l->x, l->y);
    }
    return true;
}

static void ideal(const void *state, const struct grid *grid)
{
    const struct line *line = state;
    grid_line(grid, (float)line->x0, (float)line->y0, (float)line->x1, (float)line->y1, INK_BRIGHT);
}

/* The answer: slope, direction, increments of that case (lettered A to P, two for each of the eight), how
 * many pixels. */
static void tell(const struct line *line, bool bresenham)
{
    struct line_case c = line_case_of(line->x0, line->y0, line->x1, line->y1);
    int dx = line->x1 - line->x0, dy = line->y1 - line->y0;
    if (dx == 0 && dy == 0) {
        printf("a point: 1 pixel\n");
        return;
    }
    if (dx == 0)
        printf("m is infinite, %s", dy > 0 ? "upward" : "downward");
    else
        printf("m = %.4f, %s, %s", print_tidy((float)dy / (float)dx),
               dy == 0      ? "level"
               : c.negative ? "negative"
                            : "positive",
               c.leftward ? "right to left" : "left to right");
    printf(", |m| %s 1: ", c.steep ? ">" : "<=");
    if (bresenham) {
        int along = abs(c.steep ? dy : dx), across = abs(c.steep ? dx : dy);
        printf("p0 = %d, p < 0: %+d, else: %+d", 2 * across - along, 2 * across,
               2 * across - 2 * along);
    } else {
        printf("%s (%c), %s (%c)", c.along, c.along_letter, c.across, c.across_letter);
    }
    printf(": %d pixels\n", line->pixels);
    if (line->tied)
        printf("A tie, p = 0, stays on the way back: both ways light the same pixels.\n");
}

static bool line(struct monitor *m, struct words *w)
{
    static const char *const names[] = {"dda", "integer", "bresenham", NULL};
    static const struct stepper ways[] = {
        {.title = "DDA", .header = "   k          x          y  plot x  plot y", .next = next_dda},
        {.title = "DDA in whole numbers",
         .header = "   k      x /65536      y /65536  plot x  plot y",
         .next = next_integer},
        {.title = "Bresenham's line",
         .header = "   k       p      x      y",
         .next = next_bresenham},
    };
    struct line state = {0};
    int which, *const ends[] = {&state.x0, &state.y0, &state.x1, &state.y1};
    char title[64];
    if (!words_choice(w, names, &which))
        return false;
    for (int i = 0; i < 4; i++)
        if (!words_whole(w, -FARTHEST, FARTHEST, ends[i]))
            return false;
    if (!words_end(w))
        return false;
    line_dda_begin(&state.dda, state.x0, state.y0, state.x1, state.y1);
    line_dda_integer_begin(&state.integer, state.x0, state.y0, state.x1, state.y1,
                           LINE_FRACTION_BITS);
    line_bresenham_begin(&state.bresenham, state.x0, state.y0, state.x1, state.y1);
    snprintf(title, sizeof title, "%s from (%d,%d) to (%d,%d)", ways[which].title, state.x0,
             state.y0, state.x1, state.y1);
    struct stepper stepper = ways[which];
    stepper.title = title;
    stepper.x0 = scalar_min_int(state.x0, state.x1);
    stepper.y0 = scalar_min_int(state.y0, state.y1);
    stepper.x1 = scalar_max_int(state.x0, state.x1);
    stepper.y1 = scalar_max_int(state.y0, state.y1);
    stepper.ideal = ideal;
    stepper.caption = "White: the ideal line. Lit: the pixel nearest to it at each step.";
    stepper.state = &state;
    state.told = m->table || m->steps;
    scan_run(m, &stepper);
    tell(&state, which == 2);
    return true;
}

const struct command commands_lines[] = {
    {"line", "dda|integer|bresenham x0 y0 x1 y1", "a line, pixel by pixel", line},
    {"circle", "xc yc r", "a midpoint circle from (0,r)", commands_circle},
    {"circle-side", "xc yc r", "a midpoint circle from (r,0)", commands_circle_side},
    {"ellipse", "xc yc rx ry", "a midpoint ellipse in two regions", commands_ellipse},
    {NULL, NULL, NULL, NULL},
};
