#include "emu/hand.h"

#include <math.h>
#include <stdio.h>
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

/* ---- the tablet --------------------------------------------------------------------------------- */

/* Four numbers for each head, the raster head's first. */
static bool read_picture(const char *text, enum vm_head head, double v[4])
{
    double w[8];
    if (sscanf(text, "%lf %lf %lf %lf %lf %lf %lf %lf", &w[0], &w[1], &w[2], &w[3], &w[4], &w[5],
               &w[6], &w[7]) != 8)
        return false;
    memcpy(v, head == VM_RASTER ? w : w + 4, 4 * sizeof *v);
    for (int i = 0; i < 4; i++)
        if (!(fabs(v[i]) <= 4096))
            return false;
    return v[2] >= 1 && v[3] >= 1;
}

struct vm_hand_picture vm_hand_picture(const char *text, enum vm_head head, double width,
                                       double height)
{
    double v[4], unit = width / 1024;
    if (!read_picture(text, head, v))
        return (struct vm_hand_picture){0, 0, width, height};
    return (struct vm_hand_picture){(v[0] + v[2] / 2) * unit - width / 2,
                                    (v[1] + v[3] / 2) * unit - height / 2, v[2] * unit,
                                    v[3] * unit};
}

void vm_hand_on_tablet(const struct vm_hand_picture *picture, const struct inp_tablet_setup *tablet,
                       double *x, double *y)
{
    double w = tablet->width.value, h = tablet->height.value;
    double scale = fmin(w / picture->width, h / picture->height);
    *x = fmin(fmax(w / 2 + (*x - picture->x) * scale, 0), w);
    *y = fmin(fmax(h / 2 + (*y - picture->y) * scale, 0), h);
}
