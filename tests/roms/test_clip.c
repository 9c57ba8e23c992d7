/* Clipping (roms/clip): lines by both algorithms against each other and against an exact clipper in
 * double precision, polygons against Green's theorem, text against single dots. The sources are
 * compiled for this machine. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "roms/clip/cohen_sutherland.c"
#include "roms/clip/liang_barsky.c"
#include "roms/clip/sutherland_hodgman.c"
#include "roms/clip/text.c"
#include "roms/raster/font.c"

static uint32_t random_state = 1;

static uint32_t random_below(uint32_t limit)
{
    random_state = random_state * 1664525u + 1013904223u;
    return (random_state >> 8) % limit;
}

/* Anywhere within ±limit. */
static float random_float(float limit)
{
    return ((float)random_below(1u << 24) / (float)(1u << 23) - 1) * limit;
}

/* A whole number within ±limit: many lines through corners, along edges, of length 0. */
static float random_whole(int limit)
{
    return (float)((int)random_below(2 * (uint32_t)limit + 1) - limit);
}

/* ---- the exact clipper ----------------------------------------------------------------------- */

struct kept {
    double t1, t2; /* t1 > t2: nothing */
};

/* Halves of planes cut the interval; in double precision differences and quotients of floats are
 * exact to 1e-16. The window is grown by `slack` on all sides. */
static struct kept exact(const struct clip_window *w, struct point2 a, struct point2 b,
                         double slack)
{
    struct kept k = {0, 1};
    const double from[2] = {a.x, a.y}, to[2] = {b.x, b.y};
    const double low[2] = {w->x_min - slack, w->y_min - slack};
    const double high[2] = {w->x_max + slack, w->y_max + slack};
    for (int i = 0; i < 2; i++) {
        double d = to[i] - from[i];
        if (d == 0 && (from[i] < low[i] || from[i] > high[i]))
            return (struct kept){1, 0};
        if (d == 0)
            continue;
        double in = ((d > 0 ? low[i] : high[i]) - from[i]) / d;
        double out = ((d > 0 ? high[i] : low[i]) - from[i]) / d;
        k.t1 = fmax(k.t1, in);
        k.t2 = fmin(k.t2, out);
    }
    return k;
}

/* How far a point is from the part t1…t2 of a line. */
static double distance(struct point2 a, struct point2 b, double t1, double t2, struct point2 p)
{
    double dx = (double)b.x - a.x, dy = (double)b.y - a.y, square = dx * dx + dy * dy;
    double t = square > 0 ? (((double)p.x - a.x) * dx + ((double)p.y - a.y) * dy) / square : 0;
    t = fmin(fmax(t, t1), t2);
    return hypot(a.x + t * dx - p.x, a.y + t * dy - p.y);
}

typedef bool clipper(const struct clip_window *w, struct point2 *a, struct point2 *b);

/* To within `slack`, 1e-6 of the largest coordinate: what is left lies on the line, and each of its
 * ends between those that a window larger and one smaller by the slack would leave. */
static void check_line(clipper *clip, const struct clip_window *w, struct point2 a, struct point2 b)
{
    double largest = 0;
    const float all[] = {a.x, a.y, b.x, b.y, w->x_min, w->y_min, w->x_max, w->y_max};
    for (int i = 0; i < 8; i++)
        largest = fmax(largest, fabs((double)all[i]));
    double slack = 1e-6 * largest;
    struct point2 from = a, to = b;
    struct kept grown = exact(w, a, b, slack), shrunk = exact(w, a, b, -slack);
    bool left = clip(w, &from, &to);
    if (!left) {
        assert_true(shrunk.t1 > shrunk.t2);
        assert_memory_equal(&from, &a, sizeof a);
        assert_memory_equal(&to, &b, sizeof b);
        return;
    }
    assert_true(grown.t1 <= grown.t2);
    bool any = shrunk.t1 <= shrunk.t2;
    assert_true(distance(a, b, grown.t1, any ? shrunk.t1 : grown.t2, from) <= slack);
    assert_true(distance(a, b, any ? shrunk.t2 : grown.t1, grown.t2, to) <= slack);
    assert_true(from.x >= w->x_min - slack && from.x <= w->x_max + slack);
    assert_true(to.y >= w->y_min - slack && to.y <= w->y_max + slack);
}

