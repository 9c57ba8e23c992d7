#include "roms/raster/text_antialiased.h"

#include <math.h>

#include "roms/raster/font.h"

/* A cell: where it is, dots of the font a pixel, what the ramp is. */
struct cell {
    float x, y, dots_x, dots_y;
    const uint32_t *ramp;
    int levels;
};

static float overlap(float a0, float a1, float b0, float b1)
{
    float from = a0 > b0 ? a0 : b0, to = a1 < b1 ? a1 : b1;
    return to > from ? to - from : 0;
}

/* How much of each column of dots lies in the pixel's row, v0…v1 in dots from the cell's top. */
static void sum_rows(const uint8_t *rows, float v0, float v1, float *column)
{
    for (int i = 0; i < FONT_WIDTH; i++)
        column[i] = 0;
    int first = v0 > 0 ? (int)v0 : 0;
    for (int row = first; row < FONT_HEIGHT && (float)row < v1; row++) {
        float part = overlap(v0, v1, (float)row, (float)row + 1);
        for (int i = 0; rows[row] != 0 && i < FONT_WIDTH; i++)
            if (rows[row] & 0x80 >> i)
                column[i] += part;
    }
}

/* The dots of those columns that lie in the pixel, u0…u1. */
static float sum_columns(const float *column, float u0, float u1)
{
    float sum = 0;
    int first = u0 > 0 ? (int)u0 : 0;
    for (int i = first; i < FONT_WIDTH && (float)i < u1; i++)
        sum += column[i] * overlap(u0, u1, (float)i, (float)i + 1);
    return sum;
}

static void glyph(const struct canvas *c, const struct cell *k, char which)
{
    uint8_t rows[FONT_HEIGHT];
    float column[FONT_WIDTH], whole = 1 / (k->dots_x * k->dots_y);
    int x0 = (int)floorf(k->x), x1 = (int)ceilf(k->x + FONT_WIDTH / k->dots_x);
    int y0 = (int)floorf(k->y), y1 = (int)ceilf(k->y + FONT_HEIGHT / k->dots_y);
    for (int row = 0; row < FONT_HEIGHT; row++)
        rows[row] = font_row(which, row);
    for (int y = y0 > 0 ? y0 : 0; y < y1 && y < c->height; y++) {
        float v0 = ((float)y - k->y) * k->dots_y;
        sum_rows(rows, v0, v0 + k->dots_y, column);
        for (int x = x0 > 0 ? x0 : 0; x < x1 && x < c->width; x++) {
            float u0 = ((float)x - k->x) * k->dots_x;
            float covered = sum_columns(column, u0, u0 + k->dots_x) * whole;
            int level = (int)(covered * (float)(k->levels - 1) + 0.5f);
            if (level > 0)
                canvas_dot(c, x, y, k->ramp[level < k->levels ? level : k->levels - 1]);
        }
    }
}

void canvas_text_antialiased(const struct canvas *c, float x, float y, float width, float height,
                             const uint32_t *ramp, int levels, const char *text)
{
    const float most = 16, farthest = 30000;
    if (!(width >= 2) || !(height >= 3) || width > most * FONT_WIDTH ||
        height > most * FONT_HEIGHT || levels < 2 || !(y > -farthest) || !(y < farthest))
        return;
    for (; *text != '\0'; text++, x += width) {
        struct cell k = {x, y, FONT_WIDTH / width, FONT_HEIGHT / height, ramp, levels};
        if (*text != ' ' && x > -width && x < (float)c->width)
            glyph(c, &k, *text);
    }
}
