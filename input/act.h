/* act.h — what the person at the terminal does, and when: all that ever reaches an input device.
 *
 *      script ──┐
 *      window ──┴─▶ acts, in order of time ─▶ unit.h ─▶ the device that is meant
 *
 * Models:     a hand that takes a pen, a stylus, a finger or a mouse somewhere, presses and lets go;
 *             and keys. A move may take time: the hand goes at constant speed along a straight line
 *             from where it was.
 * Time:       picoseconds since power-on. Acts come in order of `t`; of equal ones the first first.
 * Position:   thousandths, so that text and numbers are the same: of a millimetre (INP_MM), or of a head
 *             unit (INP_UNITS: of the vector head from the bottom left, y up; of the raster head dots from
 *             the top left, y down; whole numbers are middles of dots), which whoever applies the act turns
 *             into millimetres first. Millimetres: pen, from the middle of the screen, y up; finger the same;
 *             stylus and puck: from the lower left corner of the tablet, z up from its surface; mouse: how
 *             far the hand moves, right and away from the person.
 * Ownership:  plain values.
 * Errors:     none here: a device that is absent, and places off a device, are for those that take acts.
 */
#ifndef INPUT_ACT_H
#define INPUT_ACT_H

#include <stdint.h>

enum inp_device { INP_PEN, INP_TABLET, INP_TOUCH, INP_KEYBOARD, INP_MOUSE, INP_KNOB, INP_DEVICES };

enum inp_verb {
    INP_MOVE, /* to x, y (tablet: z) within `duration`; a mouse: by x, y. A pen, a finger, a stylus that
                    was away appears there at once. */
    INP_AWAY,  /* pen, stylus: far away; finger: lifted; mouse: lifted, moves no longer count */
    INP_BACK,  /* mouse: put down again */
    INP_PRESS, /* pen: tip; tablet, mouse: button `code`; keyboard: key `code`, making `character` */
    INP_RELEASE, /* the same; of a key `character` is 0 */
    INP_TURN,    /* knob `code` (enum inp_knob) to x thousandths */
    INP_VERBS
};

enum inp_space { INP_MM, INP_UNITS };
enum inp_screen { INP_VECTOR, INP_RASTER, INP_SCREENS }; /* heads, as emu/heads.h numbers them */
enum inp_knob { INP_BRIGHTNESS, INP_CONTRAST, INP_FOCUS, INP_KNOBS };

struct inp_act {
    uint64_t t;        /* ps */
    uint64_t duration; /* ps; of moves */
    uint8_t device;    /* enum inp_device */
    uint8_t verb;      /* enum inp_verb */
    uint8_t screen;    /* enum inp_screen: of a pen, a finger, a knob */
    uint8_t space;     /* enum inp_space */
    int32_t x, y, z;   /* thousandths */
    uint8_t code;      /* button 0 …; KEYCODE_… (input_regs.h), 0: not known; knob */
    uint8_t character; /* ASCII that a key's press makes; 0: none */
};

/* Furthest place, thousandths: ten metres. */
#define INP_FURTHEST 10000000

#endif