static void for_lines(void (*check)(const struct clip_window *, struct point2, struct point2))
{
    for (int i = 0; i < 300000; i++) {
        bool whole = i % 2 == 0;
        int n = 3 + i % 9;
        float limit = powf(10, (float)(i % 7 - 2));
        float v[8];
        for (int k = 0; k < 8; k++)
            v[k] = whole ? random_whole(n) : random_float(limit);
        struct clip_window w = {fminf(v[0], v[2]), fminf(v[1], v[3]), fmaxf(v[0], v[2]),
                                fmaxf(v[1], v[3])};
        check(&w, (struct point2){v[4], v[5]}, (struct point2){v[6], v[7]});
    }
}

static void by_cohen_sutherland(const struct clip_window *w, struct point2 a, struct point2 b)
{
    check_line(clip_cohen_sutherland, w, a, b);
}

static void by_liang_barsky(const struct clip_window *w, struct point2 a, struct point2 b)
{
    check_line(clip_liang_barsky, w, a, b);
}

static void cohen_sutherland_is_exact(void **state)
{
    (void)state;
    for_lines(by_cohen_sutherland);
}

static void liang_barsky_is_exact(void **state)
{
    (void)state;
    for_lines(by_liang_barsky);
}

/* At most four cuts, each moving an end that is outside onto the edge it names; ends in the
 * window. */
static void cuts_are_few(const struct clip_window *w, struct point2 a, struct point2 b)
{
    struct cohen_sutherland k;
    int cuts = 0;
    cohen_sutherland_begin(&k, w, a, b);
    for (unsigned code[2] = {k.code[0], k.code[1]}; cohen_sutherland_next(&k); cuts++) {
        assert_true(code[k.cut] & k.edge);
        assert_true(k.cut == 0 || code[0] == 0);
        struct point2 p = k.end[k.cut];
        assert_true(p.x == w->x_min || p.x == w->x_max || p.y == w->y_min || p.y == w->y_max);
        assert_false(clip_region(w, p) & k.edge);
        memcpy(code, k.code, sizeof code);
    }
    assert_true(cuts <= 4);
    if (k.accepted)
        assert_true(clip_point(w, k.end[0]) && clip_point(w, k.end[1]));
}

static void cohen_sutherland_takes_few_cuts(void **state)
{
    (void)state;
    for_lines(cuts_are_few);
}

/* Lines that pass a corner by a few units in the last place, where rounding undoes cuts. */
static void lines_through_corners_end(void **state)
{
    (void)state;
    for (int i = 0; i < 200000; i++) {
        struct clip_window w = {random_float(9), random_float(9), 0, 0};
        w.x_max = w.x_min + fabsf(random_float(5));
        w.y_max = w.y_min + fabsf(random_float(5));
        float dx = random_float(20), dy = random_float(20), t = random_float(3);
        struct point2 a = {w.x_min - t * dx, w.y_max - t * dy};
        struct point2 b = {w.x_min + dx, w.y_max + dy};
        cuts_are_few(&w, a, b);
        check_line(clip_cohen_sutherland, &w, a, b);
        check_line(clip_liang_barsky, &w, a, b);
    }
}

/* Quotients of small whole numbers are equal when they should be: Liang-Barsky's verdict has no
 * slack, also where a line touches a corner or runs along an edge. */
static void whole_numbers_are_decided_exactly(void **state)
{
    (void)state;
    int touching = 0;
    for (int i = 0; i < 200000; i++) {
        struct clip_window w = {random_whole(5), random_whole(5), 0, 0};
        w.x_max = w.x_min + (float)random_below(5);
        w.y_max = w.y_min + (float)random_below(5);
        float x = random_whole(9), y = random_whole(9);
        struct point2 a = {x, y};
        x = random_whole(9);
        y = random_whole(9);
        struct point2 b = {x, y};
        struct kept k = exact(&w, a, b, 0);
        touching += k.t1 == k.t2;
        assert_int_equal(clip_liang_barsky(&w, &a, &b), k.t1 <= k.t2);
    }
    assert_true(touching > 1000);
}

