/* panel.h — a table or list in the picture: lines of text of one width, on both heads.
 *
 *      left, top ─▶┌ heading ──────────┐      characters of both heads take about the same room:
 *                  │  k     p     x  y │      columns that blanks make stand below each other
 *                  │  1    -7     1  8 │
 *                  └───────────────────┘
 *
 * Models:     a panel of so many columns of characters by so many lines.
 * Units:      stage units; columns of STAGE_CHARACTER, lines of STAGE_TEXT_LINE.
 * Ownership:  plain value; the stage must outlive it.
 * Errors:     text beyond the last column is cut off, lines beyond the last line are left out.
 * Source:     ours.
 */
#ifndef ROMS_STAGE_PANEL_H
#define ROMS_STAGE_PANEL_H

#include "roms/stage/stage.h"

enum { PANEL_COLUMNS = 72 };

struct panel {
    struct stage *stage;
    float left, top, width, height; /* of its frame */
    int columns, lines;
    int line; /* that comes next */
};

/* The room a panel takes. */
float panel_width(int columns);
float panel_height(int lines);

/* Draws a frame with a heading, which takes the first line; "": neither. */
struct panel panel_open(struct stage *stage, float left, float top, int columns, int lines,
                        const char *heading);
/* The next line, in this ink. */
void panel_line(struct panel *panel, enum ink ink, const char *text);

#endif
