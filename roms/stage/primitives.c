/* primitives.c — lines, areas and markers by the drivers of both heads. */
#include <math.h>

#include "roms/clip/liang_barsky.h"
#include "roms/geometry/scalar.h"
#include "roms/raster/polygon_fill.h"
#include "roms/stage/device.h"
#include "roms/stage/hatch.h"

enum { MARKER = 7 /* half of a marker's arm, stage units */ };

static const struct clip_window picture = {0, 0, STAGE_WIDTH, STAGE_HEIGHT};

/* ---- lines ----------------------------------------------------------------------------------- */

static void raster_line(struct stage *s, struct point2 a, struct point2 b)
{
    canvas_line(&s->canvas, device_dot(s, a.x), device_row(s, a.y), device_dot(s, b.x),
                device_row(s, b.y), s->ink);
}

/* The beam starts where it is when it is there already. A vector without length lights nothing: a
 * point does. */
static void vector_line(struct stage *s, struct point2 a, struct point2 b, int type)
{
    struct display *d = &s->display;
    int ax = device_head_x(s, a.x), ay = device_head_y(s, a.y);
    int bx = device_head_x(s, b.x), by = device_head_y(s, b.y);
    bool there = d->mode >= 0 && d->mode != DF_MODE_CHAR && d->x == ax && d->y == ay;
    if (s->type != type)
        display_line_type(d, (unsigned)type);
    s->type = type;
    if (ax == bx && ay == by) {
        if (!there || d->mode == DF_MODE_POINT)
            display_dot(d, ax, ay);
        return;
    }
    if (!there)
        display_at(d, ax, ay);
    display_line(d, bx, by);
}

static void solid(struct stage *s, unsigned heads, struct point2 a, struct point2 b)
{
    if (heads & STAGE_RASTER)
        raster_line(s, a, b);
    if (heads & STAGE_VECTOR)
        vector_line(s, a, b, STAGE_SOLID);
}

/* ---- broken lines ---------------------------------------------------------------------------- */

enum { DASHES = 4, LONGEST_PERIOD = 32 };
#define SHORTEST_DASH 0.01f /* what rounding leaves of one is not drawn alone */

/* Lit, dark, lit, dark; head units, as the VT11's counter makes them. */
static const float dashes[][DASHES] = {
    [STAGE_LONG_DASH] = {16, 16, 16, 16},
    [STAGE_SHORT_DASH] = {8, 8, 8, 8},
    [STAGE_DOT_DASH] = {16, 8, 2, 6},
};

/* Which dash a place of the pattern is in, and how much of it is left. */
static int dash_at(const float *dash, float phase, float *left)
{
    int i = 0;
    while (i < DASHES - 1 && phase >= dash[i])
        phase -= dash[i++];
    *left = dash[i] - phase;
    return i;
}

/* Goes on with the pattern where the line before ended, so that curves are broken evenly. */
static void broken(struct stage *s, unsigned heads, struct point2 a, struct point2 b)
{
    const float *dash = dashes[s->line_type], period = dash[0] + dash[1] + dash[2] + dash[3];
    float length = hypotf(b.x - a.x, b.y - a.y) * s->units, at = 0;
    float phase = s->dash_end.x == a.x && s->dash_end.y == a.y ? s->dash_phase : 0;
    while (at < length) {
        float left;
        bool lit = dash_at(dash, phase, &left) % 2 == 0;
        left = scalar_min(scalar_max(left, SHORTEST_DASH), length - at);
        float t0 = at / length, t1 = scalar_min((at + left) / length, 1);
        if (lit)
            solid(s, heads, (struct point2){a.x + t0 * (b.x - a.x), a.y + t0 * (b.y - a.y)},
                  (struct point2){a.x + t1 * (b.x - a.x), a.y + t1 * (b.y - a.y)});
        at += left;
        phase = phase + left < period ? phase + left : 0;
    }
    s->dash_end = b;
    s->dash_phase = phase;
}

/* A vector that is long enough is broken by the vector generator. */
static bool breaks_itself(const struct stage *s, struct point2 a, struct point2 b)
{
    float longer = scalar_max(fabsf(b.x - a.x), fabsf(b.y - a.y)) * s->units;
    return longer >= 2 * LONGEST_PERIOD;
}

