/* touch_kinds.h — how each kind of panel samples; private to touch.c and the kinds.
 *
 * Models:     a scan is so many samples, evenly spaced, the last at its end. A sample sees the finger where
 *             it is at that moment.
 * Units:      micrometres from the addressable area's lower left corner, as the registers have them.
 */
#ifndef INPUT_TOUCH_KINDS_H
#define INPUT_TOUCH_KINDS_H

#include "input/touch.h"

/* Positions of an axis (0 across, 1 up): whole micrometres, so that the registers tell them exactly. */
struct inp_touch_grid {
    unsigned count;
    int32_t first;  /* of position 0 */
    uint32_t pitch; /* from one to the next; count · pitch covers the area */
};

struct inp_touch_grid inp_touch_grid(const struct inp_touch_desc *desc, int axis);
/* The position nearest to so many micrometres, in halves. */
uint32_t inp_touch_nearest(struct inp_touch_grid grid, double um);
/* Extent of the addressable area on an axis, mm. */
double inp_touch_extent(const struct inp_touch_desc *desc, int axis);
/* The finger on an axis, mm from the lower left corner. */
double inp_touch_along(const struct inp_touch_desc *desc, const struct inp_place *finger, int axis);
/* Whether the finger's middle is before the panel. */
bool inp_touch_before(const struct inp_touch_desc *desc, const struct inp_place *finger);
/* A measurement's noise on an axis in the scan under way, mm. */
double inp_touch_noise(const struct inp_touch *touch, int axis);

/* Scans a second, to a thousandth. */
struct crt_rate inp_touch_rate(const struct inp_touch_setup *setup);
/* Samples in a scan. */
unsigned inp_touch_samples(const struct inp_touch_setup *setup);
/* Sample `n` of the scan under way; finger NULL: there is none. */
void inp_touch_sample_optical(struct inp_touch *touch, unsigned n, const struct inp_place *finger);
void inp_touch_sample_sonic(struct inp_touch *touch, unsigned n, const struct inp_place *finger);
void inp_touch_sample_electrical(struct inp_touch *touch, unsigned n,
                                 const struct inp_place *finger);

#endif
