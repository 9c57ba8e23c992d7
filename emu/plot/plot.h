/* plot.h — plots as pictures: curves with axes, panels that share an axis, heat maps.
 *
 *      struct vm_plot ──▶ layout, ticks ──▶ lines and letters (plot/ink.h) ──▶ crt_image (8 bit RGB)
 *
 * Models:     nothing. Drawn on the CPU by our own rasteriser and stroke letters: the same plot is the same
 *             bytes on every machine, which no plotting library promises.
 * Text:       UTF-8 of ASCII and of the letters of units and formulas (µ ² ° · × − ± τ σ λ Δ ≤ ≥ …).
 * Units:      whatever the labels say; every axis has a label with its unit.
 * Style:      letters no smaller than 1/45 of the picture's height (projector: 1/28, thicker lines), but never below 11
 *             pixels; light on dark with a graticule for the scope. Crowded plots and heat maps of many rows have
 *             smaller letters, down to 11 pixels.
 * Ownership:  the caller's arrays and strings; the image is the caller's to free.
 * Errors:     out of memory, nothing to show, or a picture too small for letters (with a size that would do): one
 *             sentence. Samples that are not finite leave a gap, and so do those not above 0 on a logarithmic axis.
 */
#ifndef EMU_PLOT_PLOT_H
#define EMU_PLOT_PLOT_H

#include <stdbool.h>
#include <stddef.h>

#include "crt/error.h"
#include "crt/image.h"
#include "emu/quantity.h"

enum vm_plot_style { VM_PLOT_PAPER, VM_PLOT_PROJECTOR, VM_PLOT_SCOPE };

enum vm_plot_kind {
    VM_PLOT_LINE,
    VM_PLOT_STEPS, /* y[i] holds from x[i] to x[i + 1] */
    VM_PLOT_DOTS,
    VM_PLOT_IMPULSES, /* from y = 0 */
    VM_PLOT_AREA      /* filled to y = 0 */
};

struct vm_plot_series {
    const char *label; /* NULL: not in the legend */
    enum vm_plot_kind kind;
    const double *x, *y;
    size_t count;
    int colour; /* 0 … 7: of a palette that the colour-blind can tell apart; −1: by order */
    bool dashed;
};

struct vm_plot_axis {
    const char *label; /* with its unit: "time, ms" */
    bool log;
    double low, high; /* low >= high: from the data */
};

/* A line across a panel with a word on it. */
struct vm_plot_mark {
    bool vertical;
    double at;
    const char *label; /* may be NULL */
};

#define VM_PLOT_SERIES 12
#define VM_PLOT_MARKS  12
#define VM_PLOT_PANELS 6

struct vm_plot_panel {
    struct vm_plot_axis y;
    struct vm_plot_series series[VM_PLOT_SERIES];
    int series_count;
    struct vm_plot_mark mark[VM_PLOT_MARKS];
    int mark_count;
};

struct vm_plot {
    const char *title;
    const char *note; /* under the plot, wrapped; may be NULL */
    struct vm_plot_axis x;
    struct vm_plot_panel panel[VM_PLOT_PANELS]; /* one above the other */
    int panel_count;
};

bool vm_plot_draw(const struct vm_plot *plot, struct vm_size size, enum vm_plot_style style,
                  struct crt_image *image, struct crt_error *err);

/* A table of coloured cells with a text in each. */
struct vm_heat_cell {
    double value;     /* 0 … 1: the colour, from calm to alarming; NaN: grey */
    const char *text; /* may be NULL */
};

struct vm_heat {
    const char *title, *note;
    const char *x_label, *y_label;
    const char *const *columns, *const *rows; /* names */
    int column_count, row_count;
    const struct vm_heat_cell *cells; /* row_count × column_count */
    const char *low, *high;           /* what the ends of the colours mean */
};

bool vm_heat_draw(const struct vm_heat *heat, struct vm_size size, enum vm_plot_style style,
                  struct crt_image *image, struct crt_error *err);

/* The picture as a PNG file, whole or not at all ("-" is standard output), with its title in a text chunk. */
bool vm_plot_write(const char *path, const struct crt_image *image, const char *title,
                   struct crt_error *err);

/* By default 1280 × 720. */
extern const struct vm_size vm_plot_size;

#endif
