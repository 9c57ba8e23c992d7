/* gallery_plotting.c — plotting: a line, a bar and a pie chart, and a function of two variables. */
#include "roms/lessons/gallery_plotting.h"

#include <math.h>
#include <stdio.h>

#include "roms/geometry/scalar.h"
#include "roms/lessons/lesson.h"
#include "roms/lessons/pages.h"
#include "roms/raster/line_thick.h"

struct point2 plot_canvas(const struct stage *s, struct point2 p)
{
    return (struct point2){stage_canvas_x(s, p.x), stage_canvas_y(s, p.y)};
}

void plot_polyline(struct stage *s, const struct point2 *p, int count, float width, enum ink ink)
{
    enum { MOST = 160 };
    const struct line_style style = {width, CAP_BUTT, JOIN_BEVEL};
    struct point2 q[MOST];
    count = count < MOST ? count : MOST;
    for (int i = 0; i < count; i++)
        q[i] = plot_canvas(s, p[i]);
    canvas_line_thick(&s->canvas, q, count, false, &style, ink);
    stage_heads(s, STAGE_VECTOR);
    stage_ink(s, ink);
    stage_polyline(s, p, count);
    stage_heads(s, STAGE_BOTH);
}

/* ---- axes ------------------------------------------------------------------------------------ */

enum { LEFT = 90, RIGHT = 1150, BOTTOM = 90, TOP = 700 };

struct axes {
    float x0, x1, y1; /* what is shown; y from 0 */
};

static struct point2 place(const struct axes *a, float x, float y)
{
    return (struct point2){LEFT + (x - a->x0) / (a->x1 - a->x0) * (RIGHT - LEFT),
                           BOTTOM + y / a->y1 * (TOP - BOTTOM)};
}

/* 1, 2 or 5 times a power of ten: about a fifth of it. */
static float tick(float range)
{
    float power = powf(10, floorf(log10f(range / 5))), digit = range / 5 / power;
    return power * (digit < 1.5f ? 1 : digit < 3.5f ? 2 : digit < 7.5f ? 5 : 10);
}

static void draw_axes(struct stage *s, const struct axes *a, const char *x_name, const char *y_name)
{
    char text[16];
    float dx = tick(a->x1 - a->x0), dy = tick(a->y1);
    stage_ink(s, INK_GRID);
    for (float y = 0; y <= a->y1 * 1.001f; y += dy) {
        struct point2 p = place(a, a->x0, y);
        stage_line(s, LEFT, p.y, RIGHT, p.y);
    }
    for (float x = ceilf(a->x0 / dx) * dx; x <= a->x1; x += dx) {
        struct point2 p = place(a, x, 0);
        stage_line(s, p.x, BOTTOM - 8, p.x, BOTTOM);
    }
    stage_ink(s, INK_TEXT);
    for (float y = 0; y <= a->y1 * 1.001f; y += dy) {
        snprintf(text, sizeof text, "%g", (double)y);
        stage_text_middle(s, LEFT - 44, place(a, 0, y).y - 8, text);
    }
    for (float x = ceilf(a->x0 / dx) * dx; x <= a->x1; x += dx) {
        snprintf(text, sizeof text, "%g", (double)x);
        stage_text_middle(s, place(a, x, 0).x, BOTTOM - 34, text);
    }
    stage_text_middle(s, (LEFT + RIGHT) / 2, BOTTOM - 72, x_name);
    stage_text(s, LEFT, TOP + 30, y_name);
}

/* ---- lines: hares and lynxes ----------------------------------------------------------------- */

struct animals {
    float hares, lynxes;
};

/* Lotka's and Volterra's equations. */
static struct animals change(struct animals a)
{
    return (struct animals){a.hares * (1.0f - 0.04f * a.lynxes),
                            a.lynxes * (0.016f * a.hares - 0.7f)};
}

