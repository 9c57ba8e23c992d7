/* typed.h — bytes of the console as keys.
 *
 *      ESC [ A ──▶ KEYCODE_UP        b ──▶ 'b'        CR, LF ──▶ KEYCODE_ENTER
 *
 * Models:     the arrow keys' sequences of ECMA-48 terminals; characters; Enter and Tab have their codes, too.
 * Time:       a sequence's bytes come together: Escape by itself is over after TYPED_PAUSE.
 *             Text that is pasted has no pauses of TYPED_REST.
 * Units:      ticks of the timer.
 * Ownership:  plain value; begins as 0.
 * Errors:     other sequences mean nothing.
 * Source:     ECMA-48; VT100 User Guide (1978).
 */
#ifndef ROMS_INTERACT_TYPED_H
#define ROMS_INTERACT_TYPED_H

#include "roms/bsp/input.h"
#include "roms/bsp/timer.h"

enum { TYPED_PAUSE = TIMER_HZ / 10, TYPED_REST = TIMER_HZ / 20 };

struct typed {
    int within;      /* a sequence: 0 no, 1 behind ESC, 2 behind ESC [ */
    uint64_t before; /* when the last byte came */
};

/* The key that ends with this byte; false: none does. */
bool typed_take(struct typed *typed, uint8_t byte, uint64_t now, struct key_event *key);

/* The rest of a text that was refused is no keys: so is what comes without a pause. */
struct typed_rest {
    bool comes;
    uint64_t last; /* when its last byte came */
};

void typed_rest_begin(struct typed_rest *rest, uint64_t now);
/* What console_poll returned: true: a byte that belongs to the rest. */
bool typed_rest_takes(struct typed_rest *rest, int byte, uint64_t now);

#endif
