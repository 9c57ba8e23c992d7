/* circles.c — midpoint circles and ellipses: rows of their tables, decisions, images by
 * symmetry. */
#include "roms/commands/circles.h"

#include <stdio.h>

#include "roms/geometry/scalar.h"
#include "roms/monitor/stepper.h"
#include "roms/raster/circle_midpoint.h"
#include "roms/raster/circle_midpoint_side.h"
#include "roms/raster/ellipse_midpoint.h"

enum { FARTHEST = 2000, LARGEST = 1000 };

struct round {
    int xc, yc, rx, ry;
    int pixels;
    bool told; /* somebody reads rows or decisions */
    struct circle_midpoint circle;
    struct circle_midpoint_side side;
    struct ellipse_midpoint ellipse;
};

static void light(const struct round *r, struct step *step, int x, int y, enum ink ink)
{
    step->lit[step->lit_count++] = (struct step_run){r->yc + y, r->xc + x, r->xc + x, ink};
}

/* How many different pixels the images in both axes are. */
static int images_in_axes(int x, int y)
{
    return (x == 0 ? 1 : 2) * (y == 0 ? 1 : 2);
}

static void light_quadrants(const struct round *r, struct step *step, int x, int y)
{
    light(r, step, x, y, INK_GREEN);
    light(r, step, -x, y, INK_CYAN);
    light(r, step, -x, -y, INK_ORANGE);
    light(r, step, x, -y, INK_VIOLET);
}

static void light_octants(const struct round *r, struct step *step, int x, int y)
{
    light_quadrants(r, step, x, y);
    light(r, step, y, x, INK_YELLOW);
    light(r, step, -y, x, INK_BLUE);
    light(r, step, -y, -x, INK_RED);
    light(r, step, y, -x, INK_BRIGHT);
}

static void choose(const struct round *r, struct step *step, int x0, int y0, int x1, int y1)
{
    step->candidate[0] = (struct point2){(float)(r->xc + x0), (float)(r->yc + y0)};
    step->candidate[1] = (struct point2){(float)(r->xc + x1), (float)(r->yc + y1)};
    step->candidate_count = 2;
    step->midpoint = (struct point2){(step->candidate[0].x + step->candidate[1].x) * 0.5f,
                                     (step->candidate[0].y + step->candidate[1].y) * 0.5f};
    step->has_midpoint = true;
}

/* A decision of a circle: its number, below 0 at the start; p; the pixel about the origin; who may
 * step. */
struct told {
    int k, p, x, y;
    char axis;
};

static void tell_circle(const struct round *r, struct step *step, struct told t)
{
    char number[16] = "", p[16] = "";
    if (t.k >= 0) {
        snprintf(number, sizeof number, "%d", t.k);
        snprintf(p, sizeof p, "%d", t.p);
        snprintf(step->decision, STEP_TEXT, "p = %d: the middle is %s the circle, %c %s", t.p,
                 t.p < 0 ? "inside" : "outside", t.axis, t.p < 0 ? "stays" : "steps");
    } else {
        snprintf(step->decision, STEP_TEXT, "The start: (%d, %d)", t.x, t.y);
    }
    snprintf(step->row, STEP_TEXT, "%4s %7s %6d %6d %7d %7d", number, p, t.x, t.y, r->xc + t.x,
             r->yc + t.y);
}

static void past_the_octant(struct step *step)
{
    size_t length = 0;
    while (step->row[length] != '\0')
        length++;
    snprintf(step->row + length, STEP_TEXT - length, "  past the octant");
}

/* Past the octant there are only images of the pixel before. */
static void octant_pixel(struct round *r, struct step *step, int x, int y, bool past)
{
    if (past) {
        past_the_octant(step);
        return;
    }
    light_octants(r, step, x, y);
    r->pixels += images_in_axes(x, y) * (x == y ? 1 : 2);
}

static bool next_circle(void *state, struct step *step)
{
    struct round *r = state;
    struct circle_midpoint *c = &r->circle;
    int p = c->p;
    if (r->told && c->k >= 0)
        choose(r, step, c->x + 1, c->y, c->x + 1, c->y - 1);
    if (!circle_midpoint_next(c))
        return false;
    if (r->told)
        tell_circle(r, step, (struct told){c->k - 1, p, c->x, c->y, 'y'});
    octant_pixel(r, step, c->x, c->y, c->x > c->y);
    return true;
}

static bool next_side(void *state, struct step *step)
{
    struct round *r = state;
    struct circle_midpoint_side *c = &r->side;
    int p = c->p;
    if (r->told && c->k >= 0)
        choose(r, step, c->x, c->y + 1, c->x - 1, c->y + 1);
    if (!circle_midpoint_side_next(c))
        return false;
    if (r->told)
        tell_circle(r, step, (struct told){c->k - 1, p, c->x, c->y, 'x'});
    octant_pixel(r, step, c->x, c->y, c->y > c->x);
    return true;
}

/* p with its quarter, which odd radii have. */
static void write_decision(char *text, size_t room, const struct ellipse_midpoint *e)
{
    int64_t square = e->region == 1 ? e->rx_squared : e->ry_squared;
    if (e->region == 3)
        snprintf(text, room, "-");
    else if (square % 4 == 0)
        snprintf(text, room, "%.0f", (double)e->p);
    else
        snprintf(text, room, "%.2f", (double)e->p + 0.25);
}

