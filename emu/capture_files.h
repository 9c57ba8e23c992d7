/* capture_files.h — where pictures go: numbered names, and film strips (emu/y4m.h).
 *
 * Ownership:  nothing; names are written to the caller's array.
 * Errors:     a name that does not fit: one sentence.
 */
#ifndef EMU_CAPTURE_FILES_H
#define EMU_CAPTURE_FILES_H

#include <stddef.h>
#include <stdint.h>

#include "crt/error.h"
#include "emu/y4m.h"

/* Whether the name has exactly one %d, %4d or %04d and no other %. */
bool vm_frame_name_ok(const char *pattern);
/* The pattern with `number` in its place; the pattern itself when it is not numbered. */
bool vm_frame_name(const char *pattern, bool numbered, uint64_t number, char *name, size_t size,
                   struct crt_error *err);

#endif
