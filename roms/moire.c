/* moire — gratings of upright lines, to be seen through a shadow mask.
 *
 *      kinescope capture roms/moire.elf --tube SLOT14 --mode 1024x768@43i --set spot=0.25 --closeup 512,384,150 -o moire.png
 *
 * Seven bands from the top down: a line a dot wide every 2, 3, 4 … 8 dots. Their number stands at the left.
 * A mask has a grating of its own. Where a harmonic of the lines comes near to it, and the spot is fine enough to
 * draw that harmonic, the two beat: broad coloured stripes that are in neither.
 *
 * Marks: 1 when the picture is complete.
 */
#include "roms/bsp/board.h"
#include "roms/bsp/console.h"
#include "roms/bsp/video.h"
#include "roms/raster/font.h"

/* 16 bits a pixel: rrrrrggggggbbbbb. */
enum { BLACK = 0x0000, WHITE = 0xFFFF };
enum { BANDS = 7, FIRST = 2, GAP = 8 };

static void band(const struct canvas *c, int y, int height, int every)
{
    const char digit[2] = {(char)('0' + every), 0};
    int scale = height >= 4 * FONT_HEIGHT ? 3 : 1, left = scale * FONT_WIDTH + 2 * GAP;
    canvas_text(c, GAP, y + (height - scale * FONT_HEIGHT) / 2, scale, scale, WHITE, digit);
    for (int x = left; x < c->width; x += every)
        canvas_fill(c, x, y, 1, height, WHITE);
}

int main(void)
{
    if (!video_present()) {
        console_write("moire: this board has no raster head.\n");
        return 1;
    }
    struct canvas canvas = video_open(16);
    canvas_clear(&canvas, BLACK);
    int step = (canvas.height - GAP) / BANDS;
    for (int i = 0; i < BANDS; i++)
        band(&canvas, GAP + i * step, step - GAP, FIRST + i);
    video_on();
    board_mark(1);
    for (;;) {
        video_wait_retrace();
        if (console_poll() == 'q')
            return 0;
    }
}