static void choose_ellipse(const struct round *r, struct step *step)
{
    const struct ellipse_midpoint *e = &r->ellipse;
    if (e->k >= 0 && e->region == 1)
        choose(r, step, e->x + 1, e->y, e->x + 1, e->y - 1);
    else if (e->k >= 0 && e->region == 2)
        choose(r, step, e->x, e->y - 1, e->x + 1, e->y - 1);
}

/* `before`: as it was when the decision was taken; `e`: after it. */
static void tell_ellipse(struct step *step, const struct ellipse_midpoint *before,
                         const struct ellipse_midpoint *e)
{
    static const char *const steps[][2] = {{"y stays", "y steps"}, {"x steps", "x stays"}};
    char p[20] = "", k[12] = "", region[2] = "";
    if (e->k > 0) {
        write_decision(p, sizeof p, before);
        snprintf(k, sizeof k, "%d", before->k);
        snprintf(region, sizeof region, "%c", '0' + before->region);
    }
    if (e->k == 0)
        snprintf(step->decision, STEP_TEXT, "The start: (0, %d)", e->y);
    else if (before->region == 3)
        snprintf(step->decision, STEP_TEXT, "The flat tip: a run to (%d, 0)", e->rx);
    else
        snprintf(step->decision, STEP_TEXT, "Region %d: p = %s, %s", before->region, p,
                 steps[before->region - 1][before->p >= 0]);
    snprintf(step->row, STEP_TEXT, "%6s %4s %14s %5d %5d %11d %11d", region, k, p, e->x, e->y,
             (int)e->slope_x, (int)e->slope_y); /* below 2^31 up to LARGEST */
}

static bool next_ellipse(void *state, struct step *step)
{
    struct round *r = state;
    struct ellipse_midpoint *e = &r->ellipse, before = *e;
    if (r->told)
        choose_ellipse(r, step);
    if (!ellipse_midpoint_next(e))
        return false;
    if (r->told)
        tell_ellipse(step, &before, e);
    light_quadrants(r, step, e->x, e->y);
    r->pixels += images_in_axes(e->x, e->y);
    return true;
}

static void ideal(const void *state, const struct grid *grid)
{
    const struct round *r = state;
    int sides = r->rx + r->ry < 100 ? 72 : 360;
    float turn = TURN / (float)sides;
    for (int i = 0; i < sides; i++) {
        float a = turn * (float)i, b = turn * (float)(i + 1);
        grid_line(grid, (float)r->xc + (float)r->rx * cosf(a),
                  (float)r->yc + (float)r->ry * sinf(a), (float)r->xc + (float)r->rx * cosf(b),
                  (float)r->yc + (float)r->ry * sinf(b), INK_BRIGHT);
    }
}

/* Takes middle and radii; one radius or two. */
static bool take(struct words *w, struct round *r, bool circle)
{
    *r = (struct round){0};
    if (!words_whole(w, -FARTHEST, FARTHEST, &r->xc) ||
        !words_whole(w, -FARTHEST, FARTHEST, &r->yc) || !words_whole(w, 0, LARGEST, &r->rx))
        return false;
    r->ry = r->rx;
    return (circle || words_whole(w, 0, LARGEST, &r->ry)) && words_end(w);
}

static bool run(struct monitor *m, struct round *r, struct stepper stepper)
{
    char title[64];
    if (r->rx == r->ry)
        snprintf(title, sizeof title, "%s about (%d,%d), radius %d", stepper.title, r->xc, r->yc,
                 r->rx);
    else
        snprintf(title, sizeof title, "%s about (%d,%d), radii %d and %d", stepper.title, r->xc,
                 r->yc, r->rx, r->ry);
    stepper.title = title;
    stepper.x0 = r->xc - r->rx;
    stepper.y0 = r->yc - r->ry;
    stepper.x1 = r->xc + r->rx;
    stepper.y1 = r->yc + r->ry;
    stepper.ideal = ideal;
    stepper.state = r;
    r->told = m->table || m->steps;
    scan_run(m, &stepper);
    printf("%d pixel%s about (%d,%d)\n", r->pixels, r->pixels == 1 ? "" : "s", r->xc, r->yc);
    return true;
}

static const char circle_header[] = "   k       p      x      y    xc+x    yc+y";
static const char circle_caption[] =
    "An eighth is computed; symmetry gives the rest, a colour an octant.";

bool commands_circle(struct monitor *m, struct words *w)
{
    struct round r;
    if (!take(w, &r, true))
        return false;
    circle_midpoint_begin(&r.circle, r.rx);
    return run(m, &r,
               (struct stepper){.title = "Midpoint circle",
                                .caption = circle_caption,
                                .header = circle_header,
                                .next = next_circle});
}

bool commands_circle_side(struct monitor *m, struct words *w)
{
    struct round r;
    if (!take(w, &r, true))
        return false;
    circle_midpoint_side_begin(&r.side, r.rx);
    return run(m, &r,
               (struct stepper){.title = "Midpoint circle from the side",
                                .caption = circle_caption,
                                .header = circle_header,
                                .next = next_side});
}

bool commands_ellipse(struct monitor *m, struct words *w)
{
    struct round r;
    if (!take(w, &r, false))
        return false;
    ellipse_midpoint_begin(&r.ellipse, r.rx, r.ry);
    return run(
        m, &r,
        (struct stepper){.title = "Midpoint ellipse",
                         .caption =
                             "A quarter is computed; symmetry gives the rest, a colour a quadrant.",
                         .header = "region    k              p     x     y     2ry^2 x     2rx^2 y",
                         .next = next_ellipse});
}
