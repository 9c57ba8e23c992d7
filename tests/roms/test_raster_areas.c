/* Filling areas (roms/raster): polygons against every pixel's middle in exact whole numbers, by
 * both rules, with holes, in every format; tilings; flood and boundary fills against a search
 * that visits pixel by pixel. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "roms/raster/boundary_fill.c"
#include "roms/raster/fill.c"
#include "roms/raster/flood_fill.c"
#include "roms/raster/pixel.h"
#include "roms/raster/polygon_fill.c"
#include "roms/raster/span_fill.c"

enum { WIDTH = 77, HEIGHT = 60, SEEDS = 2000 };

static const unsigned formats[] = {1, 2, 4, 8, 16, 32};
enum { FORMATS = sizeof formats / sizeof *formats };

static struct {
    uint32_t words[WIDTH * HEIGHT + 4 * HEIGHT];
    struct span_seed seeds[SEEDS];
    uint32_t state;
} rig;

static uint32_t random_below(uint32_t limit)
{
    rig.state = rig.state * 1664525u + 1013904223u;
    return (rig.state >> 8) % limit;
}

static float random_within(float low, float high)
{
    return low + (high - low) * (float)random_below(1 << 20) / (1 << 20);
}

static struct canvas canvas_of(unsigned bits)
{
    memset(rig.words, 0, sizeof rig.words);
    struct canvas c = {.width = WIDTH, .height = HEIGHT, .bits = bits, .dots_a_row = 1.0f};
    c.pitch = canvas_pitch(WIDTH, bits);
    c.pixels = (uint8_t *)rig.words;
    return c;
}

/* ---- polygons -------------------------------------------------------------------------------- */

static int64_t part(float v)
{
    return (int64_t)floor((double)v * 64 + 0.5);
}

/* Edges that lie on or to the left of a pixel's middle, with the direction they go: +1 down. */
static void count_edges(const struct point2 *p, int count, int x, int y, int *crossings,
                        int *winding)
{
    for (int i = 0; i < count; i++) {
        struct point2 a = p[i], b = p[(i + 1) % count];
        int64_t x0 = part(a.x), y0 = part(a.y), x1 = part(b.x), y1 = part(b.y);
        int sense = y0 < y1 ? 1 : -1;
        if (sense < 0) {
            int64_t tx = x0, ty = y0;
            x0 = x1, y0 = y1, x1 = tx, y1 = ty;
        }
        if (y0 > 64 * y || y1 <= 64 * y)
            continue;
        if (x0 * (y1 - y0) + (x1 - x0) * (64 * y - y0) <= (int64_t)64 * x * (y1 - y0)) {
            ++*crossings;
            *winding += sense;
        }
    }
}

static bool belongs(const struct point2 *p, const int *counts, int contours, int x, int y,
                    enum polygon_rule rule)
{
    int crossings = 0, winding = 0;
    for (int i = 0; i < contours; p += counts[i++])
        count_edges(p, counts[i], x, y, &crossings, &winding);
    return rule == POLYGON_EVEN_ODD ? crossings % 2 == 1 : winding != 0;
}

static void assert_filled(const struct canvas *c, const struct point2 *p, const int *counts,
                          int contours, enum polygon_rule rule)
{
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            assert_int_equal(canvas_pixel(c, x, y), belongs(p, counts, contours, x, y, rule));
}

/* A corner: anywhere, on a pixel's middle, or far outside. */
static struct point2 corner(int kind)
{
    struct point2 p = {random_within(-20, WIDTH + 20), random_within(-20, HEIGHT + 20)};
    if (kind == 1)
        p = (struct point2){(float)random_below(WIDTH), (float)random_below(HEIGHT)};
    if (kind == 2)
        p = (struct point2){random_within(-8000, 8000), random_within(-8000, 8000)};
    return p;
}

static void fills_are_every_pixels_middle(void **state)
{
    (void)state;
    for (int i = 0; i < 3000; i++) {
        struct canvas c = canvas_of(formats[i % FORMATS]);
        struct point2 p[40];
        int count = 3 + (int)random_below(i % 10 == 0 ? 37 : 6), kind = i / 3 % 3;
        enum polygon_rule rule = i % 2 ? POLYGON_NON_ZERO : POLYGON_EVEN_ODD;
        for (int k = 0; k < count; k++)
            p[k] = corner(kind);
        canvas_polygon(&c, p, count, rule, 1);
        assert_filled(&c, p, &count, 1, rule);
    }
}

