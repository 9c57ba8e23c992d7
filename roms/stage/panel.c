#include "roms/stage/panel.h"

#include <stdio.h>

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
