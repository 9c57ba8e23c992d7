#include "roms/raster/text_antialiased.h"

#include <math.h>

#include "roms/raster/font.h"

/* A cell: where it is, dots of the font a pixel, what the ramp is. */
struct cell {
    float x, y, dots_x, dots_y;
    const uint32_t *ramp;
    int levels;
};

/* Dots of a character that lie above each row, for each column of the font. */
struct dots {
    float above[FONT_HEIGHT + 1][FONT_WIDTH];
};

static void sum_dots(struct dots *d, char which)
{
    for (int i = 0; i < FONT_WIDTH; i++)
        d->above[0][i] = 0;
    const uint8_t *rows = font_rows(which);
    for (int row = 0; row < FONT_HEIGHT; row++) {
        unsigned bits = rows[row * FONT_NEXT_ROW];
        for (int i = 0; i < FONT_WIDTH; i++)
            d->above[row + 1][i] = d->above[row][i] + (float)(bits >> (FONT_WIDTH - 1 - i) & 1);
    }
}

/* … and what lies above any height v, in dots from the cell's top. */
static void sum_above(const struct dots *d, float v, float *column)
{
    v = v > 0 ? v < FONT_HEIGHT ? v : FONT_HEIGHT : 0;
    int row = (int)v < FONT_HEIGHT - 1 ? (int)v : FONT_HEIGHT - 1;
    float part = v - (float)row;
    for (int i = 0; i < FONT_WIDTH; i++)
        column[i] = d->above[row][i] + part * (d->above[row + 1][i] - d->above[row][i]);
}

/* What of a row of pixels lies to the left of u, in dots; left: the same at whole dots. */
static inline float sum_left(const float *left, float u)
{
    u = u > 0 ? u < FONT_WIDTH ? u : FONT_WIDTH : 0;
    int i = (int)u < FONT_WIDTH - 1 ? (int)u : FONT_WIDTH - 1;
    return left[i] + (u - (float)i) * (left[i + 1] - left[i]);
}

/* A row of the cell's pixels; left: dots that they cover, summed from the left. */
static void glyph_row(const struct canvas *c, const struct cell *k, int y, const float *left)
{
    float scale = (float)(k->levels - 1) / (k->dots_x * k->dots_y);
    int x = (int)floorf(k->x), end = (int)ceilf(k->x + FONT_WIDTH / k->dots_x);
    x = x > 0 ? x : 0;
    end = end < c->width ? end : c->width;
    float u = ((float)x - k->x) * k->dots_x, before = sum_left(left, u);
    for (; x < end; x++) {
        u += k->dots_x;
        float now = sum_left(left, u);
        int level = (int)((now - before) * scale + 0.5f);
        before = now;
        if (level > 0)
            canvas_dot(c, x, y, k->ramp[level < k->levels ? level : k->levels - 1]);
    }
}

static void shaded_glyph(const struct canvas *c, const struct cell *k, char which)
{
    struct dots dots;
    float above[FONT_WIDTH], below[FONT_WIDTH], left[FONT_WIDTH + 1] = {0};
    int y = (int)floorf(k->y), end = (int)ceilf(k->y + FONT_HEIGHT / k->dots_y);
    y = y > 0 ? y : 0;
    end = end < c->height ? end : c->height;
    sum_dots(&dots, which);
    sum_above(&dots, ((float)y - k->y) * k->dots_y, above);
    for (; y < end; y++) {
        sum_above(&dots, ((float)(y + 1) - k->y) * k->dots_y, below);
        for (int i = 0; i < FONT_WIDTH; i++) {
            left[i + 1] = left[i] + below[i] - above[i];
            above[i] = below[i];
        }
        glyph_row(c, k, y, left);
    }
}

void canvas_text_antialiased(const struct canvas *c, float x, float y, float width, float height,
                             const uint32_t *ramp, int levels, const char *text)
{
    const float most = 16;
    if (!(width >= 2) || !(height >= 3) || width > most * FONT_WIDTH ||
        height > most * FONT_HEIGHT || levels < 2 || !(x > -30000) || !(y > -height) ||
        !(y < (float)c->height))
        return;
    for (; *text != '\0'; text++, x += width) {
        struct cell k = {x, y, FONT_WIDTH / width, FONT_HEIGHT / height, ramp, levels};
        if (*text != ' ' && x > -width && x < (float)c->width)
            shaded_glyph(c, &k, *text);
    }
}

/* ---- kept ------------------------------------------------------------------------------------ */

void text_shades_begin(struct text_shades *s, float width, float height, const uint32_t *ramp,
                       int levels)
{
    if (s->width == width && s->height == height && s->ramp == ramp && s->levels == levels)
        return;
    *s = (struct text_shades){.width = width, .height = height, .ramp = ramp, .levels = levels};
}

bool text_shades_fit(float width, float height)
{
    return width >= 2 && height >= 3 && width <= TEXT_SHADES_WIDTH && height <= TEXT_SHADES_HEIGHT;
}

/* The character as it will be drawn. */
static struct canvas kept_glyph(struct text_shades *s, char which)
{
    const char text[2] = {which, '\0'};
    unsigned code = (unsigned char)which % TEXT_SHADES_CODES;
    struct canvas c = {.pixels = s->glyph[code],
                       .width = (int)ceilf(s->width),
                       .height = (int)ceilf(s->height),
                       .bits = 8,
                       .dots_a_row = 1,
                       .pitch = TEXT_SHADES_WIDTH};
    if (s->known[code])
        return c;
    s->known[code] = true;
    canvas_clear(&c, s->ramp[0]);
    canvas_text_antialiased(&c, 0, 0, s->width, s->height, s->ramp, s->levels, text);
    return c;
}

static void copy_glyph(const struct canvas *c, const struct canvas *glyph, int x, int y,
                       uint32_t ground)
{
    for (int row = y < 0 ? -y : 0; row < glyph->height && y + row < c->height; row++) {
        const uint8_t *from = glyph->pixels + (uint32_t)row * glyph->pitch;
        uint8_t *to = c->pixels + (uint32_t)(y + row) * c->pitch + x;
        for (int i = x < 0 ? -x : 0; i < glyph->width && x + i < c->width; i++)
            if (from[i] != ground)
                to[i] = from[i];
    }
}

void canvas_text_shades(const struct canvas *c, struct text_shades *s, float x, float y,
                        const char *text)
{
    if (c->bits != 8 || s->levels < 2 || !text_shades_fit(s->width, s->height) ||
        !(y > -s->height) || !(y < (float)c->height) || !(x > -30000))
        return;
    int top = (int)floorf(y + 0.5f);
    for (; *text != '\0' && x < (float)c->width; text++, x += s->width) {
        if (*text == ' ' || x < -s->width)
            continue;
        struct canvas glyph = kept_glyph(s, *text);
        copy_glyph(c, &glyph, (int)floorf(x + 0.5f), top, s->ramp[0] & 0xFF);
    }
}