static struct animals moved(struct animals a, struct animals by, float k)
{
    return (struct animals){a.hares + k * by.hares, a.lynxes + k * by.lynxes};
}

/* A step after Runge and Kutta. */
static struct animals later(struct animals a, float h)
{
    struct animals k1 = change(a), k2 = change(moved(a, k1, h / 2));
    struct animals k3 = change(moved(a, k2, h / 2)), k4 = change(moved(a, k3, h));
    a = moved(moved(a, k1, h / 6), k2, h / 3);
    return moved(moved(a, k3, h / 3), k4, h / 6);
}

static void legend(struct stage *s, float x, enum ink ink, const char *name)
{
    const struct point2 p[2] = {{x, TOP + 38}, {x + 60, TOP + 38}};
    plot_polyline(s, p, 2, 4, ink);
    stage_ink(s, INK_TEXT);
    stage_text(s, x + 75, TOP + 30, name);
}

void plot_lines(struct stage *s, float seconds)
{
    enum { POINTS = 150 };
    const float years = 24, h = years / POINTS;
    struct point2 hares[POINTS + 1], lynxes[POINTS + 1];
    struct axes axes = {0, years, 150};
    struct animals a = {30, 8};
    int shown = (int)(seconds * 22) + 2;
    shown = shown < POINTS + 1 ? shown : POINTS + 1;
    for (int i = 0; i < shown; i++, a = later(a, h)) {
        hares[i] = place(&axes, (float)i * h, a.hares);
        lynxes[i] = place(&axes, (float)i * h, a.lynxes);
    }
    draw_axes(s, &axes, "years", "thousands");
    legend(s, 420, INK_CYAN, "hares");
    legend(s, 720, INK_ORANGE, "lynxes");
    plot_polyline(s, hares, shown, 4, INK_CYAN);
    plot_polyline(s, lynxes, shown, 4, INK_ORANGE);
}

/* ---- bars: sums of dice ---------------------------------------------------------------------- */

enum { DICE = 3, SUMS = 6 * DICE + 1 };

static void throw_dice(int throws, int *times)
{
    uint32_t state = 1973;
    for (int i = 0; i < throws; i++) {
        int sum = 0;
        for (int k = 0; k < DICE; k++) {
            state = state * 1664525u + 1013904223u;
            sum += 1 + (int)((state >> 16) * 6 >> 16);
        }
        times[sum]++;
    }
}

static void bar(struct stage *s, const struct axes *a, float x, float height, enum ink ink)
{
    struct point2 low = place(a, x - 0.4f, 0), high = place(a, x + 0.4f, height);
    const struct point2 p[4] = {low, {high.x, low.y}, high, {low.x, high.y}};
    stage_ink(s, ink);
    stage_area(s, p, 4);
}

void plot_bars(struct stage *s, float seconds)
{
    enum { CURVE = 60 };
    struct axes axes = {2, 19, 16};
    int times[SUMS] = {0}, throws = 10 + (int)(seconds * seconds * 30);
    struct point2 normal[CURVE];
    char text[40];
    throws = throws < 4000 ? throws : 4000;
    throw_dice(throws, times);
    draw_axes(s, &axes, "sum of three dice", "percent");
    for (int sum = DICE; sum < SUMS; sum++)
        bar(s, &axes, (float)sum, 100.0f * (float)times[sum] / (float)throws, INK_GREEN);
    for (int i = 0; i < CURVE; i++) {
        const float mean = DICE * 3.5f, variance = DICE * 35.0f / 12;
        float x = 2 + 17 * (float)i / (CURVE - 1), d = x - mean;
        normal[i] = place(&axes, x, 100 * expf(-d * d / (2 * variance)) / sqrtf(TURN * variance));
    }
    plot_polyline(s, normal, CURVE, 4, INK_YELLOW);
    snprintf(text, sizeof text, "%d throws", throws);
    stage_ink(s, INK_BRIGHT);
    stage_text(s, 880, TOP + 30, text);
}

