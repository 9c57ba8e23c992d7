/* lesson_folder.h — the lessons of a folder, in their order.
 *
 * Ownership:  vm_lesson_folder_read allocates, vm_lesson_folder_free frees.
 * Errors:     one sentence; a lesson that cannot be read is told with file and line.
 */
#ifndef EMU_LESSON_LESSON_FOLDER_H
#define EMU_LESSON_LESSON_FOLDER_H

#include "emu/lesson/lesson.h"

#define VM_LESSONS_MAX 64

struct vm_lesson_folder {
    struct vm_lesson lesson[VM_LESSONS_MAX];
    int count;
};

/* All files NAME.lesson of the folder. */
bool vm_lesson_folder_read(struct vm_lesson_folder *f, const char *path, struct crt_error *err);
void vm_lesson_folder_free(struct vm_lesson_folder *f);

#endif
