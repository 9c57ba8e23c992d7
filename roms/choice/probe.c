/* probe.c — a probe whose parts are switched: they unfold, glow, send. */
#include <math.h>
#include <stdio.h>

#include "roms/choice/choice.h"
#include "roms/geometry/scalar.h"

enum { CELLS = 5, RAYS = 12, POWER_FOR_ENGINE = 60 /* percent */ };

const struct choose_item probe_items[PARTS] = {
    [PART_PANELS] = {"Sun panels", 'A'}, [PART_ANTENNA] = {"Antenna", 'B'},
    [PART_CAMERA] = {"Camera", 'C'},     [PART_BEACON] = {"Beacon", 'D'},
    [PART_ENGINE] = {"Engine", 'E'},     [PART_LIGHTS] = {"Lights", 'F'},
};

static const struct point2 sun = {VIEW_RIGHT - 70, VIEW_TOP - 70};
static const struct point2 middle = {(VIEW_LEFT + VIEW_RIGHT) / 2 - 10, 410};

void probe_begin(struct probe *p)
{
    *p = (struct probe){.on = 1u << PART_LIGHTS, .attitude = 20};
    p->slider = (struct slider){.label = "Attitude",
                                .left = SIDE_LEFT,
                                .bottom = 318,
                                .width = SIDE_WIDTH,
                                .low = -180,
                                .high = 180,
                                .value = 20};
}

/* Panels give most when light falls on them straight. */
float probe_power(const struct probe *p)
{
    float toward_sun = atan2f(sun.y - middle.y, sun.x - middle.x);
    float straight = fabsf(sinf(toward_sun - p->attitude * DEGREE));
    return 0.25f + 0.75f * p->out[PART_PANELS] * straight;
}

uint32_t probe_disabled(const struct probe *p)
{
    return 100 * probe_power(p) < POWER_FOR_ENGINE ? 1u << PART_ENGINE : 0;
}

void probe_item(struct probe *p, int item)
{
    p->on ^= 1u << item;
}

void probe_step(struct probe *p, float seconds)
{
    p->seconds += seconds;
    p->on &= ~probe_disabled(p); /* without power it stops */
    p->attitude += (p->slider.value - p->attitude) * scalar_min(3 * seconds, 1);
    for (int i = 0; i < PARTS; i++) {
        float to = p->on >> i & 1 ? 1.0f : 0.0f, most = seconds / (i == PART_ENGINE ? 0.2f : 1.2f);
        p->out[i] += scalar_clamp(to - p->out[i], -most, most);
    }
}

/* ---- drawing ------------------------------------------------------------------------------------ */

struct pencil {
    struct stage *s;
    float cosine, sine;
};

/* From the probe's own axes. */
static struct point2 place(const struct pencil *d, float x, float y)
{
    return (struct point2){middle.x + x * d->cosine - y * d->sine,
                           middle.y + x * d->sine + y * d->cosine};
}

static void line(const struct pencil *d, float x0, float y0, float x1, float y1)
{
    struct point2 a = place(d, x0, y0), b = place(d, x1, y1);
    stage_line(d->s, a.x, a.y, b.x, b.y);
}

/* Filled with a shade on the raster head, with an outline on both. */
static void shape(const struct pencil *d, const struct point2 *p, int count, enum ink fill,
                  enum ink edge)
{
    struct point2 q[16];
    for (int i = 0; i < count; i++)
        q[i] = place(d, p[i].x, p[i].y);
    stage_heads(d->s, STAGE_RASTER);
    stage_ink(d->s, fill);
    stage_area(d->s, q, count);
    stage_heads(d->s, STAGE_BOTH);
    stage_ink(d->s, edge);
    stage_polygon(d->s, q, count);
}

