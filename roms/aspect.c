/* aspect — 1280 by 1024 dots on a screen of 4 to 3: a circle of equal radii is an egg.
 *
 *      kinescope run roms/aspect.elf
 *
 * 1280 to 1024 is 5 to 4, the screen is 4 to 3: dots are wider apart than rows. The figure on the
 * left has as many dots to its side as rows to its top; the one on the right is drawn with the
 * screen's size in mind (VIDEO_WIDTH_UM, VIDEO_HEIGHT_UM). Beneath each is what a ruler on the
 * glass would show. On a monitor that cannot follow that mode the same is shown in the one it has.
 *
 * Marks: 1 when the picture is complete.
 */
#include <stdio.h>

#include "roms/bsp/board.h"
#include "roms/bsp/console.h"
#include "roms/bsp/video.h"
#include "roms/raster/font.h"

enum { BLACK, GRID, EDGE, TEXT, EGG, ROUND, COLOURS = 16 };

/* VESA DMT: 1280x1024@60, 63.981 kHz. */
static const struct video_timing sxga = {.clock_hz = 108000000,
                                         .h_visible = 1280,
                                         .h_sync_start = 1328,
                                         .h_sync_end = 1440,
                                         .h_total = 1688,
                                         .v_visible = 1024,
                                         .v_sync_start = 1025,
                                         .v_sync_end = 1028,
                                         .v_total = 1066,
                                         .sync = VIDEO_SYNC_H_PLUS | VIDEO_SYNC_V_PLUS};

static void colours(void)
{
    static const uint32_t rgb[COLOURS] = {
        [BLACK] = 0x000000, [GRID] = 0x303848, [EDGE] = 0x808890,
        [TEXT] = 0xE8E8E8,  [EGG] = 0xFF7850,  [ROUND] = 0x60E890};
    for (unsigned i = 0; i < COLOURS; i++)
        video_set_colour(i, rgb[i]);
}

/* Micrometres of `pixels` pixels, where `all` of them are `um` wide, as "112.5". */
static void millimetres(char *text, size_t size, int pixels, int all, uint32_t um)
{
    unsigned tenths = (unsigned)(((uint64_t)um * (unsigned)pixels / (unsigned)all + 50) / 100);
    snprintf(text, size, "%u.%u", tenths / 10, tenths % 10);
}

/* A figure about x, y: its outline three pixels thick, a box around it, axes, what it measures. */
static void figure(const struct canvas *c, int x, int y, int rx, int ry, uint32_t colour,
                   const char *title)
{
    char text[64], width[16], height[16];
    int scale = c->width >= 1000 ? 2 : 1, row = FONT_HEIGHT * scale + 6;
    canvas_frame(c, x - rx, y - ry, 2 * rx + 1, 2 * ry + 1, 1, EDGE);
    canvas_line(c, x - rx, y, x + rx, y, EDGE);
    canvas_line(c, x, y - ry, x, y + ry, EDGE);
    for (int i = 0; i < 3; i++)
        canvas_ellipse(c, x, y, rx - i, ry - i, colour);
    canvas_text_middle(c, x, y - ry - 2 * row, scale, scale, colour, title);
    snprintf(text, sizeof text, "%d dots x %d rows", 2 * rx + 1, 2 * ry + 1);
    canvas_text_middle(c, x, y + ry + row, scale, scale, TEXT, text);
    millimetres(width, sizeof width, 2 * rx + 1, c->width, video_width_um());
    millimetres(height, sizeof height, 2 * ry + 1, c->height, video_height_um());
    snprintf(text, sizeof text, "%s mm x %s mm", width, height);
    canvas_text_middle(c, x, y + ry + 2 * row, scale, scale, colour, text);
}

/* Squares of a tenth of the height, as the glass has them. */
static void grid(const struct canvas *c)
{
    for (int i = -5; i <= 5; i++) {
        int y = c->height / 2 + i * c->height / 10;
        canvas_fill(c, 0, y < c->height ? y : y - 1, c->width, 1, GRID);
    }
    int cell = canvas_round_dots(c, c->height / 10);
    for (int x = c->width / 2 % cell; x < c->width; x += cell)
        canvas_fill(c, x, 0, 1, c->height, GRID);
}

static void draw(const struct canvas *c)
{
    char text[128];
    int scale = c->width >= 1000 ? 2 : 1, radius = c->height * 26 / 100;
    canvas_clear(c, BLACK);
    grid(c);
    snprintf(text, sizeof text, "%d x %d on %lu x %lu mm: rows are %d.%03d dots apart", c->width,
             c->height, (unsigned long)video_width_um() / 1000,
             (unsigned long)video_height_um() / 1000, (int)c->dots_a_row,
             (int)(c->dots_a_row * 1000.0f + 0.5f) % 1000);
    canvas_text_middle(c, c->width / 2, c->height / 20, scale, scale, TEXT, text);
    int y = c->height * 53 / 100;
    figure(c, c->width / 4, y, radius, radius, EGG, "equal radii");
    figure(c, c->width * 3 / 4, y, canvas_round_dots(c, radius), radius, ROUND,
           "corrected for the screen");
}

int main(void)
{
    if (!video_present()) {
        console_write("aspect: this board has no raster head.\n");
        return 1;
    }
    if (!video_set_timing(&sxga))
        console_write("aspect: this monitor cannot follow 1280x1024; its own mode is shown.\n");
    struct canvas canvas = video_open(4);
    colours();
    draw(&canvas);
    video_on();
    board_mark(1);
    for (;;) {
        video_wait_retrace();
        int c = console_poll();
        if (c == 'q')
            return 0;
    }
}
