/* keys.h — keys from the console, and waiting for them.
 *
 *      UART bytes ──▶ characters; ESC [ A … ──▶ KEY_UP …      nobody types: the processor waits
 *
 * Models:     a terminal's keyboard: characters, and the sequences of ECMA-48 for cursor keys.
 * Time:       ticks of the timer (roms/bsp/timer.h). An ESC that nothing follows within 20 ms is the
 *             Escape key.
 * Ownership:  static: whether the last byte was the end of input. From then on keys_next tells it again
 *             and again, whoever has seen it first; a byte that comes behind it is a key like any other.
 * Errors:     none; sequences that are not known are KEY_OTHER.
 */
#ifndef ROMS_MONITOR_KEYS_H
#define ROMS_MONITOR_KEYS_H

#include <stdint.h>

#include "roms/lessons/key.h"

enum {
    KEYS_NONE = -1,     /* none came in time */
    KEYS_INPUT_END = 4, /* control-D: nothing will come any more, or somebody is done */
    KEYS_ENTER = '\r',  /* the key */
    KEYS_LINE = '\n',   /* the end of a line in a script: ends a line, too, but chooses nothing */
    KEYS_BACKSPACE = 8, /* for Delete, too */
    KEYS_ESCAPE = 27,
};
#define KEYS_FOREVER UINT64_MAX

/* The next key, or KEYS_NONE when none has come by that time; at the end of input KEYS_INPUT_END, at
 * once. */
int keys_next(uint64_t until);

#endif
