/* menu.h — a column of items that the stylus can touch, with the keys that do the same.
 *
 * Models:     which item is where; what holds is marked. Letters take long to draw, and the menu seldom
 *             changes: its pixels are kept.
 * Units:      stage units.
 * Ownership:  the kept pixels are the caller's.
 * Errors:     none; on a screen so large that they find no room it is drawn each time.
 */
#ifndef ROMS_SPLINE_MENU_H
#define ROMS_SPLINE_MENU_H

#include "roms/spline/editor.h"
#include "roms/stage/stage.h"

enum { MENU_PIXELS = 128 * 512 };

struct menu_kept {
    bool any;
    uint64_t state;          /* what they show */
    int x, y, width, height; /* x is a multiple of 4, the width of 16 */
    uint32_t pixels[MENU_PIXELS / 4];
};

/* The item at a place; -1: none. */
int menu_item_at(struct vector3 at);
int menu_key(int item);
/* Onto a canvas that is still empty there. */
void menu_draw(const struct editor *editor, struct stage *stage, struct menu_kept *kept);

#endif
