#include "roms/stage/prompt.h"

#include <stdio.h>
#include <string.h>

#include "roms/bsp/dpu.h"
#include "roms/raster/font.h"

enum { AT_X = 20, AT_Y = 12, LEVEL = 5 };

uint32_t stage_prompt_begin(struct display *d)
{
    char blank[STAGE_PROMPT + 1];
    memset(blank, ' ', STAGE_PROMPT);
    blank[STAGE_PROMPT] = '\0';
    display_intensity(d, LEVEL);
    display_text(d, AT_X, AT_Y, blank);
    uint32_t first = d->at - STAGE_PROMPT;
    for (uint32_t at = first; at < d->at; at += 2)
        dpu_memory()[at / 2] = 0; /* characters that take no place */
    return first;
}

void stage_prompt_draw(const struct stage *stage, const struct canvas *c)
{
    int scale = c->height >= 900 ? 2 : 1, height = (FONT_HEIGHT + 2) * scale;
    canvas_fill(c, 0, c->height - height, c->width, height, INK_BLACK);
    canvas_text(c, FONT_WIDTH * scale, c->height - height, scale, scale, INK_CYAN, stage->prompted);
}

void stage_prompt(struct stage *stage, const char *text)
{
    snprintf(stage->prompted, sizeof stage->prompted, "%s", text);
    stage_prompt_draw(stage, &stage->page[stage->page_shown]);
    size_t length = strlen(stage->prompted);
    for (size_t i = 0; i < STAGE_PROMPT; i += 2) {
        unsigned low = i < length ? (unsigned char)stage->prompted[i] : 0;
        unsigned high = i + 1 < length ? (unsigned char)stage->prompted[i + 1] : 0;
        dpu_memory()[(stage->prompt + i) / 2] = (uint16_t)(high << 8 | low);
    }
}
