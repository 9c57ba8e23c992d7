/* space_chapters.h — the pictures of the lesson on space, each a function of its own time.
 *
 * Units:      seconds since the chapter began; angles in degrees.
 * Ownership:  plain values.
 * Errors:     none.
 */
#ifndef ROMS_LESSONS_SPACE_CHAPTERS_H
#define ROMS_LESSONS_SPACE_CHAPTERS_H

#include "roms/stage/stage.h"

/* How the viewer stands: added to a chapter's own turn and tilt. */
struct space_viewer {
    float turn, tilt;
};

struct space_chapter {
    float lasts;
    void (*draw)(struct stage *stage, float seconds, struct space_viewer viewer);
};

void space_chapter_axes(struct stage *stage, float seconds, struct space_viewer viewer);
void space_chapter_line(struct stage *stage, float seconds, struct space_viewer viewer);
void space_chapter_parallel(struct stage *stage, float seconds, struct space_viewer viewer);
void space_chapter_one_point(struct stage *stage, float seconds, struct space_viewer viewer);
void space_chapter_two_point(struct stage *stage, float seconds, struct space_viewer viewer);
void space_chapter_three_point(struct stage *stage, float seconds, struct space_viewer viewer);

#endif
