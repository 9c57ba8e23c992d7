/* pattern — test patterns, as the service menus of monitors have them.
 *
 *      kinescope run roms/pattern.elf [--mode 800x600@75] [--tube GRILLE17] [--console]
 *
 * At first a card with everything. A letter on the console chooses one for one thing:
 *
 *      a   the card: bars, greys, wedges, stars, black and white edges, mode and rates
 *      b   colour bars (SMPTE's): colours, saturation; near black: brightness
 *      c   crosshatch and circles: geometry; whether red, green and blue meet
 *      g   gamma: patches that give as much light as the lines around them
 *      r   resolution: wedges, stars and line pairs in both directions
 *      f   text all over: focus in the middle and in the corners
 *      w   white;  1, 2, 3   red, green, blue: purity, evenness;  k   black
 *      q   ends the program
 *
 * Cells of the grid are square and circles round on the glass in every mode.
 * Marks: n when the n-th picture is complete.
 */
#include "roms/bsp/board.h"
#include "roms/bsp/console.h"
#include "roms/pattern/pattern.h"

/* False: no such letter. */
static bool draw(const struct pattern *p, int letter)
{
    switch (letter) {
    case 'a':
        pattern_card(p);
        return true;
    case 'b':
        pattern_bars(p);
        return true;
    case 'c':
        pattern_hatch(p);
        return true;
    case 'g':
        pattern_gamma(p);
        return true;
    case 'r':
        pattern_resolution(p);
        return true;
    case 'f':
        pattern_focus(p);
        return true;
    case 'w':
        pattern_field(p, 0xFFFFFF);
        return true;
    case 'k':
        pattern_field(p, 0x000000);
        return true;
    case '1':
        pattern_field(p, 0xFF0000);
        return true;
    case '2':
        pattern_field(p, 0x00FF00);
        return true;
    case '3':
        pattern_field(p, 0x0000FF);
        return true;
    default:
        return false;
    }
}

int main(void)
{
    static struct pattern p;
    uint32_t mark = 1;
    if (!video_present()) {
        console_write("pattern: this board has no raster head.\n");
        return 1;
    }
    pattern_begin(&p);
    draw(&p, 'a');
    video_on();
    board_mark(mark);
    console_write("Patterns: a card, b bars, c crosshatch, g gamma, r resolution, f focus,\n"
                  "w white, k black, 1 red, 2 green, 3 blue; q ends.\n");
    for (;;) {
        video_wait_retrace();
        int c = console_poll();
        if (c == 'q')
            return 0;
        if (draw(&p, c))
            board_mark(++mark);
    }
}
