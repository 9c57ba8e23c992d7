#include "roms/stage/panel.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { EDGE = 12 };

float panel_width(int columns)
{
    return (float)(columns * STAGE_CHARACTER + 2 * EDGE);
}

float panel_height(int lines)
{
    return (float)(lines * STAGE_TEXT_LINE + EDGE);
}

struct panel panel_open(struct stage *stage, float left, float top, int columns, int lines,
                        const char *heading)
{
    columns = columns < PANEL_COLUMNS ? columns : PANEL_COLUMNS;
    struct panel p = {.stage = stage,
                      .left = left,
                      .top = top,
                      .width = panel_width(columns),
                      .height = panel_height(lines),
                      .columns = columns,
                      .lines = lines};
    if (heading[0] == '\0')
        return p;
    enum ink ink = stage->ink;
    stage_ink(stage, INK_GRID);
    stage_rectangle(stage, left, top - p.height, p.width, p.height);
    stage_ink(stage, ink);
    panel_line(&p, INK_BRIGHT, heading);
    return p;
}

void panel_line(struct panel *p, enum ink ink, const char *text)
{
    char part[PANEL_COLUMNS + 1];
    enum ink before = p->stage->ink;
    if (p->line >= p->lines)
        return;
    snprintf(part, sizeof part, "%.*s", p->columns, text);
    stage_ink(p->stage, ink);
    p->line++;
    stage_text(p->stage, p->left + EDGE, p->top - (float)(p->line * STAGE_TEXT_LINE) + 2, part);
    stage_ink(p->stage, before);
}

void panel_print(struct panel *p, enum ink ink, const char *format, ...)
{
    char text[PANEL_COLUMNS + 1];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    panel_line(p, ink, text);
}

static void row(struct panel *p, enum ink ink, const float *at, int count, int decimals)
{
    char text[PANEL_COLUMNS + 1] = "";
    size_t length = 0;
    for (int k = 0; k < count && length < PANEL_COLUMNS; k++) {
        float value = fabsf(at[k]) < 0.00005f ? 0 : at[k]; /* no minus before a zero */
        int written = snprintf(text + length, sizeof text - length, "%*.*f", decimals + 5, decimals,
                               (double)value);
        length += written > 0 ? (size_t)written : 0;
    }
    panel_line(p, ink, text);
}

void panel_matrix3(struct panel *p, enum ink ink, const struct matrix3 *m, int decimals)
{
    for (int i = 0; i < 3; i++)
        row(p, ink, m->at[i], 3, decimals);
}

void panel_matrix4(struct panel *p, enum ink ink, const struct matrix4 *m, int decimals)
{
    for (int i = 0; i < 4; i++)
        row(p, ink, m->at[i], 4, decimals);
}
