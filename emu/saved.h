/* saved.h — the options --save-state and --load-state, as every subcommand that runs a program has
 * them.
 *
 *      --load-state FILE ─▶ the rig, before anything runs       emu/debug/snapshot.h
 *      the rig, when all is done ─▶ --save-state FILE
 *
 * Models:     nothing; a snapshot is described in emu/debug/snapshot.h.
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

/* Before anything runs: what is written, `out` too, may not be what is read, --save-state may not be
 * where the command's own output goes, and can be written at all. The program's name and that of the
 * output may be NULL. An exit status; not 0: with a sentence. */
int vm_saved_check(const struct vm_saved_options *options, const char *program,
                   const struct vm_input_options *input, const char *out, struct crt_error *err);

/* Both are true at once when they are not asked for. */
bool vm_saved_load(const struct vm_saved_options *options, struct vm_rig *rig,
                   const struct vm_settings *settings, const struct vm_input *input,
                   struct crt_error *err);
bool vm_saved_save(const struct vm_saved_options *options, struct vm_rig *rig,
                   const struct vm_settings *settings, const struct vm_input *input,
                   struct crt_error *err);

#endif
