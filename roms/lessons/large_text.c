#include "roms/lessons/large_text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "roms/raster/font.h"

enum { TIMES = 2 };

void large_text(struct stage *s, float x, float y, const char *text)
{
    unsigned heads = s->heads;
    int column = (int)floorf(stage_canvas_x(s, x)), row = (int)floorf(stage_canvas_y(s, y));
    if (heads & STAGE_RASTER)
        canvas_text(&s->canvas, column, row - (FONT_HEIGHT - 2) * TIMES, TIMES, TIMES, s->ink,
                    text);
    stage_heads(s, heads & STAGE_VECTOR);
    stage_text(s, x, y, text);
    stage_heads(s, heads);
}

void large_text_middle(struct stage *s, float x, float y, const char *text)
{
    unsigned heads = s->heads;
    float half = (float)strlen(text) * LARGE_ADVANCE / 2;
    stage_heads(s, heads & STAGE_RASTER);
    large_text(s, x - half, y, text);
    stage_heads(s, heads & STAGE_VECTOR);
    stage_text_middle(s, x, y, text);
    stage_heads(s, heads);
}

static void bracket(struct stage *s, float x, float low, float high, float arm)
{
    const struct point2 p[] = {{x + arm, high}, {x, high}, {x, low}, {x + arm, low}};
    stage_polyline(s, p, 4);
}

/* Whole numbers as such, others with two decimals. */
static void element(char *text, size_t size, float v)
{
    if (fabsf(v - rintf(v)) < 0.005f)
        snprintf(text, size, "%5d", (int)rintf(v));
    else
        snprintf(text, size, "%5.2f", (double)v);
}

void large_matrix3(struct stage *s, float x, float y, const struct matrix3 *m)
{
    enum { COLUMN = 178, BRACKET = 14 };
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            char text[16];
            element(text, sizeof text, m->at[i][k]);
            large_text(s, x + 8 + (float)(k * COLUMN), y - (float)(i * LARGE_LINE), text);
        }
    float low = y - 2 * LARGE_LINE - 14, high = y + 46;
    bracket(s, x, low, high, BRACKET);
    bracket(s, x + LARGE_MATRIX_WIDTH, low, high, -BRACKET);
}
