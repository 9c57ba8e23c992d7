/* areas_lines.c — attributes of lines: width, caps, joins, dashes, antialiasing. */
#include <math.h>

#include "roms/geometry/scalar.h"
#include "roms/lessons/areas.h"
#include "roms/raster/line_antialiased.h"
#include "roms/raster/line_dashed.h"
#include "roms/raster/line_thick.h"

enum { POINTS = 4 };

static struct point2 on_canvas(const struct stage *s, struct point2 p)
{
    return (struct point2){stage_canvas_x(s, p.x), stage_canvas_y(s, p.y)};
}

/* Filled on the raster head; on the other one the outlines of its pieces. */
static void thick(struct stage *s, const struct point2 *p, const struct line_style *style,
                  enum ink ink)
{
    struct point2 q[POINTS];
    struct line_style dots = *style;
    struct line_thick line;
    struct thick_piece piece;
    for (int i = 0; i < POINTS; i++)
        q[i] = on_canvas(s, p[i]);
    dots.width *= s->dots;
    canvas_line_thick(&s->canvas, q, POINTS, false, &dots, ink);
    stage_heads(s, STAGE_VECTOR);
    stage_ink(s, ink);
    line_thick_begin(&line, p, POINTS, false, style);
    while (line_thick_next(&line, &piece))
        stage_polygon(s, piece.corner, piece.count);
    stage_heads(s, STAGE_BOTH);
    stage_ink(s, INK_BRIGHT);
    stage_polyline(s, p, POINTS);
}

/* A pattern that moves begins behind a line of that length. */
static struct dash_phase moved(const struct dash_pattern *k, int length)
{
    struct dash_phase phase = {0};
    struct line_dashed line;
    int x, y;
    bool on;
    line_dashed_begin(&line, 0, 0, length, 0, k, &phase);
    while (line_dashed_next(&line, &x, &y, &on))
        ;
    return phase;
}

/* The vector head's: a line for each dash; stage units. */
static void vector_dashes(struct stage *s, struct point2 a, struct point2 b,
                          const struct dash_pattern *k, struct dash_phase *phase)
{
    struct line_dashed line;
    int x, y, x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    bool on, before = false;
    line_dashed_begin(&line, (int)a.x, (int)a.y, (int)b.x, (int)b.y, k, phase);
    while (line_dashed_next(&line, &x, &y, &on)) {
        if (on && !before)
            x0 = x, y0 = y;
        if (!on && before)
            stage_line(s, (float)x0, (float)y0, (float)x1, (float)y1);
        before = on;
        x1 = x, y1 = y;
    }
    if (before)
        stage_line(s, (float)x0, (float)y0, (float)x1, (float)y1);
}

static void dashed(struct stage *s, const struct point2 *p, int count, const struct dash_pattern *k,
                   float moving, enum ink ink)
{
    struct dash_pattern wide = *k; /* in stage units */
    for (int i = 0; i < k->count; i++)
        wide.length[i] = (uint8_t)(2 * k->length[i]);
    struct dash_phase raster = moved(k, (int)moving), vector = moved(&wide, (int)(2 * moving));
    stage_heads(s, STAGE_VECTOR);
    stage_ink(s, ink);
    for (int i = 1; i < count; i++) {
        struct point2 a = on_canvas(s, p[i - 1]), b = on_canvas(s, p[i]);
        canvas_line_dashed(&s->canvas, (int)a.x, (int)a.y, (int)b.x, (int)b.y, k, &raster, ink);
        vector_dashes(s, p[i - 1], p[i], &wide, &vector);
    }
    stage_heads(s, STAGE_BOTH);
}

static void spokes(struct stage *s, float x, float y, float r, float turn, bool smooth)
{
    enum { SPOKES = 12 };
    uint32_t ramp[INK_LEVELS];
    for (int i = 0; i < INK_LEVELS; i++)
        ramp[i] = ink_shade(RAMP_GREY, (float)i / (INK_LEVELS - 1));
    stage_ink(s, INK_BRIGHT);
    for (int i = 0; i < SPOKES; i++) {
        float angle = turn + TURN * (float)i / SPOKES;
        struct point2 a = {x + 30 * cosf(angle), y + 30 * sinf(angle)};
        struct point2 b = {x + r * cosf(angle), y + r * sinf(angle)};
        if (smooth) {
            struct point2 p = on_canvas(s, a), q = on_canvas(s, b);
            canvas_line_antialiased(&s->canvas, p.x, p.y, q.x, q.y, ramp, INK_LEVELS);
        }
        stage_heads(s, smooth ? STAGE_VECTOR : STAGE_BOTH);
        stage_line(s, a.x, a.y, b.x, b.y);
        stage_heads(s, STAGE_BOTH);
    }
}

static void styles(struct stage *s, float seconds)
{
    static const char *const names[] = {"butt, bevel", "square, miter", "round, round"};
    static const enum ink inks[] = {INK_BLUE, INK_ORANGE, INK_GREEN};
    float width = 52 + 18 * sinf(seconds * 0.9f), bend = 60 * sinf(seconds * 0.5f);
    for (int i = 0; i < 3; i++) {
        float left = 75 + (float)i * 400;
        struct point2 p[POINTS] = {
            {left, 490}, {left + 60, 660}, {left + 160 + bend, 510}, {left + 260, 660}};
        struct line_style style = {width, (enum line_cap)i, (enum line_join)i};
        thick(s, p, &style, inks[i]);
        stage_ink(s, INK_TEXT);
        stage_text_middle(s, left + 130, 400, names[i]);
    }
}

void areas_attributes(struct stage *s, float seconds)
{
    static const struct dash_pattern patterns[] = {{{12, 6}, 2}, {{14, 4, 2, 4}, 4}, {{2, 5}, 2}};
    static const struct point2 corner[3] = {{0, 300}, {260, 300}, {330, 60}};
    styles(s, seconds);
    for (int i = 0; i < 3; i++) {
        struct point2 p[3];
        for (int k = 0; k < 3; k++)
            p[k] = (struct point2){75 + corner[k].x, corner[k].y - (float)(i * 60)};
        p[2].y = 60;
        p[1].x -= (float)(i * 40), p[2].x -= (float)(i * 50);
        dashed(s, p, 3, &patterns[i], fmodf(seconds * 12, 120), INK_YELLOW);
    }
    spokes(s, 610, 200, 150, seconds * 0.05f, false);
    spokes(s, 1000, 200, 150, seconds * 0.05f, true);
    stage_ink(s, INK_TEXT);
    stage_text_middle(s, 205, 10, "dashes");
    stage_text_middle(s, 610, 10, "Bresenham");
    stage_text_middle(s, 1000, 10, "antialiased");
}
