/* axis.h — from a quantity to a place in a panel.
 *
 * Models:     what an axis shows when its ends are not given: all of the data; from 0 when the data nearly reach
 *             it; on a logarithmic axis at most eight decades below the greatest.
 * Units:      pixels for places.
 * Errors:     none: ends that are senseless (not finite, equal, not positive on a logarithmic axis) count as not given.
 */
#ifndef EMU_PLOT_AXIS_H
#define EMU_PLOT_AXIS_H

#include "emu/plot/plot.h"
#include "emu/plot/ticks.h"

struct vm_scale {
    bool log;
    double low, high;
    double a, b;     /* low and high, or their logarithms */
    double from, to; /* their places */
};

/* Whether anything can be shown on the axis: its ends are given or there are finite data. */
bool vm_scale_x(struct vm_scale *scale, const struct vm_plot *plot);
bool vm_scale_y(struct vm_scale *scale, const struct vm_plot_panel *panel);

/* Within ±1e8 pixels; NaN for what has no place. */
double vm_scale_place(const struct vm_scale *scale, double value);

#endif
