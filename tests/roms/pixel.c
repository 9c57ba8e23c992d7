/* pixel — stores one pixel, and another over it when some frames have been shown. For tests of kinescope why,
 * which look for FIRST and SECOND here. */
#include "roms/bsp/board.h"
#include "roms/bsp/video.h"

enum { X = 320, Y = 240, FRAMES = 6 };

__attribute__((noinline)) static void first(volatile uint8_t *pixel)
{
    *pixel = 255; /* FIRST */
}

__attribute__((noinline)) static void second(volatile uint8_t *pixel)
{
    *pixel = 128; /* SECOND */
}

int main(void)
{
    struct canvas c = video_open(8);
    volatile uint8_t *pixel = (volatile uint8_t *)c.pixels + Y * c.pitch + X;
    for (unsigned i = 0; i < 256; i++)
        video_set_colour(i, i * 0x010101);
    first(pixel);
    video_on();
    for (int i = 0; i < FRAMES; i++)
        video_wait_retrace();
    second(pixel);
    board_mark(1);
    for (;;)
        video_wait_retrace();
}
