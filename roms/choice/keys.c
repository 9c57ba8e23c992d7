/* keys.c — keys of the keyboard, and characters and cursor keys of the console. */
#include "roms/bsp/console.h"
#include "roms/choice/choice.h"

bool keys_take(struct typed *typed, struct key_event *key)
{
    while (key_take(key))
        if (!key->up)
            return true;
    for (int c; (c = console_poll()) >= 0;)
        if (typed_take(typed, (uint8_t)c, timer_now(), key))
            return true;
    return false;
}