static void contours_make_holes(void **state)
{
    (void)state;
    for (int i = 0; i < 2000; i++) {
        struct canvas c = canvas_of(formats[i % FORMATS]);
        struct point2 p[36];
        int counts[3], all = 0;
        enum polygon_rule rule = i % 2 ? POLYGON_NON_ZERO : POLYGON_EVEN_ODD;
        for (int k = 0; k < 3; k++)
            all += counts[k] = 3 + (int)random_below(9);
        for (int k = 0; k < all; k++)
            p[k] = corner(i / 3 % 2);
        canvas_polygons(&c, p, counts, 3, rule, 1);
        assert_filled(&c, p, counts, 3, rule);
    }
}

/* The plane cut into triangles whose corners were moved: each pixel belongs to exactly one. */
static void tilings_share_no_pixel_and_leave_no_gap(void **state)
{
    (void)state;
    enum { ACROSS = 9, UP = 8 };
    for (int round = 0; round < 150; round++) {
        static struct point2 at[UP + 1][ACROSS + 1];
        static uint8_t times[HEIGHT][WIDTH];
        memset(times, 0, sizeof times);
        for (int y = 0; y <= UP; y++)
            for (int x = 0; x <= ACROSS; x++) {
                bool edge = x == 0 || y == 0 || x == ACROSS || y == UP;
                float jump = edge ? 0 : 2.9f; /* no triangle turns over */
                at[y][x] = (struct point2){(float)(x - 1) * 12 + random_within(-jump, jump),
                                           (float)(y - 1) * 12 + random_within(-jump, jump)};
                if (round % 3 == 0)
                    at[y][x] = (struct point2){roundf(at[y][x].x), roundf(at[y][x].y)};
            }
        for (int i = 0; i < 2 * ACROSS * UP; i++) {
            struct canvas c = canvas_of(8);
            int x = i / 2 % ACROSS, y = i / 2 / ACROSS;
            struct point2 p[3] = {at[y][x + 1], at[y + 1][x], i % 2 ? at[y + 1][x + 1] : at[y][x]};
            canvas_polygon(&c, p, 3, i % 3 ? POLYGON_EVEN_ODD : POLYGON_NON_ZERO, 1);
            for (int py = 0; py < HEIGHT; py++)
                for (int px = 0; px < WIDTH; px++)
                    times[py][px] = (uint8_t)(times[py][px] + canvas_pixel(&c, px, py));
        }
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++)
                assert_int_equal(times[y][x], 1);
    }
}

static void what_cannot_be_filled_is_not(void **state)
{
    (void)state;
    static struct point2 p[POLYGON_CORNERS + 1];
    struct canvas c = canvas_of(8);
    for (int i = 0; i <= POLYGON_CORNERS; i++)
        p[i] = corner(0);
    canvas_polygon(&c, p, 2, POLYGON_EVEN_ODD, 1);
    canvas_polygon(&c, p, POLYGON_CORNERS + 1, POLYGON_EVEN_ODD, 1);
    canvas_polygon(&c, p, 0, POLYGON_EVEN_ODD, 1);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            assert_int_equal(canvas_pixel(&c, x, y), 0);
    p[0] = (struct point2){NAN, INFINITY};
    p[1] = (struct point2){3e38f, -3e38f};
    canvas_polygon(&c, p, POLYGON_CORNERS, POLYGON_NON_ZERO, 1);
    c.width = c.height = 0;
    canvas_polygon(&c, p, 10, POLYGON_EVEN_ODD, 1);
}

/* ---- connected areas ------------------------------------------------------------------------- */

/* Scenery of so many values, with as many obstacles as `rare` says. */
static void scatter(const struct canvas *c, int values, int rare)
{
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            if (random_below((uint32_t)rare) == 0)
                canvas_dot(c, x, y, 1 + random_below((uint32_t)values - 1));
}

/* A search that visits pixel by pixel. */
struct search {
    const struct canvas *canvas;
    bool flood;
    uint32_t limit, colour;
    uint8_t reached[HEIGHT][WIDTH];
    int queue[WIDTH * HEIGHT], tail;
};

static void visit(struct search *s, int x, int y)
{
    if (x < 0 || y < 0 || x >= WIDTH || y >= HEIGHT || s->reached[y][x])
        return;
    uint32_t v = canvas_pixel(s->canvas, x, y);
    if (s->flood ? v != s->limit : v == s->limit || v == s->colour)
        return;
    s->reached[y][x] = 1;
    s->queue[s->tail++] = y * WIDTH + x;
}

static void search(struct search *s, int x, int y, int connected)
{
    visit(s, x, y);
    for (int head = 0; head < s->tail; head++) {
        x = s->queue[head] % WIDTH;
        y = s->queue[head] / WIDTH;
        for (int k = 0; k < 9; k++)
            if (connected == 8 || k % 2 == 1)
                visit(s, x + k % 3 - 1, y + k / 3 - 1);
    }
}

