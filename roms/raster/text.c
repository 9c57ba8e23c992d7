/* Text. Characters of small dots that lie wholly on the canvas, nearly all there are, go dot by
 * dot: eight tests a row and a store a pixel. All others go stretch by stretch of lit dots, cut at
 * the canvas's edges. */
#include <stdbool.h>
#include <string.h>

#include "roms/raster/fill_row.h"
#include "roms/raster/font.h"
#include "roms/raster/plot.h"

struct pen {
    const struct canvas *canvas;
    int sx, sy; /* pixels of a dot */
    uint32_t colour;
    uint32_t word; /* filled with it */
};

/* ---- dot by dot ------------------------------------------------------------------------------ */

/* `bits` and `scale`, 1 or 2 pixels a dot, are constants where these are called: the compiler makes
 * a copy for each. */
static inline void dot(uint8_t *at, uint32_t pitch, unsigned bits, unsigned scale, uint32_t colour)
{
    plot_store(at, bits, colour);
    if (scale == 1)
        return;
    plot_store(at + bits / 8, bits, colour);
    plot_store(at + pitch, bits, colour);
    plot_store(at + pitch + bits / 8, bits, colour);
}

static inline void dots_of_row(uint8_t *at, uint32_t pitch, unsigned bits, unsigned scale,
                               uint32_t colour, unsigned lit)
{
    const unsigned next = bits / 8 * scale;
    if (lit & 0x80)
        dot(at, pitch, bits, scale, colour);
    if (lit & 0x40)
        dot(at + next, pitch, bits, scale, colour);
    if (lit & 0x20)
        dot(at + 2 * next, pitch, bits, scale, colour);
    if (lit & 0x10)
        dot(at + 3 * next, pitch, bits, scale, colour);
    if (lit & 0x08)
        dot(at + 4 * next, pitch, bits, scale, colour);
    if (lit & 0x04)
        dot(at + 5 * next, pitch, bits, scale, colour);
    if (lit & 0x02)
        dot(at + 6 * next, pitch, bits, scale, colour);
    if (lit & 0x01)
        dot(at + 7 * next, pitch, bits, scale, colour);
}

static inline void dots(const struct pen *p, int x, int y, const uint8_t *rows, unsigned bits,
                        unsigned scale)
{
    uint32_t pitch = p->canvas->pitch, colour = p->colour;
    uint8_t *at = p->canvas->pixels + (uint32_t)y * pitch + (uint32_t)x * (bits / 8);
    const uint8_t *end = rows + FONT_HEIGHT * FONT_NEXT_ROW;
    for (; rows < end; rows += FONT_NEXT_ROW, at += scale * pitch)
        if (*rows != 0)
            dots_of_row(at, pitch, bits, scale, colour, *rows);
}

static void glyph_dots(const struct pen *p, int x, int y, const uint8_t *rows)
{
    bool once = p->sx == 1;
    if (p->canvas->bits == 8 && once)
        dots(p, x, y, rows, 8, 1);
    else if (p->canvas->bits == 8)
        dots(p, x, y, rows, 8, 2);
    else if (p->canvas->bits == 16 && once)
        dots(p, x, y, rows, 16, 1);
    else if (p->canvas->bits == 16)
        dots(p, x, y, rows, 16, 2);
    else if (once)
        dots(p, x, y, rows, 32, 1);
    else
        dots(p, x, y, rows, 32, 2);
}

/* ---- stretch by stretch ---------------------------------------------------------------------- */

/* The pixels x0 to x1 of some rows. */
static void stretch(const struct pen *p, int x0, int x1, int top, int bottom)
{
    const struct canvas *c = p->canvas;
    x0 = x0 > 0 ? x0 : 0;
    x1 = x1 < c->width ? x1 : c->width;
    if (x0 >= x1)
        return;
    uint8_t *row = c->pixels + (uint32_t)top * c->pitch;
    for (; top < bottom; top++, row += c->pitch)
        fill_row(c, row, x0, x1, p->word);
}

static void glyph_stretches(const struct pen *p, int x, int y, const uint8_t *rows)
{
    for (int row = 0; row < FONT_HEIGHT; row++, y += p->sy) {
        unsigned lit = rows[row * FONT_NEXT_ROW];
        int top = y > 0 ? y : 0;
        int bottom = y + p->sy < p->canvas->height ? y + p->sy : p->canvas->height;
        if (top >= bottom)
            continue;
        for (int from = x, to; lit != 0; from = to) {
            for (; !(lit & 0x80); lit <<= 1)
                from += p->sx;
            for (to = from; lit & 0x80; lit = lit << 1 & 0xFF)
                to += p->sx;
            stretch(p, from, to, top, bottom);
        }
    }
}

/* ---- strings --------------------------------------------------------------------------------- */

void canvas_text(const struct canvas *c, int x, int y, int sx, int sy, uint32_t colour,
                 const char *text)
{
    if (sx < 1 || sy < 1 || y >= c->height || y + FONT_HEIGHT * sy <= 0)
        return;
    struct pen pen = {c, sx, sy, colour, canvas_repeated(c, colour)};
    int advance = FONT_WIDTH * sx;
    bool small = c->bits >= 8 && sx == sy && sx <= 2;
    bool whole = small && y >= 0 && y + FONT_HEIGHT * sy <= c->height;
    for (; *text != '\0' && x < c->width; text++, x += advance) {
        if (*text == ' ' || x + advance <= 0)
            continue;
        if (whole && x >= 0 && x + advance <= c->width)
            glyph_dots(&pen, x, y, font_rows(*text));
        else
            glyph_stretches(&pen, x, y, font_rows(*text));
    }
}

void canvas_text_middle(const struct canvas *c, int x, int y, int sx, int sy, uint32_t colour,
                        const char *text)
{
    canvas_text(c, x - (int)strlen(text) * FONT_WIDTH * sx / 2, y, sx, sy, colour, text);
}
