/* look.h — colours, letters and pens of a style.
 *
 * Source:     series colours: M. Okabe and K. Ito, "Color Universal Design", 2008: eight colours that the
 *             colour-blind tell apart. On white their yellow is darkened, on black their black is white (estimates,
 *             by eye). Letters and pens are shares of the picture's height (estimates, by eye).
 * Errors:     none.
 */
#ifndef EMU_PLOT_LOOK_H
#define EMU_PLOT_LOOK_H

#include "emu/plot/letters.h"
#include "emu/plot/plot.h"

#define VM_COLOURS 8

struct vm_look {
    struct vm_rgb paper, panel, frame, grid, minor, text, dim;
    struct vm_rgb series[VM_COLOURS];
    struct vm_type title, type; /* the note and the numbers are of `type` too */
    double area;                /* opacity of what is filled */
    double curve, line, fine;   /* pens: curves, frames and marks, grids; pixels */
    enum vm_plot_style style;
    bool scope;
};

struct vm_look vm_look_of(enum vm_plot_style style, struct vm_size size);
/* Letters of `share` of their size, but not below what can be read (11 pixels). */
void vm_look_shrink(struct vm_look *look, double share);
/* Of the series that is the `order`th of its panel. */
int vm_look_colour(const struct vm_plot_series *series, int order);

#endif
