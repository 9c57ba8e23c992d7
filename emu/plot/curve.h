/* curve.h — a series as ink.
 *
 * Models:     samples of one pixel column are drawn as its first, least, greatest and last: what millions of samples
 *             look like costs what a picture costs.
 * Errors:     none; samples without a place (NaN, not positive on a logarithmic axis) leave a gap.
 */
#ifndef EMU_PLOT_CURVE_H
#define EMU_PLOT_CURVE_H

#include "emu/plot/axis.h"
#include "emu/plot/ink.h"

/* Covers (plot/ink.h) the series' lines; `width` in pixels, `dash` 0: as one line, else its pattern's number. */
void vm_curve_cover(struct vm_ink *ink, const struct vm_plot_series *series,
                    const struct vm_scale *x, const struct vm_scale *y, double width, int dash);
/* Covers what lies between an area's line and its base. */
void vm_curve_cover_area(struct vm_ink *ink, const struct vm_plot_series *series,
                         const struct vm_scale *x, const struct vm_scale *y);
/* A pen with the pattern. */
struct vm_ink_pen vm_curve_pen(double width, int dash);

#endif
