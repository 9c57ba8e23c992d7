/* lesson_results.h — what a lesson's commands made and said, and what holds of it.
 *
 *      line ─▶ said, figures      key, step ─▶ figure      expect, says ─▶ outcome
 *
 * Ownership:  vm_lesson_results_init allocates, vm_lesson_results_free frees; the lesson must live as long.
 * Errors:     "FILE:LINE: sentence".
 */
#ifndef EMU_LESSON_LESSON_RESULTS_H
#define EMU_LESSON_LESSON_RESULTS_H

#include "emu/lesson/lesson.h"
#include "emu/lesson/lesson_expect.h"
#include "emu/lesson/lesson_words.h"

struct vm_lesson_result {
    char *said;    /* on standard output; NULL: not run */
    char *trouble; /* a sentence, when the command or what it left was wrong; else NULL */
    bool has_figures;
    struct vm_figures figures;
};

struct vm_lesson_results {
    const struct vm_lesson *lesson;
    char *folder;                    /* where its files are */
    struct vm_lesson_result *result; /* of each line */
};

bool vm_lesson_results_init(struct vm_lesson_results *r, const struct vm_lesson *lesson,
                            const char *folder, struct crt_error *err);
void vm_lesson_results_free(struct vm_lesson_results *r);

/* Takes what the command of line `i` said, which must be malloced; the figures in it, when it is JSON. False: a
 * sentence without the place. */
bool vm_lesson_results_take(struct vm_lesson_results *r, int i, char *said, struct crt_error *err);

/* The value of line `i` with its figures filled in, malloced; `r` NULL: with their names. */
char *vm_lesson_filled(const struct vm_lesson *lesson, const struct vm_lesson_results *r, int i,
                       struct crt_error *err);

/* Of an expect or says line. */
bool vm_lesson_outcome(const struct vm_lesson_results *r, int i, struct vm_expect_outcome *outcome,
                       struct crt_error *err);

/* The file that line `i` made, malloced with a NUL after it. */
char *vm_lesson_made(const struct vm_lesson_results *r, int i, size_t *length,
                     struct crt_error *err);

#endif
