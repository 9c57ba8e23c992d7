/* frame.h — one exposure of all tubes of a rig: a film each, for the same time.
 *
 * Models:     nothing.
 * Time:       picoseconds, [t0, t1).
 * Ownership:  vm_frame_init allocates the films, vm_frame_free releases them; the rig must outlive
 *             an open frame.
 * Errors:     vm_frame_init: one sentence.
 */
#ifndef EMU_FRAME_H
#define EMU_FRAME_H

#include "emu/rig.h"

struct vm_frame {
    unsigned heads; /* bits: those whose tubes are there */
    struct crt_film film[VM_HEADS];
    uint64_t t0, t1;
};

bool vm_frame_init(struct vm_frame *frame, const struct vm_rig *rig, struct crt_error *err);
void vm_frame_free(struct vm_frame *frame);

/* As crt_film_open, crt_film_end and crt_film_cancel do for each film. */
void vm_frame_open(struct vm_frame *frame, const struct vm_rig *rig, uint64_t t0, uint64_t t1);
bool vm_frame_end(struct vm_frame *frame, const struct vm_rig *rig);
void vm_frame_cancel(struct vm_frame *frame, const struct vm_rig *rig);
bool vm_frame_complete(const struct vm_frame *frame);

/* A complete frame of no light, as of power-on. */
void vm_frame_clear(struct vm_frame *frame);

#endif
