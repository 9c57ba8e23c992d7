/* check_clip — clipping in the machine: properties on random cases. Exits with 0 when all hold. */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "roms/bsp/board.h"
#include "roms/clip/cohen_sutherland.h"
#include "roms/clip/liang_barsky.h"
#include "roms/clip/sutherland_hodgman.h"

static uint32_t random_state = 1;

static float random_float(float limit)
{
    random_state = random_state * 1664525u + 1013904223u;
    return ((float)(random_state >> 8) / (float)(1u << 23) - 1) * limit;
}

/* Whole numbers hit corners, edges and points often. */
static float random_coordinate(int number)
{
    float v = random_float(10);
    return number % 2 ? v : rintf(v);
}

static struct clip_window random_window(int number)
{
    float a = random_coordinate(number), b = random_coordinate(number);
    float c = random_coordinate(number), d = random_coordinate(number);
    return (struct clip_window){fminf(a, b), fminf(c, d), fmaxf(a, b), fmaxf(c, d)};
}

static bool near(struct point2 a, struct point2 b)
{
    return fabsf(a.x - b.x) <= 2e-5f && fabsf(a.y - b.y) <= 2e-5f;
}

/* Two clippers agree: the verdict and both ends. They may differ where rounding decides: there what
 * one of them leaves is a point. */
static int disagreements(int lines)
{
    int bad = 0;
    for (int i = 0; i < lines; i++) {
        struct clip_window w = random_window(i);
        struct point2 a = {random_coordinate(i), random_coordinate(i)}, c = a;
        struct point2 b = {random_coordinate(i), random_coordinate(i)}, d = b;
        bool first = clip_cohen_sutherland(&w, &a, &b), second = clip_liang_barsky(&w, &c, &d);
        bool same = first && second ? near(a, c) && near(b, d) : first == second;
        bool point = (first && !second && near(a, b)) || (second && !first && near(c, d));
        bad += !same && !point;
    }
    return bad;
}

/* What is left lies in the window and on the line. */
static int strays(int lines)
{
    int bad = 0;
    for (int i = 0; i < lines; i++) {
        struct clip_window w = random_window(i);
        struct point2 a = {random_coordinate(i), random_coordinate(i)}, from = a;
        struct point2 b = {random_coordinate(i), random_coordinate(i)}, to = b;
        if (!clip_cohen_sutherland(&w, &from, &to))
            continue;
        float dx = b.x - a.x, dy = b.y - a.y, length = hypotf(dx, dy) + 1e-9f;
        float off = fabsf((from.x - a.x) * dy - (from.y - a.y) * dx) / length;
        off = fmaxf(off, fabsf((to.x - a.x) * dy - (to.y - a.y) * dx) / length);
        bad += !clip_point(&w, from) || !clip_point(&w, to) || off > 1e-5f;
    }
    return bad;
}

static float area(const struct point2 *p, int count)
{
    float twice = 0;
    for (int i = 0; i < count; i++) {
        struct point2 a = p[i], b = p[(i + 1) % count];
        twice += a.x * b.y - b.x * a.y;
    }
    return twice / 2;
}

/* A window cut in four by a cross: the parts of a polygon in the quarters add up to what is in
 * it. */
static int lost_areas(int polygons)
{
    static struct sutherland_hodgman s;
    int bad = 0;
    for (int i = 0; i < polygons; i++) {
        struct point2 p[9];
        for (int k = 0; k < 9; k++)
            p[k] = (struct point2){random_coordinate(i), random_coordinate(i)};
        const struct clip_window w = {-7, -6, 6, 5};
        float x = random_float(5), y = random_float(4), sum = 0;
        const struct clip_window quarter[] = {{w.x_min, w.y_min, x, y},
                                              {x, w.y_min, w.x_max, y},
                                              {w.x_min, y, x, w.y_max},
                                              {x, y, w.x_max, w.y_max}};
        for (int k = 0; k < 4; k++) {
            clip_sutherland_hodgman(&s, &quarter[k], p, 9);
            sum += area(s.corner, s.count);
        }
        clip_sutherland_hodgman(&s, &w, p, 9);
        bad += fabsf(sum - area(s.corner, s.count)) > 1e-3f;
    }
    return bad;
}

/* A rectangle's part in a window is known. */
static int wrong_rectangles(int rectangles)
{
    static struct sutherland_hodgman s;
    int bad = 0;
    for (int i = 0; i < rectangles; i++) {
        struct clip_window w = random_window(i), r = random_window(i + 1);
        const struct point2 p[] = {
            {r.x_min, r.y_min}, {r.x_max, r.y_min}, {r.x_max, r.y_max}, {r.x_min, r.y_max}};
        float across = fminf(w.x_max, r.x_max) - fmaxf(w.x_min, r.x_min);
        float up = fminf(w.y_max, r.y_max) - fmaxf(w.y_min, r.y_min);
        clip_sutherland_hodgman(&s, &w, p, 4);
        float want = across > 0 && up > 0 ? across * up : 0;
        bad += fabsf(area(s.corner, s.count) - want) > 1e-4f;
    }
    return bad;
}

int main(void)
{
    static const struct {
        int (*count)(int cases);
        int cases;
        const char *what;
    } properties[] = {
        {disagreements, 20000, "lines: Cohen-Sutherland and Liang-Barsky leave the same, to 2e-5"},
        {strays, 10000, "lines: what is left is in the window and on the line, to 1e-5"},
        {lost_areas, 500, "polygons: the parts in four quarters add up, to 1e-3"},
        {wrong_rectangles, 5000, "rectangles: the area that two share, to 1e-4"},
    };
    int all = 0;
    for (unsigned i = 0; i < sizeof properties / sizeof properties[0]; i++) {
        int bad = properties[i].count(properties[i].cases);
        printf("%d %s: %d failed\n", properties[i].cases, properties[i].what, bad);
        all += bad;
    }
    return all > 0;
}
