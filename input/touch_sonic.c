/* Bursts of surface waves in the glass, one across and one up in a scan, sent from the left and from the
 * lower edge. The finger sends part of them back; the further it is, the weaker they return. */
#include <math.h>

#include "crt/maths.h"
#include "input/touch_kinds.h"

/* An echo so much below what is told surely is not heard, dB. */
#define DEAF 6.0

#define LN10 2.302585092994045684

/* Noise is as listed while the echo is sure, and grows as that weakens further. */
static double worse(double db)
{
    return db > 0 ? crt_exp(db * LN10 / 20) : 1;
}

void inp_touch_sample_sonic(struct inp_touch *touch, unsigned n, const struct inp_place *finger)
{
    const struct inp_touch_desc *desc = &touch->desc;
    const struct inp_touch_setup *setup = desc->setup;
    int axis = (int)n;
    if (!finger || !(finger->z > 0) || !inp_touch_before(desc, finger))
        return;
    double mm = inp_touch_along(desc, finger, axis);
    double weak = 2 * mm / 1000 * setup->loss.value - setup->hear.value; /* dB; < 0: surely heard */
    if (weak > DEAF)
        return;
    mm += inp_touch_noise(touch, axis) * worse(weak);
    /* mm / (m/s) is milliseconds; the clock counts megahertz. */
    double ticks = floor(2 * mm / setup->velocity.value * 1000 * setup->timer.value + 0.5);
    if (ticks < 0)
        ticks = 0;
    double us = ticks / setup->timer.value;
    touch->scan.raw[axis] = (uint32_t)(us * 1000 + 0.5);
    double um = us * setup->velocity.value / 2;
    touch->scan.axis[axis] =
        (struct inp_touch_found){true, weak > 0, inp_touch_nearest(inp_touch_grid(desc, axis), um)};
}
