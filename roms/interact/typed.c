#include "roms/interact/typed.h"

enum { ESCAPE = 27 };

/* Behind ESC [: parameters come before the end. */
static bool end_sequence(struct typed *t, uint8_t byte, struct key_event *key)
{
    static const uint8_t arrows[] = {KEYCODE_UP, KEYCODE_DOWN, KEYCODE_RIGHT, KEYCODE_LEFT};
    t->within = byte < '@' ? 2 : 0;
    if (byte < 'A' || byte > 'D')
        return false;
    *key = (struct key_event){.code = arrows[byte - 'A']};
    return true;
}

bool typed_take(struct typed *t, uint8_t byte, uint64_t now, struct key_event *key)
{
    int within = now - t->before > TYPED_PAUSE ? 0 : t->within;
    t->before = now;
    t->within = 0;
    if (byte == ESCAPE)
        t->within = 1;
    else if (within == 2)
        return end_sequence(t, byte, key);
    else if (within == 1)
        t->within = byte == '[' || byte == 'O' ? 2 : 0;
    else {
        *key = (struct key_event){.character = byte};
        if (byte == '\r' || byte == '\n')
            key->code = KEYCODE_ENTER;
        else if (byte == '\t')
            key->code = KEYCODE_TAB;
        return true;
    }
    return false;
}

/* ---- refused text ---------------------------------------------------------------------------- */

void typed_rest_begin(struct typed_rest *rest, uint64_t now)
{
    *rest = (struct typed_rest){true, now};
}

bool typed_rest_takes(struct typed_rest *rest, int byte, uint64_t now)
{
    if (!rest->comes)
        return false;
    if (byte >= 0)
        rest->last = now;
    else
        rest->comes = now - rest->last < TYPED_REST;
    return byte >= 0;
}
