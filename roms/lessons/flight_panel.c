#include "roms/lessons/flight_panel.h"

#include <math.h>
#include <stdio.h>

#include "roms/geometry/scalar.h"
#include "roms/lessons/flight_view.h"
#include "roms/raster/polygon_fill.h"

enum { RADIUS = 82, MIDDLE = 136, NAME = 8, SIDES = 24 };

/* Clockwise from the top. */
static struct point2 on_dial(float x, float radius, float turn)
{
    float angle = TURN * turn;
    return (struct point2){x + radius * sinf(angle), MIDDLE + radius * cosf(angle)};
}

/* The corners of a circle, each turned on from the last. */
static void rim(struct point2 out[SIDES], float x, float radius)
{
    const float sine = 0.25881905f, cosine = 0.96592583f; /* of 15 degrees */
    float across = 0, up = radius;
    for (int i = 0; i < SIDES; i++) {
        out[i] = (struct point2){x + across, MIDDLE + up};
        float next = across * cosine + up * sine;
        up = up * cosine - across * sine;
        across = next;
    }
}

static void fill(struct stage *s, const struct point2 *p, int count, uint32_t colour)
{
    struct point2 at[SIDES + 2];
    for (int i = 0; i < count; i++)
        at[i] = (struct point2){stage_canvas_x(s, p[i].x), stage_canvas_y(s, p[i].y)};
    canvas_polygon(&s->canvas, at, count, POLYGON_EVEN_ODD, colour);
}

static void disc(struct stage *s, float x, int radius, uint32_t colour)
{
    int rows = (int)((float)radius * s->dots);
    canvas_disc(&s->canvas, (int)stage_canvas_x(s, x), (int)stage_canvas_y(s, MIDDLE),
                canvas_round_dots(&s->canvas, rows), rows, colour);
}

/* A round face with its name below. */
static void face(struct stage *s, float x, const char *name)
{
    struct point2 p[SIDES];
    rim(p, x, RADIUS);
    disc(s, x, RADIUS, INK_TEXT);
    disc(s, x, RADIUS - 4, INK_BLACK);
    stage_heads(s, STAGE_VECTOR);
    stage_ink(s, INK_TEXT);
    stage_polygon(s, p, SIDES);
    stage_heads(s, STAGE_BOTH);
    stage_text_middle(s, x, NAME, name);
}

/* `turn`: where the needle stands, of a whole turn clockwise from the top. */
static void dial(struct stage *s, float x, const char *name, int marks, float turn)
{
    face(s, x, name);
    stage_ink(s, INK_TEXT);
    for (int i = 0; i < marks; i++) {
        struct point2 a = on_dial(x, RADIUS, (float)i / (float)marks);
        struct point2 b = on_dial(x, RADIUS - 14, (float)i / (float)marks);
        stage_line(s, a.x, a.y, b.x, b.y);
    }
    struct point2 tip = on_dial(x, RADIUS - 18, turn);
    const struct point2 needle[3] = {tip, on_dial(x, 7, turn + 0.25f), on_dial(x, 7, turn - 0.25f)};
    fill(s, needle, 3, INK_BRIGHT);
    stage_ink(s, INK_BRIGHT);
    stage_line(s, x, MIDDLE, tip.x, tip.y);
}

/* Sky and ground behind a fixed aircraft. */
static void attitude(struct stage *s, float x, const struct flight *f)
{
    struct point2 p[SIDES], part[SIDES + 2];
    float up = cosf(f->bank), right = -sinf(f->bank); /* the sky's direction on the dial */
    float pitch = f->pitch > 0.5f ? 0.5f : f->pitch < -0.5f ? -0.5f : f->pitch;
    float level = right * x + up * MIDDLE - pitch * 150;
    face(s, x, "attitude");
    rim(p, x, RADIUS - 4);
    disc(s, x, RADIUS - 4, ink_shade(RAMP_COPPER, 0.25f));
    int count = flight_half_plane(p, SIDES, right, up, level, part);
    fill(s, part, count, ink_shade(RAMP_BLUE, 0.5f));
    float away = -pitch * 150, half = sqrtf(fmaxf(RADIUS * RADIUS - away * away, 0)) - 3;
    struct point2 middle = {x + right * away, MIDDLE + up * away};
    stage_ink(s, INK_BRIGHT);
    stage_line(s, middle.x - up * half, middle.y + right * half, middle.x + up * half,
               middle.y - right * half);
    stage_ink(s, INK_YELLOW);
    stage_line(s, x - 50, MIDDLE, x - 16, MIDDLE);
    stage_line(s, x + 16, MIDDLE, x + 50, MIDDLE);
    stage_line(s, x - 16, MIDDLE, x, MIDDLE - 14);
    stage_line(s, x, MIDDLE - 14, x + 16, MIDDLE);
}

static void throttle(struct stage *s, float x, const struct flight *f)
{
    enum { WIDTH = 34, LOW = 54, HIGH = 218 };
    float top = LOW + (HIGH - LOW) * f->stick.throttle;
    const struct point2 bar[4] = {{x, LOW}, {x + WIDTH, LOW}, {x + WIDTH, top}, {x, top}};
    fill(s, bar, 4, ink_shade(RAMP_GREEN, 0.5f));
    stage_ink(s, INK_TEXT);
    stage_rectangle(s, x, LOW, WIDTH, HIGH - LOW);
    stage_line(s, x, top, x + WIDTH, top);
    stage_text_middle(s, x + WIDTH / 2, NAME, "power");
    if (f->stick.brakes) {
        stage_ink(s, INK_RED);
        stage_text_middle(s, x + WIDTH / 2, 226, "BRAKES");
    }
}

void flight_panel(struct stage *s, const struct flight *f)
{
    char text[24];
    float degrees = f->heading / DEGREE, climb = flight_climb_rate(f);
    degrees = degrees < -0.5f ? degrees + 360 : fmaxf(degrees, 0);
    int left = (int)stage_canvas_x(s, 0), top = (int)stage_canvas_y(s, SCREEN_BOTTOM - 4);
    canvas_fill(&s->canvas, left, top, (int)stage_canvas_x(s, STAGE_WIDTH) - left,
                (int)stage_canvas_y(s, 0) - top, ink_shade(RAMP_GREY, 0.035f));
    stage_ink(s, INK_GRID);
    stage_line(s, 0, SCREEN_BOTTOM - 4, STAGE_WIDTH, SCREEN_BOTTOM - 4);
    snprintf(text, sizeof text, "speed %.0f", (double)f->speed);
    dial(s, 112, text, 8, f->speed / 80);
    attitude(s, 322, f);
    snprintf(text, sizeof text, "height %.0f", (double)f->at.y);
    dial(s, 532, text, 10, f->at.y / 500);
    snprintf(text, sizeof text, "climb %+.1f", (double)climb);
    dial(s, 742, text, 8, 0.75f + 0.375f * fmaxf(fminf(climb / 7.5f, 1), -1));
    snprintf(text, sizeof text, "heading %03.0f", (double)degrees);
    dial(s, 952, text, 12, degrees / 360);
    throttle(s, 1110, f);
}
