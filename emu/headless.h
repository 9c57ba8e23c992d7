/* headless.h — a program without a window: as fast as the host can, to an end.
 *
 *      display file                 to --for, or 10 s
 *      firmware                     to its own end (finisher, or a trap nobody handles), or --for
 *      firmware, console a terminal the same, in real time: somebody types
 *      firmware, with a debugger    the same, when and as the debugger lets it
 *
 * Light:       is computed only where a snapshot is to be saved.
 * Exit status: the firmware's own; 0 for a display file that is well; 1 trouble; 2 usage; 3 when
 *              --for was over before the firmware had ended itself.
 * Ownership:   nothing is kept.
 * Errors:      an exit status and one sentence; err->text is empty when all is said.
 */
#ifndef EMU_HEADLESS_H
#define EMU_HEADLESS_H

#include "emu/debug/gdb_server.h"
#include "emu/input_file.h"
#include "emu/saved.h"
#include "emu/settings.h"

struct vm_headless {
    bool console; /* the UART is stdin and stdout */
    struct vm_time length;
    struct vm_gdb *gdb; /* a debugger may come here; NULL: none */
    struct vm_saved_options saved;
    const char *record; /* file for what was done; NULL: none */
};

int vm_headless(const struct vm_headless *headless, const struct vm_settings *settings,
                const struct vm_input *input, struct crt_error *err);

#endif
