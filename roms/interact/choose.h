/* choose.h — a menu on the stage: items to be chosen with whatever points, and with keys.
 *
 *      ┌─────────────────┐
 *      │ A  Antenna    ● │  lamp: `lit` has its bit
 *      ├─────────────────┤
 *      │ B  Beacon     ○ │  bright frame: the pointer is over it, or cursor keys have come to it
 *      ├─────────────────┤
 *      │ C  Camera       │  bright all over: pressed
 *      └─────────────────┘
 *
 * Models:     the choice of graphics packages (GKS, ISO 7942). With a pointer an item is chosen when it is
 *             released inside the item where it was pressed: who changes his mind moves out. With keys: the
 *             item's own, or cursor keys and Enter. Items are filled on the raster head, dark but not
 *             black: a light pen sees them.
 * Use:                                        choose_column(&menu, items, 3, 20, 700, 300);
 *                                             each picture: choose_draw(&menu, &stage);
 *         while (pointer_poll(&pointer))      chosen = choose_event(&menu, &pointer);
 *         while (key_take(&key))              chosen = choose_key(&menu, &key);
 *             what is drawn has changed, and is to be drawn again: menu.changed, which the program clears.
 * Units:      stage units.
 * Ownership:  the items are the caller's, and must outlive the menu.
 * Errors:     none. Disabled items cannot be chosen; labels that are too long are cut.
 * Not modelled: menus that pop up, items of several lines.
 */
#ifndef ROMS_INTERACT_CHOOSE_H
#define ROMS_INTERACT_CHOOSE_H

#include <stdbool.h>
#include <stdint.h>

#include "roms/bsp/input.h"
#include "roms/interact/pointer.h"
#include "roms/stage/stage.h"

enum { CHOOSE_MOST = 32, CHOOSE_NONE = -1 };
enum { CHOOSE_HEIGHT = 48, CHOOSE_GAP = 8 };

struct choose_item {
    const char *label;
    char key; /* upper case, a digit or a sign; 0: none */
};

struct choose {
    const struct choose_item *items;
    int count;
    float left, bottom, width, height; /* of the whole menu */
    uint32_t disabled, lamps, lit;     /* bit n: item n cannot be chosen; has a lamp; which is on */
    bool focus;                        /* cursor keys and Enter are its; choose_…: true */
    int marked;   /* the pointer, or the cursor keys, have come to it; or NONE */
    bool changed; /* it looks different now */
    /* Private. */
    bool across;
    int over; /* the item under the pointer; or NONE */
    float item_width;
    int pressed; /* the item where the pointer was pressed; or NONE */
    bool inside; /* the pointer is still there */
};

/* Items below each other, or in a row: from the upper left corner, as wide as that altogether. */
void choose_column(struct choose *choose, const struct choose_item *items, int count, float left,
                   float top, float width);
void choose_row(struct choose *choose, const struct choose_item *items, int count, float left,
                float top, float width);
void choose_draw(const struct choose *choose, struct stage *stage);

/* What the pointer's last poll has chosen, or CHOOSE_NONE. */
int choose_event(struct choose *choose, const struct pointer *pointer);
int choose_key(struct choose *choose, const struct key_event *key);
/* The item at a place, or CHOOSE_NONE: also of disabled ones. */
int choose_at(const struct choose *choose, struct point2 place);

/* The upper left corner of an item; its width. */
struct point2 choose_corner(const struct choose *choose, int item);

#endif
