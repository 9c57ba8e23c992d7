/* view_parts.h — what the files of the view tell each other.
 *
 *      view.c: segments and what has changed     view_figures.c: figures     view_around.c: grid,
 *      menu, status, rubber band     view_help.c: the page that explains
 *
 * Models:     see view.h.
 * Ownership:  as there.
 * Errors:     as there.
 */
#ifndef ROMS_SKETCH_VIEW_PARTS_H
#define ROMS_SKETCH_VIEW_PARTS_H

#include "roms/sketch/view.h"

enum {
    NAME_GRID = 1,
    NAME_MENU,
    NAME_MARKS,
    NAME_BAND,
    NAME_STATUS,
    NAME_CURSOR,
    NAME_NEW,
    NAME_GROUP
};

/* What is put in between them takes the place of the segment of this name. */
void view_renew(struct view *view);
bool view_renewed(struct view *view, int name);

/* ---- view_figures.c -------------------------------------------------------------------------- */

void view_group(struct view *view, const struct tools *tools, int group);

/* ---- view_around.c --------------------------------------------------------------------------- */

void view_grid(struct view *view, const struct tools *tools);
void view_menu(struct view *view);
void view_marks(struct view *view, const struct tools *tools);
void view_band(struct view *view, const struct tools *tools, bool near);
void view_status(struct view *view, const struct tools *tools);
void view_cursor(struct view *view);

#endif
