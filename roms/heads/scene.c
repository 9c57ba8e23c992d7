/* A house under a tree, a ship under the sun, a fan of lines: slopes of every kind. */
#include <math.h>
#include <stddef.h>
#include <stdint.h>

#include "roms/heads/heads.h"

#define TAU 6.2831853f

struct xy {
    int16_t x, y;
};

static void path(const struct heads_pen *pen, const struct xy *p, size_t count)
{
    for (size_t i = 1; i < count; i++)
        pen->line(pen->ctx, p[i - 1].x, p[i - 1].y, p[i].x, p[i].y);
}
#define PATH(pen, points) path(pen, points, sizeof(points) / sizeof *(points))

static void ring(const struct heads_pen *pen, int x, int y, int radius, int sides)
{
    int px = x + radius, py = y;
    for (int i = 1; i <= sides; i++) {
        float angle = TAU * (float)i / (float)sides;
        int qx = x + (int)lrintf((float)radius * cosf(angle));
        int qy = y + (int)lrintf((float)radius * sinf(angle));
        pen->line(pen->ctx, px, py, qx, qy);
        px = qx;
        py = qy;
    }
}

static void house(const struct heads_pen *pen)
{
    static const struct xy walls[] = {{80, 180}, {80, 380}, {380, 380}, {380, 180}, {80, 180}};
    static const struct xy roof[] = {{50, 370}, {230, 520}, {410, 370}};
    static const struct xy door[] = {{200, 180}, {200, 290}, {260, 290}, {260, 180}};
    static const struct xy left[] = {{110, 270}, {170, 270}, {170, 330}, {110, 330}, {110, 270}};
    static const struct xy right[] = {{290, 270}, {350, 270}, {350, 330}, {290, 330}, {290, 270}};
    static const struct xy bars[] = {{110, 300}, {170, 300}};
    static const struct xy bars2[] = {{290, 300}, {350, 300}};
    static const struct xy chimney[] = {{300, 462}, {300, 530}, {335, 530}, {335, 433}};
    PATH(pen, walls);
    PATH(pen, roof);
    PATH(pen, door);
    PATH(pen, left);
    PATH(pen, right);
    PATH(pen, bars);
    PATH(pen, bars2);
    PATH(pen, chimney);
    ring(pen, 248, 235, 4, 6);
}

static void ship(const struct heads_pen *pen)
{
    static const struct xy hull[] = {{540, 250}, {590, 190}, {850, 190}, {920, 250}, {540, 250}};
    static const struct xy mast[] = {{710, 250}, {710, 560}};
    static const struct xy fore[] = {{725, 545}, {725, 285}, {895, 285}, {725, 545}};
    static const struct xy aft[] = {{695, 500}, {695, 285}, {575, 285}, {695, 500}};
    static const struct xy flag[] = {{710, 560}, {660, 545}, {710, 530}};
    PATH(pen, hull);
    PATH(pen, mast);
    PATH(pen, fore);
    PATH(pen, aft);
    PATH(pen, flag);
    for (int row = 0; row < 3; row++) { /* waves */
        int y = 160 - 22 * row, shift = row % 2 * 20;
        for (int x = 500 + shift; x < 920; x += 40) {
            pen->line(pen->ctx, x, y, x + 20, y + 9);
            pen->line(pen->ctx, x + 20, y + 9, x + 40, y);
        }
    }
}

static void star(const struct heads_pen *pen)
{
    struct xy point[5];
    for (int i = 0; i < 5; i++) {
        float angle = TAU * (0.25f + (float)i / 5.0f);
        point[i] = (struct xy){(int16_t)lrintf(225.0f + 110.0f * cosf(angle)),
                               (int16_t)lrintf(690.0f + 110.0f * sinf(angle))};
    }
    for (int i = 0; i < 5; i++) {
        const struct xy *a = &point[i], *b = &point[(i + 2) % 5];
        pen->line(pen->ctx, a->x, a->y, b->x, b->y);
    }
}

/* From upright to level in equal steps: on a raster every slope has stairs of its own. */
static void fan(const struct heads_pen *pen)
{
    for (int i = 0; i <= 18; i++) {
        float angle = TAU * (0.25f + 0.25f * (float)i / 18.0f);
        pen->line(pen->ctx, 940, 620, 940 + (int)lrintf(340.0f * cosf(angle)),
                  620 + (int)lrintf(250.0f * sinf(angle)));
    }
    pen->line(pen->ctx, 940, 620, 600, 620);
}

void heads_scene(const struct heads_pen *pen, const char *title)
{
    static const struct xy ground[] = {{20, 180}, {440, 180}};
    pen->level(pen->ctx, 7);
    pen->text(pen->ctx, 60, 920, title);
    pen->level(pen->ctx, 5);
    house(pen);
    ship(pen);
    star(pen);
    pen->level(pen->ctx, 4);
    fan(pen);
    PATH(pen, ground);
    pen->text(pen->ctx, 60, 60, "THE SAME LINES, TWICE");
}
