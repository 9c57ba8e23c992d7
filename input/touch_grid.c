/* Where the positions of a panel lie. */
#include <math.h>

#include "input/noise.h"
#include "input/touch_kinds.h"

double inp_touch_extent(const struct inp_touch_desc *desc, int axis)
{
    return axis == 0 ? desc->width_mm : desc->height_mm;
}

static unsigned positions(const struct inp_touch_setup *setup, int axis)
{
    double n = setup->steps.value;
    if (setup->kind == TOUCH_OPTICAL)
        n = axis == 0 ? setup->columns.value : setup->rows.value;
    return (unsigned)n;
}

struct inp_touch_grid inp_touch_grid(const struct inp_touch_desc *desc, int axis)
{
    unsigned count = positions(desc->setup, axis);
    double extent = inp_touch_extent(desc, axis) * 1000;
    double pitch = ceil(extent / count);
    double first = floor((extent - (count - 1) * pitch) / 2);
    return (struct inp_touch_grid){count, (int32_t)first, (uint32_t)pitch};
}

uint32_t inp_touch_nearest(struct inp_touch_grid grid, double um)
{
    double n = floor((um - grid.first) / grid.pitch + 0.5);
    if (n < 0)
        return 0;
    unsigned last = grid.count - 1;
    return 2 * (n < last ? (unsigned)n : last);
}

double inp_touch_along(const struct inp_touch_desc *desc, const struct inp_place *finger, int axis)
{
    return (axis == 0 ? finger->x : finger->y) + inp_touch_extent(desc, axis) / 2;
}

bool inp_touch_before(const struct inp_touch_desc *desc, const struct inp_place *finger)
{
    return fabs(finger->x) <= desc->width_mm / 2 && fabs(finger->y) <= desc->height_mm / 2;
}

double inp_touch_noise(const struct inp_touch *touch, int axis)
{
    return touch->desc.setup->noise.value *
           inp_noise_normal(touch->desc.seed, 2 * touch->scans + (unsigned)axis);
}
