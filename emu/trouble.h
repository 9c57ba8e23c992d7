/* trouble.h — what is wrong with a guest program, in one sentence.
 *
 * Models:     nothing; reads the machine's state: a processor that re-fetches an illegal word, a
 *             bus time-out, a program that never lights the beam.
 * Addresses:  octal, with the source line where it is known.
 * Ownership:  nothing.
 */
#ifndef EMU_TROUBLE_H
#define EMU_TROUBLE_H

#include "emu/input_file.h"
#include "emu/machine.h"

enum vm_trouble {
    VM_NO_TROUBLE,
    VM_TROUBLE_ILLEGAL,
    VM_TROUBLE_TIMEOUT,
    VM_TROUBLE_DARK /* the beam has not been lit since power-on */
};

enum vm_trouble vm_find_trouble(const struct vm_machine *m, const struct vm_input *input,
                                struct crt_error *sentence);

#endif
