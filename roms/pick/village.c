#include "roms/pick/village.h"

#include <math.h>
#include <stddef.h>

#include "roms/geometry/scalar.h"

enum { PARTS = 3, SIDE = 18, SIDES_LEAST = 8, SIDES_MOST = 24 };

struct maker {
    struct segments *s;
    float x, y; /* where what follows has its origin */
};

static void ink(const struct maker *m, enum ink colour, int part)
{
    m->s->ink = colour;
    m->s->pick = part;
}

static void shape(const struct maker *m, enum segment_kind kind, const float *xy, int count)
{
    struct point2 p[24];
    for (int i = 0; i < count; i++)
        p[i] = (struct point2){m->x + xy[2 * i], m->y + xy[2 * i + 1]};
    segment_put(m->s, kind, p, count);
}

#define SHAPE(m, kind, ...)                                                                        \
    shape(m, kind, (const float[]){__VA_ARGS__},                                                   \
          sizeof((const float[]){__VA_ARGS__}) / sizeof(float) / 2)
#define LINE(m, ...) SHAPE(m, SEGMENT_POLYLINE, __VA_ARGS__)
#define AREA(m, ...) SHAPE(m, SEGMENT_AREA, __VA_ARGS__)

static void box(const struct maker *m, enum segment_kind kind, float x, float y, float w, float h)
{
    SHAPE(m, kind, x, y, x + w, y, x + w, y + h, x, y + h);
}

/* The pen's pulse comes some tenths of a microsecond after the light: sides shorter than the way of the beam
 * in that time are drawn to their end before it, and never picked. */
static void oval(const struct maker *m, enum segment_kind kind, float x, float y, float rx,
                 float ry)
{
    struct point2 p[SIDES_MOST];
    int sides = scalar_clamp_int((int)(TURN * rx / SIDE), SIDES_LEAST, SIDES_MOST);
    for (int i = 0; i < sides; i++) {
        float angle = TURN * (float)i / (float)sides;
        p[i] = (struct point2){m->x + x + rx * cosf(angle), m->y + y + ry * sinf(angle)};
    }
    segment_put(m->s, kind, p, sides);
}

/* ---- sky and land ---------------------------------------------------------------------------------- */

static void sun(const struct maker *m)
{
    ink(m, INK_YELLOW, 1);
    oval(m, SEGMENT_AREA, 0, 0, 44, 44);
    ink(m, INK_ORANGE, 2);
    for (int i = 0; i < 12; i++) {
        float c = cosf(TURN * (float)i / 12), s = sinf(TURN * (float)i / 12);
        LINE(m, 56 * c, 56 * s, 84 * c, 84 * s);
    }
}

static void cloud(const struct maker *m)
{
    ink(m, INK_TEXT, 1);
    AREA(m, -90, 0, -98, 22, -80, 40, -56, 38, -40, 62, -4, 68, 22, 48, 48, 58, 76, 44, 80, 22, 98,
         10, 88, -4);
}

static void bird(const struct maker *m)
{
    ink(m, INK_CYAN, 1);
    LINE(m, -34, 8, -22, 18, -10, 14, 0, 0);
    LINE(m, 0, 0, 10, 14, 22, 18, 34, 8);
}

static void mountain(const struct maker *m)
{
    ink(m, INK_VIOLET, 1);
    AREA(m, -190, 0, -60, 150, -40, 138, 30, 210, 80, 160, 100, 172, 230, 0);
    ink(m, INK_BRIGHT, 2);
    AREA(m, -4, 175, 30, 210, 62, 178, 44, 184, 30, 168, 14, 182);
}

static void road(const struct maker *m)
{
    ink(m, INK_GRID, 1);
    AREA(m, -600, 0, 600, 0, 600, 54, -600, 54);
    ink(m, INK_YELLOW, 2);
    for (int x = -540; x < 600; x += 180)
        LINE(m, (float)x, 27, (float)x + 70, 27);
}

static void pond(const struct maker *m)
{
    ink(m, INK_BLUE, 1);
    oval(m, SEGMENT_AREA, 0, 0, 150, 44);
}

