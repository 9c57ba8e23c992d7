/* areas_fill.c — `fill`: a polygon, row by row, with its active edges. */
#include <stdio.h>

#include "roms/commands/areas.h"
#include "roms/monitor/print.h"
#include "roms/monitor/stepper.h"
#include "roms/raster/polygon_fill.h"

enum { LIMIT = 100, MOST_CORNERS = 99, SHOWN = 4 };

/* The library's rows go down, those of the picture go up: row = −y. */
struct filling {
    struct polygon_fill fill;
    struct point2 corner[MOST_CORNERS];
    int count;
    bool more; /* of the same row */
    long pixels;
};

static float crossing(const struct polygon_edge *e)
{
    return ((float)e->x - (float)e->over / (float)e->height) / POLYGON_PARTS;
}

/* The row of the table, and the same in words. */
static void describe(const struct filling *f, struct step *s)
{
    const struct polygon_fill *fill = &f->fill;
    char at[STEP_TEXT] = "", runs[STEP_TEXT] = "";
    for (int i = 0; i < fill->active_count && i < SHOWN; i++)
        areas_add(at, sizeof at, " %8.4f", print_tidy(crossing(&fill->edge[fill->active[i]])));
    if (fill->active_count > SHOWN)
        areas_add(at, sizeof at, " ...");
    for (int i = 0; i < s->lit_count && i < SHOWN; i++)
        areas_add(runs, sizeof runs, " %d..%d", s->lit[i].x0, s->lit[i].x1);
    if (s->lit_count > SHOWN)
        areas_add(runs, sizeof runs, " ...");
    if (s->lit_count == 0)
        areas_add(runs, sizeof runs, " none");
    areas_add(s->row, sizeof s->row, "%5d %5d %-40s %s", -fill->y, fill->active_count, at, runs);
    areas_add(s->decision, sizeof s->decision, "Row %d: %d active edges; pixels%s", -fill->y,
              fill->active_count, runs);
}

static bool next(void *state, struct step *s)
{
    struct filling *f = (struct filling *)state;
    struct polygon_run run;
    bool first = !f->more;
    if (first && !polygon_fill_row(&f->fill))
        return false;
    while (s->lit_count < STEP_RUNS && polygon_fill_run(&f->fill, &run)) {
        s->lit[s->lit_count++] = (struct step_run){-f->fill.y, run.x0, run.x1 - 1, INK_CYAN};
        f->pixels += run.x1 - run.x0;
    }
    f->more = s->lit_count == STEP_RUNS;
    if (first)
        describe(f, s);
    return true;
}

static void edges(const void *state, const struct grid *grid)
{
    const struct filling *f = (const struct filling *)state;
    for (int i = 0; i < f->count; i++) {
        struct point2 a = f->corner[i], b = f->corner[i + 1 < f->count ? i + 1 : 0];
        grid_line(grid, a.x, a.y, b.x, b.y, INK_BRIGHT);
    }
    for (int i = 0; i < f->fill.active_count; i++) {
        const struct polygon_edge *e = &f->fill.edge[f->fill.active[i]];
        grid_line(grid, e->a.x, -e->a.y, e->b.x, -e->b.y, INK_YELLOW);
        struct point2 at = grid_place(grid, crossing(e), (float)-f->fill.y);
        stage_ink(grid->stage, INK_RED);
        stage_marker(grid->stage, at.x, at.y);
    }
}

bool areas_fill(struct monitor *m, struct words *w)
{
    static const char *const rules[] = {"even-odd", "non-zero", NULL};
    struct filling f = {.count = 0};
    struct point2 down[MOST_CORNERS];
    int rule;
    if (!words_choice(w, rules, &rule) ||
        !words_points2(w, (struct words_wanted){3, MOST_CORNERS, LIMIT}, f.corner, &f.count) ||
        !words_end(w))
        return false;
    for (int i = 0; i < f.count; i++)
        down[i] = (struct point2){f.corner[i].x, -f.corner[i].y};
    struct areas_box box = areas_box(f.corner, f.count);
    polygon_fill_begin(&f.fill, rule == 0 ? POLYGON_EVEN_ODD : POLYGON_NON_ZERO, -box.y1, -box.y0);
    polygon_fill_contour(&f.fill, down, f.count);
    const struct stepper stepper = {
        .title = rule == 0 ? "Polygon fill: even-odd rule" : "Polygon fill: non-zero winding rule",
        .header = "    y edges  crossings                                runs",
        .x0 = box.x0,
        .y0 = box.y0,
        .x1 = box.x1,
        .y1 = box.y1,
        .next = next,
        .ideal = edges,
        .state = &f};
    scan_run(m, &stepper);
    printf("%ld pixels\n", f.pixels);
    return true;
}
