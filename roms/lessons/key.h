/* key.h — keys as lessons and the monitor get them: characters, and these.
 *
 * Models:     a key as a number: below 0x100 the character, from there on keys that have none.
 * Ownership:  plain values.
 * Errors:     none.
 */
#ifndef ROMS_LESSONS_KEY_H
#define ROMS_LESSONS_KEY_H

enum {
    KEY_UP = 0x100,
    KEY_DOWN,
    KEY_RIGHT,
    KEY_LEFT,
    KEY_HOME,
    KEY_END,
    KEY_PAGE_UP,
    KEY_PAGE_DOWN,
    KEY_OTHER /* one that has no meaning here */
};

#endif
