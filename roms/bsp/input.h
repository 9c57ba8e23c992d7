/* input.h — light pens, tablet, touch panel, keyboard, mouse.
 *
 *      devices ──reports──▶ input_status() ──▶ pen_hit_take, tablet_take, touch_take, key_take, mouse_read
 *         └── line 7 ──▶ handler of the device (input_on)
 *
 * Models:     the registers of input/input_regs.h.
 * Use:        switch a device on, then take its reports by polling, or in a handler.
 * Units:      as in input_regs.h: the device's counts; nanometres and micrometres where a name says so.
 * Ownership:  contexts belong to the caller.
 * Errors:     on a board without input devices, and of devices that are not connected, nothing ever comes.
 * Source:     input/input_regs.h, emu/memmap.h.
 */
#ifndef ROMS_BSP_INPUT_H
#define ROMS_BSP_INPUT_H

#include <stdbool.h>
#include <stdint.h>

#include "input/input_regs.h"

enum input_head { INPUT_VECTOR, INPUT_RASTER };

/* Connected devices, INPUT_BIT_…; those with something to be taken. */
uint32_t input_present(void);
uint32_t input_status(void);
/* While the device (one INPUT_BIT_…) has something, handler(ctx) is called, which must take it. NULL: no
 * longer. */
void input_on(uint32_t bit, void (*handler)(void *ctx), void *ctx);

/* ---- light pens ------------------------------------------------------------------------------- */

struct pen_hit {
    uint32_t line, dot, field; /* of the beam, when the pulse came */
    bool lost;                 /* it fired again before this was taken */
};

/* Firings of the raster head's pen are latched from now on; only while its tip is pressed, if so. */
void pen_raster_on(bool only_pressed);
void pen_raster_off(void);
bool pen_hit_take(struct pen_hit *hit); /* false: there was none */
bool pen_tip(enum input_head head);
/* Whether the tip switch has changed since the last call. */
bool pen_tip_moved(enum input_head head);

/* ---- tablet ------------------------------------------------------------------------------------- */

struct tablet_report {
    int32_t x, y, z;
    unsigned proximity; /* TABLET_FAR … TABLET_TOUCH */
    unsigned buttons;
    uint32_t serial;
    bool lost; /* others before it */
};

struct tablet_facts {
    unsigned kind; /* TABLET_NONE … */
    uint32_t unit_nm, width, height;
    uint32_t millihertz;
};

struct tablet_facts tablet_facts(void);
/* `latest`: a newer report replaces one that was not taken. */
void tablet_on(bool latest);
void tablet_off(void);
bool tablet_take(struct tablet_report *report);
uint32_t tablet_raw(unsigned word);

/* ---- touch panel -------------------------------------------------------------------------------- */

struct touch_report {
    bool touched, unsure, lost;
    uint32_t x, y;      /* halves of positions */
    int32_t x_um, y_um; /* on the screen, from the addressable area's lower left corner */
    uint32_t serial;
};

struct touch_facts {
    unsigned kind; /* TOUCH_NONE … */
    enum input_head head;
    uint32_t columns, rows;
};

struct touch_facts touch_facts(void);
void touch_on(bool latest);
void touch_off(void);
bool touch_take(struct touch_report *report);

/* ---- keyboard ----------------------------------------------------------------------------------- */

struct key_event {
    uint8_t character; /* 0: none */
    uint8_t code;      /* KEYCODE_… */
    uint8_t modifiers; /* KEYMOD_… */
    bool up, repeat;
};

/* Events are stored from now on; whether keys go on to the console, too. */
void keyboard_on(bool console);
void keyboard_off(void); /* as at power-on: to the console only */
bool key_take(struct key_event *event);
/* Whether events were lost since the last call. */
bool key_lost(void);

/* ---- mouse -------------------------------------------------------------------------------------- */

struct mouse_state {
    int32_t dx, dy;   /* counts since the last call */
    unsigned buttons; /* bit 0 left, 1 middle, 2 right */
    bool overrun;
};

unsigned mouse_kind(void);
uint32_t mouse_unit_nm(void);
/* Whether anything has changed since the last call. */
bool mouse_read(struct mouse_state *state);

#endif
