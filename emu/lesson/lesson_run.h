/* lesson_run.h — runs the commands of lessons, several at a time.
 *
 *      lines of all lessons, in order ─▶ a process each, `at_once` of them ─▶ results by line
 *
 * Results are where their lines are: they do not depend on which command is done first.
 *
 * Ownership:  the caller's results.
 * Errors:     told one by one, "FILE:LINE: sentence": a lesson's mistakes are found in one go.
 */
#ifndef EMU_LESSON_LESSON_RUN_H
#define EMU_LESSON_LESSON_RUN_H

#include "emu/lesson/lesson_results.h"

struct vm_lesson_run {
    const char *roms; /* absolute: what roms/ means */
    int at_once;
    unsigned limit_s; /* of each command, by the clock on the wall; 0: none */
    bool projector;
    bool progress; /* a line on standard error that overwrites itself */
    void (*tell)(const struct crt_error *sentence);
    const bool *steps; /* of the only lesson: which are run; NULL: all */
};

/* Folders must exist, `results[i].folder` absolute. False: something went wrong, and was told. */
bool vm_lesson_run(const struct vm_lesson_run *run, struct vm_lesson_results *results, int count);

enum vm_lesson_verdict {
    VM_LESSON_HOLDS,
    VM_LESSON_BROKEN,    /* something that is expected does not hold */
    VM_LESSON_INCOMPLETE /* a figure is not there: nothing can be printed */
};

/* Tells all that does not hold and all figures that are not there; counts on in `asked` what was expected. */
enum vm_lesson_verdict vm_lesson_judge(const struct vm_lesson_run *run,
                                       const struct vm_lesson_results *r, int *asked);

#endif
