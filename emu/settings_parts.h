/* settings_parts.h — what the files of the settings share; not for others.
 *
 *      settings.c      options to rows and descs      settings_set.c   --set
 *
 * Models:     see emu/settings.h.
 * Ownership:  all of it works on the caller's settings.
 * Errors:     one sentence.
 */
#ifndef EMU_SETTINGS_PARTS_H
#define EMU_SETTINGS_PARTS_H

#include "emu/settings.h"

/* What --set names, in order; the rows are checked in the end. */
bool vm_settings_set(struct vm_settings *settings, const struct vm_list *set,
                     struct crt_error *err);

#endif