void stage_line(struct stage *s, float x0, float y0, float x1, float y1)
{
    struct point2 a = {x0, y0}, b = {x1, y1};
    if (!clip_point(&picture, a) || !clip_point(&picture, b)) { /* most lines lie within */
        if (!device_sane(a) || !device_sane(b) || !clip_liang_barsky(&picture, &a, &b))
            return;
        a = device_inside(a);
        b = device_inside(b);
    }
    if (s->line_type == STAGE_SOLID) {
        solid(s, s->heads, a, b);
    } else if ((s->heads & STAGE_VECTOR) && breaks_itself(s, a, b)) {
        vector_line(s, a, b, (int)s->line_type);
        broken(s, s->heads & STAGE_RASTER, a, b);
    } else {
        broken(s, s->heads, a, b);
    }
}

void stage_polyline(struct stage *s, const struct point2 *p, int count)
{
    for (int i = 1; i < count; i++)
        stage_line(s, p[i - 1].x, p[i - 1].y, p[i].x, p[i].y);
}

void stage_polygon(struct stage *s, const struct point2 *p, int count)
{
    stage_polyline(s, p, count);
    if (count > 2)
        stage_line(s, p[count - 1].x, p[count - 1].y, p[0].x, p[0].y);
}

void stage_rectangle(struct stage *s, float x, float y, float width, float height)
{
    struct point2 corners[] = {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
    stage_polygon(s, corners, 4);
}

/* ---- areas ----------------------------------------------------------------------------------- */

/* An upright rectangle, which many areas are, has a short cut to the same pixels. */
static bool upright(const struct point2 *p, int count)
{
    return count == 4 &&
           ((p[0].x == p[3].x && p[1].x == p[2].x && p[0].y == p[1].y && p[2].y == p[3].y) ||
            (p[0].y == p[3].y && p[1].y == p[2].y && p[0].x == p[1].x && p[2].x == p[3].x));
}

static void fill_upright(const struct canvas *c, const struct point2 *p, uint32_t colour)
{
    int x0 = polygon_first(scalar_min(p[0].x, p[2].x)),
        x1 = polygon_first(scalar_max(p[0].x, p[2].x));
    int y0 = polygon_first(scalar_min(p[0].y, p[2].y)),
        y1 = polygon_first(scalar_max(p[0].y, p[2].y));
    canvas_fill(c, x0, y0, x1 - x0, y1 - y0, colour);
}

static void raster_area(struct stage *s, const struct point2 *p, int count)
{
    struct point2 q[STAGE_AREA_CORNERS];
    int left, top;
    struct canvas c = stage_picture(s, &left, &top);
    for (int i = 0; i < count; i++) {
        if (!device_sane(p[i]))
            return;
        q[i].x = stage_canvas_x(s, p[i].x) - (float)left;
        q[i].y = stage_canvas_y(s, p[i].y) - (float)top;
    }
    if (upright(q, count))
        fill_upright(&c, q, s->ink);
    else
        canvas_polygon(&c, q, count, POLYGON_EVEN_ODD, s->ink);
}

void stage_area(struct stage *s, const struct point2 *p, int count)
{
    unsigned heads = s->heads;
    enum stage_line_type type = s->line_type;
    bool fits = count <= STAGE_AREA_CORNERS;
    if (fits && (heads & STAGE_RASTER))
        raster_area(s, p, count);
    stage_heads(s, fits ? heads & STAGE_VECTOR : heads);
    stage_line_type(s, STAGE_SOLID);
    stage_polygon(s, p, count);
    if (fits && s->hatch_apart > 0 && s->heads != 0)
        hatch_area(s, p, count);
    stage_line_type(s, type);
    stage_heads(s, heads);
}

/* ---- markers --------------------------------------------------------------------------------- */

void stage_marker(struct stage *s, float x, float y)
{
    enum stage_line_type type = s->line_type;
    stage_line_type(s, STAGE_SOLID);
    stage_line(s, x - MARKER, y, x + MARKER, y);
    stage_line(s, x, y - MARKER, x, y + MARKER);
    stage_line_type(s, type);
}

void stage_dot(struct stage *s, float x, float y)
{
    if (!clip_point(&picture, (struct point2){x, y}))
        return;
    if (s->heads & STAGE_RASTER)
        canvas_dot(&s->canvas, device_dot(s, x), device_row(s, y), s->ink);
    if (s->heads & STAGE_VECTOR)
        display_dot(&s->display, device_head_x(s, x), device_head_y(s, y));
}
