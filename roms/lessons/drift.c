/* drift.c — what the DDA loses on a long line, and the steps that every line of pixels has. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "roms/geometry/scalar.h"
#include "roms/lessons/lesson.h"
#include "roms/lessons/pages.h"
#include "roms/raster/line_antialiased.h"
#include "roms/raster/line_bresenham.h"
#include "roms/raster/line_dda.h"
#include "roms/raster/line_dda_integer.h"
#include "roms/stage/grid.h"

enum {
    SAMPLES = 120, /* of each curve */
    WAYS = 3,      /* floats, fractions, Bresenham */
    LINES = 4,
    PAGES = LINES + 1, /* the last: aliasing */
    RUN = 8,           /* seconds that a line takes */
    REST = 4,          /* … and that it is shown for afterwards */
    SPIN = 16,         /* seconds of aliasing */
    TEXT = 64,
};

/* From (0,0) to (length, rise), with so many bits of fraction. */
static const struct {
    int length, rise, bits;
} long_lines[LINES] = {{2000, 1237, 8}, {8000, 5641, 12}, {60000, 40361, 12}, {60000, 6007, 14}};

static const char *const names[WAYS] = {"float", "fractions", "Bresenham"};
static const enum ink inks[WAYS] = {INK_ORANGE, INK_VIOLET, INK_GREEN};

static struct drift {
    int line; /* of long_lines */
    struct line_dda dda;
    struct line_dda_integer fractions;
    struct line_bresenham bresenham;
    float error[WAYS][SAMPLES + 1]; /* pixels, at sample · length / SAMPLES */
    float now[WAYS];
    int samples;     /* that there are */
    int wrong[WAYS]; /* pixels that are not the nearest */
} the_drift;

static void turn(void *own, int page)
{
    struct drift *d = own;
    memset(d, 0, sizeof *d);
    if (page == LINES)
        return;
    int x = long_lines[page].length, y = long_lines[page].rise;
    d->line = page;
    line_dda_begin(&d->dda, 0, 0, x, y);
    line_dda_integer_begin(&d->fractions, 0, 0, x, y, long_lines[page].bits);
    line_bresenham_begin(&d->bresenham, 0, 0, x, y);
}

/* ---- drift ----------------------------------------------------------------------------------- */

/* What p keeps is the pixel's distance from the line, without loss: p + long - 2 short = 2 (exact -
 * y long). */
static float kept_by_p(const struct line_bresenham *l, int64_t exact)
{
    int64_t twice_long = l->straight - l->diagonal;
    int64_t kept = l->p + twice_long / 2 - l->straight + twice_long * l->y;
    return (float)(kept - 2 * exact) / (float)twice_long;
}

/* One pixel of all three. Each error is what was summed up less the exact k · rise / length, whole
 * pixels and the rest apart, so that the comparison loses nothing. */
static void one_pixel(struct drift *d)
{
    if (!line_dda_next(&d->dda) || !line_dda_integer_next(&d->fractions) ||
        !line_bresenham_next(&d->bresenham))
        return;
    int length = long_lines[d->line].length;
    int64_t exact = (int64_t)d->dda.k * long_lines[d->line].rise;
    int whole = (int)(exact / length), rest = (int)(exact % length), nearest = d->bresenham.y;
    float part = (float)rest / (float)length;
    struct line_parts y = d->fractions.y;
    d->now[0] = d->dda.y - (float)whole - part;
    d->now[1] = (float)(y.whole - whole) +
                (float)y.fraction / (float)(1 << long_lines[d->line].bits) - part;
    d->now[2] = kept_by_p(&d->bresenham, exact);
    d->wrong[0] += d->dda.plot_y != nearest;
    d->wrong[1] += d->fractions.plot_y != nearest;
}

/* Goes on to pixel k, and keeps the errors on the way. */
static void run_to(struct drift *d, int k)
{
    while (d->dda.k < k && d->dda.k < d->dda.last) {
        one_pixel(d);
        if (d->dda.k * (int64_t)SAMPLES < (int64_t)d->samples * d->dda.last)
            continue;
        for (int way = 0; way < WAYS; way++)
            d->error[way][d->samples] = d->now[way];
        d->samples++;
    }
}

struct plot {
    struct stage *stage;
    float left, bottom, width, height;
    float most; /* pixels at the upper edge */
};

