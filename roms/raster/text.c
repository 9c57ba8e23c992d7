/* Text, a stretch of lit pixels at a time. */
#include <string.h>

#include "roms/raster/canvas.h"
#include "roms/raster/font.h"

static void glyph(const struct canvas *c, int x, int y, int sx, int sy, uint32_t colour, char which)
{
    for (int row = 0; row < FONT_HEIGHT; row++) {
        unsigned bits = font_row(which, row);
        for (int i = 0; i < FONT_WIDTH; i++) {
            int first = i;
            while (i < FONT_WIDTH && (bits & 0x80u >> i))
                i++;
            if (i > first)
                canvas_fill(c, x + first * sx, y + row * sy, (i - first) * sx, sy, colour);
        }
    }
}

void canvas_text(const struct canvas *c, int x, int y, int sx, int sy, uint32_t colour,
                 const char *text)
{
    for (; *text != '\0'; text++, x += FONT_WIDTH * sx)
        glyph(c, x, y, sx, sy, colour, *text);
}

void canvas_text_middle(const struct canvas *c, int x, int y, int sx, int sy, uint32_t colour,
                        const char *text)
{
    canvas_text(c, x - (int)strlen(text) * FONT_WIDTH * sx / 2, y, sx, sy, colour, text);
}
