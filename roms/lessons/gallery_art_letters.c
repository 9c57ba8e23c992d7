/* gallery_art_letters.c — lettering on a cloth that waves, in perspective. */
#include <math.h>
#include <string.h>

#include "roms/lessons/gallery_art.h"
#include "roms/raster/font.h"

enum { LINES = 3 };

static const char *const words[LINES] = {"DRAWN", "WITH", "LIGHT"};

/* A place of the cloth, -1…1 across and up: where it is in the picture, and how it slopes. */
static struct point2 cloth(float x, float y, float t, float *slope)
{
    const float eye = 4.2f, scale = 2150;
    float phase = 3.1f * x + 1.1f * y - 1.6f * t, deep = 0.26f * sinf(phase);
    float turn = 0.5f * sinf(0.35f * t), c = cosf(turn), s = sinf(turn);
    float px = 0.98f * x * c + deep * s, pz = -0.98f * x * s + deep * c;
    float near = scale / (eye - pz);
    *slope = cosf(phase);
    return (struct point2){STAGE_WIDTH / 2 + px * near,
                           STAGE_HEIGHT / 2 + (0.62f * y + 0.06f * deep) * near};
}

/* A stretch of dots in a row of a letter, from dot a to dot b. */
static void stretch(struct stage *s, float left, float top, float width, float height, int row,
                    int a, int b, float t)
{
    float slope, unused;
    float x0 = left + width * (float)a / FONT_WIDTH, x1 = left + width * (float)b / FONT_WIDTH;
    float y0 = top - height * (float)row / FONT_HEIGHT;
    float y1 = top - height * ((float)row + 0.82f) / FONT_HEIGHT, y = (y0 + y1) / 2;
    const struct point2 p[4] = {cloth(x0, y0, t, &slope), cloth(x1, y0, t, &unused),
                                cloth(x1, y1, t, &unused), cloth(x0, y1, t, &unused)};
    struct point2 from = cloth(x0, y, t, &unused), to = cloth(x1, y, t, &unused);
    float light = 0.33f + 0.3f * slope;
    art_area(s, p, 4, ink_shade(RAMP_GOLD, light), INK_BLACK);
    stage_heads(s, STAGE_VECTOR);
    stage_ink(s, slope > 0.3f ? INK_BRIGHT : slope > -0.4f ? INK_CYAN : INK_TEXT);
    stage_line(s, from.x, from.y, to.x, to.y);
    stage_heads(s, STAGE_BOTH);
}

static void letter(struct stage *s, char which, float left, float top, float width, float height,
                   float t)
{
    for (int row = 0; row < FONT_HEIGHT; row++) {
        unsigned bits = font_row(which, row);
        for (int i = 0, first; i < FONT_WIDTH; i++) {
            for (first = i; i < FONT_WIDTH && (bits & 0x80u >> i); i++)
                ;
            if (i > first)
                stretch(s, left, top, width, height, row, first, i, t);
        }
    }
}

/* Threads of the cloth, behind the letters. */
static void threads(struct stage *s, float t)
{
    enum { THREADS = 7, PARTS = 24 };
    float unused;
    stage_ink(s, INK_GRID);
    for (int k = 0; k < THREADS; k++) {
        float y = 1.02f - 2.04f * (float)k / (THREADS - 1);
        struct point2 a = cloth(-1, y, t, &unused);
        for (int i = 1; i <= PARTS; i++) {
            struct point2 b = cloth(-1 + 2 * (float)i / PARTS, y, t, &unused);
            stage_line(s, a.x, a.y, b.x, b.y);
            a = b;
        }
    }
}

void art_lettering(struct stage *s, float seconds)
{
    const float high = 0.68f;
    threads(s, seconds);
    for (int k = 0; k < LINES; k++) {
        int count = (int)strlen(words[k]);
        float width = 1.9f / (float)count;
        for (int i = 0; i < count; i++)
            letter(s, words[k][i], -0.95f + width * ((float)i + 0.06f), 1.02f - high * (float)k,
                   width, high, seconds);
    }
}
