/* lesson_command.h — a command of a lesson: what it makes, and how it is started from another place.
 *
 *      probe roms/growing.df --at 9,9   ─▶  shown:   kinescope probe roms/growing.df --at 9,9 -o steady.png
 *                                           started: probe /…/roms/growing.df --at 9,9 -o /…/DIR/growing/steady.png
 *
 * Ownership:  vm_lesson_command allocates, vm_words_free and free() free.
 * Errors:     one sentence without the place.
 */
#ifndef EMU_LESSON_LESSON_COMMAND_H
#define EMU_LESSON_LESSON_COMMAND_H

#include "emu/lesson/lesson.h"
#include "emu/lesson/lesson_words.h"

/* Names of the files that a command itself says it writes. */
#define VM_LESSON_WRITTEN 8
struct vm_lesson_written {
    char name[VM_LESSON_WRITTEN][VM_LESSON_FILE];
    int count;
    int shown; /* the one that the page shows; −1: none */
};

/* Whether a lesson may have it as `word`. What it writes stays within the folder of results. */
bool vm_lesson_command_check(enum vm_lesson_word word, const char *text,
                             struct vm_lesson_written *written, struct crt_error *err);
/* "csv" when it prints CSV, "txt" when it prints something else, "png" of pictures and plots. */
const char *vm_lesson_command_ending(enum vm_lesson_word word, const char *text);

/* As typed, malloced: "kinescope …", with the options that are added. */
char *vm_lesson_command_shown(const struct vm_lesson_line *line, bool projector);

/* Where things are when a command is started; both absolute. */
struct vm_lesson_places {
    const char *roms; /* what roms/ means */
    const char *out;  /* where results go */
};
/* The words to start it with, in the folder of the lesson's file; to be freed also when it fails. */
bool vm_lesson_command_start(const struct vm_lesson_line *line,
                             const struct vm_lesson_places *places, bool projector,
                             struct vm_words *words, struct crt_error *err);

#endif
