/* Two plates that the finger presses together. The resistive one is driven from edge to edge, across and
 * then up; the conducting one picks up the voltage where they touch:
 *
 *      V ──[ sheet·(1 − f) ]──┬──[ sheet·f ]── 0        f: part of the way
 *                             └──[ contact / force ]──┬── measured
 *                                                     └──[ input ]── 0
 *
 * The load draws it down: more, the lighter the press. */
#include "input/touch_kinds.h"

#define FULL 65536.0

static double limited(double v, double low, double high)
{
    return v < low ? low : v > high ? high : v;
}

void inp_touch_sample_electrical(struct inp_touch *touch, unsigned n,
                                 const struct inp_place *finger)
{
    const struct inp_touch_desc *desc = &touch->desc;
    const struct inp_touch_setup *setup = desc->setup;
    int axis = (int)n;
    if (!finger || finger->z < setup->force.value || !inp_touch_before(desc, finger))
        return;
    double extent = inp_touch_extent(desc, axis), mm = inp_touch_along(desc, finger, axis);
    double part = limited((mm + inp_touch_noise(touch, axis)) / extent, 0, 1);
    double contact = setup->contact.value / finger->z;
    double source = setup->sheet.value * part * (1 - part) + contact;
    double measured = part * setup->input.value / (setup->input.value + source);
    uint32_t raw = (uint32_t)limited(measured * FULL, 0, FULL - 1);
    touch->scan.raw[axis] = raw;
    touch->scan.raw[2] = (uint32_t)(contact + 0.5);

    struct inp_touch_grid grid = inp_touch_grid(desc, axis);
    double um = (raw + 0.5) / FULL * extent * 1000;
    bool unsure = (part - measured) * extent * 1000 > grid.pitch / 2.0;
    touch->scan.axis[axis] = (struct inp_touch_found){true, unsure, inp_touch_nearest(grid, um)};
}
