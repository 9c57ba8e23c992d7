/* clipping.h — the pages of the lesson on clipping.
 *
 * Models:     each draws its whole picture as it is so many seconds
 *             after it began.
 * Ownership:  nothing.
 * Errors:     none.
 */
#ifndef ROMS_LESSONS_CLIPPING_H
#define ROMS_LESSONS_CLIPPING_H

#include "roms/clip/window.h"
#include "roms/stage/stage.h"

/* Where the text beside the picture begins, and where the picture ends below the title; stage units. */
enum { CLIPPING_PANEL = 854, CLIPPING_TOP = 776 };

void clipping_regions(struct stage *stage, float since);
void clipping_cohen_sutherland(struct stage *stage, float since);
void clipping_liang_barsky(struct stage *stage, float since);
void clipping_fan(struct stage *stage, float since);
void clipping_polygon(struct stage *stage, float since);
void clipping_text(struct stage *stage, float since);

/* Windows in stage units. */
void clipping_window(struct stage *stage, const struct clip_window *window, enum ink ink);
/* The window's edges drawn on, and the codes of the nine regions. */
void clipping_codes(struct stage *stage, const struct clip_window *window);
void clipping_line(struct stage *stage, struct point2 a, struct point2 b, enum ink ink);
/* Three lines side by side on the raster head. */
void clipping_thick(struct stage *stage, struct point2 a, struct point2 b, enum ink ink);
/* What is cut away: dark red; dashed and dim on the vector head. */
void clipping_cut_away(struct stage *stage, struct point2 a, struct point2 b);
/* A line of the panel, the first is 0. */
void clipping_say(struct stage *stage, int line, enum ink ink, const char *text);
/* The four digits ABRL. */
void clipping_code(unsigned code, char text[5]);

#endif
