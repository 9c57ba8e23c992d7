/* areas_lines.c — `dashed`, `thick` and `antialias`: attributes of lines. */
#include <stdio.h>

#include "roms/commands/areas.h"
#include "roms/monitor/print.h"
#include "roms/monitor/stepper.h"
#include "roms/raster/line_antialiased.h"
#include "roms/raster/line_dashed.h"
#include "roms/raster/line_thick.h"

enum { LIMIT = 100, MOST_POINTS = 40 };

/* ---- dashed ---------------------------------------------------------------------------------- */

struct dashing {
    struct dash_pattern pattern;
    struct dash_phase phase;
    struct line_dashed line;
    struct point2 point[MOST_POINTS];
    int count, segment;
    float gone, a_step; /* distance along the polyline; that of neighbouring pixels */
    bool fresh;         /* the line's first pixel is the last one of the line before */
};

static void begin_segment(struct dashing *d)
{
    struct point2 a = d->point[d->segment], b = d->point[d->segment + 1];
    float dx = fabsf(b.x - a.x), dy = fabsf(b.y - a.y), longer = fmaxf(dx, dy);
    line_dashed_begin(&d->line, (int)a.x, (int)a.y, (int)b.x, (int)b.y, &d->pattern, &d->phase);
    d->a_step = longer > 0 ? sqrtf(dx * dx + dy * dy) / longer : 0;
    d->fresh = true;
}

static bool next_dash(void *state, struct step *s)
{
    struct dashing *d = (struct dashing *)state;
    int x, y;
    bool on;
    while (!line_dashed_next(&d->line, &x, &y, &on)) {
        if (d->segment + 2 >= d->count)
            return false;
        d->segment++;
        begin_segment(d);
        line_dashed_next(&d->line, &x, &y, &on); /* the corner, which is there already */
        d->fresh = false;
    }
    if (!d->fresh)
        d->gone += d->a_step;
    d->fresh = false;
    if (on)
        s->lit[s->lit_count++] = (struct step_run){y, x, x, INK_CYAN};
    s->candidate[s->candidate_count++] = (struct point2){(float)x, (float)y};
    snprintf(s->row, sizeof s->row, "%5d %5d %10.4f  %s", x, y, (double)d->gone,
             on ? "dash" : "gap");
    snprintf(s->decision, sizeof s->decision, "Pixel (%d,%d), %.4f along the line: %s", x, y,
             (double)d->gone, on ? "dash" : "gap");
    return true;
}

static void polyline(const struct grid *grid, const struct point2 *p, int count, bool closed)
{
    for (int i = 0; i + 1 < count + closed; i++)
        grid_line(grid, p[i].x, p[i].y, p[(i + 1) % count].x, p[(i + 1) % count].y, INK_GRID);
}

static void dashed_ideal(const void *state, const struct grid *grid)
{
    const struct dashing *d = (const struct dashing *)state;
    polyline(grid, d->point, d->count, false);
}

static bool take_pattern(struct words *w, struct dash_pattern *pattern)
{
    while (words_next_is_number(w)) {
        int length;
        if (pattern->count == DASH_LENGTHS)
            return words_refuse(w, "a pattern has at most %d lengths", DASH_LENGTHS);
        if (!words_whole(w, 1, LIMIT, &length))
            return false;
        pattern->length[pattern->count++] = (uint8_t)length;
    }
    if (pattern->count == 0 || pattern->count % 2 != 0)
        return words_refuse(w, "a pattern is pairs of a dash and a gap");
    return words_take(w, "at") || words_refuse(w, "\"at\" is missing behind the pattern");
}