/* What lies on the edge belongs to the window. */
static void edges_belong_to_the_window(void **state)
{
    (void)state;
    const struct clip_window w = {-3, -2, 4, 5};
    const struct point2 lines[][2] = {{{-9, -2}, {9, -2}}, {{-9, 5}, {9, 5}},   {{-3, -9}, {-3, 9}},
                                      {{4, 9}, {4, -9}},   {{4, 5}, {4, 5}},    {{-3, 1}, {-7, 1}},
                                      {{5, 4}, {3, 6}},    {{-3, -2}, {-9, -9}}};
    for (unsigned i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        struct point2 a = lines[i][0], b = lines[i][1], c = a, d = b;
        assert_true(clip_cohen_sutherland(&w, &a, &b));
        assert_true(clip_liang_barsky(&w, &c, &d));
        assert_true(clip_point(&w, a) && clip_point(&w, b));
        assert_memory_equal(&a, &c, sizeof a);
        assert_memory_equal(&b, &d, sizeof b);
    }
}

static void inverted_windows_hold_nothing(void **state)
{
    (void)state;
    for (int i = 0; i < 20000; i++) {
        struct clip_window w = {random_whole(5), -9, 0, 9};
        w.x_max = w.x_min - 1 - (float)random_below(3);
        struct point2 a = {random_whole(9), random_whole(9)},
                      b = {random_whole(9), random_whole(9)};
        assert_false(clip_point(&w, a));
        assert_false(clip_cohen_sutherland(&w, &a, &b));
        assert_false(clip_liang_barsky(&w, &a, &b));
    }
}

/* ---- worked by hand -------------------------------------------------------------------------- */

static void assert_point(struct point2 p, double x, double y)
{
    assert_true(fabs(p.x - x) < 6e-5 && fabs(p.y - y) < 6e-5);
}

static void codes_and_cuts_of_the_course(void **state)
{
    (void)state;
    const struct clip_window w = {10, 10, 40, 40};
    struct cohen_sutherland k;
    cohen_sutherland_begin(&k, &w, (struct point2){5, 8}, (struct point2){40, 15});
    assert_int_equal(k.code[0], 5);
    assert_int_equal(k.code[1], 0);
    assert_true(cohen_sutherland_next(&k));
    assert_point(k.end[0], 10, 9);
    assert_int_equal(k.code[0], 4);
    assert_true(cohen_sutherland_next(&k));
    assert_point(k.end[0], 15, 10);
    assert_false(cohen_sutherland_next(&k));
    assert_true(k.accepted);
    cohen_sutherland_begin(&k, &w, (struct point2){5, 15}, (struct point2){25, 30});
    assert_int_equal(k.code[0], 1);
    assert_true(cohen_sutherland_next(&k));
    assert_point(k.end[0], 10, 18.75);
    cohen_sutherland_begin(&k, &w, (struct point2){15, 15}, (struct point2){35, 30});
    assert_false(cohen_sutherland_next(&k));
    assert_true(k.accepted);
    const unsigned regions[3][3] = {{5, 4, 6}, {1, 0, 2}, {9, 8, 10}};
    for (int y = 0; y < 3; y++)
        for (int x = 0; x < 3; x++)
            assert_int_equal(clip_region(&w, (struct point2){(float)(x * 25), (float)(y * 25)}),
                             regions[y][x]);
}

static void parameters_of_the_course(void **state)
{
    (void)state;
    const struct clip_window w = {10, 10, 100, 100};
    const float p[] = {-75, 75, 113, -113}, q[] = {-5, 95, 110, -20};
    struct point2 a = {5, 120}, b = {80, 7};
    struct liang_barsky k;
    assert_true(clip_liang_barsky_shown(&w, &a, &b, &k));
    assert_memory_equal(k.p, p, sizeof p);
    assert_memory_equal(k.q, q, sizeof q);
    assert_true(fabs(k.t1 - 20.0 / 113) < 1e-7 && fabs(k.t2 - 110.0 / 113) < 1e-7);
    assert_point(a, 18.2743, 100);
    assert_point(b, 78.0088, 10);
}

/* ---- polygons -------------------------------------------------------------------------------- */

static double area(const struct point2 *p, int count)
{
    double twice = 0;
    for (int i = 0; i < count; i++) {
        struct point2 a = p[i], b = p[(i + 1) % count];
        twice += (double)a.x * b.y - (double)b.x * a.y;
    }
    return twice / 2;
}

/* The integral of the line's height, held within the window, over the part of its run that is
 * within; by the middle of each stretch on which it is linear. */
