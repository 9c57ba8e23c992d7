/* lesson_text.h — a lesson as plain text: captions, and the commands to type.
 *
 * Ownership:  nothing.
 * Errors:     a figure that is not there: "FILE:LINE: sentence".
 */
#ifndef EMU_LESSON_LESSON_TEXT_H
#define EMU_LESSON_LESSON_TEXT_H

#include <stdio.h>

#include "emu/lesson/lesson_results.h"

struct vm_lesson_look {
    bool projector; /* large type, high contrast */
    bool no_flash;  /* nothing live that flashes */
};

/* `results` NULL: not run; figures are shown by their names. */
bool vm_lesson_print(FILE *out, const struct vm_lesson *lesson,
                     const struct vm_lesson_results *results, const struct vm_lesson_look *look,
                     struct crt_error *err);

extern const char vm_lesson_left_out[]; /* instead of what flashes */

#endif