bool areas_dashed(struct monitor *m, struct words *w)
{
    struct dashing d = {.segment = 0};
    if (!take_pattern(w, &d.pattern) ||
        !words_points2(w, (struct words_wanted){2, MOST_POINTS, LIMIT}, d.point, &d.count) ||
        !words_end(w))
        return false;
    for (int i = 0; i < d.count; i++)
        if (d.point[i].x != floorf(d.point[i].x) || d.point[i].y != floorf(d.point[i].y))
            return words_refuse(w, "point %d is not a pixel", i + 1);
    struct areas_box box = areas_box(d.point, d.count);
    begin_segment(&d);
    const struct stepper stepper = {.title = "Dashed line",
                                    .header = "    x     y   distance",
                                    .x0 = box.x0,
                                    .y0 = box.y0,
                                    .x1 = box.x1,
                                    .y1 = box.y1,
                                    .next = next_dash,
                                    .ideal = dashed_ideal,
                                    .state = &d};
    scan_run(m, &stepper);
    printf("%.4f pixels long\n", (double)d.gone);
    return true;
}

/* ---- thick ----------------------------------------------------------------------------------- */

struct thickness {
    struct line_thick line;
    struct thick_piece piece;
    struct polygon_fill fill;
    struct areas_box box;
    struct point2 point[MOST_POINTS];
    int count;
    bool closed, filling;
    int pieces;
};

static const char *const piece_names[] = {"segment", "join", "cap"};

/* The next piece, to be filled; the library's rows go down, those of the picture go up. */
static bool next_piece(struct thickness *t, struct step *s)
{
    struct point2 down[POLYGON_CORNERS];
    if (!line_thick_next(&t->line, &t->piece))
        return false;
    const struct thick_piece *p = &t->piece;
    for (int i = 0; i < p->count; i++)
        down[i] = (struct point2){p->corner[i].x, -p->corner[i].y};
    polygon_fill_begin(&t->fill, POLYGON_NON_ZERO, -t->box.y1, -t->box.y0);
    polygon_fill_contour(&t->fill, down, p->count);
    snprintf(s->row, sizeof s->row, "%-7s %2d ", piece_names[p->kind], p->count);
    for (int i = 0; i < 4 && i < p->count; i++)
        areas_add(s->row, sizeof s->row, " %.4f,%.4f", print_tidy(p->corner[i].x),
                  print_tidy(p->corner[i].y));
    if (p->count > 4)
        areas_add(s->row, sizeof s->row, " ...");
    snprintf(s->decision, sizeof s->decision, "Piece %d: a %s of %d corners", ++t->pieces,
             piece_names[p->kind], p->count);
    t->filling = true;
    return true;
}

/* A piece, or what more rows it has than a step holds. */
static bool next_thick(void *state, struct step *s)
{
    static const enum ink inks[] = {INK_CYAN, INK_YELLOW, INK_GREEN};
    struct thickness *t = (struct thickness *)state;
    struct polygon_run run;
    if (!t->filling && !next_piece(t, s))
        return false;
    while (s->lit_count < STEP_RUNS) {
        if (!polygon_fill_row(&t->fill)) {
            t->filling = false;
            break;
        }
        /* Pieces are convex: a run a row. */
        if (polygon_fill_run(&t->fill, &run))
            s->lit[s->lit_count++] =
                (struct step_run){-t->fill.y, run.x0, run.x1 - 1, inks[t->piece.kind]};
    }
    return true;
}

static void thick_ideal(const void *state, const struct grid *grid)
{
    const struct thickness *t = (const struct thickness *)state;
    const struct thick_piece *p = &t->piece;
    for (int i = 0; t->filling && i < p->count; i++) {
        struct point2 a = p->corner[i], b = p->corner[(i + 1) % p->count];
        grid_line(grid, a.x, a.y, b.x, b.y, INK_RED);
    }
    polyline(grid, t->point, t->count, t->closed);
}

