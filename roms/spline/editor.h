/* editor.h — what the person does to the model: with the stylus, with the menu, with keys.
 *
 *      pointer ──┬─ menu item ────┐
 *                │                ▼
 *                └─ point, handle, slider, curve: drag       keys ──▶ editor_key ──▶ model
 *
 * Models:     one thing held at a time; each press, and each key that changes the model, is a step of undo.
 * Use:        the same letters stand in the menu: touching an item is typing its letter.
 * Units:      stage units; `part` 0…1 along the curve.
 * Ownership:  plain value, some 30 KB.
 * Errors:     what cannot be done is said in `message`.
 */
#ifndef ROMS_SPLINE_EDITOR_H
#define ROMS_SPLINE_EDITOR_H

#include "roms/spline/curve.h"
#include "roms/spline/history.h"

enum editor_grip { GRIP_NONE, GRIP_POINT, GRIP_IN, GRIP_OUT, GRIP_PART };
enum editor_console { CONSOLE_NOTHING, CONSOLE_SAVE, CONSOLE_LOAD, CONSOLE_QUIT };

/* Keys that are no characters. */
enum { EDITOR_UP = 0x100, EDITOR_DOWN, EDITOR_LEFT, EDITOR_RIGHT };

/* The line on which t is set. */
enum { SLIDER_LEFT = 70, SLIDER_RIGHT = 880, SLIDER_Y = 26 };

struct editor {
    struct model model;
    struct history history;
    bool polygon, hull, construction, comb; /* shown */
    float part;                             /* where the construction is */
    int chosen;                             /* a point; -1: none */
    enum editor_grip nudge; /* what the arrow keys move: GRIP_POINT, GRIP_IN, GRIP_OUT */
    const char *message;    /* NULL: none */
    /* The pointer. */
    struct vector3 at;
    bool near, pressed;
    /* What the console is to do next; whoever does it clears it. */
    enum editor_console wanted;
    /* Private. */
    enum editor_grip grip;
    struct vector3 offset; /* from the pointer to what is held */
    struct vector3 down;   /* where it was pressed */
    bool drags;            /* it has left that place: noise of a tablet moves nothing */
    bool kept;             /* this press is in the history */
};

/* As the pointer tells it (roms/interact/pointer.h); `second`: its second button was just pressed. */
struct editor_touch {
    struct vector3 at;
    bool near, pressed, pressed_now, released_now, second;
};

void editor_begin(struct editor *editor);
void editor_touch(struct editor *editor, const struct editor_touch *touch);
/* A character or EDITOR_…; false: it means nothing. */
bool editor_key(struct editor *editor, int key);
/* Another model, which undo takes back. */
void editor_take(struct editor *editor, const struct model *model);

#endif