static void boat(const struct maker *m)
{
    ink(m, INK_BROWN, 1);
    AREA(m, -46, 0, -30, -20, 30, -20, 46, 0);
    ink(m, INK_BRIGHT, 2);
    AREA(m, 4, 8, 4, 84, 44, 8);
    ink(m, INK_ORANGE, 3);
    LINE(m, -2, 0, -2, 96);
}

/* ---- houses ------------------------------------------------------------------------------------------ */

static void church(const struct maker *m)
{
    ink(m, INK_TEXT, 1);
    AREA(m, 0, 0, 130, 0, 130, 80, 65, 124, 0, 80);
    ink(m, INK_ORANGE, 2);
    AREA(m, -70, 0, -6, 0, -6, 176, -38, 250, -70, 176);
    ink(m, INK_YELLOW, 3);
    LINE(m, -38, 250, -38, 284);
    LINE(m, -50, 270, -26, 270);
}

static void clock(const struct maker *m)
{
    ink(m, INK_BRIGHT, 1);
    oval(m, SEGMENT_AREA, 0, 0, 28, 28);
    ink(m, INK_RED, 2);
    LINE(m, 0, 22, 0, 0, 14, -9);
}

static void house(const struct maker *m)
{
    ink(m, INK_GREEN, 1);
    AREA(m, 0, 0, 210, 0, 210, 120, 0, 120);
}

static void roof(const struct maker *m)
{
    ink(m, INK_RED, 1);
    AREA(m, -24, 0, 234, 0, 170, 86, 40, 86);
}

static void chimney(const struct maker *m)
{
    ink(m, INK_BROWN, 1);
    AREA(m, 0, 0, 30, 0, 30, 50, 0, 50);
    ink(m, INK_TEXT, 2);
    LINE(m, 15, 58, 22, 70, 12, 82, 26, 96, 14, 110, 30, 124);
}

static void door(const struct maker *m)
{
    ink(m, INK_BROWN, 1);
    box(m, SEGMENT_AREA, 0, 0, 44, 80);
    ink(m, INK_YELLOW, 2);
    oval(m, SEGMENT_AREA, 36, 38, 4, 4);
}

static void window(const struct maker *m)
{
    ink(m, INK_YELLOW, 1);
    box(m, SEGMENT_AREA, 0, 0, 50, 50);
    ink(m, INK_BLUE, 2);
    LINE(m, 25, 0, 25, 50);
    LINE(m, 0, 25, 50, 25);
}

/* ---- by the road -------------------------------------------------------------------------------------- */

static void fir(const struct maker *m)
{
    ink(m, INK_BROWN, 2);
    box(m, SEGMENT_AREA, -8, 0, 16, 36);
    ink(m, INK_GREEN, 1);
    AREA(m, -56, 36, 56, 36, 24, 84, 42, 84, 16, 124, 28, 124, 0, 170, -28, 124, -16, 124, -42, 84,
         -24, 84);
}

static void apple(const struct maker *m)
{
    ink(m, INK_BROWN, 2);
    box(m, SEGMENT_AREA, -8, 0, 16, 56);
    ink(m, INK_GREEN, 1);
    oval(m, SEGMENT_AREA, 0, 100, 52, 52);
    ink(m, INK_RED, 3);
    oval(m, SEGMENT_AREA, -18, 90, 8, 8);
    oval(m, SEGMENT_AREA, 20, 112, 8, 8);
    oval(m, SEGMENT_AREA, 6, 72, 8, 8);
}

static void lamp(const struct maker *m)
{
    ink(m, INK_TEXT, 1);
    LINE(m, -3, 0, -3, 130);
    LINE(m, 3, 0, 3, 130);
    ink(m, INK_YELLOW, 2);
    AREA(m, -16, 130, 16, 130, 22, 162, -22, 162);
    ink(m, INK_ORANGE, 3);
    LINE(m, -26, 162, 0, 180, 26, 162);
}

static void fence(const struct maker *m)
{
    ink(m, INK_ORANGE, 1);
    LINE(m, 0, 18, 190, 18);
    LINE(m, 0, 40, 190, 40);
    ink(m, INK_BRIGHT, 2);
    for (int x = 5; x < 190; x += 36)
        LINE(m, (float)x, 0, (float)x, 50, (float)x + 7, 58, (float)x + 14, 50, (float)x + 14, 0);
}

