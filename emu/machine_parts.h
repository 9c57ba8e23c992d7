/* machine_parts.h — what the files of the machine share; not for others.
 *
 *      machine.c       making, loading, copying     machine_run.c   time: who is next
 *      machine_wires.c strokes, interrupt lines,    machine_bus.c   registers on the processor's bus
 *                      START and refreshes         machine_state.c snapshots
 *      machine_raster.c the raster head's wires and registers
 *      machine_goals.c until something happens     machine_steps.c strokes and lines to step by
 *      machine_devices.c acts, input devices, their wires and registers
 *
 * Models:     see emu/machine.h.
 * Time:       picoseconds since power-on.
 * Ownership:  all of it works on the caller's machine.
 * Errors:     none; guest trouble is a state of the machine.
 */
#ifndef EMU_MACHINE_PARTS_H
#define EMU_MACHINE_PARTS_H

#include "emu/machine.h"

/* machine_wires.c */
void vm_wire_dpu(struct vm_machine *m, struct df_dpu_desc *desc);
/* Strokes and lines from now on go to m->hooks, too, or no longer. */
void vm_wire_hooks(struct vm_machine *m, bool hooked);
/* Strokes are offered to the pen when it looks. */
void vm_wire_pen(struct vm_machine *m);
void vm_count_stroke(struct vm_machine *m, const struct crt_stroke *stroke);
struct vm_counts vm_counts(const struct vm_machine *m);
/* START at t; a refresh may begin with it. */
void vm_start(struct vm_machine *m, uint16_t address, uint64_t t);
/* The line of the board's interrupt controller that each interrupt drives. */
extern const unsigned vm_lines[DF_INT_COUNT];
extern const unsigned vm_raster_lines[RAS_INT_COUNT];
/* When the next line of the display processor changes, and the change. */
uint64_t vm_wires_next(const struct vm_machine *m);
void vm_wires_change(struct vm_machine *m, uint64_t t);

/* A line of the board's interrupt controller is to have this level from t on. */
void vm_set_line(struct vm_machine *m, unsigned line, bool level, uint64_t t);

/* machine_raster.c; all of it needs desc.buffer but vm_raster_next(), which is VM_NEVER without. */
void vm_raster_init(struct vm_machine *m);
void vm_raster_wire(struct vm_machine *m, struct ras_wires *wires);
void vm_raster_hook(struct vm_machine *m, bool hooked);
void vm_raster_connect(struct vm_machine *m);
uint64_t vm_raster_next(const struct vm_machine *m);
void vm_raster_event(struct vm_machine *m, uint64_t t);
void vm_raster_advance(struct vm_machine *m, uint64_t t);

/* machine_devices.c; all of it needs desc.setup but vm_devices_next(), which is VM_NEVER without. */
void vm_devices_init(struct vm_machine *m);
/* Wires them to this machine, a copy, say; offers light to the pens that look. */
void vm_devices_wire(struct vm_machine *m);
void vm_devices_connect(struct vm_machine *m);
uint64_t vm_devices_next(const struct vm_machine *m);
void vm_devices_event(struct vm_machine *m, uint64_t t);
void vm_devices_state(struct vm_machine *m, struct crt_state *s);

/* machine_run.c */
/* What to stop at before `until`. */
enum vm_goal_kind {
    VM_GOAL_NONE,
    VM_GOAL_REFRESH,
    VM_GOAL_STOP,
    VM_GOAL_WORDS,
    VM_GOAL_RETIRED,
    VM_GOAL_CONSOLE,
    VM_GOAL_MARK,
    VM_GOAL_END,
    VM_GOAL_DRAWN,
    VM_GOAL_TIMING
};

struct vm_goal {
    enum vm_goal_kind kind;
    uint64_t count; /* what is counted must pass it, or come to it: see reached() */
    uint32_t mark;
    bool on; /* the raster head was */
};
/* Runs to the goal's moment, or to `limit`: true when it came. */
bool vm_run_goal(struct vm_machine *m, uint64_t limit, struct vm_goal goal);

/* machine_goals.c, for machine_steps.c: strokes have been delivered, of which the first may be over later;
 * the raster head was switched on or off, or began a new timing. True when it came before `limit`. */
bool vm_run_drawn(struct vm_machine *m, uint64_t limit);
bool vm_run_timing(struct vm_machine *m, uint64_t limit);

/* machine_bus.c: adds the machine's ranges to the board's bus. */
void vm_bus_connect(struct vm_machine *m);

#endif
