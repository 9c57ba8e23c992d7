/* menu.h — what can be chosen, by pointing beside the drawing or by a key.
 *
 *      ┌──────────────────────────────┬─────────────┐
 *      │ drawing                      │ d Line      │      a row is one choice, or two halves:
 *      │                              │ …           │      , Turn .    left the one, right the other
 *      │                              │ ? Help      │
 *      ├──────────────────────────────┴─────────────┤
 *      │ tool, place, length, angle, attraction     │
 *      └────────────────────────────────────────────┘
 *
 * Models:     rows of text; each key is its letter, small or capital.
 * Units:      stage units.
 * Ownership:  constants.
 * Errors:     none.
 */
#ifndef ROMS_SKETCH_MENU_H
#define ROMS_SKETCH_MENU_H

#include "roms/bsp/input.h"
#include "roms/geometry/vector.h"
#include "roms/sketch/tools.h"
#include "roms/stage/stage.h"

enum {
    AREA_RIGHT = 905, /* of the drawing */
    AREA_BOTTOM = 80,
    AREA_TOP = 800,
    MENU_LEFT = 990,
    MENU_ROWS = 26
};

struct menu_row {
    const char *text;
    enum command left, right; /* the same, if it is one */
};

const struct menu_row *menu_row(int i);
/* Base line of its text. */
float menu_row_y(int i);
/* What is chosen there; COMMAND_NONE: nothing. */
enum command menu_at(struct point2 p);
/* The row of a command; -1: none. */
int menu_row_of(enum command command);
/* Of a character typed, small letters like capital ones; of a key. */
enum command menu_letter(unsigned character);
enum command menu_key(const struct key_event *key);
/* The name of a tool, and how it is used. */
const char *menu_tool(enum command tool);
const char *menu_hint(enum command tool);

#endif
