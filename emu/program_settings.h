/* program_settings.h — options to settings for a program that has been loaded, and whether the two suit each other.
 *
 *      options, what the program names ─▶ settings.h ─▶ view.h: a raster head only with firmware
 *                                                    ─▶ script_suits.h: devices for what the script does
 *
 * Ownership:  as vm_settings_resolve; vm_settings_free also after an error.
 * Errors:     an exit status and one sentence.
 */
#ifndef EMU_PROGRAM_SETTINGS_H
#define EMU_PROGRAM_SETTINGS_H

#include "emu/input_file.h"
#include "emu/settings.h"

int vm_program_settings(const struct vm_settings_options *options, const struct vm_input *input,
                        struct vm_settings *settings, struct crt_error *err);

/* The second half alone, for settings that something was done to in between. */
bool vm_program_suits(const struct vm_settings *settings, const struct vm_input *input,
                      struct crt_error *err);

#endif