static void fills_reach_what_a_search_reaches(void **state)
{
    (void)state;
    static struct search s;
    static uint32_t before[HEIGHT][WIDTH];
    long reached = 0;
    for (int i = 0; i < 3000; i++) {
        struct canvas c = canvas_of(formats[i % FORMATS]);
        int x = (int)random_below(WIDTH), y = (int)random_below(HEIGHT), connected = i % 2 ? 4 : 8;
        /* Near where what is connected falls apart. */
        scatter(&c, c.bits == 1 ? 2 : 4, 2 + (int)random_below(5));
        s = (struct search){.canvas = &c, .flood = i / 2 % 2, .colour = c.bits == 1 ? 0 : 3};
        s.limit = s.flood ? canvas_pixel(&c, x, y) : 1;
        bool nothing = s.flood && s.limit == s.colour;
        if (!nothing)
            search(&s, x, y, connected);
        for (int py = 0; py < HEIGHT; py++)
            for (int px = 0; px < WIDTH; px++)
                before[py][px] = canvas_pixel(&c, px, py);
        if (s.flood)
            assert_true(canvas_flood_fill(&c, x, y, connected, s.colour, rig.seeds, SEEDS));
        else
            assert_true(canvas_boundary_fill(&c, x, y, connected, 1, s.colour, rig.seeds, SEEDS));
        for (int py = 0; py < HEIGHT; py++)
            for (int px = 0; px < WIDTH; px++)
                assert_int_equal(canvas_pixel(&c, px, py),
                                 s.reached[py][px] ? s.colour : before[py][px]);
        reached += s.tail;
    }
    assert_true(reached > 500000);
}

/* Each span is new, and its seeds are those on top of the stack. */
static void spans_are_disjoint(void **state)
{
    (void)state;
    for (int i = 0; i < 200; i++) {
        struct canvas c = canvas_of(8);
        static uint8_t times[HEIGHT][WIDTH];
        struct span_fill f;
        struct span_filled span;
        memset(times, 0, sizeof times);
        scatter(&c, 3, 3 + i % 4);
        canvas_dot(&c, 30, 30, 0);
        flood_fill_begin(&f, &c, 30, 30, 4, 9, rig.seeds, SEEDS);
        while (span_fill_next(&f, &span)) {
            assert_true(span.x0 <= span.x1 && span.pushed <= f.count);
            for (int x = span.x0; x <= span.x1; x++)
                assert_int_equal(times[span.y][x]++, 0);
            for (int k = 1; k <= span.pushed; k++)
                assert_int_equal(abs(f.seeds[f.count - k].y - span.y), 1);
        }
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++)
                assert_int_equal(times[y][x], canvas_pixel(&c, x, y) == 9);
    }
}

/* With too small a stack something may be missing: then it is said. */
static void a_stack_that_is_too_small_is_reported(void **state)
{
    (void)state;
    static struct search s;
    int refused = 0;
    for (int i = 0; i < 1000; i++) {
        struct canvas c = canvas_of(8);
        int room = (int)random_below(30), missing = 0;
        scatter(&c, 2, 2 + i % 5);
        canvas_dot(&c, 40, 20, 0);
        s = (struct search){.canvas = &c, .flood = true, .limit = 0};
        search(&s, 40, 20, 4);
        bool complete = canvas_flood_fill(&c, 40, 20, 4, 7, rig.seeds, room);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                assert_true(canvas_pixel(&c, x, y) != 7 || s.reached[y][x]);
                missing += canvas_pixel(&c, x, y) != 7 && s.reached[y][x];
            }
        assert_true(missing == 0 || !complete);
        refused += !complete;
    }
    assert_in_range(refused, 100, 900);
}

static void seeds_outside_fill_nothing(void **state)
{
    (void)state;
    struct canvas c = canvas_of(8);
    canvas_flood_fill(&c, -1, 5, 4, 1, rig.seeds, SEEDS);
    canvas_flood_fill(&c, 5, HEIGHT, 8, 1, rig.seeds, SEEDS);
    canvas_boundary_fill(&c, WIDTH, 0, 8, 2, 1, rig.seeds, SEEDS);
    canvas_boundary_fill(&c, 70000, 0, 8, 2, 1, rig.seeds, SEEDS);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            assert_int_equal(canvas_pixel(&c, x, y), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fills_are_every_pixels_middle),
        cmocka_unit_test(contours_make_holes),
        cmocka_unit_test(tilings_share_no_pixel_and_leave_no_gap),
        cmocka_unit_test(what_cannot_be_filled_is_not),
        cmocka_unit_test(fills_reach_what_a_search_reaches),
        cmocka_unit_test(spans_are_disjoint),
        cmocka_unit_test(a_stack_that_is_too_small_is_reported),
        cmocka_unit_test(seeds_outside_fill_nothing),
    };
    rig.state = 12345;
    return cmocka_run_group_tests(tests, NULL, NULL);
}
