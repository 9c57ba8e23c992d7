/* space_pages.h — the pictures of the lesson on space, each a function of its own time.
 *
 * Units:      seconds since the page began; angles in degrees.
 * Ownership:  plain values.
 * Errors:     none.
 */
#ifndef ROMS_LESSONS_SPACE_PAGES_H
#define ROMS_LESSONS_SPACE_PAGES_H

#include "roms/stage/stage.h"

/* How the viewer stands: added to a page's own turn and tilt. */
struct space_viewer {
    float turn, tilt;
};

struct space_page {
    float lasts;
    void (*draw)(struct stage *stage, float seconds, struct space_viewer viewer);
};

void space_page_axes(struct stage *stage, float seconds, struct space_viewer viewer);
void space_page_line(struct stage *stage, float seconds, struct space_viewer viewer);
void space_page_parallel(struct stage *stage, float seconds, struct space_viewer viewer);
void space_page_one_point(struct stage *stage, float seconds, struct space_viewer viewer);
void space_page_two_point(struct stage *stage, float seconds, struct space_viewer viewer);
void space_page_three_point(struct stage *stage, float seconds, struct space_viewer viewer);

#endif
