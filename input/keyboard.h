/* keyboard.h — a keyboard: presses and releases with their times, characters, repeats.
 *
 *      key pressed ─▶ event (code, character, modifiers) ─▶ store ─▶ INPUT_KEY_EVENT
 *                 └─▶ characters as a terminal sends them ─▶ the console's UART
 *
 * Models:     modifiers, caps lock, automatic repeat of the key pressed last, a store of KEY_EVENTS_MOST
 *             events with what is lost flagged (input_regs.h): when it is full the newest is lost. Sent to
 *             the console: characters, Ctrl with a letter as a control character, the other keys by the
 *             sequences of a VT100 (ECMA-48) and its followers (xterm).
 * Modifiers:  an event's are those after it: the press of a shift key has KEYMOD_SHIFT, its release has not.
 *             Caps lock turns on and off when it is pressed.
 * Repeat:     as a VT100's: SHIFT, CONTROL and the like, ESCAPE, TAB, ENTER, and all keys while CONTROL is held
 *             do not repeat. A press of another key ends it, but of SHIFT, ALT, CAPS LOCK; the
 *             release of another does not. It makes what the press made. Repeat n comes at
 *             crt_tick_time(repeat_rate, n), n from 0, after repeat_after has passed.
 * Time:       picoseconds since power-on.
 * Ownership:  the caller owns the struct. Allocates nothing.
 * Errors:     a key pressed that is held, or released that is not, is no event. Key 0, not known, is never
 *             held: its presses make a character only, and none is no event. Guest trouble is a bit of
 *             the status register. Characters beyond ASCII are none.
 * Source:     DEC, VT100 User Guide (EK-VT100-UG), "auto repeat", and the tables of codes; the sequences of
 *             F5 … and of the editing keys: xterm's control sequences.
 * Not modelled: layouts: an act says which character the press makes (inp_key_us() for who does not know).
 */
#ifndef INPUT_KEYBOARD_H
#define INPUT_KEYBOARD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "crt/state.h"
#include "crt/tube_table.h"
#include "input/act.h"
#include "input/input_regs.h"

/* X(field, unit, value, low, high, meaning, source) */
#define INP_KEYBOARD_FIGURES(X)                                                                    \
    X(repeat_after, "us", 500000, 10000, 1e7, "from the press to the first repeat",                \
      "DEC EK-VT100-UG: more than half a second")                                                  \
    X(repeat_rate, "Hz", 30, 0.1, 100, "repeats a second", "DEC EK-VT100-UG: about 30 a second")

struct inp_keyboard_setup {
#define X(field, unit, value, low, high, meaning, source) struct crt_figure field;
    INP_KEYBOARD_FIGURES(X)
#undef X
};

struct inp_keyboard_desc {
    const struct inp_keyboard_setup *setup;
    /* What goes to the console; false: there is no room, and it is lost. May be NULL. */
    void *ctx;
    bool (*send)(void *ctx, const char *bytes, size_t length, uint64_t t);
};

struct inp_keyboard {
    struct inp_keyboard_desc desc;
    uint32_t status, control; /* status: KEY_LOST only; KEY_READY follows from `waiting` */
    uint32_t held[256 / 32];  /* keys, by code */
    bool caps;
    uint8_t repeating, character; /* the key that repeats, 0: none; what it makes */
    uint64_t repeat_from;         /* when its first repeat was due, ps */
    uint64_t repeats;             /* how many there have been */
    uint32_t missed;
    unsigned first, waiting; /* a ring */
    uint32_t store[KEY_EVENTS_MOST];
};

void inp_keyboard_init(struct inp_keyboard *keyboard, const struct inp_keyboard_desc *desc);
void inp_keyboard_reset(struct inp_keyboard *keyboard, uint64_t t);
void inp_keyboard_act(struct inp_keyboard *keyboard, const struct inp_act *act, uint64_t t);
uint64_t inp_keyboard_next(const struct inp_keyboard *keyboard);    /* the next repeat */
bool inp_keyboard_event(struct inp_keyboard *keyboard, uint64_t t); /* true: an event was stored */
/* Reading INPUT_KEY_EVENT takes an event. */
bool inp_keyboard_read(struct inp_keyboard *keyboard, uint32_t offset, uint32_t *value);
bool inp_keyboard_write(struct inp_keyboard *keyboard, uint32_t offset, uint32_t value, uint64_t t);
bool inp_keyboard_ready(const struct inp_keyboard *keyboard);

/* The character that a key of a US keyboard makes with these modifiers (KEYMOD_…); 0: none. With
 * KEYMOD_CONTROL a letter, [ \ ] ^ _ and a VT100's ~ (RS), ? (US) make control characters, and the other
 * printable keys none; ENTER, TAB, BACKSPACE, ESCAPE make 13, 9, 127, 27. */
uint8_t inp_key_us(uint8_t code, unsigned modifiers);
/* The key of a US keyboard that makes the character, and whether with shift; 0: none. Of the control
 * characters only those with a key of their own: \r and \n (ENTER), \t, \b and 127 (BACKSPACE), 27. */
uint8_t inp_key_of(uint8_t character, bool *shift);
/* What a terminal sends for a press that makes the character; its length, at most 8. */
size_t inp_key_sent(uint8_t code, uint8_t character, unsigned modifiers, char bytes[8]);
/* "A", "F1", "ENTER", "PAD_5" …; NULL: no such key. Names are without regard to case; 0: no such name. */
const char *inp_key_name(uint8_t code);
uint8_t inp_key_named(const char *name, size_t length);
/* The character that a press makes when its act says `character`: the key's own where it makes the same on
 * every layout, the control character while CONTROL is held. With CONTROL and ALT both, which is
 * AltGr on some hosts, a character that the act gives stands. */
uint8_t inp_key_makes(uint8_t code, uint8_t character, unsigned modifiers);

/* A snapshot's section "KEYB". */
void inp_keyboard_state(struct inp_keyboard *keyboard, struct crt_state *s);

#endif
