/* areas_polygon.c — pages: a polygon scan line by scan line; a star by both rules. */
#include <math.h>
#include <stdio.h>

#include "roms/geometry/scalar.h"
#include "roms/lessons/areas.h"
#include "roms/raster/polygon_fill.h"
#include "roms/stage/grid.h"

/* ---- scan lines ------------------------------------------------------------------------------ */

enum { CORNERS = 9, RIGHT = 26, TOP = 17 };

static const struct point2 shape[CORNERS] = {{1, 1},   {5, 16}, {10, 7}, {14, 15}, {18, 9},
                                             {25, 13}, {22, 2}, {15, 5}, {9, 0}};

static float crossing(const struct polygon_edge *e)
{
    return ((float)e->x - (float)e->over / (float)e->height) / POLYGON_PARTS;
}

static void pixels_of_row(const struct grid *grid, struct polygon_fill *f, enum ink ink)
{
    struct polygon_run run;
    while (polygon_fill_run(f, &run))
        grid_run(grid, -f->y, run.x0, run.x1 - 1, ink);
}

/* The active edges, and where they cross the row. */
static void active(const struct grid *grid, const struct polygon_fill *f)
{
    float y = (float)-f->y;
    grid_line(grid, 0, y, RIGHT, y, INK_RED);
    for (int i = 0; i < f->active_count; i++) {
        const struct polygon_edge *e = &f->edge[f->active[i]];
        struct point2 at = grid_place(grid, crossing(e), y);
        grid_line(grid, e->a.x, -e->a.y, e->b.x, -e->b.y, INK_YELLOW);
        stage_ink(grid->stage, INK_RED);
        stage_rectangle(grid->stage, at.x - 6, at.y - 6, 12, 12);
    }
}

static void list_active(struct stage *s, const struct polygon_fill *f)
{
    enum { LEFT = 905, FIRST = 700, APART = 40 };
    char text[32];
    float y = FIRST;
    stage_ink(s, INK_BRIGHT);
    snprintf(text, sizeof text, "row %d", -f->y);
    stage_text(s, LEFT, y, text);
    stage_ink(s, INK_YELLOW);
    snprintf(text, sizeof text, "%d active edges", f->active_count);
    stage_text(s, LEFT, y -= 2 * APART, text);
    for (int i = 0; i < f->active_count; i++) {
        const struct polygon_edge *e = &f->edge[f->active[i]];
        snprintf(text, sizeof text, "  x = %6.2f", (double)crossing(e));
        stage_text(s, LEFT, y -= APART, text);
    }
    y -= APART;
    stage_ink(s, INK_CYAN);
    stage_text(s, LEFT, y -= APART, "pixels in pairs");
    struct polygon_fill row = *f;
    struct polygon_run run;
    while (polygon_fill_run(&row, &run)) {
        snprintf(text, sizeof text, "  %d ... %d", run.x0, run.x1 - 1);
        stage_text(s, LEFT, y -= APART, text);
    }
}

void areas_scan_lines(struct stage *s, float seconds)
{
    struct polygon_fill f;
    struct point2 down[CORNERS];
    int rows = (int)(seconds * 1.3f) + 1;
    struct grid grid = grid_fit(s, 0, 0, 900, STAGE_HEIGHT, 0, 0, RIGHT, TOP);
    for (int i = 0; i < CORNERS; i++)
        down[i] = (struct point2){shape[i].x, -shape[i].y};
    polygon_fill_begin(&f, POLYGON_EVEN_ODD, -TOP, 0);
    polygon_fill_contour(&f, down, CORNERS);
    grid_rules(&grid);
    bool going = true;
    for (int i = 1; i < rows && (going = polygon_fill_row(&f)); i++)
        pixels_of_row(&grid, &f, INK_CYAN);
    for (int i = 0; i < CORNERS; i++) {
        struct point2 a = shape[i], b = shape[(i + 1) % CORNERS];
        grid_line(&grid, a.x, a.y, b.x, b.y, INK_BRIGHT);
    }
    if (going && polygon_fill_row(&f)) {
        list_active(s, &f);
        pixels_of_row(&grid, &f, INK_GREEN);
        active(&grid, &f);
    }
}

