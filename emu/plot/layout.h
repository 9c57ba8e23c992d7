/* layout.h — where everything of a plot goes, decided before anything is drawn.
 *
 * Models:     rows from the top: title, panels (each with its exponent or a legend above it), numbers, the axis'
 *             label, the note; columns from the left: labels, numbers, panels. Numbers never touch: there are
 *             fewer of them where there is no room.
 * Units:      pixels.
 * Errors:     a picture in which the letters of the style leave no room for panels: a sentence with a size that
 *             would do. Nothing to plot: a sentence.
 */
#ifndef EMU_PLOT_LAYOUT_H
#define EMU_PLOT_LAYOUT_H

#include "emu/plot/legend.h"

struct vm_layout {
    const struct vm_plot *plot;
    struct vm_place place[VM_PLOT_PANELS];
    struct vm_type y_label[VM_PLOT_PANELS]; /* smaller where there is little room */
    int y_lines;                            /* the most lines of a label beside a panel */
    struct vm_scale x;
    struct vm_ticks ticks; /* of x */
    struct vm_heading heading;
    double pad;
    double left, right, top, bottom; /* of all panels together */
    double note_y, label_y;          /* base lines */
};

/* Scales; false when there is nothing to plot. */
bool vm_layout_begin(struct vm_layout *layout, const struct vm_plot *plot, struct crt_error *err);
bool vm_layout_find(struct vm_layout *layout, struct vm_sheet *sheet, struct crt_error *err);

#endif
