/* circles.c — midpoint circles by octants, from the top and from the side, and the ellipse's two
 * regions. */
#include <stdio.h>

#include "roms/geometry/scalar.h"
#include "roms/lessons/lesson.h"
#include "roms/lessons/pages.h"
#include "roms/raster/circle_midpoint.h"
#include "roms/raster/circle_midpoint_side.h"
#include "roms/raster/ellipse_midpoint.h"
#include "roms/stage/grid.h"

enum figure { TOP, SIDE, ELLIPSE, FIGURES };

enum {
    SMALLEST = 4,
    LARGEST = 16,
    GRID_WIDTH = 800,
    TABLE_LEFT = 810,
    TABLE_TOP = 720,
    ROW = 34,   /* from row to row of the table, stage units */
    ROWS = 20,  /* of the table, at most */
    SIDES = 64, /* of the ideal */
    TEXT = 48,
};

static struct rounds {
    enum figure figure;
    int r;
    int more;   /* decisions by keys */
    float step; /* decisions that were taken, in fractions */
    int row;    /* of the table that is written next */
} the_rounds;

static struct pages pages;

static void begin(void *own)
{
    *(struct rounds *)own = (struct rounds){.r = 8};
}

static void turn(void *own, int page)
{
    struct rounds *c = own;
    if (page == TOP && c->figure == ELLIPSE) /* a round is over: larger circles */
        c->r = c->r + 2 > LARGEST ? SMALLEST : c->r + 2;
    c->figure = (enum figure)page;
    c->more = 0;
}

/* The same figure from the beginning. */
static void choose(struct rounds *c, int r)
{
    c->r = r < SMALLEST ? LARGEST : r > LARGEST ? SMALLEST : r;
    pages_go(&pages, (int)c->figure);
}

static bool key(void *own, int k)
{
    struct rounds *c = own;
    if (k == '+' || k == '=')
        choose(c, c->r + 1);
    else if (k == '-')
        choose(c, c->r - 1);
    else if (k == 'n')
        c->more++;
    else
        return false;
    return true;
}

/* rx of the ellipse; its ry is three quarters of it. */
static int rx(const struct rounds *c)
{
    return c->r;
}

static int ry(const struct rounds *c)
{
    return c->figure == ELLIPSE ? c->r * 3 / 4 : c->r;
}

/* ---- pixels and the table -------------------------------------------------------------------- */

static void light_4(const struct grid *g, int x, int y, const enum ink *ink)
{
    grid_pixel(g, x, y, ink[0]);
    grid_pixel(g, -x, y, ink[1]);
    grid_pixel(g, -x, -y, ink[2]);
    grid_pixel(g, x, -y, ink[3]);
}

static void light_8(const struct grid *g, int x, int y)
{
    static const enum ink upper[] = {INK_GREEN, INK_CYAN, INK_ORANGE, INK_VIOLET};
    static const enum ink sides[] = {INK_YELLOW, INK_BLUE, INK_RED, INK_BRIGHT};
    light_4(g, x, y, upper);
    light_4(g, y, x, sides);
}

static void write_row(struct rounds *c, struct stage *stage, const char *text, enum ink ink)
{
    stage_ink(stage, ink);
    stage_text(stage, TABLE_LEFT, (float)(TABLE_TOP - ROW * c->row++), text);
}

static void write_start(struct rounds *c, struct stage *stage, int x, int y)
{
    bool ellipse = c->figure == ELLIPSE;
    char text[TEXT];
    write_row(c, stage, ellipse ? "      p    x   y" : "  k     p    x   y", INK_TEXT);
    snprintf(text, sizeof text, "%*s%4d%4d", ellipse ? 8 : 10, "", x, y);
    write_row(c, stage, text, INK_TEXT);
}

/* The decision that is to be taken: the two pixels and the middle between them. */
static void show_choice(const struct grid *g, int x0, int y0, int x1, int y1)
{
    grid_candidate(g, x0, y0, INK_BRIGHT);
    grid_candidate(g, x1, y1, INK_BRIGHT);
    struct point2 at = grid_place(g, 0.5f * (float)(x0 + x1), 0.5f * (float)(y0 + y1));
    stage_ink(g->stage, INK_RED);
    stage_marker(g->stage, at.x, at.y);
}

/* What p says, in two lines: where the middle is, what follows. */
static void explain(struct stage *stage, int64_t p, const char *inside, const char *outside)
{
    char text[TEXT];
    snprintf(text, sizeof text, "p = %d %s 0: %s", (int)p,
             p < 0 ? "<" : ">=", p < 0 ? "inside" : "outside");
    stage_ink(stage, INK_BRIGHT);
    stage_text(stage, TABLE_LEFT, 60, text);
    stage_text(stage, TABLE_LEFT, 26, p < 0 ? inside : outside);
}

static void circle_row(struct rounds *c, struct stage *stage, int k, int p, int x, int y)
{
    char text[TEXT];
    snprintf(text, sizeof text, "%3d%6d %4d%4d", k, p, x, y);
    write_row(c, stage, text, p < 0 ? INK_CYAN : INK_YELLOW);
}

static void draw_top(struct rounds *c, const struct grid *g)
{
    struct circle_midpoint m;
    circle_midpoint_begin(&m, c->r);
    for (int p = m.p; m.k < (int)c->step && circle_midpoint_next(&m); p = m.p) {
        if (m.x <= m.y)
            light_8(g, m.x, m.y);
        if (m.k == 0)
            write_start(c, g->stage, m.x, m.y);
        else
            circle_row(c, g->stage, m.k - 1, p, m.x, m.y);
    }
    if (m.x >= m.y)
        return;
    show_choice(g, m.x + 1, m.y, m.x + 1, m.y - 1);
    explain(g->stage, m.p, "y stays", "y steps");
}

