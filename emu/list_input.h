/* list_input.h — input devices as text: what can be connected, and their figures.
 *
 * Ownership:  nothing.
 * Errors:     one sentence.
 */
#ifndef EMU_LIST_INPUT_H
#define EMU_LIST_INPUT_H

#include <stdbool.h>

#include "crt/error.h"

/* Of one device ("tablet"), or of all when `name` is NULL; `why`: ranges and sources, too. */
bool vm_list_input(const char *name, bool why, struct crt_error *err);

#endif
