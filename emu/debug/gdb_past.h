/* gdb_past.h — the machine as the debugger's target, with its past: reverse-step, reverse-continue.
 *
 *      session ─▶ remember ─▶ history: a snapshot, when one is due
 *              ─▶ changed ─▶ a mark: registers or memory were written from outside
 *              ─▶ rewind ─▶ history
 *
 * Models:     the target of gdb_machine.h; what happens while a client is there is remembered.
 * Films:      those that are open on the tube when the client goes back are given up.
 * Ownership:  the struct is the caller's, as are machine and history; all must outlive the target.
 * Errors:     as gdb_machine.h and history.h.
 */
#ifndef EMU_DEBUG_GDB_PAST_H
#define EMU_DEBUG_GDB_PAST_H

#include "emu/debug/gdb_machine.h"
#include "emu/debug/history.h"

struct vm_gdb_past {
    struct vm_gdb_target machine;
    struct vm_history *history;
};

/* `history` is of the rig that the machine belongs to. */
struct vm_gdb_target vm_gdb_with_past(struct vm_gdb_past *past, struct vm_machine *m,
                                      struct vm_history *history);

#endif
