/* trouble.h — what is wrong with a guest program, in one sentence.
 *
 * Models:     nothing; reads the machine's state: firmware with a trap nobody handles, a display
 *             processor that re-fetches an illegal word, a bus time-out, a program that never lights
 *             the beam.
 * Addresses:  the display processor's octal, with the source line where it is known; the processor's
 *             hexadecimal, with the symbol.
 * Ownership:  nothing.
 * Errors:     none: they are what it tells.
 */
#ifndef EMU_TROUBLE_H
#define EMU_TROUBLE_H

#include <stdio.h>

#include "emu/input_file.h"
#include "emu/machine.h"

enum vm_trouble {
    VM_NO_TROUBLE,
    VM_TROUBLE_TRAP,
    VM_TROUBLE_ILLEGAL,
    VM_TROUBLE_TIMEOUT,
    VM_TROUBLE_DARK /* the beam has not been lit since power-on; firmware may mean that */
};

enum vm_trouble vm_find_trouble(const struct vm_machine *m, const struct vm_input *input,
                                struct crt_error *sentence);

/* The registers at an unhandled trap, as a table of several lines. */
void vm_print_registers(FILE *out, struct rv_cpu *cpu);

#endif
