/* calm.h — a picture in which nothing flashes: the mean light of the last second or so.
 *
 *      frames, as they are shown ─▶ low pass ─▶ low pass ─▶ what is shown instead
 *
 * Models:     two low-pass filters of the first order, one after the other, time constant VM_CALM_S each, over
 *             the time of who looks on (host seconds, however slow the machine runs; what a late picture is behind
 *             does not count, as it does not for the machine). A light that flashes
 *             fully at 3 Hz is left with 7 % from crest to trough, at 10 Hz with 0.6 %. Guidelines (WCAG 2.2,
 *             2.3.1) count as a flash a pair of opposing changes of a tenth of full luminance, and allow three
 *             a second.
 * Time:       seconds of the host; frames keep the simulated time of what they come from.
 * Units:      as films.
 * Ownership:  vm_calm_create allocates, vm_calm_destroy frees; the rig must outlive it.
 * Errors:     out of memory: one sentence.
 */
#ifndef EMU_CALM_H
#define EMU_CALM_H

#include "emu/frame.h"

#define VM_CALM_S 0.4

struct vm_calm;

/* Begins with darkness. */
struct vm_calm *vm_calm_create(const struct vm_rig *rig, struct crt_error *err);
void vm_calm_destroy(struct vm_calm *calm);

/* `frame`, complete, has been there for another `seconds`. The frame to show instead is valid until the next
 * call. */
const struct vm_frame *vm_calm_show(struct vm_calm *calm, const struct vm_frame *frame,
                                    double seconds);

#endif
