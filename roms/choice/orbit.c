/* orbit.c — a satellite's orbit by Kepler's laws, as the sliders say. */
#include <math.h>
#include <stdio.h>

#include "roms/choice/choice.h"
#include "roms/geometry/scalar.h"

enum { PERIGEE, APOGEE, TURN_ROUND };
enum { CIRCLE, TRANSFER, LONG, RETROGRADE, AREAS, FAST };
enum { STEPS = 72, SECTORS = 12, TRAIL = 10 };
#define PLANET_KM  6371.0f   /* mean radius of the Earth, IUGG */
#define PLANET_MU  398600.0f /* km^3/s^2, WGS 84, rounded */
#define SHOWN_RATE 1.2f      /* radians a second at radius 1: an orbit near the planet takes 6 s */

const struct choose_item orbit_items[] = {
    {"Circle", 'A'},    {"Transfer", 'B'},    {"Long ellipse", 'C'},
    {"Backwards", 'D'}, {"Equal areas", 'E'}, {"Fast", 'F'},
};
const int orbit_count = sizeof orbit_items / sizeof *orbit_items;

void orbit_begin(struct orbit *o)
{
    static const struct slider sliders[] = {
        {.label = "Perigee", .low = 1.05f, .high = 4, .value = 1.4f},
        {.label = "Apogee", .low = 1.05f, .high = 7, .value = 3},
        {.label = "Turned", .low = 0, .high = 360, .value = 25},
    };
    *o = (struct orbit){.perigee = 1.4f, .apogee = 1.4f, .areas = true};
    for (int i = 0; i < 3; i++) {
        o->slider[i] = sliders[i];
        o->slider[i].left = SIDE_LEFT;
        o->slider[i].width = SIDE_WIDTH;
        o->slider[i].bottom = 318 - (float)(SLIDER_HEIGHT + 8) * (float)i;
    }
}

static void want(struct orbit *o, float perigee, float apogee, float turn)
{
    slider_set(&o->slider[PERIGEE], perigee);
    slider_set(&o->slider[APOGEE], apogee);
    slider_set(&o->slider[TURN_ROUND], turn);
}

void orbit_item(struct orbit *o, int item)
{
    float perigee = o->slider[PERIGEE].value, turn = o->slider[TURN_ROUND].value;
    if (item == CIRCLE)
        want(o, perigee, perigee, turn);
    else if (item == TRANSFER)
        want(o, 1.1f, 3.4f, turn);
    else if (item == LONG)
        want(o, 1.1f, 7, 60);
    else if (item == RETROGRADE)
        o->retrograde = !o->retrograde;
    else if (item == AREAS)
        o->areas = !o->areas;
    else if (item == FAST)
        o->fast = !o->fast;
}

uint32_t orbit_lamps(const struct orbit *o)
{
    return (uint32_t)o->retrograde << RETROGRADE | (uint32_t)o->areas << AREAS |
           (uint32_t)o->fast << FAST;
}

static float toward(float value, float wanted, float seconds)
{
    return value + (wanted - value) * scalar_min(4 * seconds, 1);
}

static float half_axis(const struct orbit *o)
{
    return (o->perigee + scalar_max(o->apogee, o->perigee)) / 2;
}

void orbit_step(struct orbit *o, float seconds)
{
    float a = half_axis(o), rate = SHOWN_RATE / (a * sqrtf(a)) * (o->fast ? 3 : 1);
    o->perigee = toward(o->perigee, o->slider[PERIGEE].value, seconds);
    o->apogee = toward(o->apogee, o->slider[APOGEE].value, seconds);
    o->turn = toward(o->turn, o->slider[TURN_ROUND].value, seconds);
    o->mean = fmodf(o->mean + (o->retrograde ? -rate : rate) * seconds + TURN, TURN);
}

/* ---- geometry ---------------------------------------------------------------------------------- */

struct view {
    float a, b, e, scale; /* half axes, eccentricity; stage units a radius */
    float cosine, sine;
    struct point2 middle, planet;
};

static struct point2 turned(const struct view *v, float x, float y)
{
    return (struct point2){v->middle.x + v->scale * (x * v->cosine - y * v->sine),
                           v->middle.y + v->scale * (x * v->sine + y * v->cosine)};
}

/* The ellipse is in the middle, whichever way it is turned. */
static struct view view_of(const struct orbit *o)
{
    struct view v = {.a = half_axis(o),
                     .middle = {(VIEW_LEFT + VIEW_RIGHT) / 2 + 75, (VIEW_BOTTOM + VIEW_TOP) / 2}};
    v.e = 1 - scalar_min(o->perigee, v.a) / v.a;
    v.b = v.a * sqrtf(1 - v.e * v.e);
    v.scale = 278 / scalar_max(v.a, 1.5f);
    v.cosine = cosf(o->turn * DEGREE);
    v.sine = sinf(o->turn * DEGREE);
    v.planet = turned(&v, v.a * v.e, 0);
    return v;
}

/* Kepler's equation, E - e sin E = M, by Newton's method. */
static struct point2 at_mean(const struct view *v, float mean)
{
    float eccentric = mean + v->e * sinf(mean);
    for (int i = 0; i < 6; i++)
        eccentric -= (eccentric - v->e * sinf(eccentric) - mean) / (1 - v->e * cosf(eccentric));
    return turned(v, v->a * cosf(eccentric), v->b * sinf(eccentric));
}

/* ---- drawing ------------------------------------------------------------------------------------ */

