/* What shows how fine a detail the tube resolves: gratings, wedges, stars. */
#include <math.h>
#include <stdio.h>

#include "roms/pattern/pattern.h"
#include "roms/raster/font.h"

void pattern_grating(const struct pattern *p, struct pattern_box box, int pair, bool level)
{
    pattern_fill(p, box, PATTERN_BLACK);
    int x0 = pattern_x(p, box.x0), y0 = pattern_y(p, box.y0);
    int width = pattern_x(p, box.x1) - x0, height = pattern_y(p, box.y1) - y0;
    /* Whole lines only, bright ones at both ends, in the middle of the box. */
    int length = level ? height : width;
    int lines = (length + pair / 2) / pair, used = lines * pair - pair / 2;
    if (level)
        y0 += (height - used) / 2;
    else
        x0 += (width - used) / 2;
    for (int at = 0; at < used; at += pair)
        if (level)
            canvas_fill(&p->canvas, x0, y0 + at, width, pair / 2, PATTERN_WHITE);
        else
            canvas_fill(&p->canvas, x0 + at, y0, pair / 2, height, PATTERN_WHITE);
}

/* ---- wedges ------------------------------------------------------------------------------------ */

/* How much of the length from 0 to `at` is dark, when the first half of every pair is. */
static float dark_until(float at, float pair)
{
    float whole = floorf(at / pair), rest = at - whole * pair;
    return whole * pair * 0.5f + (rest < pair * 0.5f ? rest : pair * 0.5f);
}

static uint32_t covered(const struct pattern *p, float share)
{
    return pattern_grey(p->level[(int)((1.0f - share) * (PATTERN_LEVELS - 1) + 0.5f)]);
}

/* One line of pixels across the wedge: the pairs about their middle. */
static void across(const struct pattern *p, int x, int y, float pair,
                   const struct pattern_wedge *wedge)
{
    float half = pair * ((float)wedge->pairs - 0.5f) / 2.0f; /* it ends dark on both sides */
    int reach = (int)half + 1;
    for (int i = -reach; i <= reach; i++) {
        float from = (float)i - 0.5f + half, to = from + 1.0f;
        from = from > 0.0f ? from : 0.0f;
        to = to < 2.0f * half ? to : 2.0f * half;
        float dark = to > from ? dark_until(to, pair) - dark_until(from, pair) : 0.0f;
        canvas_dot(&p->canvas, wedge->level ? x : x + i, wedge->level ? y + i : y,
                   covered(p, dark));
    }
}

/* Marks beside it: pixels a line, half a pair. */
static void mark(const struct pattern *p, int x, int y, const struct pattern_wedge *wedge, int pair)
{
    static const int marks[] = {1, 2, 3, 4, 6};
    char text[8];
    int away = (int)(wedge->wide * (float)wedge->pairs / 2.0f) + 4, tick = 6 * p->text;
    for (unsigned i = 0; i < sizeof marks / sizeof *marks; i++) {
        if (2 * marks[i] != pair)
            continue;
        snprintf(text, sizeof text, "%d", marks[i]);
        if (wedge->level) {
            canvas_fill(&p->canvas, x, y + away, 1, tick, PATTERN_WHITE);
            canvas_text_middle(&p->canvas, x, y + away + tick, 1, 1, PATTERN_WHITE, text);
        } else {
            canvas_fill(&p->canvas, x + away, y, tick, 1, PATTERN_WHITE);
            canvas_text(&p->canvas, x + away + tick + 3, y - FONT_HEIGHT / 2 + 1, 1, 1,
                        PATTERN_WHITE, text);
        }
    }
}

void pattern_wedge(const struct pattern *p, struct pattern_box box, struct pattern_wedge wedge)
{
    pattern_fill(p, box, PATTERN_WHITE);
    int x0 = pattern_x(p, box.x0), x1 = pattern_x(p, box.x1);
    int y0 = pattern_y(p, box.y0), y1 = pattern_y(p, box.y1);
    int length = wedge.level ? x1 - x0 : y1 - y0;
    int before = 0; /* whole pixels a pair, of the row of pixels before */
    for (int i = 0; i < length; i++) {
        float pair = wedge.wide - (wedge.wide - wedge.narrow) * (float)i / (float)(length - 1);
        int at = wedge.back ? length - 1 - i : i;
        int x = wedge.level ? x0 + at : (x0 + x1) / 2, y = wedge.level ? (y0 + y1) / 2 : y0 + at;
        int whole = (int)(pair + 0.01f);
        across(p, x, y, pair, &wedge);
        if (wedge.marks && whole != before)
            mark(p, x, y, &wedge, whole + (i > 0));
        if (wedge.marks && i == length - 1)
            mark(p, x, y, &wedge, whole);
        before = whole;
    }
}

/* ---- stars ------------------------------------------------------------------------------------- */

#define RAYS 18

/* The colour of a pixel, from the middle `x` and `y` as long as rows are high. */
static uint32_t ray(const struct pattern *p, float x, float y)
{
    const float sector = 3.14159265f / RAYS;
    float r = sqrtf(x * x + y * y), turned = atan2f(y, x) / sector + 0.5f;
    float whole = floorf(turned), within = turned - whole;
    float edge = (within < 0.5f ? within : 1.0f - within) * sector * r; /* rows to the next edge */
    float share = edge < 0.5f ? 0.5f + edge : 1.0f;
    return covered(p, (int)whole % 2 != 0 ? share : 1.0f - share);
}

void pattern_star(const struct pattern *p, float x, float y, float radius)
{
    const struct canvas *c = &p->canvas;
    int mx = pattern_x(p, x), my = pattern_y(p, y);
    int ry = (int)(radius * (float)p->cell_y), rx = canvas_round_dots(c, ry);
    canvas_disc(c, mx, my, rx + 3, ry + 3, PATTERN_WHITE);
    canvas_disc(c, mx, my, rx + 1, ry + 1, PATTERN_BLACK);
    for (int dy = 0; dy <= ry; dy++) {
        int half = canvas_chord(rx, ry, dy);
        for (int dx = 0; dx <= half; dx++) {
            uint32_t colour = ray(p, (float)dx / c->dots_a_row, (float)dy);
            canvas_dot(c, mx + dx, my + dy, colour);
            canvas_dot(c, mx - dx, my + dy, colour);
            canvas_dot(c, mx + dx, my - dy, colour);
            canvas_dot(c, mx - dx, my - dy, colour);
        }
    }
}
