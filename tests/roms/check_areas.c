/* check_areas — in the machine: areas, line attributes and dithering on random cases, a line a
 * property. Exits 0 when all hold. */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "roms/bsp/board.h"
#include "roms/raster/boundary_fill.h"
#include "roms/raster/dither.h"
#include "roms/raster/flood_fill.h"
#include "roms/raster/line_antialiased.h"
#include "roms/raster/line_dashed.h"
#include "roms/raster/line_thick.h"
#include "roms/raster/pixel.h"
#include "roms/raster/polygon_fill.h"

enum { WIDTH = 44, HEIGHT = 34, SEEDS = 600 };

static const unsigned formats[] = {1, 2, 4, 8, 16, 32};

static struct {
    uint32_t words[WIDTH * HEIGHT + HEIGHT];
    struct span_seed seeds[SEEDS];
    uint8_t reached[HEIGHT][WIDTH];
    int16_t queue[WIDTH * HEIGHT];
    uint32_t state;
    bool failed;
} rig = {.state = 20260101};

static uint32_t random_below(uint32_t limit)
{
    rig.state = rig.state * 1664525u + 1013904223u;
    return (rig.state >> 8) % limit;
}

static float random_within(float low, float high)
{
    return low + (high - low) * (float)random_below(65536) / 65536;
}

static struct canvas canvas_of(unsigned bits)
{
    memset(rig.words, 0, sizeof rig.words);
    return (struct canvas){.pixels = (uint8_t *)rig.words,
                           .pitch = canvas_pitch(WIDTH, bits),
                           .width = WIDTH,
                           .height = HEIGHT,
                           .bits = bits,
                           .dots_a_row = 1};
}

static void tell(int cases, const char *property, int failures)
{
    printf("%d %s%s\n", cases, property, failures == 0 ? "" : ": FAILED");
    rig.failed = rig.failed || failures > 0;
}

/* ---- polygons -------------------------------------------------------------------------------- */

/* In 1/64 pixel, as the library rounds. */
static int32_t part(float v)
{
    return (int32_t)floorf(v * 64 + 0.5f);
}

static bool belongs(const struct point2 *p, int count, int x, int y, enum polygon_rule rule)
{
    int crossings = 0, winding = 0;
    for (int i = 0; i < count; i++) {
        struct point2 a = p[i], b = p[i + 1 < count ? i + 1 : 0];
        int32_t x0 = part(a.x), y0 = part(a.y), x1 = part(b.x), y1 = part(b.y);
        bool down = y0 < y1;
        int32_t top = down ? y0 : y1, low = down ? y1 : y0;
        if (top > 64 * y || low <= 64 * y)
            continue;
        int32_t from = down ? x0 : x1, to = down ? x1 : x0;
        if (from * (low - top) + (to - from) * (64 * y - top) > 64 * x * (low - top))
            continue;
        crossings++;
        winding += down ? 1 : -1;
    }
    return rule == POLYGON_EVEN_ODD ? crossings % 2 == 1 : winding != 0;
}

static void check_polygons(void)
{
    enum { CASES = 48 };
    int wrong = 0;
    for (int i = 0; i < CASES; i++) {
        struct canvas c = canvas_of(formats[i % 6]);
        enum polygon_rule rule = i % 4 < 2 ? POLYGON_EVEN_ODD : POLYGON_NON_ZERO;
        struct point2 p[8];
        int count = 3 + (int)random_below(6);
        for (int k = 0; k < count; k++) {
            p[k] = (struct point2){random_within(-9, WIDTH + 9), random_within(-9, HEIGHT + 9)};
            if (i % 3 == 0)
                p[k] = (struct point2){floorf(p[k].x), floorf(p[k].y)};
        }
        canvas_polygon(&c, p, count, rule, 1);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++)
                wrong += (canvas_pixel(&c, x, y) != 0) != belongs(p, count, x, y, rule);
    }
    tell(CASES, "polygons: the pixels whose middle is inside, by both rules, in every format",
         wrong);
}

