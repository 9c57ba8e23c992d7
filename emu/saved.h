/* saved.h — the options --save-state and --load-state, as every subcommand that runs a program has
 * them.
 *
 *      --load-state FILE ─▶ the rig, before anything runs       emu/debug/snapshot.h
 *      the rig, when all is done ─▶ --save-state FILE
 *
 * Ownership:  strings point into argv.
 * Errors:     one sentence.
 */
#ifndef EMU_SAVED_H
#define EMU_SAVED_H

#include "emu/rig.h"

struct vm_saved_options {
    const char *save, *load; /* NULL: not asked for */
};

#define VM_SAVED_ROWS 2
extern const struct vm_option vm_saved_rows[VM_SAVED_ROWS];

/* Both are true at once when they are not asked for. */
bool vm_saved_load(const struct vm_saved_options *options, struct vm_rig *rig,
                   const struct vm_settings *settings, const struct vm_input *input,
                   struct crt_error *err);
bool vm_saved_save(const struct vm_saved_options *options, struct vm_rig *rig,
                   const struct vm_settings *settings, const struct vm_input *input,
                   struct crt_error *err);

#endif