static double swept(const struct clip_window *w, struct point2 a, struct point2 b)
{
    double x0 = fmin(fmax(a.x, w->x_min), w->x_max), x1 = fmin(fmax(b.x, w->x_min), w->x_max);
    if (x0 == x1)
        return 0;
    double slope = ((double)b.y - a.y) / ((double)b.x - a.x), at[4] = {x0, x0, x1, x1};
    if (slope != 0) {
        double low = a.x + (w->y_min - (double)a.y) / slope;
        double high = a.x + (w->y_max - (double)a.y) / slope;
        double first = (low < high) == (x0 < x1) ? low : high;
        double second = first == low ? high : low;
        at[1] = fmin(fmax(first, fmin(x0, x1)), fmax(x0, x1));
        at[2] = fmin(fmax(second, fmin(x0, x1)), fmax(x0, x1));
    }
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        double y = a.y + slope * ((at[i] + at[i + 1]) / 2 - a.x);
        sum += (at[i + 1] - at[i]) * (fmin(fmax(y, w->y_min), w->y_max) - w->y_min);
    }
    return sum;
}

/* Green's theorem: what a polygon covers of the window, with its sign. */
static double area_within(const struct clip_window *w, const struct point2 *p, int count)
{
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum -= swept(w, p[i], p[(i + 1) % count]);
    return sum;
}

static struct sutherland_hodgman clipped;

/* Any corners at all: concave, crossing themselves, beyond the window. */
static void polygons_keep_their_area(void **state)
{
    (void)state;
    for (int i = 0; i < 30000; i++) {
        struct point2 p[CLIP_POLYGON_MOST];
        int count = 3 + (int)random_below(i % 10 == 0 ? CLIP_POLYGON_MOST - 2 : 12);
        for (int k = 0; k < count; k++)
            p[k] = i % 2 ? (struct point2){random_float(10), random_float(10)}
                         : (struct point2){random_whole(6), random_whole(6)};
        struct clip_window w = {random_whole(6), random_whole(6), 0, 0};
        w.x_max = w.x_min + (float)random_below(8);
        w.y_max = w.y_min + (float)random_below(8);
        assert_true(clip_sutherland_hodgman(&clipped, &w, p, count));
        assert_true(clipped.count <= CLIP_POLYGON_ROOM);
        double want = area_within(&w, p, count);
        assert_true(fabs(area(clipped.corner, clipped.count) - want) < 2e-5 * count);
        for (int k = 0; k < clipped.count; k++)
            assert_true(clip_point(&w, clipped.corner[k]));
    }
}

/* A zigzag across the window makes the most corners of all. */
static void there_is_room_for_the_worst(void **state)
{
    (void)state;
    const struct clip_window w = {-1, -1, 1, 1};
    struct point2 p[CLIP_POLYGON_MOST];
    int most = 0;
    for (int turn = 0; turn < 2000; turn++) {
        for (int k = 0; k < CLIP_POLYGON_MOST; k++)
            p[k] = (struct point2){k % 2 ? 2.5f : -2.5f + random_float(2), random_float(2)};
        assert_true(clip_sutherland_hodgman(&clipped, &w, p, CLIP_POLYGON_MOST));
        most = clipped.count > most ? clipped.count : most;
        assert_true(clipped.count <= CLIP_POLYGON_ROOM);
    }
    assert_true(most > CLIP_POLYGON_MOST);
    assert_false(clip_sutherland_hodgman(&clipped, &w, p, CLIP_POLYGON_MOST + 1));
    assert_false(clip_sutherland_hodgman(&clipped, &w, p, 0));
}

static void a_pass_cuts_at_one_edge(void **state)
{
    (void)state;
    const struct clip_window w = {0, 0, 4, 4};
    const struct point2 p[] = {{2, -1}, {5, 2}, {2, 5}, {-1, 2}};
    const unsigned edges[] = {REGION_LEFT, REGION_RIGHT, REGION_BELOW, REGION_ABOVE};
    const int counts[] = {5, 6, 7, 8};
    assert_true(sutherland_hodgman_begin(&clipped, &w, p, 4));
    for (int i = 0; i < 4; i++) {
        assert_true(sutherland_hodgman_next(&clipped));
        assert_int_equal(clipped.edge, edges[i]);
        assert_int_equal(clipped.count, counts[i]);
    }
    assert_false(sutherland_hodgman_next(&clipped));
    assert_true(fabs(area(clipped.corner, clipped.count) - 14) < 1e-6);
}

