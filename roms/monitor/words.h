/* words.h — a typed line as words, and what a command takes from them.
 *
 *      "line dda 0 0 4 5" ──▶ line │ dda │ 0 │ 0 │ 4 │ 5      taken from the left; what is wrong is
 *                                                             kept as one sentence
 *
 * Models:     words between spaces; numbers with sign, point and exponent, and fractions such as 1/4.
 * Ownership:  points into the line, which must outlive it.
 * Errors:     a function that returns false has taken nothing and has left a sentence in `trouble`,
 *             unless there is one already. words_take and words_next_is leave none: they only look.
 */
#ifndef ROMS_MONITOR_WORDS_H
#define ROMS_MONITOR_WORDS_H

#include <stdbool.h>

enum { WORDS_MOST = 200, WORDS_TROUBLE = 100 };

struct words {
    const char *at[WORDS_MOST];
    int count, next;
    char trouble[WORDS_TROUBLE];
};

/* Cuts the line up in place. Words beyond WORDS_MOST: false. */
bool words_cut(struct words *w, char *line);
int words_left(const struct words *w);
/* The next word, which stays; "" behind the last one. */
const char *words_peek(const struct words *w);
/* Takes the next word if it is this one. */
bool words_take(struct words *w, const char *word);
bool words_next_is(const struct words *w, const char *word);
bool words_next_is_number(const struct words *w);
/* Takes a number. words_whole: a whole one within low…high. */
bool words_number(struct words *w, float *out);
bool words_whole(struct words *w, int low, int high, int *out);
/* `count` numbers one after the other. */
bool words_numbers(struct words *w, float *out, int count);
/* One of the names, which end with NULL: its index. */
bool words_choice(struct words *w, const char *const *names, int *out);
/* Nothing is left. */
bool words_end(struct words *w);
/* Notes a sentence (as printf) and returns false. */
bool words_refuse(struct words *w, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
