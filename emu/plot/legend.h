/* legend.h — the words within a panel: its legend and those of its marks.
 *
 * Models:     the legend goes where no curve is, corners first; where there is no such place, into a strip above the
 *             panel. A mark's word stands beside its line where no other word is and, if possible, no curve.
 */
#ifndef EMU_PLOT_LEGEND_H
#define EMU_PLOT_LEGEND_H

#include "emu/plot/axis.h"
#include "emu/plot/sheet.h"

struct vm_place {
    const struct vm_plot_panel *panel;
    struct vm_rect box;
    struct vm_scale x, y;
    struct vm_ticks ticks;
    int strip;                          /* lines of a legend above the panel */
    struct vm_rect legend;              /* within the panel; x1 = x0: none */
    struct vm_rect word[VM_PLOT_MARKS]; /* x1 = x0: none */
    bool turned[VM_PLOT_MARKS];
};

/* Finds places for words in the panel; false: the legend has none. */
bool vm_legend_place(struct vm_sheet *sheet, struct vm_place *place);
/* Lines of a strip for the panel's legend in that width. */
int vm_legend_strip(const struct vm_look *look, const struct vm_plot_panel *panel, double width);
void vm_legend_draw(struct vm_sheet *sheet, const struct vm_place *place);
void vm_marks_draw(struct vm_sheet *sheet, const struct vm_place *place);      /* lines */
void vm_mark_words_draw(struct vm_sheet *sheet, const struct vm_place *place); /* words */
/* 0: one line; otherwise the number of a pattern of dashes. */
int vm_dash_of(const struct vm_plot_series *series, int order);

#endif