/* Triangles about a point, out to a rectangle: each pixel once. */
static void check_tilings(void)
{
    enum { CASES = 40, RIM = 8 };
    static const struct point2 rim[RIM] = {{-1, -1},        {20, -1},     {WIDTH, -1},  {WIDTH, 15},
                                           {WIDTH, HEIGHT}, {25, HEIGHT}, {-1, HEIGHT}, {-1, 12}};
    int wrong = 0;
    for (int i = 0; i < CASES; i++) {
        static uint8_t times[HEIGHT][WIDTH];
        struct point2 middle = {random_within(1, WIDTH - 2), random_within(1, HEIGHT - 2)};
        memset(times, 0, sizeof times);
        for (int k = 0; k < RIM; k++) {
            struct canvas c = canvas_of(8);
            const struct point2 p[3] = {middle, rim[k], rim[(k + 1) % RIM]};
            canvas_polygon(&c, p, 3, POLYGON_NON_ZERO, 1);
            for (int y = 0; y < HEIGHT; y++)
                for (int x = 0; x < WIDTH; x++)
                    times[y][x] =
                        (uint8_t)(times[y][x] + c.pixels[(uint32_t)y * c.pitch + (uint32_t)x]);
        }
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++)
                wrong += times[y][x] != 1;
    }
    tell(CASES, "tilings: areas that share an edge share no pixel and leave no gap", wrong);
}

/* ---- connected areas ------------------------------------------------------------------------- */

static int search(const struct canvas *c, int x, int y, int connected, uint32_t limit)
{
    int tail = 0;
    memset(rig.reached, 0, sizeof rig.reached);
    rig.reached[y][x] = 1;
    rig.queue[tail++] = (int16_t)(y * WIDTH + x);
    for (int head = 0; head < tail; head++)
        for (int k = 0; k < 9; k++) {
            int nx = rig.queue[head] % WIDTH + k % 3 - 1, ny = rig.queue[head] / WIDTH + k / 3 - 1;
            if ((connected == 4 && k % 2 == 0) || !canvas_holds(c, nx, ny) || rig.reached[ny][nx] ||
                canvas_pixel(c, nx, ny) != limit)
                continue;
            rig.reached[ny][nx] = 1;
            rig.queue[tail++] = (int16_t)(ny * WIDTH + nx);
        }
    return tail;
}

static void check_floods(void)
{
    enum { CASES = 48 };
    int wrong = 0;
    for (int i = 0; i < CASES; i++) {
        struct canvas c = canvas_of(formats[1 + i % 5]);
        int x = (int)random_below(WIDTH), y = (int)random_below(HEIGHT), connected = i % 2 ? 4 : 8;
        for (int k = 0; k < WIDTH * HEIGHT; k++)
            if (random_below(2 + (uint32_t)i % 4) == 0)
                canvas_dot(&c, k % WIDTH, k / WIDTH, 1);
        canvas_dot(&c, x, y, 0);
        search(&c, x, y, connected, 0);
        bool complete = i % 4 < 2
                            ? canvas_flood_fill(&c, x, y, connected, 3, rig.seeds, SEEDS)
                            : canvas_boundary_fill(&c, x, y, connected, 1, 3, rig.seeds, SEEDS);
        wrong += !complete;
        for (int py = 0; py < HEIGHT; py++)
            for (int px = 0; px < WIDTH; px++)
                wrong += (canvas_pixel(&c, px, py) == 3) != (rig.reached[py][px] != 0);
    }
    tell(CASES, "flood and boundary fills: what a search pixel by pixel reaches", wrong);
}

/* ---- lines ----------------------------------------------------------------------------------- */

static void check_antialiased(void)
{
    enum { CASES = 500 };
    int wrong = 0;
    for (int i = 0; i < CASES; i++) {
        float x0 = random_within(0, 200), y0 = random_within(0, 200);
        float x1 = random_within(0, 200), y1 = random_within(0, 200);
        float dx = x1 - x0, dy = y1 - y0, length = sqrtf(dx * dx + dy * dy);
        float longer = fmaxf(fabsf(dx), fabsf(dy)), sum = 0;
        struct line_antialiased line;
        struct antialiased_column k;
        line_antialiased_begin(&line, x0, y0, x1, y1);
        while (line_antialiased_next(&line, &k))
            for (int n = 0; n < ANTIALIASED_PIXELS; n++)
                sum += (float)k.coverage[n] / 255;
        float expected = longer > 0 ? length * (longer + 1) / longer : 1;
        wrong += fabsf(sum - expected) > 0.02f * expected + 0.05f;
    }
    tell(CASES, "antialiased lines: their light is their length, within 2 %", wrong);
}

