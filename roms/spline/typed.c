#include "roms/spline/typed.h"

#include "roms/spline/editor.h"

int typed_key(struct typed *t, int byte)
{
    static const int arrows[] = {EDITOR_UP, EDITOR_DOWN, EDITOR_RIGHT, EDITOR_LEFT};
    int within = t->within;
    if (byte == 0x1B) {
        t->within = 1;
        return 0;
    }
    t->within = within == 1 && (byte == '[' || byte == 'O') ? 2 : 0;
    if (within == 2) {
        if (byte >= 'A' && byte <= 'D')
            return arrows[byte - 'A'];
        t->within = byte < '@' ? 2 : 0; /* parameters come before the end */
        return 0;
    }
    return within == 1 ? 0 : byte;
}