static struct point2 plot_place(const struct plot *p, float sample, float error)
{
    return (struct point2){p->left + p->width * sample / SAMPLES,
                           p->bottom + p->height * (0.5f + 0.5f * error / p->most)};
}

static void plot_level(const struct plot *p, float error, enum ink ink, const char *text)
{
    struct point2 a = plot_place(p, 0, error), b = plot_place(p, SAMPLES, error);
    stage_ink(p->stage, ink);
    stage_line(p->stage, a.x, a.y, b.x, b.y);
    stage_text(p->stage, 8, a.y - 8, text);
}

/* A round number at least v. */
static float round_up(float v)
{
    static const float digits[] = {1, 1.5f, 2, 3, 4, 6, 8};
    float power = powf(10, floorf(log10f(v)));
    for (unsigned i = 0; i < sizeof digits / sizeof *digits; i++)
        if (v <= digits[i] * power)
            return digits[i] * power;
    return 10 * power;
}

static struct plot draw_axes(const struct drift *d, struct stage *stage)
{
    struct plot p = {stage, 110, 70, 690, 680, 1};
    char text[TEXT];
    float most = 0.6f;
    for (int way = 0; way < WAYS; way++)
        for (int i = 0; i < d->samples; i++)
            most = fmaxf(most, fabsf(d->error[way][i]));
    p.most = round_up(most);
    snprintf(text, sizeof text, "%+.3g", (double)p.most);
    plot_level(&p, p.most, INK_GRID, text);
    snprintf(text, sizeof text, "%+.3g", (double)-p.most);
    plot_level(&p, -p.most, INK_GRID, text);
    plot_level(&p, 0, INK_GRID, "0");
    if (p.most <= 5) {
        plot_level(&p, 0.5f, INK_RED, "+1/2");
        plot_level(&p, -0.5f, INK_RED, "-1/2");
    }
    stage_ink(stage, INK_TEXT);
    snprintf(text, sizeof text, "pixel 0                    to                %d",
             long_lines[d->line].length);
    stage_text_middle(stage, p.left + p.width / 2, 26, text);
    return p;
}

static void draw_curves(const struct drift *d, const struct plot *p)
{
    for (int way = 0; way < WAYS; way++) {
        stage_ink(p->stage, inks[way]);
        for (int i = 1; i < d->samples; i++) {
            struct point2 a = plot_place(p, (float)(i - 1), d->error[way][i - 1]);
            struct point2 b = plot_place(p, (float)i, d->error[way][i]);
            stage_line(p->stage, a.x, a.y, b.x, b.y);
        }
    }
}

static void draw_figures(const struct drift *d, struct stage *stage)
{
    enum { LEFT = 836, TOP = 720, ROW = 36 };
    char text[TEXT];
    int row = 0;
    snprintf(text, sizeof text, "to (%d,%d)", long_lines[d->line].length, long_lines[d->line].rise);
    stage_ink(stage, INK_TEXT);
    stage_text(stage, LEFT, TOP, text);
    snprintf(text, sizeof text, "pixel %d", d->dda.k);
    stage_text(stage, LEFT, TOP - ROW, text);
    for (int way = 0; way < WAYS; way++) {
        stage_ink(stage, inks[way]);
        if (way == 1)
            snprintf(text, sizeof text, "%d bits of fraction", long_lines[d->line].bits);
        else
            snprintf(text, sizeof text, "%s", names[way]);
        stage_text(stage, LEFT, (float)(TOP - ROW * (row + 3)), text);
        snprintf(text, sizeof text, " off by %+.4f", (double)d->now[way]);
        stage_text(stage, LEFT, (float)(TOP - ROW * (row + 4)), text);
        snprintf(text, sizeof text, " %d wrong pixel%s", d->wrong[way],
                 d->wrong[way] == 1 ? "" : "s");
        stage_text(stage, LEFT, (float)(TOP - ROW * (row + 5)), text);
        row += 4;
    }
}

static void draw_drift(struct drift *d, struct stage *stage, float seconds)
{
    float share = seconds / RUN;
    run_to(d, (int)((share < 1 ? share : 1) * (float)d->dda.last));
    struct plot plot = draw_axes(d, stage);
    draw_curves(d, &plot);
    draw_figures(d, stage);
    stage_title(stage, "Drift: the error of the sum, in pixels");
    stage_caption(stage, "Each addition rounds; a long line drifts away. "
                         "A whole pixel off, all pixels are wrong.");
}

