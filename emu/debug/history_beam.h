/* history_beam.h — going back by strokes of the vector head and lines of the raster head; private to the
 * history.
 *
 * Models:     both have times: a line's follows from the timing, a stroke's is known to the machine, or to
 *             one that has just been run again. So a step back is a run to an earlier time.
 * Time:       picoseconds.
 * Ownership:  works on the caller's history and its machine.
 * Errors:     false: not that much is remembered; the machine is then where memory begins.
 */
#ifndef EMU_DEBUG_HISTORY_BEAM_H
#define EMU_DEBUG_HISTORY_BEAM_H

#include "emu/debug/history.h"

bool vm_history_back_beam(struct vm_history *history, struct vm_machine *machine, enum vm_unit unit,
                          uint64_t n, struct crt_error *err);

#endif