static void box(const struct pencil *d, float x, float y, float width, float height, enum ink fill,
                enum ink edge)
{
    const struct point2 p[] = {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
    shape(d, p, 4, fill, edge);
}

static enum ink shade(enum ink_ramp ramp, float level)
{
    return (enum ink)ink_shade(ramp, level);
}

/* Cells slide out, one behind the other; they shine as much as they give. */
static void panels(const struct pencil *d, const struct probe *p)
{
    float width = 46 * p->out[PART_PANELS], light = probe_power(p);
    if (width < 2)
        return;
    for (int side = -1; side <= 1; side += 2) {
        float from = (float)side * 72;
        stage_ink(d->s, INK_TEXT);
        line(d, (float)side * 60, 0, from, 0);
        for (int i = 0; i < CELLS; i++) {
            float x = from + (float)side * width * (float)i;
            box(d, side > 0 ? x : x - width, -44, width, 88,
                shade(RAMP_BLUE, 0.15f + 0.45f * light), INK_CYAN);
        }
        stage_ink(d->s, INK_CYAN);
        line(d, from, 0, from + (float)side * width * CELLS, 0);
    }
}

static void antenna(const struct pencil *d, const struct probe *p)
{
    enum { POINTS = 9 };
    struct point2 dish[POINTS];
    float out = p->out[PART_ANTENNA], foot = 70 + 46 * out;
    stage_ink(d->s, INK_TEXT);
    line(d, 0, 70, 0, foot);
    for (int i = 0; i < POINTS; i++) {
        float x = (float)(i - POINTS / 2) / (POINTS / 2), half = 16 + 62 * out;
        dish[i] = (struct point2){x * half, foot + x * x * (50 - 12 * out)};
    }
    shape(d, dish, POINTS, shade(RAMP_GREY, 0.5f), INK_BRIGHT);
    stage_ink(d->s, INK_TEXT);
    line(d, 0, foot, 0, foot + 50 * out);
    line(d, -30 * out, foot + 12 * out, 0, foot + 50 * out);
    line(d, 30 * out, foot + 12 * out, 0, foot + 50 * out);
}

/* Waves that go out from the beacon. */
static void waves(const struct pencil *d, const struct probe *p, float x, float y)
{
    enum { ARCS = 3, POINTS = 14 };
    for (int k = 0; k < ARCS; k++) {
        struct point2 arc[POINTS];
        float grown = p->seconds * 0.6f + (float)k / ARCS, r = 14 + 100 * (grown - floorf(grown));
        for (int i = 0; i < POINTS; i++) {
            float angle = (0.05f + 0.4f * (float)i / (POINTS - 1)) * PI;
            arc[i] = place(d, x + r * cosf(angle), y + r * sinf(angle));
        }
        stage_ink(d->s, r < 55 ? INK_RED : INK_BROWN);
        stage_polyline(d->s, arc, POINTS);
    }
}

static void beacon(const struct pencil *d, const struct probe *p)
{
    bool lit = (p->on >> PART_BEACON & 1) && fmodf(p->seconds, 0.8f) < 0.4f;
    stage_ink(d->s, INK_TEXT);
    line(d, 40, 60, 56, 84);
    box(d, 50, 84, 13, 13, lit ? INK_RED : shade(RAMP_COPPER, 0.1f), lit ? INK_RED : INK_BROWN);
    if (p->on >> PART_BEACON & 1)
        waves(d, p, 56, 90);
}

static void camera(const struct pencil *d, const struct probe *p)
{
    float out = p->out[PART_CAMERA];
    box(d, -46, -88 - 22 * out, 30, 24 + 22 * out, shade(RAMP_GREY, 0.25f), INK_TEXT);
    if (out < 0.9f)
        return;
    stage_ink(d->s, INK_GREEN);
    stage_line_type(d->s, STAGE_SHORT_DASH);
    line(d, -31, -112, -150, -300);
    line(d, -31, -112, 60, -310);
    stage_line_type(d->s, STAGE_SOLID);
}

static void engine(const struct pencil *d, const struct probe *p)
{
    const struct point2 nozzle[] = {{8, -70}, {40, -70}, {50, -104}, {-2, -104}};
    shape(d, nozzle, 4, shade(RAMP_GREY, 0.2f), INK_TEXT);
    if (p->out[PART_ENGINE] < 0.1f)
        return;
    float flicker = 1 + 0.18f * sinf(p->seconds * 43) + 0.1f * sinf(p->seconds * 71);
    float length = 130 * p->out[PART_ENGINE] * flicker;
    const struct point2 outer[] = {{2, -108}, {46, -108}, {24, -108 - length}};
    const struct point2 inner[] = {{12, -108}, {36, -108}, {24, -108 - 0.55f * length}};
    shape(d, outer, 3, INK_ORANGE, INK_ORANGE);
    shape(d, inner, 3, INK_YELLOW, INK_BRIGHT);
}

static void body(const struct pencil *d, const struct probe *p)
{
    const struct point2 hull[] = {{-60, -40}, {-40, -70}, {44, -70}, {60, -40},
                                  {60, 42},   {42, 70},   {-42, 70}, {-60, 42}};
    bool lit = p->on >> PART_LIGHTS & 1;
    shape(d, hull, 8, shade(RAMP_GREY, 0.16f), INK_BRIGHT);
    for (int i = 0; i < 3; i++)
        box(d, -44 + 31 * (float)i, 12, 24, 28, lit ? INK_YELLOW : shade(RAMP_GREY, 0.05f),
            lit ? INK_YELLOW : INK_GRID);
    stage_ink(d->s, INK_GRID);
    line(d, -60, -10, 60, -10);
}

/* ---- what is around it ---------------------------------------------------------------------------- */

static void sky(struct stage *s)
{
    uint32_t seed = 77;
    stage_ink(s, INK_TEXT);
    for (int i = 0; i < 40; i++) {
        seed = seed * 1664525u + 1013904223u;
        float x = VIEW_LEFT + (float)(seed >> 16 & 0x3FF) * (VIEW_RIGHT - VIEW_LEFT) / 1024.0f;
        seed = seed * 1664525u + 1013904223u;
        stage_dot(s, x, 220 + (float)(seed >> 16 & 0x3FF) * (VIEW_TOP - 220) / 1024.0f);
    }
    stage_ink(s, INK_YELLOW);
    for (int i = 0; i < RAYS; i++) {
        float angle = TURN * (float)i / RAYS, c = cosf(angle), n = sinf(angle);
        stage_line(s, sun.x + 32 * c, sun.y + 32 * n, sun.x + 52 * c, sun.y + 52 * n);
        stage_line(s, sun.x + 24 * c, sun.y + 24 * n, sun.x + 24 * cosf(angle + TURN / RAYS),
                   sun.y + 24 * sinf(angle + TURN / RAYS));
    }
}

static void horizon(struct stage *s)
{
    enum { POINTS = 33 };
    struct point2 p[POINTS + 2];
    for (int i = 0; i < POINTS; i++) {
        float x = VIEW_LEFT + (VIEW_RIGHT - VIEW_LEFT) * (float)i / (POINTS - 1),
              t = (x - 760) / 420;
        p[i] = (struct point2){x, 178 - 66 * t * t};
    }
    p[POINTS] = (struct point2){VIEW_RIGHT, VIEW_BOTTOM};
    p[POINTS + 1] = (struct point2){VIEW_LEFT, VIEW_BOTTOM};
    stage_heads(s, STAGE_RASTER);
    stage_ink(s, shade(RAMP_BLUE, 0.3f));
    stage_area(s, p, POINTS + 2);
    stage_heads(s, STAGE_BOTH);
    stage_ink(s, INK_CYAN);
    stage_polyline(s, p, POINTS);
}

static void gauge(const struct probe *p, struct stage *s)
{
    enum { LEFT = SIDE_LEFT, BOTTOM = 216, HEIGHT = 26 };
    char text[16];
    float power = probe_power(p);
    bool enough = probe_disabled(p) == 0;
    const struct point2 bar[] = {{LEFT, BOTTOM},
                                 {LEFT + SIDE_WIDTH * power, BOTTOM},
                                 {LEFT + SIDE_WIDTH * power, BOTTOM + HEIGHT},
                                 {LEFT, BOTTOM + HEIGHT}};
    stage_ink(s, INK_TEXT);
    stage_text(s, LEFT, BOTTOM + 36, "Power");
    snprintf(text, sizeof text, "%3d %%", scalar_nearest(100 * power));
    stage_text(s, LEFT + SIDE_WIDTH - 5 * STAGE_CHARACTER, BOTTOM + 36, text);
    stage_ink(s, enough ? INK_GREEN : INK_RED);
    stage_area(s, bar, 4);
    stage_ink(s, INK_GRID);
    stage_rectangle(s, LEFT, BOTTOM, SIDE_WIDTH, HEIGHT);
    float x = LEFT + SIDE_WIDTH * (POWER_FOR_ENGINE / 100.0f);
    stage_line(s, x, BOTTOM - 8, x, BOTTOM + HEIGHT + 8);
    stage_ink(s, enough ? INK_GREEN : INK_RED);
    stage_text(s, LEFT, BOTTOM - 34, enough ? "engine: ready" : "engine: no power");
}

void probe_draw(const struct probe *p, struct stage *s, bool marked)
{
    char text[16];
    struct pencil d = {s, cosf(p->attitude * DEGREE), sinf(p->attitude * DEGREE)};
    sky(s);
    horizon(s);
    panels(&d, p);
    antenna(&d, p);
    camera(&d, p);
    engine(&d, p);
    beacon(&d, p);
    body(&d, p);
    gauge(p, s);
    snprintf(text, sizeof text, "%d deg", scalar_nearest(p->slider.value));
    slider_draw(&p->slider, s, marked, text);
}