/* ---- aliasing -------------------------------------------------------------------------------- */

enum { SIZE = 23, PITCH = (SIZE + 3) / 4 * 4, GRID_SIDE = 580, SHADES = 16 };

/* A line through the middle of a small canvas, in pixels 0…SHADES − 1. */
static void small_line(uint8_t *pixels, float angle, bool smooth)
{
    struct canvas c = {pixels, PITCH, SIZE, SIZE, 8, 1};
    uint32_t ramp[SHADES];
    float middle = SIZE / 2, dx = (middle - 1) * cosf(angle), dy = (middle - 1) * sinf(angle);
    for (unsigned i = 0; i < SHADES; i++)
        ramp[i] = i;
    if (smooth)
        canvas_line_antialiased(&c, middle - dx, middle - dy, middle + dx, middle + dy, ramp,
                                SHADES);
    else
        canvas_line(&c, scalar_nearest(middle - dx), scalar_nearest(middle - dy),
                    scalar_nearest(middle + dx), scalar_nearest(middle + dy), SHADES - 1);
}

/* The same as it is on the glass: pixel for pixel, three times, on the raster head. */
static void real_lines(struct stage *stage, float left, float angle, bool smooth)
{
    uint32_t ramp[SHADES];
    for (unsigned i = 0; i < SHADES; i++)
        ramp[i] = ink_shade(RAMP_GREY, (float)i / (SHADES - 1));
    for (int i = 0; i < 3; i++) {
        float x0 = stage_canvas_x(stage, left), y0 = stage_canvas_y(stage, 70 - 30 * (float)i);
        float length = GRID_SIDE * stage->dots * 0.9f;
        float x1 = x0 + length, y1 = y0 - length * 0.1f * sinf(angle + (float)i * 0.3f);
        if (smooth)
            canvas_line_antialiased(&stage->canvas, x0, y0, x1, y1, ramp, SHADES);
        else
            canvas_line(&stage->canvas, scalar_nearest(x0), scalar_nearest(y0), scalar_nearest(x1),
                        scalar_nearest(y1), ramp[SHADES - 1]);
    }
}

static void draw_enlarged(struct stage *stage, float left, float angle, bool smooth)
{
    uint8_t pixels[SIZE * PITCH] __attribute__((aligned(4))) = {0};
    struct grid grid = grid_fit(stage, left, 130, GRID_SIDE, 620, 1, 1, SIZE - 2, SIZE - 2);
    small_line(pixels, angle, smooth);
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            unsigned level = pixels[y * PITCH + x];
            if (level > 0)
                grid_pixel(&grid, x, SIZE - 1 - y,
                           (enum ink)ink_shade(RAMP_GREY, (float)level / (SHADES - 1)));
        }
    real_lines(stage, left + 30, angle, smooth);
    stage_ink(stage, smooth ? INK_GREEN : INK_ORANGE);
    stage_text_middle(stage, left + GRID_SIDE / 2, 760, smooth ? "antialiased" : "Bresenham");
}

static void draw_aliasing(struct stage *stage, float seconds)
{
    float angle = 0.15f * seconds;
    draw_enlarged(stage, 0, angle, false);
    draw_enlarged(stage, STAGE_WIDTH - GRID_SIDE, angle, true);
    stage_title(stage, "Aliasing: a line of pixels has steps");
    stage_caption(stage,
                  "Steps creep along a line that turns. Shades by how much of a pixel the line "
                  "covers make it calm.");
}

static float draw(void *own, struct stage *stage, int page, float seconds)
{
    if (page < LINES)
        draw_drift(own, stage, seconds);
    else
        draw_aliasing(stage, seconds);
    return page < LINES ? RUN + REST : SPIN;
}

static struct pages pages = {
    .count = PAGES, .again = 0.03f, .own = &the_drift, .turn = turn, .draw = draw};

extern const struct lesson lesson_drift;
const struct lesson lesson_drift = {
    "drift", "Drift and aliasing of lines", PAGES_KEYS, &pages, pages_begin, pages_key, pages_draw};
