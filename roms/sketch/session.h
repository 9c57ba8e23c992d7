/* session.h — a person at the drawing: pointer, keys and console in, pictures and text out.
 *
 *      pointer ─ keys ─ console ──▶ commands, places ──▶ tools ──▶ view
 *                          └─ load: lines up to `end` ──▶ text reader ──▶ one step of the history
 *
 * Models:     keys and the console's bytes choose alike; while a text is being loaded the console's
 *             lines are that text. Escape, or a press, leaves off loading.
 * Time:       a round a retrace while something changes, else some milliseconds.
 * Ownership:  one for the program; it must not move (roms/interact/pointer.h).
 * Errors:     sentences on the screen; of a text that is not right on the console, too, with the
 *             number of its line. The drawing is then as it was.
 */
#ifndef ROMS_SKETCH_SESSION_H
#define ROMS_SKETCH_SESSION_H

#include "roms/interact/pointer.h"
#include "roms/interact/typed.h"
#include "roms/sketch/text.h"
#include "roms/sketch/view.h"

struct session {
    struct view view;
    struct tools tools;
    struct pointer pointer;
    bool helping, loading, shift;
    struct text_reader reader;
    char
        line[TEXT_LINE + 2]; /* of the console, while loading; one more tells that it is too long */
    int length;
    bool returned; /* the byte before was a carriage return */
    struct typed_rest rest;
};

_Noreturn void session_run(struct session *s);

#endif
