/* space_words.h — what the commands of space take from their words: vectors, points, operations.
 *
 * Domain:     numbers up to SPACE_LARGEST; up to SPACE_POINTS points and SPACE_OPERATIONS
 *             operations.
 * Ownership:  plain values.
 * Errors:     false: a sentence is in words.trouble.
 */
#ifndef ROMS_COMMANDS_SPACE_WORDS_H
#define ROMS_COMMANDS_SPACE_WORDS_H

#include "roms/geometry/rotate_axis.h"
#include "roms/geometry/transform3.h"
#include "roms/monitor/words.h"

#define SPACE_LARGEST 1e6f
/* Beyond it a product is refused: it would be lost in drawing. */
#define SPACE_LARGEST_PRODUCT 1e12f
enum { SPACE_POINTS = 32, SPACE_OPERATIONS = 16 };

struct space_points {
    struct vector3 at[SPACE_POINTS];
    int count;
};

struct space_operation {
    const char *name;
    struct transform3 transform;
    bool about_line;         /* rotate-axis: the working is */
    struct rotate_axis line; /* here */
    struct vector3 p1, p2;
};

/* A number that is not too large. */
bool space_number(struct words *w, float *out);
bool space_vector(struct words *w, struct vector3 *out);
/* Points to the end of the line, at least `least`. */
bool space_points(struct words *w, int least, struct space_points *out);
/* "at x y z …" to the end of the line, or nothing: no points. */
bool space_at(struct words *w, struct space_points *out);
bool space_operation(struct words *w, struct space_operation *out);
/* Adds to the sentence in `trouble` what this part of the command expects; false. */
bool space_refuse_form(struct words *w, const char *name, const char *form);
/* All entries are finite and not too large. */
bool space_matrix_fits(const struct matrix4 *m);
bool space_vector_fits(struct vector3 v);

#endif
