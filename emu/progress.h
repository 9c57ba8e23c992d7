/* progress.h — how far long work has come: a line on standard error that overwrites itself.
 *
 * Models:     nothing. Nothing is printed unless standard error is a terminal, and nothing in the
 *             first second. The machine is run in pieces for it, which changes nothing: observing
 *             never does.
 * Time:       host seconds between lines; picoseconds of the machine's in them.
 * Ownership:  the caller's struct.
 * Errors:     none.
 */
#ifndef EMU_PROGRESS_H
#define EMU_PROGRESS_H

#include "emu/machine.h"

struct vm_progress {
    bool shown; /* standard error is a terminal */
    bool dirty; /* a line stands there */
    double next;
};

/* Of a monotonic host clock, from an arbitrary origin. */
double vm_host_seconds(void);

void vm_progress_begin(struct vm_progress *p);
void vm_progress_end(struct vm_progress *p); /* clears the line */

void vm_progress_pictures(struct vm_progress *p, uint64_t done, uint64_t all);

/* vm_machine_run, vm_machine_run_end and vm_machine_trace, saying how far they are; `p` may be NULL. */
void vm_progress_run(struct vm_progress *p, struct vm_machine *m, uint64_t until);
bool vm_progress_run_end(struct vm_progress *p, struct vm_machine *m, uint64_t limit);
void vm_progress_trace(struct vm_progress *p, struct vm_machine *m, uint64_t until,
                       const struct vm_hooks *hooks);

#endif
