/* lesson_words.h — the words of a lesson's commands, and the figures that its texts quote.
 *
 *      capture roms/rose.df --type 'circle 0 0 8'  ─▶  capture | roms/rose.df | --type | circle 0 0 8
 *      "C1 is {c1:.2}, {decay.persistence_10_s:s}" ─▶  "C1 is 0.45, 340 µs"
 *
 * Ownership:  vm_words_split and vm_quote_fill allocate; vm_words_free and free() free.
 * Errors:     one sentence without the place.
 */
#ifndef EMU_LESSON_LESSON_WORDS_H
#define EMU_LESSON_LESSON_WORDS_H

#include <stdbool.h>
#include <stddef.h>

#include "crt/error.h"
#include "emu/lesson/lesson_figures.h"

#define VM_WORDS_MAX 64

struct vm_words {
    char *item[VM_WORDS_MAX + 1]; /* each malloced; NULL after the last */
    int count;
};

/* As a shell would, without what makes a shell one: variables, pipes and redirection are refused. */
bool vm_words_split(struct vm_words *words, const char *text, struct crt_error *err);
/* Adds a copy. */
bool vm_words_add(struct vm_words *words, const char *word, struct crt_error *err);
void vm_words_free(struct vm_words *words);

#define VM_QUOTE_KEY 80

/* Finds the figure called `key`, or NULL and a sentence. */
typedef const struct vm_figure *vm_quote_find(void *context, const char *key,
                                              struct crt_error *err);

/* The text with its {figures} filled in, malloced; with `find` NULL each is shown as [key], which checks the
 * text. NULL and a sentence when it is not well formed, a figure is not found, or memory ran out. */
char *vm_quote_fill(const char *text, vm_quote_find *find, void *context, struct crt_error *err);

#endif