static void ellipse(struct stage *s, struct point2 middle, float rx, float ry)
{
    struct point2 p[STEPS / 2];
    for (int i = 0; i < STEPS / 2; i++) {
        float angle = TURN * (float)i / (STEPS / 2);
        p[i] = (struct point2){middle.x + rx * cosf(angle), middle.y + ry * sinf(angle)};
    }
    stage_polygon(s, p, STEPS / 2);
}

static void planet(const struct view *v, struct stage *s)
{
    struct point2 p[STEPS];
    float r = v->scale;
    for (int i = 0; i < STEPS; i++) {
        float angle = TURN * (float)i / STEPS;
        p[i] = (struct point2){v->planet.x + r * cosf(angle), v->planet.y + r * sinf(angle)};
    }
    stage_heads(s, STAGE_RASTER);
    stage_ink(s, (enum ink)ink_shade(RAMP_BLUE, 0.35f));
    stage_area(s, p, STEPS);
    stage_heads(s, STAGE_BOTH);
    stage_ink(s, INK_BLUE);
    stage_polygon(s, p, STEPS);
    stage_ink(s, INK_CYAN);
    ellipse(s, v->planet, 0.4f * r, r);
    ellipse(s, v->planet, 0.8f * r, r);
    for (int i = -1; i <= 1; i++) {
        float y = 0.45f * (float)i * r, x = sqrtf(r * r - y * y);
        stage_line(s, v->planet.x - x, v->planet.y + y, v->planet.x + x, v->planet.y + y);
    }
}

/* Equal times sweep equal areas. */
static void sectors(const struct view *v, struct stage *s)
{
    stage_ink(s, INK_GRID);
    for (int i = 0; i < SECTORS; i++) {
        struct point2 p = at_mean(v, TURN * (float)i / SECTORS);
        float dx = p.x - v->planet.x, dy = p.y - v->planet.y, r = v->scale / hypotf(dx, dy);
        stage_line(s, v->planet.x + r * dx, v->planet.y + r * dy, p.x, p.y);
    }
}

static void path(const struct view *v, struct stage *s)
{
    struct point2 p[STEPS];
    for (int i = 0; i < STEPS; i++) {
        float angle = TURN * (float)i / STEPS;
        p[i] = turned(v, v->a * cosf(angle), v->b * sinf(angle));
    }
    stage_ink(s, INK_ORANGE);
    stage_polygon(s, p, STEPS);
}

/* A body with two panels, across the line to the planet. */
static void satellite(const struct view *v, struct stage *s, struct point2 at)
{
    float dx = at.x - v->planet.x, dy = at.y - v->planet.y, r = hypotf(dx, dy);
    float ux = r > 0 ? dx / r : 1, uy = r > 0 ? dy / r : 0;
    for (int k = -1; k <= 1; k++) {
        float half = k == 0 ? 9 : 13, thick = k == 0 ? 9 : 5;
        float cx = at.x - uy * 26 * (float)k, cy = at.y + ux * 26 * (float)k;
        const struct point2 p[] = {{cx - uy * half - ux * thick, cy + ux * half - uy * thick},
                                   {cx + uy * half - ux * thick, cy - ux * half - uy * thick},
                                   {cx + uy * half + ux * thick, cy - ux * half + uy * thick},
                                   {cx - uy * half + ux * thick, cy + ux * half + uy * thick}};
        stage_ink(s, k == 0 ? INK_BRIGHT : INK_YELLOW);
        stage_area(s, p, 4);
    }
}

static void trail(const struct orbit *o, const struct view *v, struct stage *s)
{
    float step = o->retrograde ? -0.05f : 0.05f;
    stage_ink(s, INK_YELLOW);
    for (int i = 1; i <= TRAIL; i++) {
        struct point2 p = at_mean(v, o->mean - step * (float)(i + 1));
        stage_dot(s, p.x, p.y);
    }
}

static void figures(const struct view *v, struct stage *s, struct point2 at)
{
    char text[48];
    float r = hypotf(at.x - v->planet.x, at.y - v->planet.y) / v->scale * PLANET_KM;
    float a = v->a * PLANET_KM, minutes = TURN * sqrtf(a / PLANET_MU) * a / 60;
    int speed = scalar_nearest(10 * sqrtf(PLANET_MU * (2 / r - 1 / a)));
    stage_ink(s, INK_TEXT);
    snprintf(text, sizeof text, "height %6d km", scalar_nearest(r - PLANET_KM));
    stage_text(s, VIEW_LEFT + 10, VIEW_TOP - 26, text);
    snprintf(text, sizeof text, "speed  %4d.%d km/s", speed / 10, speed % 10);
    stage_text(s, VIEW_LEFT + 10, VIEW_TOP - 26 - STAGE_TEXT_LINE, text);
    snprintf(text, sizeof text, "period %6d min", scalar_nearest(minutes));
    stage_text(s, VIEW_LEFT + 10, VIEW_TOP - 26 - 2 * STAGE_TEXT_LINE, text);
}

static void sliders(const struct orbit *o, struct stage *s, int marked)
{
    char text[16];
    for (int i = 0; i < 3; i++) {
        float value = o->slider[i].value;
        if (i == TURN_ROUND)
            snprintf(text, sizeof text, "%d deg", scalar_nearest(value));
        else
            snprintf(text, sizeof text, "%d km", scalar_nearest((value - 1) * PLANET_KM));
        slider_draw(&o->slider[i], s, i == marked, text);
    }
}

void orbit_draw(const struct orbit *o, struct stage *s, int marked)
{
    struct view v = view_of(o);
    struct point2 at = at_mean(&v, o->mean);
    if (o->areas)
        sectors(&v, s);
    planet(&v, s);
    path(&v, s);
    trail(o, &v, s);
    satellite(&v, s, at);
    figures(&v, s, at);
    sliders(o, s, marked);
}
