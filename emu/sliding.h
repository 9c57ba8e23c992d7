/* sliding.h — a long exposure that moves on with time, as the sum of short ones that follow each other.
 *
 *      frames      ├──┼──┼──┼──┼──┼──┤ now
 *      sum                  └──┴──┴──┘  as near to the shutter's time as whole frames come
 *
 * Models:     nothing: light adds. Sums are kept in double precision, in which adding a frame and taking it
 *             away again leaves nothing behind: the sum of k frames is the film of their whole time.
 * Time:       picoseconds. Of very many frames within the shutter's time, neighbours are put together, so that
 *             the beginning moves on in larger steps, at most a fortieth of it where memory allows. The sum's
 *             t0 and t1 say what it is of.
 * Memory:     up to 64 frames, or 256 MiB of them (4 at least).
 * Ownership:  vm_sliding_create allocates, vm_sliding_destroy frees; the rig must outlive it.
 * Errors:     out of memory: one sentence; what was gathered is forgotten then.
 */
#ifndef EMU_SLIDING_H
#define EMU_SLIDING_H

#include "emu/frame.h"

struct vm_sliding;

struct vm_sliding *vm_sliding_create(const struct vm_rig *rig, struct crt_error *err);
void vm_sliding_destroy(struct vm_sliding *sliding);

/* Adds a complete frame, forgets at the other end what `shutter` ps no longer reach, and stores the sum in
 * `sum`, a frame of the same rig. A frame that does not begin where the last one ended begins anew. */
bool vm_sliding_add(struct vm_sliding *sliding, const struct vm_frame *frame, uint64_t shutter,
                    struct vm_frame *sum, struct crt_error *err);

#endif
