/* sweep_length.h — how long a display list may grow on a vector tube before it flickers. */
#ifndef EMU_LAB_SWEEP_LENGTH_H
#define EMU_LAB_SWEEP_LENGTH_H

#include "emu/command.h"

/* kinescope sweep length … */
extern const struct vm_command vm_command_sweep_length;

#endif
