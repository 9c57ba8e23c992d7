/* areas_seed.c — `boundary` and `flood`: from a seed, span by span. */
#include <stdio.h>

#include "roms/commands/areas.h"
#include "roms/monitor/stepper.h"
#include "roms/raster/boundary_fill.h"
#include "roms/raster/flood_fill.h"
#include "roms/raster/pixel.h"

enum {
    LIMIT = 50,
    MOST_CORNERS = 90,
    SIDE = 2 * LIMIT + 5,
    SEEDS = 500,
};

/* The library's rows go down, those of the picture go up. */
struct seeding {
    uint32_t pixels[(SIDE + 3) / 4 * SIDE];
    struct canvas canvas, scene; /* what is filled; what was there */
    uint32_t before[(SIDE + 3) / 4 * SIDE];
    struct span_seed seeds[SEEDS];
    struct span_fill fill;
    struct areas_box box;
    long filled;
    int spans;
};

static int column(const struct seeding *s, int x)
{
    return x - s->box.x0;
}

static int row(const struct seeding *s, int y)
{
    return s->box.y1 - y;
}

static bool next(void *state, struct step *step)
{
    struct seeding *s = (struct seeding *)state;
    struct span_filled span;
    if (!span_fill_next(&s->fill, &span))
        return false;
    int y = s->box.y1 - span.y, x0 = s->box.x0 + span.x0, x1 = s->box.x0 + span.x1;
    step->lit[step->lit_count++] = (struct step_run){y, x0, x1, INK_CYAN};
    for (int i = 1; i <= span.pushed && step->candidate_count < STEP_CANDIDATES; i++) {
        struct span_seed seed = s->seeds[s->fill.count - i];
        step->candidate[step->candidate_count++] =
            (struct point2){(float)(s->box.x0 + seed.x), (float)(s->box.y1 - seed.y)};
    }
    snprintf(step->row, sizeof step->row, "%5d %5d %5d..%-5d %6d %7d", s->box.x0 + span.seed, y, x0,
             x1, span.pushed, s->fill.count);
    snprintf(step->decision, sizeof step->decision,
             "Seed (%d,%d): span %d..%d filled, %d seeds pushed, %d waiting", s->box.x0 + span.seed,
             y, x0, x1, span.pushed, s->fill.count);
    s->filled += x1 - x0 + 1;
    s->spans++;
    return true;
}

/* The boundary, a run of a row at a time. */
static void boundary(const void *state, const struct grid *grid)
{
    const struct seeding *s = (const struct seeding *)state;
    for (int y = s->box.y0; y <= s->box.y1; y++)
        for (int x = s->box.x0; x <= s->box.x1; x++) {
            uint32_t ink = canvas_pixel(&s->scene, column(s, x), row(s, y));
            int first = x;
            while (x < s->box.x1 && canvas_pixel(&s->scene, column(s, x + 1), row(s, y)) == ink)
                x++;
            if (ink != INK_BLACK)
                grid_run(grid, y, first, x, (enum ink)ink);
        }
}

/* A canvas of the box, over this storage. */
static struct canvas canvas_over(const struct seeding *s, uint32_t *pixels)
{
    struct canvas c = {.pixels = (uint8_t *)pixels,
                       .width = s->box.x1 - s->box.x0 + 1,
                       .height = s->box.y1 - s->box.y0 + 1,
                       .bits = 8,
                       .dots_a_row = 1};
    c.pitch = canvas_pitch(c.width, 8);
    return c;
}

/* A polygon's edges on both canvases: of one colour, or of several. */
static void draw_boundary(struct seeding *s, const struct point2 *p, int count, bool flood)
{
    static const enum ink inks[] = {INK_ORANGE, INK_GREEN, INK_VIOLET, INK_RED};
    canvas_clear(&s->canvas, INK_BLACK);
    canvas_clear(&s->scene, INK_BLACK);
    for (int i = 0; i < count; i++) {
        struct point2 a = p[i], b = p[i + 1 < count ? i + 1 : 0];
        enum ink ink = flood ? inks[i % 4] : INK_ORANGE;
        canvas_line(&s->canvas, column(s, (int)a.x), row(s, (int)a.y), column(s, (int)b.x),
                    row(s, (int)b.y), ink);
        canvas_line(&s->scene, column(s, (int)a.x), row(s, (int)a.y), column(s, (int)b.x),
                    row(s, (int)b.y), ink);
    }
}

/* How they are connected, the seed, and the boundary. */
static bool take(struct words *w, int *connected, int *x, int *y, struct point2 *p, int *count)
{
    static const char *const ways[] = {"4", "8", NULL};
    if (!words_choice(w, ways, connected) || !words_whole(w, -LIMIT, LIMIT, x) ||
        !words_whole(w, -LIMIT, LIMIT, y))
        return false;
    *connected = *connected == 0 ? 4 : 8;
    if (!words_take(w, "in"))
        return words_refuse(w, "\"in\" is missing behind the seed");
    if (!words_points2(w, (struct words_wanted){3, MOST_CORNERS, LIMIT}, p, count) || !words_end(w))
        return false;
    for (int i = 0; i < *count; i++)
        if (p[i].x != floorf(p[i].x) || p[i].y != floorf(p[i].y))
            return words_refuse(w, "point %d of the boundary is not a pixel", i + 1);
    return true;
}

static void report(const struct seeding *s)
{
    printf("%ld pixels in %d spans; at most %d seeds waited\n", s->filled, s->spans,
           s->fill.deepest);
    if (s->fill.dropped > 0)
        printf("The stack of %d seeds was too small: the area is not complete.\n", SEEDS);
}

static bool run(struct monitor *m, struct words *w, bool flood)
{
    struct seeding s = {.spans = 0};
    struct point2 p[MOST_CORNERS];
    int connected, x, y, count;
    if (!take(w, &connected, &x, &y, p, &count))
        return false;
    s.box = areas_box(p, count);
    if (x < s.box.x0 || x > s.box.x1 || y < s.box.y0 || y > s.box.y1)
        return words_refuse(w, "the seed is not where the boundary is");
    s.box = (struct areas_box){s.box.x0 - 1, s.box.y0 - 1, s.box.x1 + 1, s.box.y1 + 1};
    s.canvas = canvas_over(&s, s.pixels);
    s.scene = canvas_over(&s, s.before);
    draw_boundary(&s, p, count, flood);
    if (canvas_pixel(&s.canvas, column(&s, x), row(&s, y)) != INK_BLACK)
        return words_refuse(w, "the seed lies on the boundary");
    if (flood)
        flood_fill_begin(&s.fill, &s.canvas, column(&s, x), row(&s, y), connected, INK_CYAN,
                         s.seeds, SEEDS);
    else
        boundary_fill_begin(&s.fill, &s.canvas, column(&s, x), row(&s, y), connected, INK_ORANGE,
                            INK_CYAN, s.seeds, SEEDS);
    char title[64];
    snprintf(title, sizeof title, "%s fill, %d-connected", flood ? "Flood" : "Boundary", connected);
    const struct stepper stepper = {.title = title,
                                    .header = "    x     y  span          pushed waiting",
                                    .x0 = s.box.x0,
                                    .y0 = s.box.y0,
                                    .x1 = s.box.x1,
                                    .y1 = s.box.y1,
                                    .next = next,
                                    .before = boundary,
                                    .state = &s};
    scan_run(m, &stepper);
    report(&s);
    return true;
}

bool areas_boundary(struct monitor *m, struct words *w)
{
    return run(m, w, false);
}

bool areas_flood(struct monitor *m, struct words *w)
{
    return run(m, w, true);
}