static void check_dashes(void)
{
    enum { CASES = 100 };
    static const struct dash_pattern pattern = {{7, 3, 2, 3}, 4};
    const float total = 15;
    int wrong = 0;
    for (int i = 0; i < CASES; i++) {
        struct dash_phase phase = {0};
        float along = 0;
        int at[4][2], x, y;
        for (int k = 0; k < 4; k++)
            at[k][0] = (int)random_below(60), at[k][1] = (int)random_below(60);
        for (int k = 0; k < 3; k++) {
            float dx = (float)(at[k + 1][0] - at[k][0]), dy = (float)(at[k + 1][1] - at[k][1]);
            float length = sqrtf(dx * dx + dy * dy), longer = fmaxf(fabsf(dx), fabsf(dy));
            struct line_dashed line;
            bool on;
            line_dashed_begin(&line, at[k][0], at[k][1], at[k + 1][0], at[k + 1][1], &pattern,
                              &phase);
            for (int n = 0; line_dashed_next(&line, &x, &y, &on); n++) {
                float here = along + (longer > 0 ? (float)n * length / longer : 0);
                here -= total * floorf(here / total);
                bool expected = here < 7 || (here >= 10 && here < 12);
                bool near = fabsf(here - 7) < 0.05f || fabsf(here - 10) < 0.05f ||
                            fabsf(here - 12) < 0.05f || here < 0.05f || here > 14.95f;
                wrong += !near && on != expected;
            }
            along += length;
        }
    }
    tell(CASES, "dashed polylines: on and off by the distance along them, around corners", wrong);
}

static void check_thick(void)
{
    enum { CASES = 30 };
    int wrong = 0;
    for (int i = 0; i < CASES; i++) {
        struct canvas c = canvas_of(8);
        struct line_style style = {random_within(1, 12), CAP_ROUND, JOIN_ROUND};
        struct point2 a = {random_within(0, WIDTH), random_within(0, HEIGHT)};
        struct point2 b = {random_within(0, WIDTH), random_within(0, HEIGHT)}, p[2] = {a, b};
        float dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
        canvas_line_thick(&c, p, 2, false, &style, 1);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                float px = (float)x - a.x, py = (float)y - a.y;
                float t = square > 0 ? fminf(fmaxf((px * dx + py * dy) / square, 0), 1) : 0;
                float qx = px - t * dx, qy = py - t * dy, d = sqrtf(qx * qx + qy * qy);
                if (fabsf(d - style.width / 2) > 0.09f)
                    wrong += (canvas_pixel(&c, x, y) != 0) != (d < style.width / 2);
            }
    }
    tell(CASES, "wide lines with round caps: what is within half their width", wrong);
}

static void check_dither(void)
{
    enum { CASES = 16, SIDE = 64 };
    static float error[SIDE + 2];
    int wrong = 0;
    for (int i = 0; i < CASES; i++) {
        int levels = 2 + (int)random_below(7), ordered = 0, diffused = 0;
        float v = random_within(0, 1), scale = SIDE * SIDE * (float)(levels - 1);
        struct dither_diffusion d;
        dither_diffusion_begin(&d, error, SIDE, levels);
        for (int y = 0; y < SIDE; y++)
            for (int x = 0; x < SIDE; x++) {
                ordered += dither_ordered(DITHER_ORDERED_8, levels, x, y, v);
                diffused += dither_diffusion_next(&d, v);
            }
        wrong += fabsf((float)ordered / scale - v) > 0.009f;
        wrong += fabsf((float)diffused / scale - v) > 0.009f;
    }
    tell(CASES, "dithered areas: their mean is the intensity, within 1 %", wrong);
}

int main(void)
{
    check_polygons();
    check_tilings();
    check_floods();
    check_antialiased();
    check_dashes();
    check_thick();
    check_dither();
    return rig.failed;
}