/* A comb falls into its teeth; its back is outside. */
static void parts_stay_joined_by_doubled_edges(void **state)
{
    (void)state;
    const struct clip_window w = {0, 0, 10, 4};
    const struct point2 comb[] = {{1, 1}, {2, 6}, {3, 1}, {4, 1}, {5, 6},
                                  {6, 1}, {7, 1}, {7, 8}, {1, 8}};
    const struct point2 convex[] = {{1, 1}, {6, 2}, {5, 9}};
    assert_true(clip_sutherland_hodgman(&clipped, &w, convex, 3));
    assert_int_equal(clip_polygon_doubled(&w, clipped.corner, clipped.count), 0);
    assert_true(clip_sutherland_hodgman(&clipped, &w, comb, 9));
    assert_int_equal(clip_polygon_doubled(&w, clipped.corner, clipped.count), 3);
    const struct point2 whole[] = {{0, 0}, {10, 0}, {10, 4}, {0, 4}};
    assert_int_equal(clip_polygon_doubled(&w, whole, 4), 0);
}

/* ---- text ------------------------------------------------------------------------------------ */

static const struct clip_font font = {FONT_WIDTH, FONT_HEIGHT, font_row};

static bool lit(const char *text, int x, int y)
{
    int row = FONT_HEIGHT - 1 - y;
    return font_row(text[x / FONT_WIDTH], row) & 0x80 >> x % FONT_WIDTH;
}

/* Quarters of dots are counted one by one: what a rule shows is what lies in the window. */
static void text_is_what_lies_within(void **state)
{
    (void)state;
    enum { DOTS_X = 5 * FONT_WIDTH, PARTS = 4 };
    for (int i = 0; i < 600; i++) {
        static uint8_t seen[FONT_HEIGHT * PARTS][DOTS_X * PARTS];
        char text[6] = "";
        for (int k = 0; k < 5; k++)
            text[k] = (char)(33 + random_below(94));
        const struct clip_text t = {text, &font, {0, 0}, 1};
        struct clip_window w = {random_whole(DOTS_X * PARTS) / PARTS,
                                random_whole(FONT_HEIGHT * PARTS) / PARTS, 0, 0};
        w.x_max = w.x_min + (float)random_below(2 * DOTS_X * PARTS) / PARTS;
        w.y_max = w.y_min + (float)random_below(3 * FONT_HEIGHT * PARTS) / PARTS;
        enum clip_text_rule rule = (enum clip_text_rule)(i % 3);
        memset(seen, 0, sizeof seen);
        struct clip_text_parts p;
        for (clip_text_begin(&p, &t, &w, rule); clip_text_next(&p);)
            for (int y = (int)(p.part.y_min * PARTS); y < (int)(p.part.y_max * PARTS); y++)
                for (int x = (int)(p.part.x_min * PARTS); x < (int)(p.part.x_max * PARTS); x++)
                    seen[y][x]++;
        for (int y = 0; y < FONT_HEIGHT * PARTS; y++)
            for (int x = 0; x < DOTS_X * PARTS; x++) {
                float px = ((float)x + 0.5f) / PARTS, py = ((float)y + 0.5f) / PARTS;
                int cell = x / PARTS / FONT_WIDTH;
                float left = rule == CLIP_TEXT_STRING ? 0 : (float)(cell * FONT_WIDTH);
                float right = rule == CLIP_TEXT_STRING ? DOTS_X : left + FONT_WIDTH;
                bool want = rule == CLIP_TEXT_COMPONENT
                                ? px > w.x_min && px < w.x_max && py > w.y_min && py < w.y_max
                                : left >= w.x_min && right <= w.x_max && w.y_min <= 0 &&
                                      w.y_max >= FONT_HEIGHT;
                assert_int_equal(seen[y][x], want && lit(text, x / PARTS, y / PARTS));
            }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cohen_sutherland_is_exact),
        cmocka_unit_test(liang_barsky_is_exact),
        cmocka_unit_test(cohen_sutherland_takes_few_cuts),
        cmocka_unit_test(lines_through_corners_end),
        cmocka_unit_test(whole_numbers_are_decided_exactly),
        cmocka_unit_test(edges_belong_to_the_window),
        cmocka_unit_test(inverted_windows_hold_nothing),
        cmocka_unit_test(codes_and_cuts_of_the_course),
        cmocka_unit_test(parameters_of_the_course),
        cmocka_unit_test(polygons_keep_their_area),
        cmocka_unit_test(there_is_room_for_the_worst),
        cmocka_unit_test(a_pass_cuts_at_one_edge),
        cmocka_unit_test(parts_stay_joined_by_doubled_edges),
        cmocka_unit_test(text_is_what_lies_within),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
