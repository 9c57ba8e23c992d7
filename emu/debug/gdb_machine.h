/* gdb_machine.h — the machine as the debugger's target.
 *
 *      program memory ◀─ read, write (ROM, too) ─▶ display memory     display processor ◀─ read
 *
 * Models:     a machine with a board. A debugger reads and writes program memory and display memory,
 *             and reads the display processor's registers; no other device, as reading one may change
 *             it. Monitor commands tell of the time, the processors and the interrupt lines.
 * Time:       picoseconds; slices of a millisecond. An end or an unhandled trap under break- and
 *             watchpoints is noticed at the end of its slice: the display may be that much further.
 * Ownership:  the machine is the caller's.
 * Errors:     addresses of other devices, or of nothing, are not reached.
 * Not modelled: reading devices without their side effects.
 */
#ifndef EMU_DEBUG_GDB_MACHINE_H
#define EMU_DEBUG_GDB_MACHINE_H

#include "emu/debug/gdb_target.h"
#include "emu/machine.h"

struct vm_gdb_target vm_gdb_machine(struct vm_machine *m);

#endif
