/* view.h — which heads a program is to be looked at by, and how long a look takes.
 *
 *      --view auto ─▶ what the machine has used by then ─▶ vector, raster or both
 *
 * Time:       picoseconds.
 * Ownership:  nothing.
 * Errors:     one sentence.
 */
#ifndef EMU_VIEW_H
#define EMU_VIEW_H

#include "emu/input_file.h"
#include "emu/machine.h"
#include "emu/settings.h"

/* False and a sentence when the options ask for a raster head, by tube, view, mode or --set, and the program has no
 * firmware that could use one. */
bool vm_view_suits(const struct vm_settings *settings, const struct vm_input *input,
                   struct crt_error *err);

/* Never VM_VIEW_AUTO: `wanted`, or the heads used so far; the vector head when neither is. */
enum vm_view vm_view_now(enum vm_view wanted, const struct vm_machine *m);

/* How long a picture gathers light unless said otherwise: a frame of the raster head when that is
 * looked at alone, else a sync tick. */
uint64_t vm_view_exposure(enum vm_view view, const struct vm_machine *m);

/* Head units of the view's head to tube millimetres: the vector head's units, or the raster head's
 * dots, from the top left. */
void vm_view_place(enum vm_view view, const struct vm_machine *m, double x, double y, double *x_mm,
                   double *y_mm);

#endif
