/* mask — something to look at through a microscope: white, single dots, a line of text.
 *
 *      kinescope capture roms/mask.elf --closeup 512,384,18 --gain x0.3 -o delta.png
 *      kinescope capture roms/mask.elf --tube GRILLE17 --closeup 640,512,16 --gain x0.3 -o grille.png
 *      kinescope capture roms/mask.elf --tube SLOT14 --closeup 320,240,24 --gain x0.3 -o slot.png
 *
 * Without the lower gain what is white from afar is too bright near by: only a fifth of the screen
 * glows for each colour.
 *
 * The field is white: red, green and blue phosphor glow alike, and only their pattern is seen. In
 * the middle of the screen lies a dark window with a line of text; below it, from left to right,
 * single dots in white, red, green, blue, cyan, magenta, yellow: none is as small as the triads it
 * lights; then a pair of lines a dot wide, upright and level.
 *
 * Marks: 1 when the picture is complete.
 */
#include "roms/bsp/board.h"
#include "roms/bsp/console.h"
#include "roms/bsp/video.h"
#include "roms/raster/font.h"

/* 16 bits a pixel: rrrrrggggggbbbbb. */
enum {
    BLACK = 0x0000,
    WHITE = 0xFFFF,
    RED = 0xF800,
    GREEN = 0x07E0,
    BLUE = 0x001F,
    CYAN = GREEN | BLUE,
    MAGENTA = RED | BLUE,
    YELLOW = RED | GREEN
};

enum { WIDTH = 56, HEIGHT = 30, STEP = 5 };

static void window(const struct canvas *c, int x, int y)
{
    static const uint16_t dots[] = {WHITE, RED, GREEN, BLUE, CYAN, MAGENTA, YELLOW};
    const char *text = "PIXELS";
    canvas_fill(c, x, y, WIDTH, HEIGHT, BLACK);
    canvas_text(c, x + 4, y + 2, 1, 1, WHITE, text);
    for (int i = 0; i < 7; i++)
        canvas_fill(c, x + 5 + i * STEP, y + 20, 1, 1, dots[i]);
    for (int i = 0; i < 2; i++) {
        canvas_fill(c, x + 41 + 3 * i, y + 16, 1, 9, WHITE);
        canvas_fill(c, x + 47, y + 19 + 3 * i, 6, 1, WHITE);
    }
}

int main(void)
{
    if (!video_present()) {
        console_write("mask: this board has no raster head.\n");
        return 1;
    }
    struct canvas canvas = video_open(16);
    canvas_clear(&canvas, WHITE);
    window(&canvas, canvas.width / 2 - WIDTH / 2, canvas.height / 2 - HEIGHT / 2);
    video_on();
    board_mark(1);
    for (;;) {
        video_wait_retrace();
        int c = console_poll();
        if (c == 'q')
            return 0;
    }
}