/* ---- the rules ------------------------------------------------------------------------------- */

/* A star of so many points, each joined with that `skip` further on. */
static int star(struct point2 *p, int points, int skip, float x, float y, float r, float turn)
{
    for (int i = 0; i < points; i++) {
        float angle = PI / 2 + turn + TURN * (float)(i * skip % points) / (float)points;
        p[i] = (struct point2){x + r * cosf(angle), y + r * sinf(angle)};
    }
    return points;
}

/* The vector head's runs: every so many stage units a line. */
static void hatch(struct stage *s, const struct point2 *p, int count, enum polygon_rule rule)
{
    enum { APART = 14 };
    struct polygon_fill f;
    struct polygon_run run;
    polygon_fill_begin(&f, rule, 0, STAGE_HEIGHT);
    polygon_fill_contour(&f, p, count);
    stage_heads(s, STAGE_VECTOR);
    stage_ink(s, INK_BROWN);
    while (polygon_fill_row(&f)) {
        while (f.y % APART == 0 && polygon_fill_run(&f, &run))
            stage_line(s, (float)run.x0, (float)f.y, (float)run.x1, (float)f.y);
    }
    stage_heads(s, STAGE_BOTH);
}

/* Edges to the right of a place: how many, or how often they go around it. */
static int counted(const struct point2 *p, int count, struct point2 at, enum polygon_rule rule)
{
    int crossings = 0, winding = 0;
    for (int i = 0; i < count; i++) {
        struct point2 a = p[i], b = p[(i + 1) % count];
        if ((a.y <= at.y) == (b.y <= at.y) || a.x + (at.y - a.y) * (b.x - a.x) / (b.y - a.y) < at.x)
            continue;
        crossings++;
        winding += a.y <= at.y ? 1 : -1;
    }
    return rule == POLYGON_EVEN_ODD ? crossings : winding;
}

/* What the rule counts: in the middle, in the points, and outside. */
static void figures(struct stage *s, const struct point2 *p, int count, struct point2 middle,
                    enum polygon_rule rule)
{
    char text[8];
    stage_ink(s, INK_BRIGHT);
    for (int i = -1; i < count; i++) {
        struct point2 at = middle;
        float out = 0.7f;
        if (i >= 0)
            at = (struct point2){middle.x + out * (p[i].x - middle.x),
                                 middle.y + out * (p[i].y - middle.y)};
        snprintf(text, sizeof text, "%d", counted(p, count, at, rule));
        stage_text_middle(s, at.x, at.y - 8, text);
    }
}

static void filled_star(struct stage *s, const struct point2 *p, int count, struct point2 middle,
                        enum polygon_rule rule, enum ink ink)
{
    struct point2 q[16] = {{0, 0}};
    for (int i = 0; i < count; i++)
        q[i] = (struct point2){stage_canvas_x(s, p[i].x), stage_canvas_y(s, p[i].y)};
    canvas_polygon(&s->canvas, q, count, rule, ink);
    hatch(s, p, count, rule);
    stage_ink(s, INK_BRIGHT);
    stage_polygon(s, p, count);
    figures(s, p, count, middle, rule);
}

void areas_rules(struct stage *s, float seconds)
{
    static const int points[] = {5, 7, 8}, skip[] = {2, 3, 3};
    enum { RADIUS = 300, Y = 440 };
    int which = (int)(seconds / 5.4f) % 3;
    struct point2 p[16];
    struct point2 left = {300, Y}, right = {900, Y};
    int count = star(p, points[which], skip[which], left.x, Y, RADIUS, seconds * 0.12f);
    filled_star(s, p, count, left, POLYGON_EVEN_ODD, INK_BLUE);
    count = star(p, points[which], skip[which], right.x, Y, RADIUS, seconds * 0.12f);
    filled_star(s, p, count, right, POLYGON_NON_ZERO, INK_ORANGE);
    stage_ink(s, INK_TEXT);
    stage_text_middle(s, 300, 70, "even-odd rule");
    stage_text_middle(s, 300, 30, "even: outside");
    stage_text_middle(s, 900, 70, "non-zero winding rule");
    stage_text_middle(s, 900, 30, "0: outside");
}
