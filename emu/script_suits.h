/* script_suits.h — whether what a script does can be done at this terminal.
 *
 *      --input SCRIPT, --set tablet=none …, the program's heads ─▶ a sentence, or nothing to say
 *
 * A device does not notice an act that is for one that is not connected: whoever wrote the script hears of
 * it before anything runs.
 * Ownership:  nothing.
 * Errors:     one sentence, with the first such act.
 */
#ifndef EMU_SCRIPT_SUITS_H
#define EMU_SCRIPT_SUITS_H

#include "emu/input_file.h"
#include "emu/settings.h"

bool vm_script_suits(const struct vm_settings *settings, const struct vm_input *input,
                     struct crt_error *err);

#endif