static void draw_side(struct rounds *c, const struct grid *g)
{
    struct circle_midpoint_side m;
    circle_midpoint_side_begin(&m, c->r);
    for (int p = m.p; m.k < (int)c->step && circle_midpoint_side_next(&m); p = m.p) {
        if (m.y <= m.x)
            light_8(g, m.y, m.x);
        if (m.k == 0)
            write_start(c, g->stage, m.x, m.y);
        else
            circle_row(c, g->stage, m.k - 1, p, m.x, m.y);
    }
    if (m.y >= m.x)
        return;
    show_choice(g, m.x, m.y + 1, m.x - 1, m.y + 1);
    explain(g->stage, m.p, "x stays", "x steps");
}

static void draw_ellipse(struct rounds *c, const struct grid *g)
{
    static const enum ink inks[][4] = {{INK_GREEN, INK_GREEN, INK_GREEN, INK_GREEN},
                                       {INK_ORANGE, INK_ORANGE, INK_ORANGE, INK_ORANGE}};
    struct ellipse_midpoint m;
    char text[TEXT];
    ellipse_midpoint_begin(&m, rx(c), ry(c));
    int64_t p = m.p;
    int region = 1;
    while (m.k < (int)c->step && ellipse_midpoint_next(&m)) {
        light_4(g, m.x, m.y, inks[region > 1]);
        snprintf(text, sizeof text, "%7d %4d%4d", (int)p, m.x, m.y);
        if (m.k == 0)
            write_start(c, g->stage, m.x, m.y);
        else if (c->row < ROWS)
            write_row(c, g->stage, text, region == 1 ? INK_GREEN : INK_ORANGE);
        p = m.p;
        region = m.region;
    }
    if (m.region == 1) {
        show_choice(g, m.x + 1, m.y, m.x + 1, m.y - 1);
        explain(g->stage, m.p, "region 1: y stays", "region 1: y steps");
    } else if (m.region == 2) {
        show_choice(g, m.x, m.y - 1, m.x + 1, m.y - 1);
        explain(g->stage, m.p, "region 2: x steps", "region 2: x stays");
    }
}

static void draw_ideal(const struct rounds *c, const struct grid *g)
{
    struct point2 last = {(float)rx(c), 0};
    for (int i = 1; i <= SIDES; i++) {
        float angle = TURN / SIDES * (float)i;
        struct point2 at = {(float)rx(c) * cosf(angle), (float)ry(c) * sinf(angle)};
        grid_line(g, last.x, last.y, at.x, at.y, INK_BRIGHT);
        last = at;
    }
}

/* The borders of octants, or of the ellipse's regions: where its slope is -1. */
static void draw_borders(const struct rounds *c, const struct grid *g)
{
    float a = (float)rx(c), b = (float)ry(c), far = (float)(c->r + 1);
    float x = a * a, y = b * b, scale = far / fmaxf(x, y);
    x *= scale;
    y *= scale;
    grid_line(g, -x, -y, x, y, INK_BLUE);
    grid_line(g, -x, y, x, -y, INK_BLUE);
    if (c->figure != ELLIPSE) {
        grid_line(g, -far, 0, far, 0, INK_BLUE);
        grid_line(g, 0, -far, 0, far, INK_BLUE);
    }
}

/* How many decisions the figure takes. */
static int decisions(const struct rounds *c)
{
    int count = 0;
    if (c->figure == ELLIPSE) {
        struct ellipse_midpoint e;
        ellipse_midpoint_begin(&e, rx(c), ry(c));
        while (ellipse_midpoint_next(&e))
            count = e.k;
    } else {
        struct circle_midpoint m;
        circle_midpoint_begin(&m, c->r);
        while (circle_midpoint_next(&m))
            count = m.k;
    }
    return count;
}

static float draw(void *own, struct stage *stage, int page, float seconds)
{
    const float speed = 2.5f; /* decisions a second */
    const int rest = 6;
    static const char *const names[] = {
        "Midpoint circle from (0,%d)", "Midpoint circle from (%d,0)", "Midpoint ellipse, %d by %d"};
    static const char *const captions[] = {
        "An eighth is computed: each of its pixels has seven images.",
        "From the side y steps and x is chosen: the same pixels.",
        "Region 1 steps in x, region 2 in y; between them the slope is -1.",
    };
    struct rounds *c = own;
    char text[TEXT];
    c->step = seconds * speed + (float)c->more;
    struct grid grid = grid_fit(stage, 0, 0, GRID_WIDTH, STAGE_HEIGHT, -c->r, -ry(c), c->r, ry(c));
    c->row = 0;
    grid_rules(&grid);
    draw_borders(c, &grid);
    if (c->figure == TOP)
        draw_top(c, &grid);
    else if (c->figure == SIDE)
        draw_side(c, &grid);
    else
        draw_ellipse(c, &grid);
    draw_ideal(c, &grid);
    snprintf(text, sizeof text, names[page], rx(c), ry(c));
    stage_title(stage, text);
    stage_caption(stage, captions[page]);
    return (float)(decisions(c) + rest - c->more) / speed;
}

static struct pages pages = {.count = FIGURES,
                             .again = 0.03f,
                             .own = &the_rounds,
                             .begin = begin,
                             .turn = turn,
                             .draw = draw,
                             .key = key};

extern const struct lesson lesson_circles;
const struct lesson lesson_circles = {"circles",
                                      "Circles and ellipses",
                                      PAGES_TURN "  n step  + - radius",
                                      &pages,
                                      pages_begin,
                                      pages_key,
                                      pages_draw};
