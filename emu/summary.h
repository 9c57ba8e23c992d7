/* summary.h — how long a refresh of a program takes, for people.
 *
 * Models:     nothing; runs the machine three times: with the tube row's generator times as they
 *             are, at the low and at the high end of their ranges.
 * Ownership:  nothing; the stream stays the caller's.
 * Errors:     an exit status and one sentence.
 */
#ifndef EMU_SUMMARY_H
#define EMU_SUMMARY_H

#include <stdio.h>

#include "emu/rig.h"

/* Over the first refresh, or over those complete within `length` where it is given. */
int vm_print_summary(FILE *out, const struct vm_time *length, const struct vm_settings *settings,
                     const struct vm_input *input, struct crt_error *err);

#endif
