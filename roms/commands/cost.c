/* cost.c — what the drawing algorithms cost: instructions counted by the processor itself. */
#include <math.h>
#include <stdio.h>

#include "roms/bsp/board.h"
#include "roms/bsp/csr.h"
#include "roms/commands/cost.h"
#include "roms/geometry/scalar.h"
#include "roms/scenery/studio.h"
#include "roms/light/shade.h"
#include "roms/raster/circle_midpoint.h"
#include "roms/raster/ellipse_midpoint.h"
#include "roms/raster/flood_fill.h"
#include "roms/raster/line_antialiased.h"
#include "roms/raster/line_dda.h"
#include "roms/raster/line_dda_integer.h"
#include "roms/raster/polygon_fill.h"

enum { ACROSS = 500, UP = 310, RADIUS = 180, X = 320, Y = 240, SEEDS = 512 };

static void row(const char *what, uint32_t count, const char *unit, uint32_t instructions)
{
    printf("%-34s %7lu %-9s %9lu %8.1f %8.3f\n", what, (unsigned long)count, unit,
           (unsigned long)instructions, count > 0 ? (double)instructions / count : 0.0,
           1000.0 * instructions / board_clock_hz());
}

/* Pixels of the canvas that are not black. */
static uint32_t lit(const struct canvas *c)
{
    uint32_t count = 0;
    for (int y = 0; y < c->height; y++)
        for (int x = 0; x < c->width; x++)
            count += c->pixels[(uint32_t)y * c->pitch + (uint32_t)x] != INK_BLACK;
    return count;
}

/* ---- one figure each ------------------------------------------------------------------------------ */

static void bresenham(const struct canvas *c)
{
    canvas_line(c, 60, 60, 60 + ACROSS, 60 + UP, INK_GREEN);
}

static void dda(const struct canvas *c)
{
    canvas_line_dda(c, 60, 60, 60 + ACROSS, 60 + UP, INK_GREEN);
}

static void dda_integer(const struct canvas *c)
{
    canvas_line_dda_integer(c, 60, 60, 60 + ACROSS, 60 + UP, INK_GREEN);
}

static void antialiased(const struct canvas *c)
{
    uint32_t ramp[INK_LEVELS];
    for (int i = 0; i < INK_LEVELS; i++)
        ramp[i] = ink_shade(RAMP_GREEN, (float)i / (INK_LEVELS - 1));
    canvas_line_antialiased(c, 60, 60, 60 + ACROSS, 60 + UP, ramp, INK_LEVELS);
}

static void circle(const struct canvas *c)
{
    canvas_circle(c, X, Y, RADIUS, INK_GREEN);
}

static void ellipse(const struct canvas *c)
{
    canvas_ellipse_midpoint(c, X, Y, 280, RADIUS, INK_GREEN);
}

static void triangle(const struct canvas *c)
{
    struct point2 corners[] = {{100, 60}, {540, 180}, {220, 420}};
    canvas_polygon(c, corners, 3, POLYGON_EVEN_ODD, INK_GREEN);
}

static void star(const struct canvas *c)
{
    struct point2 corners[5];
    for (int i = 0; i < 5; i++) {
        float angle = TURN * (float)(2 * i) / 5;
        corners[i] = (struct point2){X + RADIUS * sinf(angle), Y - RADIUS * cosf(angle)};
    }
    canvas_polygon(c, corners, 5, POLYGON_NON_ZERO, INK_GREEN);
}

static void flood(const struct canvas *c)
{
    static struct span_seed seeds[SEEDS];
    canvas_circle(c, X, Y, RADIUS, INK_GREEN);
    canvas_flood_fill(c, X, Y, 4, INK_BLUE, seeds, SEEDS);
}

static void clear(const struct canvas *c)
{
    canvas_clear(c, INK_GREEN);
}

static const struct {
    const char *what;
    void (*draw)(const struct canvas *canvas);
} figures[] = {
    {"line, Bresenham, 500 by 310", bresenham}, {"line, DDA in floats", dda},
    {"line, DDA in integers", dda_integer},     {"line, antialiased", antialiased},
    {"circle, midpoint, r = 180", circle},      {"ellipse, midpoint, 280 by 180", ellipse},
    {"polygon fill, triangle", triangle},       {"polygon fill, star, non-zero", star},
    {"flood fill, disc of r = 180", flood},     {"clear the page", clear},
};

static void measure_figures(struct monitor *m)
{
    for (unsigned i = 0; i < sizeof figures / sizeof figures[0]; i++) {
        stage_begin(&m->stage);
        const struct canvas *c = &m->stage.canvas;
        uint32_t before = csr_read_minstret();
        figures[i].draw(c);
        uint32_t spent = csr_read_minstret() - before;
        row(figures[i].what, lit(c), "pixels", spent);
        stage_end(&m->stage);
    }
}

/* ---- a solid of about a thousand triangles --------------------------------------------------------- */

static void measure_solid(struct monitor *m, enum shading shading)
{
    char what[64];
    struct studio *s = studio();
    struct studio_pose pose = {600, 400, 390, 30, 35, 5};
    stage_begin(&m->stage);
    uint32_t before = csr_read_minstret();
    canvas_clear(&m->stage.canvas, INK_BLACK);
    struct studio_cost cost = studio_shade(s, &m->stage, &pose, shading, RAMP_COPPER);
    uint32_t all = csr_read_minstret() - before;
    stage_title(&m->stage, shading_names[shading]);
    stage_end(&m->stage);
    snprintf(what, sizeof what, "%s, %d triangles", shading_names[shading], s->mesh.triangles);
    row(what, cost.pixels, "pixels", cost.shade);
    snprintf(what, sizeof what, "  vertices moved and projected");
    row(what, (uint32_t)s->mesh.vertices, "vertices", cost.place);
    snprintf(what, sizeof what, "  all of it, %.1f pictures a second",
             (double)board_clock_hz() / all);
    row(what, cost.triangles, "seen", all);
}

bool cost_run(struct monitor *m, struct words *w)
{
    enum { SEGMENTS = 32 }; /* round a torus: 1024 triangles */
    if (!words_end(w))
        return false;
    if (board_clock_hz() == 0 || m->stage.canvas.width < 640)
        return words_refuse(w, "this board has no picture of 640 by 480, or a clock nobody knows");
    printf("%-34s %7s %-9s %9s %8s %8s\n", "8 bits a pixel", "count", "of", "instr.", "each", "ms");
    struct studio *s = studio();
    struct lighting lighting = s->lighting; /* the user's */
    struct material material = s->material;
    struct power_table power = s->power;
    measure_figures(m);
    studio_reset(s);
    studio_solid(s, STUDIO_TORUS, SEGMENTS);
    for (int shading = 0; shading_names[shading] != NULL; shading++)
        measure_solid(m, (enum shading)shading);
    s->lighting = lighting;
    s->material = material;
    s->power = power;
    return true;
}
