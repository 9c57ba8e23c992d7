#include "roms/raster/text_turned.h"

#include "roms/raster/font.h"

/* Along the text and downwards in a cell, for each direction: what x and y get of it. */
static const struct {
    int along_x, along_y, down_x, down_y;
} axes[] = {
    [TEXT_RIGHT] = {1, 0, 0, 1},
    [TEXT_UP] = {0, -1, 1, 0},
    [TEXT_LEFT] = {-1, 0, 0, -1},
    [TEXT_DOWN] = {0, 1, -1, 0},
};

/* The rectangle from a0 to a1 along the text, d0 to d1 down from its top. */
static void rectangle(const struct canvas *c, int x, int y, enum text_direction direction, int a0,
                      int a1, int d0, int d1, uint32_t colour)
{
    int ax = axes[direction].along_x, ay = axes[direction].along_y;
    int dx = axes[direction].down_x, dy = axes[direction].down_y;
    int x0 = x + a0 * ax + d0 * dx, y0 = y + a0 * ay + d0 * dy;
    int x1 = x + a1 * ax + d1 * dx, y1 = y + a1 * ay + d1 * dy;
    int left = x0 < x1 ? x0 : x1, top = y0 < y1 ? y0 : y1;
    canvas_fill(c, left, top, x0 + x1 - 2 * left, y0 + y1 - 2 * top, colour);
}

static void glyph(const struct canvas *c, int x, int y, const struct text_cell *cell, int begin,
                  uint32_t colour, char which)
{
    const uint8_t *rows = font_rows(which);
    for (int row = 0; row < FONT_HEIGHT; row++) {
        unsigned bits = rows[row * FONT_NEXT_ROW];
        int d0 = row * cell->height / FONT_HEIGHT, d1 = (row + 1) * cell->height / FONT_HEIGHT;
        for (int i = 0; i < FONT_WIDTH; i++) {
            int first = i;
            while (i < FONT_WIDTH && (bits & 0x80u >> i))
                i++;
            if (i > first)
                rectangle(c, x, y, cell->direction, begin + first * cell->width / FONT_WIDTH,
                          begin + i * cell->width / FONT_WIDTH, d0, d1, colour);
        }
    }
}

void canvas_text_turned(const struct canvas *c, int x, int y, const struct text_cell *cell,
                        uint32_t colour, const char *text)
{
    if (cell->width < 1 || cell->height < 1 || cell->width > TEXT_LARGEST ||
        cell->height > TEXT_LARGEST)
        return;
    for (int begin = 0; *text != '\0'; text++, begin += cell->width)
        glyph(c, x, y, cell, begin, colour, *text);
}
