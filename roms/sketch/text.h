/* text.h — a drawing as lines of text, written and read.
 *
 *      sketch 1                        # the first line; comments begin with #
 *      subpicture A 480 320            # a letter A … P, and its origin
 *      point 1 480 320                 # points are numbered 1, 2, … through the whole text
 *      point 2 560 320
 *      line 1 2 horizontal             # horizontal, vertical, or nothing
 *      drawing                         # what is shown itself; once, and after it subpictures may follow
 *      point 3 100 250.5
 *      point 4 140 250.5
 *      circle 3 4                      # middle, rim
 *      point 5 100 290
 *      arc 3 4 5                       # middle, begin, direction of the end; anticlockwise
 *      point 6 600 320
 *      copy A 6 1.5 45                 # subpicture, place of its origin, scale, degrees
 *      end
 *
 * Models:     a line a point or figure; what a figure names comes before it, but for subpictures, which
 *             may come later. Points belong to the picture that they stand in, and to at least one
 *             figure. Writing what was read gives the same text.
 * Domain:     places within ±10000 with two decimals, scales 0.01 … 100 with three, degrees 0 … 359.99
 *             with two; lines of at most TEXT_LINE characters.
 * Units:      stage units, degrees anticlockwise.
 * Ownership:  plain values.
 * Errors:     bytes are hostile. The first error as the number of its line and a sentence; the state is
 *             of no use then.
 * Source:     chosen for this program.
 */
#ifndef ROMS_SKETCH_TEXT_H
#define ROMS_SKETCH_TEXT_H

#include "roms/sketch/drawing.h"

enum { TEXT_LINE = 72, TEXT_WORDS = 6, TEXT_SENTENCE = 60 };

/* Each line without its end. */
void text_write(const struct drawing_state *s, void (*put)(void *ctx, const char *line), void *ctx);

struct text_reader {
    struct drawing_state state;
    bool done;   /* `end` was read */
    bool failed; /* lines that follow are not looked at, but for `end` */
    int line;    /* number of the last one */
    int error_line;
    char error[TEXT_SENTENCE];
    /* Private. */
    bool begun, drawing_seen;
    int picture; /* -1: none yet */
    int points, figures;
    int32_t point_line[DRAWING_POINTS], figure_line[DRAWING_FIGURES];
};

void text_begin(struct text_reader *r);
/* The next line; nothing after `end`. */
void text_line(struct text_reader *r, const char *line);
/* A line that was longer than TEXT_LINE. */
void text_too_long(struct text_reader *r);

#endif
