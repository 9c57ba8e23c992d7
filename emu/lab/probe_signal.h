/* probe_signal.h — what an oscilloscope on the deflection amplifiers and the grid would show.
 *
 *      words, strokes ──┐                    ┌─▶ x, y: where the beam is or would be, mm
 *      lines, timing ───┴─▶ bends and steps ─┴─▶ z: drive of each gun's grid, 0…1
 *
 * Models:     vector head: strokes as the generator makes them; a move with the beam off is a straight line that begins
 *             when its word is decoded and takes the settling time of the tube's row. Of a recording, which has
 *             no words, a move fills the time between two strokes.
 *             Raster head: sawteeth of the timing: lines sweep at constant speed from the end of one
 *             horizontal sync pulse to the beginning of the next and fly back during the pulse, as straight lines;
 *             fields likewise by the vertical pulse. A monitor's flyback takes longer than the pulse and is
 *             a half sine (estimate): its form is not modelled.
 * Time:       picoseconds since power-on.
 * Units:      mm on the screen from its centre, x right, y up, as if the beam were on; drive as the video
 *             amplifier gets it, before knobs. Not volts: those depend on the monitor.
 * Ownership:  vm_signals_free releases what vm_signals_record took.
 * Errors:     out of memory, too long a time: one sentence.
 * Not modelled: bandwidth of the amplifiers, ringing, pincushion correction.
 */
#ifndef EMU_LAB_PROBE_SIGNAL_H
#define EMU_LAB_PROBE_SIGNAL_H

#include "emu/rig.h"

enum vm_signal { VM_SIGNAL_X, VM_SIGNAL_Y, VM_SIGNAL_Z, VM_SIGNALS };

/* From t[i] to t[i + 1] the value goes from v[i] straight to v[i + 1]; a jump is two entries of one time. */
struct vm_trace {
    uint64_t *t;
    double *v;
    size_t count, room;
};

struct vm_signals {
    enum vm_head head;
    int guns;
    struct vm_trace x, y, z[CRT_MAX_GUNS];
    bool failed; /* private */
};

/* Runs the rig's machine, from its present time, not after `from`, to a little after `to`, and keeps what is
 * between them. */
bool vm_signals_record(struct vm_signals *signals, struct vm_rig *rig, enum vm_head head,
                       uint64_t from, uint64_t to, struct crt_error *err);
void vm_signals_free(struct vm_signals *signals);

/* The value at t, at a jump that after it, or that before it. */
double vm_trace_at(const struct vm_trace *trace, uint64_t t);
double vm_trace_before(const struct vm_trace *trace, uint64_t t);

#endif
