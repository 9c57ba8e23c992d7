/* menu.h — a column of items that the stylus can touch, with the keys that do the same.
 *
 * Models:     which item is where; what holds is marked.
 * Units:      stage units.
 * Ownership:  nothing.
 * Errors:     none.
 */
#ifndef ROMS_SPLINE_MENU_H
#define ROMS_SPLINE_MENU_H

#include "roms/spline/editor.h"
#include "roms/stage/stage.h"

/* The item at a place; -1: none. */
int menu_item_at(struct vector3 at);
int menu_key(int item);
void menu_draw(const struct editor *editor, struct stage *stage);

#endif
