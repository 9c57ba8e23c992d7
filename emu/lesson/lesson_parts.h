/* lesson_parts.h — what the parts of the lesson's reader share: lines, then what holds between
 * them, and which files their commands make.
 *
 * Ownership:  the lesson's; vm_lesson_files_free frees what vm_lesson_files_take noted.
 * Errors:     "FILE:LINE: sentence".
 */
#ifndef EMU_LESSON_LESSON_PARTS_H
#define EMU_LESSON_LESSON_PARTS_H

#include "emu/lesson/lesson.h"

/* After all lines are there: captions, results, figures that are quoted, what is missing. */
bool vm_lesson_check(struct vm_lesson *lesson, struct crt_error *err);

/* The files that commands make, in lesson_files.c: no two make the same, as several run at a time. */
struct vm_lesson_files {
    char **name;
    size_t count, room;
};
/* Checks the command of line `i`, and names the file that the page shows of it: as the command says, else
 * STEP.png, STEP-2.png and so on. A sentence without the place. */
bool vm_lesson_files_take(struct vm_lesson_files *files, struct vm_lesson *lesson, int i,
                          struct crt_error *err);
void vm_lesson_files_free(struct vm_lesson_files *files); /* also one that is all zero */

/* a-z 0-9 -, not only '-', fits. */
bool vm_lesson_is_name(const char *name, size_t length);

#endif