static void car(const struct maker *m)
{
    ink(m, INK_CYAN, 1);
    AREA(m, -90, 14, 90, 14, 90, 44, 52, 50, 28, 82, -44, 82, -62, 50, -90, 46);
    ink(m, INK_BRIGHT, 2);
    oval(m, SEGMENT_AREA, -48, 12, 18, 18);
    oval(m, SEGMENT_AREA, 48, 12, 18, 18);
    ink(m, INK_BLUE, 3);
    AREA(m, -46, 52, -36, 74, -6, 74, -6, 52);
}

static void bus_stop(const struct maker *m)
{
    ink(m, INK_TEXT, 1);
    LINE(m, 0, 0, 0, 110);
    ink(m, INK_RED, 2);
    oval(m, SEGMENT_AREA, 0, 136, 26, 26);
    ink(m, INK_BRIGHT, 3);
    segment_put_text(m->s, (struct point2){m->x - 8, m->y + 128}, "H");
}

static void mail_box(const struct maker *m)
{
    ink(m, INK_TEXT, 1);
    LINE(m, 0, 0, 0, 50);
    ink(m, INK_YELLOW, 2);
    AREA(m, -26, 50, 26, 50, 26, 84, -26, 84);
    ink(m, INK_RED, 3);
    LINE(m, 26, 80, 40, 96);
}

/* ---- all --------------------------------------------------------------------------------------------------- */

/* In the order in which they lie over each other; name n is the n-th. */
static const struct {
    const char *name;
    const char *part[PARTS];
    void (*make)(const struct maker *m);
    float x, y;
} things[] = {
    {"mountain", {"rock", "snow", NULL}, mountain, 560, 330},
    {"sun", {"disc", "rays", NULL}, sun, 1080, 690},
    {"cloud", {NULL, NULL, NULL}, cloud, 250, 660},
    {"bird", {NULL, NULL, NULL}, bird, 830, 700},
    {"road", {"tarmac", "line", NULL}, road, 600, 60},
    {"pond", {NULL, NULL, NULL}, pond, 1010, 222},
    {"boat", {"hull", "sail", "mast"}, boat, 1010, 240},
    {"church", {"nave", "tower", "cross"}, church, 720, 300},
    {"clock", {"face", "hands", NULL}, clock, 682, 440},
    {"house", {NULL, NULL, NULL}, house, 190, 250},
    {"chimney", {"bricks", "smoke", NULL}, chimney, 320, 436},
    {"roof", {NULL, NULL, NULL}, roof, 190, 370},
    {"door", {"wood", "knob", NULL}, door, 272, 250},
    {"left window", {"pane", "bars", NULL}, window, 206, 290},
    {"right window", {"pane", "bars", NULL}, window, 336, 290},
    {"fir", {"needles", "trunk", NULL}, fir, 90, 220},
    {"apple tree", {"leaves", "trunk", "apples"}, apple, 520, 240},
    {"lamp", {"post", "light", "cap"}, lamp, 630, 130},
    {"fence", {"rails", "pickets", NULL}, fence, 400, 170},
    {"car", {"body", "wheels", "window"}, car, 240, 76},
    {"bus stop", {"pole", "sign", "letter"}, bus_stop, 780, 130},
    {"mail box", {"post", "box", "flag"}, mail_box, 130, 140},
};

enum { COUNT = sizeof things / sizeof things[0] };

void village_make(struct segments *s)
{
    for (int i = 0; i < COUNT; i++) {
        struct maker m = {s, things[i].x, things[i].y};
        segment_create(s, i + 1);
        things[i].make(&m);
        segment_set_detectable(s, i + 1, true);
        segment_close(s);
    }
}

const char *village_name(int name)
{
    return name >= 1 && name <= COUNT ? things[name - 1].name : NULL;
}

const char *village_part(int name, int part)
{
    if (name < 1 || name > COUNT || part < 1 || part > PARTS)
        return NULL;
    return things[name - 1].part[part - 1];
}
