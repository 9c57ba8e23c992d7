/* space_words.h — what the commands of space take from their words: vectors, points, operations.
 *
 * Domain:     numbers within ±WORDS_FARTHEST; up to SPACE_POINTS points and SPACE_OPERATIONS
 *             operations.
 * Ownership:  plain values.
 * Errors:     false: a sentence is in words.trouble.
 */
#ifndef ROMS_COMMANDS_SPACE_WORDS_H
#define ROMS_COMMANDS_SPACE_WORDS_H

#include "roms/geometry/rotate_axis.h"
#include "roms/geometry/transform3.h"
#include "roms/monitor/words.h"

/* Beyond it a product is refused: it would be lost in drawing. */
#define SPACE_LARGEST_PRODUCT 1e12f
enum { SPACE_POINTS = 32, SPACE_OPERATIONS = 16 };

#define SPACE_OPERATIONS_FORM                                                                      \
    "translate x y z|scale sx sy sz|scale-about sx sy sz x y z|rotate x|y|z degrees|"              \
    "rotate-parallel x|y|z degrees through x y z|rotate-axis x1 y1 z1 x2 y2 z2 degrees|"           \
    "reflect x|y|z|xy|yz|xz|shear x|y|z a b"
#define SPACE_PROJECTIONS_FORM                                                                     \
    "front|rear|left|right|plan|isometric|dimetric [factor]|trimetric [turn tilt]|"                \
    "cavalier|cabinet [degrees]|oblique degrees factor|"                                           \
    "perspective zprp zvp [from x y] [turn degrees] [tilt degrees]|"                               \
    "one-point|two-point|three-point [zprp zvp]"

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

/* "at x y z …" to the end of the line, or nothing: no points. */
bool space_at(struct words *w, struct space_points *out);
bool space_operation(struct words *w, struct space_operation *out);
/* Adds to the sentence in `trouble` what this part of the command expects; false. */
bool space_refuse_form(struct words *w, const char *name, const char *form);
/* All entries are finite and not too large. */
bool space_matrix_fits(const struct matrix4 *m);
bool space_vector_fits(struct vector3 v);

#endif
