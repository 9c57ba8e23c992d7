/* words.h — a typed line as words, and what a command takes from them.
 *
 *      "line dda 0 0 4 5" ──▶ line │ dda │ 0 │ 0 │ 4 │ 5      taken from the left; what is wrong is
 *                                                             kept as one sentence
 *
 * Models:     words between spaces; numbers with sign, point and exponent, and fractions such as 1/4;
 *             points as numbers one after the other, up to a word that is none; text as the words
 *             that are left.
 * Domain:     coordinates of the world lie within ±WORDS_FARTHEST, unless an algorithm asks for less.
 * Ownership:  points into the line, which must outlive it.
 * Errors:     a function that returns false has taken nothing and has left a sentence in `trouble`,
 *             unless there is one already; what words_points and words_rest gave is then not to be
 *             used. words_take and words_next_is leave none: they only look. Each trouble has one
 *             sentence for all commands: "12 is not within -10 and 10", "at least 3 points are
 *             needed", "at most 32 points", "the last point has no y".
 */
#ifndef ROMS_MONITOR_WORDS_H
#define ROMS_MONITOR_WORDS_H

#include <stdbool.h>
#include <stddef.h>

#include "roms/geometry/vector.h"

#define WORDS_FARTHEST 1e6f /* coordinates of the world */
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
/* Takes a number. words_bounded: one within low…high; words_whole: a whole one. */
bool words_number(struct words *w, float *out);
bool words_bounded(struct words *w, float low, float high, float *out);
bool words_whole(struct words *w, int low, int high, int *out);
/* One within ±WORDS_FARTHEST; `count` of them one after the other. */
bool words_amount(struct words *w, float *out);
bool words_amounts(struct words *w, float *out, int count);
/* x y, or x y z, within ±limit. */
bool words_point(struct words *w, float limit, struct point2 *out);
bool words_vector(struct words *w, float limit, struct vector3 *out);
/* A vector of 2 or 3 dimensions that has a direction. A small one is enlarged by a power of two, so
 * that its length can be reckoned. */
bool words_direction(struct words *w, int dimensions, float limit, struct vector3 *out);
/* How many points are wanted, and where. */
struct words_wanted {
    int least, most;
    float limit; /* coordinates are within ±limit */
};
/* All points of 2 dimensions up to a word that is no number. */
bool words_points2(struct words *w, struct words_wanted wanted, struct point2 *out, int *count);
/* Of 2 or 3 dimensions; z is 0 where there is none. */
bool words_points(struct words *w, int dimensions, struct words_wanted wanted, struct vector3 *out,
                  int *count);
/* The words that are left, at least one, with a blank between them; `room` counts the end, too. */
bool words_rest(struct words *w, char *text, size_t room);
/* One of the names, which end with NULL: its index. */
bool words_choice(struct words *w, const char *const *names, int *out);
/* Nothing is left. */
bool words_end(struct words *w);
/* Notes a sentence (as printf) and returns false. */
bool words_refuse(struct words *w, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
