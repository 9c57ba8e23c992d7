/* menu.h — the lessons to choose from, drawn by the machine.
 *
 * Models:     two columns, chapters and gallery; one entry is marked.
 * Ownership:  plain value.
 * Errors:     none.
 */
#ifndef ROMS_MONITOR_MENU_H
#define ROMS_MONITOR_MENU_H

#include "roms/lessons/lesson.h"
#include "roms/stage/stage.h"

struct menu {
    int marked; /* index into lessons[] */
};

void menu_draw(const struct menu *menu, struct stage *stage);
/* Cursor keys move the mark; false: it is another key. */
bool menu_key(struct menu *menu, int key);
/* How many lessons there are. */
int menu_count(void);

#endif
