/* record.h — what a person did, as a script that does it again.
 *
 *      acts of the script and of the window ─▶ FILE ─▶ --input FILE: the same bytes
 *
 * The file is written whole each time (emu/out_file.h): a session that ends badly leaves what had been
 * saved a few seconds before.
 * Ownership:  nothing is kept.
 * Errors:     one sentence.
 */
#ifndef EMU_RECORD_H
#define EMU_RECORD_H

#include "crt/error.h"
#include "emu/machine.h"

/* Acts done so far; `program` is for a comment. */
bool vm_record_save(const char *path, const struct vm_machine *m, const char *program,
                    struct crt_error *err);

#endif
