/* gallery_interface.h — a desktop of windows; private to roms/lessons/gallery_interface*.c.
 *
 *      ┌ Open  Window ─────────────────┐     pointer: arrow keys, or by itself
 *      │ ◷ ┌─x─ Clock ─┐               │     click (space) picks what is in front there: menu,
 *      │ ∿ │    ◴   ┌─x┴ Graph ─┐      │     title bar (drag until the next click), close
 *      │ ≡ └────────┤  ∿∿∿∿     │      │     box, window (to the front), icon (opens)
 *      └────────────┴───────────┴──────┘
 *
 * Models:     overlapping windows in an order; picking from the front; hidden parts are painted
 *             over on the raster head and cut out of every line on the vector head.
 * Units:      stage units.
 */
#ifndef ROMS_LESSONS_GALLERY_INTERFACE_H
#define ROMS_LESSONS_GALLERY_INTERFACE_H

#include <stdbool.h>

#include "roms/clip/window.h"
#include "roms/stage/stage.h"

enum { DESK_WINDOWS = 4, DESK_MENUS = 2, DESK_ITEMS = 4, DESK_NONE = -1 };
enum {
    DESK_BAR = 44 /* menu bar, title bars, items: height */,
    DESK_ICON = 100,
    DESK_MENU_WIDTH = 230
};
enum { DESK_CLOCK, DESK_GRAPH, DESK_NOTES, DESK_PICTURE };

struct desk_window {
    float x, y, width, height; /* lower left corner */
    bool open;
};

struct desk {
    struct desk_window window[DESK_WINDOWS];
    int order[DESK_WINDOWS]; /* from back to front */
    struct point2 pointer;
    int dragged; /* window, or DESK_NONE */
    int menu;    /* that is down, or DESK_NONE */
    /* By itself. */
    float now, touched; /* seconds; of the last key */
    int goal;
    bool alone;
};

extern const char *const desk_titles[DESK_WINDOWS];
extern const char *const desk_menus[DESK_MENUS];
extern const char *const desk_items[DESK_MENUS][DESK_ITEMS];

/* Where things are. */
struct clip_window desk_window_area(const struct desk *desk, int window);
struct clip_window desk_icon_area(int icon);
struct clip_window desk_menu_area(int menu);
struct clip_window desk_item_area(int menu, int item);
/* The window in front, or DESK_NONE. */
int desk_focus(const struct desk *desk);

/* gallery_interface_draw.c */
void desk_draw(const struct desk *desk, struct stage *stage);

#endif
