/* script.h — acts as text: read, and written.
 *
 *      at 0.5s pen move 512 300              # head units of the vector head
 *      pen down                              # right after what comes before it
 *      pen raster move 320 240 in 200ms      # within 200 ms
 *      +20ms pen away
 *      tablet near 100 80                    # stylus 5 mm above the surface
 *      tablet touch 120 80 in 0.3s           # moved down to the surface; there its tip is pressed
 *      touch raster 12.5 -30 mm
 *      touch up
 *      mouse move 20 -3 in 0.1s
 *      mouse click left
 *      key CONTROL+C
 *      type "line dda 0 0 4 5\n" in 0.5s
 *      knob vector brightness 0.2
 *
 * Statement:  one a line; `#` begins a comment.
 *
 *      [at T | +T] WHAT
 *
 *             It begins at T; or T after the end of the statement before it; or where that ended. `in T`
 *             says how long it takes. `at` may go back, but not before the beginning of the statement before
 *             it: what takes long goes on while later ones begin (a pen moves, keys are typed), and acts
 *             are put in order of time; of equal times, those of earlier statements first.
 *
 *      pen [S] move X Y [mm] [in T]         pen [S] down | up | away       pen [S] tap [in T]
 *      tablet near X Y [Z] [mm] [in T]      tablet touch X Y [mm] [in T]   tablet move X Y Z [mm] [in T]
 *      tablet press N | release N           tablet tap [in T]              tablet away
 *      touch [S] X Y [mm] [force N] [in T]  touch [S] tap X Y [mm] [force N] [in T]   touch [S] up
 *      mouse move DX DY [mm] [in T]         mouse press B | release B      mouse click B [in T]
 *      mouse lift | drop                    knob S brightness | contrast | focus VALUE
 *      key K[+K…] [as C] [in T]             key down K [as C]              key up K
 *      type "TEXT" [in T]                   wait T
 *
 * T:          0.5s, 20ms, 3us, 5ns, 7ps, 0; parts of a picosecond are dropped. Below 2^63 ps.
 * X, Y, Z:    decimal, at most three places. Of pen and touch in units of the head, with `mm` in
 *             millimetres; of tablet and mouse always in millimetres (act.h says from where).
 * S:          vector or raster. Without: the one that this device's statements named last; before any, the pen
 *             is at the vector head and the finger at the raster head.
 * Tablet:     near: the stylus to Z, 5 mm if not said, above the surface, tip not pressed. touch: to the
 *             surface, where the tip (button 0) is pressed at the end of the move, if it was not.
 * tap, click: pressed for T, 80 ms if not said; the finger is away after it.
 * force:      of the finger in newtons; not said: what the panel takes for usual.
 * K:          the names of inp_key_name() (keyboard.h), without regard to case; UNKNOWN, of down and up: the
 *             key 0. Keys joined by + are pressed in this order, held for T, 50 ms if not said (a key
 *             that is held long repeats), and released the other way round. What a press makes is what a US keyboard makes with the modifiers
 *             that the script holds at that time, or with `as` the character C between quotes, or
 *             `none`.
 * type:       the characters by a US keyboard's keys, one every 20 ms or within T in even steps. A key is
 *             pressed where its step begins and released after half of it, 50 ms at most. SHIFT is held where
 *             needed, and CONTROL for control characters without a key of their own. \n \r: ENTER,
 *             \t: TAB, \b: BACKSPACE, \e: ESCAPE; \\ \" \xHH. A SHIFT that `key down` holds is left alone, and
 *             the characters are those of the text.
 * Ownership:  inp_script_parse allocates the acts, the caller frees them.
 * Errors:     bytes are hostile. The first error as a sentence, NAME:LINE:COLUMN, columns in bytes from 1;
 *             nothing is read then.
 */
#ifndef INPUT_SCRIPT_H
#define INPUT_SCRIPT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "crt/error.h"
#include "input/act.h"

struct inp_script {
    struct inp_act *act; /* in order of t; malloced */
    size_t count;
    uint64_t end; /* ps: when every statement has ended, waits too */
};

/* Acts at most: 4 million. */
#define INP_SCRIPT_MOST 4000000

bool inp_script_parse(struct inp_script *script, const char *name, const char *text, size_t length,
                      struct crt_error *err);
void inp_script_free(struct inp_script *script);

/* One act as a statement with its time and a newline, and a NUL; its length. Reading it gives that act
 * back, bit for bit, if what act.h does not give a meaning to for its verb is 0. 0: no script can say it
 * (a device, button, key, place, time that there is not). */
#define INP_STATEMENT_MOST 160
size_t inp_script_write(const struct inp_act *act, char text[INP_STATEMENT_MOST]);

#endif
