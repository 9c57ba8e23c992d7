#include <math.h>
#include <stdio.h>

#include "roms/bounce/bounce.h"

enum { MIDDLE = 512, HALF = 500 /* units of half a room at the near pane */ };
#define EYE 2.1f /* from the near pane, half rooms */

struct spot {
    int x, y;
};

static struct spot seen(struct vector p)
{
    float scale = HALF * EYE / (EYE + 1.0f + p.z);
    return (struct spot){MIDDLE + (int)lrintf(p.x * scale), MIDDLE + (int)lrintf(p.y * scale)};
}

static void at(struct display *d, float x, float y, float z)
{
    struct spot s = seen((struct vector){x, y, z});
    display_at(d, s.x, s.y);
}

static void line(struct display *d, float x, float y, float z)
{
    struct spot s = seen((struct vector){x, y, z});
    display_line(d, s.x, s.y);
}

/* A square across the view. */
static void pane(struct display *d, float z)
{
    at(d, -1, -1, z);
    line(d, 1, -1, z);
    line(d, 1, 1, z);
    line(d, -1, 1, z);
    line(d, -1, -1, z);
}

void draw_room(struct display *d)
{
    display_intensity(d, 3);
    pane(d, 1);
    for (int corner = 0; corner < 4; corner++) {
        float x = corner & 1 ? 1 : -1, y = corner & 2 ? 1 : -1;
        at(d, x, y, -1);
        line(d, x, y, 1);
    }
    display_intensity(d, 2);
    pane(d, -1);
    /* Boards of the floor and lines across it. */
    display_intensity(d, 1);
    for (int i = -3; i <= 3; i++) {
        at(d, (float)i / 4, -1, -1);
        line(d, (float)i / 4, -1, 1);
        at(d, -1, -1, (float)i / 4);
        line(d, 1, -1, (float)i / 4);
    }
}

/* A circle on the floor: the smaller the higher the body is. */
static void shadow(struct display *d, const struct body *body)
{
    float radius = BODY_RADIUS * (1.0f - 0.35f * (body->place.y + 1.0f) / 2);
    display_intensity(d, 2);
    display_line_type(d, DF_LINE_SHORT);
    at(d, body->place.x + radius, -1, body->place.z);
    for (int i = 1; i <= 24; i++) {
        float angle = 6.2831853f * (float)i / 24;
        line(d, body->place.x + radius * cosf(angle), -1, body->place.z + radius * sinf(angle));
    }
    display_line_type(d, DF_LINE_SOLID);
}

static float distance_squared(struct vector a, struct vector b)
{
    float x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return x * x + y * y + z * z;
}

/* Neighbours are an edge apart, others much more. Near edges are brighter. */
static void edges(struct display *d, const struct body *body)
{
    struct vector corner[BODY_VERTICES];
    body_corners(body, corner);
    for (int i = 0; i < BODY_VERTICES; i++) {
        for (int k = i + 1; k < BODY_VERTICES; k++) {
            if (distance_squared(corner[i], corner[k]) > 1.5f * BODY_RADIUS * BODY_RADIUS)
                continue;
            float depth = (corner[i].z + corner[k].z) / 2 - body->place.z;
            display_intensity(d, (unsigned)lrintf(5.0f - 2.0f * depth / BODY_RADIUS));
            at(d, corner[i].x, corner[i].y, corner[i].z);
            line(d, corner[k].x, corner[k].y, corner[k].z);
        }
    }
}

void draw_body(struct display *d, const struct body *body)
{
    char text[16];
    shadow(d, body);
    edges(d, body);
    snprintf(text, sizeof text, "BOUNCES %4u", body->bounces);
    display_intensity(d, 4);
    display_text(d, MIDDLE - 11 * 7, 960, text);
}