/* ---- pie: factors of numbers ----------------------------------------------------------------- */

enum { MOST = 1000, SLICES = 5 };

/* How many numbers up to `most` have 1, 2, 3, 4, more prime factors. */
static void count_factors(int most, int *times)
{
    for (int n = 2; n <= most; n++) {
        int rest = n, factors = 0;
        for (int d = 2; d * d <= rest; d += 1 + (d > 2))
            for (; rest % d == 0; rest /= d)
                factors++;
        factors += rest > 1;
        times[(factors < SLICES ? factors : SLICES) - 1]++;
    }
}

static void slice(struct stage *s, float from, float to, float out, enum ink ink)
{
    enum { ARC = 24, RADIUS = 310 };
    const struct point2 middle = {400 + out * cosf((from + to) / 2),
                                  400 + out * sinf((from + to) / 2)};
    struct point2 p[ARC + 2] = {middle};
    for (int i = 0; i <= ARC; i++) {
        float angle = from + (to - from) * (float)i / ARC;
        p[i + 1] =
            (struct point2){middle.x + RADIUS * cosf(angle), middle.y + RADIUS * sinf(angle)};
    }
    stage_ink(s, ink);
    stage_area(s, p, ARC + 2);
}

static void pie_legend(struct stage *s, int line, enum ink ink, const char *name, float part)
{
    char text[40];
    float y = 600 - (float)line * 80;
    const struct point2 p[4] = {{790, y}, {830, y}, {830, y + 36}, {790, y + 36}};
    stage_ink(s, ink);
    stage_area(s, p, 4);
    snprintf(text, sizeof text, "%s %4.1f %%", name, (double)(100 * part));
    stage_ink(s, INK_TEXT);
    stage_text(s, 850, y + 9, text);
}

void plot_pie(struct stage *s, float seconds)
{
    static const char *const names[SLICES] = {"prime     ", "2 factors ", "3 factors ",
                                              "4 factors ", "more      "};
    static const enum ink inks[SLICES] = {INK_CYAN, INK_BLUE, INK_VIOLET, INK_ORANGE, INK_YELLOW};
    int times[SLICES] = {0}, most = 10 + (int)(seconds * seconds * 12);
    float from = TURN / 4;
    char text[40];
    most = most < MOST ? most : MOST;
    count_factors(most, times);
    for (int i = 0; i < SLICES; i++) {
        float part = (float)times[i] / (float)(most - 1), to = from - part * TURN;
        bool pulled = (int)(seconds / 1.5f) % SLICES == i;
        if (times[i] > 0)
            slice(s, from, to, pulled ? 40 : 8, inks[i]);
        pie_legend(s, i, inks[i], names[i], part);
        from = to;
    }
    snprintf(text, sizeof text, "numbers from 2 to %d", most);
    stage_ink(s, INK_BRIGHT);
    stage_text(s, 790, 700, text);
}

/* ---- the program ----------------------------------------------------------------------------- */

static const struct page table[] = {
    {"A line chart",
     "Lotka's and Volterra's equations, integrated here after Runge and Kutta: the hunters follow "
     "the hunted.",
     15, plot_lines},
    {"A bar chart",
     "Dice are thrown here; the more of them, the nearer their sums come to the normal "
     "distribution.",
     15, plot_bars},
    {"A pie chart", "Numbers by how many prime factors they have: primes become rare.", 15,
     plot_pie},
    {"A function of two variables",
     "Waves from two places, with hidden parts left out: pixels from back to front; lines from "
     "front to back, above or below all before.",
     15, plot_surface},
};

static struct pages pages = {
    .page = table, .count = sizeof table / sizeof table[0], .again = 0.04f};

extern const struct lesson lesson_gallery_plotting;
const struct lesson lesson_gallery_plotting = {"plotting",  "Gallery: plotting", PAGES_KEYS, &pages,
                                               pages_begin, pages_key,           pages_draw};