bool areas_thick(struct monitor *m, struct words *w)
{
    static const char *const caps[] = {"butt", "square", "round", NULL};
    static const char *const joins[] = {"bevel", "miter", "round", NULL};
    struct thickness t = {.count = 0};
    struct line_style style;
    int cap, join;
    if (!words_bounded(w, 0.5f, 50, &style.width))
        return false;
    if (!words_choice(w, caps, &cap) || !words_choice(w, joins, &join))
        return false;
    t.closed = words_take(w, "closed");
    if (!words_points2(w, (struct words_wanted){1, MOST_POINTS, LIMIT}, t.point, &t.count) ||
        !words_end(w))
        return false;
    style.cap = (enum line_cap)cap;
    style.join = (enum line_join)join;
    t.box = areas_box(t.point, t.count);
    int more = (int)ceilf(style.width * (join == JOIN_MITER ? 1.5f : 0.75f));
    t.box = (struct areas_box){t.box.x0 - more, t.box.y0 - more, t.box.x1 + more, t.box.y1 + more};
    line_thick_begin(&t.line, t.point, t.count, t.closed, &style);
    const struct stepper stepper = {.title = "Wide line",
                                    .header = "piece    n  corners",
                                    .x0 = t.box.x0,
                                    .y0 = t.box.y0,
                                    .x1 = t.box.x1,
                                    .y1 = t.box.y1,
                                    .next = next_thick,
                                    .ideal = thick_ideal,
                                    .state = &t};
    scan_run(m, &stepper);
    printf("%d pieces\n", t.pieces);
    return true;
}

/* ---- antialias ------------------------------------------------------------------------------- */

struct smoothing {
    struct line_antialiased line;
    struct antialiased_column column;
    int at; /* of the column's pixels; those of no column: ANTIALIASED_PIXELS */
    struct point2 from, to;
    float sum;
};

static bool next_pixel(void *state, struct step *s)
{
    struct smoothing *a = (struct smoothing *)state;
    const struct antialiased_column *k = &a->column;
    do {
        if (++a->at >= ANTIALIASED_PIXELS) {
            a->at = 0;
            if (!line_antialiased_next(&a->line, &a->column))
                return false;
        }
    } while (k->coverage[a->at] == 0);
    int x = k->steep ? k->across + a->at : k->along, y = k->steep ? k->along : k->across + a->at;
    float distance = (float)k->distance[a->at] / ANTIALIASED_DISTANCE;
    float coverage = (float)k->coverage[a->at] / 255;
    a->sum += coverage;
    s->lit[s->lit_count++] = (struct step_run){y, x, x, (enum ink)ink_shade(RAMP_GREY, coverage)};
    s->candidate[s->candidate_count++] = (struct point2){(float)x, (float)y};
    snprintf(s->row, sizeof s->row, "%5d %5d %9.4f %9.4f", x, y, (double)distance,
             (double)coverage);
    snprintf(s->decision, sizeof s->decision, "Pixel (%d,%d) is %.4f from the line: coverage %.4f",
             x, y, (double)distance, (double)coverage);
    return true;
}

static void line_ideal(const void *state, const struct grid *grid)
{
    const struct smoothing *a = (const struct smoothing *)state;
    grid_line(grid, a->from.x, a->from.y, a->to.x, a->to.y, INK_ORANGE);
}

bool areas_antialias(struct monitor *m, struct words *w)
{
    struct smoothing a = {.at = ANTIALIASED_PIXELS};
    struct point2 p[2];
    int count;
    if (!words_points2(w, (struct words_wanted){2, 2, LIMIT}, p, &count) || !words_end(w))
        return false;
    a.from = p[0];
    a.to = p[1];
    line_antialiased_begin(&a.line, p[0].x, p[0].y, p[1].x, p[1].y);
    struct areas_box box = areas_box(p, 2);
    const struct stepper stepper = {.title = "Antialiased line: coverage by distance",
                                    .header = "    x     y  distance  coverage",
                                    .x0 = box.x0 - 1,
                                    .y0 = box.y0 - 1,
                                    .x1 = box.x1 + 1,
                                    .y1 = box.y1 + 1,
                                    .next = next_pixel,
                                    .ideal = line_ideal,
                                    .state = &a};
    scan_run(m, &stepper);
    printf("coverage of all pixels: %.4f\n", (double)a.sum);
    return true;
}
