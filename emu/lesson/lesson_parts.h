/* lesson_parts.h — what the parts of the lesson's reader share: lines, then what holds between them.
 *
 * Ownership:  the lesson's.
 * Errors:     "FILE:LINE: sentence".
 */
#ifndef EMU_LESSON_LESSON_PARTS_H
#define EMU_LESSON_LESSON_PARTS_H

#include "emu/lesson/lesson.h"

/* After all lines are there: captions, results, figures that are quoted, what is missing. */
bool vm_lesson_check(struct vm_lesson *lesson, struct crt_error *err);

/* a-z 0-9 -, not only '-', fits. */
bool vm_lesson_is_name(const char *name, size_t length);

#endif
