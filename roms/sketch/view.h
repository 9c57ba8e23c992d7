/* view.h — the drawing on both heads, through the segmented display file.
 *
 *      grid, menu ─ marks ─ 40 segments of 12 figures each ─ rubber band ─ status ─ cursor
 *                            only those whose figures have changed are made anew
 *
 * Models:     each segment is made under another name and takes the old one's, so that no refresh is
 *             without it. Figures are green, those of copies cyan, selected ones bright, moving ones
 *             yellow, what is pointed at orange; marks tell lines that are kept horizontal or vertical.
 * Time:       a picture a retrace at most: view_show waits for it.
 * Units:      stage units.
 * Ownership:  one for the program, which must not move (light_pen.h): it has the stage.
 * Errors:     groups of figures that find no room in display memory are not shown, and `full` is set;
 *             they are tried again after each step.
 */
#ifndef ROMS_SKETCH_VIEW_H
#define ROMS_SKETCH_VIEW_H

#include "roms/sketch/light_pen.h"
#include "roms/sketch/menu.h"
#include "roms/stage/segments.h"

enum {
    VIEW_GROUP = 12, /* figures of a segment */
    VIEW_GROUPS = DRAWING_FIGURES / VIEW_GROUP,
    VIEW_STATUS = 3,
    VIEW_STATUS_TEXT = 36
};

struct view {
    struct stage stage;
    struct segments segments;
    struct light_pen light_pen;
    bool full; /* not all of the drawing is shown */
    /* What is shown. */
    enum command tool;
    int picture;
    uint32_t settings; /* of the grid and of marks in the menu */
    int fullness, hot; /* figure that is pointed at; -1: none */
    bool selected[DRAWING_FIGURES], moving[DRAWING_FIGURES];
    bool stale[VIEW_GROUPS], lacking[VIEW_GROUPS]; /* to be made anew; not shown for want of room */
    uint32_t step;                                 /* of the history */
    char status[VIEW_STATUS][VIEW_STATUS_TEXT + 1];
    struct snapped cursor;
    struct place band_to;
    bool banded, near;
};

void view_open(struct view *view);
/* All anew: after another picture was on the stage. */
void view_draw(struct view *view, struct tools *tools);
/* What has changed; the cursor, unless near is false. */
void view_show(struct view *view, struct tools *tools, struct point2 cursor, bool near);
/* A line under the picture. */
void view_say(struct view *view, const char *text);
/* A page that explains; view_draw ends it. */
void view_help(struct view *view);

#endif
