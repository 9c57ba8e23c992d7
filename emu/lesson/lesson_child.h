/* lesson_child.h — one command of kinescope, run in a process of its own, and what it said.
 *
 * Models:     nothing. A process of its own leaves nothing behind: every command begins as at the shell, with
 *             nothing on standard input. It ends with its parent, and when its time is up.
 * Units:      seconds of the clock on the wall.
 * Ownership:  vm_child_start opens, vm_child_end closes; its texts are malloced.
 * Errors:     one sentence.
 */
#ifndef EMU_LESSON_LESSON_CHILD_H
#define EMU_LESSON_LESSON_CHILD_H

#include <stdio.h>
#include <sys/types.h>

#include "crt/error.h"

struct vm_child {
    pid_t pid; /* 0: none */
    FILE *out, *complaints;
    unsigned limit_s;
};

/* `arguments`: the subcommand and what follows, NULL at the end. It runs in `folder`, and may take `limit_s`; 0: as long as it wants. */
bool vm_child_start(struct vm_child *child, char *const *arguments, const char *folder,
                    unsigned limit_s, struct crt_error *err);

/* Of a child that has ended with `status` of waitpid: all that it printed, or NULL and the sentence it
 * complained with. */
char *vm_child_end(struct vm_child *child, int status, struct crt_error *err);

#endif
