/* points_text.h — a model as lines of text, and back.
 *
 *      spline 1
 *      kind pieces knots uniform open            kind: bezier pieces natural b-spline
 *      point 90 200                              knots: uniform chordal centripetal; open or closed
 *      point 200 620 g1 -60.5 20 90.75 -30       joint: c1 g1 corner, then the handles in and out,
 *      point 420 700 c1                          if they do not follow the neighbours
 *      end
 *
 * Models:     numbers with as many digits as give the same float again.
 * Domain:     lines of up to POINTS_TEXT_LINE characters; blanks between words; empty lines and what
 *             follows `#` are not looked at. Returns ('\r') count as blanks.
 * Ownership:  plain values; what is read is a model of its own, which the caller takes when it is done.
 * Errors:     bytes are hostile: the first line that is not as above ends reading, with a sentence.
 *             Points beyond the area, handles that their joint does not allow, and too many points
 *             are such lines.
 */
#ifndef ROMS_SPLINE_POINTS_TEXT_H
#define ROMS_SPLINE_POINTS_TEXT_H

#include "roms/spline/model.h"

enum { POINTS_TEXT_LINE = 120 };
enum points_state { POINTS_MORE, POINTS_DONE, POINTS_WRONG };

struct points_reader {
    struct model model;
    char line[POINTS_TEXT_LINE + 1];
    int length, number; /* characters in it; lines so far */
    bool begun, has_kind;
    enum points_state state;
    const char *trouble; /* when wrong */
};

void points_read_begin(struct points_reader *reader);
/* The next byte; bytes after the end change nothing. */
enum points_state points_read(struct points_reader *reader, char c);

/* Hands over line after line, each with its end. */
void points_write(const struct model *model, void (*put)(void *ctx, const char *line), void *ctx);

#endif
