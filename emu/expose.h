/* expose.h — runs a machine with its tubes and hands out frames: one, or a sequence.
 *
 *      instant n = from + n/fps      frame n gathers the light of [instant − exposure, instant)
 *
 * Models:     nothing. Frames may overlap when the exposure is longer than the frame interval.
 *             Exposures are cut off at power-on.
 * Time:       picoseconds; instants come from the frame's number, not by adding rounded intervals.
 * Ownership:  the frames belong to vm_expose and live until the sink returns.
 * Errors:     one sentence; a sink that fails stops the run.
 */
#ifndef EMU_EXPOSE_H
#define EMU_EXPOSE_H

#include "emu/frame.h"
#include "emu/progress.h"

#define VM_OVERLAP_MAX 64

struct vm_shots {
    uint64_t from, exposure;
    struct crt_rate fps; /* used when count > 1 */
    uint64_t count;
};

/* Receives frame `number` (from 0). */
typedef bool (*vm_frame_sink)(void *ctx, const struct vm_frame *frame, uint64_t number,
                              struct crt_error *err);

/* How many frames are open at once; above VM_OVERLAP_MAX vm_expose refuses. */
uint64_t vm_shots_overlap(const struct vm_shots *shots);
/* `progress` may be NULL. */
bool vm_expose(struct vm_rig *rig, const struct vm_shots *shots, struct vm_progress *progress,
               vm_frame_sink sink, void *ctx, struct crt_error *err);

#endif
