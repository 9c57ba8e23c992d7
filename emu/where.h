/* where.h — where a head's beam is at the machine's present time, what draws there, and both as text.
 *
 *      vector head     the stroke under way and its display word; in between, where the next one begins
 *      raster head     line and dot, or which blanking
 *
 * Models:     nothing: places are those of the pieces that the tube receives. In between strokes the beam is
 *             dark, and taken to be where the next one that has been delivered begins; without one where the
 *             position registers are.
 * Time:       picoseconds; the machine's `now`.
 * Units:      head units (vector head from the bottom left, raster head dots from the top left), mm from the
 *             screen's middle.
 * Ownership:  plain values.
 * Errors:     none; `known` is false while a head has not been used, or is off.
 */
#ifndef EMU_WHERE_H
#define EMU_WHERE_H

#include "emu/heads.h"
#include "emu/machine.h"

struct vm_where {
    enum vm_head head;
    bool known;
    bool lit;       /* vector head: within a stroke; raster head: within the picture */
    bool on_screen; /* not in blanking */
    double x, y;    /* head units */
    double x_mm, y_mm;
    uint32_t line, dot; /* raster head */
};

struct vm_where vm_where(const struct vm_machine *m, enum vm_head head);

/* "004012: 104100 long vector  at 512, 300 = -12.3, 45.6 mm" and the like. */
void vm_where_text(const struct vm_machine *m, const struct vm_where *w, char *text, size_t size);

/* Seconds with as many digits as make out `step` ps, nine at most after those of a nanosecond. */
void vm_where_time(uint64_t t, uint64_t step, char *text, size_t size);

#endif
