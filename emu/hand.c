#include "emu/hand.h"

#include <string.h>

static const struct {
    const char *name, *title;
} hands[VM_HANDS] = {
    [VM_HAND_PEN] = {"pen", "light pen"},
    [VM_HAND_STYLUS] = {"stylus", "stylus on the tablet"},
    [VM_HAND_FINGER] = {"finger", "finger on the touch panel"},
    [VM_HAND_MOUSE] = {"mouse", "mouse"},
};

enum vm_hand vm_hand_of_name(const char *name)
{
    int h = 0;
    while (h < VM_HANDS && strcmp(hands[h].name, name) != 0)
        h++;
    return (enum vm_hand)h;
}

const char *vm_hand_title(enum vm_hand hand)
{
    return hands[hand].title;
}

bool vm_hand_present(enum vm_hand hand, const struct inp_setup *setup)
{
    switch (hand) {
    case VM_HAND_PEN:
        return setup->has_pen;
    case VM_HAND_STYLUS:
        return setup->tablet.kind != TABLET_NONE;
    case VM_HAND_FINGER:
        return setup->touch.kind != TOUCH_NONE;
    case VM_HAND_MOUSE:
        return setup->mouse.kind != MOUSE_NONE;
    default:
        return false;
    }
}
