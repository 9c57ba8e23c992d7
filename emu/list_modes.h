/* list_modes.h — video modes as text of at most 100 columns: the table, or one mode in full.
 *
 * Models:     nothing; figures come from raster/mode.h. Rates are those of lines and fields, to three
 *             places as VESA prints them.
 * Ownership:  nothing is kept; prints on standard output.
 * Errors:     a mode that cannot be: false and one sentence.
 */
#ifndef EMU_LIST_MODES_H
#define EMU_LIST_MODES_H

#include <stdbool.h>

#include "crt/error.h"

void vm_list_modes(bool why);
/* Any mode that raster/mode.h knows or can make. */
bool vm_explain_mode(const char *name, struct crt_error *err);

#endif
