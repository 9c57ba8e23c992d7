/* heads — the same drawing by random scan and by raster scan.
 *
 *      kinescope run roms/heads.elf --view both
 *
 * On the vector head the beam follows each line: slanted lines are as smooth as level ones, and
 * their ends are bright, where the beam waits. On the raster head Bresenham's algorithm chooses
 * pixels, and the beam sweeps over them row by row: slanted lines are stairs. They are best seen
 * with few pixels; the program asks for 640 by 480 and keeps what there is where the monitor cannot.
 *
 * Marks: 1 when both are complete.
 */
#include "roms/bsp/board.h"
#include "roms/bsp/console.h"
#include "roms/bsp/display.h"
#include "roms/bsp/dpu.h"
#include "roms/bsp/interrupts.h"
#include "roms/bsp/video.h"
#include "roms/heads/heads.h"
#include "roms/raster/font.h"

/* VESA DMT 04h. */
static const struct video_timing vga = {25175000, 640, 656, 752, 800, 480, 490, 492, 525, 0};

/* ---- random scan ------------------------------------------------------------------------------- */

static void vector_level(void *ctx, unsigned level)
{
    display_intensity(ctx, level);
}

static int head_units(int v)
{
    return 12 + v;
}

static void vector_line(void *ctx, int x0, int y0, int x1, int y1)
{
    struct display *d = ctx;
    if (d->x != head_units(x0) || d->y != head_units(y0))
        display_at(d, head_units(x0), head_units(y0));
    display_line(d, head_units(x1), head_units(y1));
}

static void vector_text(void *ctx, int x, int y, const char *text)
{
    display_text(ctx, head_units(x), head_units(y), text);
}

static void random_scan(void)
{
    struct display d;
    const struct heads_pen pen = {&d, vector_level, vector_line, vector_text};
    display_begin(&d, 0, DPU_BYTES);
    display_sync(&d);
    heads_scene(&pen, "RANDOM SCAN: THE BEAM FOLLOWS THE LINES");
    display_jump(&d, 0);
    dpu_start(0);
}

/* ---- raster scan ------------------------------------------------------------------------------- */

struct raster {
    struct canvas canvas;
    uint32_t colour;
};

static int dot(const struct raster *r, int x)
{
    float across = (float)r->canvas.height * r->canvas.dots_a_row; /* of the square */
    return (int)((float)r->canvas.width / 2 + ((float)x / 1000.0f - 0.5f) * across);
}

static int row(const struct raster *r, int y)
{
    return (int)((float)(r->canvas.height - 1) * (1.0f - (float)y / 1000.0f) + 0.5f);
}

static void raster_level(void *ctx, unsigned level)
{
    ((struct raster *)ctx)->colour = level;
}

static void raster_line(void *ctx, int x0, int y0, int x1, int y1)
{
    const struct raster *r = ctx;
    canvas_line(&r->canvas, dot(r, x0), row(r, y0), dot(r, x1), row(r, y1), r->colour);
}

static void raster_text(void *ctx, int x, int y, const char *text)
{
    const struct raster *r = ctx;
    int scale = r->canvas.height >= 900 ? 2 : 1;
    canvas_text(&r->canvas, dot(r, x), row(r, y) - 10 * scale, scale, scale, r->colour, text);
}

/* Levels of a raster head that look like those of the other: entry 0 is black. */
static void levels(void)
{
    for (unsigned i = 0; i < 8; i++)
        video_set_colour(i, (i == 0 ? 0 : 80 + i * 25) * 0x010101u);
}

static void raster_scan(void)
{
    struct raster r;
    const struct heads_pen pen = {&r, raster_level, raster_line, raster_text};
    video_set_timing(&vga);
    r.canvas = video_open(4);
    levels();
    canvas_clear(&r.canvas, 0);
    heads_scene(&pen, "RASTER SCAN: THE BEAM FOLLOWS ITS ROWS");
    video_on();
}

int main(void)
{
    if (!board_has_vector_head() || !video_present()) {
        console_write("heads: this board does not have two heads.\n");
        return 1;
    }
    raster_scan();
    random_scan();
    board_mark(1);
    for (;;) {
        video_wait_retrace();
        int c = console_poll();
        if (c == 'q')
            return 0;
    }
}
