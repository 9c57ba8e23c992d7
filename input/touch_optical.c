/* Beams of infrared light before the screen, sampled one after the other: across, left to right, then up.
 * What is there is a finger so wide and, of beams running the other way, within their length. */
#include <math.h>

#include "input/touch_kinds.h"

/* Whether the finger reaches the stretch between emitter and detector of beams that the axis numbers. */
static bool within_length(const struct inp_touch_desc *desc, const struct inp_place *finger,
                          int axis)
{
    int along = 1 - axis;
    double half = desc->setup->finger.value / 2;
    double at = inp_touch_along(desc, finger, along);
    return at >= -half && at <= inp_touch_extent(desc, along) + half;
}

static bool broken(const struct inp_touch_desc *desc, const struct inp_place *finger, int axis,
                   unsigned beam)
{
    struct inp_touch_grid grid = inp_touch_grid(desc, axis);
    double line = (grid.first + (double)beam * grid.pitch) / 1000;
    double away = fabs(inp_touch_along(desc, finger, axis) - line);
    return away <= desc->setup->finger.value / 2 && within_length(desc, finger, axis);
}

/* One broken beam: on it; more: between the outermost; apart: not one finger at rest. */
static struct inp_touch_found find(const uint32_t raw[2], unsigned beams)
{
    struct inp_touch_found found = {false, false, 0};
    unsigned first = 0, last = 0, count = 0;
    for (unsigned n = 0; n < beams; n++) {
        if (!(raw[n / 32] >> n % 32 & 1))
            continue;
        if (count++ == 0)
            first = n;
        last = n;
    }
    found.found = count > 0;
    found.unsure = count > 0 && count != last - first + 1;
    found.at = first + last;
    return found;
}

void inp_touch_sample_optical(struct inp_touch *touch, unsigned n, const struct inp_place *finger)
{
    const struct inp_touch_setup *setup = touch->desc.setup;
    unsigned columns = (unsigned)setup->columns.value, rows = (unsigned)setup->rows.value;
    int axis = n < columns ? 0 : 1;
    unsigned beam = axis == 0 ? n : n - columns;
    uint32_t *raw = &touch->scan.raw[2 * axis];
    if (finger && broken(&touch->desc, finger, axis, beam))
        raw[beam / 32] |= UINT32_C(1) << beam % 32;
    unsigned beams = axis == 0 ? columns : rows;
    if (beam + 1 == beams)
        touch->scan.axis[axis] = find(raw, beams);
}
