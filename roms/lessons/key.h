/* key.h — keys as lessons and the monitor get them: characters, and these. */
#ifndef ROMS_LESSONS_KEY_H
#define ROMS_LESSONS_KEY_H

enum {
    KEY_UP = 0x100,
    KEY_DOWN,
    KEY_RIGHT,
    KEY_LEFT,
    KEY_HOME,
    KEY_END,
    KEY_OTHER /* one that has no meaning here */
};

#endif
