/* keys.c — keys of the keyboard, and characters and cursor keys of the console. */
#include "roms/bsp/console.h"
#include "roms/choice/choice.h"

enum { ESCAPE = 27 };

/* ESC [ A … D come together. */
static uint8_t cursor(void)
{
    static const uint8_t codes[] = {KEYCODE_UP, KEYCODE_DOWN, KEYCODE_RIGHT, KEYCODE_LEFT};
    int next = -1;
    for (int i = 0; i < 20000 && next < 0; i++)
        next = console_poll();
    if (next != '[' && next != 'O')
        return KEYCODE_ESCAPE;
    next = -1;
    for (int i = 0; i < 20000 && next < 0; i++)
        next = console_poll();
    return next >= 'A' && next <= 'D' ? codes[next - 'A'] : 0;
}

bool keys_take(struct key_event *key)
{
    while (key_take(key))
        if (!key->up)
            return true;
    int c = console_poll();
    if (c < 0)
        return false;
    *key = (struct key_event){.character = (uint8_t)c};
    if (c == ESCAPE)
        *key = (struct key_event){.code = cursor()};
    else if (c == '\r' || c == '\n')
        key->code = KEYCODE_ENTER;
    else if (c == '\t')
        key->code = KEYCODE_TAB;
    return true;
}
